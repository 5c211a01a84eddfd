"""The merging set as a map of proved cells: from which energies on S0 does which mass ratio merge, from which creep?

The window is cut into quarters, at geometric means rounded to exact rationals, until a cell is decided
(merging_cell.py) or `depth` cuts are made. Its 64 blocks are independent tasks: run in turn, by joblib or by Dask, the
map is the same. A block's quadtree is written as text: + for a cell that was cut, followed by its quarters in their
order, or else the letter of its verdict.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

from numerics.batch.parallel import run_tasks
from numerics.errors import InvalidMap
from numerics.merging.cell import Rectangle, Verdict, verdict
from numerics.merging.checkpoint import Checkpoint

BLOCK_DEPTH = 3
"""Cuts from the window to a block: 4^3 tasks keep a cluster busy, and a checkpoint short."""
MAX_DEPTH = 14
CUT = "+"
SMALLEST, LARGEST, NARROWEST = Fraction(1, 10**6), Fraction(10**6), Fraction(1001, 1000)
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class Window:
    """Ranges of m2/m1 and of E/E_cr > 1 of a start on S0; exact, dimensionless. Raises InvalidMap."""

    ratio: tuple[Fraction, Fraction] = (Fraction(4, 5), Fraction(100))
    energy: tuple[Fraction, Fraction] = (Fraction(101, 100), Fraction(101))

    def __post_init__(self) -> None:
        """Refuse empty ranges, and what neither binary64 axes nor 10,000 slips resolve."""
        for name, sides, text in zip(("m2/m1", "E/E_cr - 1"), self.rectangle, (self.ratio, self.energy), strict=True):
            low, high = sides
            if not (low >= SMALLEST and low * NARROWEST <= high <= LARGEST):
                shown = " to ".join(str(one)[:20] for one in text)
                raise InvalidMap(
                    f"{name}: {shown} is no range; give A < B with {name} from 1e-6 to 1e6 and B/A > 1.001"
                )

    @property
    def rectangle(self) -> Rectangle:
        """Return the window as the cell that holds all others."""
        low, high = self.energy
        return Rectangle(self.ratio, (low - 1, high - 1))


class MapCell(NamedTuple):
    """A leaf of the map: its rectangle, its level (0 is the whole window), column and row there, and what is proved."""

    rectangle: Rectangle
    level: int
    column: int
    row: int
    verdict: Verdict

    @property
    def share(self) -> Fraction:
        """Return its share of the window's area on logarithmic axes."""
        return Fraction(1, 4**self.level)


@dataclass(frozen=True)
class MergingMap:
    """The leaves of a window's quadtree; they cover it."""

    window: Window
    depth: int
    cells: tuple[MapCell, ...]

    def shares(self) -> dict[Verdict, float]:
        """Return the share of each verdict in the window's area on logarithmic axes."""
        areas = {one: Fraction(0) for one in Verdict}
        for cell in self.cells:
            areas[cell.verdict] += cell.share
        return {one: float(area) for one, area in areas.items()}

    def as_record(self) -> dict[str, Any]:
        """Return the map for JSON: exact fractions as text, one [m2/m1 from, to, E/E_cr from, to, verdict] a cell."""
        return {
            "ratio": [str(one) for one in self.window.ratio],
            "energy": [str(one) for one in self.window.energy],
            "depth": self.depth,
            "shares": {one.name.lower(): share for one, share in self.shares().items()},
            "cells": [
                [*(str(one) for one in cell.rectangle.ratio + cell.rectangle.energy), cell.verdict.name.lower()]
                for cell in self.cells
            ],
        }


