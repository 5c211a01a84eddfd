"""The three modes of motion, and the one place where it is decided which of them follows on the switching surface.

With P = (a2 x1 + a1 v1)/(a2 L), L = b (m1+m2)/(a2 m2), the sliding region S0 is |P| <= 1 (P = X for a1 = 0).
Rules at v1 = v2, reading `filippov`; dP/dt is taken along the stick flow:

    |P| < 1                          stick (both fields push towards the surface)
    P > 1                            slip- (both fields point to v1 < v2); P < -1: slip+
    P = 1 and dP/dt > 0              slip-, the state is on the exit ray; P = -1 and dP/dt < 0: slip+
    P = +-1 otherwise                stick: the pair turns back into S0 (dP/dt = 0 is the tangent orbit E = E_cr)

Reading `three-valued-sgn`: always stick. At the first instant these rules act on exact rationals, so ties are decided.
"""

from __future__ import annotations

from enum import Enum
from fractions import Fraction

from numerics.arithmetic.protocol import Arithmetic, Number, decide_sign
from numerics.scene import Law, Scene


class Mode(Enum):
    """A mode of motion; the sign is that of v1 - v2."""

    SLIP_PLUS = "slip+"
    SLIP_MINUS = "slip-"
    STICK = "stick"

    @property
    def sign(self) -> int:
        """Return +1, -1 or 0, the sign of v1 - v2 in this mode."""
        return 0 if self is Mode.STICK else 1 if self is Mode.SLIP_PLUS else -1


class EventKind(Enum):
    """What happens at an event."""

    ENTRY = "entry"
    """A slip ends in the sliding region: the bodies stick."""
    EXIT = "exit"
    """A stick phase ends on an exit ray: the bodies slip."""
    CROSSING = "crossing"
    """A slip meets the switching surface outside the sliding region and goes on with the other sign."""


def slip_mode(sign: int) -> Mode:
    """Return the slip mode in which v1 - v2 has this sign (+1 or -1)."""
    return Mode.SLIP_PLUS if sign > 0 else Mode.SLIP_MINUS


def mode_at_start(scene: Scene) -> Mode:
    """Return the mode that follows the initial state of a scene; exact, every tie decided by the rules above."""
    pair, at = scene.pair, scene.initial
    if at.v1 != at.v2:
        return slip_mode(_sign(at.v1 - at.v2))
    if scene.law is Law.THREE_VALUED_SGN:
        return Mode.STICK
    load = (pair.a2 * at.x1 + pair.a1 * at.v1) / (pair.a2 * pair.half_width)
    side = _sign(load)
    leaving = side * (pair.mass * at.v1 - pair.a1 * pair.half_width * load)  # dP/dt > 0 up to a positive factor
    if abs(load) > 1 or (abs(load) == 1 and leaving > 0):
        return slip_mode(-side)
    return Mode.STICK


def mode_after_contact(arithmetic: Arithmetic, law: Law, sign: int, beyond: Number, leaving: Number) -> Mode:
    """Return the mode after a slip of this sign has met the surface.

    beyond = sign P - 1: how far past the far edge of S0 the contact lies (a slip of sign s can only land at s P > -1).
    leaving = sign dP/dt, which breaks the tie at beyond = 0. Raises EventUndecided if the sign is not proven.
    """
    if law is Law.THREE_VALUED_SGN:
        return Mode.STICK
    outside = decide_sign(arithmetic, beyond, "does the slip end inside the sliding region, or cross beyond its edge?")
    if outside == 0:
        outside = decide_sign(arithmetic, leaving, "does the pair leave the edge of the sliding region at once?")
    return slip_mode(-sign) if outside > 0 else Mode.STICK


def event_kind(before: Mode, after: Mode) -> EventKind:
    """Return the kind of the event that joins two modes."""
    if after is Mode.STICK:
        return EventKind.ENTRY
    return EventKind.EXIT if before is Mode.STICK else EventKind.CROSSING


def _sign(value: Fraction) -> int:
    return (value > 0) - (value < 0)
