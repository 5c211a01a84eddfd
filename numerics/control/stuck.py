"""Motions that stick for ever under a constant and sines: the response, its multipliers, and the others for a1 = 0."""

from __future__ import annotations

from fractions import Fraction

from flint import acb, arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import working_digits
from numerics.control.linear import ONE, Row
from numerics.control.modes_proved import is_positive_inside
from numerics.control.orbit import Drive
from numerics.control.thresholds import Thresholds, load_margin, odd_ratio, stiffness
from numerics.errors import EventUndecided


def entrained(drive: Drive) -> bool:
    """Return whether the stuck response exists: |Lambda| <= b along it. Raises EventUndecided."""
    sines = drive.piece.sines
    if len(sines) == 1:
        return load_margin(drive.pair, sines[0].amplitude, sines[0].omega) >= 0
    state = stuck_state(drive, arb(0))
    if state is None:
        return False
    motion = drive.mode(0).motion(state, arb(0))
    rows: list[Row] = []
    for side in (1, -1):
        rows.append((*((place, -side * c) for place, c in motion.mode.load), (ONE, drive.b)))
    if all(is_positive_inside(motion, row, drive.period) for row in rows):
        return True
    steps = 4096
    if any(motion.range(row, drive.period * k / steps) < 0 for row in rows for k in range(steps)):
        return False
    raise EventUndecided("does friction hold the pair in its stuck response?", "load near b", working_digits())


def stuck_state(drive: Drive, t: arb) -> tuple[arb, arb, arb, arb] | None:
    """Return (x1, v1, 0, v1) of the stuck response at a time (s); None at a resonance of the stuck pair, a1 = 0."""
    pair, number = drive.pair, Ball.number
    x, v = number(sum(drive.piece.polynomial, Fraction(0)) / pair.a2), arb(0)
    for one in drive.piece.sines:
        if stiffness(pair, pair.mass, one.omega).is_zero():
            return None
        below = acb(number(pair.a2 - pair.mass * one.omega**2), number(pair.a1 * one.omega))
        turned = acb.exp(acb(0, number(one.omega) * t + number(one.phase)))
        moved = turned * number(one.amplitude) / below
        x, v = x + moved.imag, v + number(one.omega) * moved.real
    return x, v, arb(0), v


def others_stick(drive: Drive, known: Thresholds | None) -> bool:
    """Return whether motions other than the response stick for ever (`Thresholds.exception`). Raises EventUndecided."""
    if known is None or known.exception is None:
        return False
    over = Ball.number(abs(drive.piece.sines[0].amplitude)) - known.exception
    if over.contains(0):
        raise EventUndecided("does a free oscillation let the pair stick?", over.str(6), working_digits())
    return bool(over < 0)


def flattened_state(drive: Drive, t: arb) -> tuple[arb, arb, arb, arb]:
    """Return (x1, v1, 0, v1) of the stuck motion under one sine whose load has the lowest peaks, where others stick.

    The response A sin p, p = omega t + phase, and with Omega = n omega the free A c/n^2 sin(n p), where c =
    -(-1)^((n - 1)/2) sin(pi/(2 n))/n: the acceleration is then cos(pi/(2 n)) of that of the response at most.
    """
    pair, sine, number = drive.pair, drive.piece.sines[0], Ball.number
    odd = odd_ratio(pair.a2 / pair.mass, sine.omega, pair)
    assert odd is not None
    side = 1 if odd % 4 == 3 else -1
    share = side * (arb.pi() / (2 * odd)).sin() / odd
    reach = number(sine.amplitude / (pair.a2 - pair.mass * sine.omega**2))
    angle = number(sine.omega) * t + number(sine.phase)
    x = number(sum(drive.piece.polynomial, Fraction(0)) / pair.a2)
    x += reach * (angle.sin() + share / odd**2 * (odd * angle).sin())
    v = reach * number(sine.omega) * (angle.cos() + share / odd * (odd * angle).cos())
    return x, v, arb(0), v


def stuck_multipliers(drive: Drive) -> tuple[acb, ...]:
    """Return exp(lambda T) of the stuck pair's two rates, and 0: w dies in a finite time."""
    pair, number = drive.pair, Ball.number
    half, squared = pair.a1 / (2 * pair.mass), (pair.a1 / (2 * pair.mass)) ** 2 - pair.a2 / pair.mass
    rest = number(abs(squared)).sqrt()
    rates = [acb(0, rest), acb(0, -rest)] if squared < 0 else [acb(rest), acb(-rest)]
    return (*(acb.exp((one - number(half)) * drive.period) for one in rates), acb(0))
