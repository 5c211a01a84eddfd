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
    """A curve of a system from x = 0 to x = `end`; bounds at its end on N and on the errors of z."""

    system: int
    curve: Point
    end: arb
    norm: arb
    apart: Vector


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
        system, curve, end, norm, apart = self.legs[max(0, after - 1)]
        there = curve.at(_place(curve.t, end, local.mid()))
        at, more, wider = middle(self.systems[system], there)
        late = abs(there.t - local).upper()
        return enclosed(self.systems[system], at, late, (norm + more).upper(), apart + wider)


def _place(t: arb, end: arb, time: arb) -> arb:
    """Return where on [0, end] a curve is at a time, about."""
    if not time > t[0]:
        return arb(0)
    return rise(t, time) if time < t(end) else end


def middle(system: System, at: Point) -> tuple[Point, arb, Vector]:
    """Return the midpoints of a point; bounds on N of the radii, and on those of z."""
    off = at.each(arb.rad)
    return at.each(arb.mid), system.norm(off.q1, off.v1, off.v2), off.z


def enclosed(system: System, at: Point, late: arb, norm: arb, apart: Vector) -> PlaneState:
    """Return the true state within `late` (s) of a point of the path, by the bounds on N and on z."""
    near = around(system, at, norm, late)
    first, second = norm / system.root_m1 + near.first * late, norm / system.root_m2 + near.second * late
    q1 = wide(at.q1, system.soft * norm + (abs(at.v1) + first) * late)
    v1, v2 = wide(at.v1, first), wide(at.v2, second)
    z = wide(at.z, apart + (abs(at.s) + system.apart * norm + (near.first + near.second) * late) * late)
    if not any(at.s) and all(x.overlaps(y) for x, y in zip(v1, v2, strict=True)):
        v1 = v2 = Vector(x.intersection(y) for x, y in zip(v1, v2, strict=True))
    place, x1 = system.place, system.place @ q1
    return PlaneState(x1, place @ v1, x1 - system.at_first - place @ z, place @ v2)
