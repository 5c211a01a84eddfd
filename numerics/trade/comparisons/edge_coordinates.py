"""The switched pair rewritten so that events are clean roots and small slips keep their digits: any integrator's best.

Both modes are odd, so one system serves both signs. The coordinates are those of the edge of S0 that matters:

    slip  (times its sign):    edge = load + held,  g = v1 - v2,  m1 v1' = held - b - edge,  m1 g' = -edge,  z' = g
                               until g falls to 0
    stick (times sign load'):  edge = load - held,  (m1+m2) v1' = -(held + edge)   until edge rises to 0

with edge' = a2 v1 + a1 v1' in both. At an exit edge = g = 0 exactly, so a slip of any length can be computed to full
relative accuracy. The slip z, and with it friction's work b z, is integrated along, and gives x2 at the end; so is
u = int v1^2 dt where there is viscosity. Every arc starts at time 0. Once the load has missed one edge it never reaches
the other, so one guard will do in stick.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Protocol

import numpy as np

from numerics.motion.modes import EventKind
from numerics.scene import Scene
from numerics.trade.comparisons.peer import Extra, PeerRun, PeerTexts
from numerics.trade.comparisons.switching import EventLog, SwitchedPair


class EdgePair:
    """The constants of a scene in an integrator's own numbers (`number` converts a rational), SI units."""

    def __init__(self, scene: Scene, number: Callable[[Fraction], Extra]) -> None:
        """Convert. Raises Unsupported."""
        pair, at = scene.pair, scene.initial
        held = pair.a2 * pair.half_width
        self.number, self.zero = number, number(Fraction(0))
        self.first = SwitchedPair.of(scene).start.sign
        # the load exactly, lest a start on the edge of S0 misses it by a rounding error
        self.until, self.load, self.v1 = number(scene.until), number(pair.a2 * at.x1 + pair.a1 * at.v1), number(at.v1)
        self.gap, self.apart = number(at.v1 - at.v2), number(at.x1 - at.x2)
        self.a1, self.a2, self.b, self.held = (number(value) for value in (pair.a1, pair.a2, pair.b, held))
        self.m1, self.mass, self.push = (number(value) for value in (pair.m1, pair.mass, held - pair.b))
        self.rest = [self.zero] if pair.a1 > 0 else []
        """Where u starts, if there is viscosity."""
        self.quick = 0.5 * math.sqrt(pair.m1 / pair.a2)
        """Half a radian of slip, s."""
        self._floats = tuple(float(value) for value in (self.m1, self.a1, self.a2, self.push))

    def comes_back(self, edge: float, v: float) -> float:
        """Return when c1 t + c2 t^2/2 + c3 t^3/6, the start of g, comes back to 0, s; 0 if g leaves steeply.

        For a slip from an exit, undamped, that is never before g itself comes back.
        """
        m1, a1, a2, push = self._floats
        pull = (push - edge) / m1
        rate = a2 * v + a1 * pull
        c1, c2, c3 = -edge / m1, -rate / m1, -(a2 * pull - a1 * rate / m1) / m1
        if c1 > abs(c2) * self.quick:
            return 0.0
        inner = c2 * c2 / 4 - 2 * c1 * c3 / 3
        return 3 * (-c2 / 2 - math.sqrt(inner)) / c3 if c3 < 0 <= inner else math.inf

    def turning(self, edge: Extra, v: Extra) -> Extra:
        """Return load' in stick, times half a radian's time, N: it falls to 0 where the load turns."""
        return (self.a2 * v - self.a1 * (self.held + edge) / self.mass) * self.quick

    def leaves(self, edge: Extra, v: Extra) -> bool:
        """Tell whether a stick arc that ended where min(-edge, turning) fell to 0 has met the edge before it turned."""
        return bool(-edge <= self.turning(edge, v))


class EdgeArcs(Protocol):
    """An integrator of both systems: each arc goes to its event, or over the time that is left.

    An arc returns whether the event was met, its length (s), and the coordinates at its end: edge, v, g, z (and u) of a
    slip, edge, v (and u) of a stick.
    """

    steps: int
    """How many steps were taken since it was set to 0."""

    def slip(self, start: Extra, left: Extra) -> Extra:
        """Slip until g falls to 0."""

    def stick(self, start: Extra, left: Extra) -> Extra:
        """Stick until edge rises to 0."""


def run_by_edges(pair: EdgePair, arcs: EdgeArcs, text: Callable[[Extra], str] | None = None) -> PeerRun:
    """Run from event to event, by the rules of motion/modes.py; `text` writes numbers that are finer than floats."""
    zero, a1, a2, held = pair.zero, pair.a1, pair.a2, pair.held
    log, arcs.steps = EventLog(), 0
    t, load, v, g, sign = zero, pair.load, pair.v1, pair.gap, pair.first  # sign 0 is stick
    slipped, work = zero, zero  # the integrals of v1 - v2 and of the power lost
    while True:
        if sign == 0:
            to = 1 if a2 * v > a1 * load / pair.mass else -1
            met, length, (edge, v, *lost) = arcs.stick((to * load - held, to * v, *pair.rest), pair.until - t)
            load, v, g, after = to * (held if met else edge + held), to * v, zero, -to
            kind = EventKind.EXIT
        else:
            start = (sign * load + held, sign * v, sign * g, zero, *pair.rest)
            met, length, (edge, v, g, z, *lost) = arcs.slip(start, pair.until - t)
            load, v, g = sign * (edge - held), sign * v, zero if met else sign * g
            slipped, work = slipped + sign * z, work + pair.b * z
            crosses = edge >= 2 * held and (edge > 2 * held or sign * (a2 * v - a1 * load / pair.mass) > zero)
            after, kind = (-sign, EventKind.CROSSING) if crosses else (0, EventKind.ENTRY)
        if lost:
            work = work + a1 * lost[0]
        if not met:
            break
        t = t + length
        log.add(kind, float(t))
        sign = after
        if not t < pair.until:
            break
    x = (load - a1 * v) / a2
    final = (x, v, x - pair.apart - slipped, v - g)

    def texts(write: Callable[[Extra], str]) -> PeerTexts:
        return PeerTexts(write(t) if log.kinds else None, tuple(write(value) for value in final), write(work))

    y = np.array([float(value) for value in final])
    exact = None if text is None else partial(texts, text)
    return PeerRun(tuple(log.kinds), np.array(log.times), y, float(work), arcs.steps, texts=exact)
