"""The pair as a user of an integrator writes it down: one smooth field per mode, in coordinates that lose nothing.

With the load F = u(t) - a2 x1 - a1 v1 and held = b (m1+m2)/m2, friction holds the bodies together while |F| < held.
Towards one edge of that region, s = +1 or -1 (in slip the sign of v1 - v2), the coordinates are

    room = held - s F,   v = s v1,   g = s (v1 - v2),   z' = g

    slip   m1 v' = held - b - room,   m1 g' = -room     until g falls to 0
    stick  (m1+m2) v' = held - room,  g = 0             until room falls to 0

with room' = a2 v + a1 v' - s u'(t) in both; and the integral of v^2 where there is viscosity. At an exit room = g = 0
exactly, so a slip of any length can be computed to full relative accuracy, and events are clean roots.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from enum import Enum
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.scene import Law, Pair, Scene
from numerics.trade.comparisons.peer import Call, PeerFailed, PeerRun, Unsupported

Number = Any
"""A number of the integrator's format: float or numpy.longdouble."""
MAX_EVENTS, MAX_IDLE = 300_000, 100


def slips(beyond: Number, rate: Number) -> bool:
    """Return whether bodies at one speed part, towards the side of the load F: the one rule of all integrators here.

    `beyond` = |F| - held and `rate` is the time derivative of |F| along stick. Where F lies on the edge they part if it
    goes on outwards; where it turns back they stick.
    """
    return bool(beyond > 0 or (beyond == 0 and rate > 0))


