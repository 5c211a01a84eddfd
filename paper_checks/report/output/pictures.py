"""The figures of a report as files, drawn here or in several processes; one that cannot be drawn costs the reader that figure only."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from matplotlib.figure import Figure

from numerics.trade.recorded import Trade
from paper_checks.drawing.figures import FIGURES
from paper_checks.report.content import speed
from paper_checks.report.formats import vector
from paper_checks.running import processes

LONGEST = ("resonance", "static-friction", "euler-convergence")
"""Figures that take longest: they are begun first."""
SAVED: Mapping[str, Callable[[Figure], bytes]] = {"svg": vector.svg, "pdf": vector.pdf}


class Drawing(NamedTuple):
    """A figure by its name, as `svg` or `pdf`: drawn anew for each, as saving it leaves a trace in its layout."""

    name: str
    form: str


def made(drawings: Sequence[Drawing], trade: Trade, jobs: int = 1) -> Iterator[tuple[Drawing, bytes | str]]:
    """Yield each figure, or why there is none, as soon as it is drawn, in any order; with one job in this process."""
    if min(jobs, len(drawings)) < 2:
        yield from ((one, drawn(one, trade)) for one in drawings)
        return
    order = sorted(drawings, key=lambda one: one.name not in LONGEST)
    for one, answer in processes.answers(order, jobs, drawn, trade):
        ended = isinstance(answer, processes.Ended)
        yield one, f"the figure {one.name} was not drawn: its process ended" if ended else answer


def drawn(one: Drawing, trade: Trade) -> bytes | str:
    """Return a figure, or why there is none."""
    figures = {**FIGURES, **speed.figures(trade)}
    if one.name not in figures:
        return f"the figure {one.name} is not known"
    try:
        return SAVED[one.form](figures[one.name]())
    except Exception as error:  # noqa: BLE001  one figure's failure must not cost the reader the report
        return f"the figure {one.name} was not drawn: {type(error).__name__}: {error}"
