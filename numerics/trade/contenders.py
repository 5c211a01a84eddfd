"""Who takes part: what a user calls of ours, and every peer in its best use. Nothing is imported before it prepares."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np

from numerics.plane.trajectory import PlaneTrajectory
from numerics.solver.solve import ArithmeticName, solve
from numerics.trade.comparisons.forward_euler import euler_peer
from numerics.trade.comparisons.integrators import heyoka_arcs, scipy_arcs
from numerics.trade.comparisons.switched import Call, PeerRun, switched
from numerics.trade.scenes import KINDS, LINE

MAX_EVENTS = 10**7
Prepare = Callable[[Any, float], Call]
"""prepare(scene, setting) builds and compiles everything; the call that it returns is timed, and solves each time."""


class Contender(NamedTuple):
    """A method with the settings that are worth measuring, from coarse to fine: digits, tolerances, steps (s)."""

    label: str
    settings: tuple[float, ...]
    prepare: Prepare
    package: str = ""
    """What has to be installed."""
    kinds: tuple[str, ...] = tuple(KINDS)

    def missing(self) -> str | None:
        """Return what has to be installed before it can run, in words for a reader; None if nothing is missing."""
        return None if not self.package or find_spec(self.package) else f"{self.package} (extra `comparisons`)"


def solved(arithmetic: ArithmeticName | None = None) -> Prepare:
    """Return what prepares `solve`: the setting is its digits, 0 for none. Its answer is read as a peer's is."""

    def prepare(scene: Any, digits: float) -> Call:
        asked = int(digits) or None
        return lambda: looked_at(solve(scene, arithmetic=arithmetic, digits=asked, max_events=MAX_EVENTS))

    return prepare


def looked_at(trajectory: Any) -> Any:
    """Look at what a user looks at, t, y and modes, and return the trajectory: they are made when they are read."""
    trajectory.t, trajectory.y, trajectory.modes  # noqa: B018
    return trajectory


def answer_of(found: Any) -> PeerRun:
    """Return what a run of anybody says of a scene."""
    if isinstance(found, PeerRun):
        return found
    if isinstance(found, PlaneTrajectory):
        final = tuple(x for part in found.final_state for x in part)
        return PeerRun(found.modes, tuple(one.t for one in found.events), final)
    with found.arithmetic.context():
        off_line = found.scene.friction.weakening is not None
        lost = None if off_line else found.ledger.friction + found.ledger.viscous
    signs = tuple(mode.sign for mode in found.modes)
    return PeerRun(signs, tuple(found.t[1 : len(signs)]), tuple(found.y[:, -1]), lost)


CONTENDERS = (
    Contender("solve", (0, 12, 20), solved()),
    Contender("ball", (15, 100, 1000, 10_000), solved("ball"), kinds=LINE),
    Contender("forward Euler", (1e-3, 1e-4, 1e-5), euler_peer, kinds=("free",)),
    Contender("SciPy DOP853", (1e-6, 1e-9, 1e-12), switched(scipy_arcs), "scipy", LINE),
    Contender("heyoka", (1e-9, 1e-12, 1e-15), switched(heyoka_arcs), "heyoka", LINE),
    Contender("heyoka long double", (1e-15, 1e-18), switched(heyoka_arcs, np.longdouble), "heyoka", LINE),
)


def contender(label: str) -> Contender:
    """Return the contender of this label."""
    return next(one for one in CONTENDERS if one.label == label)
