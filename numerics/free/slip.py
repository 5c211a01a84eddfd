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
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb

from numerics.arithmetic.ball import mean_value
from numerics.arithmetic.compiled import by_type, compilable
from numerics.arithmetic.functions import cosine_deficit, sin, sine_cosine, sine_deficit, versine
from numerics.arithmetic.protocol import Number


class Variables(NamedTuple):
    """Guard, gap and push at the start of a slip, dimensionless."""

    guard: Number
    gap: Number
    push: Number


@compilable
def guard_and_gap(at: Variables, theta: Number) -> tuple[Number, Number]:
    """Return k(theta) and its slope d(theta)."""
    sine, drop = sin(theta), versine(theta)
    guard = (at.gap * sine + at.push * drop - sine_deficit(theta)) + at.guard
    return guard, at.gap + (at.push * sine - (1 + at.gap) * drop)


@compilable
def push_at(at: Variables, theta: Number) -> Number:
    """Return u(theta)."""
    sine, cosine = sine_cosine(theta)
    return at.push * cosine - (1 + at.gap) * sine


@compilable
def _slid_of_points(theta: Number, at: Variables) -> Number:
    grown = at.gap * versine(theta) + at.push * sine_deficit(theta)
    return (grown - cosine_deficit(theta)) + at.guard * theta


@by_type(_slid_of_points, _slid_of_points)
def slid_at(theta: Number, at: Variables) -> Number:
    """Return K(theta); its slope is the guard, so at a contact, where a ball of angles is centred, it is stationary."""
    if type(theta) is arb:
        return mean_value(lambda x: _slid_of_points(x, at), lambda x: guard_and_gap(at, x)[0], theta)
    return _slid_of_points(theta, at)
