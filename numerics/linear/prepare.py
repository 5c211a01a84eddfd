"""A scene as the kernel reads it: units in which powers stay in the range of floats, pairs of floats, tables.

Units of mass, time and length are powers of 2, so that they change no bit of what comes out.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray

from numerics.arithmetic.ball import exact_middle
from numerics.arithmetic.compiled import compiled
from numerics.errors import OutOfRange
from numerics.linear.columns import Constants, Drive, constants
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.record import AT, ROW
from numerics.linear.table import FIRST, Tables, form, make_tables
from numerics.scene import Law, Pair, Scene

Halves = tuple[float, float]
REACH, TERMS = 1.5, 24
"""rate h of a step in float64, and how many Taylor terms make truncation smaller than rounding."""
_WIDE_REACH, _WIDE_TERMS = 1.5, 36
"""The same in double-double."""
_MORE_TERMS = 14
"""So many terms more than the polynomial of u has coefficients."""
_ROWS_PER_HALF_TURN, _MOST_HALF_TURNS = 3, 5_000
"""Events that a half turn of the fastest rate is given room for, and how many half turns are foreseen."""


class Units(NamedTuple):
    """Exponents of 2: one unit of mass is 2^mass kg, and so on."""

    mass: int
    time: int
    length: int

    def of(self, mass: int = 0, time: int = 0, length: int = 0) -> int:
        """Return the exponent of kg^mass s^time m^length."""
        return mass * self.mass + time * self.time + length * self.length


class Prepared(NamedTuple):
    """What the kernel takes, and the units in which it gives."""

    pair: Constants
    drive: Drive
    tables: Tables
    start: NDArray[np.float64]
    is_decided: bool
    units: Units
    pieces: Sequence[ExactPiece]
    room: int
    """So many rows are given room for at first; with more the run is made again."""


def halves(x: Fraction, exponent: int = 0) -> Halves:
    """Return x 2^-exponent as a pair of floats. Raises OutOfRange."""
    n, d = x.numerator, x.denominator
    if exponent < 0:
        n <<= -exponent
    else:
        d <<= exponent
    try:
        high = n / d
        p, q = high.as_integer_ratio()
        low = (n * q - p * d) / (d * q)
    except OverflowError:
        raise OutOfRange('a number of this scene is beyond the range of float64; use arithmetic="ball"') from None
    return high, low


def reduced(phase: Fraction) -> Fraction:
    """Return a phase less whole turns, in (-pi, pi], as far as 256 bits go; itself below 4."""
    if abs(phase) < 4:
        return phase
    turn = _turn(256 * (2 + round(abs(phase)).bit_length() // 256))
    return phase - round(phase / turn) * turn


@lru_cache(maxsize=16)
def _turn(bits: int) -> Fraction:
    """Return 2 pi to so many bits."""
    with ctx.workprec(bits):
        return exact_middle(2 * arb.pi())


class Bodies(NamedTuple):
    """What the kernel takes of a pair: its constants, m1, M, m2, a1 and a2 as halves, and the units of all numbers."""

    constants: Constants
    halves: tuple[Halves, ...]
    units: Units


def _exponent(x: Fraction) -> int:
    return x.numerator.bit_length() - x.denominator.bit_length()


@lru_cache(maxsize=256)
def bodies_of(pair: Pair, law: Law) -> Bodies:
    """Return a pair in units in which M and a2 are about 1, and the other numbers not far from it, if they can.

    Raises OutOfRange, also where floats do not hold what the answer is told in beside its own numbers: L and E_cr.
    """
    for value in (pair.half_width, pair.critical_energy):
        if halves(value)[0] == 0.0:
            raise OutOfRange('a number of this scene is beyond the range of float64; use arithmetic="ball"')
    mass = _exponent(pair.mass)
    units = Units(mass, (mass - _exponent(pair.a2)) // 2, _exponent(pair.half_width))
    kg = units.of(mass=1)
    numbers = *(halves(one, kg) for one in (pair.m1, pair.mass, pair.m2)), halves(pair.a1, kg - units.time)
    numbers = *numbers, halves(pair.a2, kg - 2 * units.time)
    return Bodies(constants(np.array(numbers), law is Law.THREE_VALUED_SGN), numbers, units)


def prepare(scene: Scene, *, wide: bool) -> Prepared:
    """Return a scene as the kernel reads it, made once and kept with the scene. Raises OutOfRange."""
    found: Prepared | None = scene.made.get(wide)
    if found is None:
        found = scene.made[wide] = _prepared(scene, wide=wide)
    return found


def _prepared(scene: Scene, *, wide: bool) -> Prepared:
    pair, numbers, units = bodies_of(scene.pair, scene.law)
    pieces = pieces_of(scene)
    drive, kinds = _drive(pieces, units)
    tables = _tables(numbers, tuple(kinds), float(drive.length[:, 0].max()), wide)
    at, speed = scene.initial, units.of(length=1, time=-1)
    start = np.zeros(ROW)
    for name, value, exponent in (
        ("x1", at.x1, units.length),
        ("v1", at.v1, speed),
        ("x2", at.x2, units.length),
        ("v2", at.v2, speed),
    ):
        start[AT[name] : AT[name] + 2] = halves(value, exponent)
    gap = (at.v1 > at.v2) - (at.v1 < at.v2)  # exact: halves may not tell
    start[AT["mode"]] = gap
    room = len(pieces) + 16 + int(_ROWS_PER_HALF_TURN * _half_turns(pair, drive))
    return Prepared(pair, drive, tables, start, gap != 0, units, pieces, room)


def _half_turns(pair: Constants, drive: Drive) -> float:
    """Return how often the fastest of body 1 alone and the sines turns by pi over the run, or the most foreseen."""
    fastest = max((pair.a2 / pair.m1) ** 0.5, float(drive.sines[:, 1, 0].max(initial=0.0)))
    found = float(drive.length[:, 0].sum()) * fastest / math.pi
    return found if found < _MOST_HALF_TURNS else _MOST_HALF_TURNS


Kind = tuple[int, tuple[Halves, ...]]
"""The number of coefficients of the polynomial, and the frequencies."""


def _drive(pieces: Sequence[ExactPiece], units: Units) -> tuple[Drive, dict[Kind, int]]:
    """Return the table of the pieces, and the kinds of force in it."""
    force, second = units.of(mass=1, length=1, time=-2), units.time
    places: list[tuple[int, ...]] = []
    b: list[Halves] = []
    length: list[Halves] = []
    coefficients: list[Halves] = []
    sines: list[tuple[Halves, Halves, Halves]] = []
    kinds: dict[Kind, int] = {}
    omegas: dict[Fraction, Halves] = {}
    last: Fraction | None = None
    for one in pieces:
        for sine in one.sines:
            if sine.omega not in omegas:
                omegas[sine.omega] = halves(sine.omega, -second)
        kind = len(one.polynomial), tuple(omegas[sine.omega] for sine in one.sines)
        index = kinds.setdefault(kind, len(kinds))
        places.append((len(coefficients), len(one.polynomial), len(sines), len(one.sines), index, int(one.is_jump)))
        b.append(b[-1] if one.b == last else halves(one.b, force))
        last = one.b
        length.append(halves(one.length, second))
        coefficients += [halves(c, force - k * second) for k, c in enumerate(one.polynomial)]
        for sine in one.sines:
            phase = reduced(sine.omega * one.start + sine.phase)
            sines.append((halves(sine.amplitude, force), omegas[sine.omega], halves(phase)))
    drive = Drive(
        np.array(places, dtype=np.int64),
        np.array(b),
        np.array(length),
        np.array(coefficients).reshape(-1, 2),
        np.array(sines).reshape(-1, 3, 2),
    )
    return drive, kinds


def most_terms(coefficients: int, least: int = TERMS) -> int:
    """Return how many Taylor terms a table has: an even number, beyond the degree of the polynomial of u."""
    return max(least, coefficients + _MORE_TERMS + coefficients % 2)


@lru_cache(maxsize=64)
def _tables(pair: tuple[Halves, ...], kinds: tuple[Kind, ...], longest: float, wide: bool) -> Tables:
    """Return the tables of all kinds of force."""
    columns, most = max(FIRST + terms + 2 * len(omegas) for terms, omegas in kinds), max(terms for terms, _ in kinds)
    reach, terms = (_WIDE_REACH, most_terms(most, _WIDE_TERMS)) if wide else (REACH, most_terms(most))
    tables = make_tables(len(kinds), columns, terms)
    for index, (coefficients, omegas) in enumerate(kinds):
        compiled(form)(
            tables, index, np.array(pair), coefficients, np.array(omegas).reshape(-1, 2), longest, reach, wide
        )
    return tables
