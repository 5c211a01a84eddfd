"""An independent solver to check the other by: SI equations, complex exponentials, a fine scan and bisection.

It shares nothing with numerics/ but the scene. It is slow and proves nothing: the scan sees what its step sees.
"""

from typing import NamedTuple

import mpmath
from mpmath import mpf

from numerics.scene import Law, Scene

DIGITS = 90
POINTS_PER_RADIAN = 12


class Happening(NamedTuple):
    """An event: time, modes before and after, x1 v1 x2 v2."""

    t: mpf
    before: str
    after: str
    y: tuple


class Line:
    """x1 = y - force/a2 with m y'' + a1 y' + a2 y = 0: one body, or both, under a constant force."""

    def __init__(self, mass, a1, a2, force, x, v):
        self.rest = -force / a2
        discriminant = a1 * a1 - 4 * mass * a2
        if abs(discriminant) < a1 * a1 * mpf(10) ** (10 - DIGITS):
            discriminant = mpf(0)  # critical exactly, up to the rounding of the parameters
        root = mpmath.sqrt(mpmath.mpc(discriminant))
        self.one, self.two = (-a1 + root) / (2 * mass), (-a1 - root) / (2 * mass)
        y = x - self.rest
        self.double, self.turns = self.one == self.two, discriminant < 0
        if self.double:
            self.c1, self.c2 = mpmath.mpc(y), v - self.one * y
        else:
            self.c1 = (v - self.two * y) / (self.one - self.two)
            self.c2 = y - self.c1

    def position(self, t):
        e1 = mpmath.exp(self.one * t)
        if self.turns:  # the other exponential is the conjugate of this one, and so is its coefficient
            return 2 * (self.c1 * e1).real + self.rest
        value = (self.c1 + self.c2 * t) * e1 if self.double else self.c1 * e1 + self.c2 * mpmath.exp(self.two * t)
        return value.real + self.rest

    def speed(self, t):
        e1 = mpmath.exp(self.one * t)
        if self.turns:
            return 2 * (self.c1 * self.one * e1).real
        if self.double:
            return (((self.c1 + self.c2 * t) * self.one + self.c2) * e1).real
        return (self.c1 * self.one * e1 + self.c2 * self.two * mpmath.exp(self.two * t)).real


def number(value):
    return mpf(value.numerator) / value.denominator


