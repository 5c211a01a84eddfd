"""From the path and its bounds to the true motion, enclosed: at an event, at any time, on the axes of the scene."""

from __future__ import annotations

from bisect import bisect_right
from typing import NamedTuple

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.plane.answer import PlaneState
from numerics.plane.polynomial import rise
from numerics.plane.series import SeriesPoint, TaylorCurve
from numerics.plane.system import System
from numerics.plane.vector import Vector, exact, wide
from numerics.plane.window import around


class PlaneLeg(NamedTuple):
    """A curve from x = 0 to x = `end`; bounds at its end on N and on the errors of z."""

    curve: TaylorCurve
    end: arb
    norm: arb
    apart: Vector


class States:
    """The states of a run, as enclosures of the true ones."""

    def __init__(self, system: System, legs: list[PlaneLeg]) -> None:
        """Take the legs of a path, which may still grow."""
        self.system, self.legs = system, legs
        with self.system.fine():
            given = self.system.given
            self.pieces = [Ball.number(p.start) for p in given.pieces]
            self.place, self.force, self.apart = exact(given.place), exact(given.force), exact(given.apart)

    def enclosed(self, at: SeriesPoint, late: arb, norm: arb, apart: Vector) -> PlaneState:
        """Return the true state within `late` (s) of a point of the path, by the bounds on N and on z."""
        system = self.system
        near = around(system, at, norm, late)
        first, second = norm / system.root_m1 + near.first * late, norm / system.root_m2 + near.second * late
        q1 = wide(at.q1, system.soft * norm + (abs(at.v1) + first) * late)
        v1, v2 = wide(at.v1, first), wide(at.v2, second)
        z = wide(at.z, apart + (abs(at.s) + system.apart * norm + (near.first + near.second) * late) * late)
        if all(x.is_zero() for x in at.s) and all(x.overlaps(y) for x, y in zip(v1, v2, strict=True)):
            v1 = v2 = Vector(x.intersection(y) for x, y in zip(v1, v2, strict=True))
        x1 = self.place @ q1
        return PlaneState(x1, self.place @ v1, x1 - self.apart - self.place @ z, self.place @ v2)

    def word(self, mode: str) -> str:
        """Return a mode on the axes of the scene: of a box, those that do not move stick."""
        if self.system.given.is_round:
            return "stick" if "0" in mode else "slip"
        letters = iter(mode)
        return "".join(next(letters) if any(row) else "0" for row in zip(*self.place, strict=True))

    def at(self, t: arb) -> PlaneState:
        """Return the state at a time."""
        piece = max(0, bisect_right(self.pieces, t.mid()) - 1)
        local = t - self.pieces[piece]
        starts = bisect_right(self.legs, (piece, local.mid()), key=lambda one: (one.curve.piece, one.curve.t[0]))
        leg = self.legs[max(0, starts - 1)]
        there = leg.curve.at(_place(leg, local.mid()))
        at, norm, apart = there.middle(self.system)
        return self.enclosed(at, abs(there.t - local).upper(), (leg.norm + norm).upper(), leg.apart + apart)


def _place(leg: PlaneLeg, local: arb) -> arb:
    """Return where on [0, 1] a curve is at a time of its piece, about."""
    t = leg.curve.t
    if not local > t[0]:
        return arb(0)
    if not local < t(leg.end):
        return leg.end
    return rise(t, local) if t.degree() > 1 else ((local - t[0]) / t[1]).mid()
