"""A trajectory as points for drawing, in binary64: as many in each segment as its curve needs."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.motion.modes import Mode
from numerics.scene import Scene

RESOLVED = 100
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
    stick: NDArray[np.bool_]
    """Whether the bodies stick."""


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
    stick = np.array([mode is Mode.STICK for mode in trajectory.modes])[at]
    resolved = (parts >= _FEWEST * radians)[at]
    return Curve(tau_ / rate, y, w, np.stack([friction, viscous]) * unit, at, resolved, stick)


def _parts(radians: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return into how many parts each segment is divided, from the radians that it turns through."""
    share = _MOST * radians / max(radians.sum(), 1.0)
    parts = 6 + np.minimum(_PER_RADIAN * radians, np.maximum(share, _LEAST)).astype(int)
    if len(parts) > 10 * RESOLVED:
        parts[RESOLVED:-RESOLVED] = 2  # speeds are largest about the middle of a stick phase
    return parts


def force_on(scene: Scene, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return u(t) of a scene, N, right after each time (s)."""
    starts = np.array([float(one) for one in scene.force.starts])
    at, found = np.searchsorted(starts, t, side="right") - 1, np.zeros_like(t)
    for index in np.unique(at[at >= 0]):
        piece, here = scene.force.pieces[index], at == index
        since = t[here] - starts[index]
        found[here] = np.polynomial.polynomial.polyval(since, [*map(float, piece.polynomial)] or [0.0])
        for sine in piece.sines:
            found[here] += float(sine.amplitude) * np.sin(float(sine.omega) * t[here] + float(sine.phase))
    return found


def friction_on(scene: Scene, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return b of a scene, N, right after each time (s)."""
    starts = np.array([float(start) for start, _ in scene.friction.pieces])
    values = np.array([float(scene.pair.b), *(float(b) for _, b in scene.friction.pieces)])
    return values[np.searchsorted(starts, t, side="right")]


def load_on(scene: Scene, curve: Curve) -> NDArray[np.float64]:
    """Return the friction force on body 2 that sticking needs, m2 (u - a2 x1 - a1 v1)/M, N."""
    pair = scene.pair
    pull = force_on(scene, curve.t) - float(pair.a2) * curve.y[0] - float(pair.a1) * curve.y[1]
    return float(pair.m2 / pair.mass) * pull
