"""A scene as the kernel reads it: units in which powers stay in the range of floats; tables.

Units of mass, time and length are powers of 2, so that they change no bit of what comes out.
"""

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
    AHEAD,
    BELT,
    CEILING,
    CONSTANT,
    DRIVEN,
    FIRST,
    KINETIC,
    SLIP,
    V1,
    WALL,
    X1,
    X2,
    Bodies,
    Cell,
    Layout,
    ModeRows,
    Norm,
    exact_rows,
    make_rows,
    norm_of,
)
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.record import AT, END_ROW, factors_of
from numerics.linear.room import Drive, Problems
from numerics.linear.table import BEHIND, MEET, OTHERS, REACH, Tables, form, make_tables, most_terms, put_matrices
from numerics.scene import Law, Pair, Scene
from numerics.scene.decimals import short

Halves = tuple[float, float]
Kind = tuple[Layout, Cell]
"""What the matrices of a piece depend on."""
_MOST_KINDS = 4_000
"""For so many cells of friction in all pieces there are tables."""
_EVENTS_PER_HALF_TURN = 3
"""So many events a half turn of the fastest rate (of body 1 alone, of a sine) is given room for."""
_STATE = slice(AT["x1"], AT["x1"] + 4)
"""Where x1, v1, x2 and v2 stand in a row."""


class KernelUnits(NamedTuple):
    """Exponents of 2: one unit of mass is 2^mass kg, and so on."""

    mass: int
    time: int
    length: int

    def of(self, mass: int = 0, time: int = 0, length: int = 0) -> int:
        """Return the exponent of kg^mass s^time m^length."""
        return mass * self.mass + time * self.time + length * self.length


class Prepared(NamedTuple):
    """What the kernel takes, and the units in which it gives."""

    problems: Problems
    """The scene's alone."""
    starts: NDArray[np.float64]
    """(1, END_ROW)"""
    units: KernelUnits
    pieces: Sequence[ExactPiece]
    cells: Cells | None
    half_turns: float
    """How many of them the fastest rate makes."""
    to_si: NDArray[np.float64]
    """(1, 5, 2), of record.factors_of"""

    def room(self, most: int) -> int:
        """Return how many rows are given room for at first, with so many events at most."""
        return len(self.pieces) + 1 + int(min(most, 16 + _EVENTS_PER_HALF_TURN * self.half_turns))


def halves(x: Fraction, exponent: int = 0) -> Halves:
    """Return x 2^-exponent as a float, and what its rounding left out. Raises OutOfRange."""
    try:
        return nearest(x, exponent)
    except OverflowError:
        raise OutOfRange.of(f"{short(x)}, or that in units of this pair,", "float64") from None


def rounded(x: Fraction, exponent: int = 0) -> float:
    """Return the float nearest to x 2^-exponent. Raises OutOfRange."""
    return halves(x, exponent)[0]


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


def _exponent(x: Fraction) -> int:
    return x.numerator.bit_length() - x.denominator.bit_length()


@lru_cache(maxsize=256)
def _units_of(scene_pair: Pair, until: Fraction, reach: Fraction) -> KernelUnits:
    """Return units in which M, a2 and L are about 1, as far as a pair has them; else time and length are a scene's.

    Raises OutOfRange where floats do not hold L and E_cr, in which the answer is given, too.
    """
    pair = scene_pair
    mass = _exponent(pair.m1 if pair.m2 == math.inf else pair.mass)
    time = (mass - _exponent(pair.a2)) // 2 if pair.a2 else _exponent(until)
    if pair.a2 and pair.b:
        for value in (pair.half_width, pair.critical_energy):
            if rounded(value) == 0.0:
                raise OutOfRange.of(f"L or E_cr of this pair, {short(value)},", "float64")
        return KernelUnits(mass, time, _exponent(pair.half_width))
    return KernelUnits(mass, time, _exponent(reach) if reach else 0)


