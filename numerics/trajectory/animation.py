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
from numerics.trajectory.columns import Floats
from numerics.trajectory.figures import BLUE, GRAY, ORANGE, draw
from numerics.trajectory.solution import Solution

_WRITERS = {".gif": "pillow", ".mp4": "ffmpeg"}
_MOST_FRAMES = 10_000
_TURNS = 9
"""Turns of the spring that is drawn."""


def animate(trajectory: Solution, file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return a matplotlib animation of a trajectory; see Trajectory.animate."""

    def drawn(count: int) -> tuple[Any, Callable[[int], tuple[Any, ...]]]:
        from matplotlib import pyplot as plt

        times = np.linspace(0.0, trajectory.arithmetic.to_float(trajectory.end_time), count)
        y, modes = trajectory.floats(trajectory.sol(times)), trajectory.mode_at(times)
        figure, (above, below) = plt.subplots(2, 1, figsize=(7, 5), height_ratios=(2, 3), layout="constrained")
        draw(trajectory, "velocities", below)
        below.set_title("")
        moment = below.axvline(0.0, color="black", lw=1)
        bodies = _Bodies(above, y)

        def show(k: int) -> tuple[Any, ...]:
            moment.set_xdata([times[k]] * 2)
            above.set_title(f"t = {times[k]:.3f} s, {modes[k].value}", fontsize="medium")
            return moment, *bodies.move(y[0, k], y[2, k], modes[k])

        return figure, show

    return film(drawn, file, duration, frames_per_second)


def film(drawn: Callable[[int], Any], file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return the animation of `drawn(count)`, a figure and what shows a frame by its number; write it to `file`.

    Raises MissingTool, OSError, ValueError.
    """
    path = None if file is None else Path(file)
    count = _frames(duration, frames_per_second)
    writer = None if path is None else _writer(path)
    try:
        from matplotlib import animation
        from matplotlib import pyplot as plt
    except ImportError:
        raise MissingTool("an animation needs matplotlib; python -m pip install matplotlib") from None
    if writer is not None and not animation.writers.is_available(writer):
        raise MissingTool(f"this film needs {writer}, which is not installed; write a .gif, or install {writer}")
    figure, show = drawn(count)
    show(0)
    figure.canvas.draw()
    figure.set_layout_engine(None)  # the axes stay where they are: to lay them out anew takes as long as a frame
    made = animation.FuncAnimation(figure, show, frames=count, interval=1000 / frames_per_second, blit=False)
    if path is not None and writer is not None:
        with tempfile.TemporaryDirectory() as folder, whole_file(path) as opened:
            kept = Path(folder) / path.name
            figure.canvas.draw_idle = lambda: (
                None
            )  # the writer draws each frame; matplotlib would do it once before that
            made.save(kept, writer=writer, fps=frames_per_second)
            opened.write(kept.read_bytes())
        plt.close(figure)
    return made


def _frames(duration: float, frames_per_second: int) -> int:
    """Return the count of frames. Raises ValueError."""
    for name, value in (("duration", duration), ("frames_per_second", frames_per_second)):
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value < float("inf"):
            raise ValueError(f"{name} = {str(value)[:40]!r} must be a finite number > 0")
    count = round(duration * frames_per_second)
    if not 2 <= count <= _MOST_FRAMES:
        raise ValueError(
            f"{duration:g} s with {frames_per_second:g} frames a second are {count} frames; choose 2 to 10000"
        )
    return count


def _writer(path: Path) -> str:
    """Return the name of matplotlib's writer for a file. Raises ValueError for any but .gif and .mp4."""
    if path.suffix not in _WRITERS:
        raise ValueError(f"file = {path.name!r} must end in .gif or .mp4")
    if not path.parent.is_dir():
        raise FileNotFoundError(2, "No such folder", str(path.parent))
    return _WRITERS[path.suffix]


class _Bodies:
    """Body 1 on its spring with body 2 on top, drawn to the scale of the motion; the interface is orange in a slip."""

    def __init__(self, ax: Any, y: Floats) -> None:
        """Draw both at rest in axes as wide as the positions y[0], y[2] (m) need."""
        self.size = size = max(float(np.abs(y[[0, 2]]).max()), 1e-300)
        self.wall, low, high = -7 * size, float(y[[0, 2]].min()), float(y[[0, 2]].max())
        ax.set(xlim=(self.wall - 0.3 * size, high + 4 * size), ylim=(-0.2, 2.6), yticks=[], xlabel="x1, x2 (m)")
        ax.axvline(self.wall, color="black", lw=3)
        ax.axhline(0.0, color=GRAY, lw=1)
        for place in (low, high):
            ax.plot([place, place], [0, 2.5], color=GRAY, lw=0.6, ls=":")
        widths, heights = (6 * size, 2.4 * size), (1.0, 0.9)
        self.first, self.second = ax.bar((0, 0), heights, widths, (0.05, 1.15), color=(BLUE, ORANGE), alpha=0.6)
        self.spring = ax.plot([], [], color="black", lw=1)[0]
        self.joint = ax.plot([], [], lw=3)[0]
        self.zigzag = np.tile([0.4, 0.7], _TURNS)

    def move(self, x1: float, x2: float, mode: Mode) -> tuple[Any, ...]:
        """Put the bodies at x1 and x2 (m)."""
        left = x1 - 3 * self.size
        self.first.set_x(left)
        self.second.set_x(x2 - 1.2 * self.size)
        self.spring.set_data(np.linspace(self.wall, left, 2 * _TURNS), self.zigzag)
        self.joint.set_data([x2 - 1.2 * self.size, x2 + 1.2 * self.size], [1.1, 1.1])
        self.joint.set_color(GRAY if mode is Mode.STICK else ORANGE)
        return self.first, self.second, self.spring, self.joint
