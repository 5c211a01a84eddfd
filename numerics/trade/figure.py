"""Figure of a trade: digits against time on every scene."""

from __future__ import annotations

import math
from typing import Any

from numerics.trade.recorded import Trade

MARKERS = "osD^vP*Xh"
"""Methods differ by marker too, not only by colour."""


def draw_trade(trade: Trade, columns: int = 4, panel_size: tuple[float, float] = (4.6, 3.2)) -> Any:
    """Return a matplotlib figure: a panel a scene, right digits upwards, time to the right; sizes in inches.

    A mark is a run. Filled: its events are right; hollow: they are wrong.
    """
    from matplotlib.figure import Figure

    rows = math.ceil(len(trade.scenes) / columns)
    figure = Figure(figsize=(panel_size[0] * columns, panel_size[1] * rows), layout="constrained")
    panels, handles = figure.subplots(rows, columns, squeeze=False).flatten(), dict[str, Any]()
    for spare in panels[len(trade.scenes) :]:
        spare.remove()
    people = list(dict.fromkeys(one.who for one in trade.runs))
    for scene, panel in zip(trade.scenes, panels, strict=False):
        for who in dict.fromkeys(one.who for one in trade.of(scene)):
            place = people.index(who)
            style: dict[str, Any] = {"color": f"C{place}", "marker": MARKERS[place % len(MARKERS)], "ms": 5, "lw": 0.9}
            for right, more in ((True, {}), (False, {"ls": "", "mfc": "none"})):
                some = [one for one in trade.of(scene, who) if one.seconds and one.right is right]
                at = sorted((one.seconds, max(-0.7, one.digits or 0)) for one in some)
                (line,) = panel.plot([x for x, _ in at], [y for _, y in at], **style, **more)
                handles.setdefault(who, line)
        panel.set(xscale="log", title=scene, xlabel="time (s)", ylabel="right digits")
        panel.set_yscale("symlog", linthresh=20, linscale=2.5)
        panel.set_ylim(-3, 1.5 * panel.dataLim.ymax)  # the library's margin is that of a linear scale: marks are cut
        panel.grid(alpha=0.25)
    figure.legend(handles.values(), handles.keys(), loc="outside lower center", ncols=5)
    return figure
