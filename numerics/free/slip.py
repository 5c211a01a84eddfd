"""The slip of an undamped pair: after one change of variables it is the same motion for every pair.

For a slip of sign s put sigma = -s, angle theta = tau/sqrt(q), and from its start
    gap    d = (sigma X - 1)/q          signed distance beyond the edge of the sliding region that it may leave by
    push   u = sigma V1/sqrt(q)
    guard  k = s (V1 - V2)/sqrt(q)      positive while the slip lasts, k(0) = g
Then (1 + d, u) turns on a circle and, with versine = 1 - cos and sine_deficit = theta - sin, free of cancellation,
    k(theta)  = g + d sin + u versine - sine_deficit,       k' = d(theta)
    d(theta)  = d - (1 + d) versine + u sin
    u(theta)  = u - u versine - (1 + d) sin
    K(theta)  = g theta + d versine + u sine_deficit - (theta^2/2 - versine)
where K is the integral of k: the bodies have slid q K (in units of L) and E/E_cr has dropped by 2 r q K.

The first contact of a slip that starts off the switching surface is certified. k' = A cos(theta - phase) - 1 vanishes
at phase +- lean + 2 pi j, so the pieces on which the guard k is monotone are explicit; its local minima fall by 2 pi
from one to the next, so the first one below zero is known without visiting the others. The root lies on the decreasing
piece before it, and is the first. A minimum that is not proved to be above or below zero is a graze.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb

from numerics.arithmetic.ball import mean_value
from numerics.arithmetic.functions import (
    atan2,
    ceiling,
    cosine_deficit,
    midpoint,
    require_phase,
    sign,
    sine_cosine,
    sine_deficit,
    sqrt,
    two_pi,
    versine,
)
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.root import falling_root


class Start(NamedTuple):
    """The start of a mode of motion. In stick X = side (1 + gap) and V = push; in a slip the variables above.

    `driven` is side V2/sqrt(q); `turns` belongs to a free slip: the guard has extrema, A^2 = (1 + d)^2 + u^2 > 1,
    decided on exact rationals where A may be 1. tau is the reduced time.
    """

    kind: int
    side: int
    X: Number
    guard: Number
    gap: Number
    push: Number
    driven: Number
    turns: bool
    Z: Number
    w: Number
    tau: Number


def guard_and_gap(at: Start, theta: Number) -> tuple[Number, Number]:
    """Return k(theta) and its slope d(theta)."""
    sine, drop = sine_cosine(theta)[0], versine(theta)
    guard = (at.gap * sine + at.push * drop - sine_deficit(theta)) + at.guard
    return guard, at.gap + (at.push * sine - (1 + at.gap) * drop)


def push_at(at: Start, theta: Number) -> Number:
    """Return u(theta)."""
    sine, cosine = sine_cosine(theta)
    return at.push * cosine - (1 + at.gap) * sine


def slid_at(theta: Number, at: Start) -> Number:
    """Return K(theta); its slope is the guard, so at a contact, where a ball of angles is centred, it is stationary."""

    def slid(x: Number) -> Number:
        grown = at.gap * versine(x) + at.push * sine_deficit(x)
        return (grown - cosine_deficit(x)) + at.guard * x

    return mean_value(slid, lambda x: guard_and_gap(at, x)[0], theta) if type(theta) is arb else slid(theta)


def first_contact(at: Start) -> Number:
    """Return the first theta > 0 with k = 0, k(0) > 0."""
    g, d, u = at.guard, at.gap, at.push
    excess, zero = d * (2 + d) + u * u, g * 0  # A^2 - 1

    def guard(x: Number) -> tuple[Number, Number]:
        return guard_and_gap(at, x)

    if not at.turns or sign(excess, "does the guard of this slip turn at all?") <= 0:
        return falling_root(zero, g + u + 3, guard)  # monotone: k <= g + u + A - theta, A <= 1
    turn, height = two_pi(g), sqrt(excess)
    lean, phase = atan2(height, zero + 1), atan2(u, 1 + d)
    count = (g + u - height + (lean - phase)) / turn  # k at the minimum phase - lean, in full turns
    if midpoint(count) > 1:
        require_phase(count)
    index = ceiling(count, "does the slip touch the switching surface without crossing it (a graze)?")
    first = phase - lean
    if index < 1:
        index = 1 if sign(first, "is the guard's minimum next to the start before it?") <= 0 else 0
    minimum = first + turn * index
    maximum = minimum - turn + 2 * lean
    return falling_root(maximum if midpoint(maximum) > 0 else zero, minimum, guard)