def _reach(scene: Scene) -> Fraction:
    """Return a length of a scene's size."""
    at = scene.initial
    moved = max(abs(at.x1), abs(at.x2), max(abs(at.v1), abs(at.v2)) * scene.until)
    return moved or scene.pair.b / scene.pair.m1 * scene.until**2


@lru_cache(maxsize=128)
def prepare(scene: Scene) -> Prepared:
    """Return a scene as the kernel reads it. Raises OutOfRange."""
    units, pieces = _units_of(scene.pair, scene.until, _reach(scene)), pieces_of(scene)
    cells = cells_of(scene)
    if cells and (any(not one.b for one in pieces) or len(cells.all) * len(pieces) > _MOST_KINDS):
        raise OutOfRange("friction that vanishes, or of too many points and pieces, is solved in balls only")
    drive, kinds, longest = _drive(cells, pieces, units)
    norm = _norm(scene.pair, units)
    tables = _tables(scene.pair, norm, kinds, units, longest)
    if cells is not None:
        tables, norm = _cut(tables, cells, norm, units)
    at, starts, place, speed = scene.initial, np.zeros((1, END_ROW)), units.length, units.of(length=1, time=-1)
    start = starts[0]
    start[_STATE] = rounded(at.x1, place), rounded(at.v1, speed), rounded(at.x2, place), rounded(at.v2, speed)
    start[AT["mode"]] = gap = (at.v1 > at.v2) - (at.v1 < at.v2)  # exact: floats may be equal
    start[AT["jump"]] = gap == 0
    half_turns = float(drive.length[:, 0].sum()) * REACH / float(tables.steps[:, :2].min()) / math.pi
    alone = Drive(*(one[None] for one in drive))
    problems = Problems(np.array([norm]), alone, tables, scene.law is Law.THREE_VALUED_SGN)
    return Prepared(problems, starts, units, pieces, cells, half_turns, factors_of([units]))


def _drive(
    cells: Cells | None, pieces: Sequence[ExactPiece], units: KernelUnits
) -> tuple[Drive, tuple[Kind, ...], float]:
    """Return the table of the pieces, the kinds in it, and the length of the longest piece."""
    second = units.time
    places: list[tuple[int, ...]] = []
    coefficients: list[float] = []
    sines: list[tuple[Halves, Halves, Halves]] = []
    kinds: dict[tuple[Kind, ...], int] = {}
    for one in pieces:
        own = _kinds(cells, one)
        index = kinds.setdefault(own, len(kinds))
        places.append((index * len(own), len(coefficients), len(sines), int(one.is_jump), int(one.belt_jumps)))
        for signal, exponent in zip(one.signals, _dimensions(units), strict=True):
            coefficients += [rounded(c, exponent - k * second) for k, c in enumerate(signal.polynomial)]
            for sine in signal.sines:
                phase = reduced(sine.phase + sine.omega * one.start)
                sines.append((halves(sine.amplitude, exponent), halves(sine.omega, -second), halves(phase)))
    length = np.array([halves(one.length, second) for one in pieces])
    arrays = np.array(places, dtype=np.int64), length, np.array(coefficients), np.array(sines).reshape(-1, 3, 2)
    return Drive(*arrays), tuple(chain.from_iterable(kinds)), float(length[:, 0].max())


def _kinds(cells: Cells | None, piece: ExactPiece) -> tuple[Kind, ...]:
    """Return the kinds of a piece, one for each cell."""
    if cells is None:
        return ((piece.layout, CONSTANT),)
    return tuple((piece.layout, cells.branch(piece, *one)) for one in cells.all)


