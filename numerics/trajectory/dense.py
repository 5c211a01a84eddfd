"""A trajectory at any time: which segment holds it, and that segment's closed form."""

from __future__ import annotations

import bisect
import operator
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any, Literal

from numerics.arithmetic.protocol import Number, Sign
from numerics.motion.modes import Mode
from numerics.motion.records import ReducedState

Side = Literal["left", "right"]


class Dense:
    """The dense evaluation of one trajectory; to be used in its arithmetic's context."""

    def __init__(self, trajectory: Any) -> None:
        """Evaluate this trajectory."""
        self._of, self._arithmetic = trajectory, trajectory.arithmetic

    def state(self, t: Any, side: Side) -> ReducedState:
        """Return the reduced state at time t (s)."""
        time = self.time(t)
        tau = self._of.units[1] * time
        segments = self._of.segments
        states = [segments[i].state(tau - segments[i].start) for i in self._segments_at(time, tau, side)]
        first, *rest = states
        for other in rest:
            first = ReducedState(*(one.union(two) for one, two in zip(first, other, strict=True)))
        return first

    def mode(self, t: Any, side: Side) -> Mode:
        """Return the mode at time t (s); at an event the one on the given side."""
        time = self.time(t)
        found = self._segments_at(time, self._of.units[1] * time, side)
        modes: tuple[Mode, ...] = self._of.modes
        return modes[found[0 if side == "left" else -1]]

    def time(self, t: Any) -> Number:
        """Return t as a number of the arithmetic: exact from rationals and floats, its own numbers as they are."""
        number, until = self._arithmetic.to_float, self._of.scene.until if self._of.reached else Fraction(0)
        end, own = number(self._of.end_time), type(self._of.end_time)
        if own is not float and isinstance(t, own):
            if not 0 <= number(t) <= max(end, float(until)):
                raise ValueError(f"t = {self._arithmetic.text(t)} s is outside the solved time [0, {end:g}] s")
            return t
        exact = exact_time(t)
        if not 0 <= exact <= max(until, Fraction(end)):
            raise ValueError(f"t = {float(exact):g} s is outside the solved time [0, {end:g}] s; solve further")
        return self._arithmetic.number(exact)

    @cached_property
    def _starts(self) -> list[Number]:
        """Start times in s: as rounded as the times of the events, so that an event's own time finds its segments."""
        times = self._of.event_times.tolist()
        return [self._middle(time) for time in [self._arithmetic.number(0), *times][: len(self._of.segments)]]

    def _middle(self, x: Number) -> Number:
        """Return x itself, or the midpoint of a ball: a float would not tell the ends of a short slip apart."""
        return x.mid() if self._arithmetic.name == "ball" else x

    def _segments_at(self, time: Number, tau: Number, side: Side) -> Sequence[int]:
        """Return the index of the segment that holds a time (tau: the same, reduced), or all that balls leave open."""
        find = bisect.bisect_right if side == "right" else bisect.bisect_left
        first = last = max(0, find(self._starts, self._middle(time)) - 1)
        if self._arithmetic.name == "ball":
            while first > 0 and self._may_hold(first - 1, tau):
                first -= 1
            while last < len(self._of.segments) - 1 and self._may_hold(last + 1, tau):
                last += 1
        return range(first, last + 1)

    def _may_hold(self, index: int, tau: Number) -> bool:
        """Return whether it is not excluded that segment `index` holds tau."""
        segment, last = self._of.segments[index], index == len(self._of.segments) - 1
        before = self._arithmetic.sign(tau - segment.start) is Sign.NEGATIVE
        after = not last and self._arithmetic.sign(segment.end - tau) is Sign.NEGATIVE
        return not before and not after


def exact_time(t: Any) -> Fraction:
    """Return a time as an exact rational: text as a decimal, a float as its binary value."""
    try:
        if hasattr(t, "as_integer_ratio"):
            return Fraction(*t.as_integer_ratio())
        return Fraction(t if isinstance(t, str) else operator.index(t))
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        raise ValueError(f"t = {str(t)[:40]!r} is not a time in seconds; give a finite number >= 0") from None
