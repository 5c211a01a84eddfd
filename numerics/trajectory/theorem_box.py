"""A box of states: where all motions of a scene surely are, as the kernel's program (Trajectory.v) carries it.

The program encloses closed forms by intervals; here the engine's balls stand for them, with a margin where the two may
round differently. A sign k = +1 or -1 is that of v1 - v2 in a slip, and that of the slip which follows a stick.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import NamedTuple

from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, exact_middle
from numerics.arithmetic.precision import precision
from numerics.linear.model import FIRST, FORCE
from numerics.linear.modes import Mode
from numerics.linear.pieces import ExactPiece, particular
from numerics.linear.system import LinearMode, Motion, Row, W, value
from numerics.scene import Pair, Piece

number = Ball.number
SIGN_BITS = (20, 28, 44, 60, 92, 124)
"""In what precisions it is tried to see that nothing happens in a phase; the kernel takes `SPARE_SIGN_BITS` more."""
SPARE_SIGN_BITS = 4
PARTS = 1000
"""Into how many parts a phase is cut at most for that: a file has to be judged in minutes."""
_STATE = tuple(((place, Fraction(1)),) for place in range(FIRST))


class Tone(NamedTuple):
    """(in_sine + rise_sine t) sin(turn t + phase) + (in_cosine + rise_cosine t) cos(turn t + phase), turn in rad/s."""

    in_sine: Fraction
    in_cosine: Fraction
    rise_sine: Fraction
    rise_cosine: Fraction
    turn: Fraction
    phase: Fraction


class Steady(NamedTuple):
    """A force, or how a mass answers to it: a polynomial of t - since (s), from the constant on, plus tones of t."""

    since: Fraction
    polynomial: tuple[Fraction, ...]
    tones: tuple[Tone, ...]

    @classmethod
    def force(cls, piece: Piece) -> Steady:
        """Return a force."""
        nothing = Fraction(0)
        tones = (Tone(one.amplitude, nothing, nothing, nothing, one.omega, one.phase) for one in piece.sines)
        return cls(piece.start, piece.polynomial, tuple(tones))

    def answer(self, pair: Pair, mass: Fraction) -> Steady:
        """Return a solution y of mass y'' + a1 y' + a2 y = force."""
        tones, nothing = [], Fraction(0)
        for sine, _, _, _, turn, phase in self.tones:
            stiff, damp = pair.a2 - mass * turn**2, pair.a1 * turn
            size = stiff**2 + damp**2
            parts = (stiff * sine / size, -damp * sine / size, nothing, nothing) if size else (nothing,) * 4
            tone = Tone(*parts, turn, phase)
            tones.append(tone if size else tone._replace(rise_cosine=-sine / (2 * mass * turn)))
        return Steady(self.since, tuple(particular(self.polynomial, mass, pair.a1, pair.a2)), tuple(tones))

    def rates(self, t: float) -> tuple[float, float]:
        """Return bounds on the first and the second derivative, up to a time."""
        first = second = 0.0
        for k, one in enumerate(self.polynomial):
            first += k * abs(float(one)) * t ** max(0, k - 1)
            second += k * (k - 1) * abs(float(one)) * t ** max(0, k - 2)
        for tone in self.tones:
            steady, rising, turn = abs(float(tone[0])) + abs(float(tone[1])), abs(float(tone[3])), float(tone.turn)
            first += steady * turn + rising * (1 + turn * t)
            second += (steady * turn + rising * (2 + turn * t)) * turn
        return first, second


class TooCoarse(Exception):
    """The boxes have grown too large: more bits are needed."""


class Unseen(TooCoarse):
    """It is not seen that the pair keeps its mode until the next event."""


class Program:
    """What the program computes with: a pair, the piece of its signals, the bits of states and of signs."""

    def __init__(self, pair: Pair, piece: ExactPiece, bits: int) -> None:
        """Begin with a piece."""
        self.pair, self.bits, self.sign_bits = pair, bits, SIGN_BITS[0]
        self.begin(piece)

    def begin(self, piece: ExactPiece) -> None:
        """Go on with a piece; `rates` bound those of the answers to its force, of both bodies and of body 1 alone."""
        force, end = Steady.force(piece.signals[FORCE]), float(piece.start + piece.length)
        self.piece = piece
        self.rates = [force.answer(self.pair, mass).rates(end) for mass in (self.pair.mass, self.pair.m1)]


