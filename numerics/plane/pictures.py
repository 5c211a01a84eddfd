"""A motion on a surface, seen from above: both bodies' paths and the relative velocity; what sticks is grey."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from numerics.plane.answer import PlaneTrajectory

_POINTS = 60


def overview(trajectory: PlaneTrajectory) -> Any:
    """Return a figure: x1 and x2 from above, and v1 - v2 (m/s), by segments."""
    import matplotlib.pyplot as plt

    figure, (above, relative) = plt.subplots(1, 2, figsize=(9, 4.5), layout="constrained")
    n = trajectory.scene.pair.axes
    times = [0.0, *(float(t.mid()) if hasattr(t, "mid") else float(t) for t in trajectory.event_times)]
    ends = [*times, float(trajectory.end_time.mid())]
    for (start, end), mode in zip(pairwise(ends), trajectory.modes, strict=False):
        inside = np.linspace(start, end, _POINTS)[1:-1]
        y = np.array([[float(x) for x in trajectory.sol(float(t))] for t in inside]).reshape(-1, 4 * n).T
        grey = set(mode) <= {"0"} or mode == "stick"
        above.plot(y[0], y[1], color="0.7" if grey else "C0", lw=1.2)
        above.plot(y[2 * n], y[2 * n + 1], color="0.85" if grey else "C1", lw=1.2)
        relative.plot(y[n] - y[3 * n], y[n + 1] - y[3 * n + 1], color="0.7" if grey else "C2", lw=1.2)
    for axes, title in ((above, "bodies 1 (blue) and 2 (orange), m"), (relative, "$v_1-v_2$, m/s")):
        axes.set_title(title)
        axes.set_aspect("equal", "datalim")
    return figure
