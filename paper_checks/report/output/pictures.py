"""The figures of a report as files, drawn here or in several processes; one that cannot be drawn costs the reader that figure only."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from matplotlib.figure import Figure

from numerics.trade.recorded import Trade
from paper_checks.drawing.figures import FIGURES
from paper_checks.drawing.style import Figures
from paper_checks.report.content import speed
from paper_checks.report.formats import vector
from paper_checks.running import processes

LONGEST = ("resonance", "static-friction", "euler-convergence")
"""Figures that take longest: they are begun first."""
_SAVED: Mapping[str, Callable[[Figure], bytes]] = {"svg": lambda one: vector.svg(one).encode(), "pdf": vector.pdf}


@dataclass(frozen=True)
class Drawing:
    """A figure by its name, as `svg` or `pdf`: drawn anew for each, as saving it leaves a trace in its layout."""

    name: str
    form: str


@dataclass(frozen=True)
class Undrawn:
    """Why a figure was not drawn."""

    why: str


def figures(trade: Trade) -> Figures:
    """Return how every figure is drawn, by name."""
    return {**FIGURES, **speed.figures(trade)}


def drawn(figures: Figures, name: str, form: str) -> bytes | Undrawn:
    """Return a figure as `svg` or `pdf`."""
    if name not in figures:
        return Undrawn(f"the figure {name} is not known")
    try:
        return _SAVED[form](figures[name]())
    except Exception as error:  # noqa: BLE001  one figure's failure must not cost the reader the report
        return Undrawn(f"the figure {name} was not drawn: {type(error).__name__}: {error}")


def made(drawings: Sequence[Drawing], trade: Trade, jobs: int = 1) -> Iterator[tuple[Drawing, bytes | Undrawn]]:
    """Yield each figure as soon as it is drawn, in any order; with one job they are drawn in this process."""
    if min(jobs, len(drawings)) < 2:
        yield from ((one, _made(one, trade)) for one in drawings)
        return
    for one, answer in processes.answers(sorted(drawings, key=_place), jobs, _made, trade):
        ended = isinstance(answer, processes.Ended)
        yield one, Undrawn(f"the figure {one.name} was not drawn: its process ended") if ended else answer


def _place(one: Drawing) -> int:
    return LONGEST.index(one.name) if one.name in LONGEST else len(LONGEST)


def _made(one: Drawing, trade: Trade) -> bytes | Undrawn:
    return drawn(figures(trade), one.name, one.form)


def shown(found: Mapping[str, bytes | Undrawn], complaints: list[str]) -> dict[str, bytes]:
    """Return the figures that were drawn, by name; why another was not joins the complaints, once."""
    for one in found.values():
        if isinstance(one, Undrawn) and one.why not in complaints:
            complaints.append(one.why)
    return {name: one for name, one in found.items() if isinstance(one, bytes)}
