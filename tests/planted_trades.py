"""Trades with planted answers, as `python -m numerics trade --json` would write them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from numerics.trade.euler import EulerFigure, EulerOutcome
from numerics.trade.ours import COMPILED, PLAIN, READ
from numerics.trade.recorded import RecordedTrade, recorded

MACHINE = {"processor": "Abacus", "cores": 2, "system": "Linux", "python": "3.11", "packages": {"numpy": "2"}}
SCENES = ("velocities", "relative-motion-b05", "near-critical-1e-6")


def run(contender: str, scene: str, seconds: float | None, error: Any = None, **more: Any) -> dict[str, Any]:
    """Return a run; ours if its contender is known to be. Without an error it was stopped."""
    ours = contender.startswith(("float64", "solve", "ball", "mpmath", "double-double"))
    record = {"contender": contender, "ours": ours, "scene": scene, "knob": "digits", "setting": 53.0}
    record |= {"status": "stopped" if error is None else "measured", "note": "", "prepare_seconds": 0.5}
    record |= {"seconds": seconds, "batches": 3}
    if error is not None:
        record |= {"right": True, "difference": None, "log10_error": error}
    return record | more


def our_runs(compiled: bool = True) -> list[dict[str, Any]]:
    """Return runs of ours on all scenes: `solve` and what runs inside with 14 digits, balls with 100, mpmath."""
    runs = []
    for scene in SCENES:
        runs += [run(COMPILED, scene, 4e-6, -14.5)] if compiled else []
        runs += [run(PLAIN, scene, 3e-4, -14.5), run(READ, scene, 5e-4, -14.5)]
        runs += [run("ball", scene, 2e-3, -22.0, setting=10.0), run("ball", scene, 3e-3, -112.0, setting=100.0)]
        runs += [run("mpmath", scene, 2e-2, -21.0, setting=10.0)]
    return runs


def growth() -> list[dict[str, Any]]:
    """Return a curve along each axis."""
    point = {"events": 32, "note": "", "sine_cosine_seconds": None, "cores": 1}
    curves = [("digits", "ball", 10.0, 5e-5), ("digits", "ball", 1000.0, 4e-4)]
    curves += [("events", PLAIN, 20.0, 1e-5), ("events", PLAIN, 200.0, 2e-5)]
    curves += [("m1/m2", PLAIN, 1e-6, 1e-5), ("m1/m2", PLAIN, 1e6, 3e-5)]
    found = [point | {"axis": a, "contender": c, "x": x, "seconds_per_event": s} for a, c, x, s in curves]
    found[0]["sine_cosine_seconds"], found[1]["sine_cosine_seconds"] = 2.5e-7, 2e-5
    batch = point | {"axis": "batch", "contender": "solve_many", "events": None}
    found += [batch | {"x": x, "seconds_per_event": s} for x, s in ((1.0, 6e-4), (100.0, 8e-6))]
    return [*found, batch | {"x": 100.0, "seconds_per_event": 4e-6, "cores": 2}]


def record(runs: list[dict[str, Any]] | None = None, **more: Any) -> dict[str, Any]:
    """Return the record of a trade."""
    scenes = [{"scene": name, "why": "planted"} for name in SCENES]
    found = {"size": "small", "machine": MACHINE, "left_out": [], "scenes": scenes, "references": [], "front": []}
    return found | {"leads": [], "runs": our_runs() if runs is None else runs, "growth": growth()} | more


def with_forced() -> list[dict[str, str]]:
    """Return the scenes of a record and one under a force."""
    return [{"scene": name, "why": "planted"} for name in (*SCENES, "forced-touch")]


def planted(folder: Path, *more_runs: dict[str, Any], **more: Any) -> RecordedTrade:
    """Return the trade of a record with further runs, read from a file."""
    made = record(**more)
    made["runs"] = [*made["runs"], *more_runs]
    path = folder / "planted.json"
    path.write_text(json.dumps(made), "utf-8")
    return recorded(path)


EULER_FIGURE = EulerFigure(
    "9",
    7,
    2.0,
    (EulerOutcome(1e-2, False, "5 events, not 7", 1.0, 0), EulerOutcome(1e-3, True, None, -1.5, 40)),
)
"""Forward Euler on a figure that the paper does not have: wrong with the coarser of two steps."""
