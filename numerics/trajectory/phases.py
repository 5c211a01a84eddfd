"""A motion from one phase to the next, over points and over intervals of mpmath: its events in sure bounds."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpmath.ctx_iv import MPIntervalContext
from mpmath.ctx_mp import MPContext

from numerics.linear.modes import Mode
from numerics.scene import Pair
from numerics.trajectory.closed_forms import ClosedForms, State, Value, Wave
from numerics.trajectory.spells import Spell


class TooCoarse(Exception):
    """The boxes have grown too large: more bits are needed."""


class Forms:
    """The closed forms of a pair in a spell, over points with twice as many bits as over intervals."""

    def __init__(self, pair: Pair, most: int) -> None:
        """Compute with so many bits at most."""
        self.pair, self.bits, self.points, self.boxes = pair, most, MPContext(), MPIntervalContext()
        self.points.prec, self.boxes.prec = 2 * most, most

    def begin(self, spell: Spell) -> None:
        """Begin a spell."""
        self.spell = spell
        self.sharp, self.wide = (ClosedForms(on, self.pair, spell) for on in (self.points, self.boxes))

    def narrow(self, bits: int) -> None:
        """Compute over intervals with no more bits than these."""
        self.bits = self.boxes.prec = min(self.bits, bits)


@dataclass
class Run:
    """Where a motion is: at a point, and surely in a box."""

    forms: Forms
    at_points: State
    at: State

    @classmethod
    def start(cls, forms: Forms, numbers: tuple[Fraction, ...]) -> Run:
        """Return the run from an exact state: t, x1, v1, x2, v2."""
        return cls(forms, *(State(*map(of.number, numbers)) for of in (forms.sharp, forms.wide)))

    def guards(self, mode: Mode, k: int) -> tuple[Wave, Wave]:
        """Return what is positive until a phase ends, over points and over intervals."""
        sharp, wide = self.forms.sharp, self.forms.wide
        if mode is Mode.STICK:
            return sharp.grip(k, self.at_points), wide.grip(k, self.at)
        return sharp.guard(k, self.at_points), wide.guard(k, self.at)

    def hit(self, mode: Mode, k: int, time: float, places: int) -> tuple[Fraction, Fraction]:
        """Go to the next event, near the time; return bounds of the time since, to so many places, or TooCoarse."""
        sharp, wide = self.forms.sharp, self.forms.wide
        low, high = self._bracket(time - float(self.at_points.t), places, *self.guards(mode, k))
        between = self.forms.boxes.mpf([wide.number(low).a, wide.number(high).b])
        self.at_points = moved(sharp, mode, k, self.at_points, sharp.number((low + high) / 2), ends=True)
        self.at = moved(wide, mode, k, self.at, between, ends=True)
        return low, high

    def rest(self, mode: Mode, time: Fraction) -> tuple[Fraction, Value]:
        """Go on in a mode to a time; return for how long it surely lasts, and v1 - v2 then. Raises TooCoarse."""
        sharp, wide = self.forms.sharp, self.forms.wide
        left = wide.number(time) - self.at.t
        if not left > 0:  # the last event may be at the end
            raise TooCoarse
        least = outward(left, int(self.forms.bits * 0.3))[1]
        signs = (1, -1) if mode is Mode.STICK else (mode.sign,)
        guards = [self.guards(mode, k)[1] for k in signs]
        if not all(guard(wide.number(least)) > 0 for guard in guards):
            raise TooCoarse
        relative = mode.sign * guards[0](left)
        since = sharp.number(time) - self.at_points.t
        self.at_points = moved(sharp, mode, mode.sign, self.at_points, since, ends=False)
        self.at = moved(wide, mode, mode.sign, self.at, left, ends=False)._replace(t=wide.number(time))
        return least, relative

    def _bracket(self, guess: float, shown: int, sharp: Wave, wide: Wave) -> tuple[Fraction, Fraction]:
        """Return decimals around the root of a falling wave, sure for every state of the boxes."""
        points, number = self.forms.points, self.forms.wide.number
        slope, root = sharp.slope(), points.mpf(guess)
        for _ in range(60):
            step = sharp(root) / slope(root)
            root -= step
            if abs(step) < abs(root) * points.mpf(2) ** (-1.8 * self.forms.bits):
                break
        places = int(self.forms.bits * 0.301) - math.floor(math.log10(guess))
        centre, steps = int(points.nint(root * points.mpf(10) ** places)), 1
        while True:
            if Fraction(steps, 10**places) > Fraction(1, 10**shown):
                raise TooCoarse
            low, high = (Fraction(centre + by, 10**places) for by in (-steps, steps))
            if wide(number(low)) > 0 and wide(number(high)) < 0:
                spare = Fraction((steps + 7) // 8, 10**places)  # the kernel's bounds are not these to the last bit
                return low - spare, high + spare
            steps += (steps + 3) // 4


def moved(forms: ClosedForms, mode: Mode, k: int, at: State, u: Value, *, ends: bool) -> State:
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