def _cut(tables: Tables, cells: Cells, norm: Norm, units: KernelUnits) -> tuple[Tables, Norm]:
    """Return tables with the ends of cells, and a norm with how steep friction is in them."""
    numbers, speed = {one: n for n, one in enumerate(cells.all[:-1])}, units.of(length=1, time=-1)
    ends, neighbours = np.full((len(cells.all), 3), np.inf), np.full((len(cells.all), 2, 3), -1)
    for n, (side, cell) in enumerate(cells.all):
        limit = cells.limit(cell)
        for kind, _, offset in cells.guards(side, cell)[0]:
            to = cells.behind(side, cell, kind)
            ends[n, kind] = rounded(offset, units.length if kind == AHEAD else speed)
            neighbours[n, BEHIND, kind] = numbers[side, to] if to[0] >= 0 and cells.is_open(to) else -1
        if limit is not None:
            ends[n, CEILING], neighbours[n, BEHIND, CEILING] = rounded(limit, speed), -1
        neighbours[n, MEET] = [numbers[side, (0, cell[1])] for side in (-1, 1, 1)]
    neighbours[-1, MEET, :2] = numbers[-1, (0, cells.begun[0])], len(numbers)
    pieces = len(tables.ends) // len(ends)  # that differ, each with a kind for every cell
    firsts = len(ends) * np.arange(pieces)[:, None, None, None]
    of_kinds = np.where(neighbours < 0, -1, neighbours + firsts).reshape(-1, 2, 3)
    slope, pull = (float(np.abs(tables.lines[:, 0, OTHERS + KINETIC, place]).max()) for place in (V1, X1))
    steepest = norm._replace(steep=norm.kappa * norm.kappa * slope, pull=norm.kappa * pull)
    return tables._replace(ends=np.tile(ends, (pieces, 1)), neighbours=of_kinds), steepest


def _norm(pair: Pair, units: KernelUnits) -> Norm:
    """Return the numbers of the norm in these units."""
    mass, rate = units.mass, units.of(mass=1, time=-1)
    exponents = mass, rate, units.of(mass=1, time=-2), -mass, -mass, -mass, 0, 0, 0
    bodies = Bodies(*(rounded(one, exponent) for one, exponent in zip(Bodies.of(pair), exponents, strict=True)))
    return Norm(*map(float, norm_of(bodies)))


@lru_cache(maxsize=64)
def _tables(pair: Pair, norm: Norm, kinds: tuple[Kind, ...], units: KernelUnits, longest: float) -> Tables:
    """Return the tables of all kinds of pieces; every entry of a matrix is rounded once."""
    n, terms = max(one.size for one, _ in kinds), max(max(one.terms) for one, _ in kinds)
    tables = make_tables(len(kinds), n, most_terms(terms))
    for index, (layout, cell) in enumerate(kinds):
        rows = _in_units(exact_rows(pair, layout, cell), layout, units)
        rows.guards[SLIP, 1, X1], rows.guards[SLIP, 1, X2] = (1.0, -1.0) if cell is not CONSTANT else (0.0, 0.0)
        put_matrices(tables, index, layout, rows)
    compiled(form)(tables, np.array([norm] * len(kinds)), np.full(len(kinds), longest), 1.0)
    return tables


def _in_units(rows: ModeRows, layout: Layout, units: KernelUnits) -> ModeRows:
    """Return exact matrices as floats in units of powers of 2."""
    force, speed, size = units.of(mass=1, length=1, time=-2), units.of(length=1, time=-1), layout.size
    z = np.zeros(size, dtype=int)
    z[:FIRST] = units.length, speed, units.length, speed
    for (first, terms, sines, waves), exponent in zip(layout.blocks, _dimensions(units), strict=True):
        z[first : first + terms] = exponent - units.time * np.arange(terms)
        z[sines : sines + 2 * waves] = exponent
    found = make_rows(size)
    others = np.full((4, 1), force)
    others[DRIVEN] = speed
    guards, powers = np.array([speed, force])[:, None, None], np.array([force, speed])[None, None, :, None]
    for exact, own, unit in zip(rows, found, (z[None, :, None] - units.time, guards, others, powers), strict=True):
        exponents = np.broadcast_to(unit - z, exact.shape)
        for place in zip(*exact.nonzero(), strict=True):
            own[place] = rounded(exact[place], int(exponents[place]))
    return found


def _dimensions(units: KernelUnits) -> tuple[int, ...]:
    """Return the exponents of the signals."""
    found = [units.of(mass=1, length=1, time=-2)] * 5
    found[BELT], found[WALL] = units.of(length=1, time=-1), units.length
    return tuple(found)
