"""What acts on a pair in a spell, exact, and its motion in closed form from event to event: the waves of Waves.v.

A spell of force and friction lasts from one change of either to the next. Of a force of polynomials and sines one
answer of a mass on spring and damper is a polynomial and sines again (undetermined coefficients). Motions are formed
in balls, in SI units and in time u (s) since the phase began. A sign k = +1 or -1 is that of v1 - v2 in a slip, and
that of the slip which follows a stick.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import NamedTuple

import flint
from flint import acb, acb_poly, arb

from numerics.arithmetic.ball import Ball, exact_middle, widened
from numerics.arithmetic.precision import precision
from numerics.linear.modes import Mode
from numerics.linear.pieces import particular, pieces_of
from numerics.scene import Pair, Scene

SPARE_SIGN_BITS = 4
"""With how many bits more than the writer the kernel sees that nothing happens in a phase."""
SHORT = 2.0**-12
"""Half the length of an interval whose sine the kernel bounds by its middle and its slope."""
DEPTH = 60
"""How often an interval is halved for that."""
PARTS = 1000
"""Into how many parts a phase is cut at most for that: a file has to be judged in minutes."""
SPARE = 1.25
"""Bounds of an event are wider than a box says: the kernel rounds elsewhere."""
_NEWTON = 60
number = Ball.number


class TooCoarse(Exception):
    """The boxes have grown too large: more bits are needed."""


class Unseen(TooCoarse):
    """It is not seen that the pair keeps its mode until the next event."""


class Tone(NamedTuple):
    """(in_sine + rise_sine t) sin(turn t + phase) + (in_cosine + rise_cosine t) cos(turn t + phase), turn in rad/s."""

    in_sine: Fraction
    in_cosine: Fraction
    rise_sine: Fraction
    rise_cosine: Fraction
    turn: Fraction
    phase: Fraction


class Steady(NamedTuple):
    """A polynomial of t - since (s), by its coefficients from the constant on, plus tones of t; exact."""

    since: Fraction
    polynomial: tuple[Fraction, ...]
    tones: tuple[Tone, ...]

    def wave(self, t: arb) -> Wave:
        """Return it as a wave from a time on."""
        parts = [Oscillation(acb_poly([*map(number, self.polynomial)]), clock=t - number(self.since))]
        for in_sine, in_cosine, rise_sine, rise_cosine, turn, phase in self.tones:
            factor = [acb(number(c), -number(s)) for c, s in ((in_cosine, in_sine), (rise_cosine, rise_sine))]
            parts.append(Oscillation(acb_poly(factor), acb(0, number(turn)), number(phase), t))
        return Wave(parts)


class Oscillation(NamedTuple):
    """The real part of factor(s) exp(rate s + i phase), s = clock + u."""

    factor: acb_poly
    rate: acb = acb(0)
    phase: arb = arb(0)
    clock: arb = arb(0)

    def __call__(self, u: arb) -> arb:
        """Return the value at u."""
        s = self.clock + u
        angle, factor = self.rate.imag * s + self.phase, self.factor(s)
        sine, cosine = angle.sin_cos()
        if angle.rad() < SHORT:  # as the kernel does
            sine, cosine = (widened(one, angle.rad()) for one in angle.mid().sin_cos())
        return (self.rate.real * s).exp() * (factor.real * cosine - factor.imag * sine)

    def slope(self) -> Oscillation:
        """Return the derivative."""
        return self._replace(factor=self.factor.derivative() + self.rate * self.factor)


class Wave(list[Oscillation]):
    """A sum of parts."""

    def __call__(self, u: arb) -> arb:
        """Return the value at u."""
        return sum((one(u) for one in self), arb(0))

    def slope(self) -> Wave:
        """Return the derivative."""
        return Wave(one.slope() for one in self)

    def plus(self, k: int, *polynomial: arb) -> Wave:
        """Return a polynomial plus k times the wave."""
        return Wave([Oscillation(acb_poly([*polynomial])), *(one._replace(factor=k * one.factor) for one in self)])


class Spell(NamedTuple):
    """From `since` (s) on: friction (N) and force (N), and how body 1 and both bodies together answer to it (m)."""

    since: Fraction
    friction: Fraction
    force: Steady
    alone: Steady
    together: Steady


def spells(scene: Scene) -> Iterator[Spell]:
    """Yield the spells that begin before the end."""
    pair, nothing = scene.pair, Fraction(0)
    for one in pieces_of(scene):
        piece = scene.force.piece_at(one.start)
        tones = tuple(Tone(sine.amplitude, nothing, nothing, nothing, sine.omega, sine.phase) for sine in piece.sines)
        force = Steady(piece.start, piece.polynomial, tones)
        yield Spell(one.start, one.b, force, _answer(pair, pair.m1, force), _answer(pair, pair.mass, force))


def _answer(pair: Pair, mass: Fraction, force: Steady) -> Steady:
    """Return a solution y of mass y'' + a1 y' + a2 y = force, whose tones are sines."""
    tones, nothing = [], Fraction(0)
    for sine, _, _, _, turn, phase in force.tones:
        stiff, damp = pair.a2 - mass * turn**2, pair.a1 * turn
        if size := stiff**2 + damp**2:
            answer = stiff * sine / size, -damp * sine / size, nothing, nothing
        else:  # resonance
            answer = nothing, nothing, nothing, -sine / (2 * mass * turn)
        tones.append(Tone(*answer, turn, phase))
    return Steady(force.since, tuple(particular(force.polynomial, mass, pair.a1, pair.a2)), tuple(tones))


