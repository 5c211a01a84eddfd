"""How a run starts: from SI numbers to reduced ones, every sign decided before anything is rounded.

With M = m1 + m2, L = b M/(a2 m2), Omega = sqrt(a2/M), q = m1/M, r = m2/M the reduced numbers are
X = x1/L, V_i = v_i/(L Omega), Z = (x1 - x2)/L, tau = Omega t, w = E/E_cr - 1 (all dimensionless), and

    stick            X'' + X = 0
    slip, sign s     q V1' = -(X + r s),   V2' = s
    energy           E/E_cr = X^2 + q V1^2 + r V2^2,   w' = -2 r |V1 - V2|

The SI numbers are wide: exact rationals, or double-double in compiled code. What a run needs of them is formed wide and
narrowed once, by the function `narrow`. Rationals are narrowed to any arithmetic, and everything is known;
double-double is narrowed to binary64, and says where 106 bits do not decide a sign or leave too few digits of a
difference (`known` is False: convert exactly).
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

from flint import fmpq

from numerics.arithmetic.compiled import by_type, compilable
from numerics.arithmetic.functions import like, signed, sqrt
from numerics.arithmetic.pair import Pair
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.motion import FREE, STICK, SURFACE, Parameters, Start

Wide = Any
"""fmpq, or Pair."""
Narrow = Callable[[Wide], Number]
_SURE = 2.0**-46
"""A difference smaller than this, relative to its terms, is left to exact arithmetic: 60 bits of 106 remain above."""


def wide(x: Fraction) -> fmpq:
    """Return a rational as one of flint, which calculates several times as fast."""
    return fmpq(x.numerator, x.denominator)


def narrowing(arithmetic: Arithmetic) -> Narrow:
    """Return what turns rationals of flint into numbers of an arithmetic."""
    return lambda x: arithmetic.number(Fraction(int(x.p), int(x.q)))


class SI(NamedTuple):
    """Parameters, initial state and horizon in SI units, wide; a1 is 0."""

    m1: Wide
    m2: Wide
    a2: Wide
    b: Wide
    x1: Wide
    v1: Wide
    x2: Wide
    v2: Wide
    until: Wide
    a1: Wide


class Units(NamedTuple):
    """What one unit of the reduced numbers is: L in m, Omega in 1/s, E_cr in J."""

    length: Number
    rate: Number
    energy: Number


@compilable
def in_si(units: Units, at: Any) -> tuple[Number, Number, Number, Number]:
    """Return (x1, v1, x2, v2) in m and m/s of a reduced state."""
    speed = units.length * units.rate
    return units.length * at.X, speed * at.V1, units.length * (at.X - at.Z), speed * at.V2


class Begun(NamedTuple):
    """How a scene begins: reduced parameters, first motion, velocities, horizon, units, whether all is known."""

    at: Parameters
    start: Start
    V1: Number
    V2: Number
    horizon: Number
    units: Units
    known: bool


@compilable
def _sign_of_pair(x: Pair) -> int:
    return 1 if x.high > 0.0 else (-1 if x.high < 0.0 else 0)


@by_type(None, _sign_of_pair)
def wide_sign(x: Wide) -> int:
    """Return the sign of a wide number."""
    return _sign_of_pair(x) if type(x) is Pair else (x > 0) - (x < 0)


@compilable
def _sure_in_pairs(difference: Pair, size: Pair) -> bool:
    return abs(difference.high) > _SURE * abs(size.high)


@by_type(None, _sure_in_pairs)
def sure(difference: Wide, size: Wide) -> bool:
    """Return whether the sign of a difference of terms of this size, and 17 digits of it, are right."""
    return type(difference) is not Pair or _sure_in_pairs(difference, size)


@compilable
def units_of(si: SI, narrow: Narrow) -> Units:
    """Return the units of a pair."""
    edge, stiff = (si.m1 + si.m2) * si.b, si.a2 * si.m2
    rate = sqrt(narrow(si.a2 / (si.m1 + si.m2)))
    return Units(narrow(edge / stiff), rate, narrow(edge * edge / (2 * (stiff * si.m2))))


@compilable
def parameters_of(si: SI, literal: bool, narrow: Narrow) -> Parameters:
    """Return the reduced parameters of a pair."""
    mass = si.m1 + si.m2
    q = narrow(si.m1 / mass)
    return Parameters(q, narrow(si.m2 / mass), sqrt(q), literal)


@compilable
def first_mode(si: SI, literal: bool) -> tuple[int, bool]:
    """Return the sign of v1 - v2 in the first mode (linear/modes.py), and whether it is known."""
    edge, pull = (si.m1 + si.m2) * si.b, si.a2 * si.x1 * si.m2  # the load is X = pull/edge
    side = 1 if wide_sign(pull) >= 0 else -1
    slips = wide_sign(si.v1 - si.v2)
    if slips != 0 or literal:
        return slips, True
    beyond = side * pull - edge
    known = sure(beyond, edge)
    # on the edge the pair leaves by the side to which it moves
    leaves = wide_sign(beyond) > 0 or (wide_sign(beyond) == 0 and side * wide_sign(si.v1) > 0)
    return (-side if leaves else 0), known


@compilable
def begin(si: SI, literal: bool, narrow: Narrow) -> Begun:
    """Return how a scene with a1 = 0 begins."""
    edge, stiff = (si.m1 + si.m2) * si.b, si.a2 * si.m2
    at, units = parameters_of(si, literal, narrow), units_of(si, narrow)
    X, Z = narrow(stiff * si.x1 / edge), narrow((si.x1 - si.x2) * stiff / edge)
    V1, V2 = narrow(stiff * si.v1 / edge) / units.rate, narrow(stiff * si.v2 / edge) / units.rate
    twice_energy = si.x1 * si.x1 * si.a2 + (si.v1 * si.v1 * si.m1 + si.v2 * si.v2 * si.m2)
    critical = edge * edge
    excess = twice_energy * (stiff * si.m2) - critical  # over the critical energy: w
    w, horizon, zero = narrow(excess / critical), units.rate * narrow(si.until), like(X, 0.0)
    mode, known = first_mode(si, literal)
    known = known and sure(excess, critical)
    if mode == 0:
        near = 1 if wide_sign(si.x1) >= 0 else -1
        offset = narrow((near * (stiff * si.x1) - edge) / edge)
        start = Start(STICK, float(near), X, zero, offset, V1, zero, True, Z, w, zero, zero, zero)
        return Begun(at, start, V1, V2, horizon, units, known)
    gap = (-mode * (stiff * si.x1) - edge) / (si.b * si.m1)  # how far beyond the edge, over q
    beyond = gap * (2 + gap)
    turning = beyond + si.v1 * si.v1 * (stiff * si.m2) / (si.b * si.b * si.m1)
    guard = narrow(mode * ((si.v1 - si.v2) * stiff) / edge) / units.rate / at.sqrt_q
    on_surface = wide_sign(si.v1 - si.v2) == 0
    known = known and (on_surface or sure(turning, abs(beyond) + turning))
    side = float(-mode)
    push = signed(side, V1) / at.sqrt_q
    driven = push + guard if on_surface else signed(side, V2) / at.sqrt_q
    kind = SURFACE if on_surface else FREE
    start = Start(kind, side, X, guard, narrow(gap), push, driven, wide_sign(turning) > 0, Z, w, zero, zero, zero)
    return Begun(at, start, V1, V2, horizon, units, known)
