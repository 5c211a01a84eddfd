"""The trade as pictures: error against time on every scene, and how cost grows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Protocol

from numerics.trade.front import Point, best_front
from numerics.trade.growth import Growth
from numerics.trade.ours import BALL, COMPILED
from numerics.trajectory.export import whole_file

OUR_COLOURS = ("#b30000", "#ef6548", "#fdae6b", "#e7298a", "#7f2704", "#ff2a1a")
PEER_COLOURS = (
    "#08519c", "#3182bd", "#006d2c", "#31a354", "#54278f", "#756bb1", "#111111", "#737373", "#01665e", "#35978f",
    "#8c6d31", "#bd9e39", "#5254a3", "#9c9ede",
)  # fmt: skip
MARKERS = "osD^vP<>X*"
AXES = {"digits": "digits", "events": "events", "m1/m2": "$m_1/m_2$", "batch": "scenes in a batch"}
LEGEND = "right digits: of the worst of final state,\nlast event and dissipated energy"
_LINEAR_DIGITS = 20
"""Up to here right digits are drawn to a linear scale, beyond to a logarithmic one."""
_TICKS = (0, 5, 10, 15, 30, 100, 1000, 10_000)


class Drawable(Protocol):
    """What is drawn: a Trade just measured, or a RecordedTrade."""

    @property
    def scenes(self) -> Sequence[Any]:
        """Scenes with a `name`."""

    @property
    def contenders(self) -> Sequence[Any]:
        """Contenders with a `label`."""

    @property
    def growth(self) -> Sequence[Growth]:
        """All growth curves."""

    def points(self, scene: Any, /) -> list[Point]:
        """Return the points of one of the scenes."""


def write_figures(trade: Drawable, path: Path) -> None:
    """Write the work-precision figure to `path`, and the growth beside it with "-growth" before the suffix."""
    figures = {path: draw_trade(trade)}
    if any(one.seconds_per_event for one in trade.growth):
        figures[path.with_name(f"{path.stem}-growth{path.suffix}")] = draw_growth(trade)
    for name, figure in figures.items():
        with whole_file(name) as file:
            figure.savefig(file, format=name.suffix[1:], dpi=150)


def draw_trade(trade: Drawable, columns: int = 4, panel_size: tuple[float, float] = (4.2, 3.4)) -> Any:
    """Return a matplotlib figure: a panel a scene, right digits upwards, time to the right; sizes in inches.

    Filled: the event sequence is right; hollow: it is wrong. Ours in reds; the front as a black line.
    """
    from matplotlib.figure import Figure

    styles = _styles(trade)
    columns = min(columns, len(trade.scenes))
    rows = math.ceil(len(trade.scenes) / columns)
    width, height = panel_size
    below = 0 if len(trade.scenes) < rows * columns else 1.2  # the legend, if no panel is free for it
    figure = Figure(figsize=(width * columns, height * rows + below), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).flatten().tolist()
    for scene, panel in zip(trade.scenes, panels, strict=False):
        _draw_scene(panel, trade, scene, styles)
    spare = panels[len(trade.scenes) :]
    for panel in spare:
        panel.set_axis_off()
    if spare:
        _draw_legend(spare[0], styles, loc="center", ncols=2, frameon=False)
    else:
        _draw_legend(figure, styles, loc="outside lower center", ncols=2 * columns)
    return figure


def _styles(trade: Drawable) -> dict[str, dict[str, Any]]:
    """Return colour and marker of every contender that has a point."""
    names: dict[str, bool] = {}
    for scene in trade.scenes:
        names |= {one.contender: one.ours for one in trade.points(scene)}
    own, others = ([name for name, ours in names.items() if ours is wanted] for wanted in (True, False))
    styles = {name: {"color": OUR_COLOURS[i % 6], "marker": MARKERS[i % 10], "ms": 7} for i, name in enumerate(own)}
    for i, name in enumerate(others):
        styles[name] = {"color": PEER_COLOURS[i % len(PEER_COLOURS)], "marker": MARKERS[i % 10], "ms": 5}
    return styles


def _draw_scene(panel: Any, trade: Drawable, scene: Any, styles: dict[str, dict[str, Any]]) -> None:
    from matplotlib.ticker import NullLocator

    candidates = trade.points(scene)
    front = best_front(candidates)
    panel.plot([one.seconds for one in front], [_shown(one) for one in front], color="black", lw=1, zorder=1)
    for name, style in styles.items():
        mine = sorted((one for one in candidates if one.contender == name), key=lambda one: one.seconds)
        for right in (True, False):
            some = [one for one in mine if one.right is right]
            face = style["color"] if right else "none"
            at = ([one.seconds for one in some], [_shown(one) for one in some])
            panel.plot(*at, linestyle="", mfc=face, mew=1.1, zorder=2, **style)
    panel.set(xscale="log", title=scene.name, xlabel="time (s)", ylabel="right digits")
    panel.set_yscale("symlog", linthresh=_LINEAR_DIGITS, linscale=2.5)
    most = max((_shown(one) for one in candidates), default=0.0)
    panel.set_yticks([tick for tick in _TICKS if tick <= max(20, 1.2 * most)])
    panel.set_ylim(-1.5, max(22, 1.6 * most))
    panel.yaxis.set_major_formatter(lambda value, _: f"{value:,.0f}")
    panel.yaxis.set_minor_locator(NullLocator())
    _whole_decades(panel, [one.seconds for one in candidates])
    panel.grid(alpha=0.25)


def _whole_decades(panel: Any, seconds: list[float]) -> None:
    """Let a time axis run from one power of ten to another, labelled at these only."""
    from matplotlib.ticker import LogLocator, NullFormatter

    panel.xaxis.set_major_locator(LogLocator(numticks=12))
    panel.xaxis.set_minor_formatter(NullFormatter())
    if seconds:
        low, high = math.floor(math.log10(min(seconds)) - 0.1), math.ceil(math.log10(max(seconds)) + 0.1)
        panel.set_xlim(10.0**low, 10.0**high)


def _shown(one: Point) -> float:
    """Return right digits; what is wrong in the first one stands just below 0."""
    return max(-0.7, -one.error)


def _draw_legend(place: Any, styles: dict[str, dict[str, Any]], **how: Any) -> None:
    from matplotlib.lines import Line2D

    signs = [Line2D([], [], linestyle="", label=name, **style) for name, style in styles.items()]
    signs.append(Line2D([], [], linestyle="", marker="o", mfc="none", color="gray", label="hollow: events wrong"))
    signs.append(Line2D([], [], color="black", lw=1, label="the front"))
    place.legend(handles=signs, fontsize="small", title=LEGEND, title_fontsize="small", **how)


def draw_growth(trade: Drawable, columns: int = 4, panel_size: tuple[float, float] = (4.4, 3.4)) -> Any:
    """Return a matplotlib figure: the time of one event (of one scene, for batches) along each axis, log-log."""
    from matplotlib.figure import Figure

    timed = [one for one in trade.growth if one.seconds_per_event]
    axes = [axis for axis in AXES if any(one.axis == axis for one in timed)]
    names = list(dict.fromkeys(one.contender for one in trade.growth))
    names.sort(key=[*(one.label for one in trade.contenders), *names].index)
    columns = min(columns, len(axes))
    rows = math.ceil(len(axes) / columns)
    figure = Figure(figsize=(panel_size[0] * columns, panel_size[1] * rows + 0.6), layout="constrained")
    drawn: dict[str, Any] = {}
    panels = figure.subplots(rows, columns, squeeze=False).flatten().tolist()
    for panel in panels[len(axes) :]:
        panel.set_axis_off()
    for axis, panel in zip(axes, panels, strict=False):
        drawn |= _draw_axis(panel, [one for one in timed if one.axis == axis], names)
        unit = "s for each scene" if axis == "batch" else "s for each event"
        panel.set(xlabel=AXES[axis], ylabel=unit)
    below = {"loc": "outside lower center", "ncols": columns + 1, "fontsize": "small", "frameon": False}
    figure.legend(drawn.values(), drawn.keys(), **below)
    return figure


def _draw_axis(panel: Any, growth: list[Growth], names: list[str]) -> dict[str, Any]:
    """Draw every curve along one axis, dashed on more than one core; return the lines by what the legend calls them."""
    from matplotlib.ticker import NullFormatter

    drawn = {}
    for name, cores in sorted({(one.contender, one.cores) for one in growth}):
        curve = [one for one in growth if (one.contender, one.cores) == (name, cores)]
        index, called = names.index(name), name if cores == 1 else f"{name}, {cores} cores"
        style = {"color": OUR_COLOURS[index % 6], "marker": MARKERS[index % 10], "ms": 5}
        at = ([one.x for one in curve], [one.seconds_per_event for one in curve])
        (drawn[called],) = panel.plot(*at, "-" if cores == 1 else "--", **style)
    for name, dots in ((BALL, ":"), (COMPILED, "-.")):
        costs = {one.x: one.sine_cosine_seconds for one in growth if one.contender == name and one.sine_cosine_seconds}
        called = "one arb.sin_cos" if name == BALL else "one compiled sine-cosine pair"
        if costs:
            (drawn[called],) = panel.plot(list(costs), list(costs.values()), dots, color="gray", marker=".")
    panel.set(xscale="log", yscale="log")
    panel.xaxis.set_minor_formatter(NullFormatter())
    seconds = [one for line in panel.lines for one in line.get_ydata()]
    panel.set_ylim(10.0 ** math.floor(math.log10(min(seconds))), 10.0 ** math.ceil(math.log10(max(seconds))))
    panel.grid(alpha=0.25)
    return drawn
