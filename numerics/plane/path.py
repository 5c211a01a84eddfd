"""What a path is made of: legs, events, the point that was reached, the bound N, and questions about the load there."""

from __future__ import annotations

from collections.abc import Callable

from flint import arb

from numerics.errors import EventUndecided
from numerics.plane.motion import Around, PlaneEvent, PlaneLeg, PlaneMotion, around, drifted, enclosed, middle
from numerics.plane.series import Friction, Point
from numerics.plane.system import PlaneDrive, System
from numerics.plane.vector import Vector, wide

OUTSIDE = "does the load leave the friction set, or only touch its edge"
Progress = Callable[[int, float], None]


class PlanePath:
    """A path that is followed: legs and events so far, the point that was reached, its bounds.

    `systems`: of the line on which it is at first, and of all axes that move. `mode` has a letter for each axis: 0
    sticks, + and - slip with constant friction, * with that of their direction.
    """

    def __init__(self, systems: list[System], max_events: int, max_legs: int, progress: Progress | None = None) -> None:
        """Begin at t = 0."""
        self.systems, self.system, self.mode = systems, systems[0], "0" * systems[0].n
        self.max_events, self.max_legs, self.progress = max_events, max_legs, progress
        self.legs: list[PlaneLeg] = []
        self.events: list[PlaneEvent] = []
        self.motion = PlaneMotion(systems, self.legs)
        with self.system.fine():
            (q1, v1, v2), still = self.system.start, self.system.still
            self.norm = arb(0)
            self.set(Point(0, arb(0), q1, v2, v1 - v2, still))

    @property
    def drive(self) -> PlaneDrive:
        """Return what acts at the point."""
        return self.system.drive(self.at)

    @property
    def reached(self) -> bool:
        """Return whether the path is at the horizon."""
        return self.at.piece == len(self.systems[-1].pieces)

    def undecided(self, question: str) -> EventUndecided:
        """Return the error for a point after which these digits do not tell what happens."""
        return self.system.undecided(question, self.at, self.norm)

    def set(self, point: Point) -> None:
        """Go to a point: enclosures become their midpoints, and N grows by their radii."""
        self.at, norm = middle(self.system, point)
        self.norm = (self.norm + norm).upper()

    def go_on(self, curve: Point, end: arb, norm: arb, *, ends: bool) -> None:
        """Record a curve and go to its end, or to the next piece of force if it `ends` there."""
        point, self.norm = drifted(self.system, curve, end, norm), norm
        self.set(point)
        true = self.drive.length if ends else self.at.t
        # the curve is there a little earlier or later: as a motion that rests meanwhile it lacks all its rates
        self.norm = (self.norm + self.rate(true) * abs(point.t - true)).upper()
        self.legs.append(PlaneLeg(self.systems.index(self.system), curve, end, self.norm))
        if ends:
            self.at = self.at._replace(piece=curve.piece + 1, t=arb(0))

    def halt(self, gone: Vector) -> None:
        """Take a part of s away from both bodies, up to its errors."""
        first = gone * self.system.share
        self.norm = (self.norm + self.system.norm(self.system.still, first, gone - first)).upper()
        self.set(self.at._replace(v2=self.at.v2 + gone - first, s=self.at.s - gone))

    def around(self, window: arb, slips: Friction = ()) -> Around:
        """Return what holds of the true motion within `window` (s) of the point, proved. Raises EventUndecided."""
        return around(self.system, self.at, self.norm, window, slips)

    def rate(self, true: arb) -> arb:
        """Return a bound on the rate of N by which a path that rests at the point, until a time, leaves the motion."""
        system, at, drive = self.system, self.at, self.drive
        first = abs(system.push(drive.force(at.t.union(true)), at.q1, at.v1)) + drive.b
        return system.norm(at.v1, first / system.m1, drive.b / system.m2)

    @property
    def load(self) -> Vector:
        """Return an enclosure of the true motion's Lam at the point."""
        there = self.system.load(self.drive.force(self.at.t), self.at.q1, self.at.v1)
        return Vector(wide(there, self.system.load_error * self.norm))

    def fitted(self, h: arb) -> tuple[arb, bool]:
        """Return a time to go on for, not beyond the end of the piece, and whether it is that."""
        left = (self.drive.length - self.at.t).mid()
        return (left, True) if h >= left else (h, False)

    def leaves(self, normal: Vector, window: arb, m: int, slips: Friction = ()) -> bool:
        """Return whether n.Lam > h(n) from the beginning of a slip to the end of a window: then s != 0 in it.

        n.kap^-1 s rises, n.kap^-1 s' = n.(Lam - f) >= n.Lam - h(n). For m = 2, n.Lam = h(n) at the beginning, n its
        normal there: without a damper n.Lam rises by n.drift. With one the slip itself enters Lam; but |s|_{kap^-1}
        grows no faster than the kap-distance of Lam from K, so to second order: at most by sum_i sqrt(kap_i) steep_i
        t^2/2 in a time t < 2 window.
        """
        system, near = self.system, self.around(window, slips)
        if m == 1:
            return bool(normal @ near.load > self.drive.friction(normal)[1])
        far = system.apart @ near.steep * window
        return bool(normal @ near.drift > far * (abs(normal) @ (system.share * (abs(system.a1) @ system.apart))))

    def record(self, before: str, direction: Vector, late: arb, cause: str) -> None:
        """Record a change of mode, which comes before or after a piece of force, not perhaps the one or the other."""
        if late > 0 and not (late < self.at.t and self.at.t + late < self.drive.length):
            raise self.undecided("does the event come before the force changes, or the run ends")
        system, load, along = self.system, self.around(late).load, self.system.place @ direction
        self.at = self.at._replace(z=wide(self.at.z, system.apart * (2 * self.norm * late)))  # whatever slips
        t, length = self.motion.starts[self.at.piece] + self.at.t + arb(0, late.upper()), (along @ along).sqrt()
        y, (old, new) = enclosed(system, self.at, late, self.norm), map(system.word, (before, self.mode))
        unit = along / length if length > 0 else along
        self.events.append(PlaneEvent(t, old, new, y, unit, system.force @ load, cause))
