"""One cell of the merging map: what becomes of every start on S0 above E_cr in a rectangle, proved (a1 = 0).

With r = m2/(m1+m2), q = 1 - r, w = E/E_cr - 1 and y = w/q the pair leaves S0 by a ray with gap d = 0, push u = sqrt(y).
A slip from S (contact.py) of angle theta and depth c(theta) then gives

    y' = y - r c (c + 2 d)       excess at its end; the pair merges there exactly if y' <= 0
    e  = d + c - 2/q             how far beyond the other edge it ends: if e <= 0 the pair sticks, up to a ray
    d' = e,  u' = theta - u      start of the next slip if e > 0

A pair creeps, that is tends to E_cr and never merges, once one of three holds, with k = cot(theta/2):
    r <= r*        y' > 0 after every slip from S with y > 0; r* = 1/(2 sin^2 phi*) of theory/merging.py
    y <= h(t)^2    where 1 - cos t = 1/r, so k^2 = r - q. As 2 d + u^2 <= y and h k < 1, u + d k <= h at t: the slip
                   ends at theta <= t; there y' = (q + k^2) d^2 + (k^2 + q - r) c d + h^2 - r c^2 > 0, and y' <= y
    theta <= pi    in an excursion from a ray with y' > 0: up to pi y' rises with theta and then at most falls, so it
                   is positive for all smaller angles too, which are all that follow
"""

from __future__ import annotations

from enum import Enum
from fractions import Fraction

from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball
from numerics.free.centred_form import Centred, parameters
from numerics.free.contact import enclosed_contact, point_at

CRITICAL_SHARE = Fraction("0.557839090721526")
"""r* rounded down: for shares m2/M up to it nothing merges after a start on S0 above E_cr."""
MAX_SLIPS = 10_000
Side = tuple[Fraction, Fraction]


class Merging(Enum):
    """What is proved of every point of a cell; the value is the letter that stands for it in a checkpoint."""

    MERGES = "m"
    CREEPS = "c"
    UNDECIDED = "u"


_Start = tuple[Centred, Centred, Centred]
"""Start of a slip: gap d, push u and scaled excess y; on a ray the gap is exactly 0."""


def verdict(sides: tuple[Side, Side]) -> Merging:
    """Return what becomes of every start in a cell of mass ratios m2/m1 and excess energies w > 0, sides included.

    UNDECIDED if it is not one and the same, or not proved.
    """
    ratios, excess = sides
    low, high = (ratio / (1 + ratio) for ratio in ratios)
    if high <= CRITICAL_SHARE:
        return Merging.CREEPS
    with Ball(16).context():
        return _CellRun((low, high), excess).follow()


def creeping_excess(share: arb) -> arb:
    """Return h(t)^2, 1 - cos t = 1/r, r in (1/2, 1]: a start on S with w/q up to it creeps. It falls as r grows."""
    return (share * (1 - 1 / share).acos() - (2 * share - 1).sqrt()) ** 2


class _CellRun:
    """All points of one cell, followed from slip to slip as long as they share their itinerary."""

    def __init__(self, share: Side, excess: Side) -> None:
        # the third parameter is free: it stands for what is known by its bounds only
        self.r, self.w, self.free = parameters(share, excess, (Fraction(-1), Fraction(1)))
        q = self.r.constant(arb(1)) - self.r
        self.one_over_q = Centred(1 / q.centre, q.slopes / -(q.value * q.value), 1 / q.value, q.cell)

    def follow(self) -> Merging:
        """Return the common fate; each turn of the loop is one slip from S."""
        start: _Start | None = self._on_ray(self.w * self.one_over_q)
        level = creeping_excess(self.r.value.upper())
        for _ in range(MAX_SLIPS):
            if start is None:
                break
            gap, push, excess = start
            if excess.value <= level:
                return Merging.CREEPS
            end = self._slip(start)
            if end is None:
                start = self._short_slip(gap.value.upper(), push.value, excess)
                continue
            theta, depth, after = end
            if after.value < 0:
                return Merging.MERGES
            if not after.value > 0:
                break
            if gap.value.is_zero() and theta.value <= arb.pi():
                return Merging.CREEPS
            start = self._next(gap + depth - self.one_over_q - self.one_over_q, theta - push, after)
        return Merging.UNDECIDED

    def _on_ray(self, excess: Centred) -> _Start:
        return excess.constant(arb(0)), excess.sqrt(), excess

    def _slip(self, start: _Start) -> tuple[Centred, Centred, Centred] | None:
        """Return theta, c(theta) and y' at the end of a slip from S; None if it is not enclosed over the whole cell.

        dtheta = (du + cot(theta/2) dd) (1 - cos theta)/(c + d), and c' = h = u + d cot(theta/2).
        """
        gap, push, before = start
        at_centre = enclosed_contact(gap.centre, push.centre)
        over_cell = enclosed_contact(gap.value, push.value)
        if at_centre is None or over_cell is None:
            return None
        (angle, deep, _), (angles, *_) = at_centre, over_cell
        rate = 2 * (angles / 2).sin() ** 2 / (_depth_and_rise(angles)[0] + gap.value)
        theta = Centred(angle, (push.slopes + gap.slopes * (angles / 2).cot()) * rate, angles, gap.cell)
        depths, rise = _depth_and_rise(theta.value)
        depth = Centred(deep, theta.slopes * rise, depths, gap.cell)
        excess = before - self.r * depth * (depth + gap + gap)
        if gap.value.is_zero():  # of y - r c^2 the slope in y is 1 - r (1 - cos theta), which lies in [-1, 1]
            in_y, in_r = 1 - 2 * self.r.value * (theta.value / 2).sin() ** 2, -(depth.value * depth.value)
            slopes = before.slopes * in_y + self.r.slopes * in_r
            excess = Centred(excess.centre, slopes, excess.value, gap.cell)
        return theta, depth, excess

    def _next(self, beyond: Centred, push: Centred, excess: Centred) -> _Start | None:
        """Return the start of the next slip, wherever the last one ended; None if that is too uncertain."""
        if beyond.value < 0:
            return self._on_ray(excess)
        if beyond.value > 0:
            return beyond, push, excess
        return self._short_slip(beyond.value.upper(), push.value, excess)

    def _short_slip(self, reach: arb, push: arb, excess: Centred) -> _Start | None:
        """Return the ray after a slip from a gap d in [0, reach] that moves inwards (u < 0), known by bounds only.

        d cot(theta/2) = h - u bounds theta by 2 d/|u|, and the depth by d, as h tan(theta/2) >= c by the inequality of
        Cusa and Huygens: the slip ends in S0, less than 2 d from the edge.
        """
        if not (push < 0 and reach < self.one_over_q.value):
            return None
        deep, angle = reach, (2 * reach / -push).upper()
        if angle < arb.pi():
            deep = deep.min(_depth_and_rise(angle)[0])
        half = excess.constant((deep * (deep + 2 * reach)).upper() / 2)
        by_r, by_w, free = excess.slopes.entries()  # what was free before is another one than what is free now
        centre = excess.centre + arb(0, abs(free).upper())
        excess = Centred(centre, arb_mat([[by_r, by_w, 0]]), excess.value, excess.cell)
        left = excess - self.r * (half + half * self.free)
        return self._on_ray(left) if left.value > 0 else None


def _depth_and_rise(theta: arb) -> tuple[arb, arb]:
    """Return c and h = c' over a ball of angles in (0, 2 pi), where both increase."""
    low, high = (point_at(arb(0), arb(0), end) for end in (theta.lower(), theta.upper()))
    return low.depth.union(high.depth), low.rise.union(high.rise)
