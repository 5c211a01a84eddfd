"""The trade as pictures: error against time on every scene, and how cost grows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol

from numerics.files import whole_file
from numerics.trade.front import Point, best_front
from numerics.trade.growth import Growth
from numerics.trade.ours import BALL, COMPILED, DOUBLE, MANY, MPMATH, READ

COLOURS = ("#D55E00", "#0072B2", "#009E73", "#CC79A7", "#000000", "#8C6D00")
"""Told apart by those who do not see all colours, with `MARKERS` also without colour (after Okabe and Ito)."""
MARKERS = "osD^vP"
AXES = {"digits": "digits", "events": "events", "m1/m2": "$m_1/m_2$", "batch": "scenes in a batch"}
_LINEAR_DIGITS = 20
"""Up to here right digits are drawn to a linear scale, beyond to a logarithmic one."""
GROWTH_TITLES = {
    "digits": "more digits",
    "events": "more events",
    "m1/m2": "heavier driving bodies",
    "batch": "more scenes at once",
}
FAST, PROVING = "ours, fast", "ours, proving"
"""Our float64 and double-double; our balls, and mpmath that checks them."""
MOST_OTHERS = 4
"""Families of others that are told apart in a panel; more share the last one."""
_ROOM = 0.075
"""Height of a label, as a share of its panel's."""
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


def draw_trade(trade: Drawable, columns: int = 4, panel_size: tuple[float, float] = (4.6, 3.2)) -> Any:
    """Return a matplotlib figure: a panel a scene, right digits upwards, time to the right; sizes in inches.

    A mark is a family of methods, drawn by its best runs: no other run of the family beats them in both. Filled: the
    event sequence is right; hollow: it is wrong.
    """
    from matplotlib.figure import Figure

    of = families(trade)
    columns = min(columns, len(trade.scenes))
    rows = math.ceil(len(trade.scenes) / columns)
    width, height = panel_size
    figure = Figure(figsize=(width * columns, height * rows), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).flatten().tolist()
    for scene, panel in zip(trade.scenes, panels, strict=False):
        _draw_scene(panel, trade, scene, of)
    for panel in panels[len(trade.scenes) :]:
        panel.set_axis_off()
    return figure


def families(trade: Drawable) -> dict[str, str]:
    """Return the family of every contender that has a point: two of ours, and at most four of others."""
    names: dict[str, bool] = {}
    for scene in trade.scenes:
        names |= {one.contender: one.ours for one in trade.points(scene)}
    heads = list(dict.fromkeys(_head(name) for name, ours in names.items() if not ours))
    last = " and ".join(heads[MOST_OTHERS - 1 :])
    found = {name: head if head in heads[: MOST_OTHERS - 1] else last for name, head in ((n, _head(n)) for n in names)}
    return found | {name: PROVING if name in (BALL, MPMATH) else FAST for name, ours in names.items() if ours}


def _head(name: str) -> str:
    """Return the name of a package, or of a method that is nobody's.

    >>> _head("SciPy Radau"), _head("forward Euler (plain Python)")
    ('SciPy', 'forward Euler')
    """
    words = name.partition(" (")[0].split()
    return " ".join(words[: 2 if words[0] == "forward" else 1])


def _draw_scene(panel: Any, trade: Drawable, scene: Any, of: dict[str, str]) -> None:
    from matplotlib.ticker import NullLocator

    candidates = trade.points(scene)
    labels: list[tuple[float, str, str]] = []
    for number, family in enumerate(dict.fromkeys(of.values())):
        mine = [one for one in candidates if of[one.contender] == family]
        style = {"color": COLOURS[number], "marker": MARKERS[number], "ms": 5}
        best = best_front(mine)
        panel.plot([one.seconds for one in best], [_shown(one) for one in best], lw=0.9, zorder=3, **style)
        wrong = best_front([replace(one, right=True) for one in mine if not one.right])
        at = ([one.seconds for one in wrong], [_shown(one) for one in wrong])
        panel.plot(*at, linestyle="", mfc="none", mew=1.0, zorder=2, **style)
        if mine:
            labels.append((max(_shown(one) for one in best or wrong), family, COLOURS[number]))
    panel.set(xscale="log", title=scene.name, xlabel="time (s)", ylabel="right digits")
    panel.set_yscale("symlog", linthresh=_LINEAR_DIGITS, linscale=2.5)
    most = max((_shown(one) for one in candidates), default=0.0)
    panel.set_yticks([tick for tick in _TICKS if tick <= max(20, 1.2 * most)])
    panel.set_ylim(-1.5, max(22, 1.6 * most))
    panel.yaxis.set_major_formatter(lambda value, _: f"{value:,.0f}")
    panel.yaxis.set_minor_locator(NullLocator())
    _whole_decades(panel, [one.seconds for one in candidates])
    panel.grid(alpha=0.25)
    _label(panel, labels)


