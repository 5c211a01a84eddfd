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

    A small mark is a method with a setting on a scene; larger ones, joined by a line, are the medians over
    several scenes. Hollow: an event is wrong, however many digits agree.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="constrained")
    panel, big = figure.subplots(), 5 if len(trade.scenes) == 1 else 8
    rows = [one for one in trade.rows if one.seconds]
    in_seconds = any(one.ratio is None for one in rows)
    for place, method in enumerate(dict.fromkeys(one.method for one in rows)):
        look: dict[str, Any] = {"marker": MARKERS[place], "color": f"C{place}"}
        middle = []
        for setting in dict.fromkeys(one.setting for one in rows if one.method == method):
            some = [one for one in rows if (one.method, one.setting) == (method, setting)]
            points = [((one.seconds if in_seconds else one.ratio) or 0.0, max(one.digits, FEWEST)) for one in some]
            for row, (x, y) in zip(some, points, strict=True):
                panel.plot(x, y, **look, ms=5, alpha=0.6, mfc=look["color"] if row.right else "none")
            middle.append(tuple(map(median, zip(*points, strict=True))))
            right = all(one.right for one in some)
            panel.plot(*middle[-1], **look, ms=big, mfc=look["color"] if right else "white")
        panel.plot(*zip(*middle, strict=True), color=look["color"], zorder=1)
        panel.plot([], [], **look, label=method)
    panel.set(xscale="log", yscale="log", ylabel="right digits of the worst error")
    panel.set_xlabel("time (s)" if in_seconds else "time, by that of float64 on the same scene")
    panel.set_yticks(TICKS, [*map(str, TICKS)])
    panel.set_ylim(FEWEST * 0.9, None)
    panel.grid(alpha=0.25)
    panel.legend(loc="upper left")
    return figure
