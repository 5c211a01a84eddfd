"""The first contact of an undamped slip that starts off the switching surface, certified.

k' = A cos(theta - phase) - 1 vanishes at phase +- lean + 2 pi j, so the pieces on which the guard k is monotone are
explicit; its local minima fall by 2 pi from one to the next, so the first one below zero is known without visiting the
others. The root lies on the decreasing piece before it, and is the first. A minimum that is not proved to be above or
below zero is a graze.
"""

from __future__ import annotations

import math

from numerics.arithmetic.double_double import Double, add, less, scaled
from numerics.arithmetic.float64 import (
    ZERO,
    atan2,
    ceiling,
    exactly,
    finite,
    resolved,
    rough,
    sign,
    sqrt,
    turn,
    undefined,
)
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import GRAZES, GUARD_TURNS, MINIMUM_BEFORE_START
from numerics.arithmetic.telling import text
from numerics.contact.root import root_of
from numerics.flows.slip import Variables, guard_and_gap

guard_root = root_of(guard_and_gap, "guard_root")


@text
def guessed_contact(at: Variables, lower: Number, upper: Number) -> Number:  # noqa: ARG001
    """Return where the search in a bracket starts."""
    return (lower + upper) / 2


def double_guess(at: Variables, lower: Double, upper: Double) -> Double:
    """Return where the search in double-double starts: at the root that binary64 finds, if it lies in the bracket."""
    rounded = Variables(at.guard.high, at.gap.high, at.push.high)
    theta = Double(guard_root(rounded, lower.high, upper.high, (lower.high + upper.high) / 2), 0.0)
    return theta if less(lower, theta) and less(theta, upper) else scaled(add(lower, upper), 0.5)


@text
def first_contact(at: Variables, turns: bool) -> tuple[Number, float]:
    """Return the first theta > 0 with k = 0, k(0) > 0, and how far above 0 the lowest minimum before it lies.

    `turns`: the guard has extrema, A^2 = (1 + d)^2 + u^2 > 1, decided on exact rationals where A may be 1.
    """
    g, d, u = at.guard, at.gap, at.push
    excess = d * (2 + d) + u * u  # A^2 - 1
    if not finite(excess):
        return undefined(), 0.0
    if not turns or sign(excess, GUARD_TURNS) <= 0:
        upper = g + u + 3  # monotone: k <= g + u + A - theta, A <= 1
        return guard_root(at, ZERO, upper, guessed_contact(at, ZERO, upper)), math.inf
    height = sqrt(excess)
    lean, phase = atan2(height, exactly(1.0)), atan2(u, 1 + d)
    count = (g + u - height + (lean - phase)) / turn()  # k at the minimum phase - lean, in full turns
    if not finite(count) or (rough(count) > 1.0 and not resolved(count)):
        return undefined(), 0.0
    index, first = ceiling(count, GRAZES), phase - lean
    if index < 1:
        index = 1 if sign(first, MINIMUM_BEFORE_START) <= 0 else 0
    minimum = first + turn() * index
    maximum = minimum - turn() + 2 * lean
    least = 1 if rough(first) <= 0.0 else 0
    spared = rough(turn() * (count - (index - 1))) if index > least else math.inf
    lower = ZERO if rough(maximum) <= 0.0 else maximum
    return guard_root(at, lower, minimum, guessed_contact(at, lower, minimum)), spared
