"""Siconos time stepping with a relay law at v1 - v2, run by Debian's own Python in a process of its own."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from numerics.motion.modes import EventKind
from numerics.scene import Scene
from numerics.trade.comparisons.peer import PeerFailed, PeerRun
from numerics.trade.comparisons.switching import SwitchedPair

MAX_STEPS = 3_000_000
TIME_LIMIT = 300.0
CHILD = Path(__file__).with_name("siconos_child.py")


class SiconosPeer:
    """The implicit relay at fixed steps; it sticks where the multiplier stays inside (-b, b), without chatter."""

    forced = False
    knob = "step (s)"
    settings: tuple[float, ...] = (1e-2, 1e-3, 1e-4, 1e-5)

    def __init__(self, scheme: str) -> None:
        """Take the one-step integrator: "ZeroOrderHold" or "EulerMoreau"."""
        self.scheme = scheme
        self.name = f"Siconos {scheme}"
        self.use = "exact linear flow, implicit relay" if scheme == "ZeroOrderHold" else "theta = 1/2, implicit relay"

    def missing(self) -> str | None:
        """Ask the system's interpreter whether it can import siconos."""
        return None if _interpreter() else "python3-siconos (a package of Debian, for /usr/bin/python3)"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Write the request; each run starts a process, warms up on a few steps, and times the others."""
        pair = SwitchedPair.of(scene)
        request = {
            "scheme": self.scheme,
            "step": setting,
            "until": pair.until,
            **{name: getattr(pair, name) for name in ("m1", "m2", "a1", "a2", "b", "y")},
        }

        def run() -> PeerRun:
            if pair.until / setting > MAX_STEPS:
                raise PeerFailed(f"{pair.until / setting:.0f} steps are beyond the cap of {MAX_STEPS}")
            answer = ask(request)
            kinds = tuple(EventKind(kind) for kind in answer["kinds"])
            y = np.array(answer["y"])
            lost = pair.lost(y[0], y[1], y[3])
            return PeerRun(kinds, np.array(answer["times"]), y, lost, answer["steps"], answer["elapsed"])

        return run


@cache
def _interpreter() -> str | None:
    """Return the system's interpreter if it can import siconos, else None."""
    python = shutil.which("python3", path="/usr/bin")
    if python is None:
        return None
    probe = subprocess.run([python, "-I", "-c", "import siconos.kernel"], capture_output=True, check=False, timeout=60)
    return python if probe.returncode == 0 else None


def ask(request: dict[str, object]) -> dict[str, Any]:
    """Return the answer of siconos_child.py. Raises PeerFailed."""
    command = [str(_interpreter()), "-I", str(CHILD)]
    done = subprocess.run(
        command, input=json.dumps(request), capture_output=True, encoding="utf-8", check=False, timeout=TIME_LIMIT
    )
    if done.returncode:
        raise PeerFailed(f"Siconos: {done.stderr.strip()[-300:]}")
    answer: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return answer