def _swing(pair: Pair, mass: Fraction, x: arb, v: arb) -> Iterator[Oscillation]:
    """Yield the parts of a free swing of a mass; whether damping is below its critical value is decided exactly."""
    slow = pair.a1 / (2 * mass)
    square = pair.a2 / mass - slow**2
    decay, root = number(slow), number(abs(square)).sqrt()
    odd = v + decay * x
    if square > 0:
        yield Oscillation(acb_poly([acb(x, -odd / root)]), acb(-decay, root))
    elif square == 0:
        yield Oscillation(acb_poly([x, odd]), acb(-decay))
    else:
        for k in (1, -1):
            yield Oscillation(acb_poly([(x + k * odd / root) / 2]), acb(k * root - decay))


class EnclosedState(NamedTuple):
    """Time (s), place (m) and velocity (m/s) of body 1, the same of body 2."""

    t: arb
    x1: arb
    v1: arb
    x2: arb
    v2: arb


@dataclass
class TheoremRun:
    """Where a motion surely is: in a box, in contact or not; with k at the edge at which a stick has ended."""

    pair: Pair
    spell: Spell
    signs: int
    """In how many bits it is seen that nothing happens in a phase."""
    at: EnclosedState
    touches: bool
    k: int = 0

    def start(self, *numbers: Fraction) -> TheoremRun:
        """Return the run from an exact state, t, x1, v1, x2, v2."""
        return replace(self, at=EnclosedState(*map(number, numbers)), touches=numbers[2] == numbers[4], k=0)

    @property
    def time(self) -> float:
        """Return about when it is there, s."""
        return float(self.at.t.mid())

    def path(self, mode: Mode) -> Wave:
        """Return body 1's place, m."""
        pair, spell, at = self.pair, self.spell, self.at
        mass, answer = (pair.m1, spell.alone) if mode.sign else (pair.mass, spell.together)
        wave, centre = answer.wave(at.t), number(-mode.sign * spell.friction / pair.a2)
        away = at.x1 - centre - wave(arb(0))
        return Wave([*wave, *_swing(pair, mass, away, at.v1 - wave.slope()(arb(0)))]).plus(1, centre)

    def guard(self, mode: Mode, k: int) -> Wave:
        """Return what is positive until a mode ends: k (v1 - v2) of a slip, m/s; m/s^2 that friction has left for k."""
        slope, gained = self.path(mode).slope(), number(self.spell.friction / self.pair.m2)
        if mode is Mode.STICK:
            return slope.slope().plus(-k, gained)
        return slope.plus(k, -k * self.at.v2, -gained)

    def moved(self, mode: Mode, u: arb, ends: int = 0) -> EnclosedState:
        """Return the state a time later; where a mode ends, a stick towards `ends`, both velocities are equal."""
        pair, spell, at, path = self.pair, self.spell, self.at, self.path(mode)
        t, x1, v1 = at.t + u, path(u), path.slope()(u)
        if mode is Mode.STICK:
            load = spell.force.wave(t)(arb(0)) - number(ends * spell.friction * pair.mass / pair.m2)
            edge = (load - number(pair.a1) * v1) / number(pair.a2) if ends else x1
            return EnclosedState(t, edge, v1, at.x2 + (x1 - at.x1), v1)
        v2 = at.v2 + number(mode.sign * spell.friction / pair.m2) * u
        return EnclosedState(t, x1, v2 if ends else v1, at.x2 + (at.v2 + v2) / 2 * u, v2)

    def hit(self, mode: Mode, k: int, time: float) -> tuple[Fraction, Fraction]:
        """Go to the next event, near the time; return bounds of the time since. Raises TooCoarse."""
        guard = self.guard(mode, k)
        if mode is not Mode.STICK and self.k not in (0, k):
            raise Unseen
        low, high = _bracket(time - self.time, guard)
        for side in ends_of(mode):
            keeps(self.guard(mode, side), self._zeros(mode, side), low if side == k else high, self.signs)
        self.at = self.moved(mode, number(low).union(number(high)), k)
        self.touches, self.k = True, k if mode is Mode.STICK else 0
        return low, high

    def rest(self, mode: Mode, time: Fraction) -> tuple[Fraction, arb]:
        """Go on in a mode to a time; return for how long it surely lasts, and v1 - v2 then. Raises TooCoarse."""
        left = number(time) - self.at.t
        if not left > 0:  # the last event may be at the end
            raise TooCoarse
        least = outward(left, _places(left))[1]
        guards = {k: self.guard(mode, k) for k in ends_of(mode)}
        if not all(guard(number(least)) > 0 for guard in guards.values()):
            raise TooCoarse
        for k, guard in guards.items():
            keeps(guard, self._zeros(mode, k), least, self.signs)
        relative = mode.sign * guards[mode.sign or 1](left)
        self.at = self.moved(mode, left)._replace(t=number(time))
        self.touches, self.k = mode is Mode.STICK, 0
        return least, relative

    def is_kept(self, u: arb) -> bool:
        """Return whether a stick under a constant force does not end from a time on: its energy is too small for it."""
        pair, spell, at = self.pair, self.spell, self.moved(Mode.STICK, u)
        away = number(pair.a2) * at.x1 - spell.force.wave(at.t)(arb(0))
        reach = (away**2 / number(pair.a2) + number(pair.mass) * at.v1**2) * number(pair.a2 + pair.a1**2 / pair.mass)
        return bool(number(spell.friction * pair.mass / pair.m2) ** 2 > reach)

    def _zeros(self, mode: Mode, k: int) -> int:
        """Return how many derivatives of what is positive in a mode are zero at first."""
        return int(self.k == k) if mode is Mode.STICK else self.touches * (1 + (self.k == k))


