"""heyoka at its best: the system rewritten so that its events are clean roots and small slips keep their digits.

Both modes are odd, so one integrator serves both signs. The coordinates are those of the edge that matters:

    slip  (times its sign):    edge = load + held,  g = v1 - v2,  m1 v1' = held - b - edge,  m1 g' = -edge
                               until g falls to 0
    stick (times sign load'):  edge = load - held,  (m1+m2) v1' = -(held + edge)   until edge rises to 0

At an exit edge = g = 0 exactly, so a slip of any length is computed to full relative accuracy. There g has a double
zero, which heyoka's root isolation does not get past: a short step without events leads off the surface first, and in a
short slip the next step is cut to its length, so that its roots lie apart. The slip z, and with it friction's work b z,
is integrated along, and gives x2 at the end; every arc starts at time 0. Once the load has missed one edge it never
reaches the other, so one guard will do in stick.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from importlib.util import find_spec
from typing import Literal

import numpy as np

from numerics.comparisons.heyoka_peer import FAILED
from numerics.comparisons.peer import Extra, PeerFailed, PeerRun
from numerics.comparisons.switching import EventLog, SwitchedPair
from numerics.modes import EventKind
from numerics.scene import Pair, Scene

Precision = Literal["double", "long double", "quadruple"]
_FINEST = {"double": (1e-15, 1e-18), "long double": (1e-18, 1e-21), "quadruple": (1e-24, 1e-34)}


class TunedHeyokaPeer:
    """The best use found, in one of the floating point formats that heyoka compiles for."""

    use = "edge coordinates, no root at a start, work integrated along"
    knob = "tol"

    def __init__(self, precision: Precision) -> None:
        """Take the format."""
        self.precision: Precision = precision
        self.name = "heyoka" if precision == "double" else f"heyoka {precision}"
        self.settings: tuple[float, ...] = (1e-6, 1e-9, 1e-12, *_FINEST[precision])

    def missing(self) -> str | None:
        """Name heyoka if it is not installed, or the format if its build does not know it."""
        if not find_spec("heyoka"):
            return "heyoka (extra `comparisons`)"
        import heyoka

        needed = {"double": "expression", "long double": "taylor_adaptive_ldbl", "quadruple": "real128"}
        return None if hasattr(heyoka, needed[self.precision]) else f"a heyoka built with {self.precision}"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Compile slip, slip without events, and stick. Raises Unsupported."""
        first = SwitchedPair.of(scene).start.sign
        arcs = Arcs(scene.pair, self.precision, setting)
        number, zero, a1, a2, held, at = arcs.number, arcs.zero, arcs.a1, arcs.a2, arcs.held, scene.initial
        until, x1, v1, gap, apart = (
            number(value) for value in (scene.until, at.x1, at.v1, at.v1 - at.v2, at.x1 - at.x2)
        )

        def run() -> PeerRun:
            log, arcs.steps = EventLog(), 0
            t, load, v, g, sign = zero, a2 * x1 + a1 * v1, v1, gap, first  # sign 0 is stick
            slipped, work = zero, zero  # the integrals of v1 - v2 and of the power lost
            while True:
                if sign == 0:
                    to = 1 if a2 * v > a1 * load / arcs.mass else -1
                    met, length, (edge, v, *lost) = arcs.stick((to * load - held, to * v, *arcs.rest), until - t)
                    load, v, g, after = to * (held if met else edge + held), to * v, zero, -to
                    kind = EventKind.EXIT
                else:
                    start = (sign * load + held, sign * v, sign * g, zero, *arcs.rest)
                    met, length, (edge, v, g, z, *lost) = arcs.slip(start, until - t)
                    load, v, g = sign * (edge - held), sign * v, zero if met else sign * g
                    slipped, work = slipped + sign * z, work + arcs.b * z
                    crosses = edge >= 2 * held and (edge > 2 * held or sign * (a2 * v - a1 * load / arcs.mass) > zero)
                    after, kind = (-sign, EventKind.CROSSING) if crosses else (0, EventKind.ENTRY)
                if lost:
                    work = work + a1 * lost[0]
                if not met:
                    break
                t = t + length
                log.add(kind, float(t))
                sign = after
            x = (load - a1 * v) / a2
            y = np.array([float(x), float(v), float(x - apart - slipped), float(v - g)])
            return PeerRun(tuple(log.kinds), np.array(log.times), y, float(work), arcs.steps)

        return run


