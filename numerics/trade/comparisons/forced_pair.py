"""The switched system under a force, as a user of an integrator writes it down: floats, one smooth field per mode.

Between two jumps of u or b (a span), with the load F = u(t) - a2 x1 - a1 v1 and held = b (m1+m2)/m2,

    slip of sign s:  m1 v1' = F - b s,  m2 v2' = b s          until v1 - v2 reaches 0
    stick:           (m1+m2) v1' = (m1+m2) v2' = F            until |F| exceeds held

and lost' = b |v1 - v2| + a1 v1^2 is integrated along. Every jump restarts the integrator, and in stick the mode is
asked again. What decides are floats: a tie comes out as rounding has it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Protocol

import numpy as np

from numerics.motion.modes import MODES, Mode, event_kind
from numerics.scene import Law, Scene
from numerics.trade.comparisons.peer import Extra, PeerRun, Unsupported
from numerics.trade.comparisons.switching import EventLog


@dataclass(frozen=True)
class Span:
    """The time between two jumps, with u and b on it; u = sum_k polynomial[k] (t - origin)^k plus the sines."""

    start: float
    end: float
    origin: float
    polynomial: tuple[float, ...]
    sines: tuple[tuple[float, float, float], ...]
    """(amplitude, omega, phase)"""
    b: float

    def force(self) -> Callable[[float], float]:
        """Return u(t), N."""
        origin, reverse, sines = self.origin, self.polynomial[::-1], self.sines

        def u(t: float) -> float:
            value = 0.0
            for coefficient in reverse:
                value = value * (t - origin) + coefficient
            for amplitude, omega, phase in sines:
                value += amplitude * math.sin(omega * t + phase)
            return value

        return u


@dataclass(frozen=True)
class ForcedPair:
    """A scene in floats, SI units."""

    m1: float
    m2: float
    a1: float
    a2: float
    y: tuple[float, float, float, float]
    spans: tuple[Span, ...]

    @classmethod
    def of(cls, scene: Scene) -> ForcedPair:
        """Return the scene in floats. Raises Unsupported."""
        if scene.law is not Law.FILIPPOV:
            raise Unsupported(f"only the law {Law.FILIPPOV.value} is written down for this integrator")
        pair, at = scene.pair, scene.initial
        m1, m2, a1, a2, *y = (
            float(value) for value in (pair.m1, pair.m2, pair.a1, pair.a2, at.x1, at.v1, at.x2, at.v2)
        )
        return cls(m1, m2, a1, a2, (y[0], y[1], y[2], y[3]), spans_of(scene))

    @property
    def mass(self) -> float:
        """Return m1 + m2, kg."""
        return self.m1 + self.m2

    def held(self, span: Span) -> float:
        """Return b (m1+m2)/m2, the largest load that friction holds in stick, N."""
        return span.b * self.mass / self.m2

    def energy(self, y: Sequence[float]) -> float:
        """Return E = (a2 x1^2 + m1 v1^2 + m2 v2^2)/2, J."""
        return (self.a2 * y[0] ** 2 + self.m1 * y[1] ** 2 + self.m2 * y[3] ** 2) / 2

    @property
    def scales(self) -> tuple[float, float]:
        """Return a length (m) and a speed (m/s) of the motion, by which absolute tolerances are measured."""
        length = max(self.held(span) for span in self.spans) / self.a2 + abs(self.y[0])
        return length, length * math.sqrt(self.a2 / self.mass) + abs(self.y[1]) + abs(self.y[3])

    def on_surface(self, span: Span, u: Callable[[float], float], t: float, x1: float, v1: float) -> Mode:
        """Return the mode that follows where v1 = v2."""
        load = u(t) - self.a2 * x1 - self.a1 * v1
        return Mode.STICK if abs(load) <= self.held(span) else MODES[1 if load > 0 else -1]


def spans_of(scene: Scene) -> tuple[Span, ...]:
    """Return the times between jumps, in order, with what acts on each."""
    jumps = {Fraction(0), *scene.force.starts, *scene.friction.starts}
    times = [*sorted(at for at in jumps if at < scene.until), scene.until]
    b, frictions, spans = scene.pair.b, dict(scene.friction.pieces), []
    for start, end in pairwise(times):
        piece, b = scene.force.piece_at(start), frictions.get(start, b)
        sines = tuple((float(one.amplitude), float(one.omega), float(one.phase)) for one in piece.sines)
        numbers = float(start), float(end), float(piece.start)
        spans.append(Span(*numbers, tuple(map(float, piece.polynomial)), sines, float(b)))
    return tuple(spans)


class Arcs(Protocol):
    """An integrator of all modes."""

    steps: int
    """How many steps were taken since it was set to 0."""

    def arc(self, span: Span, mode: Mode, t: float, y: Extra) -> tuple[bool, float, Extra]:
        """Go on from t, y = (x1, v1, x2, v2, lost) to the guard (True) or the end of the span; return t and y there."""


def run_by_spans(pair: ForcedPair, arcs: Arcs) -> PeerRun:
    """Run from event to event and from jump to jump."""
    log, arcs.steps = EventLog(), 0
    t, y, apart = 0.0, np.array([*pair.y, 0.0]), pair.y[1] - pair.y[3]
    mode = MODES[1 if apart > 0 else -1] if apart else None
    for span in pair.spans:
        u = span.force()
        if mode is None or mode is Mode.STICK:
            after = pair.on_surface(span, u, t, y[0], y[1])
            if mode is not None and after is not mode:
                log.add(event_kind(mode, after), t)
            mode = after
        while t < span.end:
            met, t, y = arcs.arc(span, mode, t, y)
            if not met:
                break
            if mode is Mode.STICK:
                after = MODES[1 if u(t) - pair.a2 * y[0] - pair.a1 * y[1] > 0 else -1]
            else:
                y[3] = y[1]
                after = pair.on_surface(span, u, t, y[0], y[1])
            if after is not mode:
                log.add(event_kind(mode, after), t)
            mode = after
        t = span.end
    return PeerRun(tuple(log.kinds), np.array(log.times), y[:4].copy(), float(y[4]), arcs.steps)
