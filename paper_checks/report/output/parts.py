"""What takes long in a report, its chapters and its figures: made one after the other, or in several processes.

Both ways give the same; a figure that cannot be drawn is `Undrawn`, and costs the reader that figure only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from numerics.trade.recorded import Trade
from paper_checks.drawing.figures import FIGURES
from paper_checks.drawing.style import Figures
from paper_checks.report.content import speed, under_a_force
from paper_checks.report.content.blocks import Section
from paper_checks.report.output.pictures import Undrawn, drawn
from paper_checks.running import processes

LONGEST = ("euler-convergence", "work-precision")
"""Figures that take longest, the longest first: they are begun first."""


@dataclass(frozen=True)
class Chapter:
    """A chapter, by its anchor."""

    name: str


@dataclass(frozen=True)
class Drawing:
    """A figure by its name, as `svg` or `pdf`: drawn anew for each, as saving it leaves a trace in its layout."""

    name: str
    form: str


Part = Chapter | Drawing
Made = Section | bytes | Undrawn
"""A chapter, or the file of a figure."""


def chapters(trade: Trade) -> dict[str, Callable[[], Section]]:
    """Return how the chapters after the rows are made, by anchor, in their order."""
    return {under_a_force.ID: under_a_force.section, speed.ID: lambda: speed.section(trade)}


def figures(trade: Trade) -> Figures:
    """Return how every figure is drawn, by name."""
    return {**FIGURES, **under_a_force.figures(), **speed.figures(trade)}


def made(parts: Sequence[Part], trade: Trade, jobs: int = 1) -> Iterator[tuple[Part, Made]]:
    """Yield each part as soon as it is made, in any order; with one job they are made in this process."""
    if min(jobs, len(parts)) < 2:
        yield from ((part, _made(part, trade)) for part in parts)
        return
    for part, answer in processes.answers(sorted(parts, key=_place), jobs, _made, trade):
        yield part, _here(part, trade) if isinstance(answer, processes.Ended) else answer


def _place(part: Part) -> int:
    """Return where a part stands among those that wait: chapters first, then the longest figures."""
    if isinstance(part, Chapter):
        return 0
    return 1 + LONGEST.index(part.name) if part.name in LONGEST else 1 + len(LONGEST)


def _made(part: Part, trade: Trade) -> Made:
    if isinstance(part, Chapter):
        return chapters(trade)[part.name]()
    return drawn(figures(trade), part.name, part.form)


def _here(part: Part, trade: Trade) -> Made:
    """Return what stands for a part whose process ended: a chapter made here, which then says what is wrong with it."""
    if isinstance(part, Chapter):
        return _made(part, trade)
    return Undrawn(f"the figure {part.name} was not drawn: its process ended")
