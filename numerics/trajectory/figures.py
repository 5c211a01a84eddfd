"""Pictures of one trajectory, for a quick look: every kind in one axes, stick phases shaded. Drawn in binary64."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.errors import MissingTool
from numerics.motion.modes import EventKind, Mode

BLUE, ORANGE, GREEN, GRAY = "#0072B2", "#D55E00", "#009E73", "#999999"
"""Colours that are told apart without red and green."""
_MARKERS = {EventKind.ENTRY: ("o", "entry"), EventKind.EXIT: ("^", "exit"), EventKind.CROSSING: ("x", "crossing")}
_MOST_MARKED = 200
"""Events beyond this number would hide the curve: then none is marked."""
_MOST_SHADED = 1000
"""Stick phases beyond this number are narrower than a pixel: then none is shaded."""
_RESOLVED = 100
"""So many segments at the beginning and at the end are always drawn as curves."""
_PER_RADIAN, _FEWEST, _LEAST, _MOST = 24, 8, 60, 10_000
"""Points for each radian of Omega t; fewer than the second are no curve; a segment gets at least the third if it turns
so far; longer ones share the last."""


class Curve(NamedTuple):
    """A trajectory for drawing, n points: its ends and, in every segment, both ends and points between them."""

    t: NDArray[np.float64]
    """Time, s."""
    y: NDArray[np.float64]
    """x1, v1, x2, v2, shape (4, n), m and m/s."""
    w: NDArray[np.float64]
    """E/E_cr - 1."""
    lost: NDArray[np.float64]
    """What friction and viscosity have taken so far, shape (2, n), J."""
    segment: NDArray[np.int64]
    """Which segment each point belongs to."""
    resolved: NDArray[np.bool_]
    """Whether the points of this segment are so many that lines between them are its curve."""


def sampled(trajectory: Any) -> Curve:
    """Return points that resolve every segment, however short; of thousands of segments the first and the last."""
    number = trajectory.arithmetic.to_float
    with trajectory.arithmetic.context():
        length, rate, unit = (number(one) for one in trajectory.units)
        radians = np.array([number(segment.length) for segment in trajectory.segments])
        parts = _parts(radians)
        rows, taken = [], np.zeros(2)
        for segment, long, count in zip(trajectory.segments, radians, parts, strict=True):
            start, lost = number(segment.start), np.zeros(2)
            for part in range(count + 1):
                tau = segment.length * part / int(count)
                state = [number(one) for one in segment.state(tau)]
                lost = np.array([number(one) for one in segment.losses(tau)])
                rows.append([start + long * part / count, *state, *(taken + lost)])
            taken = taken + lost
    tau_, X, V1, V2, Z, w, friction, viscous = np.array(rows, dtype=float).reshape(-1, 8).T
    speed, at = length * rate, np.repeat(np.arange(len(parts)), parts + 1)
    y = np.stack([X * length, V1 * speed, (X - Z) * length, V2 * speed])
    return Curve(tau_ / rate, y, w, np.stack([friction, viscous]) * unit, at, (parts >= _FEWEST * radians)[at])


def _parts(radians: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return into how many parts each segment is divided, from the radians that it turns through."""
    share = _MOST * radians / max(radians.sum(), 1.0)
    parts = 6 + np.minimum(_PER_RADIAN * radians, np.maximum(share, _LEAST)).astype(int)
    if len(parts) > 10 * _RESOLVED:
        parts[_RESOLVED:-_RESOLVED] = 2  # speeds are largest about the middle of a stick phase
    return parts


def draw(trajectory: Any, kind: str, ax: Any = None, curve: Curve | None = None) -> Any:
    """Draw into matplotlib axes, new ones if none are given, and return them.

    Kinds: "velocities" and "positions" of both bodies against time; "phase", x1 against v1, with S0 shaded; "excess",
    |E/E_cr - 1| on a logarithmic axis; "energy", what is left of it and who took the rest. Raises ValueError for any
    other kind, MissingTool. `curve` saves sampling the trajectory for every picture of it.
    """
    if kind not in _KINDS:
        raise ValueError(f"kind = {kind!r} is not one of {', '.join(_KINDS)}")
    if ax is None:
        ax = _new_axes()
    curve = curve or sampled(trajectory)
    title, drawn = _KINDS[kind]
    ax.set_title(title, fontsize="medium")
    drawn(trajectory, curve, ax)
    if kind != "phase":
        _shade_stick(trajectory, curve, ax)
        ax.set_xlabel("t (s)")
        ax.set_xlim(curve.t[0], curve.t[-1])
    if ax.get_legend_handles_labels()[0]:
        few = len(trajectory.events) <= _MOST_MARKED
        if not few:  # dashes of so long a line take minutes to draw, and so does the best place for the legend
            for line in ax.lines:
                line.set_linestyle("none" if line.get_marker() == "," else "-")
        ax.legend(loc="best" if few else "upper right", fontsize="small", framealpha=0.9)
    return ax


def _new_axes() -> Any:
    try:
        from matplotlib import pyplot as plt
    except ImportError:
        raise MissingTool("a plot needs matplotlib, which is not installed") from None
    return plt.subplots(layout="constrained")[1]


def _shade_stick(trajectory: Any, curve: Curve, ax: Any) -> None:
    """Shade the times at which the bodies stick, over the whole height of the axes."""
    stick = np.array([mode is Mode.STICK for mode in trajectory.modes])[curve.segment]
    if stick.any() and trajectory.modes.count(Mode.STICK) <= _MOST_SHADED:
        ax.fill_between(
            curve.t, 0, 1, where=stick, transform=ax.get_xaxis_transform(), color=GRAY, alpha=0.25, lw=0, label="stick"
        )


