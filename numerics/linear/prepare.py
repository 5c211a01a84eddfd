"""A scene as the kernel reads it: units in which powers stay in the range of floats; tables.

Units of mass, time and length are powers of 2, so that they change no bit of what comes out.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.ball import exact_middle
from numerics.arithmetic.compiled import compiled
from numerics.arithmetic.pair import nearest
from numerics.arithmetic.precision import precision
from numerics.errors import OutOfRange
from numerics.linear.columns import Constants, Drive, Problem, constants
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.record import AT, END_ROW
from numerics.linear.table import (
    FIRST,
    Tables,
    form,
    make_tables,
    most_terms,
)
from numerics.scene import Law, Pair, Scene
from numerics.scene.decimals import short

Halves = tuple[float, float]
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

    problem: Problem
    start: NDArray[np.float64]
    units: KernelUnits
    pieces: Sequence[ExactPiece]

    def room(self, most: int) -> int:
        """Return how many rows are given room for at first, with so many events at most."""
        pair, drive, *_ = self.problem
        fastest = max((pair.a2 / pair.m1) ** 0.5, float(drive.sines[:, 1, 0].max(initial=0.0)))
        half_turns = float(drive.length[:, 0].sum()) * fastest / math.pi
        return len(self.pieces) + 1 + int(min(most, 16 + _EVENTS_PER_HALF_TURN * half_turns))

    def part(self, piece: int, until: Fraction) -> Problem:
        """Return the problem of one piece alone, up to a time in it (s)."""
        drive = self.problem.drive
        length = np.array([halves(until, self.units.time)])
        alone = drive._replace(places=drive.places[piece : piece + 1], b=drive.b[piece : piece + 1], length=length)
        return self.problem._replace(drive=alone)


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
def _bodies_of(pair: Pair, law: Law) -> tuple[Constants, tuple[Halves, ...], KernelUnits]:
    """Return the constants of a pair, its m1, M, m2, a1 and a2 with their rests, and the units of all numbers.

    In these M and a2 are about 1, and the other numbers not far from it, if they can. Raises OutOfRange, also where
    floats do not hold L and E_cr, in which the answer is given, too.
    """
    for value in (pair.half_width, pair.critical_energy):
        if rounded(value) == 0.0:
            raise OutOfRange.of(f"L or E_cr of this pair, {short(value)},", "float64")
    mass = _exponent(pair.mass)
    units = KernelUnits(mass, (mass - _exponent(pair.a2)) // 2, _exponent(pair.half_width))
    given = (pair.m1, 0), (pair.mass, 0), (pair.m2, 0), (pair.a1, -1), (pair.a2, -2)
    numbers = tuple([halves(value, units.of(mass=1, time=power)) for value, power in given])
    return constants(np.array(numbers), law is Law.THREE_VALUED_SGN), numbers, units


def prepare(scene: Scene) -> Prepared:
    """Return a scene as the kernel reads it, made once and kept with the scene. Raises OutOfRange."""
    if "prepared" in scene.made:
        return scene.made["prepared"]
    pair, numbers, units = _bodies_of(scene.pair, scene.law)
    pieces = pieces_of(scene)
    drive, kinds, longest = _drive(pieces, units)
    tables = _tables(numbers, tuple(kinds), longest)
    at, start, place, speed = scene.initial, np.zeros(END_ROW), units.length, units.of(length=1, time=-1)
    start[_STATE] = rounded(at.x1, place), rounded(at.v1, speed), rounded(at.x2, place), rounded(at.v2, speed)
    start[AT["mode"]] = gap = (at.v1 > at.v2) - (at.v1 < at.v2)  # exact: floats may be equal
    start[AT["jump"]] = gap == 0
    scene.made["prepared"] = found = Prepared(Problem(pair, drive, tables, True), start, units, pieces)
    return found


Kind = tuple[int, tuple[Halves, ...]]
"""The number of coefficients of the polynomial, and the frequencies."""


def _drive(pieces: Sequence[ExactPiece], units: KernelUnits) -> tuple[Drive, dict[Kind, int], float]:
    """Return the table of the pieces, the kinds of force in it, and the length of the longest piece."""
    force, second = units.of(mass=1, length=1, time=-2), units.time
    places: list[tuple[int, ...]] = []
    b: list[float] = []
    length: list[Halves] = []
    coefficients: list[float] = []
    sines: list[tuple[Halves, Halves, Halves]] = []
    kinds: dict[Kind, int] = {}
    for one in pieces:
        omegas = tuple([halves(sine.omega, -second) for sine in one.sines])
        index = kinds.setdefault((len(one.polynomial), omegas), len(kinds))
        places.append((len(coefficients), len(one.polynomial), len(sines), len(one.sines), index, int(one.is_jump)))
        b.append(rounded(one.b, force))
        length.append(halves(one.length, second))
        coefficients += [rounded(c, force - k * second) for k, c in enumerate(one.polynomial)]
        for sine, omega in zip(one.sines, omegas, strict=True):
            phase = sine.phase + sine.omega * one.start if one.start else sine.phase
            sines.append((halves(sine.amplitude, force), omega, halves(reduced(phase))))
    numbers = np.array(coefficients), np.array(sines).reshape(-1, 3, 2)
    drive = Drive(np.array(places, dtype=np.int64), np.array(b), np.array(length), *numbers)
    return drive, kinds, max(length)[0]


@lru_cache(maxsize=64)
def _tables(pair: tuple[Halves, ...], kinds: tuple[Kind, ...], longest: float) -> Tables:
    """Return the tables of all kinds of force."""
    columns, most = max(FIRST + terms + 2 * len(omegas) for terms, omegas in kinds), max(terms for terms, _ in kinds)
    tables = make_tables(len(kinds), columns, most_terms(most))
    for index, (coefficients, omegas) in enumerate(kinds):
        compiled(form)(tables, index, np.array(pair), coefficients, np.array(omegas).reshape(-1, 2), longest)
    return tables
