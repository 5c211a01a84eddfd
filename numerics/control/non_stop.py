"""The motion that slips for ever and reverses twice a period: whether it is one, and from which amplitude on.

From a reversal to slip + on, with the square wave of friction from (-b h, -b h') (`thresholds`) and T = 2 pi/omega,

    w = own(t) + S sin(omega t),    S = sqrt((U omega/Z(m1))^2 - V^2)
    own(t) = e^(-lambda t) (-b h' C(t) - k S(t)) - beta (t - T/4) - V cos(omega t)

V the velocity that the sine must supply, k = (b - a2 b h)/m1 - lambda b h', C(t) = cos(omegad t), S(t) =
sin(omegad t)/omegad; w = 0 at both ends. It is a motion exactly if U >= U** and w keeps its sign for 0 < t < T/2. There
w rises with S, so the second condition, too, holds from some amplitude on: S >= -own(t)/sin(omega t) for all t.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.control.linear import is_positive_on
from numerics.control.thresholds import cosine_and_sine, hypot, reversal_demand, square_wave_response, stiffness
from numerics.scene import Pair

_PARTS = 64
"""Into so many parts half a period is cut before w > 0 counts as undecided."""
_TIMES = 96
"""Times in half a period at which w is looked at where nothing is proved."""


@dataclass(frozen=True)
class NonStop:
    """What w (m/s) of that motion consists of, at a frequency (rad/s) or over a ball of them; times in s."""

    pair: Pair
    omega: arb
    place: arb
    speed: arb
    demand: arb
    acceleration: arb

    @classmethod
    def of(cls, pair: Pair, omega: arb) -> NonStop:
        """Return the motion of a pair at a frequency, in the arithmetic's context."""
        return cls(pair, omega, *square_wave_response(pair, omega), *reversal_demand(pair, omega))

    @cached_property
    def half(self) -> arb:
        """Half a period, s."""
        return arb.pi() / self.omega

    @cached_property
    def _lambda(self) -> arb:
        return Ball.number(self.pair.a1 / (2 * self.pair.m1))

    @cached_property
    def _squared(self) -> Fraction:
        """Return omegad^2, 1/s^2, of any sign."""
        return self.pair.a2 / self.pair.m1 - (self.pair.a1 / (2 * self.pair.m1)) ** 2

    @cached_property
    def _beta(self) -> arb:
        return Ball.number(self.pair.b / self.pair.m2)

    @cached_property
    def _square(self) -> arb:
        """Return -b h', m/s."""
        return -Ball.number(self.pair.b) * self.speed

    @cached_property
    def _swing(self) -> arb:
        number, pair = Ball.number, self.pair
        b = number(pair.b)
        return (b - number(pair.a2) * b * self.place) / number(pair.m1) - self._lambda * b * self.speed

    def own(self, t: arb) -> arb:
        """Return w without its part S sin(omega t), m/s."""
        c, s = cosine_and_sine(self._squared, t)
        own = (-self._lambda * t).exp() * (self._square * c - self._swing * s)
        return own - self._beta * (t - self.half / 2) - self.demand * (self.omega * t).cos()

    def relative(self, t: arb, sine: arb) -> arb:
        """Return w, m/s, for S = sine."""
        return self.own(t) + sine * (self.omega * t).sin()

    def rate(self, t: arb, sine: arb) -> arb:
        """Return the rate of w, m/s^2, for S = sine."""
        decay, squared = self._lambda, Ball.number(self._squared)
        c, s = cosine_and_sine(self._squared, t)
        turn, turned = (self.omega * t).sin_cos()
        falls = -self._square * (decay * c + squared * s) - self._swing * (c - decay * s)
        driven = self.omega * (self.demand * turn + sine * turned)
        return (-decay * t).exp() * falls - self._beta + driven

    def sine(self, amplitude: arb) -> arb | None:
        """Return S, m/s, under a force of an amplitude, N; None where it is not proved to be > 0."""
        reach = amplitude * self.omega / stiffness(self.pair, self.pair.m1, self.omega)
        rest = reach * reach - self.demand * self.demand
        return rest.sqrt() if rest > 0 else None


def keeps_slipping(pair: Pair, amplitude: arb, omega: arb) -> bool:
    """Return whether w > 0 is proved between the reversals of the motion that only slips, for U > U** (N)."""
    motion = NonStop.of(pair, omega)
    sine = motion.sine(amplitude)
    if sine is None:
        return False

    def rising(part: arb) -> arb:
        """Return w in the form that is the sharper: by its value in the middle and its rate over the part."""
        wide = motion.relative(part.mid(), sine) + (part - part.mid()) * motion.rate(part, sine)
        plain = motion.relative(part, sine)
        return wide if wide.rad() < plain.rad() else plain

    short, end = (motion.half / 16).lower(), motion.half.upper()
    return (
        is_positive_on(lambda t: motion.rate(t, sine), arb(0), short, _PARTS)
        and is_positive_on(lambda t: -motion.rate(t, sine), motion.half.lower() - short, end, _PARTS)
        and is_positive_on(rising, short, end - short, _PARTS)
    )


def turns_back(pair: Pair, amplitude: arb, omega: arb) -> bool:
    """Return whether w < 0 is proved at some time between the reversals: then U (N) >= U** is not enough."""
    motion = NonStop.of(pair, omega)
    sine = motion.sine(amplitude)
    return sine is not None and any(motion.relative(t, sine) < 0 for t in _times(motion))


def non_stop_edge(pair: Pair, omega: arb) -> float:
    """Return the least U >= U**, N, at which w keeps its sign, in binary64.

    Approximate, for figures: w is looked at on a grid of times, not between them; the edge is never below U**, but may
    lie a little too low. Not finite where U** is not.
    """
    motion = NonStop.of(pair, omega)
    least = motion.acceleration / omega
    for t in _times(motion):
        least = max(least, -motion.own(t) / (omega * t).sin(), key=float)
    return float(stiffness(pair, pair.m1, omega) / omega * hypot(motion.demand, least))


def _times(motion: NonStop) -> list[arb]:
    return [(motion.half * (2 * k + 1) / (2 * _TIMES)).mid() for k in range(_TIMES)]
