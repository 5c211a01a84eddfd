"""From the path and its bounds to the true motion, enclosed: at an event, at any time, on the axes of the scene."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided
from numerics.plane.answer import PlaneEvent, PlaneState
from numerics.plane.path import SLIP, Happening, Leg, Path
from numerics.plane.polynomial import rise
from numerics.plane.series import Point
from numerics.plane.system import Balls
from numerics.plane.window import around, wide
from numerics.scene.plane import Matrix, PlaneScene


class States:
    """The states of a run, as enclosures of the true ones."""

    def __init__(self, scene: PlaneScene, run: Path) -> None:
        """Take a scene and its run."""
        self.scene, self.run, self.system = scene, run, run.system
        self.starts = [(leg.curve.piece, float(leg.curve.t[0].mid())) for leg in run.legs]

    def enclosed(self, at: Point, norm: arb, apart: Balls, late: arb) -> PlaneState:
        """Return the true state within `late` (s) of a point of the path, by the bounds on N and on z."""
        system, given = self.system, self.system.given
        near = around(system, at, norm, late)
        if near is None:
            raise EventUndecided("how far does the motion get in a window", f"{late.str(3)} s", system.digits)
        q1, v1, v2, z = [], [], [], []
        for i in system.axes:
            first, second = near.first[i] * late, near.second[i] * late
            q1.append(wide(at.q1[i], system.soft[i] * norm + (abs(at.v1[i]) + norm / system.root_m1[i] + first) * late))
            v1.append(wide(at.v1[i], norm / system.root_m1[i] + first))
            v2.append(wide(at.v2[i], norm / system.root_m2[i] + second))
            z.append(wide(at.z[i], apart[i] + (abs(at.s[i]) + system.apart[i] * norm + first + second) * late))
        if all(x.is_zero() for x in at.s):
            v1 = v2 = [x.intersection(y) for x, y in zip(v1, v2, strict=True)] if _meet(v1, v2) else v1
        x1 = taken(given.place, q1)
        gone = [Ball.number(x - y) for x, y in zip(self.scene.x1, self.scene.x2, strict=True)]
        x2 = [x - y - w for x, y, w in zip(x1, gone, taken(given.place, z), strict=True)]
        return PlaneState(tuple(x1), tuple(taken(given.place, v1)), tuple(x2), tuple(taken(given.place, v2)))

    def event(self, one: Happening, name: Callable[[str], str] = str) -> PlaneEvent:
        """Return an event on the axes of the scene."""
        given = self.system.given
        t = Ball.number(given.pieces[one.at.piece].start) + one.at.t + arb(0, one.late.upper())
        load, direction = taken(given.force, one.load), taken(given.place, one.direction)
        length = sum((x * x for x in direction), arb(0)).sqrt()
        y = self.enclosed(one.at, one.norm, one.apart, one.late)
        unit = tuple(x / length for x in direction) if length > 0 else tuple(direction)
        return PlaneEvent(t, name(one.before), name(one.after), y, unit, tuple(load), one.cause)

    def end(self) -> tuple[arb, PlaneState]:
        """Return time and state at the end of the run."""
        if self.run.reached:
            return Ball.number(self.scene.until), self.at(Ball.number(self.scene.until))
        last = self.run.events[-1]
        found = self.event(last)
        return found.t, found.y

    def at(self, t: arb) -> PlaneState:
        """Return the state at a time."""
        system, pieces = self.system, self.system.given.pieces
        middle = Fraction(*(int(x) for x in _ratio(t.mid())))
        piece = bisect_right([p.start for p in pieces], middle) - 1
        piece = min(max(piece, 0), len(pieces) - 1)
        local = t - Ball.number(pieces[piece].start)
        k = max(0, bisect_right(self.starts, (piece, float(local.mid()))) - 1)
        while k + 1 < len(self.run.legs) and self._precedes(self.run.legs[k], piece, local):
            k += 1
        while k > 0 and self.run.legs[k].curve.piece == piece and self.run.legs[k].curve.t[0] > local:
            k -= 1
        leg = self.run.legs[k]
        curve = leg.curve
        x = self._place(leg, local.mid())
        at = Point(curve.piece, curve.t(x).mid(), *([p(x) for p in part] for part in curve[2:6]))
        late = abs(curve.t(x) - local).upper()
        wide = Point(at.piece, at.t, *([y.mid() for y in part] for part in at[2:]))
        rounding = max((abs(y.rad()) for part in at[2:] for y in part), key=lambda one: one)
        grown = (
            leg.norm + system.norm([rounding] * system.n, [2 * rounding] * system.n, [rounding] * system.n)
        ).upper()
        return self.enclosed(wide, grown, [y + rounding for y in leg.apart], late)

    def _precedes(self, leg: Leg, piece: int, local: arb) -> bool:
        return leg.curve.piece < piece or (leg.curve.piece == piece and bool(leg.curve.t(leg.end) < local))

    def _place(self, leg: Leg, local: arb) -> arb:
        """Return where on [0, 1] a curve is at a time of its piece, about."""
        t = leg.curve.t
        low, high = t[0], t(leg.end)
        if local <= low:
            return arb(0)
        if local >= high:
            return leg.end
        if leg.mode != SLIP or t.degree() == 1:
            return ((local - low) / t[1]).mid()
        return rise(t, local)


def taken(matrix: Matrix, values: Sequence[arb]) -> Balls:
    """Return a rational matrix times a vector."""
    return [sum((Ball.number(a) * x for a, x in zip(row, values, strict=True) if a), arb(0)) for row in matrix]


def _meet(one: Balls, two: Balls) -> bool:
    return all(x.overlaps(y) for x, y in zip(one, two, strict=True))


def _ratio(x: arb) -> tuple[int, int]:
    mantissa, exponent = (int(one) for one in x.man_exp()) if not x.is_zero() else (0, 0)
    return (mantissa << exponent, 1) if exponent >= 0 else (mantissa, 1 << -exponent)
