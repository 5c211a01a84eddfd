"""A scene as the kernel reads it: floats and tables, in SI units."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import chain
from typing import NamedTuple

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.ball import exact_middle
from numerics.arithmetic.compiled import compiled
from numerics.arithmetic.pair import nearest
from numerics.arithmetic.precision import precision
from numerics.errors import OutOfRange
from numerics.linear.cells import Cells, cells_of
from numerics.linear.model import (
    CEILING,
    CONSTANT,
    KINETIC,
    SLIP,
    V1,
    X1,
    X2,
    Bodies,
    Cell,
    Layout,
    Norm,
    Rows,
    exact_rows,
    norm_of,
)
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.record import AT, END_ROW
from numerics.linear.room import Drive, Problem
from numerics.linear.table import OTHERS, REACH, Tables, form, make_tables, most_terms
from numerics.scene import Law, Pair, Scene
from numerics.scene.decimals import short

Halves = tuple[float, float]
Kind = tuple[Layout, Cell]
"""What the matrices of a piece depend on."""
LEAST, MOST = 1e-60, 1e60
"""Of the numbers that give a pair its scale, so that powers and products of them are in the range of floats."""
_MOST_KINDS = 4_000
"""For so many cells of friction in all pieces there are tables."""
_EVENTS_PER_HALF_TURN = 3
"""So many events a half turn of the fastest rate (of body 1 alone, of a sine) is given room for."""
_STATE = slice(AT["x1"], AT["x1"] + 4)
"""Where x1, v1, x2 and v2 stand in a row."""


class Prepared(NamedTuple):
    """What the kernel takes."""

    problem: Problem
    start: NDArray[np.float64]
    pieces: Sequence[ExactPiece]
    half_turns: float
    """How many of them the fastest rate makes."""

    def room(self, most: int) -> int:
        """Return how many rows are given room for at first, with so many events at most."""
        return len(self.pieces) + 1 + int(min(most, 16 + _EVENTS_PER_HALF_TURN * self.half_turns))


def halves(x: Fraction) -> Halves:
    """Return x as a float, and what its rounding left out. Raises OutOfRange."""
    try:
        return nearest(x)
    except OverflowError:
        raise OutOfRange.of(short(x), "float64") from None


def rounded(x: Fraction) -> float:
    """Return the float nearest to x. Raises OutOfRange."""
    return halves(x)[0]


def reduced(phase: Fraction) -> Fraction:
    """Return a phase less whole turns, in (-pi, pi], as far as 256 bits go; itself below 4."""
    if abs(phase) < 4:
        return phase
    turn = _turn(256 * (2 + round(abs(phase)).bit_length() // 256))
    return phase - round(phase / turn) * turn


@lru_cache(maxsize=16)
def _turn(bits: int) -> Fraction:
    """Return 2 pi to so many bits."""
    with precision(bits):
        return exact_middle(2 * arb.pi())


@lru_cache(maxsize=256)
def _require_scale(pair: Pair) -> None:
    """Raise OutOfRange for a pair whose masses, a2 or L are so small or large that powers of them are lost."""
    sizes = {"m1": pair.m1, "m2": pair.m2, "a2": pair.a2, "L": pair.half_width if pair.a2 and pair.b else 0}
    for name, value in sizes.items():
        if value not in {0, math.inf} and not LEAST < value < MOST:
            raise OutOfRange.of(f"{name} of this pair, {short(Fraction(value))},", "float64", LEAST, MOST)


@lru_cache(maxsize=128)
def prepare(scene: Scene) -> Prepared:
    """Return a scene as the kernel reads it. Raises OutOfRange."""
    _require_scale(scene.pair)
    pieces, cells = pieces_of(scene), cells_of(scene)
    if cells and (any(not one.b for one in pieces) or len(cells.all) * len(pieces) > _MOST_KINDS):
        raise OutOfRange("friction that vanishes, or of too many points and pieces, is solved in balls only")
    drive, kinds, longest = _drive(cells, pieces)
    norm = norm_of(Bodies(*map(rounded, Bodies.of(scene.pair))))
    tables = _tables(scene.pair, norm, kinds, longest)
    tables = tables if cells is None else _cut(tables, cells, norm.kappa)
    at, start = scene.initial, np.zeros(END_ROW)
    start[_STATE] = [rounded(one) for one in (at.x1, at.v1, at.x2, at.v2)]
    start[AT["mode"]] = gap = (at.v1 > at.v2) - (at.v1 < at.v2)  # exact: floats may be equal
    start[AT["jump"]] = gap == 0
    half_turns = float(drive.length[:, 0].sum()) * REACH / float(tables.steps[:, :2].min()) / math.pi
    problem = Problem(norm, drive, tables, scene.law is Law.THREE_VALUED_SGN)
    return Prepared(problem, start, pieces, half_turns)


def _drive(cells: Cells | None, pieces: Sequence[ExactPiece]) -> tuple[Drive, tuple[Kind, ...], float]:
    """Return the table of the pieces, the kinds in it, and the length of the longest piece."""
    places: list[tuple[int, ...]] = []
    coefficients: list[float] = []
    sines: list[tuple[Halves, Halves, Halves]] = []
    kinds: dict[tuple[Kind, ...], int] = {}
    for one in pieces:
        own = _kinds(cells, one)
        index = kinds.setdefault(own, len(kinds))
        places.append((index * len(own), len(coefficients), len(sines), int(one.is_jump), int(one.belt_jumps)))
        for signal in one.signals:
            coefficients += map(rounded, signal.polynomial)
            for sine in signal.sines:
                phase = reduced(sine.phase + sine.omega * one.start)
                sines.append((halves(sine.amplitude), halves(sine.omega), halves(phase)))
    length = np.array([halves(one.length) for one in pieces])
    arrays = np.array(places, dtype=np.int64), length, np.array(coefficients), np.array(sines).reshape(-1, 3, 2)
    return Drive(*arrays), tuple(chain.from_iterable(kinds)), float(length[:, 0].max())


def _kinds(cells: Cells | None, piece: ExactPiece) -> tuple[Kind, ...]:
    """Return the kinds of a piece, one for each cell."""
    if cells is None:
        return ((piece.layout, CONSTANT),)
    return tuple((piece.layout, cells.branch(piece, *one)) for one in cells.all)


def _cut(tables: Tables, cells: Cells, kappa: float) -> Tables:
    """Return tables with the ends of cells."""
    numbers = {one: n for n, one in enumerate(cells.all[:-1])}
    ends, behind = np.full((len(cells.all), 3), np.inf), np.full((len(cells.all), 3), -1)
    for n, (side, cell) in enumerate(cells.all):
        limit = cells.limit(cell)
        for kind, _, offset in cells.guards(side, cell)[0]:
            to = cells.behind(side, cell, kind)
            ends[n, kind] = rounded(offset)
            behind[n, kind] = numbers[side, to] if to[0] >= 0 and cells.is_open(to) else -1
        if limit is not None:
            ends[n, CEILING], behind[n, CEILING] = rounded(limit), -1
    meets = np.array([[numbers[side, (0, j)] for side in (-1, 1, 1)] for _, (_, j) in cells.all])
    meets[-1, 0], meets[-1, 1] = numbers[-1, (0, cells.begun[0])], len(numbers)
    slope, pull = (np.abs(tables.lines[:, 0, OTHERS + KINETIC, place]).max() for place in (V1, X1))
    return tables._replace(ends=ends, behind=behind, meets=meets, steep=np.array([kappa * kappa * slope, kappa * pull]))


@lru_cache(maxsize=64)
def _tables(pair: Pair, norm: Norm, kinds: tuple[Kind, ...], longest: float) -> Tables:
    """Return the tables of all kinds of pieces; every entry of a matrix is rounded once."""
    n, terms = max(one.size for one, _ in kinds), max(max(one.terms) for one, _ in kinds)
    tables = make_tables(len(kinds), n, most_terms(terms))
    for index, (layout, cell) in enumerate(kinds):
        rows = Rows(*(_rounded(one) for one in exact_rows(pair, layout, cell)))
        rows.guards[SLIP, 1, X1], rows.guards[SLIP, 1, X2] = (1.0, -1.0) if cell is not CONSTANT else (0.0, 0.0)
        compiled(form)(tables, index, norm, layout.blocks, rows, 1.0, longest)
    return tables


_rounded = np.vectorize(rounded, otypes=[np.float64])
