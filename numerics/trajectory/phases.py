"""A motion from one phase to the next, over intervals of mpmath: its events in sure bounds."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from numerics.linear.modes import Mode
from numerics.trajectory.closed_forms import Forms, State, TooCoarse, Unseen, Value, Wave, hull, number


@dataclass
class Run:
    """Where a motion surely is: in a box, in contact or not; with k at the edge at which a stick has ended."""

    forms: Forms
    at: State
    touches: bool
    k: int = 0

    @classmethod
    def start(cls, forms: Forms, numbers: tuple[Fraction, ...], k: int = 0) -> Run:
        """Return the run from an exact state, t, x1, v1, x2, v2; with k at the edge towards a slip of that sign."""
        return cls(forms, State(*map(number, numbers)), numbers[2] == numbers[4], k)

    @property
    def time(self) -> float:
        """Return about when it is there, s."""
        return float(self.at.t.mid)

    def _keeps(self, mode: Mode, k: int, wave: Wave, end: Fraction) -> None:
        """See that what is positive in a mode is so until an end."""
        at_edge = self.k == k
        self.forms.keeps(wave, at_edge if mode is Mode.STICK else self.touches * (1 + at_edge), end)

    def guard(self, mode: Mode, k: int) -> Wave:
        """Return what is positive until a phase ends."""
        return self.forms.guard(mode, k, self.at)

    def hit(self, mode: Mode, k: int, time: float, places: int) -> tuple[Fraction, Fraction]:
        """Go to the next event, near the time; return bounds of the time since, to so many places, or TooCoarse."""
        guard = self.guard(mode, k)
        if mode is not Mode.STICK and self.k not in (0, k):
            raise Unseen
        low, high = self._bracket(time - self.time, places, guard)
        self._keeps(mode, k, guard, low)
        if mode is Mode.STICK:
            self._keeps(mode, -k, self.guard(mode, -k), high)
        self.at = self.forms.moved(mode, self.at, hull(low, high), ends=k)
        self.touches, self.k = True, k if mode is Mode.STICK else 0
        return low, high

    def rest(self, mode: Mode, time: Fraction) -> tuple[Fraction, Value]:
        """Go on in a mode to a time; return for how long it surely lasts, and v1 - v2 then. Raises TooCoarse."""
        left = number(time) - self.at.t
        if not left > 0:  # the last event may be at the end
            raise TooCoarse
        least = outward(left, int(self.forms.bits * 0.3))[1]
        guards = {k: self.guard(mode, k) for k in ends_of(mode)}
        if not all(guard(number(least)) > 0 for guard in guards.values()):
            raise TooCoarse
        for k, guard in guards.items():
            self._keeps(mode, k, guard, least)
        relative = mode.sign * guards[mode.sign or 1](left)
        self.at = self.forms.moved(mode, self.at, left)._replace(t=number(time))
        self.touches, self.k = mode is Mode.STICK, 0
        return least, relative

    def _bracket(self, guess: float, shown: int, guard: Wave) -> tuple[Fraction, Fraction]:
        """Return decimals around the root of a falling wave, sure for every state of the box."""
        slope, root = guard.slope(), Fraction(guess)
        places = int(self.forms.bits * 0.301) - math.floor(math.log10(guess))
        for _ in range(60):
            value = guard(number(root))
            root -= sum(outward(value.mid / slope(number(root)).mid, places), Fraction(0)) / 2
            if 0 in value:
                break
        unit, steps = Fraction(10) ** -places, 1
        centre = round(root / unit)
        while True:
            low, high = ((centre + by) * unit for by in (-steps, steps))
            spare = (steps + 7) // 8 * unit  # the kernel's bounds are not these to the last bit
            if low <= spare or steps * unit > Fraction(10) ** -shown:
                raise TooCoarse
            if guard(number(low)) > 0 and guard(number(high)) < 0:
                return low - spare, high + spare
            steps += (steps + 3) // 4


def ends_of(mode: Mode) -> tuple[int, ...]:
    """Return the signs of the guards that may end a mode."""
    return (mode.sign,) if mode.sign else (1, -1)


def outward(box: Any, places: int) -> tuple[Fraction, Fraction]:
    """Return decimals with so many places around an interval."""
    low, high = (Fraction((-1) ** sign * int(man)) * Fraction(2) ** exponent for sign, man, exponent, _ in box._mpi_)
    unit = Fraction(10) ** places
    return math.floor(low * unit) / unit, math.ceil(high * unit) / unit
