"""What a user waits for at the public interface, beside the run inside and two peers: in one process, in turns.

`python -m numerics trade --interface` prints it. The clock decides nothing here: what is wished for stands beside what
was found, and a reader compares.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from numerics.arithmetic.float64 import FLOAT64
from numerics.arithmetic.telling import can_compile
from numerics.scene import Scene, State
from numerics.scene.file import load_scene
from numerics.solver.prepared import Solver
from numerics.solver.solve import solve
from numerics.trade.clock import BATCH
from numerics.trade.contender import all_contenders
from numerics.trade.ours import batch_call, inside, looked_at
from numerics.trade.scenes import HEADLINE

RUN, SOLVE, READ = "the run inside", "solve(scene)", "t, y, modes, t_events of it, together"
_PEERS = {"heyoka (edge coordinates)": 1e-15, "SciPy DOP853 (edge coordinates)": 1e-12, "SciPy LSODA": 1e-12}
"""At settings with about as many right digits as float64 has."""
_MANY = 1000
SHARE = f"solve_many, a scene of {_MANY:,}"
_COMPILE = "from numerics.trade.interface import compile_now; print(compile_now())"


@dataclass(frozen=True)
class Wait:
    """How long a call takes (s), how many times as long as another one, and how long it should take at most."""

    call: str
    seconds: float
    by: str = ""
    """The call that it is compared with; "" for seconds by themselves."""
    ratio: float | None = None
    most: float | None = None
    """Of the ratio, or of the seconds where there is none."""

    @property
    def kept(self) -> bool | None:
        """Return whether it is as it should be; None where nothing is asked of it."""
        return None if self.most is None else (self.seconds if self.ratio is None else self.ratio) <= self.most

    def as_record(self) -> dict[str, Any]:
        """Return it as the object that JSON carries."""
        return asdict(self)


def interface(budget: float, compilation: bool) -> list[Wait]:
    """Measure the headline scene for about so many seconds a call; `compilation`: compile everything anew as well."""
    scene = load_scene(HEADLINE)
    enough = _digits_of_float64(scene)
    took = in_turns(_our_calls(scene, enough) | _peer_calls(scene), budget)
    took[READ] -= took[SOLVE]
    took[SHARE] /= _MANY
    run, call, answer = took[RUN], took[SOLVE], took[SOLVE] + took[READ]
    asked = {
        SOLVE: (RUN, run, 6.0),
        READ: (SOLVE, call, 1.0),
        "Scene(...), solve(scene)": (RUN, run, None),
        "solver(state, until)": (RUN, run, 3.0),
        "solver(State(...), until)": (RUN, run, None),
        f"solve(scene, digits={enough})": (SOLVE, call, 2.0),
        "solve(scene, digits=12)": (SOLVE, call, 2.0 if enough >= 12 else None),
        "solve_many, one scene": ("", None, 60e-6),
        SHARE: (RUN, run, None),
    }
    found = []
    for name, seconds in took.items():
        by, other, most = asked.get(name, (f"{SOLVE}, read", answer, None) if name in _PEERS else ("", None, None))
        found.append(Wait(name, seconds, by, None if other is None else seconds / other, most))
    if compilation and can_compile():
        found.append(Wait("first compilation, float64", first_compilation(), most=12.0))
    return found


def _digits_of_float64(scene: Scene) -> int:
    accuracy = solve(scene).accuracy
    return accuracy.digits if accuracy is not None else 0


def _our_calls(scene: Scene, enough: int) -> dict[str, Callable[[], object]]:
    pair, at, until, law = scene.pair, scene.initial, scene.until, scene.law
    solver = Solver(pair, law)
    return {
        RUN: inside(FLOAT64, compiled=True)(scene, 53.0),
        SOLVE: lambda: solve(scene),
        READ: lambda: looked_at(solve(scene)),
        "Scene(...), solve(scene)": lambda: solve(Scene(pair, State(at.x1, at.v1, at.x2, at.v2), until, law)),
        "solver(state, until)": lambda: solver(at, until),
        "solver(State(...), until)": lambda: solver(State(at.x1, at.v1, at.x2, at.v2), until),
        f"solve(scene, digits={enough})": lambda: solve(scene, digits=enough),
        "solve(scene, digits=12)": lambda: solve(scene, digits=12),
        "solve_many, one scene": batch_call(scene, 1, 1),
        SHARE: batch_call(scene, _MANY, 1),
    }


def _peer_calls(scene: Scene) -> dict[str, Callable[[], object]]:
    peers = {one.label: one for one in all_contenders() if one.label in _PEERS and one.missing() is None}
    return {label: one.prepare(scene, _PEERS[label]) for label, one in peers.items()}


def in_turns(calls: Mapping[str, Callable[[], object]], budget: float) -> dict[str, float]:
    """Return the median time of every warm call (s), in turn with the others, so that all share the noise."""
    inner, taken = {}, {name: [] for name in calls}  # type: dict[str, int], dict[str, list[float]]
    for name, call in calls.items():
        call()
        start = time.perf_counter()
        call()
        inner[name] = max(1, round(BATCH / (time.perf_counter() - start)))
    end = time.perf_counter() + budget * len(calls)
    while len(taken[next(iter(calls))]) < 3 or time.perf_counter() < end:
        for name, call in calls.items():
            start = time.perf_counter()
            for _ in range(inner[name]):
                call()
            taken[name].append((time.perf_counter() - start) / inner[name])
    return {name: statistics.median(some) for name, some in taken.items()}


def first_compilation() -> float:
    """Return how long the float64 run takes to be compiled (s) by a new process with an empty cache."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [sys.executable, "-c", _COMPILE],
            env={**os.environ, "NUMBA_CACHE_DIR": folder},
            stdout=subprocess.PIPE,
            encoding="utf-8",
            check=True,
        )
    return float(done.stdout)


def compile_now() -> float:
    """Return how long it takes this process to bring up the compiled run, numba's import included (s)."""
    start = time.perf_counter()
    inside(FLOAT64, compiled=True)(load_scene(HEADLINE), 53.0)
    return time.perf_counter() - start
