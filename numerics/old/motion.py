"""What the loop needs of a motion: where it is, when it ends, what follows."""

from __future__ import annotations

from typing import Protocol

from numerics.arithmetic.protocol import Number
from numerics.motion.frame import ReducedState
from numerics.motion.modes import Mode


class Motion(Protocol):
    """One mode of motion from a given start, in reduced coordinates; exact, approximate or enclosed as its numbers."""

    mode: Mode
    start: ReducedState

    def duration(self) -> Number | None:
        """Return the reduced time until the mode ends, None if it never does. Raises EventUndecided."""

    def state(self, tau: Number) -> ReducedState:
        """Return the state at reduced time tau after the start, by the closed form."""

    def losses(self, tau: Number) -> tuple[Number, Number]:
        """Return what friction and viscosity took from E/E_cr up to tau: 2 r int |V1-V2| and 4 zeta int V1^2."""

    def whole_losses(self) -> tuple[Number, Number]:
        """Return the losses of the motion from its start to its end."""

    def successor(self) -> Motion:
        """Return the motion that follows when this one ends. Raises EventUndecided."""
