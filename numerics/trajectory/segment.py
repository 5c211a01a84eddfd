"""Segments and events of a trajectory, made when they are looked at."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import Telling
from numerics.motion import undamped
from numerics.motion.modes import EventKind, Mode
from numerics.motion.records import At, ReducedState


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
