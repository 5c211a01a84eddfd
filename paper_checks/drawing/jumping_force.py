"""A force that jumps at the exit from stick: motions of one period that lie beside one another for ever."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from numerics.solver.solve import solve
from paper_checks.claims.jumping_force import SHOWN, member
from paper_checks.drawing.style import panels, samples
from theory import jumping_force as jump

STYLES = (("#1b4f8f", "-"), ("#c8641e", "--"), ("#2e8b3d", "-."))


def jumping_force() -> Figure:
    """Draw three members of the family in the plane of body 1, and the force and their loads over a period."""
    figure, (plane, over_time) = panels(9.4, 3.9, 1, 2)
    for speed, (colour, line) in zip(SHOWN, STYLES, strict=True):
        scene = member(speed)
        t, y = samples(solve(scene))
        push = np.array([float(scene.force(float(time), side=-1)) for time in t])
        plane.plot(y[0], y[1], color=colour, ls=line, label=f"$v={float(speed):g}$ m/s")
        plane.plot(y[0, 0], y[1, 0], "o", color=colour, ms=4)
        over_time.plot(t, (push - y[0]) / 2, color=colour, ls=line)
    steps = np.array([0, float(jump.SLIP_TIME), float(jump.SLIP_TIME + jump.stick_time())])
    level = float(jump.PUSH)
    times = np.concatenate([steps, steps[-1] + steps[1:]])
    over_time.step(times, [level, 0, -level, 0, 0], where="post", color="black", lw=1.2, label="force $u$ (N)")
    for side in (1, -1):
        over_time.axhline(side, color="#777777", lw=0.8, ls=":")
    over_time.plot([], [], color="#777777", lw=1.2, label=r"loads $\Lambda$ (N)")
    plane.set(xlabel="$x_1$ (m)", ylabel="$v_1$ (m/s)", title="three of the periodic motions; dots: exits")
    over_time.set(
        xlabel="$t$ (s)",
        ylabel="force (N)",
        title=r"at the jumps of $u$ each $\Lambda$ leaves $|\Lambda|\leqslant b=1$",
    )
    plane.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), ncols=3)
    over_time.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), ncols=2)
    return figure
