"""A free motion between two events in closed form, over points or intervals of mpmath: the waves of Waves.v.

Everything is in SI units and in time u (s) since the phase began. A sign k = +1 or -1 is that of v1 - v2 in a slip, and
that of the slip which follows a stick.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from numerics.scene import Pair

Value = Any
"""A number of mpmath: a point or an interval."""


class Swing(NamedTuple):
    """A free swing of one mass: its decay (1/s), the square of its frequency (1/s^2), the sign of that, its root."""

    decay: Value
    square: Value
    side: int
    root: Value


class Wave(NamedTuple):
    """u -> still + drift u + exp(-decay u) (even C(u) + odd S(u)), where C'' = -square C and S' = C."""

    on: Any
    still: Value
    drift: Value
    even: Value
    odd: Value
    swing: Swing

    def __call__(self, u: Value) -> Value:
        """Return the value at u."""
        on, (decay, _, side, root) = self.on, self.swing
        if side > 0:
            phase = root * u
            swung = on.exp(-(decay * u)) * (self.even * on.cos(phase) + self.odd * (on.sin(phase) / root))
        elif side == 0:
            swung = on.exp(-(decay * u)) * (self.even + self.odd * u)
        else:
            other = self.odd / root
            swung = (self.even + other) / 2 * on.exp(-((decay - root) * u))
            swung += (self.even - other) / 2 * on.exp(-((decay + root) * u))
        return self.still + self.drift * u + swung

    def slope(self) -> Wave:
        """Return the derivative, a wave."""
        decay, square = self.swing.decay, self.swing.square
        even, odd = self.odd - decay * self.even, -(square * self.even) - decay * self.odd
        return Wave(self.on, self.drift, 0 * self.drift, even, odd, self.swing)


class ClosedForms:
    """What a pair without a force does, over `on`: a context of points or of intervals."""

    def __init__(self, on: Any, pair: Pair) -> None:
        """Read the exact parameters; whether damping is below its critical value is decided exactly."""
        self.on = on
        self.a1, self.a2, self.b = (self.number(one) for one in (pair.a1, pair.a2, pair.b))
        self.gained = self.number(pair.b / pair.m2)
        self.edge_load = self.number(pair.b * pair.mass / pair.m2)
        self.alone, self.together = (self._swing(pair, mass) for mass in (pair.m1, pair.mass))

    def number(self, value: Fraction) -> Value:
        """Return an exact number in the context."""
        return self.on.mpf(value.numerator) / self.on.mpf(value.denominator)

    def _swing(self, pair: Pair, mass: Fraction) -> Swing:
        decay = pair.a1 / (2 * mass)
        square = pair.a2 / mass - decay * decay
        root = self.on.sqrt(self.number(abs(square)))
        return Swing(self.number(decay), self.number(square), (square > 0) - (square < 0), root)

    def _about(self, centre: Value, x: Value, v: Value, swing: Swing) -> Wave:
        """Return the swing about a place from a state."""
        away = x - centre
        return Wave(self.on, centre, self.on.mpf(0), away, v + swing.decay * away, swing)

    def slide(self, k: int, x1: Value, v1: Value) -> Wave:
        """Return body 1's place in a slip, m."""
        return self._about(-k * self.b / self.a2, x1, v1, self.alone)

    def driven(self, k: int, v2: Value, u: Value) -> Value:
        """Return body 2's velocity in a slip, m/s."""
        return v2 + k * self.gained * u

    def guard(self, k: int, x1: Value, v1: Value, v2: Value) -> Wave:
        """Return k (v1 - v2) in a slip, m/s: positive until it ends."""
        speed = self.slide(k, x1, v1).slope()
        return Wave(self.on, -(k * v2), -self.gained, k * speed.even, k * speed.odd, speed.swing)

    def stuck(self, x1: Value, v: Value) -> Wave:
        """Return body 1's place in a stick, m."""
        return self._about(self.on.mpf(0), x1, v, self.together)

    def grip(self, k: int, x1: Value, v: Value) -> Wave:
        """Return what friction has left in a stick towards a slip k, m/s^2: positive until it ends."""
        change = self.stuck(x1, v).slope().slope()
        return Wave(self.on, self.gained, self.on.mpf(0), -(k * change.even), -(k * change.odd), change.swing)

    def edge(self, k: int, v: Value) -> Value:
        """Return the place where a stick ends towards k with the velocity v, m."""
        return (-(k * self.edge_load) - self.a1 * v) / self.a2
