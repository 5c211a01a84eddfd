"""SciPy's solve_ivp, stopped by terminal events and restarted with the field of the next mode."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

from numerics.motion.modes import Mode, event_kind
from numerics.scene import Scene
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun
from numerics.trade.comparisons.switching import EventLog, SwitchedPair

Vector = NDArray[np.float64]


class ScipyPeer:
    """solve_ivp by one method, in its natural use: guards as terminal directed events, v2 := v1 at every event."""

    use = "terminal events, restarted by mode"
    forced = False
    knob = "rtol"
    settings: tuple[float, ...] = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)

    def __init__(self, method: str) -> None:
        """Take one of SciPy's method names."""
        self.method, self.name = method, f"SciPy {method}"

    def missing(self) -> str | None:
        """Name SciPy if it is not installed."""
        return None if find_spec("scipy") else "scipy (extra `comparisons`)"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Set up fields, Jacobians and guards; the absolute tolerances are rtol times the sizes that E(0) allows."""
        import scipy.integrate

        pair = SwitchedPair.of(scene)
        tolerances = {"rtol": setting, "atol": setting * np.array(pair.scales)}
        options = {mode: self._options(pair, mode) for mode in Mode}

        def run() -> PeerRun:
            log, steps = EventLog(), 0
            t, y, mode = 0.0, np.array(pair.y), pair.start
            while True:
                arc = scipy.integrate.solve_ivp(
                    t_span=(t, pair.until), y0=y, method=self.method, **options[mode], **tolerances
                )
                t, y, steps = arc.t[-1], arc.y[:, -1], steps + len(arc.t) - 1
                if arc.status == -1:
                    raise PeerFailed(f"{self.name} at t = {t:.9g} s: {arc.message}")
                if arc.status == 0:
                    break
                after = pair.after(mode, y[0], y[1])
                log.add(event_kind(mode, after), t)
                mode, y[3] = after, y[1]
            lost = pair.lost(y[0], y[1], y[3])
            return PeerRun(tuple(log.kinds), np.array(log.times), y, lost, steps)

        return run

    def _options(self, pair: SwitchedPair, mode: Mode) -> dict[str, Extra]:
        p1, f1, p2, f2 = pair.accelerations(mode)
        a1, a2, held = pair.a1, pair.a2, pair.held

        def field(_: float, y: Vector) -> list[float]:
            x1, v1, _x2, v2 = y.tolist()
            load = a2 * x1 + a1 * v1
            return [v1, f1 - p1 * load, v2, f2 - p2 * load]

        events = (
            [
                terminal(lambda _, y: a2 * y[0] + a1 * y[1] - held, 1),
                terminal(lambda _, y: a2 * y[0] + a1 * y[1] + held, -1),
            ]
            if mode is Mode.STICK
            else [terminal(lambda _, y: y[1] - y[3], -mode.sign)]
        )
        return {"fun": field, "events": events, **jacobian(self.method, pair, mode)}


def terminal(guard: Callable[[float, Vector], float], direction: int) -> Extra:
    """Mark a guard as solve_ivp reads it: the run ends where it crosses zero in this direction."""
    guard.terminal, guard.direction = True, direction  # type: ignore[attr-defined]
    return guard


def jacobian(method: str, pair: SwitchedPair, mode: Mode) -> dict[str, Extra]:
    """Return the constant Jacobian in the form that an implicit method takes; explicit ones take none."""
    p1, _, p2, _ = pair.accelerations(mode)
    rows = [[0, 1, 0, 0], [-p1 * pair.a2, -p1 * pair.a1, 0, 0], [0, 0, 0, 1], [-p2 * pair.a2, -p2 * pair.a1, 0, 0]]
    matrix = np.array(rows, dtype=float)
    if method in {"Radau", "BDF"}:
        return {"jac": matrix}
    return {"jac": lambda _t, _y: matrix} if method == "LSODA" else {}
