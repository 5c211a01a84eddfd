"""The answer of a scene on a surface, in the words of the line's Solution: events, any time, bounds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.ball import EXACT, Ball, digits_within
from numerics.linear.modes import EventKind
from numerics.plane.system import SPARE_BITS
from numerics.plane.vector import Matrix, Vector, exact
from numerics.scene.decimals import exact_decimal
from numerics.scene.plane import PlaneScene
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.status import Status

Numbers = tuple[arb, ...]


class PlaneState(NamedTuple):
    """x1, v1, x2, v2, (n,) each: m, m/s; rad, rad/s on the axis phi."""

    x1: Numbers
    v1: Numbers
    x2: Numbers
    v2: Numbers


class Motion(Protocol):
    """What knows the state at any time of a run."""

    def at(self, t: arb) -> PlaneState:
        """Return the state at a time, enclosed."""


class Working(Ball):
    """Balls that keep the bits of the path and of its defects."""

    def __init__(self, digits: int, name: str) -> None:
        """Fix the working digits, and the name under which numbers are given."""
        super().__init__(digits)
        self.name, self.bits = name, self.bits + SPARE_BITS


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
        held = self.after.count("0") - self.before.count("0") + (self.after == "stick") - (self.before == "stick")
        return EventKind.ENTRY if held > 0 else EventKind.EXIT if held < 0 else EventKind.CROSSING


class PlaneSolution:
    """A solved scene on a surface. Numbers are enclosures (balls), or floats with bounds on their errors beside them.

    `t` (m,): start, events, end, or t_eval; `y` (4 n, m): x1, v1, x2, v2 by axes; `sol(t)` (4 n,). With float64
    `t_error` and `y_error` are proved bounds, which balls have as radii.
    """

    def __init__(
        self,
        scene: PlaneScene,
        arithmetic: Any,
        status: Status,
        events: Sequence[PlaneEvent],
        modes: Sequence[str],
        end: tuple[arb, PlaneState],
        motion: Motion,
        t_eval: Any = None,
    ) -> None:
        """Keep what a run found; `motion` gives the state at a time."""
        self.scene, self.arithmetic, self.status = scene, arithmetic, status
        self.events, self.modes, self.end_time, self.final_state = tuple(events), tuple(modes), end[0], end[1]
        self.motion, self.t_eval, self.digits, self.tried = motion, t_eval, 0, ""
        with self.context():
            self.digits = min(MOST if self.is_float else EXACT, self._right_digits())

    def context(self) -> Any:
        """Return the context of the balls."""
        return self.arithmetic.context()

    @property
    def is_float(self) -> bool:
        """Return whether numbers are given as floats."""
        return bool(self.arithmetic.name == "float64")

    @property
    def success(self) -> bool:
        """Return whether the horizon was reached."""
        return self.status.success

    @property
    def message(self) -> str:
        """Return the sentence that says how the solve ended."""
        return self.status.sentence

    @property
    def event_kinds(self) -> tuple[EventKind, ...]:
        """Return the kinds of the events."""
        return tuple(one.kind for one in self.events)

    @property
    def final_mode(self) -> str:
        """Return the mode at the end."""
        return self.modes[-1]

    @property
    def event_times(self) -> NDArray[Any]:
        """Return the times of the events, s."""
        return self._shown([one.t for one in self.events])

    @property
    def t(self) -> NDArray[Any]:
        """Return the times of start, events and end, or t_eval, s."""
        return self._shown([t for t, _ in self._points()])

    @property
    def y(self) -> NDArray[Any]:
        """Return the states at `t`, (4 n, m)."""
        return np.array([self._shown(_flat(y)) for _, y in self._points()]).T

    @property
    def t_error(self) -> NDArray[Any]:
        """Return bounds on the errors of `t`, s."""
        return np.array([_bound(t) for t, _ in self._points()])

    @property
    def y_error(self) -> NDArray[Any]:
        """Return bounds on the errors of `y`."""
        return np.array([[_bound(x) for x in _flat(y)] for _, y in self._points()]).T

    @property
    def energy(self) -> NDArray[Any]:
        """Return the energy at `t`, J."""
        with self.context():
            return self._shown([self.energy_of(y) for _, y in self._points()])

    @property
    def final_energy(self) -> Any:
        """Return the energy at the end, J."""
        with self.context():
            return self._shown([self.energy_of(self.final_state)])[0]

    def sol(self, t: Any) -> NDArray[Any]:
        """Return x1, v1, x2, v2 at time(s) t (s), exact or enclosed: (4 n,) or (4 n, m). Raises ValueError outside."""
        if np.ndim(t):
            return np.array([self.sol(one) for one in t]).T
        return self._shown(_flat(self._at(t)))

    def _at(self, t: Any) -> PlaneState:
        with self.context():
            return self.motion.at(self._time(t))

    def _time(self, t: Any) -> arb:
        """Return a time of the run as a ball. Raises ValueError."""
        time = t if isinstance(t, arb) else Ball.number(exact_decimal(t, "t"))
        if time < 0 or time > self.end_time:
            raise ValueError(f"t = {str(t)[:40]} s is outside of the run, [0, {self.end_time.str(6)}] s")
        return time

    def _points(self) -> list[tuple[arb, PlaneState]]:
        if self.t_eval is not None:
            with self.context():
                return [(self._time(t), self._at(t)) for t in self.t_eval]
        return [(arb(0), self._at(0)), *((one.t, one.y) for one in self.events), (self.end_time, self.final_state)]

    def _shown(self, numbers: Sequence[arb]) -> NDArray[Any]:
        return np.array(
            [float(x.mid()) for x in numbers] if self.is_float else list(numbers),
            dtype=None if self.is_float else object,
        )

    def _right_digits(self) -> int:
        """Return how many digits are right of every time, state and energy; near 0 relative to the run's largest."""
        states = [*(one.y for one in self.events), self.final_state]
        found = [digits_within(one.t.rad(), one.t, one.t) for one in self.events]
        n = self.scene.pair.axes
        for pair in ((0, 2), (1, 3)):
            for i in range(n):
                column = [(y[k][i]) for y in states for k in pair]
                scale = max((abs(x.mid()) for x in column), key=lambda one: one)
                for x in column:
                    size = scale if x.contains(0) else x
                    found.append(EXACT if x.rad().is_zero() else digits_within(x.rad(), size, size))
        energy = self.energy_of(self.final_state)
        return min([*found, digits_within(energy.rad(), energy, energy)])

    def mode_at(self, t: Any) -> Any:
        """Return the mode at time t (s), at an event the one after it; a list for several times."""
        if np.ndim(t):
            return [self.mode_at(one) for one in t]
        with self.context():
            time = self._time(t)
            return self.modes[sum(1 for one in self.events if not one.t > time)]

    def energy_of(self, y: PlaneState) -> arb:
        """Return (x1.A2 x1 + v1.M1 v1 + v2.M2 v2)/2 of a state, J, as a ball."""
        return energy_of(self.scene, y)

    def __repr__(self) -> str:
        """Return a short summary."""
        return (
            f"{self.message}; {self.arithmetic.name}, {self.digits} right digits, {len(self.events)} events, "
            f"t in [0, {self.end_time.str(6, radius=False)}] s, {self.final_mode} at the end"
        )


MOST = 15
"""Digits that a float shows."""


def energy_of(scene: PlaneScene, y: PlaneState) -> arb:
    """Return (x1.A2 x1 + v1.M1 v1 + v2.M2 v2)/2, J. (A ball about 0 has no ** 2 in python-flint: it answers nan.)"""
    x, v, w = map(Vector, (y.x1, y.v1, y.v2))
    found: arb = Matrix.of(scene.pair.a2) @ x @ x + exact(scene.pair.m1) * v @ v + exact(scene.pair.m2) * w @ w
    return found / 2


def _flat(y: PlaneState) -> list[arb]:
    return [x for part in y for x in part]


def _bound(x: arb) -> float:
    """Return how far the float of x may be off."""
    return float(abs(x - arb(float(x.mid()))).upper()) * (1 + 1e-15)