def _mark_events(trajectory: Any, ax: Any, across: int | None, up: int) -> None:
    """Mark the events at row `up` of y, against row `across` of it, or against time."""
    number = np.vectorize(trajectory.arithmetic.to_float, otypes=[float])
    if len(trajectory.events) > _MOST_MARKED:
        return
    for (marker, label), t, y in zip(_MARKERS.values(), trajectory.t_events, trajectory.y_events, strict=True):
        if len(t):
            x = number(t) if across is None else number(y[:, across])
            ax.plot(x, number(y[:, up]), marker, color="black", ms=4, mfc="none", label=label, ls="none")


def _velocities(trajectory: Any, curve: Curve, ax: Any) -> None:
    ax.plot(curve.t, curve.y[1], color=BLUE, lw=1.2, label="$v_1$")
    ax.plot(curve.t, curve.y[3], color=ORANGE, lw=1.2, ls="--", label="$v_2$")
    _mark_events(trajectory, ax, None, 1)
    ax.set_ylabel("velocity (m/s)")


def _positions(trajectory: Any, curve: Curve, ax: Any) -> None:
    ax.plot(curve.t, curve.y[0], color=BLUE, lw=1.2, label="$x_1$")
    ax.plot(curve.t, curve.y[2], color=ORANGE, lw=1.2, ls="--", label="$x_2$")
    half_width = float(trajectory.scene.pair.half_width)
    for side in (-half_width, half_width) if trajectory.scene.pair.a1 == 0 else ():
        ax.axhline(side, color=GRAY, lw=0.8, ls=":", label="edges of $S_0$" if side > 0 else None)
    ax.set_ylabel("position (m)")


def _phase(trajectory: Any, curve: Curve, ax: Any) -> None:
    """Draw x1 against v1: on S, where v1 = v2, with a full line, in slip with a thin one."""
    pair, stick = trajectory.scene.pair, np.array([mode is Mode.STICK for mode in trajectory.modes])[curve.segment]
    for kept, color, width, dashes, label in (
        (~stick, ORANGE, 0.8, "--", "slip"),
        (stick, BLUE, 2.0, "-", "stick, on $S$"),
    ):
        x, v = (np.where(kept & curve.resolved, row, np.nan) for row in curve.y[:2])
        if np.isfinite(x).any():
            ax.plot(x, v, color=color, lw=width, ls=dashes, label=label)
        sparse = kept & ~curve.resolved
        if sparse.any():  # lines between these points would not be the curve
            ax.plot(*curve.y[:2, sparse], ",", color=color)
    _mark_events(trajectory, ax, 0, 1)
    low, high = ax.get_ylim()
    half_width, lean = float(pair.half_width), float(pair.a1 / pair.a2)
    v = np.array([low, high])
    ax.fill_betweenx(v, -half_width - lean * v, half_width - lean * v, color=GRAY, alpha=0.25, lw=0, label="$S_0$")
    ax.set_ylim(low, high)
    if pair.a1 == 0:  # the critical orbit touches both edges
        angle = np.linspace(0, 2 * np.pi, 400)
        speed = half_width * float(pair.a2 / pair.mass) ** 0.5
        ax.plot(half_width * np.cos(angle), speed * np.sin(angle), color="black", lw=0.8, ls=":", label="$E = E_{cr}$")
    ax.locator_params(axis="x", nbins=6)
    ax.set(xlabel="$x_1$ (m)", ylabel="$v_1$ (m/s)")


def _excess(_: Any, curve: Curve, ax: Any) -> None:
    """Draw what the energy has above E_cr, or lacks below it."""
    for sign, how in ((1, {"color": BLUE, "label": r"$E/E_{cr} - 1$"}), (-1, {"color": ORANGE, "ls": "--"})):
        part = np.where(sign * curve.w > 0, sign * curve.w, np.nan)
        if np.isfinite(part).any():
            ax.plot(curve.t, part, lw=1.2, **({"label": r"$1 - E/E_{cr}$"} | how))
    ax.set_yscale("log")
    ax.set_ylabel("distance from $E_{cr}$, relative")


def _energy(trajectory: Any, curve: Curve, ax: Any) -> None:
    """Draw the ledger: what is left, what friction took and what viscosity took, on top of each other."""
    left = float(trajectory.scene.pair.critical_energy) * (1 + curve.w)
    parts = [("energy left", left, BLUE, None), ("lost to friction", curve.lost[0], ORANGE, "//")]
    if trajectory.scene.pair.a1 > 0:
        parts.append(("lost to viscosity", curve.lost[1], GREEN, ".."))
    below = np.zeros_like(left)
    for label, part, color, hatch in parts:
        ax.fill_between(curve.t, below, below + part, color=color, alpha=0.6, lw=0, label=label, hatch=hatch)
        below = below + part
    ax.axhline(float(trajectory.scene.pair.critical_energy), color="black", lw=0.8, ls=":", label="$E_{cr}$")
    ax.set_ylabel("energy (J)")
    ax.set_ylim(0, None)


_KINDS = {
    "velocities": ("Velocities of both bodies", _velocities),
    "positions": ("Positions of both bodies", _positions),
    "phase": ("Phase portrait of body 1", _phase),
    "excess": ("Distance from the critical energy", _excess),
    "energy": ("Where the energy went", _energy),
}
