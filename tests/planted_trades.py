"""Trades with planted answers, as `python -m numerics trade --json` would write them."""

from pathlib import Path

from numerics.trade.recorded import NONE, TimedRun, Trade, recorded

MACHINE = {"processor": "Abacus", "cores": 2, "load": 0.1, "python": "3.11", "packages": {"numpy": "2"}}
SCENES = ("velocities", "relative-motion-b05", "near-critical-1e-6")


def run(
    who: str,
    scene: str,
    seconds: float | None,
    digits: float | None = None,
    right: bool | None = True,
    asked: float = 0,
) -> TimedRun:
    """Return a run of a peer, or of ours; its note where the events are wrong or there is no answer."""
    note = {True: "", False: "1 events, not 24", None: f"{NONE}stopped"}[right]
    return TimedRun(scene, who, asked if who == "solve" else 15.0, seconds, digits, note)


def trade_of(*runs: TimedRun, **more: object) -> Trade:
    """Return a trade of `solve` with 14 digits and balls with 40 on all scenes, and of further runs."""
    ours = [run(*one) for scene in SCENES for one in (("solve", scene, 1e-3, 14.5), ("ball", scene, 1e-2, 40.0))]
    every = (*ours, *runs)
    given = {"machine": MACHINE, "left_out": {}, "scenes": {one.scene: "planted" for one in every}}
    return Trade(**(given | more), runs=every)


def planted(folder: Path, *runs: TimedRun, **more: object) -> Trade:
    """Return the trade that was written into a file of a folder and read again."""
    path = folder / "planted.json"
    path.write_text(trade_of(*runs, **more).text(), "utf-8")
    return recorded(path)
