"""One motion after the other, outside the loop: for maps that stop at an event of their own choice."""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.float64 import clock, finite
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.arithmetic.telling import text
from numerics.motion.codes import OUT_OF_RANGE, RAY, STUCK
from numerics.motion.modes import MODES, Mode
from numerics.motion.records import ReducedState
from numerics.motion.tellings import motion_telling
from numerics.motion.undamped import arrive, flow, follow, locate, mode_of, on_ray
from numerics.run.one import left_range


@text
def onward(pair: Any, start: Any, end: Any, duration: Number) -> tuple[Any, bool]:
    """Return the start of the motion that follows, and whether its numbers are finite."""
    tau, rest = clock(start.tau, start.rest, duration)
    after = follow(pair, start, arrive(pair, start, end, duration), duration, tau, rest)
    return after, finite(after.w)


class Walk:
    """A pair in a mode of motion, which `start` describes, in one arithmetic and its context.

    Raises EventUndecided and OutOfRange, each for what is asked.
    """

    def __init__(self, arithmetic: Arithmetic, pair: Any, start: Any = None, *, is_damped: bool = False) -> None:
        """Begin with the start of a motion, as motion/begin.py has it; or with `leave_by`."""
        self.arithmetic, self.pair, self.start, self.is_damped = arithmetic, pair, start, is_damped
        self._told = motion_telling(arithmetic.telling, is_damped=is_damped)
        self._located: tuple[Any, Any] | None = None

    def leave_by(self, side: float, w: Number, tau: Number) -> None:
        """Put the pair on an exit ray with excess w > 0 at the reduced time tau; a1 = 0."""
        zero = self.arithmetic.number(0)
        self._put(self._told(on_ray)(self.pair, side, zero, w, tau, zero, zero))

    def _put(self, start: Any) -> None:
        self.start, self._located = start, None

    @property
    def mode(self) -> Mode:
        """Return the mode of motion."""
        return MODES[self._told(mode_of)(self.start)]

    @property
    def on_ray(self) -> bool:
        """Return whether the motion is a slip that left S0 by an exit ray, a1 = 0."""
        return not self.is_damped and self.start.kind == RAY

    def duration(self) -> Number | None:
        """Return the reduced time to the next event, None if there is none."""
        return self._locate()[0]

    def _locate(self) -> tuple[Any, Any]:
        if self._located is None:
            how, duration, end = self._told(locate)(self.pair, self.start)
            if how == OUT_OF_RANGE:
                raise left_range(self.arithmetic, self.is_damped)
            self._located = (None if how == STUCK else duration), end
        return self._located

    def go_on(self) -> None:
        """Go on to the motion after the next event."""
        duration, end = self._locate()
        after, sound = self._told(onward)(self.pair, self.start, end, duration)
        if not sound:
            raise left_range(self.arithmetic, self.is_damped)
        self._put(after)

    def state(self, tau: Number) -> ReducedState:
        """Return the state at the reduced time tau, in this motion."""
        return ReducedState(*self._told(flow)(self.pair, self.start, tau - self.start.tau)[:5])
