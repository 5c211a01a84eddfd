"""Fig. 3: two itineraries, projected orthogonally on the switching plane S."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from numerics.linear.modes import EventKind, Mode
from numerics.trajectory.trajectory import Trajectory
from paper_checks.drawing.style import MM, MODE_COLOURS, marker_style, panels, segment_samples, solved

PARTS = {
    Mode.SLIP_PLUS: r"in $\Omega_+$ ($v_1>v_2$)",
    Mode.SLIP_MINUS: r"in $\Omega_-$ ($v_1<v_2$)",
    Mode.STICK: "in $S_0$",
}
DASHES = {Mode.SLIP_PLUS: "-", Mode.SLIP_MINUS: (0, (5, 1.5)), Mode.STICK: "-"}
NAMES_B = ("O_1", "A_1", "B_1", "A_2", "C_1", "B_2", "D_1", "A_3", "O_2")
OFFSETS_B = {
    "O_1": (-19, 2), "A_1": (8, 4), "B_1": (-16, -10), "A_2": (-1, 8), "C_1": (7, 2), "B_2": (5, -13), "D_1": (-18, 2),
    "A_3": (3, -14), "O_2": (-5, -17),
}  # fmt: skip


def itinerary_that_merges() -> Figure:
    """Draw a trajectory that enters S0 once and merges with an orbit of E < E_cr."""
    trajectory = solved("itinerary-that-merges")
    return _draw(
        trajectory,
        ("O", "A"),
        {"O": (6, 8), "A": (8, 3)},
        title="(a) enters $S_0$ and merges with an orbit of $E<E_{cr}$",
    )


def itinerary_that_creeps() -> Figure:
    """Draw O1 -> A1 -> B1 -> A2 -> C1 -> B2 -> D1 -> A3 -> O2."""
    return _draw(
        solved("itinerary-that-creeps"),
        NAMES_B,
        OFFSETS_B,
        title="(b) crosses $S$ twice, then sticks and slips towards $E=E_{cr}$",
    )


def _draw(trajectory: Trajectory, names: tuple[str, ...], offsets: dict[str, tuple[int, int]], title: str) -> Figure:
    figure, axes = panels(6.6, 5.0)
    pair = trajectory.scene.pair
    half, rate = MM * float(pair.half_width), float(pair.a2 / pair.mass) ** 0.5
    top = 1.18 * max(_draw_motion(axes, trajectory), half * rate)
    axes.axvspan(-half, half, facecolor="#f2f2f2", edgecolor="#c4c4c4", hatch="////", linewidth=0, zorder=0)
    for side, name in ((1, r"\ell_+"), (-1, r"\ell_-")):
        axes.plot([side * half] * 2, [0, side * top], color="#2e8b3d", lw=2.4, zorder=1.5, solid_capstyle="butt")
        axes.annotate(f"${name}$", (side * half, side * 0.93 * top), xytext=(5 * side, 0), textcoords="offset points",
                      color="#1d6b2b", ha="left" if side > 0 else "right", va="center", fontsize=11)  # fmt: skip
    angle = np.linspace(0, 2 * np.pi, 400)
    axes.plot(half * np.cos(angle), half * rate * np.sin(angle), color="#777777", lw=0.9, ls=(0, (1.5, 1.5)), zorder=1)
    _name_points(axes, trajectory, names, offsets)
    edge = max(abs(value) for value in axes.get_xlim())
    for x, name in ((-(half + edge) / 2, "$S_-$"), (0, "$S_0$"), ((half + edge) / 2, "$S_+$")):
        axes.text(x, -0.93 * top, name, ha="center", va="center", fontsize=11, color="#555555")
    axes.set(xlim=(-edge, edge), ylim=(-top, top), xlabel="$x_1$ (mm)", ylabel=r"$(v_1+v_2)/2$ (mm/s)", title=title)
    figure.legend(handles=_legend(trajectory), loc="outside lower center", ncols=4)
    return figure


def _draw_motion(axes: Any, trajectory: Trajectory) -> float:
    """Draw the parts in the paper's colours with an arrow each, and return the largest |(v1 + v2)/2|, mm/s."""
    highest = 0.0
    for mode, _, y in segment_samples(trajectory, 200):
        x, v = MM * y[0], MM * (y[1] + y[3]) / 2
        axes.plot(x, v, color=MODE_COLOURS[mode], ls=DASHES[mode], lw=1.6, zorder=3)
        middle = len(x) // 2
        axes.annotate("", (x[middle + 2], v[middle + 2]), (x[middle - 2], v[middle - 2]), zorder=4,
                      arrowprops={"arrowstyle": "-|>", "color": MODE_COLOURS[mode], "lw": 1.2, "mutation_scale": 13})  # fmt: skip
        highest = max(highest, float(np.max(np.abs(v))))
    return highest


def _name_points(
    axes: Any, trajectory: Trajectory, names: tuple[str, ...], offsets: dict[str, tuple[int, int]]
) -> None:
    """Mark and name the start, the events, and the end where it has a name."""
    first, last = trajectory.y[:, 0], trajectory.y[:, -1]
    states = [first, *(np.array(event.y) for event in trajectory.events), last]
    kinds = [None, *trajectory.event_kinds, None]
    for name, kind, y in zip(names, kinds, states, strict=False):
        at = MM * y[0], MM * (y[1] + y[3]) / 2
        look = marker_style(kind, 7) if kind else {"marker": "s", "markersize": 6, "color": "black", "zorder": 5}
        axes.plot(*at, linestyle="none", **look)
        axes.annotate(f"${name}$", at, xytext=offsets[name], textcoords="offset points", fontsize=11, zorder=6)


def _legend(trajectory: Trajectory) -> list[Any]:
    parts = [
        Line2D([], [], color=MODE_COLOURS[mode], ls=DASHES[mode], lw=1.6, label=PARTS[mode])
        for mode in PARTS
        if mode in trajectory.modes
    ]
    kinds = [kind for kind in EventKind if kind in trajectory.event_kinds]
    events = [Line2D([], [], linestyle="none", label=f"{kind.value}", **marker_style(kind, 7)) for kind in kinds]
    return [
        *parts,
        *events,
        Line2D([], [], color="#2e8b3d", lw=2.4, label="exit rays"),
        Line2D([], [], color="#777777", ls=(0, (1.5, 1.5)), lw=0.9, label="$E=E_{cr}$ on $S$"),
        Patch(facecolor="#f2f2f2", edgecolor="#c4c4c4", hatch="////", linewidth=0, label="sliding region $S_0$"),
    ]
