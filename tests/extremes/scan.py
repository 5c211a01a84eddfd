"""brute_force.py at any precision: the SI-unit scan, sharpened where an extreme scene would escape its step.

Three things are added, each from the equation of motion alone: steps small enough for a slip that starts at a double
root with a tiny slope, a look at the guard's minima between steps (grazes), and a jump over the part of a long slip
in which |v1 - v2| is too large for the spring to matter.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction

import brute_force
import mpmath
from brute_force import BruteForce, number
from mpmath import mpf

from numerics.scene import Scene

PRINTED = 60


@contextmanager
def working_digits(digits: int) -> Iterator[None]:
    """Compute, and break ties, with this many digits."""
    before, brute_force.DIGITS = brute_force.DIGITS, digits
    try:
        with mpmath.workdps(digits):
            yield
    finally:
        brute_force.DIGITS = before


class Scan(BruteForce):
    """The scan; its first step after a double root is 10^-smallest of the ordinary one."""

    def __init__(self, scene: Scene, smallest: int = 40):
        super().__init__(scene)
        self.smallest = smallest

    def times(self, mass, end, from_zero):
        later = iter(super().times(mass, end, from_zero))
        first = next(later)
        if from_zero and self.smallest > 40:
            early = first * mpf(10) ** (40 - self.smallest)
            while early < min(first, end):
                yield early
                early *= mpf(7) / 6
        yield first
        yield from later

    def slip_end(self, line, sign, gain, v2, end, on_surface):
        def guard(t):
            return sign * (line.speed(t) - v2 - gain * t)

        if on_surface:
            return self.first_fall(guard, self.m1, end, True)
        wait = self.certain_wait(line, sign, gain, v2)
        if wait > end:
            return None
        previous = wait
        for step in self.times(self.m1, end - wait, False):
            t = wait + step
            low = self.minimum(line, sign, gain, previous, t)
            for right in (low, t):
                if right is not None and guard(right) <= 0:
                    return self.bisect(guard, previous, right)
            previous = t
        return None

    def certain_wait(self, line, sign, gain, v2):
        """A time before which s (v1 - v2) > 0, as |v1| of an undamped body 1 never exceeds its amplitude."""
        if self.a1 > 0:
            return mpf(0)
        y, v = line.position(mpf(0)) - line.rest, line.speed(mpf(0))
        amplitude = mpmath.sqrt(v * v + self.a2 / self.m1 * y * y)
        return max(mpf(0), (-sign * v2 - amplitude) / abs(gain) * (1 - mpf(10) ** -30))

    def minimum(self, line, sign, gain, left, right):
        """The local minimum of the guard between two scan times, if there is one."""

        def fall(t):
            force = self.a1 * line.speed(t) + self.a2 * line.position(t) + self.b * sign
            return sign * (force / self.m1 + gain)

        return self.bisect(fall, left, right) if fall(left) > 0 >= fall(right) else None

    @staticmethod
    def bisect(function, low, high):
        """Ten bisections, then the Illinois method (the end that stays twice is halved), to any precision."""
        f_low, f_high, stayed = function(low), function(high), 0
        for n in range(1000):
            if f_high == 0 or abs(high - low) < mpf(10) ** (3 - brute_force.DIGITS) * high:
                break
            middle = (low + high) / 2 if n < 10 else high - f_high * (high - low) / (f_high - f_low)
            value = function(middle)
            if value > 0:
                low, f_low, f_high = middle, value, f_high / 2 if stayed > 0 else f_high
                stayed = 1
            else:
                high, f_high, f_low = middle, value, f_low / 2 if stayed < 0 else f_low
                stayed = -1
        return high

    def stick_end(self, line, end):
        """An undamped pair with E <= E_cr never leaves S0: nothing to scan. An exit comes before an extremum of the
        load that may lie beyond the horizon: the scan goes on up to it."""
        if self.a1 == 0:
            x, v = line.position(mpf(0)), line.speed(mpf(0))
            energy, critical = self.a2 * x * x + self.mass * v * v, self.held**2 / self.a2
            if energy <= critical * (1 + mpf(10) ** (20 - brute_force.DIGITS)):
                return None
        return super().stick_end(line, end + 4 * mpmath.sqrt(self.mass / self.a2) + 4 * self.a1 / self.a2)


def text(value, scale, digits: int) -> str:
    """60 digits; "0" for what is only rounding of its scale."""
    if abs(value) <= scale * mpf(10) ** (-7 * digits // 10):
        return "0"
    return mpmath.nstr(value, PRINTED, strip_zeros=True, min_fixed=1, max_fixed=0)


def scanned(scene: Scene, max_events: int, digits: int, smallest: int) -> dict:
    """The events and the end of a scene as decimal text."""
    with working_digits(digits):
        happenings, final = Scan(scene, smallest).run(max_events)
        pair = scene.pair
        m1, m2, a2 = number(pair.m1), number(pair.m2), number(pair.a2)
        width, rate = number(pair.half_width), mpmath.sqrt(number(pair.a2 / pair.mass))
        scales, close = (width, width * rate, width, width * rate), mpf(10) ** (-digits // 2)
        # stopped by the cap: the final state is that of the last event
        stopped = len(happenings) == max_events and all(
            abs(one - two) <= close * scale for one, two, scale in zip(final, happenings[-1].y, scales, strict=True)
        )
        end = happenings[-1].t if stopped else number(Fraction(scene.until))

        def row(t, y):
            return [text(t, t, digits)] + [text(v, s, digits) for v, s in zip(y, scales, strict=True)]

        energy = (a2 * final[0] ** 2 + m1 * final[1] ** 2 + m2 * final[3] ** 2) / 2
        excess = energy / number(pair.critical_energy) - 1
        start = "slip+" if scene.initial.v1 > scene.initial.v2 else "slip-"
        modes = [one.before for one in happenings[:1]] + [one.after for one in happenings]
        if not modes:
            modes = ["stick" if final[1] == final[3] else start]
        return {
            "modes": modes,
            "events": [row(one.t, one.y) for one in happenings],
            "final": [
                *row(end, final),
                text(energy, number(pair.critical_energy), digits),
                text(excess, 1, digits),
            ],
        }
