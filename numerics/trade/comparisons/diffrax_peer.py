"""diffrax, in edge coordinates: one compiled `diffeqsolve` for both modes, called from event to event.

As with SciPy at its best, the first step off the surface ends inside the slip, and a stick arc stops at the exit or
where the load turns back, whichever comes first.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from numerics.scene import Scene
from numerics.trade.comparisons.diffrax_arc import Arc, Asked, DiffraxMethod
from numerics.trade.comparisons.edge_coordinates import EdgePair, run_by_edges
from numerics.trade.comparisons.peer import Extra, PeerRun


class DiffraxPeer(DiffraxMethod):
    """A free pair by diffrax."""

    use = "edge coordinates, first steps set, peaks watched, work integrated along"
    forced = False
    settings: tuple[float, ...] = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)

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
        self.pair, self.steps = pair, 0
        energy = energy or pair.held**2 / pair.a2
        force, speed = math.sqrt(2 * energy * pair.a2), math.sqrt(2 * energy / pair.m1)
        sizes = (force, speed, speed, energy / pair.b, energy / (pair.a1 or 1.0))
        width = 4 + len(pair.rest)
        self.arc = Arc(method, tolerance, sizes[:width], _field(pair), _guard(pair, force, speed), _unpack, width + 4)

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
        met, length, steps, end = self.arc([left, min(first, left), slips, watched, *start])
        self.steps += steps
        return met, length, end


def _unpack(packed: Extra) -> Asked:
    """Read an array: left, first step, 1 in slip, 1 where guards are watched, the start."""
    return Asked(packed[0], packed[1], packed[4:], (packed[2] == 1, packed[3] == 1))


def _field(pair: EdgePair) -> Callable[..., Extra]:
    """Return the rates of edge, v1, g, z, and of u where there is viscosity, in the mode that is asked."""
    import jax.numpy as jnp

    a1, a2, m1, push, mass, held = pair.a1, pair.a2, pair.m1, pair.push, pair.mass, pair.held

    def field(_: Extra, y: Extra, modes: Extra) -> Extra:
        slips, _ = modes
        pull = jnp.where(slips, (push - y[0]) / m1, -(held + y[0]) / mass)
        rates = [a2 * y[1] + a1 * pull, pull, jnp.where(slips, -y[0] / m1, 0.0), y[2]]
        return jnp.stack([*rates, y[1] ** 2] if pair.rest else rates)

    return field


def _guard(pair: EdgePair, force: float, speed: float) -> Callable[..., Extra]:
    """Return what falls to 0 at the event: g in slip; in stick the distance to the edge, or to where the load turns."""
    import jax.numpy as jnp

    def guard(t: Extra, y: Extra, args: Extra, **_: Extra) -> Extra:  # noqa: ARG001  (diffrax names its arguments)
        slips, watched = args
        stick = jnp.minimum(-y[0], pair.turning(y[0], y[1])) / force
        return jnp.where(watched, jnp.where(slips, y[2] / speed, stick), 1.0)

    return guard
