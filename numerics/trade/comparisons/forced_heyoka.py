"""heyoka's Taylor integrator under a force: u is a formula in time, its coefficients are runtime parameters.

Where a slip begins its guard is 0, and heyoka finds that root again or loses the next one of the step. So a step
without events leads off the surface first, at most a tenth of a radian and halved until it ends inside the slip.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from importlib.util import find_spec

from numerics.motion.modes import Mode
from numerics.scene import Scene
from numerics.trade.comparisons.forced_pair import ForcedPair, Span, run_by_spans
from numerics.trade.comparisons.heyoka_peer import FAILED, finished
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun

_HALVINGS = 40


class ForcedHeyokaPeer:
    """One compiled integrator for each mode with terminal directed events, and one for the first step of a slip."""

    name = "heyoka"
    use = "restarted by mode and at jumps, no root at a start"
    knob = "tol"
    settings: tuple[float, ...] = (1e-6, 1e-9, 1e-12, 1e-15, 1e-18)
    forced = True

    def missing(self) -> str | None:
        """Name heyoka if it is not installed."""
        return None if find_spec("heyoka") else "heyoka (extra `comparisons`)"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Compile, with room for the longest polynomial and the most sines. Raises Unsupported."""
        pair = ForcedPair.of(scene)
        arcs = HeyokaSpans(pair, setting)
        return lambda: run_by_spans(pair, arcs)


class HeyokaSpans:
    """The compiled arcs; parameters are b, the origin, the coefficients, and three numbers for each sine."""

    def __init__(self, pair: ForcedPair, tolerance: float) -> None:
        """Compile for a pair."""
        self.steps = 0
        self.degree = max(len(span.polynomial) for span in pair.spans)
        self.sines = max(len(span.sines) for span in pair.spans)
        self.first = 0.1 * math.sqrt(pair.m1 / pair.a2)
        self.watched = {mode: self._compiled(pair, mode, tolerance) for mode in Mode}
        self.leaving = {mode: self._compiled(pair, mode, tolerance, watched=False) for mode in Mode if mode.sign}
        self.finished = finished()

    def _compiled(self, pair: ForcedPair, mode: Mode, tolerance: float, watched: bool = True) -> Extra:
        import heyoka as hy

        x1, v1, x2, v2, lost = hy.make_vars("x1", "v1", "x2", "v2", "lost")
        b, since, u = hy.par[0], hy.time - hy.par[1], hy.expression(0.0)
        for k in reversed(range(self.degree)):
            u = u * since + hy.par[2 + k]
        for n in range(self.sines):
            amplitude, omega, phase = (hy.par[2 + self.degree + 3 * n + k] for k in range(3))
            u = u + amplitude * hy.sin(omega * hy.time + phase)
        load, rub = u - pair.a2 * x1 - pair.a1 * v1, mode.sign * b
        up, down = hy.event_direction.positive, hy.event_direction.negative
        if mode is Mode.STICK:
            held, pull = b * (pair.mass / pair.m2), load / pair.mass
            events = [hy.t_event(load - held, direction=up), hy.t_event(load + held, direction=down)]
            system = [(x1, v1), (v1, pull), (x2, v2), (v2, pull), (lost, pair.a1 * v1 * v1)]
        else:
            events = [hy.t_event(v1 - v2, direction=down if mode.sign > 0 else up)]
            rate = rub * (v1 - v2) + pair.a1 * v1 * v1
            system = [(x1, v1), (v1, (load - rub) / pair.m1), (x2, v2), (v2, rub / pair.m2), (lost, rate)]
        return hy.taylor_adaptive(system, [0.0] * 5, tol=tolerance, t_events=events if watched else [])

    def arc(self, span: Span, mode: Mode, t: float, y: Extra) -> tuple[bool, float, Extra]:
        """Integrate to the guard or the end of the span. Raises PeerFailed."""
        polynomial = [*span.polynomial, *[0.0] * (self.degree - len(span.polynomial))]
        idle = [(0.0, 1.0, 0.0)] * (self.sines - len(span.sines))
        numbers = [span.b, span.origin, *polynomial, *(part for sine in (*span.sines, *idle) for part in sine)]
        if mode.sign and y[1] == y[3]:
            t, y = self._off_the_surface(span, mode, t, y, numbers)
        one = _placed(self.watched[mode], numbers, t, y)
        one.reset_cooldowns()
        outcome, _, _, taken, *_ = one.propagate_until(span.end)
        self.steps += taken
        met = int(outcome) > FAILED
        if not met and outcome != self.finished:
            raise PeerFailed(f"heyoka at t = {one.time:.9g} s: {outcome}")
        return met, float(one.time), one.state.copy()

    def _off_the_surface(self, span: Span, mode: Mode, t: float, y: Extra, numbers: list[float]) -> tuple[float, Extra]:
        length = min(self.first, span.end - t)
        for _ in range(_HALVINGS):
            one = _placed(self.leaving[mode], numbers, t, y)
            one.propagate_until(t + length)
            self.steps += 1
            if mode.sign * (one.state[1] - one.state[3]) > 0:
                break
            length /= 2
        return float(one.time), one.state.copy()


def _placed(one: Extra, numbers: list[float], t: float, y: Extra) -> Extra:
    """Return an integrator set to a time, a state and the numbers of a span."""
    pars = one.pars
    pars[:] = numbers[: len(pars)]
    one.time = t
    one.state[:] = y
    return one
