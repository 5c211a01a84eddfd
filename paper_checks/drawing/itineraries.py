"""Fig. 3: two itineraries, projected orthogonally on the switching plane S."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from numerics.linear.modes import Mode
from numerics.trajectory.trajectory import Trajectory
from paper_checks.drawing.style import MM, MODE_COLOURS, SLIDING, marker_style, panels, segment_samples, solved

PARTS = {
    Mode.SLIP_PLUS: (r"in $\Omega_+$ ($v_1>v_2$)", "-"),
    Mode.SLIP_MINUS: (r"in $\Omega_-$ ($v_1<v_2$)", "--"),
    Mode.STICK: ("in $S_0$", "-"),
}


def itinerary_that_merges() -> Figure:
    """Draw a trajectory that enters S0 once and merges with an orbit of E < E_cr."""
    return _draw(
        solved("itinerary-that-merges", Fraction("1.5")),
        "O A",
        "(a) enters $S_0$ and merges with an orbit of $E<E_{cr}$",
    )


def itinerary_that_creeps() -> Figure:
    """Draw O1 -> A1 -> B1 -> A2 -> C1 -> B2 -> D1 -> A3 -> O2."""
    title = "(b) crosses $S$ twice, then sticks and slips towards $E=E_{cr}$"
    return _draw(solved("itinerary-that-creeps", Fraction("1.1")), "O_1 A_1 B_1 A_2 C_1 B_2 D_1 A_3 O_2", title)


def _draw(trajectory: Trajectory, names: str, title: str) -> Figure:
    figure, axes = panels(6.6, 5.0)
    pair = trajectory.scene.pair
    half, rate = MM * float(pair.half_width), float(pair.a2 / pair.mass) ** 0.5
    for mode, _, y in segment_samples(trajectory, 200):
        label, dashes = PARTS[mode]
        x, v = _projected(y)
        axes.plot(x, v, color=MODE_COLOURS[mode], ls=dashes, lw=1.6, zorder=3, label=label)
        look = {"arrowstyle": "-|>", "color": MODE_COLOURS[mode], "mutation_scale": 13}
        axes.annotate("", (x[102], v[102]), (x[98], v[98]), arrowprops=look)
    _name_points(axes, trajectory, names)
    angle = np.linspace(0, 2 * np.pi, 400)
    circle = half * np.cos(angle), half * rate * np.sin(angle)
    axes.plot(*circle, color="#777777", lw=0.9, ls=":", zorder=1, label="$E=E_{cr}$ on $S$")
    edge, top = (1.05 * max(map(abs, limits)) for limits in (axes.get_xlim(), axes.get_ylim()))
    for side, name, colour in ((1, r"$\ell_+$", "#c8641e"), (-1, r"$\ell_-$", "#2e8b3d")):
        axes.plot([side * half] * 2, [0, side * top], color=colour, lw=2.4, zorder=1.5, label=name)
    axes.axvspan(-half, half, color=SLIDING, lw=0, zorder=0, label="sliding region $S_0$")
    axes.set(xlim=(-edge, edge), ylim=(-top, top), xlabel="$x_1$ (mm)", ylabel=r"$(v_1+v_2)/2$ (mm/s)", title=title)
    handles, labels = axes.get_legend_handles_labels()
    shown = dict(zip(labels, handles, strict=True))
    figure.legend(shown.values(), shown.keys(), loc="outside lower center", ncols=4)
    return figure


def _name_points(axes: Axes, trajectory: Trajectory, names: str) -> None:
    """Mark and name the start, the events in their order, and the end where it has a name."""
    states = [trajectory.y[:, 0], *(event.y for event in trajectory.events), trajectory.y[:, -1]]
    kinds = [None, *trajectory.event_kinds, None]
    for name, kind, y in zip(names.split(), kinds, states, strict=False):
        look = marker_style(kind) if kind else {"marker": "s", "color": "black", "zorder": 5}
        axes.plot(*_projected(y), linestyle="none", label=kind.value if kind else None, **look)
        white = {"fc": "white", "ec": "none", "alpha": 0.75, "pad": 0.5}
        axes.annotate(f"${name}$", _projected(y), xytext=(8, 6), textcoords="offset points", bbox=white, zorder=6)


def _projected(y: Any) -> tuple[Any, Any]:
    return MM * y[0], MM * (y[1] + y[3]) / 2
