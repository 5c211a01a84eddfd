"""heyoka's Taylor integrator, stopped by terminal events and restarted with the field of the next mode."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec

import numpy as np

from numerics.motion.modes import Mode, event_kind
from numerics.scene import Scene
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun
from numerics.trade.comparisons.switching import EventLog, SwitchedPair


class HeyokaPeer:
    """Natural use: three compiled integrators, one for each mode, with terminal directed events and no callback."""

    name = "heyoka"
    use = "terminal events, one integrator for each mode"
    forced = False
    knob = "tol"
    settings: tuple[float, ...] = (1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16, 1e-18)

    def missing(self) -> str | None:
        """Name heyoka if it is not installed."""
        return None if find_spec("heyoka") else "heyoka (extra `comparisons`)"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Compile the three integrators. Raises Unsupported."""
        pair = SwitchedPair.of(scene)
        integrators = {mode: compiled(pair, mode, setting) for mode in Mode}
        states = {mode: one.state for mode, one in integrators.items()}

        def run() -> PeerRun:
            log, steps = EventLog(), 0
            t, y, mode = 0.0, np.array(pair.y), pair.start
            while True:
                integrator, state = integrators[mode], states[mode]
                integrator.time, state[:] = t, y
                integrator.reset_cooldowns()
                outcome, _, _, taken, *_ = integrator.propagate_until(pair.until)
                steps, y = steps + taken, state
                if int(outcome) <= FAILED:
                    if outcome != finished():
                        raise PeerFailed(f"{self.name} at t = {integrator.time:.9g} s: {outcome}")
                    break
                t, after = integrator.time, pair.after(mode, y[0], y[1])
                log.add(event_kind(mode, after), t)
                mode, y[3] = after, y[1]
            return PeerRun(tuple(log.kinds), np.array(log.times), y.copy(), pair.lost(y[0], y[1], y[3]), steps)

        return run


FAILED = -(2**32)
"""Outcomes down here are heyoka's own; -1 - i says that terminal event i has stopped the run."""


def finished() -> Extra:
    """Return heyoka's word for having reached the horizon."""
    import heyoka

    return heyoka.taylor_outcome.time_limit


def compiled(pair: SwitchedPair, mode: Mode, tolerance: float) -> Extra:
    """Return the integrator of one mode, its guards as terminal events."""
    import heyoka as hy

    x1, v1, x2, v2 = hy.make_vars("x1", "v1", "x2", "v2")
    p1, f1, p2, f2 = pair.accelerations(mode)
    load = pair.a2 * x1 + pair.a1 * v1
    up, down = hy.event_direction.positive, hy.event_direction.negative
    if mode is Mode.STICK:
        events = [hy.t_event(load - pair.held, direction=up), hy.t_event(load + pair.held, direction=down)]
    else:
        events = [hy.t_event(v1 - v2, direction=down if mode.sign > 0 else up)]
    system = [(x1, v1), (v1, f1 - p1 * load), (x2, v2), (v2, f2 - p2 * load)]
    return hy.taylor_adaptive(system, [0.0] * 4, tol=tolerance, t_events=events)
