"""Motions with two stops, or two reversals, a period under U sin(omega t + phase): guesses that orbit.py proves.

The motion repeats with the other sign after half a period h. Counted from an exit to slip +, with a slip of length ts
and u = S sin(omega t) + C cos(omega t), the exit state (x0, v0) and (S, C) solve a linear system:

    C - a1 v0 - a2 x0 = M beta        Lambda = b at the exit
    v1(ts) = v0 + beta ts             w = 0 where the slip ends
    (x1, v1)(h) = -(x0, v0)           after a stick phase from ts on

U(ts) = hypot(S, C) runs from U* at ts = 0 to U** at ts = h; between two values of ts with U on either side lies a
guess.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball
from numerics.control.linear import FIRST, ONE, V1, V2, X1, LinearMode, matrix
from numerics.control.orbit import Drive, Leg, Orbit
from numerics.control.thresholds import reversal_demand, square_wave_response, stiffness
from numerics.scene import Piece, Sine

_SAMPLES, _NEAR_ENDS = 256, 40
"""Slip lengths at which U(ts) is compared with U; powers of 10 from either end of (0, h) besides."""


def two_stop_guesses(drive: Drive) -> Iterator[Orbit]:
    """Yield a two-stop motion for each change of sign of U(ts) - U that shows on a grid, not proved."""
    amplitude, half = Ball.number(drive.piece.sines[0].amplitude), drive.period / 2
    near = [half / 256 * arb(10) ** (-k / 2) for k in range(_NEAR_ENDS, 0, -1)]
    grid = [*near, *(half * k / _SAMPLES for k in range(1, _SAMPLES)), *(half - one for one in reversed(near))]
    excess = [_excess(drive, ts, amplitude) for ts in grid]
    for (low, left), (high, right) in pairwise(zip(grid, excess, strict=True)):
        if left is not None and right is not None and (left > 0) != (right > 0):
            yield _orbit(drive, _bisected(drive, low, high, amplitude, positive_left=bool(left > 0)))


def _excess(drive: Drive, ts: arb, amplitude: arb) -> arb | None:
    try:
        _, _, S, C = exit_state(drive, ts)
    except ZeroDivisionError:
        return None
    excess = S * S + C * C - amplitude * amplitude
    return None if excess.contains(0) else excess


def _bisected(drive: Drive, low: arb, high: arb, amplitude: arb, *, positive_left: bool) -> arb:
    for _ in range(60):
        middle = ((low + high) / 2).mid()
        excess = _excess(drive, middle, amplitude)
        if excess is not None and bool(excess > 0) == positive_left:
            low = middle
        else:
            high = middle
    return high


def exit_state(drive: Drive, ts: arb) -> tuple[arb, arb, arb, arb]:
    """Return (x0, v0, S, C) of the two-stop motion with a slip of length ts (s); raises ZeroDivisionError."""
    pair, sine = drive.pair, drive.piece.sines[0]
    # one sine of amplitude 1 in the place of the force: (C, S) are its two components at the exit
    unit = Piece(0, (), [Sine(1, sine.omega)])
    slip, stick = (matrix(LinearMode(pair, drive.b, side, unit).generator()) for side in (1, 0))
    first = (slip * ts).exp()
    both = (stick * (drive.period / 2 - ts)).exp() * first
    places = (X1, V1, FIRST + 1, FIRST)
    columns = [_moved(first, place) for place in places], [_moved(both, place) for place in places]
    begun = [_moved(first, ONE), _moved(both, ONE)]
    number = Ball.number
    rows = [[number(-pair.a2), number(-pair.a1), arb(0), arb(1)]]
    rows.append([one[V1] - one[V2] for one in columns[0]])
    rows += [[one[place] + int(n == place) for n, one in enumerate(columns[1])] for place in (X1, V1)]
    right = [number(pair.mass * drive.b / pair.m2), begun[0][V2] - begun[0][V1], -begun[1][X1], -begun[1][V1]]
    solved = arb_mat(rows).solve(arb_mat([[one] for one in right])).entries()
    return solved[0], solved[1], solved[2], solved[3]


def _moved(flow: arb_mat, place: int) -> list[arb]:
    """Return where a flow takes the unit vector of a place; a unit of v is one of both bodies."""
    taken = [flow[row, place] for row in range(V2 + 1)]
    return [a + flow[row, V2] for row, a in enumerate(taken)] if place == V1 else taken


def _orbit(drive: Drive, ts: arb) -> Orbit:
    """Return the motion with slips of length ts, in the time of the force."""
    x0, v0, S, C = exit_state(drive, ts)
    unit = LinearMode(drive.pair, drive.b, 1, Piece(0, (), [Sine(1, drive.piece.sines[0].omega)]))
    z = (matrix(unit.generator()) * ts).exp() * arb_mat([[x0], [v0], [0], [v0], [1], [C], [S]])
    begin = _time_of_phase(drive, S, C)
    return _with_mirrored(drive, [Leg(1, begin, x0, v0), Leg(0, begin + ts, z[X1, 0], z[V1, 0])])


def non_stop_guesses(drive: Drive) -> Iterator[Orbit]:
    """Yield the motion that only slips and reverses twice a period, if U is above U**, not proved."""
    pair, sine, number = drive.pair, drive.piece.sines[0], Ball.number
    omega = number(sine.omega)
    velocity, least = reversal_demand(pair, omega)
    stiff = stiffness(pair, pair.m1, sine.omega)
    if stiff.is_zero():
        return
    place, speed = number(sine.amplitude) / stiff, velocity / omega
    rest = place * place - speed * speed
    if not rest > 0 or not omega * omega * rest.sqrt() > least:
        return
    # what the sine alone gives: velocity v and position x where the slip + begins
    x, v = -rest.sqrt(), -velocity
    inertial, damped = number(pair.a2 - pair.m1 * sine.omega**2), number(pair.a1)
    C, S = inertial * x + damped * v, inertial * v / omega - damped * omega * x
    place, _ = square_wave_response(pair, omega)
    b, quarter = number(drive.b), drive.period / 4
    yield _with_mirrored(drive, [Leg(1, _time_of_phase(drive, S, C), x - b * place, -b / number(pair.m2) * quarter)])


def _time_of_phase(drive: Drive, S: arb, C: arb) -> arb:
    """Return the first time t >= 0 at which the force is C, and its derivative omega S."""
    sine = drive.piece.sines[0]
    sign = 1 if sine.amplitude > 0 else -1
    t = (arb.atan2(sign * C, sign * S) - Ball.number(sine.phase)) / Ball.number(sine.omega)
    return t - drive.period * math.floor(float(t / drive.period))


def _with_mirrored(drive: Drive, legs: list[Leg]) -> Orbit:
    """Return half a period of legs and the same with the other sign; a constant force shifts x1."""
    shift = Ball.number(sum(drive.piece.polynomial, Fraction(0)) / drive.pair.a2)
    mirrored = [Leg(-leg.side, leg.t + drive.period / 2, -leg.x, -leg.v) for leg in legs]
    return Orbit(drive, tuple(replace(leg, x=leg.x + shift) for leg in (*legs, *mirrored)))
