"""diffrax, in edge coordinates: one compiled `diffeqsolve` for both modes, called from event to event.

Events are found where a condition changes sign over a step, and located by bisection of the dense output (Newton's
method, the documentation's choice, runs away from wide steps). So, as with SciPy at its best, the first step off the
surface ends inside the slip, and a stick arc stops at the exit or where the load turns back, whichever comes first.
What goes in and out of the compiled function is packed into one array each way: transfers cost more than steps.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from importlib.util import find_spec

import numpy as np

from numerics.scene import Scene
from numerics.trade.comparisons.edge_coordinates import EdgePair, run_by_edges
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun

MAX_STEPS = 1_000_000


class DiffraxPeer:
    """diffeqsolve by one explicit method with a PID controller, in float64, compiled and warm."""

    use = "edge coordinates, first steps set, peaks watched, work integrated along"
    forced = False
    knob = "rtol"
    settings: tuple[float, ...] = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)

    def __init__(self, method: str) -> None:
        """Take one of diffrax's solvers: "Dopri8", "Tsit5"."""
        self.method, self.name = method, f"diffrax {method}"

    def missing(self) -> str | None:
        """Name diffrax if it is not installed."""
        return None if find_spec("diffrax") else "diffrax (extra `comparisons`)"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Compile the arc. Raises Unsupported."""
        import jax

        pair = EdgePair(scene, float)
        with jax.enable_x64(True):
            arcs = DiffraxArcs(pair, self.method, setting, float(scene.energy))

        def run() -> PeerRun:
            with jax.enable_x64(True):
                return run_by_edges(pair, arcs)

        return run


class DiffraxArcs:
    """The compiled arc; which mode it is in, and whether peaks are watched, are runtime arguments."""

    def __init__(self, pair: EdgePair, method: str, tolerance: float, energy: float) -> None:
        """Compile for a pair, the absolute tolerances being rtol times the sizes that E(0) > 0 allows."""
        import jax

        self.pair, self.steps = pair, 0
        energy = energy or pair.held**2 / pair.a2
        force, speed = math.sqrt(2 * energy * pair.a2), math.sqrt(2 * energy / pair.m1)
        sizes = (force, speed, speed, energy / pair.b, energy / (pair.a1 or 1.0))
        self.width = 4 + len(pair.rest)
        arc = arc_function(pair, method, tolerance, sizes[: self.width])
        self.arc = jax.jit(arc).lower(np.zeros(self.width + 4)).compile()

    def slip(self, start: Extra, left: float) -> Extra:
        """Slip until g falls to 0."""
        first = self.pair.quick
        if start[2] == 0 and (back := self.pair.comes_back(start[0], start[1])):
            first = min(back / 2, first)
        return self._solve(start, left, first, True, True)

    def stick(self, start: Extra, left: float) -> Extra:
        """Stick until edge rises to 0; if it turns back before it has, stick for all of the time left."""
        start = (*start[:2], 0.0, 0.0, *start[2:])
        met, length, end = self._solve(start, left, self.pair.quick, False, True)
        if met and not self.pair.leaves(end[0], end[1]):
            met, length, end = self._solve(start, left, self.pair.quick, False, False)
        return met, length, (*end[:2], *end[4:])

    def _solve(self, start: Extra, left: float, first: float, slips: bool, watched: bool) -> Extra:
        out = np.asarray(self.arc(np.array([left, min(first, left), slips, watched, *start])))
        length, met, steps, good, *end = out.tolist()
        if not good:
            raise PeerFailed(f"diffrax: no end of the arc after {steps:.0f} steps")
        self.steps += int(steps)
        return met == 1, length, end


def arc_function(pair: EdgePair, method: str, tolerance: float, sizes: tuple[float, ...]) -> Callable[..., Extra]:
    """Return the arc as a function of one array: left, first step, 1 in slip, 1 where guards are watched, the start.

    It returns one array: length, 1 if the event was met, steps, 1 if it got there, the end.
    """
    import diffrax
    import jax.numpy as jnp
    import optimistix

    a1, a2, m1, push, mass, held = pair.a1, pair.a2, pair.m1, pair.push, pair.mass, pair.held

    def field(_: Extra, y: Extra, modes: Extra) -> Extra:
        slips, _ = modes
        pull = jnp.where(slips, (push - y[0]) / m1, -(held + y[0]) / mass)
        rates = [a2 * y[1] + a1 * pull, pull, jnp.where(slips, -y[0] / m1, 0.0), y[2]]
        return jnp.stack([*rates, y[1] ** 2] if pair.rest else rates)

    def guard(t: Extra, y: Extra, args: Extra, **_: Extra) -> Extra:  # noqa: ARG001  (diffrax names its arguments)
        slips, watched = args
        stick = jnp.minimum(-y[0], pair.turning(y[0], y[1])) / sizes[0]
        return jnp.where(watched, jnp.where(slips, y[2] / sizes[1], stick), 1.0)

    event = diffrax.Event(guard, optimistix.Bisection(1e-15, 1e-14), direction=False)
    atol = tolerance * jnp.array(sizes)
    controller = diffrax.PIDController(rtol=tolerance, atol=atol)
    solver = getattr(diffrax, method)()

    def arc(packed: Extra) -> Extra:
        left, first, slips, watched = packed[0], packed[1], packed[2] == 1, packed[3] == 1
        out = diffrax.diffeqsolve(
            diffrax.ODETerm(field),
            solver,
            0.0,
            left,
            first,
            packed[4:],
            args=(slips, watched),
            stepsize_controller=controller,
            event=event,
            max_steps=MAX_STEPS,
            throw=False,
        )
        stopped = out.result == diffrax.RESULTS.event_occurred
        good = stopped | (out.result == diffrax.RESULTS.successful)
        return jnp.concatenate([jnp.stack([out.ts[-1], stopped, out.stats["num_steps"], good]), out.ys[-1]])

    return arc
