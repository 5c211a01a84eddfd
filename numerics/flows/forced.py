"""The motion of body 1 under a force: m x'' + a1 x' + a2 x = u(t) + push, in closed form on one piece of u.

m is m1 in a slip (push = -s b) and m1 + m2 in stick (push = 0). A piece is a run of numbers in a flat table (Drive), so
that one compiled text serves every force. The motion is the free one, plus the answer to the polynomial, plus that from
rest to each sine, each formed so that nothing cancels; short times are told by power series.
"""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.float64 import ZERO, rough, size, widened
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text, text_apart
from numerics.flows.forced_records import HEAD, PHASES, SINE, Drive, Moved, Swing
from numerics.flows.forced_sine import sine_by_series, sine_by_steady_state, sine_near_resonance
from numerics.flows.oscillator import propagate


@text
def polynomial_at(numbers: Any, first: int, count: int, t: Number) -> tuple[Number, Number]:
    """Return value and derivative of a polynomial with these coefficients."""
    value, slope = ZERO, ZERO
    for k in range(count - 1, -1, -1):
        slope = slope * t + value
        value = value * t + numbers[first + k]
    return value, slope


@text
def coefficient_at(numbers: Any, first: int, count: int, k: int, t: Number) -> Number:
    """Return the k-th coefficient of the polynomial in powers of its argument less t: p^(k)(t)/k!."""
    value = ZERO
    for n in range(count - 1, k - 1, -1):
        # Horner's scheme for the k-th derivative over k!
        value = value * t + numbers[first + n] * binomial(n, k)
    return value


@text
def binomial(n: int, k: int) -> int:
    """Return n over k."""
    value = 1
    for i in range(k):
        value = value * (n - i) // (i + 1)
    return value


@text_apart
def moved(swing: Swing, drive: Drive, piece: int, side: int, x: Number, v: Number, local: Number, tau: Number) -> Moved:
    """Return x1 and v1 at tau after (x, v) at `local` seconds into a piece; side -1, +1: slip, 0: stick."""
    numbers, first = drive.numbers, drive.places[piece][0]
    count, sines = drive.places[piece][1], drive.places[piece][2]
    push = -side * numbers[first + 2]
    if swing.rate * rough(tau) <= swing.short:
        found = by_series(swing, numbers, first + HEAD, count, push, x, v, local, tau)
    else:
        found = by_particular(
            swing, numbers, first + HEAD + (count if side != 0 else 2 * count), count, push, x, v, local, tau
        )
    at = first + HEAD + 3 * count
    for _ in range(sines):
        found = with_sine(swing, numbers, at, side == 0, local, tau, found)
        at += SINE
    return found


@text
def by_series(
    swing: Swing, numbers: Any, first: int, count: int, push: Number, x: Number, v: Number, local: Number, tau: Number
) -> Moved:
    """Return the motion under the polynomial and the push by its power series, for rate tau <= 1.

    d_k = x^(k) tau^k/k! is carried whole, so that no unit of time is too large or too small:
    (k+1)(k+2) d_(k+2) = (f_k tau^(k+2) - a1 tau (k+1) d_(k+1) - a2 tau^2 d_k)/m, divided by tau once. Past the
    polynomial's degree max(|x^(k)|, |x^(k+1)|/rate)/rate^k never grows, which bounds the rest.
    """
    a, b, power = x, v, tau  # d_k, d_(k+1)/tau and tau^(k+1)
    position, speed = x + v * tau, v
    x_size, v_size = abs(rough(x)) + abs(rough(v * tau)), abs(rough(v))
    terms, drag, stiff = max(swing.terms, count + 2), swing.a1 * tau, swing.a2 * tau
    for k in range(terms):
        pull = -drag * ((k + 1) * b) - stiff * a
        if k < count:
            pull = pull + coefficient_at(numbers, first, count, k, local) * power
        if k == 0:
            pull = pull + push * tau
        c = (pull / swing.mass) / ((k + 1) * (k + 2))
        term = c * tau
        speed = speed + (k + 2) * c
        position = position + term
        x_size += abs(rough(term))
        v_size += (k + 2) * abs(rough(c))
        a, b, power = b * tau, c, power * tau
    # d_n and d_(n+1), n = terms, times rate tau/(n+1) and 1: what is left of x is (rate tau) times these over n + 2
    rest = size(a) * (swing.rate * tau) / (terms + 1) + size(b * tau)
    x_rest = 4 * rest * (swing.rate * tau) / (terms + 2)
    return Moved(widened(position, x_rest), widened(speed, 4 * rest * swing.rate), x_size, v_size)


@text
def by_particular(
    swing: Swing, numbers: Any, first: int, count: int, push: Number, x: Number, v: Number, local: Number, tau: Number
) -> Moved:
    """Return the same by the particular polynomial, whose coefficients stand in the table, and the free motion."""
    offset = push / swing.a2
    before, slope_before = polynomial_at(numbers, first, count, local)
    after, slope_after = polynomial_at(numbers, first, count, local + tau)
    y, z = x - (before + offset), v - slope_before
    free, free_speed = propagate(swing.of, y, z, tau)
    x_size = abs(rough(x)) + abs(rough(before)) + abs(rough(after)) + abs(rough(offset)) + abs(rough(y))
    v_size = abs(rough(v)) + abs(rough(slope_before)) + abs(rough(slope_after)) + abs(rough(z))
    rate = swing.rate
    return Moved(after + offset + free, slope_after + free_speed, x_size + v_size / rate, v_size + x_size * rate)


@text
def with_sine(swing: Swing, numbers: Any, at: int, is_stick: bool, local: Number, tau: Number, found: Moved) -> Moved:
    """Return the motion with the answer from rest to one sine added."""
    amplitude, omega = numbers[at], numbers[at + 1]
    phase = numbers[at + 2] + omega * local
    off = (abs(rough(numbers[at + 2])) + rough(omega * local)) / PHASES
    mode = at + (5 if is_stick else 3)
    total = (swing.rate + rough(omega)) * rough(tau)
    if total <= swing.short:
        one = sine_by_series(swing, amplitude, omega, phase, off, tau)
    elif swing.light and 0.5 < rough(omega) / rough(swing.of.frequency) < 2.0:
        one = sine_near_resonance(swing, amplitude, omega, phase, off, numbers[mode], tau)
    else:
        one = sine_by_steady_state(swing, amplitude, omega, phase, off, numbers[mode + 1], tau)
    return Moved(found.x + one.x, found.v + one.v, found.x_size + one.x_size, found.v_size + one.v_size)
