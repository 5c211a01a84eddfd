"""From SI numbers in binary64 to the start of a viscous run, in double-double where a sign or a difference needs it.

It converts as Frame and start.py do on exact rationals, and gives their bits; where 106 bits do not decide a sign, or
leave fewer than 17 digits of a difference, it says so and the caller converts exactly.
"""

from __future__ import annotations

import math
from typing import Any

from numerics.kernel.compilation import kernel
from numerics.kernel.double_double import Double, add, negative, product, quotient, times, two_product, two_sum
from numerics.kernel.packed import EVENTS, HORIZON, HOW
from numerics.kernel.viscous_bounds import initial_errors
from numerics.kernel.viscous_packed import pack, viscous_pair
from numerics.kernel.viscous_state import Start

_SURE = 2.0**-46
"""A difference smaller than this, relative to its terms, is left to exact arithmetic: 60 bits of 106 remain above."""
_LARGEST, _SMALLEST = 1e70, 1e-70


@kernel
def sure(difference: Double, size: float) -> bool:
    """Return whether the sign of a difference of terms of this size, and 17 digits of it, are right."""
    return abs(difference.high) > _SURE * size


@kernel
def in_range(si: Any) -> bool:
    """Return whether no product of four of these numbers leaves the range of binary64."""
    fits = True
    for number in si:
        fits = fits and (number == 0.0 or _SMALLEST < abs(number) < _LARGEST)
    return fits


@kernel
def prepare(si: Any, literal: bool, state: Any) -> bool:
    """Write the packed start of a run; return False where the scene must be converted exactly.

    si = (m1, m2, a2, b, x1, v1, x2, v2, until, a1), state as in viscous_packed.py.
    """
    if not (in_range(si) and si[9] > 0.0):
        return False
    m1, m2, a2, b, x1, v1, x2, v2, until, a1 = si[0], si[1], si[2], si[3], si[4], si[5], si[6], si[7], si[8], si[9]
    mass, stiff = two_sum(m1, m2), two_product(a2, m2)
    width_above = times(mass, b)  # L = b M/(a2 m2)
    q, r = quotient(Double(m1, 0.0), mass), quotient(Double(m2, 0.0), mass)
    rate = math.sqrt(quotient(Double(a2, 0.0), mass))
    X, Z = quotient(times(stiff, x1), width_above), quotient(product(two_sum(x1, -x2), stiff), width_above)
    V1 = quotient(times(stiff, v1), width_above) / rate
    V2 = quotient(times(stiff, v2), width_above) / rate
    # both damping regimes
    square, four = two_product(a1, a1), times(mass, 4.0 * a2)
    stick_gap = add(four, negative(square))
    slip_gap = add(two_product(m1, 4.0 * a2), negative(square))
    size = four.high + square.high
    if not (sure(stick_gap, size) and sure(slip_gap, 4.0 * a2 * m1 + square.high)):
        return False
    two_zeta = math.sqrt(quotient(square, times(mass, a2)))
    stick_frequency = math.sqrt(abs(quotient(stick_gap, four)))
    slip_frequency = math.sqrt(abs(quotient(slip_gap, four))) / q
    stick = (1 if stick_gap.high > 0.0 else -1), stick_frequency
    slip = (1 if slip_gap.high > 0.0 else -1), slip_frequency
    # E/E_cr - 1
    kinetic = add(times(two_product(v1, v1), m1), times(two_product(v2, v2), m2))
    energy = product(add(times(two_product(x1, x1), a2), kinetic), product(stiff, Double(m2, 0.0)))
    critical = product(width_above, width_above)
    excess = add(energy, negative(critical))
    if not sure(excess, critical.high):
        return False
    mode, rising, known = first_mode(si, literal)
    if not known:
        return False
    w = quotient(excess, critical)
    start = Start(mode, X, V1, V2, Z, w, rising, False, 0.0, 0.0, 0.0, 0.0)
    pack(state, viscous_pair(q, r, two_zeta, literal, stick, slip), start, initial_errors(q, r, X, V1, V2, Z, w), 0.0)
    state[HORIZON], state[EVENTS], state[HOW] = rate * until, 0.0, 0.0
    return True


@kernel
def first_mode(si: Any, literal: bool) -> tuple[int, bool, bool]:
    """Return the first mode (modes.mode_at_start), whether its guard rises, and whether 106 bits decide this."""
    m1, m2, a2, b, x1, v1, v2, a1 = si[0], si[1], si[2], si[3], si[4], si[5], si[7], si[9]
    spring, damper = two_product(a2, x1), two_product(a1, v1)
    pull, edge = times(add(spring, damper), m2), times(two_sum(m1, m2), b)  # P = pull/edge
    size = m2 * (abs(spring.high) + abs(damper.high)) + edge.high
    side = 1 if pull.high > 0.0 else -1
    if v1 != v2:
        mode = 1 if v1 > v2 else -1
    else:
        outside = add(times(pull, float(side)), negative(edge))
        if not (literal or sure(outside, size)):
            return 0, False, False
        mode = 0 if literal or outside.high < 0.0 else -side
    slope = add(times(pull, -float(mode)), negative(edge))
    # dP/dt = 0 at the start: only exact arithmetic can tell
    moved = Double(m1, 0.0) if mode != 0 else two_sum(m1, m2)
    forces = add(add(spring, damper), Double(mode * b, 0.0))
    left, right = product(two_product(a2, v1), moved), times(forces, a1)
    turns = add(left, negative(right))
    largest = abs(left.high) + a1 * (abs(spring.high) + abs(damper.high) + b)
    known = sure(turns, largest) and (mode == 0 or sure(slope, size))
    return mode, mode != 0 and slope.high > 0.0, known


@kernel
def prepare_all(si: Any, literal: bool, states: Any) -> None:
    """Prepare every row; one that must be converted exactly gets -1 as its ending."""
    for index in range(len(si)):
        if not prepare(si[index], literal, states[index]):
            states[index, HOW] = -1.0
