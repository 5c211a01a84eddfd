"""heyoka at its best: edge coordinates, and no event function with a root at the start of a step.

At an exit g has a double zero, which heyoka's root isolation does not get past: it loses the next root of that step. So
a short step without events leads off the surface first, and in a short slip the next step is cut to its length, so that
the roots lie apart. In many digits a step gets so long that roots are lost again, unless it is cut to part of a radian.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from importlib.util import find_spec

from numerics.scene import Scene
from numerics.trade.comparisons.edge_coordinates import EdgePair, run_by_edges
from numerics.trade.comparisons.heyoka_formats import Format, Precision, format_of
from numerics.trade.comparisons.heyoka_peer import FAILED
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun

_FINEST = {"double": (1e-15, 1e-18), "long double": (1e-18, 1e-21), "quadruple": (1e-24, 1e-34)}
_DIGITS = (50.0, 100.0, 300.0)
_LONGEST = 0.7
"""The longest step in many digits, radians of its mode: the fastest found that loses no root up to 300 digits."""
_NEEDED = {
    "double": "expression",
    "long double": "taylor_adaptive_ldbl",
    "quadruple": "real128",
    "real": "taylor_adaptive_real",
}


class TunedHeyokaPeer:
    """The best use found, in one of the floating point formats that heyoka compiles for."""

    forced = False
    use = "edge coordinates, no root at a start, work integrated along"

    def __init__(self, precision: Precision) -> None:
        """Take the format; the knob of "real" is its digits, its tolerance the last of them."""
        self.precision: Precision = precision
        self.name = "heyoka" if precision == "double" else f"heyoka {precision}"
        self.knob = "digits" if precision == "real" else "tol"
        self.settings: tuple[float, ...] = _DIGITS if precision == "real" else (1e-6, 1e-9, 1e-12, *_FINEST[precision])

    def missing(self) -> str | None:
        """Name heyoka if it is not installed, or the format if its build does not know it."""
        if not find_spec("heyoka"):
            return "heyoka (extra `comparisons`)"
        import heyoka

        return None if hasattr(heyoka, _NEEDED[self.precision]) else f"a heyoka built with {self.precision}"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Compile slip, slip without events, and stick. Raises Unsupported."""
        many = self.precision == "real"
        form = format_of(self.precision, int(setting) if many else 0)
        tolerance = form.number(Fraction(1, 10 ** int(setting))) if many else form.read(setting)
        pair = EdgePair(scene, form.number)
        arcs = HeyokaArcs(pair, form, tolerance, _LONGEST if many else None)
        text = None if self.precision == "double" else form.text
        return lambda: run_by_edges(pair, arcs, text)


class HeyokaArcs:
    """The compiled arcs."""

    def __init__(self, pair: EdgePair, form: Format, tolerance: Extra, longest: float | None) -> None:
        """Compile for a pair; `longest` caps the steps, in radians of each mode."""
        import heyoka as hy

        self.pair, self.read, self.zero, self.steps = pair, form.read, pair.zero, 0
        kind = form.kind
        self.cut = int(hy.taylor_outcome.time_limit)
        edge, v, g, z, u = hy.make_vars("edge", "v", "g", "z", "u")
        viscous = [(u, v * v)] if pair.rest else []
        slip_pull, stick_pull = (pair.push - edge) / pair.m1, -(pair.held + edge) / pair.mass
        slip = [(edge, pair.a2 * v + pair.a1 * slip_pull), (v, slip_pull), (g, -edge / pair.m1), (z, g), *viscous]
        stick = [(edge, pair.a2 * v + pair.a1 * stick_pull), (v, stick_pull), *viscous]
        falling = hy.t_event(g, direction=hy.event_direction.negative, fp_type=kind)
        rising = hy.t_event(edge, direction=hy.event_direction.positive, fp_type=kind)

        def compiled(system: Extra, guards: Extra, mass: Extra) -> Extra:
            start = [self.zero] * len(system)
            radian = math.sqrt(float(mass) / float(pair.a2))
            cap = {} if longest is None else {"max_delta_t": self.read(longest * radian)}
            one = hy.taylor_adaptive(system, start, t_events=guards, fp_type=kind, tol=tolerance, **form.options)
            return one, one.state, cap

        self.leaving, self.slipping = compiled(slip, [], pair.m1), compiled(slip, [falling], pair.m1)
        self.sticking = compiled(stick, [rising], pair.mass)

    def slip(self, start: Extra, left: Extra) -> Extra:
        """Slip until g falls to 0."""
        integrator, state, cap = self.slipping
        off = first = self.zero
        if start[2] == self.zero and (back := self.pair.comes_back(float(start[0]), float(start[1]))):
            leaving, away, _ = self.leaving
            _place(leaving, away, start, self.zero)
            leaving.step(min(left, self.read(min(back / 2, self.pair.quick))))
            self.steps += 1
            start, off = away.tolist(), leaving.time
            first = self.read(1.5 * back) if back < self.pair.quick else self.zero
        _place(integrator, state, start, self.zero)
        integrator.reset_cooldowns()
        met = self._advance(integrator, left - off, first, cap)
        return met, off + integrator.time, state.tolist()

    def stick(self, start: Extra, left: Extra) -> Extra:
        """Stick until edge rises to 0."""
        integrator, state, cap = self.sticking
        _place(integrator, state, start, self.zero)
        integrator.reset_cooldowns()
        met = self._advance(integrator, left, self.zero, cap)
        return met, integrator.time, state.tolist()

    def _advance(self, integrator: Extra, left: Extra, first: Extra, cap: dict[str, Extra]) -> bool:
        """Go on to the event (True) or until the time is up (False); the first step at most `first`, if not 0."""
        if first:
            code = int(integrator.step(min(left, first))[0])
            self.steps += 1
            if code > FAILED:
                return True
        outcome, _, _, steps, *_ = integrator.propagate_until(left, **cap)
        self.steps += steps
        code = int(outcome)
        if code <= FAILED and code != self.cut:
            raise PeerFailed(f"heyoka: {outcome}")
        return code > FAILED


def _place(integrator: Extra, state: Extra, start: Extra, zero: Extra) -> None:
    integrator.time = zero
    for index, value in enumerate(start):
        state[index] = value
