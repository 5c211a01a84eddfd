"""A motion from one phase to the next, over intervals of mpmath: its events in sure bounds."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from numerics.linear.modes import Mode
from numerics.trajectory.closed_forms import Forms, State, TooCoarse, Unseen, Value, Wave


class Known(NamedTuple):
    """What is known of a state beside bounds: a contact, and with k the edge at which a stick has ended."""

    touches: bool
    k: int = 0


@dataclass
class Run:
    """Where a motion surely is: in a box."""

    forms: Forms
    at: State
    known: Known

    @classmethod
    def start(cls, forms: Forms, numbers: tuple[Fraction, ...], k: int = 0) -> Run:
        """Return the run from an exact state, t, x1, v1, x2, v2; with k at the edge towards a slip of that sign."""
        return cls(forms, State(*map(forms.number, numbers)), Known(numbers[2] == numbers[4], k))

    @property
    def time(self) -> float:
        """Return about when it is there, s."""
        return float(self.at.t.mid)

    def _keeps(self, mode: Mode, k: int, wave: Wave, end: Fraction) -> None:
        """See that what is positive in a mode is so until an end."""
        at_edge = self.known.k == k
        zeros = at_edge if mode is Mode.STICK else self.known.touches * (1 + at_edge)
        self.forms.keeps(wave, int(zeros), end)

    def guard(self, mode: Mode, k: int) -> Wave:
        """Return what is positive until a phase ends."""
        return self.forms.guard(mode, k, self.at)

    def hit(self, mode: Mode, k: int, time: float, places: int) -> tuple[Fraction, Fraction]:
        """Go to the next event, near the time; return bounds of the time since, to so many places, or TooCoarse."""
        guard = self.guard(mode, k)
        if mode is not Mode.STICK and self.known.k not in (0, k):
            raise Unseen
        low, high = self._bracket(time - self.time, places, guard)
        self._keeps(mode, k, guard, low)
        if mode is Mode.STICK:
            self._keeps(mode, -k, self.guard(mode, -k), high)
        between = self.forms.hull(low, high)
        self.at = moved(self.forms, mode, k, self.at, between, ends=True)
        self.known = Known(touches=True, k=k if mode is Mode.STICK else 0)
        return low, high

    def rest(self, mode: Mode, time: Fraction) -> tuple[Fraction, Value]:
        """Go on in a mode to a time; return for how long it surely lasts, and v1 - v2 then. Raises TooCoarse."""
        number = self.forms.number
        left = number(time) - self.at.t
        if not left > 0:  # the last event may be at the end
            raise TooCoarse
        least = outward(left, int(self.forms.bits * 0.3))[1]
        signs = ends_of(mode)
        guards = [self.guard(mode, k) for k in signs]
        if not all(guard(number(least)) > 0 for guard in guards):
            raise TooCoarse
        for k, guard in zip(signs, guards, strict=True):
            self._keeps(mode, k, guard, least)
        relative = mode.sign * guards[0](left)
        self.at = moved(self.forms, mode, mode.sign, self.at, left, ends=False)._replace(t=number(time))
        self.known = Known(touches=mode is Mode.STICK)
        return least, relative

    def _bracket(self, guess: float, shown: int, guard: Wave) -> tuple[Fraction, Fraction]:
        """Return decimals around the root of a falling wave, sure for every state of the box."""
        number, slope, root = self.forms.number, guard.slope(), Fraction(guess)
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


def moved(forms: Forms, mode: Mode, k: int, at: State, u: Value, *, ends: bool) -> State:
    """Return the state a time later; both velocities are equal where a mode ends."""
    t = at.t + u
    if mode is Mode.STICK:
        path = forms.stuck(at)
        x1, v1 = path(u), path.slope()(u)
        return State(t, forms.edge(k, t, v1) if ends else x1, v1, at.x2 + (x1 - at.x1), v1)
    path, v2 = forms.slide(k, at), forms.driven(k, at.v2, u)
    return State(t, path(u), v2 if ends else path.slope()(u), at.x2 + (at.v2 + v2) / 2 * u, v2)


def outward(box: Any, places: int) -> tuple[Fraction, Fraction]:
    """Return decimals with so many places around an interval."""
    low, high = (Fraction((-1) ** sign * int(man)) * Fraction(2) ** exponent for sign, man, exponent, _ in box._mpi_)
    unit = Fraction(10) ** places
    return math.floor(low * unit) / unit, math.ceil(high * unit) / unit
