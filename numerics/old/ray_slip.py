"""A slip that leaves S0 by an exit ray: no positions, everything is a function of the energy excess w = q u^2."""

from __future__ import annotations

from numerics.arithmetic.dual import differentiated
from numerics.arithmetic.protocol import Number
from numerics.motion.frame import Frame
from numerics.old import tangent
from numerics.old.slip_flow import SlipFlow


def ray_flow(frame: Frame, w: Number) -> SlipFlow:
    """Return the slip variables on an exit ray with energy excess w: gap 0 and guard 0 exactly, push sqrt(w/q)."""
    arithmetic, zero = frame.arithmetic, frame.arithmetic.number(0)
    values = lambda: (zero, arithmetic.sqrt(w) / frame.sqrt_q)  # noqa: E731
    gap, push = differentiated(arithmetic, values, lambda _: tangent.on_ray(frame, w))
    return SlipFlow(arithmetic, zero, gap, push)


def ray_landing(frame: Frame, w: Number) -> tuple[Number, Number, Number]:
    """Return (theta, c, w') of the slip from an exit ray with excess w: h(theta) = sqrt(w/q), w' = w - r q c^2.

    The contact is located at the centre of w; along w, theta/u falls (h is convex), c' = h and
    dw'/dw = 1 - r (1 - cos theta), which lies in (-1, 1): so enclosures of w do not grow from one excursion to the
    next, however many there are. For a point arithmetic the centre is w itself, and what is added is exactly 0.
    """
    arithmetic, q, r = frame.arithmetic, frame.q, frame.r
    centre = arithmetic.centre(w)
    push = arithmetic.sqrt(centre) / frame.sqrt_q
    at = arithmetic.contact(arithmetic.number(0), push)
    stretch = arithmetic.sqrt(w / centre)
    theta = at.theta * stretch
    depth = at.depth + push * stretch * (theta - at.theta)
    # 1 - cos changes by less than |theta - theta at the centre|; 3 makes the ball cover both signs of that difference,
    # of which it lacks a part, as sqrt bends: sqrt 2 - 1 > 1/3
    slope = 1 - r * (at.versine + 3 * (theta - at.theta))
    return theta, depth, (centre - r * q * at.depth * at.depth) + (w - centre) * slope
