"""The paper's forward Euler, judged as its user would read it: chatter inside the sliding region is sticking.

Its run has no events, only signs of v1 - v2 and loads at its steps. They are read so:

    slip of sign s ends    at the first step where v1 - v2 no longer has sign s: an entry if the load lies in the
                           sliding region there, else a crossing;
    stick (chatter) ends   at the first step where the load lies outside the region: an exit;
    a new slip             may have to wait for its sign, as after chatter: it can end only once v1 - v2 has had its
                           sign, or the load is back inside.

Its dissipated energy is E(0) - E(end), which chatter spoils: forward Euler gains energy in stick.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

from numerics.motion.modes import EventKind
from numerics.scene import Scene
from numerics.trade.comparisons.forward_euler import EulerRun, forward_euler, march
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun
from numerics.trade.comparisons.switching import EventLog, SwitchedPair

MAX_STEPS = 20_000_000
Vector = NDArray[np.float64]


class EulerPeer:
    """Forward Euler with a fixed step, as Python runs it or with its loop compiled by numba."""

    forced = False
    knob = "step (s)"
    settings: tuple[float, ...] = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)

    def __init__(self, compiled: bool) -> None:
        """Take whether the loop is compiled."""
        self.compiled = compiled
        self.name = "forward Euler"
        self.use = "compiled by numba" if compiled else "plain Python"

    def missing(self) -> str | None:
        """Name numba where the loop is to be compiled and it is not installed."""
        return "numba" if self.compiled and not find_spec("numba") else None

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Compile the loop. Raises Unsupported; the run raises PeerFailed if it would take too many steps."""
        pair = SwitchedPair.of(scene)
        loop: Extra = march
        if self.compiled:
            import numba

            loop = numba.njit(march)
            forward_euler(scene, pair.until / 2, loop)

        def run() -> PeerRun:
            if pair.until / setting > MAX_STEPS:
                raise PeerFailed(f"{pair.until / setting:.0f} steps do not fit the memory; the cap is {MAX_STEPS}")
            with np.errstate(over="ignore", invalid="ignore"):  # a coarse step may blow up, and says so by its result
                return read(pair, forward_euler(scene, setting, loop))

        return run


def read(pair: SwitchedPair, euler: EulerRun) -> PeerRun:
    """Return what a forward Euler run says, read by the rules above."""
    x1, v1, _, v2 = euler.y
    sign, load = np.sign(v1 - v2), pair.a2 * x1 + pair.a1 * v1
    log = EventLog()
    for kind, step in _events(sign, load, pair.held, pair.start.sign):
        log.add(kind, float(euler.t[step]))
    y = euler.y[:, -1]
    lost = pair.lost(float(y[0]), float(y[1]), float(y[3]))
    return PeerRun(tuple(log.kinds), np.array(log.times), y.copy(), lost, len(euler.t) - 1)


def _events(sign: Vector, load: Vector, held: float, mode: int) -> Iterator[tuple[EventKind, int]]:
    """Yield the kind and the step of each event; the mode is the sign of the slip, 0 in stick."""
    inside = np.abs(load) <= held
    outside = np.flatnonzero(~inside)
    other = {one: np.flatnonzero(sign != one) for one in (-1, 1)}
    begun = {one: np.flatnonzero((sign == one) | inside) for one in (-1, 1)}
    step: int | None = 0
    while True:
        step = _next(outside, step) if mode == 0 else _next(other[mode], _next(begun[mode], step))
        if step is None:
            return
        if mode == 0:
            mode = -1 if load[step] > 0 else 1
            yield EventKind.EXIT, step
        else:
            mode = 0 if inside[step] else -mode
            yield (EventKind.CROSSING if mode else EventKind.ENTRY), step


def _next(steps: NDArray[np.intp], after: int | None) -> int | None:
    """Return the first of the sorted steps that is not before `after`, or None."""
    index = len(steps) if after is None else int(np.searchsorted(steps, after))
    return int(steps[index]) if index < len(steps) else None
