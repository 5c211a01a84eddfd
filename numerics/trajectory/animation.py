"""A film of one trajectory: both bodies on their spring, and their velocities, with the time that passes."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from numerics.errors import MissingTool
from numerics.files import whole_file
from numerics.linear.modes import Mode
from numerics.trajectory.figures import BLUE, GRAY, ORANGE, draw
from numerics.trajectory.solution import Solution

_WRITERS = {".gif": "pillow", ".mp4": "ffmpeg"}
_MOST_FRAMES = 10_000
_TURNS = 9
"""Turns of the spring that is drawn."""


def animate(trajectory: Solution, file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return a matplotlib animation of a trajectory; see Trajectory.animate."""

    def drawn(count: int) -> tuple[Any, Callable[[int], None]]:
        """Draw body 2 on body 1 on its spring, to the scale of the motion; the interface is orange in a slip."""
        from matplotlib import pyplot as plt

        times = np.linspace(0.0, trajectory.arithmetic.to_float(trajectory.end_time), count)
        y, modes = trajectory.floats(trajectory.sol(times)), trajectory.mode_at(times)
        figure, (ax, below) = plt.subplots(2, 1, figsize=(7, 5), height_ratios=(2, 3), layout="constrained")
        draw(trajectory, "velocities", below)
        below.set_title("")
        moment, size = below.axvline(0.0, color="black", lw=1), max(float(np.abs(y[[0, 2]]).max()), 1e-300)
        wall, low, high = -7 * size, y[[0, 2]].min(), y[[0, 2]].max()
        ax.set(xlim=(wall - 0.3 * size, high + 4 * size), ylim=(-0.2, 2.6), yticks=[], xlabel="x1, x2 (m)")
        ax.axvline(wall, color="black", lw=3)
        ax.axhline(0.0, color=GRAY, lw=1)
        ax.vlines((low, high), 0, 2.5, color=GRAY, lw=0.6, ls=":")
        half = np.array([3.0, 1.2]) * size
        bodies = ax.bar((0, 0), (1.0, 0.9), 2 * half, (0.05, 1.15), color=(BLUE, ORANGE), alpha=0.6)
        spring, joint = ax.plot([], [], color="black", lw=1)[0], ax.plot([], [], lw=3)[0]

        def show(k: int) -> None:
            moment.set_xdata([times[k]] * 2)
            ax.set_title(f"t = {times[k]:.3f} s, {modes[k].value}", fontsize="medium")
            left, right = y[[0, 2], k] - half, y[2, k] + half[1]
            for body, place in zip(bodies, left, strict=True):
                body.set_x(place)
            spring.set_data(np.linspace(wall, left[0], 2 * _TURNS), [0.4, 0.7] * _TURNS)
            joint.set_data([left[1], right], [1.1, 1.1])
            joint.set_color(GRAY if modes[k] is Mode.STICK else ORANGE)

        return figure, show

    return film(drawn, file, duration, frames_per_second)


def film(drawn: Callable[[int], Any], file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return the animation of `drawn(count)`, a figure and what shows a frame by its number; write it to `file`.

    Raises MissingTool, OSError, ValueError.
    """
    for name, value in (("duration", duration), ("frames_per_second", frames_per_second)):
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value < float("inf"):
            raise ValueError(f"{name} = {str(value)[:40]!r} must be a finite number > 0")
    count = round(duration * frames_per_second)
    if not 2 <= count <= _MOST_FRAMES:
        shown = f"{duration:g} s with {frames_per_second:g} frames a second are {count} frames"
        raise ValueError(f"{shown}; choose 2 to {_MOST_FRAMES}")
    path = None if file is None else Path(file)
    writer = _WRITERS.get(path.suffix) if path else None
    if path and not writer:
        raise ValueError(f"file = {path.name!r} must end in .gif or .mp4")
    if path and not path.parent.is_dir():
        raise FileNotFoundError(2, "No such folder", str(path.parent))
    try:
        from matplotlib import animation
        from matplotlib import pyplot as plt
    except ImportError:
        raise MissingTool("an animation needs matplotlib; python -m pip install matplotlib") from None
    if writer and not animation.writers.is_available(writer):
        raise MissingTool(f"this film needs {writer}, which is not installed; write a .gif, or install {writer}")
    figure, show = drawn(count)
    show(0)
    figure.canvas.draw()
    figure.set_layout_engine(None)  # the axes stay where they are: to lay them out anew takes as long as a frame
    made = animation.FuncAnimation(figure, show, frames=count, interval=1000 / frames_per_second, blit=False)
    if path:
        with tempfile.TemporaryDirectory() as folder, whole_file(path) as opened:
            kept = Path(folder) / path.name
            figure.canvas.draw_idle = int  # nothing: the writer draws each frame, which matplotlib would do before it
            made.save(kept, writer=writer, fps=frames_per_second)
            opened.write(kept.read_bytes())
        plt.close(figure)
    return made
