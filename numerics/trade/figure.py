"""The figure of a trade: right digits against time, all scenes in one picture."""

from __future__ import annotations

from statistics import median
from typing import Any

from numerics.trade.recorded import Trade

MARKERS = "os^vDP"
"""Methods differ by marker too, not only by colour."""
TICKS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
FEWEST = 0.5
"""Fewer digits are drawn as so many."""


def draw_trade(trade: Trade, size: tuple[float, float] = (7.2, 4.6)) -> Any:
    """Return a matplotlib figure, size in inches: right digits upwards, time by that of float64 to the right.

    A mark is a method with a setting on a scene, hollow where an event is wrong; a line joins the medians over scenes.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="constrained")
    panel, rows = figure.subplots(), [one for one in trade.rows if one.seconds]
    in_seconds = any(one.ratio is None for one in rows)
    for place, method in enumerate(dict.fromkeys(one.method for one in rows)):
        own, color = [one for one in rows if one.method == method], f"C{place}"
        points = [(one.seconds if in_seconds else one.ratio, max(one.digits or 0.0, FEWEST)) for one in own]
        filled = [color if one.right else "none" for one in own]
        look: dict[str, Any] = {"marker": MARKERS[place], "edgecolors": color, "facecolors": filled, "s": 30}
        panel.scatter(*zip(*points, strict=True), **look, alpha=0.7, label=method)
        settings = dict.fromkeys(one.setting for one in own)
        some = ([point for one, point in zip(own, points, strict=True) if one.setting == k] for k in settings)
        panel.plot(*zip(*[tuple(map(median, zip(*one, strict=True))) for one in some], strict=True), color=color)
    panel.set(xscale="log", yscale="log", ylabel="right digits of the worst error")
    panel.set_xlabel("time (s)" if in_seconds else "time, by that of float64 on the same scene")
    panel.set_yticks(TICKS, [*map(str, TICKS)])
    panel.set_ylim(FEWEST * 0.9, None)
    panel.grid(alpha=0.25)
    panel.legend(loc="upper left")
    return figure