class Arcs:
    """The compiled arcs of a pair, in edge coordinates: from a start to their event, or over the time that is left.

    They return whether the event was met, the length of the arc, and the coordinates at its end.
    """

    def __init__(self, pair: Pair, precision: Precision, tolerance: float) -> None:
        """Compile for a pair."""
        import heyoka as hy

        self.kind, self.number = formats(precision)
        number, held = self.number, pair.a2 * pair.half_width
        self.zero = number(Fraction(0))
        self.a1, self.a2, self.b, self.held = (number(value) for value in (pair.a1, pair.a2, pair.b, held))
        self.m1, self.mass, self.push = (number(value) for value in (pair.m1, pair.mass, held - pair.b))
        self.quick = 0.5 * math.sqrt(pair.m1 / pair.a2)  # half a radian of slip, s
        self.floats = tuple(float(value) for value in (self.m1, self.a1, self.a2, self.push))
        self.cut = int(hy.taylor_outcome.time_limit)
        self.steps = 0
        edge, v, g, z, u = hy.make_vars("edge", "v", "g", "z", "u")
        viscous = [(u, v * v)] if pair.a1 > 0 else []
        self.rest = [self.zero] * len(viscous)
        slip_pull, stick_pull = (self.push - edge) / self.m1, -(self.held + edge) / self.mass
        slip = [(edge, self.a2 * v + self.a1 * slip_pull), (v, slip_pull), (g, -edge / self.m1), (z, g), *viscous]
        stick = [(edge, self.a2 * v + self.a1 * stick_pull), (v, stick_pull), *viscous]
        falling = hy.t_event(g, direction=hy.event_direction.negative, fp_type=self.kind)
        rising = hy.t_event(edge, direction=hy.event_direction.positive, fp_type=self.kind)
        self.leaving, self.slipping, self.sticking = (
            (one, one.state)
            for one in (
                hy.taylor_adaptive(
                    system, [self.zero] * len(system), t_events=guards, fp_type=self.kind, tol=self.kind(tolerance)
                )
                for system, guards in ((slip, []), (slip, [falling]), (stick, [rising]))
            )
        )

    def slip(self, start: Extra, left: Extra) -> Extra:
        """Slip until g falls to 0."""
        integrator, state = self.slipping
        off = longest = self.zero
        if start[2] == self.zero and (back := self._comes_back(float(start[0]), float(start[1]))):
            leaving, away = self.leaving
            _place(leaving, away, start, self.zero)
            leaving.step(min(left, self.kind(min(back / 2, self.quick))))
            self.steps += 1
            start, off = away.tolist(), leaving.time
            longest = self.kind(1.5 * back) if back < self.quick else self.zero
        _place(integrator, state, start, self.zero)
        integrator.reset_cooldowns()
        met = self._advance(integrator, left - off, longest)
        return met, off + integrator.time, state.tolist()

    def stick(self, start: Extra, left: Extra) -> Extra:
        """Stick until edge rises to 0."""
        integrator, state = self.sticking
        _place(integrator, state, start, self.zero)
        integrator.reset_cooldowns()
        met = self._advance(integrator, left, self.zero)
        return met, integrator.time, state.tolist()

    def _advance(self, integrator: Extra, left: Extra, longest: Extra) -> bool:
        """Go on to the event (True) or until the time is up (False); first by a step of at most `longest`, if any."""
        if longest:
            code = int(integrator.step(min(left, longest))[0])
            self.steps += 1
            if code > FAILED:
                return True
        outcome, _, _, steps, *_ = integrator.propagate_until(left)
        self.steps += steps
        code = int(outcome)
        if code <= FAILED and code != self.cut:
            raise PeerFailed(f"heyoka: {outcome}")
        return code > FAILED

    def _comes_back(self, edge: float, v: float) -> float:
        """Return when c1 t + c2 t^2/2 + c3 t^3/6, the start of g, comes back to 0, s; 0 if g leaves steeply."""
        m1, a1, a2, push = self.floats
        pull = (push - edge) / m1
        rate = a2 * v + a1 * pull
        c1, c2, c3 = -edge / m1, -rate / m1, -(a2 * pull - a1 * rate / m1) / m1
        if c1 > abs(c2) * self.quick:
            return 0.0
        inner = c2 * c2 / 4 - 2 * c1 * c3 / 3
        return 3 * (-c2 / 2 - math.sqrt(inner)) / c3 if c3 < 0 <= inner else math.inf


def _place(integrator: Extra, state: Extra, start: Extra, zero: Extra) -> None:
    integrator.time = zero
    for index, value in enumerate(start):
        state[index] = value


def formats(precision: Precision) -> tuple[Extra, Callable[[Fraction], Extra]]:
    """Return heyoka's type for a format and the nearest conversion of a rational to it."""
    if precision == "double":
        return float, float
    if precision == "long double":
        kind: Extra = np.longdouble
    else:
        import heyoka

        kind = heyoka.real128
    return kind, lambda value: kind(str(value.numerator)) / kind(str(value.denominator))
