"""Pictures of one trajectory, for a quick look: a kind in one axes, many in one figure, a film. Drawn in binary64."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Collection, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from numerics.errors import MissingTool
from numerics.exits import tool
from numerics.files import path_of, whole_file
from numerics.linear.modes import EventKind, Mode
from numerics.meter import meter
from numerics.scene import Law
from numerics.scene.decimals import positive, require_one_of
from numerics.trajectory.curve import SampledCurve, sampled
from numerics.trajectory.export import word

BLUE, ORANGE, GREEN, PURPLE, GRAY = "#0072B2", "#D55E00", "#009E73", "#7B4FA3", "#999999"
"""Body 1, body 2, friction, the force, stick; told apart without red and green. What is of no body is black."""
FIRST = {"color": BLUE, "lw": 1.2, "label": "body 1"}
SECOND = {"color": ORANGE, "lw": 1.2, "ls": "--", "label": "body 2"}
_MARKERS = {EventKind.ENTRY: ("o", "entry"), EventKind.EXIT: ("^", "exit"), EventKind.CROSSING: ("x", "crossing")}
_MOST_MARKED = 200
"""Events beyond this number would hide the curve: then none is marked."""
_MOST_POINTS = 8_000
"""Curves of more points are pixels in a vector graphic too, which would take megabytes."""
_MOST_SHADED = 1000
"""Stick phases beyond this number are narrower than a pixel: then none is shaded."""

FREE = ("velocities", "positions", "load", "phase", "excess", "energy")
FORCED = ("force", "load", "velocities", "positions", "phase", "energy")
_CRITICAL = {"color": "black", "lw": 0.8, "ls": ":", "label": "$E = E_{cr}$"}
_ENOUGH = {"color": GREEN, "alpha": 0.2, "lw": 0, "label": "friction is enough ($S_0$)"}
_NEEDED = {"color": GREEN, "lw": 1.2, "label": "sticking needs this friction"}
_MOST_FRAMES = 10_000
Drawn = tuple[Any, Callable[[int], None]]
"""A figure, and what moves its artists to the frame of a number."""


def draw(trajectory: Any, kind: str | None, ax: Any = None, curve: Any = None) -> Any:
    """Draw into matplotlib axes, new ones if none are given, and return them.

    Kinds: "velocities" and "positions" of both bodies against time; "load", the friction that sticking needs, and what
    the interface can give; "force", u(t); "friction", what it is against v1 - v2; "phase", x1 against v1, with S0
    shaded; "relative", x1 against v1 - v2; "excess", |E/E_cr - 1| on a logarithmic axis; "energy", what is left of it
    and who took the rest. Raises ValueError for any other kind, MissingTool. `curve` saves sampling the trajectory for
    every picture of it.
    """
    kinds = trajectory.pictures.KINDS
    kind, is_new = kind or next(iter(kinds)), ax is None
    ax, curve = axes_for(kind, kinds, ax), curve or trajectory.pictures.sampled(trajectory)
    title, label, drawn = kinds[kind]
    ax.set_title(title, fontsize="medium")
    ax.set_ylabel(label)
    drawn(trajectory, curve, ax)
    if not ax.get_xlabel():
        _against_time(trajectory, curve, ax)
    if len(curve.t) > _MOST_POINTS:
        for one in (*ax.lines, *ax.collections):
            one.set_rasterized(True)
    for line in ax.lines:
        if len(line.get_xdata()) > _MOST_POINTS:  # dashes of so long a line take minutes to draw
            line.set_linestyle("-")
    return explained(ax, is_new=is_new)


def axes_for(kind: Any, kinds: Collection[str], ax: Any, name: str = "kind") -> Any:
    """Return axes to draw one of some kinds into, or new ones. Raises ValueError, TypeError, MissingTool."""
    require_one_of(name, kind, kinds)
    if ax is not None and not hasattr(ax, "set_title"):
        raise TypeError(f"ax = {str(ax)[:40]!r} must be matplotlib axes; leave it out for new ones")
    plt = tool("matplotlib.pyplot")
    return plt.subplots(layout="constrained")[1] if ax is None else ax


def _against_time(trajectory: Any, curve: SampledCurve, ax: Any) -> None:
    """Label the time axis, and shade the times at which the bodies stick over the whole height of the axes."""
    ax.set_xlabel("t (s)")
    ax.set_xlim(curve.t[0], curve.t[-1])
    if 0 < trajectory.modes.count(Mode.STICK) <= _MOST_SHADED:
        across = ax.get_xaxis_transform()
        ax.fill_between(curve.t, 0, 1, where=curve.stick, transform=across, color=GRAY, alpha=0.25, lw=0, label="stick")


def _mark_events(trajectory: Any, ax: Any, across: int, up: int) -> None:
    """Mark the events at row `up` of t, x1, v1, x2, v2, against row `across` of them."""
    if len(trajectory.events) > _MOST_MARKED:
        return
    for (marker, label), t, y in zip(_MARKERS.values(), trajectory.t_events, trajectory.y_events, strict=True):
        if len(t):
            rows = trajectory.floats([t, *y.T])
            ax.plot(rows[across], rows[up], marker, color="black", ms=4, mfc="none", label=label, ls="none")


def _bodies(row: int, trajectory: Any, curve: SampledCurve, ax: Any) -> None:
    """Draw positions (row 0) or velocities (row 1) of both."""
    ax.plot(curve.t, curve.y[row], **FIRST)
    ax.plot(curve.t, curve.y[row + 2], **SECOND)
    if row:
        _mark_events(trajectory, ax, 0, 2)


def _load(_: Any, curve: SampledCurve, ax: Any) -> None:
    ax.fill_between(curve.t, -curve.b, curve.b, **_ENOUGH)
    ax.plot(curve.t, curve.load, **_NEEDED)


def _force(_: Any, curve: SampledCurve, ax: Any) -> None:
    ax.plot(curve.t, curve.u, color=PURPLE, lw=1.2)


def _friction(_: Any, curve: SampledCurve, ax: Any) -> None:
    """Draw friction against the relative speed: in stick it is what sticking needs."""
    w = curve.y[1] - curve.y[3], "$v_1 - v_2$ (m/s)"
    _plane(curve, ax, w, curve.friction)


def _phase(trajectory: Any, curve: SampledCurve, ax: Any) -> None:
    """Draw x1 against v1, and S0 where it stays."""
    _plane(curve, ax, (curve.y[0], "$x_1$ (m)"), curve.y[1], **FIRST)
    _mark_events(trajectory, ax, 1, 2)
    if not trajectory.scene.is_forced:
        _sliding_region(trajectory.scene.pair, ax)


def _relative(_: Any, curve: SampledCurve, ax: Any) -> None:
    """Draw x1 against v1 - v2: on S that is 0, and a cycle of stick and slip closes."""
    _plane(curve, ax, (curve.y[0], "$x_1$ (m)"), curve.y[1] - curve.y[3])


def _plane(curve: SampledCurve, ax: Any, across: tuple[Any, str], up: Any, **style: Any) -> None:
    """Draw one quantity against another, named."""
    (x, name), sparse = across, ~curve.resolved  # lines between sparse points would not be the curve
    line = np.where(sparse, np.nan, (x, up))
    draw_path(ax, line[0], line[1], curve.stick, **style)
    ax.plot(x[sparse], up[sparse], ",", color=style.get("color", "black"))
    ax.locator_params(axis="x", nbins=6)
    ax.set_xlabel(name)


def draw_path(ax: Any, x: Any, y: Any, stick: Any, **style: Any) -> None:
    """Draw a curve from its marked start; where the bodies stick a band lies below it."""
    if stick.any():
        band = {"color": GRAY, "alpha": 0.4, "lw": 6, "solid_capstyle": "butt", "label": "stick"}
        ax.plot(*np.where(stick, (x, y), np.nan), **band)
    ax.plot(x, y, **{"color": "black", "lw": 1.2} | style)
    ax.plot(x[:1], y[:1], "s", color="black", ms=5, label="start")


def _sliding_region(pair: Any, ax: Any) -> None:
    """Shade S0 as far as the trajectory goes, and draw the critical orbit, which touches both edges."""
    half_width, lean = float(pair.half_width), float(pair.a1 / pair.a2)
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    v = np.array([low, high])
    ax.fill_betweenx(v, -half_width - lean * v, half_width - lean * v, **_ENOUGH)
    ax.set(xlim=(min(left, -1.1 * half_width), max(right, 1.1 * half_width)), ylim=(low, high))
    if pair.a1 == 0:
        angle = np.linspace(0, 2 * np.pi, 400)
        speed = half_width * float(pair.a2 / pair.mass) ** 0.5
        ax.plot(half_width * np.cos(angle), speed * np.sin(angle), **_CRITICAL)


def _excess(trajectory: Any, curve: SampledCurve, ax: Any) -> None:
    """Draw what the energy has above E_cr, or lacks, if it is more than its error. Raises InvalidScene without E_cr."""
    _ = trajectory.scene.pair.half_width, trajectory.scene.pair.critical_energy
    least = trajectory.accuracy.energy_excess if trajectory.bounded else 0.0
    for part, label, dashes in ((curve.w, r"$E/E_{cr} - 1$", "-"), (-curve.w, r"$1 - E/E_{cr}$", "--")):
        if (part > least).any():
            ax.semilogy(curve.t, np.where(part > least, part, np.nan), lw=1.2, label=label, color="black", ls=dashes)


def _energy(trajectory: Any, curve: SampledCurve, ax: Any) -> None:
    """Draw the ledger: what acts has put in, what is left of it, and what friction and viscosity took."""
    scene, (friction, viscous) = trajectory.scene, curve.lost
    work = curve.energy - curve.energy[0] + friction + viscous
    if not scene.is_forced:
        ax.axhline(float(scene.pair.critical_energy), **_CRITICAL)
    for is_there, label, part, color, dashes in (
        (scene.is_forced, "work of what acts", work, PURPLE, "-"),
        (True, "energy of the pair", curve.energy, "black", "-"),
        (True, "lost to friction", friction, GREEN, "--"),
        (scene.pair.a1 > 0, "lost to viscosity", viscous, "black", ":"),
    ):
        if is_there:
            ax.plot(curve.t, part, color=color, lw=1.2, ls=dashes, label=label)


KINDS: dict[str, tuple[str, str, Callable[..., None]]] = {
    "velocities": ("Velocities of both bodies", "$v_1$, $v_2$ (m/s)", partial(_bodies, 1)),
    "positions": ("Positions of both bodies", "$x_1$, $x_2$ (m)", partial(_bodies, 0)),
    "load": ("The friction that sticking needs, and can get", "force on body 2 (N)", _load),
    "force": ("Force on body 1", "u (N)", _force),
    "phase": ("Phase portrait of body 1", "$v_1$ (m/s)", _phase),
    "relative": ("Phase plane of the slip", "$v_1 - v_2$ (m/s)", _relative),
    "excess": ("Distance from the critical energy", r"$|E/E_{cr} - 1|$", _excess),
    "energy": ("Where the energy went", "energy (J)", _energy),
    "friction": ("Friction against the relative speed", "friction on body 2 (N)", _friction),
}
"""Title, label of what is drawn upwards, and what draws it."""


def overview(trajectory: Any) -> Any:
    """Return a matplotlib figure: velocities, positions, load, phase portrait and energy, titled by the scene.

    Under a force it shows u(t) too.
    """
    scene, curve, law = trajectory.scene, sampled(trajectory), ""
    kinds = FORCED if scene.is_forced else FREE
    if scene.friction.weakening:
        kinds = ("friction", "relative", *FORCED[1:4], "energy")
    elif kinds is FORCED and not curve.u.any():
        kinds = ("relative", *FORCED[1:])
    if scene.law is Law.THREE_VALUED_SGN:
        law = "; sgn(0) = 0 read literally"
    title = f"{scene.pair} from {scene.initial}{law}\n{course(trajectory)}"
    return together([partial(draw, trajectory, kind, curve=curve) for kind in kinds], (11, 11), title)


def course(trajectory: Any) -> str:
    """Return how many events a trajectory has in what time, and how it ended."""
    count, end = len(trajectory.events), trajectory.arithmetic.to_float(trajectory.end_time)
    return f"{count} event{'' if count == 1 else 's'} in {end:g} s; {trajectory.message}"


def together(drawings: Sequence[Callable[..., Any]], size: tuple[float, float], title: str) -> Any:
    """Return a figure (inches) of what is drawn into axes, two in a row; marks are explained once, below all."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="constrained")
    for drawn, ax in zip(drawings, figure.subplots(len(drawings) // 2, 2).flat, strict=True):
        drawn(ax=ax)
    explain_below(figure)
    figure.suptitle(title, fontsize="medium")
    return figure


def marks_of(ax: Any) -> dict[str, Any]:
    """Return what a legend of axes shows, by its labels, each once."""
    return {name: handle for handle, name in zip(*ax.get_legend_handles_labels(), strict=True)}


def explained(ax: Any, *, is_new: bool) -> Any:
    """Return axes with a legend: within them, or below new ones, where it hides nothing."""
    if is_new:
        explain_below(ax.figure)
    elif marks := marks_of(ax):
        ax.legend(marks.values(), marks, fontsize="small", framealpha=0.9)
    return ax


def explain_below(figure: Any) -> None:
    """Move the legends of all axes to one below them, in which each mark is once."""
    common: dict[str, Any] = {}
    for ax in figure.axes:
        common |= marks_of(ax)
        if ax.get_legend():
            ax.get_legend().remove()
    across = int(figure.get_figwidth() // 2)  # of about two inches each
    figure.legend(common.values(), common, loc="outside lower center", ncols=across, fontsize="small")


def filmed(trajectory: Any, times: Any, y: Any) -> Drawn:
    """Draw body 2 on body 1, to the scale of the motion, above the velocities."""
    from matplotlib import pyplot as plt

    figure, (ax, below) = plt.subplots(2, 1, figsize=(7, 5), height_ratios=(2, 3), layout="constrained")
    draw(trajectory, "velocities", below)
    below.set_title("")
    explain_below(figure)
    moment, size = below.axvline(0.0, color="black", lw=1), max(float(np.abs(y[[0, 2]]).max()), 1e-300)
    half = np.array([3.0, 1.2]) * size
    xlim = y[[0, 2]].min() - 4 * size, y[[0, 2]].max() + 4 * size
    ax.set(xlim=xlim, ylim=(0, 2.6), yticks=[], xlabel="x1, x2 (m)")
    bodies = ax.bar((0, 0), (1.0, 0.9), 2 * half, (0.05, 1.15), color=(BLUE, ORANGE), alpha=0.6)

    def show(k: int) -> None:
        moment.set_xdata([times[k]] * 2)
        for body, place in zip(bodies, y[[0, 2], k] - half, strict=True):
            body.set_x(place)

    return figure, show


def film(trajectory: Any, file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return the animation of a trajectory, and write it to `file`; time and mode stand above the first axes.

    Raises MissingTool, OSError, ValueError.
    """
    count = round(positive(duration, "duration") * positive(frames_per_second, "frames_per_second"))
    if not 2 <= count <= _MOST_FRAMES:
        shown = f"{duration:g} s with {frames_per_second:g} frames a second are {count} frames"
        raise ValueError(f"{shown}; choose 2 to {_MOST_FRAMES}")
    path = None if file is None else path_of(file)
    if path and path.suffix not in {".gif", ".mp4"}:
        raise ValueError(f"file = {path.name!r} must end in .gif or .mp4")
    plt, animation = (tool(f"matplotlib.{name}") for name in ("pyplot", "animation"))
    if path and path.suffix == ".mp4" and not animation.writers.is_available("ffmpeg"):
        raise MissingTool("an .mp4 file needs ffmpeg, which is not installed; write a .gif, or install ffmpeg")
    with meter("drawing") as line:
        times = np.linspace(0.0, trajectory.arithmetic.to_float(trajectory.end_time), count)
        figure, show = trajectory.pictures.filmed(trajectory, times, trajectory.floats(trajectory.sol(times)))
        modes = trajectory.mode_at(times)

        def frame(k: int) -> None:
            show(k)
            figure.axes[0].set_title(f"t = {times[k]:.3f} s, {word(modes[k])}", fontsize="medium")

        frame(0)
        figure.canvas.draw()
        figure.set_layout_engine(None)  # the axes stay where they are: to lay them out anew takes as long as a frame
        made = animation.FuncAnimation(figure, frame, frames=count, interval=1000 / frames_per_second, blit=False)
        if path:
            with tempfile.TemporaryDirectory() as folder, whole_file(path) as opened:
                kept, writer = Path(folder) / path.name, "pillow" if path.suffix == ".gif" else "ffmpeg"
                figure.canvas.draw_idle = int  # nothing: the writer draws each frame, matplotlib would before it
                made.save(kept, writer=writer, fps=frames_per_second, progress_callback=line)
                opened.write(kept.read_bytes())
            plt.close(figure)
    return made