class Guard(NamedTuple):
    """What is positive until a mode ends: a row along a motion."""

    motion: Motion
    row: Row

    def __call__(self, u: arb | Fraction) -> arb:
        """Return the value a time after the motion began, s."""
        return self.over(u)[0]

    def over(self, u: arb | Fraction) -> list[arb]:
        """Return the value, the slope and the bend over a ball of times."""
        over = self.motion.over(u if isinstance(u, arb) else number(u))
        return [over.range(self.row, order) for order in range(3)]

    def lasts(self, zeros: int, end: Fraction) -> bool:
        """Whether it is seen to be positive up to an end where it is: by its bounds, slope or bend, or by halves.

        At first it is 0, as are so many less one of its derivatives; or, of no zeros, positive.
        """
        waiting = [(Fraction(0), end)]
        for _ in range(PARTS):
            low, high = waiting.pop()
            here, slope, bend = over = self.over(hull(low, high))
            if zeros and not low:
                seen = bool(over[zeros] > 0)
            else:
                rises = bend >= 0 and self.over(low)[1] >= 0
                seen = bool(here > 0 or slope >= 0 or slope <= 0 or bend <= 0 or rises)
            if not seen:
                middle = (low + high) / 2
                if not self(middle) > 0:
                    return False
                waiting += [(middle, high), (low, middle)]
            if not waiting:
                return True
        return False


