"""When stick cannot end before its piece does: the steady load and what is left of the free one stay below b."""

from __future__ import annotations

import math

from numerics.arithmetic.float64 import rough, sine_cosine
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text_apart
from numerics.flows.forced_jet import push_at, state_at
from numerics.flows.forced_records import HEAD, SINE, Drive, Pair, Start

_BELOW = 1.0 - 1e-9


@text_apart
def calm(pair: Pair, drive: Drive, start: Start, tau: Number) -> bool:
    """Return whether |Lambda| < b is proved up to the end of the piece, however late that is.

    Lambda/m2 = x'' is the steady state's, at most the sum of its amplitudes, and that of a free motion y, of which
    y^2 + (m/a2) y'^2 never grows. Only for polynomials up to t^2, whose part of x'' is constant, away from resonance.
    """
    numbers, first = drive.numbers, drive.places[start.piece][0]
    count, sines = drive.places[start.piece][1], drive.places[start.piece][2]
    if count > 3:
        return False
    here, local, m = state_at(pair, drive, start, tau), start.local + tau, rough(pair.mass)
    push = push_at(drive, start.piece, local)
    a1, a2 = rough(pair.a1), rough(pair.a2)
    x2 = (push.u0 - pair.a2 * here.x - pair.a1 * here.v) / pair.mass
    free = rough(x2)
    free_rate = rough((push.u1 - pair.a1 * x2 - pair.a2 * here.v) / pair.mass)
    steady = 2.0 * rough(numbers[first + HEAD + 2 * count + 2]) if count == 3 else 0.0
    free, steady, rounding = free - steady, abs(steady), abs(free) + abs(steady)
    at = first + HEAD + 3 * count
    for _ in range(sines):
        omega, stiff = rough(numbers[at + 1]), rough(numbers[at + 6])
        square = stiff * stiff + a1 * omega * (a1 * omega)
        if not square > 1e-12 * a2 * a2:
            return False
        scale = rough(numbers[at]) * omega * omega / square
        in_phase, behind = stiff * scale, a1 * omega * scale
        sine, cosine = sine_cosine(numbers[at + 2] + numbers[at + 1] * local)
        sine_rough, cosine_rough = rough(sine), rough(cosine)
        free += in_phase * sine_rough - behind * cosine_rough
        free_rate += omega * (in_phase * cosine_rough + behind * sine_rough)
        steady += math.hypot(in_phase, behind)
        rounding += (abs(in_phase) + abs(behind)) * (1.0 + omega * math.sqrt(m / a2))
        at += SINE
    most = steady + math.sqrt(free * free + m / a2 * free_rate * free_rate) + 1e-13 * rounding
    error = rough(pair.load_norm * start.norm)
    return rough(pair.m2) * most + error < _BELOW * rough(numbers[first + 2])