def merging_cells(
    window: Window,
    depth: int,
    *,
    jobs: int = 1,
    dask: str | None = None,
    resume: Path | None = None,
    progress: Progress | None = None,
) -> MergingMap:
    """Return the map of a window, cells down to 2^-depth of its sides; every verdict is proved for its whole cell.

    `jobs` processes by joblib, or the Dask cluster at the address `dask`; neither changes the result. `resume` is a
    checkpoint of finished blocks: those in it are not computed again. `progress` is called with (blocks done, all).
    Raises InvalidMap (depth, checkpoint of another map) and MissingTool (joblib or distributed is not installed).
    """
    if not 1 <= depth <= MAX_DEPTH:
        raise InvalidMap(f"depth {depth}: give 1 to {MAX_DEPTH} cuts of each side in two")
    corner = min(BLOCK_DEPTH, depth)
    blocks = list(_parts(MapCell(window.rectangle, 0, 0, 0, Verdict.UNDECIDED), corner))
    checkpoint = Checkpoint(resume, _title(window, depth))
    leaves: dict[int, tuple[MapCell, ...]] = {}
    for index, block in enumerate(blocks):
        if str(index) in checkpoint.finished:
            leaves[index] = _decode(checkpoint.finished[str(index)], block, depth)
    tasks = [(index, block, depth - corner) for index, block in enumerate(blocks) if index not in leaves]
    for done, (index, tree) in enumerate(run_tasks(_compute_block, tasks, jobs=jobs, dask=dask), start=len(leaves) + 1):
        checkpoint.add(str(index), tree)
        leaves[index] = _decode(tree, blocks[index], depth)
        if progress is not None:
            progress(done, len(blocks))
    return MergingMap(window, depth, tuple(cell for index in range(len(blocks)) for cell in leaves[index]))


def _title(window: Window, depth: int) -> dict[str, object]:
    """Return what a checkpoint must agree with."""
    sides = {"ratio": [str(one) for one in window.ratio], "energy": [str(one) for one in window.energy]}
    return {"map": "merging", **sides, "depth": depth}


def _parts(cell: MapCell, cuts: int) -> Iterator[MapCell]:
    """Yield the cells of one level below a cell."""
    if cuts == 0:
        yield cell
        return
    for quarter in _quarters(cell):
        yield from _parts(quarter, cuts - 1)


def _compute_block(task: tuple[int, MapCell, int]) -> tuple[int, str]:
    """Return a block's index and the text of its quadtree."""
    index, block, cuts = task
    return index, "".join(_tree(block, cuts))


def _tree(cell: MapCell, cuts: int) -> Iterator[str]:
    found = verdict(cell.rectangle)
    if found is not Verdict.UNDECIDED or cuts == 0:
        yield found.value
        return
    yield CUT
    for quarter in _quarters(cell):
        yield from _tree(quarter, cuts - 1)


def _decode(tree: str, block: MapCell, depth: int) -> tuple[MapCell, ...]:
    """Return the cells that a block's text stands for. Raises InvalidMap if it is damaged."""
    letters = iter(tree)
    try:
        cells = tuple(_leaves(letters, block, depth))
    except ValueError:
        cells = ()
    if not cells or next(letters, None) is not None:
        raise InvalidMap(f"the checkpoint holds a damaged block ({tree[:40]!r}...); remove its line")
    return cells


def _leaves(letters: Iterator[str], cell: MapCell, depth: int) -> Iterator[MapCell]:
    letter = next(letters, "")
    if letter != CUT or cell.level == depth:
        yield cell._replace(verdict=Verdict(letter))
        return
    for quarter in _quarters(cell):
        yield from _leaves(letters, quarter, depth)


def _quarters(cell: MapCell) -> Iterator[MapCell]:
    """Yield the quarters of a cell: lower left, lower right, upper left, upper right."""
    columns, rows = (
        [(low, mean), (mean, high)] for low, high in cell.rectangle for mean in [_geometric_mean(low, high)]
    )
    for (upper, row), (right, column) in product(enumerate(rows), enumerate(columns)):
        place = (cell.level + 1, 2 * cell.column + right, 2 * cell.row + upper)
        yield MapCell(Rectangle(column, row), *place, Verdict.UNDECIDED)


def _geometric_mean(low: Fraction, high: Fraction) -> Fraction:
    """Return sqrt(low high) rounded down to about 64 bits: exact in what it is, the same on every machine."""
    bits = 64 + max(0, low.denominator.bit_length() - low.numerator.bit_length())
    return Fraction(math.isqrt(math.floor(low * high * 4**bits)), 2**bits)
