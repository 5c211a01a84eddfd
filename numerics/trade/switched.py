"""The pair as a user of an integrator writes it down: one smooth field per mode, in coordinates that lose nothing.

With the load F = u(t) - a2 x1 - a1 v1 and held = b (m1+m2)/m2, friction holds the bodies together while |F| < held.
Towards one edge
of that region, s = +1 or -1 (in slip the sign of v1 - v2), the coordinates are

    r = F - s held,   v = v1,   g = v1 - v2,   z = x1 - x2,   with z' = g

    slip   m1 v' = r + s (held - b),   m1 g' = r       until s g falls to 0
    stick  (m1+m2) v' = r + s held,    g = 0           until -s r falls to 0

with r' = u'(t) - a2 v - a1 v' in both. At an exit r = g = 0 exactly, so a slip of any length can be computed to full
relative accuracy, and events are clean roots.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from numerics.errors import NumericsError
from numerics.linear.modes import MODES
from numerics.linear.pieces import pieces_of
from numerics.scene import Law, Scene
from numerics.trade.judge import Call, Run

Number = Any
"""A number of the integrator's format: float or numpy.longdouble."""
MAX_ARCS = 300_000
Extra = Any
"""What a module of the extra `comparisons` makes; it is imported late and untyped."""


class PeerFailed(NumericsError):
    """A run that does not get to the horizon: too many steps or events, or its own error."""


def unknown(scene: Any) -> str | None:
    """Return in words what is written down here of no such scene; None where it is known."""
    if not isinstance(scene, Scene):
        return "a surface"
    if scene.law is not Law.FILIPPOV:
        return f'law = "{scene.law.value}"'
    return scene.extra or None


class Span(NamedTuple):
    """The time between two jumps of u or b; numbers, arrays or formulas.

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

    @property
    def start(self) -> Number:
        """Return the time from which the polynomial counts, s."""
        return self.numbers[2]

    def u(self, t: Number, order: int, waves: Any) -> Number:
        """Return the derivative of order 0, 1 or 2 at t (s); `waves`: sine and cosine of the numbers that t is of."""
        value, numbers, sines = 0 * t, self.numbers, 3 + self.terms
        for k in range(order, self.terms):
            value += math.perm(k, order) * numbers[3 + k] * (t - self.start) ** (k - order)
        for n in range(sines, len(numbers), 3):
            wave = waves[order % 2](numbers[n + 1] * t + numbers[n + 2])
            value += (-1) ** (order // 2) * numbers[n] * numbers[n + 1] ** order * wave
        return value


class SwitchedPair:
    """A scene in an integrator's own numbers, SI units."""

    def __init__(self, scene: Scene, kind: type = float) -> None:
        """Convert a scene of Filippov's law; the mode at t = 0 is decided on exact numbers."""
        pair, at, self.kind, self.zero = scene.pair, scene.initial, kind, kind(0)
        self.m1, self.mass, self.a1, self.a2 = self.numbers(pair.m1, pair.mass, pair.a1, pair.a2)
        self.waves: Any = (math.sin, math.cos) if kind is float else (np.sin, np.cos)
        pieces, self.spans = pieces_of(scene), list[Span]()
        terms, sines = (max(len(part(one)) for one in pieces) for part in (lambda p: p.polynomial, lambda p: p.sines))
        for one in pieces:
            numbers = [one.b * pair.mass / pair.m2, one.b, one.start, *one.polynomial]
            numbers += [Fraction(0)] * (terms - len(one.polynomial))
            numbers += [part for wave in one.sines for part in (wave.amplitude, wave.omega, wave.phase)]
            numbers += [Fraction(0)] * (3 + terms + 3 * sines - len(numbers))
            self.spans.append(Span(self.numbers(one.start + one.length)[0], terms, self.numbers(*numbers)))
        self.driven = terms > 1 or sines > 0
        self.quick = 0.5 * math.sqrt(pair.m1 / pair.a2)
        """Half a radian of slip, s."""
        # exactly, lest a start on the edge misses it by a rounding error
        load = Fraction(scene.force(0)) - pair.a2 * at.x1 - pair.a1 * at.v1
        beyond = abs(load) - pieces[0].b * pair.mass / pair.m2
        self.start = self.numbers(load, at.v1, at.v1 - at.v2, at.x1 - at.x2)
        """The load F, v, g and z."""
        self.mode = int(np.sign(self.start[2])) or self.parted(
            self.spans[0], self.zero, self.start[0], beyond, self.start[1]
        )
        length = max(float(one.held / self.a2) for one in self.spans) + abs(float(at.x1))
        speed = length * math.sqrt(pair.a2 / pair.m1) + abs(float(at.v1)) + abs(float(at.v2))
        self.sizes = [length * float(pair.a2), speed, speed, length]
        """Of the coordinates: what absolute tolerances are measured by."""

    def numbers(self, *values: Fraction) -> list[Number]:
        """Return rationals in the integrator's format."""
        return [self.kind(str(one.numerator)) / self.kind(str(one.denominator)) for one in values]

    def u(self, span: Span, t: Number, order: int = 0) -> Number:
        """Return a derivative of u at t (s)."""
        return span.u(t, order, self.waves) if self.driven or not order else self.zero

    def load_rate(self, span: Span, t: Number, load: Number, v1: Number) -> Number:
        """Return F' along stick, N/s."""
        return self.u(span, t, 1) - self.a2 * v1 - self.a1 * load / self.mass

    def parted(self, span: Span, t: Number, load: Number, beyond: Number, v1: Number) -> int:
        """Return the mode after v1 = v2, towards the side of the load F; `beyond` = |F| - held.

        Where F lies on the edge the bodies part if it goes on outwards along stick; where it turns back they stick.
        """
        side = 1 if load > 0 else -1
        return side * bool(beyond > 0 or (beyond == 0 and side * self.load_rate(span, t, load, v1) > 0))

    def rates(self, slip: bool, span: Span, s: Number, push: Number, y: Any) -> list[Any]:
        """Return the time derivatives of the coordinates y, with push = u'(t); numbers, arrays or formulas."""
        r, v, g, _ = y
        pull = (r + s * (span.held - span.b)) / self.m1 if slip else (r + s * span.held) / self.mass
        return [push - self.a2 * v - self.a1 * pull, pull, *([r / self.m1, g] if slip else [0 * g, 0 * g])]

    def first_step(self, span: Span, s: int, t: Number, r: Number, v: Number) -> tuple[float, float]:
        """Return a step off the surface that ends within the slip, and when g comes back by its series, s.

        s g starts as c1 t + c2 t^2/2 + c3 t^3/6; where it leaves steeply it is not asked, and the second number is 0.
        """
        rate, pull, *_ = self.rates(True, span, s, self.u(span, t, 1), (r, v, self.zero, self.zero))
        bend = self.u(span, t, 2) - self.a2 * pull - self.a1 * rate / self.m1
        c1, c2, c3 = (float(s * one / self.m1) for one in (r, rate, bend))
        if c1 > abs(c2) * self.quick:
            return self.quick, 0.0
        inner = c2 * c2 / 4 - 2 * c1 * c3 / 3
        back = 3 * (-c2 / 2 - math.sqrt(inner)) / c3 if c3 < 0 <= inner else math.inf
        return min(back / 2, self.quick), back


