"""The result of solving a scene on a surface: in the words of Trajectory, with a column for each axis.

Its file (trajectory/saved.py) has the legs of the path with their bounds, so that any time is answered as before; of a
box in parts, the header of each part's own trajectory.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from typing import Any, Self

import numpy as np
from flint import arb, arb_poly

from numerics.arithmetic.ball import EXACT, Ball, digits_within
from numerics.plane.box import Parts
from numerics.plane.motion import PlaneEvent, PlaneLeg, PlaneMotion, PlaneState, Working
from numerics.plane.reduced import reduced
from numerics.plane.series import Point
from numerics.plane.system import System, highest
from numerics.plane.vector import Vector, exact
from numerics.scene.plane import PlaneScene
from numerics.trajectory import export, saved
from numerics.trajectory.answer import Answer, Side
from numerics.trajectory.columns import Array, Counts
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory


class PlaneTrajectory(Answer[str]):
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
    >>> run.sol([0.5, 1]).shape, [len(one) for one in run.t_events], run.y_events[0].shape
    ((8, 2), [1, 0, 0], (1, 8))
    >>> run.events[0].kind.value, run.mode_at(0.001), run.mode_at([0, "1/3"]).tolist(), run.scene.pair.axes
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
    _PICTURES = "numerics.plane.pictures"

    def __init__(
        self,
        scene: PlaneScene,
        arithmetic: Working,
        status: Status,
        mode: str,
        events: tuple[PlaneEvent, ...],
        motion: PlaneMotion | Parts,
    ) -> None:
        """Keep what a run found: how it ended, the mode at t = 0, its events, and what knows the state at any time."""
        self.arithmetic: Working = arithmetic
        self.scene, self.status, self.events, self.motion = scene, status, events, motion
        self.bounded, self.reached = False, status.success
        self._all_modes = mode, *(one.after for one in events)
        self.event_times = np.array([one.t for one in events], dtype=object)
        self.event_states = _columns((one.y for one in events), 4 * scene.pair.axes)
        with self.context():
            until = Ball.number(scene.until)
            end = (until, self.motion.at(until)) if self.reached else (events[-1].t, events[-1].y)
            self.end_time, self.final_state = end
            self.final: PlaneState = self.final_state
            self.digits: int = min(EXACT, self._right_digits())

    @property
    def initial(self) -> PlaneState:  # type: ignore[override]
        """Return the state at the start."""
        with self.context():
            return self.motion.at(arb(0))

    def _states_at(self, times: Array, side: Side) -> Array:  # noqa: ARG002
        return _columns(map(self.motion.at, times), 4 * self.scene.pair.axes)

    def _energies(self, t: Array, y: Array, rows: Counts | None) -> Array:  # noqa: ARG002
        """Return (x1.A2 x1 + v1.M1 v1 + v2.M2 v2)/2 of states, J. (A ball about 0 has no ** 2: flint answers nan.)"""
        a2, m1, m2 = map(exact, (self.scene.pair.a2, self.scene.pair.m1, self.scene.pair.m2))
        states = (map(Vector, np.reshape(one, (4, -1))) for one in y.T)
        return np.array([(a2 @ x @ x + m1 * v @ v + m2 * w @ w) / 2 for x, v, _, w in states], dtype=object)

    def _right_digits(self) -> int:
        """Return how many digits are right of every time, state and energy; near 0 relative to the run's largest.

        Where that is 0, as at rest, relative to what friction holds.
        """
        pair = self.scene.pair
        b, mass, stiff = exact(pair.b), exact(pair.m1) + exact(pair.m2), exact(row[i] for i, row in enumerate(pair.a2))
        held = *(b / stiff), *(b / (stiff * mass).each(arb.sqrt))
        energy = highest(b * b / stiff) / 2
        left: Any = self.final_energy
        found = [(left, energy if left.contains(0) else left), *((x, x) for x in self.event_times)]
        states = np.column_stack([self.event_states, np.ravel(self.final_state)])
        columns = states.reshape(2, 2 * pair.axes, -1).swapaxes(0, 1)
        for column, least in zip(columns, held, strict=True):
            largest = max(abs(x.mid()) for x in column.flat)
            scale = largest if largest > 0 else least
            found += [(x, scale if x.contains(0) else x) for x in column.flat]
        return min(digits_within(x.rad(), of, of) for x, of in found)

    def record(self) -> dict[str, object]:
        """Return the JSON object of the interface: decimal strings of right digits, with radii beside balls."""
        return export.as_record(self)

    def kept(self) -> dict[str, Any]:
        """Return what the run wrote, as what JSON holds."""
        motion = self.motion
        return {
            "status": int(self.status),
            "events": [saved.plain([*vars(one).values()]) for one in self.events],
            "mode": self._all_modes[0],
            "legs": saved.plain(motion.legs) if isinstance(motion, PlaneMotion) else None,
            "parts": [*map(saved.contents, motion.answers)] if isinstance(motion, Parts) else None,
        }

    @classmethod
    def restored(cls, scene: Any, header: dict[str, Any]) -> Self:
        """Return the trajectory of a scene with what its run wrote."""
        _, digits = header["arithmetic"]
        working = Working(digits)
        with working.context():
            motion: PlaneMotion | Parts
            if header["parts"] is None:
                motion = PlaneMotion([System(one, digits) for one in reduced(scene)], [*map(_leg, header["legs"])])
            else:
                kinds = {kind.FORMAT: kind for kind in (cls, Trajectory)}
                parts = (saved.restored(one, kinds[one["format"]]) for one in header["parts"])
                motion = Parts(scene, {one.scene: one for one in parts}.__getitem__)
            rows = header["events"]
            events = tuple(PlaneEvent(t, one, two, PlaneState(*y), *more) for t, one, two, y, *more in rows)
        return cls(scene, working, Status(header["status"]), header["mode"], events, motion)


def _columns(states: Iterable[PlaneState], rows: int) -> Array:
    """Return states as columns."""
    return np.array([[*chain(*one)] for one in states], dtype=object).reshape(-1, rows).T


def _leg(given: Any) -> PlaneLeg:
    system, (piece, t, *parts), end, norm = given
    return PlaneLeg(system, Point(piece, arb_poly(t), *map(Vector, parts)), end, norm)
