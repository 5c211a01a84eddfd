"""The result of solving a scene: exact segments joined by events. Nothing is sampled until somebody asks."""

from __future__ import annotations

import bisect
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Arithmetic, Number, Sign
from numerics.motion.frame import Frame, ReducedState
from numerics.motion.modes import EventKind, Mode
from numerics.old.motion import Motion
from numerics.scene import Scene

if TYPE_CHECKING:
    from numerics.kernel.state import Bounds
    from numerics.sensitivity.sensitivity import Sensitivity
    from numerics.trajectory.accuracy import Accuracy

Side = Literal["left", "right"]


class Status(Enum):
    """How a solve ended; the value is the sentence the user reads."""

    REACHED_HORIZON = "reached the horizon"
    STUCK_FOR_EVER = "reached the horizon; the pair has stuck for ever"
    EVENT_LIMIT = "stopped at the cap on events before the horizon; raise max_events (--max-events)"


@dataclass(frozen=True, slots=True)
class Segment:
    """One mode of motion from reduced time `start` to `end`, with its closed-form motion.

    `length` is kept apart: next to a late start the difference of both would round a short slip away.
    """

    motion: Motion
    start: Number
    end: Number
    length: Number

    @property
    def mode(self) -> Mode:
        """Return the mode of the segment."""
        return self.motion.mode


@dataclass(frozen=True, slots=True)
class Event:
    """A change of mode: time t (s), its kind, the modes it joins, and (x1, v1, x2, v2) in SI units."""

    t: Number
    kind: EventKind
    before: Mode
    after: Mode
    y: tuple[Number, Number, Number, Number]
    reduced: ReducedState


@dataclass(frozen=True, slots=True)
class EnergyLedger:
    """Where the energy went, J: initial - final against b int |v1 - v2| dt + a1 int v1^2 dt, each in closed form.

    `residual` = initial - final - friction - viscous: rounding only, and an enclosure of 0 for balls.
    """

    initial: Number
    final: Number
    friction: Number
    viscous: Number
    residual: Number


