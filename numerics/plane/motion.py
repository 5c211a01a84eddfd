"""From the path and its bounds to the true motion, enclosed: at an event, at any time, on the axes of the scene."""

from __future__ import annotations

from bisect import bisect_right
from typing import NamedTuple

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.plane.answer import PlaneState
from numerics.plane.polynomial import rise
from numerics.plane.series import Point
from numerics.plane.system import System
from numerics.plane.vector import Vector, wide
from numerics.plane.window import around


class Leg(NamedTuple):
    """A curve of a system from x = 0 to x = `end`, and a bound on N up to there."""

    system: int
    curve: Point
    end: arb
    norm: arb


class Motion:
    """The motion that the legs of a path enclose."""

    def __init__(self, systems: list[System], legs: list[Leg]) -> None:
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
