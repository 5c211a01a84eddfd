"""For how long a slip cannot end whatever its fast oscillations do: their amplitude is below the guard's slow part."""

from __future__ import annotations

import math

from numerics.arithmetic.float64 import rough, sine_cosine
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text, text_apart
from numerics.flows.forced import polynomial_at
from numerics.flows.forced_jet import state_at
from numerics.flows.forced_records import HEAD, SINE, Drive, Jet, Pair, Start

_SLOW, _MARGIN = 0.25, 1e-12


@text
def stays(jet: Jet, h: float) -> bool:
    """Return whether the guard is proved to be positive for the next h seconds."""
    end = jet.value + h * (jet.slope + h * jet.bend / 2.0)
    low = min(jet.value, end)
    if jet.slope < 0.0 and jet.bend > 0.0 and -jet.slope < jet.bend * h:
        low = min(low, jet.value - jet.slope * (jet.slope / (2.0 * jet.bend)))
    terms = abs(jet.value) + h * (abs(jet.slope) + h * abs(jet.bend))
    return low - (jet.bound + h * jet.growth) * h * h * h / 6.0 > _MARGIN * terms


@text
def fastest_of(pair: Pair, drive: Drive, piece: int) -> float:
    """Return the fastest rate in the guard of a slip, 1/s."""
    first, count = drive.places[piece][0], drive.places[piece][1]
    fastest, at = pair.slip.rate, first + HEAD + 3 * count
    for _ in range(drive.places[piece][2]):
        fastest = max(fastest, rough(drive.numbers[at + 1]))
        at += SINE
    return fastest


@text_apart
def apart(pair: Pair, drive: Drive, start: Start, tau: Number, left: float, fastest: float) -> float:
    """Return for how long from tau on a slip is proved to go on, at most `left`; 0 if that is no gain.

    s (v1 - v2) is a line (of the particular polynomial, up to t^2, and of body 2), the steady answers to slow sines,
    and oscillations about both: those to fast sines, and the free motion, of which a2/m y^2 + y'^2 never grows.
    """
    slow = slow_guard(pair, drive, start, tau, _SLOW * fastest)
    h = left
    for _ in range(60):
        if fastest * h <= 1.0 or slow.value <= 0.0:
            return 0.0
        if stays(slow, h):
            return h
        h = h / 2.0
    return 0.0


@text
def slow_guard(pair: Pair, drive: Drive, start: Start, tau: Number, limit: float) -> Jet:
    """Return the slow part of a slip's guard, less the amplitude of all that is fast; a value < 0 proves nothing.

    Slow is what has a rate below `limit`: sines, and the free motion y'' = -(a2 y + a1 y')/m1.
    """
    numbers, first = drive.numbers, drive.places[start.piece][0]
    count, sines = drive.places[start.piece][1], drive.places[start.piece][2]
    here, local, side = state_at(pair, drive, start, tau), start.local + tau, float(start.mode)
    a1, a2, rate = rough(pair.a1), rough(pair.a2), math.sqrt(rough(pair.a2 / pair.m1))
    b = numbers[first + 2]
    x, v = polynomial_at(numbers, first + HEAD + count, count, local)
    slope = side * 2.0 * rough(numbers[first + HEAD + count + 2]) if count == 3 else 0.0
    value, slope = rough(start.mode * (v - start.v2) - b / pair.m2 * tau), slope - rough(b / pair.m2)
    y, z = rough(here.x - x + start.mode * b / pair.a2), rough(here.v - v)
    size, fast, bend, bound = abs(y) * rate + abs(z) + abs(value), 0.0, 0.0, 0.0
    at, known = first + HEAD + 3 * count, count <= 3
    for _ in range(sines):
        omega, stiff = rough(numbers[at + 1]), rough(numbers[at + 4])
        square = stiff * stiff + a1 * omega * (a1 * omega)
        known = known and square > 1e-12 * a2 * a2
        scale = rough(numbers[at]) / square if known else 0.0
        in_phase, behind = stiff * scale, a1 * omega * scale
        sine, cosine = sine_cosine(numbers[at + 2] + numbers[at + 1] * local)
        one = in_phase * rough(sine) - behind * rough(cosine)
        two = omega * (in_phase * rough(cosine) + behind * rough(sine))
        y, z, peak = y - one, z - two, omega * math.hypot(in_phase, behind)
        size += (abs(in_phase) + abs(behind)) * (omega + rate)
        if omega < limit:
            value, slope, bend = (
                value + side * two,
                slope - side * omega * omega * one,
                bend - side * omega * omega * two,
            )
            bound += peak * omega**3
        else:
            fast += peak
        at += SINE
    free = math.sqrt(rate * y * (rate * y) + z * z)
    if pair.slip.rate < limit:
        two = -(a2 * y + a1 * z) / rough(pair.m1)
        value, slope = value + side * z, slope + side * two
        bend, bound = bend - side * (a2 * z + a1 * two) / rough(pair.m1), bound + 2.0 * pair.slip.rate**3 * free
    else:
        fast += free
    fast += rough(pair.guard_norm * start.norm) + 1e-9 * size
    return Jet(value - fast if known else -1.0, slope, bend, bound, 0.0, 0.0)
