"""A window of two quantities > 0 as a quadtree of decided cells.

It is cut into quarters, at geometric means rounded to exact rationals, until a cell is decided or `depth` cuts are
made. Its 64 blocks are independent tasks: run in turn, by joblib or by Dask, the map is the same. A block's quadtree is
written as text: + for a cell that was cut, followed by its quarters in their order, or else the letter of its verdict.
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
from numerics.scene.short_repr import ShortRepr
from numerics.tasks import run_tasks

BLOCK_DEPTH = 3
"""Cuts from the window to a block: 4^3 tasks keep a cluster busy, and a checkpoint short."""
MAX_DEPTH = 14
CUT = "+"
Progress = Callable[[int, int], None]
Side = tuple[Fraction, Fraction]
Sides = tuple[Side, Side]
"""Ranges of both quantities, ends included."""


class Leaf(NamedTuple):
    """A cell: its sides, its level (0 is the whole window), column and row there, and what is proved."""

    sides: Sides
    level: int
    column: int
    row: int
    verdict: Any

    @property
    def share(self) -> Fraction:
        """Return its share of the window's area on logarithmic axes."""
        return Fraction(1, 4**self.level)


class Verdicts(NamedTuple):
    """What decides a cell: a function of its sides that answers with an Enum of letters, and its answer for a refusal.

    The function must be importable, alone or under functools.partial: it is sent to other processes.
    """

    decide: Callable[[Sides], Any]
    kinds: type[Enum]
    undecided: Any


@dataclass(frozen=True, repr=False)
class CellMap(ShortRepr):
    """The leaves that cover a window, cells down to 2^-depth of its sides.

    `title` says what was asked, in what JSON holds; in it the sides are larger by `added` than those of the window.
    """

    title: dict[str, Any]
    window: Sides
    depth: int
    kinds: type[Enum]
    leaves: tuple[Leaf, ...]
    added: tuple[int, int] = (0, 0)

    def shares(self) -> dict[Any, float]:
        """Return the share of each verdict in the window's area on logarithmic axes."""
        areas = {one: Fraction(0) for one in self.kinds}
        for cell in self.leaves:
            areas[cell.verdict] += cell.share
        return {one: float(area) for one, area in areas.items()}

    def raster(self, order: Iterable[Any]) -> Any:
        """Return the verdicts on the finest grid as places in `order`, (2^depth, 2^depth), the second side upwards."""
        places = {one: index for index, one in enumerate(order)}
        grid = np.empty((2**self.depth, 2**self.depth), dtype=np.uint8)
        for cell in self.leaves:
            size = 2 ** (self.depth - cell.level)
            row, column = cell.row * size, cell.column * size
            grid[row : row + size, column : column + size] = places[cell.verdict]
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
    verdicts: Verdicts,
    title: dict[str, Any],
    added: tuple[int, int] = (0, 0),
    *,
    jobs: int = 1,
    dask: str | None = None,
    resume: Path | None = None,
    progress: Progress | None = None,
) -> CellMap:
    """Return the map of a window.

    `jobs` processes by joblib, or the Dask cluster at the address `dask`; neither changes the result. `resume` is a
    checkpoint of finished blocks, which must agree with `title`. `progress` is called with (blocks done, all).
    Raises InvalidMap (depth, checkpoint of another map) and MissingTool (joblib or distributed is not installed).
    """
    title = {**title, "depth": depth}
    if not 1 <= depth <= MAX_DEPTH:
        raise InvalidMap(f"depth {depth}: give 1 to {MAX_DEPTH} cuts of each side in two")
    root = Leaf(window, 0, 0, 0, verdicts.undecided)
    blocks = [block for _, block in _walk(root, min(BLOCK_DEPTH, depth), lambda _: CUT) if block]
    checkpoint = Checkpoint(resume, title)
    before = {n: tree for n in range(len(blocks)) if (tree := checkpoint.finished.get(str(n)))}
    leaves = {index: _decode(tree, blocks[index], depth, verdicts) for index, tree in before.items()}
    tasks = [(index, block, depth, verdicts) for index, block in enumerate(blocks) if index not in leaves]
    for done, (index, tree) in enumerate(run_tasks(_compute_block, tasks, jobs=jobs, dask=dask), start=len(leaves) + 1):
        checkpoint.add(str(index), tree)
        leaves[index] = _decode(tree, blocks[index], depth, verdicts)
        if progress is not None:
            progress(done, len(blocks))
    every = tuple(cell for index in range(len(blocks)) for cell in leaves[index])
    return CellMap(title, window, depth, verdicts.kinds, every, added)


def _walk(cell: Leaf, depth: int, letter_of: Callable[[Leaf], str]) -> Iterator[tuple[str, Leaf | None]]:
    """Yield the letters of the quadtree of a cell in their order, each with its cell, if that is not cut."""
    letter = letter_of(cell)
    if letter == CUT and cell.level < depth:
        yield CUT, None
        for quarter in _quarters(cell):
            yield from _walk(quarter, depth, letter_of)
    else:
        yield letter, cell


def _compute_block(task: tuple[int, Leaf, int, Verdicts]) -> tuple[int, str]:
    """Return a block's index and the text of its quadtree."""
    index, block, depth, verdicts = task

    def decided(cell: Leaf) -> str:
        found = verdicts.decide(cell.sides)
        return CUT if found is verdicts.undecided and cell.level < depth else str(found.value)

    return index, "".join(letter for letter, _ in _walk(block, depth, decided))


def _decode(tree: str, block: Leaf, depth: int, verdicts: Verdicts) -> tuple[Leaf, ...]:
    """Return the cells that a block's text stands for. Raises InvalidMap if it is damaged."""
    letters = iter(tree)
    try:
        walk = _walk(block, depth, lambda _: next(letters, ""))
        cells = tuple(cell._replace(verdict=verdicts.kinds(letter)) for letter, cell in walk if cell)
    except ValueError:
        cells = ()
    if not cells or next(letters, None) is not None:
        raise InvalidMap(f"the checkpoint holds a damaged block ({tree[:40]!r}...); remove its line")
    return cells


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


class Checkpoint:
    """Finished parts by name, kept in a file (or nowhere). A last line torn by a crash is dropped."""

    def __init__(self, path: Path | None, title: dict[str, object]) -> None:
        """Read what is there, or begin the file with the title. Raises InvalidMap if it belongs to something else."""
        self.finished: dict[str, str] = {}
        self._path = path
        if path is None:
            return
        lines = path.read_bytes().decode("utf-8", errors="replace").splitlines(keepends=True) if path.exists() else []
        whole = [line for line in lines if line.endswith("\n")]
        for number, line in enumerate(whole):
            match _parsed(line), number:
                case dict() as found, 0 if found == title:
                    pass
                case dict(), 0:
                    raise InvalidMap(f"checkpoint {path.name} is of another map ({line[:120]}); name another file")
                case {"part": str(part), "result": str(result)}, _:
                    self.finished[part] = result
                case _:
                    raise InvalidMap(
                        f"checkpoint {path.name}, line {number + 1} is damaged; remove the line, or name another file"
                    )
        # what is appended next must not continue a torn line
        path.write_text("".join(whole) or _line(title), "utf-8")

    def add(self, part: str, result: str) -> None:
        """Append a finished part as one whole line."""
        if self._path is not None:
            with self._path.open("a", encoding="utf-8") as file:
                file.write(_line({"part": part, "result": result}))


def _line(record: dict[str, object]) -> str:
    return json.dumps(record) + "\n"


def _parsed(line: str) -> object:
    try:
        return json.loads(line)
    except ValueError:
        return None