class BruteForce:
    """Runs a scene to its horizon or to a number of events."""

    def __init__(self, scene: Scene):
        pair, at = scene.pair, scene.initial
        self.m1, self.m2, self.a1, self.a2, self.b = (number(v) for v in (pair.m1, pair.m2, pair.a1, pair.a2, pair.b))
        self.mass, self.held = self.m1 + self.m2, self.b * (self.m1 + self.m2) / self.m2
        self.y = tuple(number(v) for v in (at.x1, at.v1, at.x2, at.v2))
        self.literal, self.until = scene.law is Law.THREE_VALUED_SGN, number(scene.until)
        # exact ties of the first instant
        self.tie = abs(pair.a2 * at.x1 + pair.a1 * at.v1) == pair.b * pair.mass / pair.m2

    def load(self, x, v):
        return self.a2 * x + self.a1 * v

    def sign_on_surface(self, x, v, tie):
        """0 stick, +-1 slip."""
        load = self.load(x, v)
        side = 1 if load > 0 else -1
        beyond = 0 if tie else abs(load) - self.held
        leaving = side * (self.a2 * v - self.a1 * self.load(x, v) / self.mass)
        if self.literal or beyond < 0 or (beyond == 0 and leaving <= mpf(10) ** (10 - DIGITS) * self.held):
            return 0
        return -side

    def times(self, mass, end, from_zero):
        """Scan times: equal steps that resolve an oscillation, growing ones for a damped motion or from a root at 0."""
        step = 1 / (POINTS_PER_RADIAN * max(mpmath.sqrt(self.a2 / mass), self.a1 / mass))
        oscillates = self.a1**2 < 4 * mass * self.a2
        t = step * mpf(10) ** -40 if from_zero else step
        while t < end:
            yield t
            growing = t / 6
            t += min(step, growing) if oscillates and from_zero else step if oscillates else max(min(step, t), growing)
        yield end

    def first_fall(self, function, mass, end, from_zero):
        """The first t > 0 at which function goes from > 0 to <= 0."""
        previous = None if from_zero else mpf(0)
        positive = not from_zero and function(previous) > 0
        for t in self.times(mass, end, from_zero):
            now = function(t)
            if positive and now <= 0:
                return self.bisect(function, previous, t)
            previous, positive = t, now > 0
        return None

    @staticmethod
    def bisect(function, low, high):
        f_low, f_high = function(low), function(high)
        for n in range(400):
            if f_high == 0:
                return high
            middle = (low + high) / 2 if n < 12 else high - f_high * (high - low) / (f_high - f_low)
            value = function(middle)
            if value > 0:
                low, f_low = middle, value
                if n >= 12:
                    f_high /= 2  # Illinois
            else:
                high, f_high = middle, value
                if n >= 12:
                    f_low /= 2
            if abs(high - low) < mpf(10) ** (3 - DIGITS) * high:
                break
        return (low + high) / 2

    def run(self, max_events):
        """The events, and the state at the end (the horizon, or the last event)."""
        x, v, x2, v2 = self.y
        now, happenings = mpf(0), []
        sign = (v > v2) - (v < v2)
        on_surface = sign == 0
        if on_surface:
            sign = self.sign_on_surface(x, v, self.tie)
        while True:
            mass = self.m1 if sign else self.mass
            line = Line(mass, self.a1, self.a2, self.b * sign, x, v)
            end = self.until - now
            gain = sign * self.b / self.m2
            at = self.slip_end(line, sign, gain, v2, end, on_surface) if sign else self.stick_end(line, end)
            if at is None or at > end or len(happenings) == max_events:
                t = mpf(0) if len(happenings) == max_events and at is not None and at <= end else end
                return happenings, self.state(line, sign, gain, x, x2, v2, t)
            name = {0: "stick", 1: "slip+", -1: "slip-"}
            x, v, x2, v2 = self.state(line, sign, gain, x, x2, v2, at)
            now, before = now + at, sign
            if sign:
                v = v2
                sign = self.sign_on_surface(x, v, False)
            else:
                side = 1 if self.load(x, v) > 0 else -1
                x, sign = (side * self.held - self.a1 * v) / self.a2, -side
            on_surface = True
            happenings.append(Happening(now, name[before], name[sign], (x, v, x2, v2)))

    def slip_end(self, line, sign, gain, v2, end, on_surface):
        return self.first_fall(lambda t: sign * (line.speed(t) - v2 - gain * t), self.m1, end, on_surface)

    def stick_end(self, line, end):
        """The load leaves its bound next to an extremum, perhaps for a moment only: look at each extremum."""
        if self.literal:
            return None
        held = self.held * (1 + mpf(10) ** (10 - DIGITS))
        load = lambda t: self.load(line.position(t), line.speed(t))  # noqa: E731
        slope = lambda t: self.a2 * line.speed(t) - self.a1 * load(t) / self.mass  # noqa: E731
        start = previous = mpf(0)
        sign = mpmath.sign(slope(previous)) or -mpmath.sign(load(previous))
        for t in self.times(self.mass, end, False):
            if sign * slope(t) <= 0:
                extremum = self.bisect(lambda u, sign=sign: sign * slope(u), previous, t)
                if abs(load(extremum)) > held:
                    return self.bisect(lambda u: held - abs(load(u)), start, extremum)
                start, sign = extremum, -sign
            previous = t
        return self.bisect(lambda u: held - abs(load(u)), start, end) if abs(load(end)) > held else None

    def state(self, line, sign, gain, x, x2, v2, t):
        x_end, v_end = line.position(t), line.speed(t)
        if sign:
            return x_end, v_end, x2 + v2 * t + gain * t * t / 2, v2 + gain * t
        return x_end, v_end, x2 + (x_end - x), v_end