@dataclass
class Box:
    """Time and (x1, v1, x2, v2) of all motions; whether they are in contact; k at the edge where a stick has ended."""

    program: Program
    t: arb
    state: tuple[arb, ...]
    touches: bool
    k: int = 0

    @classmethod
    def start(cls, program: Program, time: Fraction, state: tuple[Fraction, ...], k: int = 0) -> Box:
        """Return the box of an exact state; with k at the edge towards a slip of that sign."""
        with precision(program.bits):
            return cls(program, number(time), tuple(map(number, state)), state[1] == state[3], k)

    @property
    def time(self) -> float:
        """Return about when it is, s."""
        return float(self.t.mid())

    def motion(self, mode: Mode) -> Motion:
        """Return the motion in a mode, as wide as the sum of an answer and a swing: both depend on the time."""
        (x1, v1, x2, v2), late = self.state, 3 * self.t.rad()
        place, speed = (arb(0, late * rate) for rate in self.program.rates[mode.sign != 0])
        mode_here = LinearMode(self.program.pair, mode.sign, self.program.piece)
        return mode_here.motion((x1 + place, v1 + speed, x2, v2), self.t)

    def guard(self, mode: Mode, k: int) -> Guard:
        """Return what is positive until a mode ends towards k: k (v1 - v2) of a slip, b - k Lambda of a stick."""
        motion = self.motion(mode)
        row = motion.mode.guards[k < 0] if mode is Mode.STICK else tuple((place, k * c) for place, c in W)
        return Guard(motion, row)

    def moved(self, mode: Mode, u: arb, ends: int = 0) -> Box:
        """Return the box a time later; where the mode ends, a stick towards `ends`."""
        over, (old_x1, _, old_x2, old_v2), t = self.motion(mode).over(u), self.state, self.t + u
        x1, v1, _, v2 = (over.range(row) for row in _STATE)
        if mode is Mode.STICK:
            x2, v2 = old_x2 + (x1 - old_x1), v1
            if ends:
                pair, b = self.program.pair, self.program.piece.b
                held = number(ends * b * pair.mass / pair.m2)
                x1 = (self.force(t) - held - number(pair.a1) * v1) / number(pair.a2)
        else:
            x2, v1 = old_x2 + (old_v2 + v2) / 2 * u, v2 if ends else v1
        touches = bool(ends) or mode is Mode.STICK
        return Box(self.program, t, (x1, v1, x2, v2), touches, ends if mode is Mode.STICK else 0)

    def force(self, t: arb) -> arb:
        """Return the force on body 1, N."""
        mode = LinearMode(self.program.pair, 0, self.program.piece)
        return value(mode.signal(FORCE), arb_mat(mode.size, 1, mode.begin(self.state, t)))

    def keeps(self, mode: Mode, k: int, guard: Guard, end: Fraction) -> None:
        """See that a guard is positive until an end, as the program does. Raises Unseen."""
        at_edge = self.k == k
        zeros = at_edge if mode is Mode.STICK else self.touches * (1 + at_edge)
        if not (zeros or guard(Fraction(0)) > 0):
            raise Unseen
        program = self.program
        for bits in SIGN_BITS[SIGN_BITS.index(program.sign_bits) :]:
            with precision(bits):
                if guard.lasts(zeros, end):
                    program.sign_bits = bits
                    return
        raise Unseen

    def hit(self, mode: Mode, k: int, time: float, places: int) -> tuple[Box, Fraction, Fraction]:
        """Return the box at the next event, near a time, and bounds of how much later it is. Raises TooCoarse."""
        with precision(self.program.bits):
            guard = self.guard(mode, k)
            if mode is not Mode.STICK and self.k not in (0, k):
                raise Unseen
            low, high = self._bracket(time - self.time, places, guard)
            self.keeps(mode, k, guard, low)
            if mode is Mode.STICK:
                self.keeps(mode, -k, self.guard(mode, -k), high)
            return self.moved(mode, hull(low, high), ends=k), low, high

    def rest(self, mode: Mode, time: Fraction) -> tuple[Box, Fraction, arb]:
        """Return the box at a time in the same mode, for how long that surely lasts, and v1 - v2 then, or TooCoarse."""
        with precision(self.program.bits):
            left = number(time) - self.t
            if not left > 0:  # the last event may be at the end
                raise TooCoarse
            least = outward(left, int(self.program.bits * 0.3))[1]
            guards = {k: self.guard(mode, k) for k in ends_of(mode)}
            if not all(guard(least) > 0 for guard in guards.values()):
                raise TooCoarse
            for k, guard in guards.items():
                self.keeps(mode, k, guard, least)
            relative = mode.sign * guards[mode.sign](left) if mode.sign else arb(0)
            return replace(self.moved(mode, left), t=number(time)), least, relative

    def sticks_for_ever(self) -> bool:
        """Whether no stick under a constant force uses up what friction holds from here on."""
        pair, (x1, v1, *_) = self.program.pair, self.state
        away = number(pair.a2) * x1 - self.force(self.t)
        reach = away**2 / number(pair.a2) + number(pair.mass) * v1**2
        held = self.program.piece.b * pair.mass / pair.m2
        return bool(number(held**2) > reach * number(pair.a2 + pair.a1**2 / pair.mass))

    def _bracket(self, guess: float, shown: int, guard: Guard) -> tuple[Fraction, Fraction]:
        """Return decimals around the root of a falling guard, sure for every state of the box."""
        root = Fraction(guess)
        places = int(self.program.bits * 0.301) - math.floor(math.log10(guess))
        for _ in range(60):
            here, slope, _ = guard.over(root)
            root -= sum(outward(here.mid() / slope.mid(), places), Fraction(0)) / 2
            if here.contains(0):
                break
        unit, steps = Fraction(10) ** -places, 1
        centre = round(root / unit)
        while True:
            low, high = ((centre + by) * unit for by in (-steps, steps))
            spare = (steps + 3) // 4 * unit  # the program's bounds are not these
            if low <= spare or steps * unit > Fraction(10) ** -shown:
                raise TooCoarse
            if guard(low) > 0 and guard(high) < 0:
                return low - spare, high + spare
            steps += (steps + 3) // 4


def ends_of(mode: Mode) -> tuple[int, ...]:
    """Return the signs of the guards that may end a mode."""
    return (mode.sign,) if mode.sign else (1, -1)


def hull(low: Fraction, high: Fraction) -> arb:
    """Return the ball from one number to another."""
    return number(low).union(number(high))


def outward(ball: arb, places: int) -> tuple[Fraction, Fraction]:
    """Return decimals with so many places around a ball."""
    unit = Fraction(10) ** places
    low, high = (exact_middle(end) * unit for end in (ball.lower(), ball.upper()))
    return math.floor(low) / unit, math.ceil(high) / unit
