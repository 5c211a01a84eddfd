"""One motion after the other, in plain Python: runs in mpmath and balls, and maps that stop where they choose."""

from __future__ import annotations

from numerics.arithmetic.functions import clock, finite
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.arithmetic.questions import QUESTIONS, SIDE_OF_ZERO
from numerics.errors import EventUndecided, OutOfRange
from numerics.free.motion import (
    OUT_OF_RANGE,
    RAY,
    STUCK,
    Parameters,
    Start,
    mode_of,
    next_event,
    resolve,
)
from numerics.linear.modes import MODES, Mode


class Walk:
    """A pair in a mode of motion, which `start` describes, in one arithmetic and its context.

    Raises EventUndecided and OutOfRange, each for what is asked.
    """

    duration: Number | None
    """The reduced time to the next event, None if there is none."""

    def __init__(self, arithmetic: Arithmetic, at: Parameters, start: Start) -> None:
        """Begin with a motion (start.begin), or on a ray (motion.on_ray)."""
        self.arithmetic, self.at = arithmetic, at
        self.put(start)

    def put(self, start: Start) -> None:
        """Put the pair where a motion starts, and locate the event that ends it."""
        how, duration, self._end = next_event(self.at, start)
        if how == OUT_OF_RANGE:
            raise left_range(self.arithmetic)
        self.start, self.duration = start, None if how == STUCK else duration

    @property
    def mode(self) -> Mode:
        """Return the mode of motion."""
        return MODES[mode_of(self.start)]

    @property
    def on_ray(self) -> bool:
        """Return whether the motion is a slip that left S0 by an exit ray."""
        return self.start.kind == RAY

    def go_on(self) -> None:
        """Go on to the motion after the next event."""
        tau, rest = clock(self.start.tau, self.start.rest, self.duration)
        after = resolve(self.at, self.start, self._end, tau, rest)
        if not finite(after.w):
            raise left_range(self.arithmetic)
        self.put(after)


def left_range(arithmetic: Arithmetic) -> Exception:
    """Return what says that a number left the range, or that balls know nothing of one any more."""
    if arithmetic.name == "ball":
        return EventUndecided(QUESTIONS[SIDE_OF_ZERO], "a number that is not finite", arithmetic.digits)
    return OutOfRange(
        f"a number of this scene left the range of {arithmetic.name} on the way, or one slip turns through an angle "
        f'that {arithmetic.digits} digits do not resolve; use arithmetic="ball"'
    )
