"""Trades with planted answers, as `python -m numerics trade --json` would write them."""

from pathlib import Path

from numerics.trade.recorded import Row, Trade, recorded

MACHINE = {"processor": "Abacus", "cores": 2, "load": 0.1, "python": "3.11", "packages": {"numpy": "2"}}
SCENES = ("velocities", "relative-motion-b05", "near-critical-1e-6")


def row(
    method: str, scene: str, ratio: float | None = None, digits: float = 15.0, note: str = "", setting: float = 15
) -> Row:
    """Return a row with so many digits of the states; float64 takes a millisecond, what has no ratio does not end."""
    seconds = None if ratio is None else 1e-3 * ratio
    return Row(scene, method, setting, seconds, ratio, 24, None if note else digits, note)


def trade_of(*rows: Row, **more: object) -> Trade:
    """Return a trade of float64 with 14.5 digits and balls with 40 on all scenes, and of further rows."""
    ours = [row(*one) for scene in SCENES for one in (("float64", scene, 1.0, 14.5), ("balls", scene, 100.0, 40.0))]
    every = (*ours, *rows)
    given = {"machine": MACHINE, "left_out": {}, "scenes": {one.scene: "planted" for one in every}}
    return Trade(**(given | more), rows=every)


def planted(folder: Path, *rows: Row, **more: object) -> Trade:
    """Return the trade that was written into a file of a folder and read again."""
    path = folder / "planted.json"
    path.write_text(trade_of(*rows, **more).text(), "utf-8")
    return recorded(path)
