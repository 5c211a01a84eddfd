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
from numerics.linear.pieces import ExactPiece, Grid, pieces_of
from numerics.linear.record import AT, ROW
from numerics.linear.table import FIRST, Tables, form, make_tables
from numerics.scene import Law, Pair, Scene, Sine

Halves = tuple[float, float]
REACH, TERMS = 2.0, 28
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

    @property
    def room(self) -> int:
        """Return how many rows are given room for at first; with more the run is made again."""
        return len(self.pieces) + 16 + int(_ROWS_PER_HALF_TURN * _half_turns(self.pair, self.drive))


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


class Known:
    """Numbers of scenes as halves; the very same numbers, which many pieces and scenes share, are converted once."""

    def __init__(self) -> None:
        """Begin with none."""
        self._found: dict[tuple[int, ...], tuple[Halves, object]] = {}
        self._bodies: dict[tuple[int, Law], tuple[Bodies, Pair]] = {}
        self.grid = Grid()

    def halves(self, x: Fraction, exponent: int = 0) -> Halves:
        """Return halves(x, exponent)."""
        key = id(x), exponent
        if key not in self._found:
            self._found[key] = halves(x, exponent), x  # what is kept keeps its id
        return self._found[key][0]

    def phase(self, sine: Sine, start: Fraction) -> Halves:
        """Return the phase of a sine at a time."""
        key = id(sine.omega), id(sine.phase), id(start)
        if key not in self._found:
            self._found[key] = halves(reduced(sine.omega * start + sine.phase)), (sine, start)
        return self._found[key][0]

    def bodies(self, pair: Pair, law: Law) -> Bodies:
        """Return bodies_of(pair, law)."""
        key = id(pair), law
        if key not in self._bodies:
            self._bodies[key] = bodies_of(pair, law), pair
        return self._bodies[key][0]


def prepare(scene: Scene, *, wide: bool, known: Known | None = None) -> Prepared:
    """Return a scene as the kernel reads it, made once and kept with the scene. Raises OutOfRange.

    `known`: what scenes before this one have had converted.
    """
    found: Prepared | None = scene.made.get(wide)
    if found is None:
        found = scene.made[wide] = _prepared(scene, known or Known(), wide=wide)
    return found


def _prepared(scene: Scene, known: Known, *, wide: bool) -> Prepared:
    pair, numbers, units = known.bodies(scene.pair, scene.law)
    pieces = pieces_of(scene, known.grid)
    drive, kinds, longest = _drive(pieces, units, known)
    tables = _tables(numbers, tuple(kinds), longest, wide)
    at, speed = scene.initial, units.of(length=1, time=-1)
    start = np.zeros(ROW)
    for name, value, exponent in (
        ("x1", at.x1, units.length),
        ("v1", at.v1, speed),
        ("x2", at.x2, units.length),
        ("v2", at.v2, speed),
    ):
        start[AT[name] : AT[name] + 2] = known.halves(value, exponent)
    gap = (at.v1 > at.v2) - (at.v1 < at.v2)  # exact: halves may not tell
    start[AT["mode"]] = gap
    return Prepared(pair, drive, tables, start, gap != 0, units, pieces)


def _half_turns(pair: Constants, drive: Drive) -> float:
    """Return how often the fastest of body 1 alone and the sines turns by pi over the run, or the most foreseen."""
    fastest = max((pair.a2 / pair.m1) ** 0.5, float(drive.sines[:, 1, 0].max(initial=0.0)))
    found = float(drive.length[:, 0].sum()) * fastest / math.pi
    return found if found < _MOST_HALF_TURNS else _MOST_HALF_TURNS


Kind = tuple[int, tuple[Halves, ...]]
"""The number of coefficients of the polynomial, and the frequencies."""


def _drive(pieces: Sequence[ExactPiece], units: Units, known: Known) -> tuple[Drive, dict[Kind, int], float]:
    """Return the table of the pieces, the kinds of force in it, and the length of the longest piece."""
    force, second = units.of(mass=1, length=1, time=-2), units.time
    places: list[tuple[int, ...]] = []
    b: list[Halves] = []
    length: list[Halves] = []
    coefficients: list[Halves] = []
    sines: list[tuple[Halves, Halves, Halves]] = []
    kinds: dict[Kind, int] = {}
    for one in pieces:
        omegas = tuple([known.halves(sine.omega, -second) for sine in one.sines])
        kind = len(one.polynomial), omegas
        index = kinds.setdefault(kind, len(kinds))
        places.append((len(coefficients), len(one.polynomial), len(sines), len(one.sines), index, int(one.is_jump)))
        b.append(known.halves(one.b, force))
        length.append(known.halves(one.length, second))
        coefficients += [known.halves(c, force - k * second) for k, c in enumerate(one.polynomial)]
        for sine, omega in zip(one.sines, omegas, strict=True):
            sines.append((known.halves(sine.amplitude, force), omega, known.phase(sine, one.start)))
    drive = Drive(
        np.array(places, dtype=np.int64),
        np.array(b),
        np.array(length),
        np.array(coefficients).reshape(-1, 2),
        np.array(sines).reshape(-1, 3, 2),
    )
    return drive, kinds, max(length)[0]


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
