"""Siconos time stepping under a force: u at the middle of each step, the relay's bounds from the b of the time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict

import numpy as np

from numerics.motion.modes import EventKind
from numerics.scene import Scene
from numerics.trade.comparisons.forced_pair import ForcedPair
from numerics.trade.comparisons.peer import PeerFailed, PeerRun
from numerics.trade.comparisons.siconos_peer import MAX_STEPS, SiconosPeer, ask


class ForcedSiconosPeer(SiconosPeer):
    """The implicit relay at fixed steps by EulerMoreau; jumps are felt at the next step."""

    forced = True

    def __init__(self) -> None:
        """Take the one-step integrator that reads a force at every step."""
        super().__init__("EulerMoreau")
        self.use = "theta = 1/2, implicit relay, u at the middle of a step"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Write the request; each run starts a process, warms up on a few steps, and times the others."""
        pair = ForcedPair.of(scene)
        until = pair.spans[-1].end
        request = {
            "scheme": self.scheme,
            "step": setting,
            "until": until,
            "b": pair.spans[0].b,
            "spans": [asdict(span) for span in pair.spans],
            **{name: getattr(pair, name) for name in ("m1", "m2", "a1", "a2", "y")},
        }

        def run() -> PeerRun:
            if until / setting > MAX_STEPS:
                raise PeerFailed(f"{until / setting:.0f} steps are beyond the cap of {MAX_STEPS}")
            answer = ask(request)
            kinds, y = tuple(EventKind(kind) for kind in answer["kinds"]), np.array(answer["y"])
            lost = pair.energy(pair.y) + answer["work"] - pair.energy(answer["y"])
            return PeerRun(kinds, np.array(answer["times"]), y, lost, answer["steps"], answer["elapsed"])

        return run
