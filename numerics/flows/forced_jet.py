"""The guard of a mode under a force, with two derivatives and a proved bound on the third: what isolates its roots.

Slip of sign s: g = s (v1 - v2). Stick: g = b - s Lambda for both sides s, with the load Lambda = m2 x1''. The
derivatives of x1 follow from m x'' + a1 x' + a2 x = u + push, differentiated; the k-th obeys the same equation, so
sqrt(a2/m x^(k)^2 + x^(k+1)^2) grows by int |u^(k)|/m at most: a bound that knows damping and resonance.
"""

from __future__ import annotations

import math

from numerics.arithmetic.float64 import UNIT, rough, sine_cosine, spread
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text, text_apart
from numerics.flows.forced import coefficient_at, moved
from numerics.flows.forced_records import HEAD, PHASES, ROUNDINGS, SINE, Drive, Jet, Moved, Pair, Push, Start


@text_apart
def push_at(drive: Drive, piece: int, local: Number) -> Push:
    """Return the force at a time in a piece."""
    numbers, first = drive.numbers, drive.places[piece][0]
    count, sines = drive.places[piece][1], drive.places[piece][2]
    low, length = first + HEAD, rough(numbers[first + 1])
    u0, u1 = coefficient_at(numbers, low, count, 0, local), coefficient_at(numbers, low, count, 1, local)
    u2, u3 = 2 * coefficient_at(numbers, low, count, 2, local), 6 * coefficient_at(numbers, low, count, 3, local)
    height, third, fourth = 0.0, 0.0, 0.0
    for n in range(count):
        term = abs(rough(numbers[low + n]))
        height += term * rough(local) ** n * (1.0 + n / 8.0)  # Horner's scheme rounds twice for each power
        if n > 2:
            third += term * n * (n - 1) * (n - 2) * length ** (n - 3)
        if n > 3:
            fourth += term * n * (n - 1) * (n - 2) * (n - 3) * length ** (n - 4)
    at = low + 3 * count
    for _ in range(sines):
        amplitude, omega = numbers[at], numbers[at + 1]
        sine, cosine = sine_cosine(numbers[at + 2] + omega * local)
        rate, peak = rough(omega), abs(rough(amplitude))
        push, next_push = amplitude * sine, amplitude * omega * cosine
        u0, u1 = u0 + push, u1 + next_push
        u2, u3 = u2 - omega * omega * push, u3 - omega * omega * next_push
        off = (abs(rough(numbers[at + 2])) + rate * rough(local)) / PHASES
        height += abs(rough(push)) + abs(rough(amplitude * cosine)) * off
        third, fourth = third + peak * rate**3, fourth + peak * rate**4
        at += SINE
    return Push(u0, u1, u2, u3, height, third, fourth)


@text
def state_at(pair: Pair, drive: Drive, start: Start, tau: Number) -> Moved:
    """Return x1 and v1 at tau after the start of a mode."""
    swing = pair.stick if start.mode == 0 else pair.slip
    return moved(swing, drive, start.piece, start.mode, start.x1, start.v1, start.local, tau)


@text
def load_at(pair: Pair, drive: Drive, piece: int, local: Number, x: Number, v: Number) -> Number:
    """Return Lambda = m2 (u - a2 x1 - a1 v1)/M."""
    u = push_at(drive, piece, local).u0
    return pair.m2 * ((u - pair.a2 * x - pair.a1 * v) / pair.mass)


@text
def load_error(pair: Pair, height: float, here: Moved) -> float:
    """Return the rounding of the load."""
    size = height + rough(pair.a2) * here.x_size + rough(pair.a1) * here.v_size
    return ROUNDINGS * UNIT * size * rough(pair.m2) / rough(pair.mass)


@text_apart
def guard_at(pair: Pair, drive: Drive, start: Start, side: int, tau: Number) -> tuple[Number, Number, float]:
    """Return the guard at tau, its slope, and its rounding: of a slip, or of the side of stick."""
    here = state_at(pair, drive, start, tau)
    local = start.local + tau
    push, b = push_at(drive, start.piece, local), drive.numbers[drive.places[start.piece][0] + 2]
    pull = push.u0 - pair.a2 * here.x - pair.a1 * here.v
    if start.mode != 0:
        brake = b / pair.m2
        value = start.mode * (here.v - start.v2) - brake * tau
        slope = start.mode * ((pull - start.mode * b) / pair.m1) - brake
        size = here.v_size + abs(rough(start.v2)) + abs(rough(brake * tau))
        return value, slope, ROUNDINGS * UNIT * size
    x2 = pull / pair.mass
    x3 = (push.u1 - pair.a1 * x2 - pair.a2 * here.v) / pair.mass
    return b - side * (pair.m2 * x2), -side * (pair.m2 * x3), load_error(pair, push.height, here) + UNIT * rough(b)


@text_apart
def slip_jet(pair: Pair, drive: Drive, start: Start, tau: Number) -> Jet:
    """Return the guard s (v1 - v2) of a slip."""
    here, m = state_at(pair, drive, start, tau), pair.m1
    push, b = push_at(drive, start.piece, start.local + tau), drive.numbers[drive.places[start.piece][0] + 2]
    x2 = (push.u0 - start.mode * b - pair.a2 * here.x - pair.a1 * here.v) / m
    x3 = (push.u1 - pair.a1 * x2 - pair.a2 * here.v) / m
    x4 = (push.u2 - pair.a1 * x3 - pair.a2 * x2) / m
    brake = b / pair.m2
    value = start.mode * (here.v - start.v2) - brake * tau
    size = here.v_size + abs(rough(start.v2)) + abs(rough(brake * tau))
    error = ROUNDINGS * UNIT * size + rough(spread(value)) + rough(pair.guard_norm * start.norm)
    bound = largest(pair, m, rough(x3), rough(x4))
    slope, bend = rough(start.mode * x2 - brake), rough(start.mode * x3)
    return Jet(rough(value) - error, slope, bend, bound, push.third / rough(m), error)


@text
def largest(pair: Pair, mass: Number, one: float, two: float) -> float:
    """Return the bound on |x^(k+1)| of a motion that goes on with x^(k) = one and x^(k+1) = two."""
    return 1.0001 * math.sqrt(rough(pair.a2) / rough(mass) * one * one + two * two)


@text_apart
def stick_jets(pair: Pair, drive: Drive, start: Start, tau: Number) -> tuple[Jet, Jet]:
    """Return the guards b - Lambda and b + Lambda of stick."""
    here, m = state_at(pair, drive, start, tau), pair.mass
    push, b = push_at(drive, start.piece, start.local + tau), drive.numbers[drive.places[start.piece][0] + 2]
    x2 = (push.u0 - pair.a2 * here.x - pair.a1 * here.v) / m
    x3 = (push.u1 - pair.a1 * x2 - pair.a2 * here.v) / m
    x4 = (push.u2 - pair.a1 * x3 - pair.a2 * x2) / m
    x5 = (push.u3 - pair.a1 * x4 - pair.a2 * x3) / m
    load, m2 = pair.m2 * x2, rough(pair.m2)
    error = load_error(pair, push.height, here) + UNIT * rough(b)
    error += rough(spread(load)) + rough(pair.load_norm * start.norm)
    bound, growth = m2 * largest(pair, m, rough(x4), rough(x5)), m2 * push.fourth / rough(m)
    slope, bend = m2 * rough(x3), m2 * rough(x4)
    return (
        Jet(rough(b - load) - error, -slope, -bend, bound, growth, error),
        Jet(rough(b + load) - error, slope, bend, bound, growth, error),
    )
