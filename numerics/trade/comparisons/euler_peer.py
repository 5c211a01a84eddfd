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

from collections.abc import Iterator
from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

from numerics.scene import Scene
from numerics.trade.comparisons.forward_euler import EulerRun, forward_euler, march
from numerics.trade.comparisons.peer import Call, Extra, PeerFailed, PeerRun, Unsupported
from numerics.trade.comparisons.switched import SwitchedPair

MAX_STEPS = 20_000_000
Vector = NDArray[np.float64]


def euler_peer(scene: Scene, step: float) -> Call:
    """Compile the loop, where numba is installed. Raises Unsupported; PeerFailed for too many steps."""
    if scene.is_forced:
        raise Unsupported("the paper's forward Euler is for free pairs")
    loop: Extra = march
    pair, steps = SwitchedPair(scene), float(scene.until) / step
    if steps > MAX_STEPS:
        raise PeerFailed(f"{steps:.0f} steps do not fit the memory; the cap is {MAX_STEPS}")
    if find_spec("numba"):
        import numba

        loop = numba.njit(march)

    def run() -> PeerRun:
        with np.errstate(over="ignore", invalid="ignore"):  # a coarse step may blow up, and says so by its result
            return read(pair, forward_euler(scene, step, loop))

    return run


def read(pair: SwitchedPair, euler: EulerRun) -> PeerRun:
    """Return what a forward Euler run says, read by the rules above."""
    x1, v1, _, v2 = euler.y
    steps = _events(np.sign(v1 - v2), pair.a2 * x1 + pair.a1 * v1, pair.spans[0].held, pair.mode)
    events = [(mode, float(euler.t[step])) for mode, step in steps]
    return PeerRun.of(pair.mode, events, euler.y[:, -1].tolist(), float(euler.energy[0] - euler.energy[-1]))


def _events(sign: Vector, load: Vector, held: float, mode: int) -> Iterator[tuple[int, int]]:
    """Yield the mode after each event and its step; a mode is the sign of the slip, 0 in stick."""
    inside = np.abs(load) <= held
    outside = np.flatnonzero(~inside)
    other = {one: np.flatnonzero(sign != one) for one in (-1, 1)}
    begun = {one: np.flatnonzero((sign == one) | inside) for one in (-1, 1)}
    step: int | None = 0
    while True:
        step = _next(outside, step) if mode == 0 else _next(other[mode], _next(begun[mode], step))
        if step is None:
            return
        mode = (-1 if load[step] > 0 else 1) if mode == 0 else 0 if inside[step] else -mode
        yield mode, step


def _next(steps: NDArray[np.intp], after: int | None) -> int | None:
    """Return the first of the sorted steps that is not before `after`, or None."""
    index = len(steps) if after is None else int(np.searchsorted(steps, after))
    return int(steps[index]) if index < len(steps) else None
