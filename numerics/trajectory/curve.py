"""A trajectory as points for drawing, in binary64: as many in each segment as its curve needs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from numerics.trajectory.columns import Array, Counts, Floats
from numerics.trajectory.events import wall_of
from numerics.trajectory.rows import RecordedRun

RESOLVED = 100
"""So many segments at the beginning and at the end are always drawn as curves."""
_TINY = 1e-300
"""A time that is none, s."""
_PER_RADIAN, _FEWEST, _LEAST, _MOST = 24, 8, 60, 10_000
"""Points for each radian of Omega t; fewer than the second are no curve; a segment gets at least the third if it turns
so far; longer ones share the last."""


class SampledCurve(NamedTuple):
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


def sampled(trajectory: RecordedRun) -> SampledCurve:
    """Return points that resolve every segment, however short; of thousands of segments the first and the last.

    At a jump of u or b, as at an event, there are two points.
    """
    scene, number = trajectory.scene, trajectory.floats
    with trajectory.arithmetic.context():
        lengths, excess = number(trajectory.row_lengths), trajectory.row_excess
    m1, a1, a2 = [float(one) for one in (scene.pair.m1, scene.pair.a1, scene.pair.a2)]
    fastest = [max([(a2 / m1) ** 0.5, *(float(s) for one in p.layout.omegas for s in one)]) for p in trajectory.pieces]
    radians = lengths * np.array(fastest)[trajectory.row_pieces[: len(lengths)]]
    parts = _parts(radians)
    at = np.repeat(np.arange(len(parts)), parts + 1)
    share = np.concatenate([np.linspace(0, 1, count + 1) for count in parts])
    since, stick = lengths[at] * share, trajectory.row_signs[at] == 0
    found = trajectory.row_changes(at, since)
    y, (u, load, kinetic, edge) = number(trajectory.row_states)[:, at] + found[:4], found[4:]
    segment = np.searchsorted(trajectory.event_rows, at, side="right")
    t = number(trajectory.row_times)[at] + since
    wall = number(wall_of(trajectory, at, trajectory.row_times[at] + since)[0]) if scene.wall.pieces else 0.0 * t
    energy = np.asarray(scene.pair.energy((y[0] - wall, *y[1:]), float))
    b, friction = np.where(stick, edge, np.abs(kinetic)), np.where(stick, load, kinetic)
    apart = np.where(stick, 0.0, found[0] - found[2])
    push = u - a2 * (y[0] - wall) - friction  # what is left of it the damper takes
    speed = np.diff(wall) / np.maximum(np.diff(since), _TINY)
    viscous = _work(push, y[0] - wall) - m1 * (_work(y[1], y[1]) - speed * np.diff(y[1]))
    steps = np.where(np.diff(at) == 0, [_work(kinetic, apart), viscous * (a1 > 0)], 0.0)
    lost = np.cumsum(np.insert(steps, 0, 0.0, axis=1), axis=1)
    w = np.full(len(t), np.nan)
    if trajectory.has_critical_energy:
        unit = float(scene.pair.critical_energy)
        # where it is carried it keeps its digits where E/E_cr - 1 cancels
        w = energy / unit - 1 if excess is None else number(excess)[at] - kinetic * apart / unit
    resolved = (parts >= _FEWEST * radians)[at]
    return SampledCurve(t, y, w, lost, segment, resolved, stick, u, b, load, friction, energy)


def _work(force: Floats, along: Floats) -> Floats:
    """Return what a force does from point to point; exact where it is linear in the way."""
    return np.asarray((force[1:] + force[:-1]) / 2 * np.diff(along))


def _parts(radians: Floats) -> Counts:
    """Return into how many parts each segment is divided, from the radians that it turns through."""
    share = _MOST * radians / max(radians.sum(), 1.0)
    parts = 6 + np.minimum(_PER_RADIAN * radians, np.maximum(share, _LEAST)).astype(int)
    if len(parts) > 10 * RESOLVED:
        parts[RESOLVED:-RESOLVED] = 2  # speeds are largest about the middle of a stick phase
    return np.asarray(parts)
