"""heyoka at its best: edge coordinates, and no event function with a root at the start of a step.

At an exit g has a double zero, which heyoka's root isolation does not get past: it loses the next root of that step. So
a short step without events leads off the surface first, and in a short slip the next step is cut to its length, so that
the roots lie apart.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from importlib.util import find_spec
from typing import Literal

import numpy as np

from numerics.comparisons.edge_coordinates import EdgePair, run_by_edges
from numerics.comparisons.heyoka_peer import FAILED
from numerics.comparisons.peer import Extra, PeerFailed, PeerRun
from numerics.scene import Scene

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
        kind, number = formats(self.precision)
        pair = EdgePair(scene, number)
        arcs = HeyokaArcs(pair, kind, setting)
        return lambda: run_by_edges(pair, arcs)


class HeyokaArcs:
    """The compiled arcs."""

    def __init__(self, pair: EdgePair, kind: Extra, tolerance: float) -> None:
        """Compile for a pair."""
        import heyoka as hy

        self.pair, self.kind, self.zero, self.steps = pair, kind, pair.zero, 0
        self.cut = int(hy.taylor_outcome.time_limit)
        edge, v, g, z, u = hy.make_vars("edge", "v", "g", "z", "u")
        viscous = [(u, v * v)] if pair.rest else []
        slip_pull, stick_pull = (pair.push - edge) / pair.m1, -(pair.held + edge) / pair.mass
        slip = [(edge, pair.a2 * v + pair.a1 * slip_pull), (v, slip_pull), (g, -edge / pair.m1), (z, g), *viscous]
        stick = [(edge, pair.a2 * v + pair.a1 * stick_pull), (v, stick_pull), *viscous]
        falling = hy.t_event(g, direction=hy.event_direction.negative, fp_type=kind)
        rising = hy.t_event(edge, direction=hy.event_direction.positive, fp_type=kind)

        def compiled(system: Extra, guards: Extra) -> Extra:
            start = [self.zero] * len(system)
            one = hy.taylor_adaptive(system, start, t_events=guards, fp_type=kind, tol=kind(tolerance))
            return one, one.state

        self.leaving, self.slipping = compiled(slip, []), compiled(slip, [falling])
        self.sticking = compiled(stick, [rising])

    def slip(self, start: Extra, left: Extra) -> Extra:
        """Slip until g falls to 0."""
        integrator, state = self.slipping
        off = longest = self.zero
        if start[2] == self.zero and (back := self.pair.comes_back(float(start[0]), float(start[1]))):
            leaving, away = self.leaving
            _place(leaving, away, start, self.zero)
            leaving.step(min(left, self.kind(min(back / 2, self.pair.quick))))
            self.steps += 1
            start, off = away.tolist(), leaving.time
            longest = self.kind(1.5 * back) if back < self.pair.quick else self.zero
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


def _place(integrator: Extra, state: Extra, start: Extra, zero: Extra) -> None:
    integrator.time = zero
    for index, value in enumerate(start):
        state[index] = value


def formats(precision: Precision) -> tuple[Extra, Callable[[Fraction], Extra]]:
    """Return heyoka's type for a format and the conversion of a rational to it."""
    if precision == "double":
        return float, float
    if precision == "long double":
        kind: Extra = np.longdouble
    else:
        import heyoka

        kind = heyoka.real128
    return kind, lambda value: kind(str(value.numerator)) / kind(str(value.denominator))
