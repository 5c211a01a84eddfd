"""How a run starts: from SI numbers to reduced ones (frame.py), every sign decided before anything is rounded.

The SI numbers are wide: exact rationals, or double-double in compiled code. What a run needs of them is formed wide and
narrowed once. As these texts stand they narrow double-double to binary64 and say where 106 bits do not decide a sign or
leave too few digits of a difference (`known` is False: convert exactly); told exactly they narrow rationals to any
arithmetic, and everything is known.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.float64 import ZERO, exactly, signed, sqrt
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text
from numerics.flows.oscillator import oscillator
from numerics.motion import damped, undamped
from numerics.motion.codes import FREE, STICK, SURFACE

Wide = Any
"""Fraction, DualNumber over Fractions, or Double."""
_SURE = 2.0**-46
"""A difference smaller than this, relative to its terms, is left to exact arithmetic: 60 bits of 106 remain above."""


class SI(NamedTuple):
    """Parameters, initial state and horizon in SI units, wide."""

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


class Reduced(NamedTuple):
    """What every start needs: shares of the mass, coordinates, and whether they are known to be right."""

    q: Number
    r: Number
    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number
    horizon: Number
    units: Units
    known: bool


@text
def narrow(x: Wide) -> Number:
    """Return a wide number, rounded: here double-double to binary64."""
    return x.high


@text
def wide_sign(x: Wide) -> int:
    """Return the sign of a wide number."""
    return 1 if x.high > 0.0 else (-1 if x.high < 0.0 else 0)


@text
def sure(difference: Wide, size: Wide) -> bool:
    """Return whether the sign of a difference of terms of this size, and 17 digits of it, are right."""
    return abs(difference.high) > _SURE * abs(size.high)


@text
def magnitude(x: Wide) -> Wide:
    """Return |x|."""
    return x if wide_sign(x) >= 0 else -x


@text
def edge_of(si: SI) -> tuple[Wide, Wide]:
    """Return b M and a2 m2, whose quotient is the half width L of the sliding region."""
    return (si.m1 + si.m2) * si.b, si.a2 * si.m2


@text
def reduced(si: SI) -> Reduced:
    """Return the reduced numbers of a scene."""
    mass, (edge, stiff) = si.m1 + si.m2, edge_of(si)
    rate = sqrt(narrow(si.a2 / mass))
    twice_energy = si.x1 * si.x1 * si.a2 + (si.v1 * si.v1 * si.m1 + si.v2 * si.v2 * si.m2)
    critical = edge * edge
    excess = twice_energy * (stiff * si.m2) - critical  # over the critical energy: w
    return Reduced(
        narrow(si.m1 / mass),
        narrow(si.m2 / mass),
        narrow(stiff * si.x1 / edge),
        narrow(stiff * si.v1 / edge) / rate,
        narrow(stiff * si.v2 / edge) / rate,
        narrow((si.x1 - si.x2) * stiff / edge),
        narrow(excess / critical),
        rate * narrow(si.until),
        Units(narrow(edge / stiff), rate, narrow(critical / (2 * (stiff * si.m2)))),
        sure(excess, critical),
    )


@text
def first_mode(si: SI, literal: bool) -> tuple[int, int, bool]:
    """Return the first mode (modes.py), the side of the load on the interface, and whether both are known."""
    edge, _ = edge_of(si)
    pull = (si.a2 * si.x1 + si.a1 * si.v1) * si.m2  # the load is P = pull/edge
    side = 1 if wide_sign(pull) >= 0 else -1
    slips = wide_sign(si.v1 - si.v2)
    if slips != 0:
        return slips, side, True
    beyond = side * pull - edge
    known = literal or sure(beyond, edge)
    if literal or wide_sign(beyond) < 0:
        return 0, side, known
    # on the edge the sign of dP/dt along the stick flow decides: P' has that of M v1 - a1 L P
    leaving = side * ((si.m1 + si.m2) * si.v1 * (si.a2 * si.m2) - si.a1 * pull)
    return (-side if wide_sign(beyond) > 0 or wide_sign(leaving) > 0 else 0), side, known


@text
def undamped_start(si: SI, literal: bool) -> tuple[undamped.Pair, undamped.Start, Reduced, bool]:
    """Return the pair, the first motion, the reduced numbers, and whether all is known, for a1 = 0."""
    at, (edge, stiff) = reduced(si), edge_of(si)
    mode, side, known = first_mode(si, literal)
    sqrt_q = sqrt(at.q)
    pair = undamped.Pair(at.q, at.r, sqrt_q, damping_ratio(si), literal)
    if mode == 0:
        offset = narrow((side * (stiff * si.x1) - edge) / edge)
        start = undamped.Start(STICK, float(side), at.X, ZERO, offset, at.V1, ZERO, True, at.Z, at.w, ZERO, ZERO, ZERO)
        return pair, start, at, known and at.known
    gap = (-mode * (stiff * si.x1) - edge) / (si.b * si.m1)  # how far beyond the edge, over q
    turning = gap * (2 + gap) + si.v1 * si.v1 * (stiff * si.m2) / (si.b * si.b * si.m1)
    guard = narrow(mode * ((si.v1 - si.v2) * stiff) / edge) / at.units.rate / sqrt_q
    on_surface = wide_sign(si.v1 - si.v2) == 0
    known = known and (on_surface or sure(turning, magnitude(gap * (2 + gap)) + turning))
    edge_side = -float(mode)
    push = signed(edge_side, at.V1) / sqrt_q
    driven = push + guard if on_surface else signed(edge_side, at.V2) / sqrt_q
    turns, kind = wide_sign(turning) > 0, SURFACE if on_surface else FREE
    start = undamped.Start(kind, edge_side, at.X, guard, narrow(gap), push, driven, turns, at.Z, at.w, ZERO, ZERO, ZERO)
    return pair, start, at, known and at.known


@text
def damping_ratio(si: SI) -> Number:
    """Return 2 zeta = a1/(M Omega); at a1 = 0 not by its square, which has no derivative there."""
    mass = si.m1 + si.m2
    if wide_sign(si.a1) == 0:
        return narrow(si.a1 / mass) / sqrt(narrow(si.a2 / mass))
    return sqrt(narrow(si.a1 * si.a1 / (si.a2 * mass)))


@text
def damped_pair(si: SI, at: Reduced, literal: bool) -> tuple[damped.Pair, bool]:
    """Return the pair for a1 > 0, and whether both damping regimes are known."""
    two_zeta, square, whole = damping_ratio(si), si.a1 * si.a1, 4 * (si.a2 * (si.m1 + si.m2))
    in_stick, in_slip = whole - square, 4 * (si.a2 * si.m1) - square  # over 4 a2 M: 1 - zeta^2 and q - zeta^2
    stick_frequency = sqrt(narrow(magnitude(in_stick) / whole))
    slip_frequency = sqrt(narrow(magnitude(in_slip) / whole)) / at.q
    stick = oscillator(two_zeta / 2, exactly(1.0), wide_sign(in_stick), stick_frequency)
    slip = oscillator(two_zeta / 2 / at.q, 1 / at.q, wide_sign(in_slip), slip_frequency)
    known = sure(in_stick, whole + square) and sure(in_slip, 4 * (si.a2 * si.m1) + square)
    return damped.Pair(at.q, at.r, two_zeta, literal, stick, slip), known


@text
def damped_start(si: SI, literal: bool) -> tuple[damped.Pair, damped.Start, Reduced, bool]:
    """Return the pair, the first motion, the reduced numbers, and whether all is known, for a1 > 0.

    With P the load, the guard f of a slip of sign s has q f' = -(s P + 1); where that vanishes f'' has the sign of
    -(a1 L/M + s v1); where that vanishes too, it falls. Where dP/dt = 0 exactly at the start, f'' = 0 in a slip, and in
    stick P is at its extremum (`level`).
    """
    at, (edge, stiff) = reduced(si), edge_of(si)
    pair, regimes_known = damped_pair(si, at, literal)
    mode, _, known = first_mode(si, literal)
    forces = si.a2 * si.x1 + si.a1 * si.v1
    slope, curvature = -(mode * (forces * si.m2) + edge), -(si.a1 * si.b + mode * (stiff * si.v1))
    rising = mode != 0 and (wide_sign(slope) > 0 or (wide_sign(slope) == 0 and wide_sign(curvature) > 0))
    moved = si.m1 if mode != 0 else si.m1 + si.m2
    pulled, held = si.a2 * si.v1 * moved, si.a1 * (forces + mode * si.b)
    known = known and sure(pulled - held, magnitude(pulled) + magnitude(held)) and (mode == 0 or sure(slope, edge))
    level = wide_sign(pulled - held) == 0
    start = damped.Start(mode, at.X, at.V1, at.V2, at.Z, at.w, rising, level, ZERO, ZERO, ZERO, ZERO)
    return pair, start, at, known and regimes_known and at.known
