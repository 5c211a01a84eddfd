"""The three modes of motion, and the rules that say which of them follows on the switching surface.

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


class Mode(Enum):
    """A mode of motion; the sign is that of v1 - v2.

    >>> Mode.SLIP_PLUS.sign, Mode.SLIP_MINUS.sign, Mode.STICK.sign, Mode.STICK.value
    (1, -1, 0, 'stick')
    >>> Mode.STICK == "stick", str(Mode.SLIP_PLUS)
    (True, 'slip+')
    """

    SLIP_PLUS = "slip+"
    SLIP_MINUS = "slip-"
    STICK = "stick"

    def __eq__(self, other: object) -> bool:
        """Return whether it is that mode, or its word."""
        return self is other or other == self.value

    def __hash__(self) -> int:
        """Hash it as its word."""
        return hash(self.value)

    def __str__(self) -> str:
        """Return its word."""
        return str(self.value)

    @property
    def sign(self) -> int:
        """Return +1, -1 or 0, the sign of v1 - v2 in this mode."""
        return 0 if self is Mode.STICK else 1 if self is Mode.SLIP_PLUS else -1


MODES = {-1.0: Mode.SLIP_MINUS, 0.0: Mode.STICK, 1.0: Mode.SLIP_PLUS}
"""The modes by the sign of v1 - v2."""


class EventKind(Enum):
    """What happens at an event."""

    ENTRY = "entry"
    """A slip ends in the sliding region: the bodies stick."""
    EXIT = "exit"
    """A stick phase ends on an exit ray: the bodies slip."""
    CROSSING = "crossing"
    """A slip meets the switching surface outside the sliding region and goes on with the other sign."""


def event_kind(gained: int) -> EventKind:
    """Return the kind of an event after which more sticks, or less, or as much."""
    return EventKind.ENTRY if gained > 0 else EventKind.EXIT if gained < 0 else EventKind.CROSSING


def sticking(mode: object) -> int:
    """Return how much sticks in a mode, on a surface a word: the pair, or so many axes of a box."""
    return (mode == Mode.STICK) + str(mode).count("0")
