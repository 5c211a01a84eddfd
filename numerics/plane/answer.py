"""What a run on a surface finds: states, events and the motion, as enclosures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.linear.modes import EventKind, event_kind, sticking
from numerics.plane.system import SPARE_BITS
from numerics.scene.short_repr import ShortRepr

Numbers = tuple[arb, ...]


class PlaneState(NamedTuple):
    """x1, v1, x2, v2, (n,) each: m, m/s; rad, rad/s on the axis phi."""

    x1: Numbers
    v1: Numbers
    x2: Numbers
    v2: Numbers


class Working(Ball):
    """Balls that keep the bits of the path and of its defects."""

    def __init__(self, digits: int) -> None:
        """Fix the working digits."""
        super().__init__(digits)
        self.bits += SPARE_BITS


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
        return event_kind(sticking(self.after) - sticking(self.before))
