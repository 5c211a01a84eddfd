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

from collections.abc import Callable
from enum import Enum
from fractions import Fraction
from typing import NamedTuple

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.free.centred_form import Cell, Centred
from numerics.free.contact import contact_next_to_binary64

CRITICAL_SHARE = Fraction("0.557839090721526")
"""r* rounded down: for shares m2/M up to it nothing merges after a start on S0 above E_cr."""
MAX_SLIPS = 10_000


class Verdict(Enum):
    """What is proved of every point of a cell; the value is the letter that stands for it in a checkpoint."""

    MERGES = "m"
    CREEPS = "c"
    UNDECIDED = "u"


class Rectangle(NamedTuple):
    """Mass ratios m2/m1 and excess energies w = E/E_cr - 1 > 0 of a cell, sides included; exact, dimensionless."""

    ratio: tuple[Fraction, Fraction]
    excess: tuple[Fraction, Fraction]

    @property
    def energy(self) -> tuple[Fraction, Fraction]:
        """Return the range of E/E_cr."""
        low, high = self.excess
        return 1 + low, 1 + high


class _Start(NamedTuple):
    """Start of a slip: gap d, push u and scaled excess y; on a ray the gap is exactly 0."""

    gap: Centred
    push: Centred
    excess: Centred
    on_ray: bool


class _End(NamedTuple):
    """End of a slip: angle theta, depth c(theta) and scaled excess y'."""

    theta: Centred
    depth: Centred
    excess: Centred


def verdict(rectangle: Rectangle) -> Verdict:
    """Return what becomes of every start in the rectangle; UNDECIDED if it is not one and the same, or not proved."""
    low, high = (ratio / (1 + ratio) for ratio in rectangle.ratio)
    if high <= CRITICAL_SHARE:
        return Verdict.CREEPS
    with Ball(16).context():
        return _CellRun((low, high), rectangle.excess).follow()


def creeping_excess(share: arb) -> arb:
    """Return h(t)^2, 1 - cos t = 1/r, r in (1/2, 1]: a start on S with w/q up to it creeps. It falls as r grows."""
    return _rise((1 - 1 / share).acos()) ** 2


