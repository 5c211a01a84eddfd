"""Who takes part: ours, and every other integrator in its best use. Nothing is imported before it prepares."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np

from numerics.scene.plane import PlaneScene
from numerics.solver.solve import ArithmeticName, solve
from numerics.trade.forward_euler import euler_peer, not_marched
from numerics.trade.judge import MAX_EVENTS, Call, looked_at
from numerics.trade.peers import heyoka_arcs, scipy_arcs, switched, unknown


class Contender(NamedTuple):
    """A method with the settings that are worth measuring: digits, steps or tolerances, from coarse to fine."""

    name: str
    settings: tuple[float, ...]
    prepare: Callable[[Any, float], Call]
    """prepare(scene, setting) builds and compiles everything; the call that it returns solves the scene each time."""
    unknown: Callable[[Any], str | None]
    """Of a scene in words why it is not solved."""
    package: str = "numpy"
    """What has to be installed."""

    def left_out(self, scene: Any) -> str | None:
        """Return in words why it does not solve a scene; None if it does."""
        if not find_spec(self.package):
            return f"needs {self.package} (extra `comparisons`)"
        of = self.unknown(scene)
        return of and f"not for {of}"


def ours(arithmetic: ArithmeticName) -> Callable[[Any, float], Call]:
    """Return what prepares `solve` in an arithmetic; its setting is the digits asked for, 0 for none."""

    def prepare(scene: Any, digits: float) -> Call:
        asked = int(digits) or None
        return lambda: looked_at(solve(scene, arithmetic=arithmetic, digits=asked, max_events=MAX_EVENTS))

    return prepare


FLOAT64, BALLS, PEERS = "float64", "balls", ("heyoka", "heyoka long double")
"""Ours, and whom it is measured against: the fastest integrator of its kind that we know."""
CONTENDERS = (
    Contender(FLOAT64, (0,), ours("float64"), lambda scene: "a surface" if isinstance(scene, PlaneScene) else None),
    Contender(BALLS, (15, 30, 100, 300, 1000), ours("ball"), lambda _: None),
    Contender("forward Euler", (1e3, 1e4, 1e5, 1e6), euler_peer, not_marched),
    Contender("SciPy DOP853", (1e-6, 1e-9, 1e-12), switched(scipy_arcs), unknown, "scipy"),
    Contender("heyoka", (1e-9, 1e-12, 1e-15), switched(heyoka_arcs), unknown, "heyoka"),
    Contender(PEERS[1], (1e-15, 1e-18), switched(heyoka_arcs, np.longdouble), unknown, "heyoka"),
)
