"""The first contact of an undamped slip that starts off the switching surface, certified.

k' = A cos(theta - phase) - 1 vanishes at phase +- lean + 2 pi j, so the pieces on which the guard k is monotone are
explicit; its local minima fall by 2 pi from one to the next, so the first one below zero is known without visiting the
others. The root lies on the decreasing piece before it, and is the first. A minimum that is not proved to be above or
below zero is a graze.
"""

from __future__ import annotations

import math

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.functions import as_float, atan2, ceiling, finite, like, resolved, sign, sqrt, two_pi
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import GRAZES, GUARD_TURNS, MINIMUM_BEFORE_START
from numerics.free.root import falling_root
from numerics.free.slip import Variables, guard_and_gap


@compilable
def first_contact(at: Variables, turns: bool) -> tuple[Number, float]:
    """Return the first theta > 0 with k = 0, k(0) > 0, and how far above 0 the lowest minimum before it lies.

    `turns`: the guard has extrema, A^2 = (1 + d)^2 + u^2 > 1, decided on exact rationals where A may be 1.
    nan where a number left the range.
    """
    g, d, u = at
    excess, zero = d * (2 + d) + u * u, like(g, 0.0)  # A^2 - 1
    if not finite(excess):
        return like(g, math.nan), 0.0
    if not turns or sign(excess, GUARD_TURNS) <= 0:
        return falling_root(zero, g + u + 3, guard_and_gap, at), math.inf  # monotone: k <= g + u + A - theta, A <= 1
    turn, height = two_pi(g), sqrt(excess)
    lean, phase = atan2(height, like(g, 1.0)), atan2(u, 1 + d)
    count = (g + u - height + (lean - phase)) / turn  # k at the minimum phase - lean, in full turns
    if not finite(count) or (as_float(count) > 1.0 and not resolved(count)):
        return like(g, math.nan), 0.0
    index, first = ceiling(count, GRAZES), phase - lean
    if index < 1:
        index = 1 if sign(first, MINIMUM_BEFORE_START) <= 0 else 0
    minimum = first + turn * index
    maximum = minimum - turn + 2 * lean
    least = 1 if as_float(first) <= 0.0 else 0
    spared = as_float(turn * (count - (index - 1))) if index > least else math.inf
    return falling_root(zero if as_float(maximum) <= 0.0 else maximum, minimum, guard_and_gap, at), spared
