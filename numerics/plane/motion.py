"""From the path and its bounds to the true motion, enclosed: its words, short windows, events, any time.

Twice the rate of v1 at a point of the path, V, bounds |v1'| as long as |u - A2 q1 - A1 v1| + b < m1 V with all that q1
and v1 can come to at such rates: that is checked, so V cannot be exceeded first. All that follows from it is proved,
whatever friction does in a window.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from flint import arb, arb_series

from numerics.arithmetic.ball import Ball
from numerics.linear.modes import EventKind, event_kind, sticking
from numerics.plane.polynomial import rise
from numerics.plane.series import Point
from numerics.plane.system import SPARE_BITS, System
from numerics.plane.vector import Vector, wide
from numerics.scene.short_repr import ShortRepr

Numbers = tuple[arb, ...]


class PlaneState(NamedTuple):
    """x1, v1, x2, v2, (n,) each: m, m/s; rad, rad/s on the axis phi."""

    x1: Numbers
    v1: Numbers
    x2: Numbers
    v2: Numbers


class Working(Ball):
    """Balls that keep the bits of the path and of its defects."""

    def __init__(self, digits: int) -> None:
        """Fix the working digits."""
        super().__init__(digits)
        self.bits += SPARE_BITS


@dataclass(frozen=True, repr=False)
class PlaneEvent(ShortRepr):
    """A change of mode at t (s): `direction` (n,) of v1 - v2 after it (before a stick), `load` (n,) on the friction, N.

    Modes are "stick" and "slip", of a box a word of + 0 -. `cause`: "guard", or "jump" of the force or of b.
    """

    t: arb
    before: str
    after: str
    y: PlaneState
    direction: Numbers
    load: Numbers
    cause: str

    @property
    def kind(self) -> EventKind:
        """Return whether something sticks from now on, slips from now on, or only reverses."""
        return event_kind(sticking(self.after) - sticking(self.before))


BEYOND = 1 + 2.0**-10
"""So far beyond K friction may be: that of a mode which is followed on to where the true motion has left it."""


class Around(NamedTuple):
    """Enclosures and bounds by axes, for all of a window.

    `first`, `second`, `steep`: bounds on |v1'|, |v2'|, |Lam'|; `load`: Lam; `drift`: the rate of what Lam is without
    the part of s, share (u - A2 q1 - A1 V), V the velocity of the common mass, in which no friction is.
    """

    first: Vector
    second: Vector
    load: Vector
    drift: Vector
    steep: Vector


def around(system: System, at: Point, norm: arb, window: arb, slips: Sequence[arb | None] = ()) -> Around:
    """Return what holds within `window` (s) of a point from which the true motion is N <= norm. Raises EventUndecided.

    `slips`: friction on axes that slip with a constant one (else None); there the rate of v1 replaces that of V.
    """
    drive = system.drive(at)
    first = (abs(system.push(drive.force(at.t), at.q1, at.v1)) + drive.b) * 2 / system.m1
    v1 = wide(at.v1, norm / system.root_m1 + first * window)
    q1 = wide(at.q1, system.soft * norm + abs(v1) * window)
    both = drive.force(arb_series([wide(at.t, window), 1], 2))
    u, turn = both.order(0), both.order(1)
    push = system.push(u, q1, v1)
    if not all(x < y for x, y in zip(abs(push) + drive.b * BEYOND, system.m1 * first, strict=True)):
        raise system.undecided("how far does the motion get in a window", at, norm)
    pull = list(push / system.mass)
    for i, f in enumerate(slips):
        if f is not None:
            pull[i] = (push[i] - f) / system.m1[i]
    steep = system.share * (abs(turn - system.a2 @ v1) + abs(system.a1) @ first)
    drift = system.load(turn, v1, Vector(pull))
    return Around(first, drive.b * BEYOND / system.m2, push * system.share, drift, steep)


class PlaneLeg(NamedTuple):
    """A curve of a system from x = 0 to x = `end`, and a bound on N up to there."""

    system: int
    curve: Point
    end: arb
    norm: arb


class PlaneMotion:
    """The motion that the legs of a path enclose."""

    def __init__(self, systems: list[System], legs: list[PlaneLeg]) -> None:
        """Take the legs, which may still grow."""
        self.systems, self.legs = systems, legs
        with systems[-1].fine():
            self.starts = [Ball.number(one.start) for one in systems[-1].given.pieces]

    def at(self, t: arb) -> PlaneState:
        """Return the state at a time."""
        piece = max(0, bisect_right(self.starts, t.mid()) - 1)
        local = t - self.starts[piece]
        after = bisect_right(self.legs, (piece, local.mid()), key=lambda one: (one.curve.piece, one.curve.t[0]))
        index, curve, end, norm = self.legs[max(0, after - 1)]
        system = self.systems[index]
        there = drifted(system, curve, _place(curve.t, end, local.mid()), norm)
        at, more = middle(system, there)
        return enclosed(system, at, abs(there.t - local).upper(), (norm + more).upper())


def _place(t: arb, end: arb, time: arb) -> arb:
    """Return where on [0, end] a curve is at a time, about."""
    if not time > t[0]:
        return arb(0)
    return rise(t, time) if time < t(end) else end


def drifted(system: System, curve: Point, x: arb, norm: arb) -> Point:
    """Return a point of a curve; z is off by what s is off for the time from its beginning, on the axes that slip."""
    there = curve.at(x)
    off = system.apart * (norm * abs(there.t - curve.t[0]))
    return there._replace(z=Vector(wide(z, y) if p else z for z, y, p in zip(there.z, off, curve.s, strict=True)))


def middle(system: System, at: Point) -> tuple[Point, arb]:
    """Return the midpoints of a point, z with its errors; a bound on N of the radii."""
    off = at.each(arb.rad)
    return at.each(arb.mid)._replace(z=at.z), system.norm(off.q1, off.v1, off.v2)


def enclosed(system: System, at: Point, late: arb, norm: arb) -> PlaneState:
    """Return the true state within `late` (s) of a point of the path, by the bound on N."""
    near = around(system, at, norm, late)
    first, second = norm / system.root_m1 + near.first * late, norm / system.root_m2 + near.second * late
    q1 = wide(at.q1, system.soft * norm + (abs(at.v1) + first) * late)
    v1, v2 = wide(at.v1, first), wide(at.v2, second)
    z = wide(at.z, (abs(at.s) + system.apart * norm + (near.first + near.second) * late) * late)
    if not any(at.s) and all(x.overlaps(y) for x, y in zip(v1, v2, strict=True)):
        v1 = v2 = Vector(x.intersection(y) for x, y in zip(v1, v2, strict=True))
    place, x1 = system.place, system.place @ q1
    return PlaneState(x1, place @ v1, x1 - system.at_first - place @ z, place @ v2)
