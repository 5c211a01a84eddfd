"""From the path and its bounds to the true motion, enclosed: at an event, at any time, on the axes of the scene."""

from __future__ import annotations

from bisect import bisect_right

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided
from numerics.plane.answer import PlaneEvent, PlaneState
from numerics.plane.path import SLIP, STICK, Happening, Leg
from numerics.plane.polynomial import rise
from numerics.plane.series import Point
from numerics.plane.system import System
from numerics.plane.vector import Matrix, Vector, exact, wide
from numerics.plane.window import around
from numerics.scene.plane import PlaneScene


class States:
    """The states of a run, as enclosures of the true ones."""

    def __init__(self, scene: PlaneScene, system: System, legs: list[Leg]) -> None:
        """Take a scene and the path of its run."""
        self.system, self.legs = system, legs
        self.starts = [(leg.curve.piece, leg.curve.t[0]) for leg in legs]
        with self.system.fine():
            given = self.system.given
            self.pieces = [Ball.number(p.start) for p in given.pieces]
            self.place, self.force = Matrix.of(given.place), Matrix.of(given.force)
            self.apart = exact(x - y for x, y in zip(scene.x1, scene.x2, strict=True))

    def enclosed(self, at: Point, norm: arb, apart: Vector, late: arb) -> PlaneState:
        """Return the true state within `late` (s) of a point of the path, by the bounds on N and on z."""
        system = self.system
        near = around(system, at, norm, late)
        if near is None:
            raise EventUndecided("how far does the motion get in a window", f"{late.str(3)} s", system.digits)
        first, second = norm / system.root_m1 + near.first * late, norm / system.root_m2 + near.second * late
        q1 = wide(at.q1, system.soft * norm + (abs(at.v1) + first) * late)
        v1, v2 = wide(at.v1, first), wide(at.v2, second)
        z = wide(at.z, apart + (abs(at.s) + system.apart * norm + (near.first + near.second) * late) * late)
        if all(x.is_zero() for x in at.s) and all(x.overlaps(y) for x, y in zip(v1, v2, strict=True)):
            v1 = v2 = Vector(x.intersection(y) for x, y in zip(v1, v2, strict=True))
        x1 = self.place @ q1
        return PlaneState(x1, self.place @ v1, x1 - self.apart - self.place @ z, self.place @ v2)

    def event(self, one: Happening) -> PlaneEvent:
        """Return an event on the axes of the scene."""
        t = self.pieces[one.at.piece] + one.at.t + arb(0, one.late.upper())
        direction = self.place @ one.direction
        length = (direction @ direction).sqrt()
        y = self.enclosed(one.at, one.norm, one.apart, one.late)
        unit = direction / length if length > 0 else direction
        return PlaneEvent(t, self.word(one.before), self.word(one.after), y, unit, self.force @ one.load, one.cause)

    def word(self, mode: str) -> str:
        """Return a mode on the axes of the scene: of a box, those that do not move stick."""
        letters = iter(mode)
        return mode if mode in (STICK, SLIP) else "".join(next(letters) if row else "0" for row in self.place)

    def at(self, t: arb) -> PlaneState:
        """Return the state at a time."""
        piece = max(0, bisect_right(self.pieces, t.mid()) - 1)
        local = t - self.pieces[piece]
        leg = self.legs[max(0, bisect_right(self.starts, (piece, local.mid())) - 1)]
        curve, norm, system = leg.curve, leg.norm, self.system
        x = _place(leg, local.mid())
        q1, v2, s, z = (part.each(lambda p: p(x)) for part in curve[2:6])
        off = [part.each(arb.rad) for part in (q1, v2, s, z)]
        norm = (norm + system.norm(off[0], off[1] + off[2], off[1])).upper()
        at = Point(curve.piece, curve.t(x).mid(), *(part.each(arb.mid) for part in (q1, v2, s, z)))
        return self.enclosed(at, norm, leg.apart + off[3], abs(curve.t(x) - local).upper())


def _place(leg: Leg, local: arb) -> arb:
    """Return where on [0, 1] a curve is at a time of its piece, about."""
    t = leg.curve.t
    if not local > t[0]:
        return arb(0)
    if not local < t(leg.end):
        return leg.end
    return rise(t, local) if t.degree() > 1 else ((local - t[0]) / t[1]).mid()