class _CellRun:
    """All points of one cell, followed from slip to slip as long as they share their itinerary."""

    def __init__(self, share: tuple[Fraction, Fraction], excess: tuple[Fraction, Fraction]) -> None:
        # the third parameter is free: it stands for what is known by its bounds only
        self.cell = Cell(share, excess, (-1, 1))
        self.r, self.w, self.free = self.cell.parameters
        self.q = self.cell.constant(arb(1)) - self.r
        self.one_over_q = self.q.chain(1 / self.q.centre, -1 / (self.q.value * self.q.value), 1 / self.q.value)

    def follow(self) -> Verdict:
        """Return the common fate; each turn of the loop is one slip from S."""
        start: _Start | None = self._on_ray(self.w * self.one_over_q)
        level = creeping_excess(self.r.value.upper())
        for _ in range(MAX_SLIPS):
            if start is None:
                break
            if start.excess.value <= level:
                return Verdict.CREEPS
            end = self._slip(start)
            if end is None:
                start = self._short_slip(start.gap.value.upper(), start.push.value, start.excess)
                continue
            if end.excess.value < 0:
                return Verdict.MERGES
            if not end.excess.value > 0:
                break
            if start.on_ray and end.theta.value <= arb.pi():
                return Verdict.CREEPS
            start = self._next(start, end)
        return Verdict.UNDECIDED

    def _on_ray(self, excess: Centred) -> _Start:
        excess = self.cell.tight(excess)
        return _Start(self.cell.constant(arb(0)), self.cell.tight(excess.sqrt()), excess, on_ray=True)

    def _slip(self, start: _Start) -> _End | None:
        """Return the end of a slip from S; None if its angle is not enclosed over the whole cell."""
        theta = self._angle(start)
        if theta is None:
            return None
        deep = theta.chain(_depth(theta.centre), _rise(theta.value), _increasing(_depth, theta.value))
        deep = self.cell.tight(deep)
        lost = self.r * deep * (deep + start.gap * 2)
        excess = start.excess - lost
        if start.on_ray:
            excess = Centred(excess.centre, self._slopes_from_ray(start, theta, deep), excess.value)
        return _End(theta, deep, self.cell.tight(excess))

    def _angle(self, start: _Start) -> Centred | None:
        """Return theta(d, u): dtheta = (du + cot(theta/2) dd) (1 - cos theta)/(c + d)."""
        gap, push = start.gap, start.push
        at_centre = contact_next_to_binary64(gap.centre, push.centre)
        over_cell = contact_next_to_binary64(gap.value, push.value)
        if at_centre is None or over_cell is None:
            return None
        centre, value = at_centre[0], over_cell[0]
        rate = 2 * (value / 2).sin() ** 2 / (_increasing(_depth, value) + gap.value)
        cotangent = (value / 2).cot()
        slopes = (rate * (du + cotangent * dd) for du, dd in zip(push.slopes, gap.slopes, strict=True))
        return self.cell.tight(Centred(centre, tuple(slopes), value))

    def _slopes_from_ray(self, start: _Start, theta: Centred, deep: Centred) -> tuple[arb, ...]:
        """Return the slopes of y - r c^2 by its slope in y, 1 - r (1 - cos theta), which lies in [-1, 1]."""
        in_y, in_r = 1 - 2 * self.r.value * (theta.value / 2).sin() ** 2, -(deep.value * deep.value)
        return tuple(in_y * dy + in_r * dr for dy, dr in zip(start.excess.slopes, self.r.slopes, strict=True))

    def _next(self, start: _Start, end: _End) -> _Start | None:
        """Return the start of the next slip, wherever the last one ended; None if that is too uncertain."""
        beyond = self.cell.tight(start.gap + end.depth - self.one_over_q * 2)
        if beyond.value < 0:
            return self._on_ray(end.excess)
        push = self.cell.tight(end.theta - start.push)
        if beyond.value > 0:
            return _Start(beyond, push, end.excess, on_ray=False)
        reach = beyond.value.upper()
        if push.value > 0:
            return self._outwards(reach, end.excess)
        return self._short_slip(reach, push.value, end.excess)

    def _outwards(self, reach: arb, excess: Centred) -> _Start | None:
        """Return a start for points that end on this side of the edge, or up to `reach` beyond it, and move outwards.

        The former leave S0 by this edge, as if from gap 0; with the gap, 2 d + q d^2 + u^2 = y gives the push.
        """
        gap, excess = self._from_zero_to(reach), self.cell.without(2, excess)
        squared = self.cell.tight(excess - gap * (gap * self.q + self.cell.constant(arb(2))))
        if not squared.value > 0:
            return None
        return _Start(gap, self.cell.tight(squared.sqrt()), excess, on_ray=False)

    def _short_slip(self, reach: arb, push: arb, excess: Centred) -> _Start | None:
        """Return the ray after a slip from a gap d in [0, reach] that moves inwards (u < 0), known by bounds only.

        d cot(theta/2) = h - u bounds theta by 2 d/|u|, and the depth by d, as h tan(theta/2) >= c by the inequality of
        Cusa and Huygens: the slip ends in S0, less than 2 d from the edge.
        """
        if not (push < 0 and reach < self.one_over_q.value):
            return None
        deep, angle = reach, (2 * reach / -push).upper()
        if angle < arb.pi():
            deep = deep.min(_depth(angle))
        loss = self.r * self._from_zero_to((deep * (deep + 2 * reach)).upper())
        left = self.cell.tight(self.cell.without(2, excess) - loss)
        return self._on_ray(left) if left.value > 0 else None

    def _from_zero_to(self, bound: arb) -> Centred:
        """Return a number in [0, bound] of which nothing more is known, as a function of the free parameter."""
        return (self.free + self.cell.constant(arb(1))) * (bound / 2)


def _depth(theta: arb) -> arb:
    """Return c(theta) = 2 - theta cot(theta/2), which increases on (0, 2 pi): its derivative is h > 0."""
    return 2 - theta * (theta / 2).cot()


def _rise(theta: arb) -> arb:
    """Return h(theta) = theta/(1 - cos theta) - cot(theta/2), which increases on (0, 2 pi)."""
    return _increasing(lambda x: x / (2 * (x / 2).sin() ** 2) - (x / 2).cot(), theta)


def _increasing(function: Callable[[arb], arb], x: arb) -> arb:
    """Return the range of an increasing function over a ball."""
    return function(x) if x.is_exact() else function(x.lower()).union(function(x.upper()))