def _label(panel: Any, labels: list[tuple[float, str, str]]) -> None:
    """Write names right of the axes, each as high as its curve ends, or higher where there is no room."""
    scale, least = panel.transData + panel.transAxes.inverted(), -1.0
    for height, name, colour in sorted(labels):
        place = max(float(scale.transform((1.0, height))[1]), least + _ROOM)
        panel.annotate(name, (1.02, place), xycoords="axes fraction", color=colour, va="center", fontsize=9)
        least = place


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


def draw_growth(trade: Drawable, columns: int = 4, panel_size: tuple[float, float] = (4.6, 3.2)) -> Any:
    """Return a matplotlib figure: the time of one event (of one scene, for batches) along each axis, log-log."""
    from matplotlib.figure import Figure

    timed = [one for one in trade.growth if one.seconds_per_event]
    names = _most_telling(timed)
    timed = [one for one in timed if one.contender in names]
    axes = [axis for axis in AXES if any(one.axis == axis for one in timed)]
    columns = min(columns, len(axes))
    rows = math.ceil(len(axes) / columns)
    figure = Figure(figsize=(panel_size[0] * columns, panel_size[1] * rows), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).flatten().tolist()
    for panel in panels[len(axes) :]:
        panel.set_axis_off()
    for axis, panel in zip(axes, panels, strict=False):
        _draw_axis(panel, [one for one in timed if one.axis == axis], names)
        unit = "s for each scene" if axis == "batch" else "s for each event"
        panel.set(xlabel=AXES[axis], ylabel=unit, title=GROWTH_TITLES[axis])
    return figure


def _most_telling(growth: Sequence[Growth]) -> list[str]:
    """Return at most six of ours: what a user calls and the four arithmetics before what is between them."""
    first = (READ, COMPILED, DOUBLE, BALL, MPMATH, MANY)
    names = list(dict.fromkeys(one.contender for one in growth))
    return sorted(names, key=lambda name: first.index(name) if name in first else len(first))[: len(COLOURS)]


def _draw_axis(panel: Any, growth: list[Growth], names: list[str]) -> None:
    """Draw every curve along one axis, dashed on more than one core, each with its name at its end."""
    from matplotlib.ticker import NullFormatter

    labels = []
    for name, cores in sorted({(one.contender, one.cores) for one in growth}):
        curve = [one for one in growth if (one.contender, one.cores) == (name, cores)]
        number = names.index(name)
        style = {"color": COLOURS[number], "marker": MARKERS[number], "ms": 4, "lw": 1}
        at = [one.x for one in curve], [one.seconds_per_event or 0.0 for one in curve]
        panel.plot(*at, "-" if cores == 1 else "--", **style)
        labels.append((at[1][-1], name if cores == 1 else f"{name}, {cores} cores", COLOURS[number]))
    for name, dots in ((BALL, ":"), (COMPILED, "-.")):
        costs = {one.x: one.sine_cosine_seconds for one in growth if one.contender == name and one.sine_cosine_seconds}
        if costs:
            panel.plot(list(costs), list(costs.values()), dots, color="gray", marker=".")
            called = "one sine and cosine" + (", ball" if name == BALL else "")
            labels.append((list(costs.values())[-1], called, "gray"))
    panel.set(xscale="log", yscale="log")
    panel.xaxis.set_minor_formatter(NullFormatter())
    seconds = [one for line in panel.lines for one in line.get_ydata()]
    panel.set_ylim(10.0 ** math.floor(math.log10(min(seconds))), 10.0 ** math.ceil(math.log10(max(seconds))))
    panel.grid(alpha=0.25)
    _label(panel, labels)
