"""SciPy's solve_ivp under a force: terminal events, restarted by mode and at every jump."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

from numerics.motion.modes import Mode
from numerics.scene import Scene
from numerics.trade.comparisons.forced_pair import ForcedPair, Span, run_by_spans
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun
from numerics.trade.comparisons.scipy_peer import terminal

Vector = NDArray[np.float64]


class ForcedScipyPeer:
    """solve_ivp by one method, in its natural use."""

    use = "restarted by mode and at jumps, terminal events"
    knob = "rtol"
    settings: tuple[float, ...] = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    forced = True

    def __init__(self, method: str) -> None:
        """Take one of SciPy's method names."""
        self.method, self.name = method, f"SciPy {method}"

    def missing(self) -> str | None:
        """Name SciPy if it is not installed."""
        return None if find_spec("scipy") else "scipy (extra `comparisons`)"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Set up fields and guards for every mode and span. Raises Unsupported."""
        pair = ForcedPair.of(scene)
        arcs = ScipySpans(pair, self.method, setting)
        return lambda: run_by_spans(pair, arcs)


class ScipySpans:
    """The arcs of a pair; fields are made when a span meets a mode first."""

    def __init__(self, pair: ForcedPair, method: str, tolerance: float) -> None:
        """Set the absolute tolerances to rtol times the pair's own length and speed."""
        import scipy.integrate

        self.pair, self.method, self.steps = pair, method, 0
        length, speed = pair.scales
        energy = pair.a2 * length**2
        self.solve = scipy.integrate.solve_ivp
        self.tolerances = {"rtol": tolerance, "atol": tolerance * np.array([length, speed, length, speed, energy])}
        self.made: dict[tuple[Span, Mode], dict[str, Extra]] = {}

    def arc(self, span: Span, mode: Mode, t: float, y: Vector) -> tuple[bool, float, Vector]:
        """Integrate to the guard or the end of the span. Raises PeerFailed."""
        key = (span, mode)
        if key not in self.made:
            self.made[key] = self._made(span, mode)
        found = self.solve(t_span=(t, span.end), y0=y, method=self.method, **self.made[key], **self.tolerances)
        self.steps += len(found.t) - 1
        if found.status == -1:
            raise PeerFailed(f"SciPy at t = {found.t[-1]:.9g} s: {found.message}")
        return found.status == 1, float(found.t[-1]), found.y[:, -1]

    def _made(self, span: Span, mode: Mode) -> dict[str, Extra]:
        pair, u, held = self.pair, span.force(), self.pair.held(span)
        a1, a2, m1, m2, mass, rub = pair.a1, pair.a2, pair.m1, pair.m2, pair.mass, span.b * mode.sign

        def slip(t: float, y: Vector) -> list[float]:
            x1, v1, _, v2, _ = y.tolist()
            load = u(t) - a2 * x1 - a1 * v1
            return [v1, (load - rub) / m1, v2, rub / m2, rub * (v1 - v2) + a1 * v1 * v1]

        def stick(t: float, y: Vector) -> list[float]:
            x1, v1, _, _, _ = y.tolist()
            pull = (u(t) - a2 * x1 - a1 * v1) / mass
            return [v1, pull, v1, pull, a1 * v1 * v1]

        def load(t: float, y: Vector) -> float:
            return float(u(t) - a2 * y[0] - a1 * y[1])

        if mode is Mode.STICK:
            guards = [terminal(lambda t, y: load(t, y) - held, 1), terminal(lambda t, y: load(t, y) + held, -1)]
            return {"fun": stick, "events": guards}
        return {"fun": slip, "events": [terminal(lambda _, y: y[1] - y[3], -mode.sign)]}