def ends_of(mode: Mode) -> tuple[int, ...]:
    """Return the signs of the guards that may end a mode."""
    return (mode.sign,) if mode.sign else (1, -1)


def keeps(wave: Wave, zeros: int, end: Fraction, bits: int) -> None:
    """See that a wave is positive after 0 until an end, as the kernel does; so many derivatives may be zero at 0.

    By its bounds over a part, its slope or bend there, or both halves. Raises Unseen.
    """
    if not zeros and not wave(arb(0)) > 0:
        raise Unseen
    with precision(bits):
        slope = wave.slope()
        bend, begin = slope.slope(), Fraction(0)
        if zeros:
            begin = _early((wave, slope, bend)[zeros], end / 2)
        if begin and not wave(number(begin)) > 0:
            raise Unseen
        parts = [(begin, end)]
        for _ in range(PARTS):
            if not parts:
                return
            low, high = parts.pop()
            between, middle = number(low).union(number(high)), (low + high) / 2
            if wave(between) > 0:
                continue
            steep, bent = slope(between), bend(between)
            if steep >= 0 or steep <= 0 or bent <= 0 or (bent >= 0 and slope(number(low)) >= 0):
                continue
            if (high - low) * 2**DEPTH < end or not wave(number(middle)) > 0:
                break
            parts += (middle, high), (low, middle)
    raise Unseen


def _early(wave: Wave, end: Fraction) -> Fraction:
    """Return a time until which a wave is positive by its bounds."""
    for _ in range(DEPTH):
        if wave(arb(0).union(number(end))) > 0:
            return end
        end /= 2
    raise Unseen


def _bracket(guess: float, guard: Wave) -> tuple[Fraction, Fraction]:
    """Return decimals around the root of a falling wave, sure for every state of the box."""
    slope, root = guard.slope(), arb(guess)
    for _ in range(_NEWTON):
        if guard(root).contains(0):
            break
        root = (root - guard(root) / slope(root)).mid()
    near = root * arb(1, (1, 4 - flint.ctx.prec))
    off = guard(near).abs_upper() / slope(near).abs_lower()
    if not (off.is_finite() and off < root):
        raise TooCoarse
    low, high = outward(near + arb(0, SPARE * off), _places(root))
    if not (low > 0 and guard(number(low)) > 0 and guard(number(high)) < 0):
        raise TooCoarse
    return low, high


def outward(box: arb, places: int) -> tuple[Fraction, Fraction]:
    """Return decimals with so many places around a ball."""
    unit = Fraction(10) ** places
    return math.floor(exact_middle(box.lower()) * unit) / unit, math.ceil(exact_middle(box.upper()) * unit) / unit


def _places(size: arb) -> int:
    """Return how many decimal places a number of this size has in the present precision, and two more."""
    return int(flint.ctx.prec * 0.301) + 2 - math.floor(float(size.abs_upper().log_base(10).mid()))
