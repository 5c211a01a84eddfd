"""A window of two quantities > 0 as a quadtree of decided cells.

It is cut into quarters, at geometric means rounded to exact rationals, until a cell is decided or `depth` cuts are
made. Its 64 blocks are independent tasks: run in turn, by joblib or by Dask, the map is the same. A block's quadtree is
written as text: the letter of each cell's verdict, followed by those of its quarters where it was cut.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from numerics.errors import InvalidMap
from numerics.scene.decimals import decimal_text, exact_decimal
from numerics.scene.short_repr import ShortRepr
from numerics.tasks import run_tasks

BLOCK_DEPTH = 3
"""Cuts from the window to a block: 4^3 tasks keep a cluster busy, and a checkpoint short."""
MAX_DEPTH, NARROWEST = 14, Fraction(1001, 1000)
Progress = Callable[[int, int], None]
Side = tuple[Fraction, Fraction]
Sides = tuple[Side, Side]
"""Ranges of both quantities, ends included."""
Decide = Callable[[Sides], Any]
"""What decides a cell: it answers with a member of an Enum of letters, one of which says that it is undecided.

It must be importable, alone or under functools.partial: it is sent to other processes.
"""


def side_of(name: str, ends: Any, least: Fraction = Fraction(0), most: Fraction | None = None, less: int = 0) -> Side:
    """Return two numbers, from and to, less a number, exact: a side of a window. Raises InvalidMap.

    Bounds are those of what is returned; both are > 0, and their ratio is at least NARROWEST.
    """
    try:
        first, last = ends
    except (TypeError, ValueError):
        raise InvalidMap(f"{name} = {str(ends)[:40]!r} must be two numbers: from, to") from None
    low, high = exact_decimal(first, name) - less, exact_decimal(last, name) - less
    if not (0 < low * NARROWEST <= high and least <= low and (most is None or high <= most)):
        given = " to ".join(decimal_text(one + less)[:20] for one in (low, high))
        bounds = f"from {decimal_text(least + less)} to {decimal_text(most + less)}" if most else "> 0"
        apart = f"(B - {less})/(A - {less})" if less else "B/A"
        raise InvalidMap(f"{name}: {given} is no range; give A and B {bounds} and {apart} at least 1.001")
    return low, high


class Leaf(NamedTuple):
    """A cell: its sides, its level (0 is the whole window), column and row there, and what is proved."""

    sides: Sides
    level: int
    column: int
    row: int
    verdict: Any

    @property
    def share(self) -> float:
        """Return its share of the window's area on logarithmic axes, exact."""
        return 4.0**-self.level


@dataclass(frozen=True, repr=False)
class CellMap(ShortRepr):
    """The leaves that cover a window, cells down to 2^-depth of its sides.

    `title` says what was asked, in what JSON holds; in it the sides are larger by `added` than those of the window.
    """

    title: dict[str, Any]
    window: Sides
    depth: int
    leaves: tuple[Leaf, ...]
    added: tuple[int, int] = (0, 0)

    def shares(self) -> dict[Any, float]:
        """Return the share of each verdict in the window's area on logarithmic axes."""
        kinds = type(self.leaves[0].verdict)
        return {one: sum(cell.share for cell in self.leaves if cell.verdict is one) for one in kinds}

    def raster(self, order: Iterable[Any]) -> Any:
        """Return the verdicts on the finest grid as places in `order`, (2^depth, 2^depth), the second side upwards."""
        places = list(order)
        grid = np.empty((2**self.depth, 2**self.depth), dtype=np.uint8)
        for cell in self.leaves:
            size = 2 ** (self.depth - cell.level)
            row, column = cell.row * size, cell.column * size
            grid[row : row + size, column : column + size] = places.index(cell.verdict)
        return grid

    def as_record(self) -> dict[str, Any]:
        """Return the map for JSON: exact numbers as text, one [from, to, from, to, verdict] a cell."""
        cells = [
            [*(str(end + more) for side, more in zip(cell.sides, self.added, strict=True) for end in side),
             cell.verdict.name.lower()]
            for cell in self.leaves
        ]  # fmt: skip
        shares = {one.name.lower(): share for one, share in self.shares().items()}
        return {**self.title, "shares": shares, "cells": cells}

    def draw(self, axes: Any, colours: dict[Any, str], labels: dict[Any, str]) -> list[Any]:
        """Draw the cells into logarithmic matplotlib axes, and return what a legend shows of them."""
        from matplotlib.colors import ListedColormap
        from matplotlib.patches import Patch

        edges = [np.geomspace(float(low), float(high), 2**self.depth + 1) for low, high in self.window]
        how = {"cmap": ListedColormap(list(colours.values())), "vmin": -0.5, "vmax": len(colours) - 0.5}
        axes.pcolormesh(*edges, self.raster(colours), rasterized=True, **how)
        axes.set(xscale="log", yscale="log")
        shares = self.shares()
        return [
            Patch(fc=colours[one], ec="black", lw=0.5, label=f"{labels[one]} ({shares[one]:.1%})") for one in colours
        ]


