"""What acts on a pair from one time to the next, spell by spell, and how a mass on spring and damper answers: exact.

Of a force of polynomials and sines one answer is a polynomial and sines again. Source: undetermined coefficients.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from numerics.linear.pieces import particular
from numerics.scene import Pair, Scene

SHORT = 2.0**-11
"""How long an interval is at most whose sine the kernel bounds by its middle and its slope."""
Polynomial = tuple[Fraction, ...]
"""Coefficients of 1, t, t^2, ..."""


class Tone(NamedTuple):
    """(in_sine + rise_sine t) sin(turn t + phase) + (in_cosine + rise_cosine t) cos(turn t + phase), turn in rad/s."""

    in_sine: Fraction
    in_cosine: Fraction
    rise_sine: Fraction
    rise_cosine: Fraction
    turn: Fraction
    phase: Fraction

    def slope(self) -> Tone:
        """Return the derivative."""
        steady = self.rise_sine - self.in_cosine * self.turn, self.rise_cosine + self.in_sine * self.turn
        return Tone(*steady, -self.rise_cosine * self.turn, self.rise_sine * self.turn, self.turn, self.phase)

    def times(self, factor: int) -> Tone:
        """Return the multiple."""
        sine, cosine, rising_sine, rising_cosine, turn, phase = self
        return Tone(factor * sine, factor * cosine, factor * rising_sine, factor * rising_cosine, turn, phase)


class Steady(NamedTuple):
    """A polynomial of t - since (s) plus tones of t; exact."""

    since: Fraction
    polynomial: Polynomial = ()
    tones: tuple[Tone, ...] = ()

    def __call__(self, on: Any, t: Any) -> Any:
        """Return the value at t, over a context of intervals of mpmath."""
        number = partial(exactly, on)
        value, after = on.mpf(0), t - number(self.since)
        for coefficient in reversed(self.polynomial):
            value = number(coefficient) + after * value
        for tone in self.tones:
            angle = number(tone.turn) * t + number(tone.phase)
            value += (number(tone.in_sine) + number(tone.rise_sine) * t) * bounded(on.sin, angle)
            value += (number(tone.in_cosine) + number(tone.rise_cosine) * t) * bounded(on.cos, angle)
        return value

    def slope(self) -> Steady:
        """Return the derivative."""
        return Steady(self.since, _slope(self.polynomial), tuple(tone.slope() for tone in self.tones))

    def times(self, factor: int) -> Steady:
        """Return the multiple."""
        tones = tuple(one.times(factor) for one in self.tones)
        return Steady(self.since, tuple(factor * one for one in self.polynomial), tones)


def exactly(on: Any, one: Fraction) -> Any:
    """Return an exact number in a context of intervals of mpmath."""
    return on.mpf(one.numerator) / on.mpf(one.denominator)


def bounded(function: Callable[[Any], Any], angle: Any) -> Any:
    """Return a sine or cosine over an interval, a short one by its middle and its slope, as the kernel does."""
    return function(angle) if angle.delta > SHORT else function(angle.mid) + (angle - angle.mid)


class Spell(NamedTuple):
    """From `since` (s) on: friction (N) and force (N), and how body 1 and both bodies together answer to it (m)."""

    since: Fraction
    friction: Fraction
    force: Steady
    alone: Steady
    together: Steady


def spells(scene: Scene) -> Iterator[Spell]:
    """Yield the spells that begin before the end."""
    pair = scene.pair
    starts = {Fraction(0), *scene.force.starts, *scene.friction.starts}
    for start in sorted(one for one in starts if one < scene.until):
        piece = scene.force.piece_at(start)
        nothing = Fraction(0)
        tones = tuple(Tone(one.amplitude, nothing, nothing, nothing, one.omega, one.phase) for one in piece.sines)
        force = Steady(piece.start, piece.polynomial, tones)
        b = next((b for at, b in reversed(scene.friction.pieces) if at <= start), pair.b)
        yield Spell(start, b, force, _answer(pair, pair.m1, force), _answer(pair, pair.mass, force))


def _answer(pair: Pair, mass: Fraction, force: Steady) -> Steady:
    """Return a solution y of mass y'' + a1 y' + a2 y = force."""
    y, tones = tuple(particular(force.polynomial, mass, pair.a1, pair.a2)), []
    for tone in force.tones:
        stiff, damp = pair.a2 - mass * tone.turn**2, pair.a1 * tone.turn
        size, sine, cosine, nothing = stiff**2 + damp**2, tone.in_sine, tone.in_cosine, Fraction(0)
        if size:
            answer = (stiff * sine + damp * cosine) / size, (stiff * cosine - damp * sine) / size, nothing, nothing
        else:  # resonance
            growth = 2 * mass * tone.turn
            answer = nothing, nothing, cosine / growth, -sine / growth
        tones.append(Tone(*answer, tone.turn, tone.phase))
    return Steady(force.since, y, tuple(tones))


def _slope(polynomial: Polynomial) -> Polynomial:
    return tuple(k * one for k, one in enumerate(polynomial))[1:]
