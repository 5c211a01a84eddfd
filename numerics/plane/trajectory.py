"""The result of solving a scene on a surface: in the words of Trajectory, with a column for each axis.

Its file (trajectory/saved.py) has the legs of the path with their bounds, so that any time is answered as before; of a
box in parts, the header of each part's own trajectory.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, product
from types import ModuleType
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from flint import arb, arb_poly

from numerics.arithmetic.ball import EXACT, Ball, digits_within
from numerics.arithmetic.precision import cached_property
from numerics.linear.modes import EventKind
from numerics.meter import meter
from numerics.plane.answer import PlaneEvent, PlaneState, Working
from numerics.plane.box import Parts
from numerics.plane.motion import Leg, Motion
from numerics.plane.reduced import reduced
from numerics.plane.series import Point
from numerics.plane.system import System
from numerics.plane.vector import Vector, exact
from numerics.scene.decimals import exact_decimal
from numerics.scene.plane import PlaneScene
from numerics.trajectory import export, saved
from numerics.trajectory.answer import Answer
from numerics.trajectory.columns import Array
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from numerics.scene.decimals import Quantity, Times


class PlaneTrajectory(Answer):
    """A solved scene on a surface, with the attribute names of Trajectory; two are equal if every number is.

    Rows of `y` are x1, v1, x2, v2 by axes (m, m/s; rad, rad/s of an angle), columns belong to `t` (s): start, events,
    end; with t_eval, those times instead. All are enclosures; `floats` makes binary64 numbers of them.

    >>> from numerics import PlanePair, PlaneScene, solve
    >>> run = solve(PlaneScene(PlanePair(m1=1, m2=1, a2=200, b="0.5"), until=2, v1=["0.06", "0.01"]))
    >>> run.success, run.status.name, run.message, run.digits, run.tried, run.arithmetic.name
    (True, 'REACHED_HORIZON', 'reached the horizon', 15, '', 'ball')
    >>> run.modes, run.final_mode, run.event_kinds[0].value, run.event_times.shape, run.t_eval
    (('slip', 'stick'), 'stick', 'entry', (1,), None)
    >>> run.t.shape, run.y.shape, run.energy.shape, run.floats(run.y).dtype
    ((3,), (8, 3), (3,), dtype('float64'))
    >>> float(run.end_time), run.final == run.final_state, len(run.initial.x1), run.final_energy < 0.00107
    (2.0, True, 2, True)
    >>> run.sol([0.5, 1]).shape
    (8, 2)
    >>> run.events[0].kind.value, run.mode_at(0.001), run.mode_at([0, "1/3"]), run.scene.pair.axes
    ('entry', 'slip', ['slip', 'stick'], 2)
    >>> run.record()["final"]["mode"], run.to_csv()[:15], len(run.to_dataframe())
    ('stick', 'from,to,t (s),t', 3)
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     run.save(f"{folder}/run.npz")
    ...     PlaneTrajectory.load(f"{folder}/run.npz") == run
    True
    """

    scene: PlaneScene
    FORMAT = "inertial-pair surface trajectory 5"
    ENERGIES = ("energy",)
    EVENT_COLUMNS = ("direction", "load")

    def __init__(
        self,
        scene: PlaneScene,
        arithmetic: Working,
        status: Status,
        mode: str,
        events: tuple[PlaneEvent, ...],
        motion: Motion | Parts,
    ) -> None:
        """Keep what a run found: how it ended, the mode at t = 0, its events, and what knows the state at any time."""
        self.arithmetic: Working = arithmetic
        self.scene, self.status, self.events, self.motion = scene, status, events, motion
        self.modes = mode, *(one.after for one in events)
        with self.context():
            until = Ball.number(scene.until)
            end = (until, self.motion.at(until)) if self.success else (self.events[-1].t, self.events[-1].y)
            self.end_time, self.final_state = end
            self.final: PlaneState = self.final_state
            self.digits: int = min(EXACT, self._right_digits())

    def look_up_times(self) -> None:
        """Raise ValueError for times in t_eval that are outside the run."""
        for t in () if self.t_eval is None else self.t_eval:
            self._time(t)

    @property
    def final_mode(self) -> str:
        """Return the mode at the end."""
        return self.modes[-1]

    @property
    def event_kinds(self) -> tuple[EventKind, ...]:
        """Return the kinds of the events."""
        return tuple(one.kind for one in self.events)

    @property
    def event_times(self) -> Array:
        """Return the times of the events, s."""
        return np.array([one.t for one in self.events], dtype=object)

    @cached_property
    def _points(self) -> Array:
        """Return time and state at start, events and end, or at t_eval, shape (1 + 4 n, m)."""
        with self.context():
            given = self.t_eval
            rows = (
                [(one.t, one.y) for one in self.events]
                if given is None
                else [(self._time(t), self._at(t)) for t in given]
            )
            if given is None:
                rows = [(arb(0), self._at(0)), *rows, (self.end_time, self.final_state)]
            return np.array([[t, *chain(*y)] for t, y in rows], dtype=object).T

    @property
    def t(self) -> Array:
        """Return the times of start, events and end, or t_eval, s, shape (m,)."""
        return self._points[0]

    @property
    def y(self) -> Array:
        """Return the states at `t`, shape (4 n, m)."""
        return self._points[1:]

    @property
    def energy(self) -> Array:
        """Return the energy at `t`, J, shape (m,)."""
        with self.context():
            return np.array([*map(self.energy_of, self.y.T)], dtype=object)

    @property
    def final_energy(self) -> arb:
        """Return the energy at the end, J."""
        return self.end_numbers()[-1]

    def energy_of(self, y: Sequence[Quantity]) -> arb:
        """Return (x1.A2 x1 + v1.M1 v1 + v2.M2 v2)/2 of a state, J. (A ball about 0 has no ** 2: flint answers nan.)"""
        pair, (x, v, _, w) = self.scene.pair, map(Vector, np.reshape(np.array(y, dtype=object), (4, -1)))
        found: arb = exact(pair.a2) @ x @ x + exact(pair.m1) * v @ v + exact(pair.m2) * w @ w
        return found / 2

    def end_numbers(self) -> tuple[Quantity, ...]:
        """Return x1, v1, x2, v2 and the energy at the end."""
        with self.context():
            return *self.final_state, self.energy_of(self.final_state)

    def sol(self, t: Times) -> Array:
        """Return x1, v1, x2, v2 at time(s) t (s): shape (4 n,) for a number, (4 n, ...) for an array.

        Enclosed. Raises ValueError outside [0, end].
        """
        given = np.asarray(t, dtype=object)
        states = [[*chain(*self._at(one))] for one in given.flat]
        return np.array(states, dtype=object).T.reshape(4 * self.scene.pair.axes, *given.shape)

    def mode_at(self, t: Times) -> str | list[str]:
        """Return the mode at time t (s), at an event the one after it; a list for several times."""
        given = np.asarray(t, dtype=object)
        with self.context():
            found = [self.modes[sum(1 for one in self.events if not one.t > at)] for at in map(self._time, given.flat)]
        return found if given.ndim else found[0]

    def _at(self, t: Any) -> PlaneState:
        with self.context():
            return self.motion.at(self._time(t))

    def _time(self, t: Any) -> arb:
        """Return a time of the run as a ball; what the float next to its end shows is one, too. Raises ValueError."""
        given = t, float(self.end_time.mid())
        time, last = (x if isinstance(x, arb) else Ball.number(exact_decimal(x, "t")) for x in given)
        if time < 0 or (time > self.end_time and time > last):
            shown = f"t = {str(t)[:40]} s is outside the solved time [0, {last.str(6, radius=False)}] s"
            raise ValueError(f"{shown}; give one within it, or solve further")
        return time

    def _right_digits(self) -> int:
        """Return how many digits are right of every time, state and energy; near 0 relative to the run's largest."""
        states = [*(one.y for one in self.events), self.final_state]
        alone = [*(one.t for one in self.events), self.energy_of(self.final_state)]
        found = [(x, x) for x in alone]
        for k, i in product((0, 1), range(self.scene.pair.axes)):
            column = [x for y in states for x in (y[k][i], y[k + 2][i])]
            scale = max(abs(x.mid()) for x in column)
            found += [(x, scale if x.contains(0) else x) for x in column]
        return min(digits_within(x.rad(), of, of) for x, of in found)

    def record(self) -> dict[str, object]:
        """Return the JSON object of the interface: decimal strings of right digits, with radii beside balls."""
        return export.as_record(self)

    def _pictures(self) -> ModuleType:
        from numerics.plane import pictures

        return pictures

    @meter("drawing")
    def plot(self, kind: str = "above", ax: Axes | None = None) -> Axes:
        """Draw "above" (both bodies, m) or "relative" (v1 - v2, m/s) into matplotlib axes and return them."""
        return self._pictures().draw(self, kind, ax)

    @property
    def initial(self) -> PlaneState:
        """Return the state at the start."""
        return self._at(0)

    def _shown(self) -> dict[str, Any]:
        """Return what a summary says, by its names."""
        return {
            "message": self.message,
            "arithmetic": f"{self.arithmetic.name}, {self.digits} right digits",
            "events": len(self.events),
            "t": f"[0, {self.end_time.str(6, radius=False)}] s",
            "final mode": self.final_mode,
        }

    def kept(self) -> dict[str, Any]:
        """Return what the run wrote, as what JSON holds."""
        motion = self.motion
        return {
            "status": int(self.status),
            "events": [saved.plain([*vars(one).values()]) for one in self.events],
            "mode": self.modes[0],
            "legs": saved.plain(motion.legs) if isinstance(motion, Motion) else None,
            "parts": [*map(saved.contents, motion.answers)] if isinstance(motion, Parts) else None,
        }

    @classmethod
    def restored(cls, scene: Any, header: dict[str, Any]) -> Self:
        """Return the trajectory of a scene with what its run wrote."""
        _, digits = header["arithmetic"]
        working = Working(digits)
        with working.context():
            motion: Motion | Parts
            if header["parts"] is None:
                motion = Motion([System(one, digits) for one in reduced(scene)], [*map(_leg, header["legs"])])
            else:
                kinds = {kind.FORMAT: kind for kind in (cls, Trajectory)}
                parts = (saved.restored(one, kinds[one["format"]]) for one in header["parts"])
                motion = Parts(scene, {one.scene: one for one in parts}.__getitem__)
            rows = header["events"]
            events = tuple(PlaneEvent(t, one, two, PlaneState(*y), *more) for t, one, two, y, *more in rows)
        return cls(scene, working, Status(header["status"]), header["mode"], events, motion)


def _leg(given: Any) -> Leg:
    system, (piece, t, *parts), end, norm = given
    return Leg(system, Point(piece, arb_poly(t), *map(Vector, parts)), end, norm)
