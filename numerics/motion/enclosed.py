"""What balls do otherwise in an undamped slip, so that enclosures grow no more than they must."""

from __future__ import annotations

import math

from flint import arb

from numerics.arithmetic.ball_words import BALL, ZERO, mean_value, sqrt
from numerics.contact.enclosed import enclosed_contact
from numerics.flows.slip import Variables, guard_and_gap, slid_at
from numerics.motion.undamped import Landing, Pair, Start

_SLID, _GUARD = BALL(slid_at), BALL(guard_and_gap)


def enclosed_slid(at: Variables, theta: arb) -> arb:
    """Return K(theta); its slope is the guard, so at a contact it is stationary."""
    return mean_value(lambda x: _SLID(at, x), lambda x: _GUARD(at, x)[0], theta)


def enclosed_ray_landing(pair: Pair, start: Start) -> Landing:
    """Return the end of a slip from an exit ray, a function of its excess w.

    The contact is located at the centre of w; along w, theta/u falls (h is convex), c' = h and
    dw'/dw = 1 - r (1 - cos theta), which lies in (-1, 1): so enclosures of w do not grow from one excursion to the
    next, however many there are.
    """
    w, q, r = start.w, pair.q, pair.r
    centre = w.mid()
    push = sqrt(centre) / pair.sqrt_q
    at = enclosed_contact(ZERO, push)
    stretch = sqrt(w / centre)
    theta = at.theta * stretch
    depth = at.depth + push * stretch * (theta - at.theta)
    # 1 - cos changes by less than |theta - theta at the centre|; 3 makes the ball cover both signs of that difference,
    # of which it lacks a part, as sqrt bends: sqrt 2 - 1 > 1/3
    slope = 1 - r * (at.versine + 3 * (theta - at.theta))
    after = (centre - r * q * at.depth * at.depth) + (w - centre) * slope
    return Landing(theta, -depth, depth * depth / 2, after, at.versine, math.inf)