@dataclass(frozen=True)
class Trajectory:
    """A solved scene, in the words of SciPy's solution objects and with the physics beside them.

    Rows of `y` are x1, v1 (m, m/s) and x2, v2; columns belong to `t` (s): start, events, end. With float64 they are
    float arrays, otherwise object arrays of the arithmetic's numbers (enclosures for balls).
    """

    scene: Scene
    frame: Frame
    segments: Sequence[Segment]
    events: Sequence[Event]
    status: Status
    digits: int | None = None
    """Right decimal digits of every event and of the final state, where they were asked for and reached."""
    bounds: Bounds | None = None
    """What the kernels of float64 and double-double say of their own rounding."""
    tried: str = ""
    """Why the arithmetic was chosen, where `solve` chose it."""

    @property
    def arithmetic(self) -> Arithmetic:
        """Return the arithmetic it was solved in."""
        return self.frame.arithmetic

    @cached_property
    def accuracy(self) -> Accuracy | None:
        """Return the error bounds of a float64 or double-double trajectory, else None (balls carry their own)."""
        from numerics.trajectory.accuracy import kernel_accuracy

        return None if self.bounds is None else kernel_accuracy(self)

    @property
    def message(self) -> str:
        """Return the sentence that says how the solve ended, and whether the phase was lost on the way to the end."""
        if not self.phase_lost:
            return self.status.value
        return (
            f"{self.status.value}; {self.arithmetic.digits} digits keep no phase over the last segment: at the end the "
            "mode and the energy are known, x1, v1, x2 and v2 are not; use --arithmetic ball"
        )

    @property
    def phase_lost(self) -> bool:
        """Return whether the last segment turns through more radians than a point arithmetic has digits for."""
        if self.arithmetic.name == "ball":
            return False
        length, number = self.segments[-1].length, self.arithmetic.to_float
        alive = number(self.frame.two_zeta * length) < 5 * self.arithmetic.digits  # e^(-zeta length) is no rounding yet
        return bool(alive and length > 10 ** (self.arithmetic.digits - 3))

    @property
    def success(self) -> bool:
        """Return whether the horizon was reached."""
        return self.status is not Status.EVENT_LIMIT

    @property
    def modes(self) -> tuple[Mode, ...]:
        """Return the itinerary: the mode of every segment."""
        return tuple(segment.mode for segment in self.segments)

    @property
    def event_kinds(self) -> tuple[EventKind, ...]:
        """Return the kinds of the events in their order."""
        return tuple(event.kind for event in self.events)

    @property
    def final_mode(self) -> Mode:
        """Return the mode at the end: after the last event, where the cap on events ended the run."""
        return self.segments[-1].mode if self.success else self.events[-1].after

    @cached_property
    def final(self) -> ReducedState:
        """Return the reduced state at the end: of the last event, where the cap on events ended the run."""
        if not self.success and self.events:
            return self.events[-1].reduced
        last = self.segments[-1]
        with self.arithmetic.context():
            return last.motion.state(last.length)

    @cached_property
    def t(self) -> NDArray[Any]:
        """Return the times of start, events and end, s, shape (m,)."""
        with self.arithmetic.context():
            taus = [self.segments[0].start, *(segment.end for segment in self.segments)]
            return self._array([self.frame.si_time(tau) for tau in taus])

    @cached_property
    def y(self) -> NDArray[Any]:
        """Return the states at `t`, shape (4, m)."""
        with self.arithmetic.context():
            states = [segment.motion.start for segment in self.segments]
            return self._array([self.frame.si_state(state) for state in [*states, self.final]]).T

    @cached_property
    def energy(self) -> NDArray[Any]:
        """Return the energy at `t`, J, shape (m,), formed from the states."""
        with self.arithmetic.context():
            states = [segment.motion.start for segment in self.segments]
            return self._array([self.frame.energy(state) for state in [*states, self.final]])

    @property
    def t_events(self) -> tuple[NDArray[Any], ...]:
        """Return the event times by kind, in the order of EventKind (entry, exit, crossing), each of shape (k,)."""
        return tuple(self._array([event.t for event in self.events if event.kind is kind]) for kind in EventKind)

    @property
    def y_events(self) -> tuple[NDArray[Any], ...]:
        """Return the event states by kind, each of shape (k, 4)."""
        return tuple(
            self._array([event.y for event in self.events if event.kind is kind]).reshape(-1, 4) for kind in EventKind
        )

    @cached_property
    def ledger(self) -> EnergyLedger:
        """Return the energy ledger of the whole run."""
        with self.arithmetic.context():
            friction = viscous = self.arithmetic.number(0)
            for index, segment in enumerate(self.segments):
                ended = index < len(self.segments) - 1 or not self.success
                losses = segment.motion.whole_losses() if ended else segment.motion.losses(segment.length)
                friction, viscous = friction + losses[0], viscous + losses[1]
            unit = self.frame.critical_energy
            friction, viscous = unit * friction, unit * viscous
            initial, final = self.arithmetic.number(self.scene.energy), self.frame.energy(self.final)
            return EnergyLedger(initial, final, friction, viscous, initial - final - friction - viscous)

    @cached_property
    def sensitivity(self) -> Sensitivity:
        """Return the derivatives of events and final state by initial state and parameters; it solves once more."""
        from numerics.sensitivity.sensitivity import sensitivity

        return sensitivity(self)

    def sol(self, t: Any, side: Side = "right") -> NDArray[Any]:
        """Return (x1, v1, x2, v2) at the time(s) t (s): shape (4,) for a number, (4, n) for a sequence.

        t is exact (int, Fraction, decimal text, or a float taken as its binary value) or a number of the arithmetic,
        such as the time of an event; `side` says which segment answers at an event, where the state is continuous but
        the accelerations jump. Enclosures for balls: where the segment is not decided, both answer. Raises ValueError
        outside [0, end].
        """
        with self.arithmetic.context():
            if np.ndim(t) == 0:
                return self._array(self.frame.si_state(self.reduced(t, side)))
            columns = [self.frame.si_state(self.reduced(one, side)) for one in t]
            return self._array(columns).reshape(-1, 4).T

    def reduced(self, t: Any, side: Side = "right") -> ReducedState:
        """Return the reduced state at time t (s); as `sol`."""
        with self.arithmetic.context():
            time = self._time(t)
            tau = self.frame.rate * time
            found = self._segments_at(time, tau, side)
            states = [self.segments[i].motion.state(tau - self.segments[i].start) for i in found]
            first, *rest = states
            for other in rest:
                first = ReducedState(*(one.union(two) for one, two in zip(first, other, strict=True)))
            return first

    def mode_at(self, t: Any, side: Side = "right") -> Mode:
        """Return the mode at time t (s); at an event the one on the given side."""
        with self.arithmetic.context():
            time = self._time(t)
            found = self._segments_at(time, self.frame.rate * time, side)
            return self.segments[found[0 if side == "left" else -1]].mode

    def _time(self, t: Any) -> Number:
        """Return t as a number of the arithmetic: exact from rationals and floats, its own numbers as they are."""
        number = self.frame.arithmetic.to_float
        end = number(self.frame.si_time(self.segments[-1].end))
        own = type(self.segments[0].start)
        if own is not float and isinstance(t, own):
            if not 0 <= number(t) <= max(end, float(self.scene.until) if self.success else 0.0):
                raise ValueError(f"t = {self.arithmetic.text(t)} s is outside the solved time [0, {end:g}] s")
            return t
        exact = _exact_time(t)
        if not 0 <= exact <= max(self.scene.until if self.success else Fraction(0), Fraction(end)):
            raise ValueError(f"t = {float(exact):g} s is outside the solved time [0, {end:g}] s; solve further")
        return self.arithmetic.number(exact)

    @cached_property
    def _starts(self) -> list[Number]:
        """Start times in s: as rounded as the times of the events, so that an event's own time finds its segments."""
        return [self._middle(self.frame.si_time(segment.start)) for segment in self.segments]

    def _middle(self, x: Number) -> Number:
        """Return x itself, or the midpoint of a ball: a float would not tell the ends of a short slip apart."""
        return x.mid() if self.arithmetic.name == "ball" else x

    def _segments_at(self, time: Number, tau: Number, side: Side) -> Sequence[int]:
        """Return the index of the segment that holds a time (tau: the same, reduced), or all that balls leave open."""
        find = bisect.bisect_right if side == "right" else bisect.bisect_left
        first = last = max(0, find(self._starts, self._middle(time)) - 1)
        if self.arithmetic.name == "ball":
            while first > 0 and self._may_hold(first - 1, tau):
                first -= 1
            while last < len(self.segments) - 1 and self._may_hold(last + 1, tau):
                last += 1
        return range(first, last + 1)

    def _may_hold(self, index: int, tau: Number) -> bool:
        """Return whether it is not excluded that segment `index` holds tau."""
        segment, last = self.segments[index], index == len(self.segments) - 1
        before = self.arithmetic.sign(tau - segment.start) is Sign.NEGATIVE
        after = not last and self.arithmetic.sign(segment.end - tau) is Sign.NEGATIVE
        return not before and not after

    def _array(self, values: Any) -> NDArray[Any]:
        return np.array(values, dtype=float if self.arithmetic.name == "float64" else object)


def _exact_time(t: Any) -> Fraction:
    """Return a time as an exact rational: text as a decimal, a float as its binary value."""
    try:
        if hasattr(t, "as_integer_ratio"):
            return Fraction(*t.as_integer_ratio())
        return Fraction(t if isinstance(t, str) else operator.index(t))
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        raise ValueError(f"t = {str(t)[:40]!r} is not a time in seconds; give a finite number >= 0") from None