Arc = Callable[[bool, Span, int, Number, list[Number]], tuple[bool, Number, list[Number]]]
"""An integrator of both modes: from slip or not, a span, the edge, the time (s) and the coordinates r, v, g, z, to
whether it met its event, the time and the coordinates there. It may stop before the end of the span where the load
turns back. Raises PeerFailed."""


def switched(integrator: Callable[[SwitchedPair, float], Arc], kind: type = float) -> Callable[[Scene, float], Call]:
    """Return what prepares an integrator, in numbers of a format: it compiles once, and each call solves the scene."""

    def prepare(scene: Scene, setting: float) -> Call:
        pair = SwitchedPair(scene, kind)
        arc = integrator(pair, setting)
        return lambda: run(pair, arc)

    return prepare


def run(pair: SwitchedPair, arc: Arc) -> Run:
    """Run from event to event and from jump to jump. Raises PeerFailed."""
    t, mode, arcs, (load, v, g, z) = pair.zero, pair.mode, 0, pair.start
    modes, times, states = [mode], list[Number](), list[tuple[Number, ...]]()

    def note(span: Span) -> None:
        """Keep the state."""
        x1 = (pair.u(span, t) - load - pair.a1 * v) / pair.a2
        states.append((x1, v, x1 - z, v - g))

    note(pair.spans[0])
    for before, span in zip([pair.spans[0], *pair.spans], pair.spans, strict=False):
        held, turned, after = span.held, 0, mode
        if span is not before:
            load += pair.u(span, t) - pair.u(before, t)
            after = mode or pair.parted(span, t, load, abs(load) - held, v)
        while True:
            if after != mode:
                modes.append(after)
                times.append(t)
                note(span)
            mode = after
            if t >= span.end:
                break
            s = mode or turned or (1 if pair.load_rate(span, t, load, v) > 0 else -1)
            met, t, (r, v, g, z) = arc(mode != 0, span, s, t, [load - s * held, v, g, z])
            load, turned, arcs = r + s * held, -s, arcs + 1
            if arcs > MAX_ARCS:
                raise PeerFailed(f"{len(times)} events by t = {t:.9g} s in {arcs} arcs")
            if met:
                side, beyond, g = (s, s * r, pair.zero) if s * r > -held else (-s, -s * r - 2 * held, pair.zero)
                if mode == 0:
                    load, after = side * held, side
                else:
                    after, turned = pair.parted(span, t, load, beyond, v), 0
    note(pair.spans[-1])
    return Run([MODES[one].value for one in modes], times, states)
