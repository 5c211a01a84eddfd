"""The figures of a report as SVG texts; one that cannot be drawn costs the reader that figure only."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from paper_checks.drawing.style import Figures
from paper_checks.report.formats import vector


@dataclass(frozen=True)
class Undrawn:
    """Why a figure was not drawn."""

    why: str


def drawn(figures: Figures, name: str) -> str | Undrawn:
    """Return a figure as SVG text."""
    if name not in figures:
        return Undrawn(f"the figure {name} is not known")
    try:
        return vector.svg(figures[name]())
    except Exception as error:  # noqa: BLE001  one figure's failure must not cost the reader the report
        return Undrawn(f"the figure {name} was not drawn: {type(error).__name__}: {error}")


def shown(found: Iterable[tuple[str, str | Undrawn]], complain: Callable[[str], None]) -> Mapping[str, str]:
    """Return those of the named figures that were drawn; why another was not is told to `complain`."""
    texts = {}
    for name, one in found:
        if isinstance(one, Undrawn):
            complain(one.why)
        else:
            texts[name] = one
    return texts
