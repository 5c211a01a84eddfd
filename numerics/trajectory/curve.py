"""A trajectory as points for drawing, in binary64: as many in each segment as its curve needs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from numerics.linear.cells import cells_of
from numerics.trajectory.columns import Array, Counts, Floats
from numerics.trajectory.events import energy_in_floats
from numerics.trajectory.rows import Rows

RESOLVED = 100
"""So many segments at the beginning and at the end are always drawn as curves."""
_PER_RADIAN, _FEWEST, _LEAST, _MOST = 24, 8, 60, 10_000
"""Points for each radian of Omega t; fewer than the second are no curve; a segment gets at least the third if it turns
so far; longer ones share the last."""


class Curve(NamedTuple):
    """A trajectory for drawing, n points: its ends and, in every segment, both ends and points between them."""

    t: Floats
    """Time, s."""
    y: Floats
    """x1, v1, x2, v2, shape (4, n), m and m/s."""
    w: Floats
    """E/E_cr - 1."""
    lost: Floats
    """What friction and viscosity have taken so far, shape (2, n), J."""
    segment: Counts
    """Which segment each point belongs to."""
    resolved: Array
    """Whether the points of this segment are so many that lines between them are its curve."""
    stick: Array
    """Whether the bodies stick."""
    u: Floats
    """Force on body 1, N; where it jumps there are two points."""
    b: Floats
    """Friction that the interface gives in slip, and can give in stick, N."""
    load: Floats
    """Friction force on body 2 that sticking needs, N."""
    friction: Floats
    """Friction force on body 2, N: by the mode, since rounding gives v1 - v2 a sign of its own at an event."""
    energy: Floats
    """J"""


def sampled(trajectory: Rows) -> Curve:
    """Return points that resolve every segment, however short; of thousands of segments the first and the last.

    At a jump of u or b, as at an event, there are two points.
    """
    scene, number, cells = trajectory.scene, trajectory.floats, cells_of(trajectory.scene)
    with trajectory.arithmetic.context():
        lengths, excess = number(trajectory.row_lengths), trajectory.row_excess
    own = float(scene.pair.a2 / scene.pair.m1) ** 0.5
    fastest = [max([own, *(float(s) for one in p.layout.omegas for s in one)]) for p in trajectory.pieces]
    radians = lengths * np.array(fastest)[trajectory.row_pieces[: len(lengths)]]
    parts = _parts(radians)
    at = np.repeat(np.arange(len(parts)), parts + 1)
    share = np.concatenate([np.linspace(0, 1, count + 1) for count in parts])
    since, stick = lengths[at] * share, trajectory.row_signs[at] == 0
    found = trajectory.row_changes(at, since, integrals=True)
    y, (u, load, kinetic, edge), taken = number(trajectory.row_states)[:, at] + found[:4], found[4:8], found[8:10]
    if cells is not None:
        edge = edge * cells.relative(y[1] - y[3], y[0] - y[2])
    ends = np.cumsum(parts + 1) - 1
    lost = np.insert(np.cumsum(taken[:, ends], axis=1), 0, 0.0, axis=1)[:, at] + taken
    segment = np.searchsorted(trajectory.event_rows, at, side="right")
    t = number(trajectory.row_times)[at] + since
    energy = energy_in_floats(scene, t, y)
    w = np.full(len(t), np.nan)
    if trajectory.has_critical_energy:
        unit = float(scene.pair.critical_energy)
        # where it is carried it keeps its digits where E/E_cr - 1 cancels
        w = energy / unit - 1 if excess is None else number(excess)[at] - taken[0] / unit
    b, friction = np.where(stick, edge, np.abs(kinetic)), np.where(stick, load, kinetic)
    resolved = (parts >= _FEWEST * radians)[at]
    return Curve(t, y, w, lost, segment, resolved, stick, u, b, load, friction, energy)


def _parts(radians: Floats) -> Counts:
    """Return into how many parts each segment is divided, from the radians that it turns through."""
    share = _MOST * radians / max(radians.sum(), 1.0)
    parts = 6 + np.minimum(_PER_RADIAN * radians, np.maximum(share, _LEAST)).astype(int)
    if len(parts) > 10 * RESOLVED:
        parts[RESOLVED:-RESOLVED] = 2  # speeds are largest about the middle of a stick phase
    return np.asarray(parts)
