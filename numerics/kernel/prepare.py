"""From SI numbers in binary64 to the start of a run, in double-double where the difference of large numbers counts.

It converts as Frame and start.py do on exact rationals, and gives their bits; where 106 bits do not decide a sign, or
leave fewer than 17 digits of a difference, it says so and the caller converts exactly.
"""

from __future__ import annotations

import math
from typing import Any

from numerics.kernel.bounds import ULP, Errors, no_linear
from numerics.kernel.compilation import kernel
from numerics.kernel.double_double import Double, add, negative, product, quotient, times, two_product, two_sum
from numerics.kernel.packed import EVENTS, HORIZON, HOW, pack
from numerics.kernel.state import FREE, STICK, SURFACE, Pair, Start

_SURE = 2.0**-46
"""A difference smaller than this, relative to its terms, is left to exact arithmetic: 60 bits of 106 remain above."""
_LARGEST, _SMALLEST = 1e140, 1e-140


@kernel
def prepare(si: Any, literal: bool, state: Any) -> bool:
    """Write the packed start of a run; return False where the scene must be converted exactly.

    si = (m1, m2, a2, b, x1, v1, x2, v2, until), state as in packed.py.
    """
    m1, m2, a2, b, x1, v1, x2, v2, until = si[0], si[1], si[2], si[3], si[4], si[5], si[6], si[7], si[8]
    for number in si:
        if not (number == 0.0 or _SMALLEST < abs(number) < _LARGEST):
            return False
    mass = two_sum(m1, m2)
    stiff = two_product(a2, m2)
    width_above = times(mass, b)  # L = b M/(a2 m2)
    scale = quotient(stiff, width_above)
    if not (_SMALLEST < scale < _LARGEST):
        return False
    q, r = quotient(Double(m1, 0.0), mass), quotient(Double(m2, 0.0), mass)
    sqrt_q, rate = math.sqrt(q), math.sqrt(quotient(Double(a2, 0.0), mass))
    X, Z = quotient(times(stiff, x1), width_above), quotient(product(two_sum(x1, -x2), stiff), width_above)
    V1 = quotient(times(stiff, v1), width_above) / rate
    V2 = quotient(times(stiff, v2), width_above) / rate
    # E/E_cr - 1
    kinetic = add(times(two_product(v1, v1), m1), times(two_product(v2, v2), m2))
    energy = product(add(times(two_product(x1, x1), a2), kinetic), product(stiff, Double(m2, 0.0)))
    critical = product(width_above, width_above)
    excess = add(energy, negative(critical))
    w = quotient(excess, critical)
    if not abs(excess.high) > _SURE * critical.high:
        return False
    # how far x1 lies beyond the edge, over L; its sign decides where the pair may stick
    edge = -1.0 if x1 < 0.0 else 1.0
    beyond = add(times(stiff, abs(x1)), negative(width_above))
    if not abs(beyond.high) > _SURE * width_above.high:
        return False
    norm = 4 * ULP * (abs(X) + sqrt_q * abs(V1) + math.sqrt(r) * abs(V2))
    horizon = rate * until
    if v1 == v2 and (literal or beyond.high < 0.0):
        offset = quotient(beyond, width_above)
        start = Start(STICK, edge, X, 0.0, offset, V1, 0.0, True, Z, w, 0.0, 0.0, 0.0)
    else:
        sign = (1.0 if v1 > v2 else -1.0) if v1 != v2 else -edge
        side = -sign
        below = beyond if side == edge else add(times(stiff, side * x1), negative(width_above))
        gap = quotient(below, two_product(b, m1))  # (side X - 1)/q
        u = side * V1 / sqrt_q
        # the guard turns if gap (2 + gap) + u^2 > 0
        turning = gap * (2.0 + gap) + u * u
        if v1 != v2 and not abs(turning) > 1e-12 * (abs(gap * (2.0 + gap)) + u * u):
            return False
        relative = quotient(product(two_sum(sign * v1, -sign * v2), stiff), width_above) / rate
        kind = SURFACE if v1 == v2 else FREE
        driven = u if kind == SURFACE else side * V2 / sqrt_q
        start = Start(kind, side, X, relative / sqrt_q, gap, u, driven, turning > 0.0, Z, w, 0.0, 0.0, 0.0)
    errors = Errors(
        0.0, 2 * ULP * abs(start.gap), 4 * ULP * abs(start.push), 2 * ULP * abs(w), 0.0, 2 * ULP * abs(Z), 0.0, norm
    )
    pack(state, Pair(q, r, sqrt_q, literal), start, errors, no_linear(errors), 0.0)
    state[HORIZON], state[EVENTS], state[HOW] = horizon, 0.0, 0.0
    return True


@kernel
def prepare_all(si: Any, literal: bool, states: Any) -> None:
    """Prepare every row; one that must be converted exactly gets -1 as its ending."""
    for index in range(len(si)):
        if not prepare(si[index], literal, states[index]):
            states[index, HOW] = -1.0
