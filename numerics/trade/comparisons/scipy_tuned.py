"""SciPy's solve_ivp at its best: edge coordinates, a first step inside the slip, and the peaks of the load watched.

It looks at the signs of its guards at step ends. So the first step off the surface ends within half of the slip's
predicted length, where g > 0; and a stick arc stops at the exit or where the load turns back, whichever comes first:
the lesser of both guards stays below 0 once the exit is past, so no step can jump over a short stay beyond the edge.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from numerics.scene import Scene
from numerics.trade.comparisons.edge_coordinates import EdgePair, run_by_edges
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun
from numerics.trade.comparisons.scipy_peer import ScipyPeer, terminal

Vector = NDArray[np.float64]


class TunedScipyPeer(ScipyPeer):
    """solve_ivp by one explicit method, in the coordinates in which it loses nothing."""

    use = "edge coordinates, first steps set, peaks watched, work integrated along"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Set up fields and guards. Raises Unsupported."""
        pair = EdgePair(scene, float)
        arcs = ScipyArcs(pair, self.method, setting, float(scene.energy))
        return lambda: run_by_edges(pair, arcs)


class ScipyArcs:
    """The arcs of a pair in floats."""

    def __init__(self, pair: EdgePair, method: str, tolerance: float, energy: float) -> None:
        """Set the absolute tolerances to rtol times the sizes that E(0) > 0 allows."""
        import scipy.integrate

        self.pair, self.steps = pair, 0
        energy = energy or pair.held**2 / pair.a2
        force, speed = math.sqrt(2 * energy * pair.a2), math.sqrt(2 * energy / pair.m1)
        sizes = [force, speed, speed, energy / pair.b, energy / (pair.a1 or 1.0)]
        self.solve, self.options = scipy.integrate.solve_ivp, {"method": method, "rtol": tolerance}
        extra = len(pair.rest)
        self.slip_atol = tolerance * np.array(sizes[: 4 + extra])
        self.stick_atol = tolerance * np.array([force, speed, *sizes[4 : 4 + extra]])
        a1, a2, m1, push, mass, held = pair.a1, pair.a2, pair.m1, pair.push, pair.mass, pair.held

        def slip(_: float, y: Vector) -> list[float]:
            edge, v, g, *_ = y.tolist()
            pull = (push - edge) / m1
            rates = [a2 * v + a1 * pull, pull, -edge / m1, g]
            return [*rates, v * v] if extra else rates

        def stick(_: float, y: Vector) -> list[float]:
            edge, v, *_ = y.tolist()
            pull = -(held + edge) / mass
            rates = [a2 * v + a1 * pull, pull]
            return [*rates, v * v] if extra else rates

        self.fields = slip, stick
        self.falls = terminal(lambda _, y: y[2], -1)
        self.leaves_or_turns = terminal(lambda _, y: min(-y[0], pair.turning(y[0], y[1])), -1)

    def slip(self, start: Extra, left: float) -> Extra:
        """Slip until g falls to 0."""
        first = None
        if start[2] == 0:
            back = self.pair.comes_back(start[0], start[1]) or math.inf
            first = min(back / 2, self.pair.quick, left)
        arc = self._solve(self.fields[0], start, left, self.slip_atol, [self.falls], first)
        return arc.status == 1, arc.t[-1], arc.y[:, -1].tolist()

    def stick(self, start: Extra, left: float) -> Extra:
        """Stick until edge rises to 0; if it turns back before it has, stick for all of the time left."""
        field, atol = self.fields[1], self.stick_atol
        arc = self._solve(field, start, left, atol, [self.leaves_or_turns])
        if arc.status == 1 and not self.pair.leaves(arc.y[0, -1], arc.y[1, -1]):
            arc = self._solve(field, start, left, atol, None)
        return arc.status == 1, arc.t[-1], arc.y[:, -1].tolist()

    def _solve(
        self, field: Extra, start: Extra, left: float, atol: Vector, events: Extra, first: float | None = None
    ) -> Extra:
        arc = self.solve(field, (0.0, left), start, events=events, atol=atol, first_step=first, **self.options)
        self.steps += len(arc.t) - 1
        if arc.status == -1:
            raise PeerFailed(f"SciPy: {arc.message}")
        return arc
