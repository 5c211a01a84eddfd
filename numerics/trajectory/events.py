"""What a trajectory consists of: segments in one mode, and the events between them."""

from __future__ import annotations

from dataclasses import dataclass, field

from numerics.arithmetic.protocol import Number
from numerics.free.frame import ReducedState
from numerics.linear.modes import EventKind, Mode
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.dense import Dense
from numerics.trajectory.ledger import losses_of_rows


@dataclass(frozen=True, slots=True, repr=False)
class Event(ShortRepr):
    """A change of mode: time t (s), its kind, the modes it joins, and (x1, v1, x2, v2) in SI units.

    `cause`: "guard", a velocity or a load got there; or "jump", of the force or of b.
    """

    t: Number
    kind: EventKind
    before: Mode
    after: Mode
    y: tuple[Number, Number, Number, Number]
    reduced: ReducedState = field(repr=False)
    cause: str = "guard"


@dataclass(frozen=True, slots=True, repr=False)
class Segment(ShortRepr):
    """One mode of motion from `start` to `end` (s); u and b may jump in it.

    `length` (s) is kept apart: next to a late start the difference of both would round a short slip away.
    """

    mode: Mode
    start: Number
    end: Number
    length: Number
    rows: range = field(repr=False)
    dense: Dense = field(repr=False, compare=False)

    def state(self, since: Number) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) at `since` (s) after the start, m and m/s; in the arithmetic's context."""
        return self.dense.after(self.rows, since)

    def losses(self) -> tuple[Number, Number]:
        """Return what friction and viscosity take in it, b int |v1 - v2| and a1 int v1^2, J."""
        friction, viscous, _ = losses_of_rows(self.dense, self.rows).sum(axis=1)
        return friction, viscous