def map_of(
    window: Sides,
    depth: int,
    decide: Decide,
    undecided: Enum,
    title: dict[str, Any],
    added: tuple[int, int] = (0, 0),
    *,
    jobs: int = 1,
    dask: str | None = None,
    resume: Path | None = None,
    progress: Progress | None = None,
) -> CellMap:
    """Return the map of a window; a cell of which `decide` answers `undecided` is cut.

    `jobs` processes by joblib, or the Dask cluster at the address `dask`; neither changes the result. `resume` is a
    checkpoint of finished blocks, which must agree with `title`. `progress` is called with (blocks done, all).
    Raises InvalidMap (depth, checkpoint of another map) and MissingTool (joblib or distributed is not installed).
    """
    title = {**title, "depth": depth}
    if not 1 <= depth <= MAX_DEPTH:
        raise InvalidMap(f"depth {depth}: give 1 to {MAX_DEPTH} cuts of each side in two")
    whole = Leaf(window, 0, 0, 0, undecided)
    blocks = list(_leaves(whole, min(BLOCK_DEPTH, depth), lambda _: undecided))
    leaves = {} if resume is None else _finished(resume, title, blocks)
    tasks = [(number, block, depth, decide) for number, block in enumerate(blocks) if number not in leaves]
    for number, text in run_tasks(_compute_block, tasks, jobs=jobs, dask=dask):
        if resume is not None:
            with resume.open("a", encoding="utf-8") as file:
                file.write(_line({"part": str(number), "result": text}))
        leaves[number] = _read(text, blocks[number], depth)
        if progress is not None:
            progress(len(leaves), len(blocks))
    return CellMap(title, window, depth, tuple(cell for number in range(len(blocks)) for cell in leaves[number]), added)


def _leaves(cell: Leaf, depth: int, decide: Decide) -> Iterator[Leaf]:
    """Yield the cells into which an undecided one is cut; the verdict of each is asked before that of its quarters."""
    verdict = decide(cell.sides)
    if verdict is cell.verdict and cell.level < depth:
        for quarter in _quarters(cell):
            yield from _leaves(quarter, depth, decide)
    else:
        yield cell._replace(verdict=verdict)


def _compute_block(task: tuple[int, Leaf, int, Decide]) -> tuple[int, str]:
    """Return a block's number and the text of its quadtree."""
    number, block, depth, decide = task
    asked = []

    def told(sides: Sides) -> Any:
        asked.append(decide(sides))
        return asked[-1]

    list(_leaves(block, depth, told))
    return number, "".join(verdict.value for verdict in asked)


def _read(text: str, block: Leaf, depth: int) -> list[Leaf]:
    """Return the cells that a block's text stands for. Raises ValueError if it is damaged."""
    letters = iter(text)
    found = list(_leaves(block, depth, lambda _: type(block.verdict)(next(letters, ""))))
    if any(letters):
        raise ValueError("letters are left")
    return found


def _quarters(cell: Leaf) -> Iterator[Leaf]:
    """Yield the quarters of a cell: lower left, lower right, upper left, upper right."""
    columns, rows = ([(low, mean), (mean, high)] for low, high in cell.sides for mean in [_geometric_mean(low, high)])
    for (upper, row), (right, column) in product(enumerate(rows), enumerate(columns)):
        place = (cell.level + 1, 2 * cell.column + right, 2 * cell.row + upper)
        yield Leaf((column, row), *place, cell.verdict)


def _geometric_mean(low: Fraction, high: Fraction) -> Fraction:
    """Return sqrt(low high) rounded down to about 64 bits: exact in what it is, the same on every machine."""
    bits = 64 + max(0, low.denominator.bit_length() - low.numerator.bit_length())
    return Fraction(math.isqrt(math.floor(low * high * 4**bits)), 2**bits)


def _finished(path: Path, title: dict[str, Any], blocks: list[Leaf]) -> dict[int, list[Leaf]]:
    """Return the cells of the blocks that a checkpoint holds, and begin it with the title if it is new.

    A last line torn by a crash is dropped. Raises InvalidMap if the file is damaged, or belongs to another map.
    """
    lines = path.read_text("utf-8", errors="replace").splitlines(keepends=True) if path.exists() else []
    whole = [line for line in lines if line.endswith("\n")] or [_line(title)]
    if not _line(title).startswith(lines[0] if lines else ""):
        raise InvalidMap(f"checkpoint {path.name} is of another map ({lines[0][:120]}); name another file")
    found = {}
    for index, line in enumerate(whole[1:], start=2):
        try:
            record = json.loads(line)
            number = int(record["part"])
            found[number] = _read(record["result"], blocks[number], title["depth"])
        except (ValueError, LookupError, TypeError):
            remedy = "remove the line, or name another file"
            raise InvalidMap(f"checkpoint {path.name}, line {index} is damaged; {remedy}") from None
    # what is appended next must not continue a torn line
    path.write_text("".join(whole), "utf-8")
    return found


def _line(record: dict[str, Any]) -> str:
    return json.dumps(record) + "\n"
