"""Segments and events of a trajectory, made when they are looked at."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import Telling
from numerics.motion import undamped
from numerics.motion.codes import STICK
from numerics.motion.damped import Start as DampedStart
from numerics.motion.modes import MODES, EventKind, Mode, event_kind
from numerics.motion.records import At, ReducedState
from numerics.motion.tellings import motion_telling


@dataclass(frozen=True, slots=True)
class Segment:
    """One mode of motion from reduced time `start` to `end`, with its closed form.

    `length` is kept apart: next to a late start the difference of both would round a short slip away.
    """

    mode: Mode
    start: Number
    end: Number
    length: Number
    pair: Any
    motion: Any
    """The pair and the start of the motion, as the texts of motion/ know them."""
    telling: Telling

    def state(self, tau: Number) -> ReducedState:
        """Return the state at reduced time tau after the start, by the closed form; in the arithmetic's context."""
        return ReducedState(*self._flow(tau)[:5])

    def losses(self, tau: Number) -> tuple[Number, Number]:
        """Return what friction and viscosity took from E/E_cr up to tau: 2 r int |V1-V2| and 4 zeta int V1^2."""
        found = self._flow(tau)
        return found.spent - self.motion.spent, found.damped - getattr(self.motion, "damped", 0)

    def _flow(self, tau: Number) -> At:
        return self.telling(undamped.flow)(self.pair, self.motion, tau)


@dataclass(frozen=True, slots=True)
class Event:
    """A change of mode: time t (s), its kind, the modes it joins, and (x1, v1, x2, v2) in SI units.

    `cause`: "guard", a velocity or a load got there; or "jump", of the force or of b.
    """

    t: Number
    kind: EventKind
    before: Mode
    after: Mode
    y: tuple[Number, Number, Number, Number]
    reduced: ReducedState
    cause: str = "guard"


@dataclass(frozen=True, slots=True)
class EnergyLedger:
    """Where the energy went, J: initial - final against b int |v1 - v2| dt + a1 int v1^2 dt, each in closed form.

    `work` is what a force has put in, int u v1 dt. `residual` = initial + work - final - friction - viscous: rounding
    only, and an enclosure of 0 for balls.
    """

    initial: Number
    final: Number
    friction: Number
    viscous: Number
    residual: Number
    work: Number = 0

    def times(self, factor: Number) -> EnergyLedger:
        """Return the ledger in another unit of energy."""
        parts = self.initial, self.final, self.friction, self.viscous, self.residual, self.work
        return EnergyLedger(*(factor * one for one in parts))


def segment_of(trajectory: Any, index: int) -> Segment:
    """Return a segment of a trajectory; the last one, after all events, ends at the horizon."""
    record, arithmetic, is_damped = trajectory.record, trajectory.arithmetic, trajectory.scene.pair.a1 > 0
    start = record.number(index - 1, "tau") if index else arithmetic.number(0)
    with_event = index < len(record)
    end = record.number(index, "tau") if with_event else record.end("tau")
    length = record.number(index, "length") if with_event else record.end("length")
    motion = _motion_after(trajectory, index - 1) if index else trajectory.begun.start
    telling = motion_telling(arithmetic.telling, is_damped=is_damped)
    return Segment(MODES[trajectory.signs[index]], start, end, length, trajectory.begun.pair, motion, telling)


def _motion_after(trajectory: Any, index: int) -> Any:
    """Return the start of the motion that an event starts."""
    record, zero = trajectory.record, trajectory.arithmetic.number(0)
    X, V, Z, w, tau, gap, push = (record.number(index, name) for name in ("X", "V", "Z", "w", "tau", "gap", "push"))
    kind, side = int(record.code(index, "kind")), record.code(index, "side")
    if trajectory.scene.pair.a1 > 0:
        return DampedStart(kind, X, V, V, Z, w, True, False, tau, zero, zero, zero)
    return undamped.Start(kind, side, X, zero, gap, push, zero if kind == STICK else push, True, Z, w, tau, zero, zero)


def event_of(trajectory: Any, index: int) -> Event:
    """Return an event of a trajectory."""
    before, after = (MODES[sign] for sign in trajectory.signs[index : index + 2])
    X, V, Z, w = (trajectory.record.number(index, name) for name in ("X", "V", "Z", "w"))
    t, (x1, v1, x2, v2) = trajectory.event_times[index], trajectory.event_states[:, index]
    if trajectory.arithmetic.name == "float64":
        t, x1, v1, x2, v2 = map(float, (t, x1, v1, x2, v2))
    return Event(t, event_kind(before, after), before, after, (x1, v1, x2, v2), ReducedState(X, V, V, Z, w))
