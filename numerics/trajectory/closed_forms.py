"""What acts on a pair in a spell, exact, and its motion in closed form from event to event: the waves of Waves.v.

A spell of force and friction lasts from one change of either to the next. Of a force of polynomials and sines one
answer of a mass on spring and damper is a polynomial and sines again (undetermined coefficients). Motions are formed
over intervals of mpmath, in SI units and in time u (s) since the phase began. A sign k = +1 or -1 is that of v1 - v2 in
a slip, and that of the slip which follows a stick.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from mpmath.ctx_iv import MPIntervalContext

from numerics.linear.modes import Mode
from numerics.linear.pieces import particular, pieces_of
from numerics.scene import Pair, Scene

INTERVALS = MPIntervalContext()
"""In which all of it is formed; its precision is that of the file which is written."""
SHORT = 2.0**-11
"""How long an interval is at most whose sine the kernel bounds by its middle and its slope."""
SIGN_BITS = (20, 28, 44, 60, 92, 124)
"""In what precisions it is tried to see that nothing happens in a phase; the kernel takes `SPARE_SIGN_BITS` more."""
SPARE_SIGN_BITS = 4
DEPTH = 60
"""How often an interval is halved for that."""
PARTS = 1000
"""Into how many parts a phase is cut at most for that: a file has to be judged in minutes."""


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

    def slope(self) -> Tone:
        """Return the derivative."""
        steady = self.rise_sine - self.in_cosine * self.turn, self.rise_cosine + self.in_sine * self.turn
        return Tone(*steady, -self.rise_cosine * self.turn, self.rise_sine * self.turn, self.turn, self.phase)


class Steady(NamedTuple):
    """A polynomial of t - since (s), by its coefficients from the constant on, plus tones of t; exact."""

    since: Fraction
    polynomial: tuple[Fraction, ...] = ()
    tones: tuple[Tone, ...] = ()

    def __call__(self, t: Any) -> Any:
        """Return the value at t."""
        value, after = INTERVALS.mpf(0), t - number(self.since)
        for coefficient in reversed(self.polynomial):
            value = number(coefficient) + after * value
        for tone in self.tones:
            in_sine, in_cosine, rise_sine, rise_cosine, turn, phase = map(number, tone)
            sine, cosine = sine_cosine(turn * t + phase)
            value += (in_sine + rise_sine * t) * sine
            value += (in_cosine + rise_cosine * t) * cosine
        return value

    def slope(self) -> Steady:
        """Return the derivative."""
        slope = tuple(k * one for k, one in enumerate(self.polynomial))[1:]
        return Steady(self.since, slope, tuple(tone.slope() for tone in self.tones))


def number(one: Fraction) -> Any:
    """Return the interval of an exact number."""
    return INTERVALS.mpf(one.numerator) / INTERVALS.mpf(one.denominator)


def hull(low: Fraction, high: Fraction) -> Any:
    """Return the interval from one number to another."""
    return INTERVALS.mpf([number(low).a, number(high).b])


def sine_cosine(angle: Any) -> Any:
    """Yield sine and cosine over an interval, a short one by its middle and its slope, as the kernel does."""
    for function in (INTERVALS.sin, INTERVALS.cos):
        yield function(angle) if angle.delta > SHORT else function(angle.mid) + (angle - angle.mid)


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


Value = Any
"""An interval of mpmath."""


class StateForms(NamedTuple):
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
    """u -> still + drift u + sign (exp(-decay u) (even C(u) + odd S(u)) + answer(clock + u)).

    C'' = -square C and S' = C.
    """

    still: Value
    drift: Value
    even: Value
    odd: Value
    swing: Swing
    clock: Value
    answer: Steady
    sign: int = 1

    def __call__(self, u: Value) -> Value:
        """Return the value at u."""
        exp, (decay, _, side, root) = INTERVALS.exp, self.swing
        if side > 0:
            sine, cosine = sine_cosine(root * u)
            swung = exp(-(decay * u)) * (self.even * cosine + self.odd * (sine / root))
        elif side == 0:
            swung = exp(-(decay * u)) * (self.even + self.odd * u)
        else:
            other = self.odd / root
            swung = (self.even + other) / 2 * exp(-((decay - root) * u))
            swung += (self.even - other) / 2 * exp(-((decay + root) * u))
        return self.still + self.drift * u + self.sign * swung + self.sign * self.answer(self.clock + u)

    def slope(self) -> Wave:
        """Return the derivative, a wave."""
        decay, square = self.swing.decay, self.swing.square
        even, odd = self.odd - decay * self.even, -(square * self.even) - decay * self.odd
        still, drift, answer = self.drift, 0 * self.drift, self.answer.slope()
        return self._replace(still=still, drift=drift, even=even, odd=odd, answer=answer)


class Forms:
    """What a pair does in one spell of force and friction after another."""

    def __init__(self, pair: Pair, most: int) -> None:
        """Compute with so many bits at most."""
        self.sign_bits, self.parts = SIGN_BITS[0], PARTS
        self.pair, self.bits, INTERVALS.prec = pair, most, most

    def begin(self, spell: Spell) -> None:
        """Read the exact parameters of a spell; whether damping is below its critical value is decided exactly."""
        pair, self.spell = self.pair, spell
        self.a1, self.a2, self.b, self.mass = map(number, (pair.a1, pair.a2, spell.friction, pair.mass))
        self.gained = number(spell.friction / pair.m2)
        self.edge_load = number(spell.friction * pair.mass / pair.m2)
        self.alone, self.together = (self._swing(mass) for mass in (pair.m1, pair.mass))

    def _swing(self, mass: Fraction) -> Swing:
        decay = self.pair.a1 / (2 * mass)
        square = self.pair.a2 / mass - decay * decay
        root = INTERVALS.sqrt(number(abs(square)))
        return Swing(number(decay), number(square), (square > 0) - (square < 0), root)

    def path(self, mode: Mode, at: StateForms) -> Wave:
        """Return body 1's place from a state on, m."""
        swing, answer = (self.alone, self.spell.alone) if mode.sign else (self.together, self.spell.together)
        centre = -mode.sign * self.b / self.a2
        away = at.x1 - centre - answer(at.t)
        odd = at.v1 - answer.slope()(at.t) + swing.decay * away
        return Wave(centre, INTERVALS.mpf(0), away, odd, swing, at.t, answer)

    def moved(self, mode: Mode, at: StateForms, u: Value, ends: int = 0) -> StateForms:
        """Return the state a time later; where a mode ends, a stick towards `ends`, both velocities are equal."""
        t, path = at.t + u, self.path(mode, at)
        x1, v1 = path(u), path.slope()(u)
        if mode is Mode.STICK:
            edge = (self.spell.force(t) - ends * self.edge_load - self.a1 * v1) / self.a2 if ends else x1
            return StateForms(t, edge, v1, at.x2 + (x1 - at.x1), v1)
        v2 = at.v2 + mode.sign * self.gained * u
        return StateForms(t, x1, v2 if ends else v1, at.x2 + (at.v2 + v2) / 2 * u, v2)

    def guard(self, mode: Mode, k: int, at: StateForms) -> Wave:
        """Return what is positive until a mode ends: k (v1 - v2) of a slip, m/s; m/s^2 that friction has left for k."""
        slope = self.path(mode, at).slope()
        if mode is Mode.STICK:
            return slope.slope()._replace(still=self.gained, sign=-k)
        return slope._replace(still=-(k * at.v2), drift=-self.gained, sign=k)

    def spare(self, at: StateForms) -> Value:
        """Return what no stick under a constant force uses up from a state on, N^2: for ever, if it is not negative."""
        away = self.a2 * at.x1 - self.spell.force(at.t)
        reach = (away**2 / self.a2 + self.mass * at.v1**2) * (self.a2 + self.a1**2 / self.mass)
        return self.edge_load**2 - reach

    def narrow(self, bits: int) -> None:
        """Compute with no more bits than these."""
        self.bits = INTERVALS.prec = min(self.bits, bits)

    def keeps(self, wave: Wave, zeros: int, end: Fraction) -> None:
        """See that a wave is positive after 0 until an end, as the kernel does; it and its slope may be zero at 0.

        Raises Unseen.
        """
        before = self.sign_bits
        for self.sign_bits in (one for one in SIGN_BITS if one >= before):
            INTERVALS.prec, self.parts = self.sign_bits, PARTS
            waves = wave, wave.slope(), wave.slope().slope()
            begins = Fraction(0) if not zeros else self._early(waves[zeros], end / 2)
            seen = begins is not None and (not begins or wave(number(begins)) > 0)
            seen = seen and self._stays(waves, begins or Fraction(0), end, DEPTH)
            INTERVALS.prec = self.bits
            if seen and (zeros or wave(number(Fraction(0))) > 0):
                return
        self.sign_bits = before
        raise Unseen

    def _early(self, wave: Wave, end: Fraction) -> Fraction | None:
        """Return a time until which a wave is positive by its bounds."""
        for _ in range(DEPTH):
            if wave(hull(Fraction(0), end)) > 0:
                return end
            end /= 2
        return None

    def _stays(self, waves: tuple[Wave, Wave, Wave], low: Fraction, high: Fraction, depth: int) -> bool:
        """Whether a wave that is positive at both ends is seen to be so between: by bounds, slope, bend or halves."""
        between, middle = hull(low, high), (low + high) / 2
        self.parts -= 1
        if waves[0](between) > 0:
            return True
        slope = waves[1](between)
        bend = waves[2](between)
        if slope >= 0 or slope <= 0 or bend <= 0 or (bend >= 0 and waves[1](number(low)) >= 0):
            return True
        if not depth or self.parts <= 0 or not waves[0](number(middle)) > 0:
            return False
        return all(self._stays(waves, *part, depth - 1) for part in ((low, middle), (middle, high)))


@dataclass
class TheoremRun:
    """Where a motion surely is: in a box, in contact or not; with k at the edge at which a stick has ended."""

    forms: Forms
    at: StateForms
    touches: bool
    k: int = 0

    @classmethod
    def start(cls, forms: Forms, numbers: tuple[Fraction, ...], k: int = 0) -> TheoremRun:
        """Return the run from an exact state, t, x1, v1, x2, v2; with k at the edge towards a slip of that sign."""
        return cls(forms, StateForms(*map(number, numbers)), numbers[2] == numbers[4], k)

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
