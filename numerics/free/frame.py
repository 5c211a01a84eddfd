"""Reduced coordinates, in which the free pair has one parameter; how a run starts in them, every sign decided exactly.

With M = m1 + m2, L = b M/(a2 m2), Omega = sqrt(a2/M), q = m1/M, r = m2/M, 2 zeta = a1/(M Omega):
X = x1/L, V_i = v_i/(L Omega), Z = (x1 - x2)/L, tau = Omega t, w = E/E_cr - 1 (all dimensionless). Then

    stick            X'' + 2 zeta X' + X = 0
    slip, sign s     q V1' = -(X + 2 zeta V1 + r s),   V2' = s
    energy           E/E_cr = X^2 + q V1^2 + r V2^2,   w' = -2 r |V1 - V2| - 4 zeta V1^2

The SI numbers of a start are exact rationals, or binary64 numbers in compiled code. What a run needs of them is formed
in their own arithmetic and converted once, by the function `narrow`. From rationals every sign is exact and every
number rounded once. From binary64 numbers a difference is off by roundings of its terms (bounds.initial), and
`is_known` says whether all signs are certain and every difference keeps most of its digits; else convert exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

from flint import fmpq

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.functions import like, signed, sqrt
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.motion import FREE, STICK, SURFACE, Parameters
from numerics.free.slip import Start
from numerics.scene import Pair

Given = Any
"""fmpq, or float in compiled code."""
Narrow = Callable[[Given], Number]
_SURE = 2.0**-6
"""A difference smaller than this, relative to its terms, is left to exact arithmetic."""


def as_fmpq(x: Fraction) -> fmpq:
    """Return a rational as one of flint, which calculates several times as fast."""
    return fmpq(x.numerator, x.denominator)


def narrowing(arithmetic: Arithmetic) -> Narrow:
    """Return what turns rationals of flint into numbers of an arithmetic."""
    return lambda x: arithmetic.number(Fraction(int(x.p), int(x.q)))


class FrameUnits(NamedTuple):
    """What one unit of the reduced numbers is: L in m, Omega in 1/s, E_cr in J."""

    length: Number
    rate: Number
    energy: Number


@compilable
def in_si(units: FrameUnits, at: Any) -> tuple[Number, Number, Number, Number]:
    """Return (x1, v1, x2, v2) in m and m/s of a reduced state."""
    speed = units.length * units.rate
    return units.length * at.X, speed * at.V1, units.length * (at.X - at.Z), speed * at.V2


class Begun(NamedTuple):
    """How a scene begins: reduced parameters, first motion, velocities, horizon, units."""

    at: Parameters
    start: Start
    V1: Number
    V2: Number
    horizon: Number
    units: FrameUnits


@compilable
def _sign(x: Given) -> int:
    zero = x - x
    return (x > zero) - (x < zero)


@compilable
def constants(
    m1: Given, m2: Given, a2: Given, b: Given, literal: bool, narrow: Narrow, unit: float
) -> tuple[Parameters, FrameUnits]:
    """Return the reduced parameters and the units of a pair; `unit` is the rounding of one operation."""
    mass, stiff = m1 + m2, a2 * m2
    q, edge = narrow(m1 / mass), mass * b
    units = FrameUnits(narrow(edge / stiff), sqrt(narrow(a2 / mass)), narrow(edge * edge / (2 * (stiff * m2))))
    return Parameters(q, narrow(m2 / mass), sqrt(q), literal, unit), units


@compilable
def begin(given: tuple[Given, ...], literal: bool, narrow: Narrow, unit: float) -> Begun:
    """Return how a scene with a1 = 0 begins, given m1, m2, a2, b, x1, v1, x2, v2 and until in SI units.

    Which mode begins is the rule of linear/modes.py.
    """
    m1, m2, a2, b, x1, v1, x2, v2, until = given
    at, units = constants(m1, m2, a2, b, literal, narrow, unit)
    mass = m1 + m2
    length, squared, q, r = mass * b / (a2 * m2), a2 / mass, m1 / mass, m2 / mass
    x, apart = x1 / length, (v1 - v2) / length
    v1, v2 = v1 / length, v2 / length  # V_i Omega
    X, V1, V2 = narrow(x), narrow(v1) / units.rate, narrow(v2) / units.rate
    Z, w = narrow((x1 - x2) / length), narrow(x * x + (q * v1 * v1 + r * v2 * v2) / squared - 1)
    horizon, zero = units.rate * narrow(until), like(X, 0.0)
    mode, near = _sign(apart), 1 if _sign(x) >= 0 else -1
    on_surface, outside = mode == 0, _sign(near * x - 1)
    # on the edge the pair leaves by the side to which it moves
    if on_surface and not literal and (outside > 0 or (outside == 0 and near * _sign(v1) > 0)):
        mode = -near
    way = -mode if mode != 0 else near
    beyond, side = way * x - 1, float(way)
    if mode == 0:
        start = Start(STICK, side, X, zero, narrow(beyond), V1, zero, True, Z, w, zero, zero, zero)
        return Begun(at, start, V1, V2, horizon, units)
    gap = beyond / q
    turning = gap * (2 + gap) + v1 * v1 / (squared * q)
    guard = narrow(-way * apart) / units.rate / at.sqrt_q
    push = signed(side, V1) / at.sqrt_q
    driven = push if on_surface else signed(side, V2) / at.sqrt_q
    kind = SURFACE if on_surface else FREE
    start = Start(kind, side, X, guard, narrow(gap), push, driven, _sign(turning) > 0, Z, w, zero, zero, zero)
    return Begun(at, start, V1, V2, horizon, units)


@compilable
def is_known(begun: Begun) -> bool:
    """Return whether a start formed in binary64 has the signs of the exact one, and digits in all differences."""
    start, q, size = begun.start, begun.at.q, 1.0 + abs(begun.start.X)
    known = math.isfinite(start.w + begun.horizon) and abs(start.w) > _SURE * (1.0 + abs(1.0 + start.w))
    if start.kind == STICK:
        return known and abs(start.gap) > _SURE * size
    if start.kind == SURFACE:
        return known and q * abs(start.gap) > _SURE * size
    square, gap = start.push * start.push, abs(start.gap)
    turning = start.gap * (2.0 + start.gap) + square
    return known and abs(turning) > _SURE * (square + (2.0 + gap) * (gap + size / q))


class ReducedState(NamedTuple):
    """A point of the reduced state space; w is a variable of its own, accurate where E/E_cr - 1 would cancel."""

    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number


class Frame:
    """The constants of one pair in one arithmetic: dimensionless q, r, sqrt_q, two_zeta; SI units of what is reduced.

    These are length, rate, speed and critical_energy. two_zeta = 2 zeta is 0 for a free pair.
    In float64 rationals are rounded once (0.5 ulp), so roots of them are within 1 ulp and the speed within 3 ulp.
    """

    def __init__(self, arithmetic: Arithmetic, pair: Pair) -> None:
        """Convert the exact parameters once, in the arithmetic's context; raises OutOfRange if one does not fit."""
        self.arithmetic, narrow = arithmetic, narrowing(arithmetic)
        m1, m2, a2, b = map(as_fmpq, (pair.m1, pair.m2, pair.a2, pair.b))
        self.parameters, self.units = constants(m1, m2, a2, b, False, narrow, 0.0)
        self.q, self.r, self.sqrt_q, *_ = self.parameters
        self.length, self.rate, self.critical_energy = self.units
        self.speed = self.length * self.rate
        self.two_zeta = arithmetic.number(pair.a1 / pair.mass) / self.rate

    def reduced(self, y: Any, excess: Number | None = None) -> ReducedState:
        """Return (x1, v1, x2, v2) in reduced coordinates; without an excess, w is formed from the state."""
        x1, v1, x2, v2 = y
        X, V1, V2 = x1 / self.length, v1 / self.speed, v2 / self.speed
        w = self.energy_ratio(X, V1, V2) - 1 if excess is None else excess
        return ReducedState(X, V1, V2, (x1 - x2) / self.length, w)

    def energy(self, state: Any) -> Number:
        """Return E in J, formed from the state."""
        return self.critical_energy * self.energy_ratio(state.X, state.V1, state.V2)

    def energy_ratio(self, X: Number, V1: Number, V2: Number) -> Number:
        """Return E/E_cr = X^2 + q V1^2 + r V2^2, formed from the state: in float64 within 3.5 ulp.

        Each term is > 0 and has 2 u or less, u = 2^-53, the first sum adds 1 u and the second 0.5 ulp.
        """
        return X * X + self.q * V1 * V1 + self.r * V2 * V2
