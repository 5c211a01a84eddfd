"""A motion between two events in closed form, over intervals of mpmath: the waves of Waves.v.

Everything is in SI units and in time u (s) since the phase began. A sign k = +1 or -1 is that of v1 - v2 in a slip, and
that of the slip which follows a stick.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from numerics.scene import Pair
from numerics.trajectory.spells import Spell, Steady, bounded, exactly

Value = Any
"""An interval of mpmath."""


class State(NamedTuple):
    """Time (s), place (m) and velocity (m/s) of body 1, the same of body 2."""

    t: Value
    x1: Value
    v1: Value
    x2: Value
    v2: Value


class Swing(NamedTuple):
    """A free swing of one mass: its decay (1/s), the square of its frequency (1/s^2), the sign of that, its root."""

    decay: Value
    square: Value
    side: int
    root: Value


class Wave(NamedTuple):
    """u -> still + drift u + exp(-decay u) (even C(u) + odd S(u)) + answer(clock + u), C'' = -square C and S' = C."""

    on: Any
    still: Value
    drift: Value
    even: Value
    odd: Value
    swing: Swing
    clock: Value
    answer: Steady

    def __call__(self, u: Value) -> Value:
        """Return the value at u."""
        on, (decay, _, side, root) = self.on, self.swing
        if side > 0:
            phase = root * u
            cosine, sine = (bounded(function, phase) for function in (on.cos, on.sin))
            swung = on.exp(-(decay * u)) * (self.even * cosine + self.odd * (sine / root))
        elif side == 0:
            swung = on.exp(-(decay * u)) * (self.even + self.odd * u)
        else:
            other = self.odd / root
            swung = (self.even + other) / 2 * on.exp(-((decay - root) * u))
            swung += (self.even - other) / 2 * on.exp(-((decay + root) * u))
        return self.still + self.drift * u + swung + self.answer(self.on, self.clock + u)

    def slope(self) -> Wave:
        """Return the derivative, a wave."""
        decay, square = self.swing.decay, self.swing.square
        even, odd = self.odd - decay * self.even, -(square * self.even) - decay * self.odd
        return Wave(self.on, self.drift, 0 * self.drift, even, odd, self.swing, self.clock, self.answer.slope())


class ClosedForms:
    """What a pair does in one spell of force and friction, over `on`: a context of intervals."""

    def __init__(self, on: Any, pair: Pair, spell: Spell) -> None:
        """Read the exact parameters; whether damping is below its critical value is decided exactly."""
        self.on, self.spell = on, spell
        self.a1, self.a2, self.b = (self.number(one) for one in (pair.a1, pair.a2, spell.friction))
        self.mass = self.number(pair.mass)
        self.gained = self.number(spell.friction / pair.m2)
        self.edge_load = self.number(spell.friction * pair.mass / pair.m2)
        self.alone, self.together = (self._swing(pair, mass) for mass in (pair.m1, pair.mass))

    def number(self, value: Fraction) -> Value:
        """Return an exact number in the context."""
        return exactly(self.on, value)

    def _swing(self, pair: Pair, mass: Fraction) -> Swing:
        decay = pair.a1 / (2 * mass)
        square = pair.a2 / mass - decay * decay
        root = self.on.sqrt(self.number(abs(square)))
        return Swing(self.number(decay), self.number(square), (square > 0) - (square < 0), root)

    def _about(self, centre: Value, at: State, swing: Swing, answer: Steady) -> Wave:
        """Return the swing about a place from a state."""
        away = at.x1 - centre - answer(self.on, at.t)
        odd = at.v1 - answer.slope()(self.on, at.t) + swing.decay * away
        return Wave(self.on, centre, self.on.mpf(0), away, odd, swing, at.t, answer)

    def slide(self, k: int, at: State) -> Wave:
        """Return body 1's place in a slip, m."""
        return self._about(-k * self.b / self.a2, at, self.alone, self.spell.alone)

    def driven(self, k: int, v2: Value, u: Value) -> Value:
        """Return body 2's velocity in a slip, m/s."""
        return v2 + k * self.gained * u

    def guard(self, k: int, at: State) -> Wave:
        """Return k (v1 - v2) in a slip, m/s: positive until it ends."""
        speed = self.slide(k, at).slope()
        return Wave(
            self.on, -(k * at.v2), -self.gained, k * speed.even, k * speed.odd, speed.swing, at.t, speed.answer.times(k)
        )

    def stuck(self, at: State) -> Wave:
        """Return body 1's place in a stick, m."""
        return self._about(self.on.mpf(0), at, self.together, self.spell.together)

    def grip(self, k: int, at: State) -> Wave:
        """Return what friction has left in a stick towards a slip k, m/s^2: positive until it ends."""
        change = self.stuck(at).slope().slope()
        even, odd = -(k * change.even), -(k * change.odd)
        return Wave(self.on, self.gained, self.on.mpf(0), even, odd, change.swing, at.t, change.answer.times(-k))

    def edge(self, k: int, t: Value, v: Value) -> Value:
        """Return the place where a stick ends towards k at the time t with the velocity v, m."""
        return (self.spell.force(self.on, t) - k * self.edge_load - self.a1 * v) / self.a2

    def spare(self, at: State) -> Value:
        """Return what no stick under a constant force uses up from a state on, N^2: for ever, if it is not negative."""
        away = self.a2 * at.x1 - self.spell.force(self.on, at.t)
        reach = (away**2 / self.a2 + self.mass * at.v1**2) * (self.a2 + self.a1**2 / self.mass)
        return self.edge_load**2 - reach
