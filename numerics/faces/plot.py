"""A quick look at one trajectory: both velocities and the energy against time, events marked."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from numerics.motion.modes import EventKind
from numerics.trajectory.export import whole_file
from numerics.trajectory.trajectory import Trajectory

MARKERS = {EventKind.ENTRY: ("o", "entry"), EventKind.EXIT: ("^", "exit"), EventKind.CROSSING: ("x", "crossing")}
FORMATS = (".svg", ".pdf", ".png")


def sample_times(trajectory: Trajectory, points: int = 2000) -> Any:
    """Return increasing times (s) that resolve every segment and contain the events; for drawing only."""
    to_float = np.vectorize(trajectory.arithmetic.to_float, otypes=[float])
    events = to_float(trajectory.t)
    return np.union1d(np.linspace(events[0], events[-1], points), events)


def draw(trajectory: Trajectory) -> Any:
    """Return a matplotlib figure: v1 and v2 (m/s), and E - E_cr (J), against t (s)."""
    from matplotlib.figure import Figure

    to_float = np.vectorize(trajectory.arithmetic.to_float, otypes=[float])
    times = sample_times(trajectory)
    states = [trajectory.reduced(t) for t in np.minimum(times, to_float(trajectory.t)[-1])]
    with trajectory.arithmetic.context():
        y = to_float(np.array([trajectory.frame.si_state(state) for state in states]).T)
        # w times E_cr, since the difference of both energies is rounding close to the critical orbit
        excess = to_float(np.array([trajectory.frame.critical_energy * state.w for state in states]))
    figure = Figure(figsize=(8, 5.5), layout="constrained")
    velocity, energy = figure.subplots(2, 1, sharex=True)
    velocity.plot(times, y[1], label="$v_1$", lw=1.2)
    velocity.plot(times, y[3], label="$v_2$", lw=1.2)
    for kind, (marker, label) in MARKERS.items():
        index = list(EventKind).index(kind)
        t, at = to_float(trajectory.t_events[index]), trajectory.y_events[index]
        if len(t):
            velocity.plot(t, to_float(at[:, 3]), marker, color="black", ms=4, mfc="none", label=label)
    velocity.set_ylabel("velocity (m/s)")
    velocity.legend(loc="upper right", ncols=5, fontsize="small")
    energy.plot(times, excess, color="tab:green", lw=1.2)
    energy.axhline(0, color="gray", lw=0.8)
    energy.set(xlabel="t (s)", ylabel="$E - E_{cr}$ (J)")
    return figure


def write_plot(trajectory: Trajectory, path: Path) -> None:
    """Write the drawing to a .svg, .pdf or .png file."""
    figure = draw(trajectory)
    with whole_file(path) as file:
        figure.savefig(file, format=path.suffix[1:])
