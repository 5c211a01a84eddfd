"""Fig. 1 for a real scene: the relative motion, its tolerance ring, and the moment from which on it stays inside."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse

from numerics.control.ring import Ring
from numerics.scene import Scene
from numerics.solver.solve import solve
from numerics.trajectory.figures import BLUE, GRAY, ORANGE

_POINTS = 6000


def draw_ring(found: Ring) -> Figure:
    """Return the relative plane and the distance from the limit over time; solved in float64, ample for the eye."""
    scene, entry, radius, rate = found.scene, float(found.entry), float(found.radius), float(found.rate)
    until = max(float(scene.until), 1.3 * entry)
    longer = Scene(scene.pair, scene.initial, until, scene.law, scene.force, scene.friction)
    t = np.union1d(np.linspace(0, until, _POINTS), [entry])
    y = solve(longer).sol(t)
    z, w = y[0] - y[2] - float(found.centre), y[1] - y[3]
    inside = t >= entry
    figure = Figure(figsize=(10.5, 5.2), layout="constrained")
    plane, time = figure.subplots(1, 2)
    for part, colour, width, label in ((~inside, ORANGE, 0.9, "before"), (inside, BLUE, 1.6, "inside for good")):
        plane.plot(np.where(part, z, np.nan), np.where(part, w, np.nan), color=colour, lw=width, label=label)
    plane.add_patch(Ellipse((0, 0), 2 * radius, 2 * radius * rate, fill=False, ec="black", ls="--", label="ring"))
    at = np.searchsorted(t, entry)
    plane.plot(z[at], w[at], "o", color="black", ms=5, label=f"t = {entry:.6g} s")
    plane.set(xlabel="$z - z^*$ (m)", ylabel="$w = v_1 - v_2$ (m/s)", title="The relative motion and its ring")
    plane.locator_params(axis="x", nbins=5)
    # the motion fills the plane: the legend stands under it
    plane.legend(fontsize=9, loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=2)
    distance = np.hypot(z, w / rate)
    time.semilogy(t, np.where(distance > 0, distance, np.nan), color=BLUE, lw=0.9)
    time.axhline(radius, color="black", ls="--", lw=0.9)
    time.axvline(entry, color=GRAY, lw=1)
    time.set(xlabel="t (s)", ylabel="distance from the limit (m)", title="From the line on inside for good")
    return figure
