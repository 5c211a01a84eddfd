"""The trade as a picture: digits against time on every scene, and how cost grows with the horizon."""

from __future__ import annotations

import math
from typing import Any

from numerics.trade.recorded import Trade
from numerics.trade.scenes import LONG

MARKERS = "osD^vP*X"
"""Contenders are told apart by them also without colour."""


def draw_trade(trade: Trade, columns: int = 4, panel_size: tuple[float, float] = (4.6, 3.2)) -> Any:
    """Return a matplotlib figure: a panel a scene, right digits upwards, time to the right; sizes in inches.

    A mark is a run. Filled: its events are right; hollow: they are wrong. The last panel has the time of an excursion
    on longer and longer horizons.
    """
    from matplotlib.figure import Figure

    count = len(trade.scenes) + 1
    columns = min(columns, count)
    rows = math.ceil(count / columns)
    figure = Figure(figsize=(panel_size[0] * columns, panel_size[1] * rows), layout="constrained")
    places = figure.subplots(rows, columns, squeeze=False).flatten()
    for spare in places[count:]:
        spare.remove()
    *panels, last = places[:count]
    for number, who in enumerate(dict.fromkeys(one.who for one in trade.runs)):
        style: dict[str, Any] = {"color": f"C{number}", "marker": MARKERS[number % len(MARKERS)], "ms": 5, "lw": 0.9}
        far: dict[int, float] = {}
        for scene, panel in zip(trade.scenes, panels, strict=True):
            some = [(one.seconds, max(-0.7, one.digits or 0), one) for one in trade.of(scene, who) if one.seconds]
            for right, more in ((True, {"label": who}), (False, {"ls": "", "mfc": "none"})):
                at = sorted((seconds, digits) for seconds, digits, one in some if one.right is right)
                panel.plot([x for x, _ in at], [y for _, y in at], **style, **more)
            if scene.startswith(LONG) and some:
                excursions = int(scene.removeprefix(LONG))
                far[excursions] = min(seconds for seconds, *_ in some) / excursions
        if far:
            last.loglog(sorted(far), [far[one] for one in sorted(far)], **style)
    for scene, panel in zip(trade.scenes, panels, strict=True):
        panel.set(xscale="log", title=scene, xlabel="time (s)", ylabel="right digits")
        panel.set_yscale("symlog", linthresh=20, linscale=2.5)
        panel.grid(alpha=0.25)
    last.set(title="longer horizons", xlabel="excursions", ylabel="s for each")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=5)
    return figure