class Span(NamedTuple):
    """The time between two jumps of u or b (its end, s); numbers, arrays or formulas.

    `numbers` are held and b (N), and u: an origin, the coefficients of a polynomial in t - origin (so many `terms`,
    constant first), and three for each sine: amplitude, omega, phase.
    """

    end: Number
    terms: int
    numbers: Any

    @property
    def held(self) -> Number:
        """Return b (m1+m2)/m2, the largest load that friction holds in stick, N."""
        return self.numbers[0]

    @property
    def b(self) -> Number:
        """Return the friction force, N."""
        return self.numbers[1]

    def u(self, t: Number, order: int = 0, waves: Any = (math.sin, math.cos)) -> Number:
        """Return the derivative of order 0, 1 or 2 at t (s); `waves`: sine and cosine of the numbers that t is of."""
        value, numbers, sines = 0 * t, self.numbers, 3 + self.terms
        for k in range(order, self.terms):
            value += math.perm(k, order) * numbers[3 + k] * (t - numbers[2]) ** (k - order)
        for n in range(sines, len(numbers), 3):
            wave = waves[order % 2](numbers[n + 1] * t + numbers[n + 2])
            value += (-1) ** (order // 2) * numbers[n] * numbers[n + 1] ** order * wave
        return value


class SwitchedPair:
    """A scene in an integrator's own numbers, SI units."""

    def __init__(self, scene: Scene, kind: type = float) -> None:
        """Convert; the mode at t = 0 is decided on exact numbers. Raises Unsupported."""
        if scene.law is not Law.FILIPPOV:
            raise Unsupported(f"only the law {Law.FILIPPOV.value} is written down for this integrator")
        pair, at, self.kind, self.zero = scene.pair, scene.initial, kind, kind(0)
        self.m1, self.mass, self.a1, self.a2 = self.numbers(pair.m1, pair.mass, pair.a1, pair.a2)
        self.waves: Any = (math.sin, math.cos) if kind is float else (np.sin, np.cos)
        self.viscous = [self.zero] if pair.a1 > 0 else []
        """Where the integral of v^2 starts, if there is viscosity."""
        pieces = pieces_of(scene)
        self.spans = self._spans(pair, pieces)
        self.driven = self.spans[0].terms > 1 or len(self.spans[0].numbers) > 3 + self.spans[0].terms
        self.quick = 0.5 * math.sqrt(pair.m1 / pair.a2)
        """Half a radian of slip, s."""
        # exactly, lest a start on the edge misses it by a rounding error
        load = Fraction(scene.force(0)) - pair.a2 * at.x1 - pair.a1 * at.v1
        held = pieces[0].b * pair.mass / pair.m2
        self.load, self.v1, self.gap, self.apart = self.numbers(load, at.v1, at.v1 - at.v2, at.x1 - at.x2)
        side = 1 if load > 0 else -1
        parts = slips(abs(load) - held, side * self.load_rate(self.spans[0], self.zero, self.load, self.v1))
        self.mode = int(np.sign(self.gap)) or side * parts
        length = max(float(one.held / self.a2) for one in self.spans) + abs(float(at.x1))
        speed = length * math.sqrt(pair.a2 / pair.m1) + abs(float(at.v1)) + abs(float(at.v2))
        self.sizes = [length * float(pair.a2), speed, speed, length, speed * length][: 4 + len(self.viscous)]
        """Of the coordinates: what absolute tolerances are measured by."""

    def numbers(self, *values: Fraction | int) -> list[Number]:
        """Return rationals in the integrator's format."""
        return [self.kind(str(one.numerator)) / self.kind(str(one.denominator)) for one in values]

    def _spans(self, pair: Pair, pieces: Sequence[ExactPiece]) -> list[Span]:
        terms, sines, spans = max(len(one.polynomial) for one in pieces), max(len(one.sines) for one in pieces), []
        for piece in pieces:
            waves: list[Any] = [part for one in piece.sines for part in (one.amplitude, one.omega, one.phase)]
            powers = [*piece.polynomial, *[0] * (terms - len(piece.polynomial))]
            u = [piece.start, *powers, *waves, *[0] * (3 * sines - len(waves))]
            end, held = piece.start + piece.length, piece.b * pair.mass / pair.m2
            spans.append(Span(self.numbers(end)[0], terms, self.numbers(held, piece.b, *u)))
        return spans

    def load_rate(self, span: Span, t: Number, load: Number, v1: Number) -> Number:
        """Return F' along stick, N/s."""
        rate = -self.a2 * v1 - self.a1 * load / self.mass
        return rate + self.u(span, t, 1) if self.driven else rate

    def u(self, span: Span, t: Number, order: int = 0) -> Number:
        """Return a derivative of u at t (s)."""
        return span.u(t, order, self.waves)

    def rates(self, slip: bool, span: Span, s: Number, push: Number, y: Any) -> list[Any]:
        """Return the time derivatives of the coordinates y, with push = u'(t); numbers, arrays or formulas."""
        room, v, g, _, *viscous = y
        pull = (span.held - span.b - room) / self.m1 if slip else (span.held - room) / self.mass
        apart = [-room / self.m1, g] if slip else [0 * g, 0 * g]
        return [self.a2 * v + self.a1 * pull - s * push, pull, *apart, *[v * v] * len(viscous)]

    def first_step(self, span: Span, s: int, t: Number, room: Number, v: Number) -> tuple[float, float]:
        """Return a step off the surface that ends within the slip, and when g comes back by its series, s.

        g starts as c1 t + c2 t^2/2 + c3 t^3/6; where it leaves steeply it is not asked, and the second number is 0.
        """
        pull = (span.held - span.b - room) / self.m1
        rate, bend = self.a2 * v + self.a1 * pull, self.a2 * pull
        if self.driven:
            rate, bend = rate - s * self.u(span, t, 1), bend - s * self.u(span, t, 2)
        c1, c2, c3 = (float(one / self.m1) for one in (-room, -rate, self.a1 * rate / self.m1 - bend))
        if c1 > abs(c2) * self.quick:
            return self.quick, 0.0
        inner = c2 * c2 / 4 - 2 * c1 * c3 / 3
        back = 3 * (-c2 / 2 - math.sqrt(inner)) / c3 if c3 < 0 <= inner else math.inf
        return min(back / 2, self.quick), back


class Asked(NamedTuple):
    """What an arc is asked: in slip or stick, in which span, towards which edge, from when (s) and where, how far."""

    slip: bool
    span: Span
    s: int
    t: Number
    start: list[Number]
    """room, v, g, z, and the integral of v^2 where there is viscosity."""
    until: Number
    still: bool
    """The load starts with the rate 0, so its turning is no event."""


class Ended(Enum):
    """How an arc ended: at its event; where the load turns back in stick, for who looks at step ends; at its time."""

    MET, TURNED, TIME = range(3)


Arc = Callable[[Asked], tuple[Ended, Number, list[Number]]]
"""An integrator of both modes: how an arc ended, when (s), and the coordinates there. Raises PeerFailed."""


def switched(integrator: Callable[[SwitchedPair, float], Arc], kind: type = float) -> Callable[[Scene, float], Call]:
    """Return what prepares an integrator, in numbers of a format."""

    def prepare(scene: Scene, setting: float) -> Call:
        pair = SwitchedPair(scene, kind)
        arc = integrator(pair, setting)
        return lambda: run(pair, arc)

    return prepare


def run(pair: SwitchedPair, arc: Arc) -> PeerRun:
    """Run from event to event and from jump to jump. Raises PeerFailed."""
    t = slipped = lost = pair.zero
    load, v1, gap, mode, idle = pair.load, pair.v1, pair.gap, pair.mode, 0
    events: list[tuple[int, Number]] = []
    for before, span in zip([pair.spans[0], *pair.spans], pair.spans, strict=False):
        held, turned = span.held, 0
        if span is not before:
            load += pair.u(span, t) - pair.u(before, t)
            side = 1 if load > 0 else -1
            if mode == 0 and slips(abs(load) - held, side * pair.load_rate(span, t, load, v1)):
                mode = side
                events.append((mode, t))
        while t < span.end:
            rate = pair.zero if mode else pair.load_rate(span, t, load, v1)
            s, still = mode or turned or (1 if rate > 0 else -1), mode == turned == rate == 0
            until = min(span.end, t + pair.quick) if still else span.end
            start = [held - s * load, s * v1, s * gap, pair.zero, *pair.viscous]
            ended, at, (room, v, g, z, *viscous) = arc(Asked(mode != 0, span, s, t, start, until, still))
            idle = idle + 1 if at <= t else 0
            if idle > MAX_IDLE or len(events) > MAX_EVENTS:
                raise PeerFailed(f"{len(events)} events by t = {t:.9g} s, {idle} arcs on the spot")
            t, load, v1, gap, turned = at, s * (held - room), s * v, s * g, -s if ended is Ended.TURNED else 0
            slipped, lost = slipped + s * z, lost + span.b * z
            if viscous:
                lost += pair.a1 * viscous[0]
            if ended is not Ended.MET:
                continue
            side, gap, after = s if room < held else -s, pair.zero, mode
            if mode == 0:
                load, after = side * held, side
            else:
                beyond = -room if side == s else room - 2 * held
                after = side * slips(beyond, side * pair.load_rate(span, t, load, v1))
            if after != mode:
                events.append((after, t))
            mode = after
    x1 = (pair.u(pair.spans[-1], t) - load - pair.a1 * v1) / pair.a2
    return PeerRun.of(pair.mode, events, (x1, v1, x1 - pair.apart - slipped, v1 - gap), lost)
