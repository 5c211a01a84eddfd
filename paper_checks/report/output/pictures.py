"""The figures of a report as files; one that cannot be drawn costs the reader that figure only."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from matplotlib.figure import Figure

from paper_checks.drawing.style import Figures
from paper_checks.report.formats import vector

_SAVED: Mapping[str, Callable[[Figure], bytes]] = {"svg": lambda one: vector.svg(one).encode(), "pdf": vector.pdf}


@dataclass(frozen=True)
class Undrawn:
    """Why a figure was not drawn."""

    why: str


def drawn(figures: Figures, name: str, form: str) -> bytes | Undrawn:
    """Return a figure as `svg` or `pdf`; it is drawn anew for each, as saving it leaves a trace in its layout."""
    if name not in figures:
        return Undrawn(f"the figure {name} is not known")
    try:
        return _SAVED[form](figures[name]())
    except Exception as error:  # noqa: BLE001  one figure's failure must not cost the reader the report
        return Undrawn(f"the figure {name} was not drawn: {type(error).__name__}: {error}")


def shown(found: Mapping[str, bytes | Undrawn], complaints: list[str]) -> dict[str, bytes]:
    """Return the figures that were drawn, by name; why another was not joins the complaints, once."""
    for one in found.values():
        if isinstance(one, Undrawn) and one.why not in complaints:
            complaints.append(one.why)
    return {name: one for name, one in found.items() if isinstance(one, bytes)}
