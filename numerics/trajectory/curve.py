"""A trajectory as points for drawing, in binary64: as many in each segment as its curve needs."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.motion.forced_pieces import ExactPiece
from numerics.motion.modes import Mode
from numerics.scene import Pair
from numerics.trajectory.forced_segment import length_of

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
    u: NDArray[np.float64]
    """Force on body 1, N; where it jumps there are two points."""
    b: NDArray[np.float64]
    """Friction that the interface can give, N."""

    def load(self, pair: Pair) -> NDArray[np.float64]:
        """Return the friction force on body 2 that sticking needs, m2 (u - a2 x1 - a1 v1)/M, N."""
        pull = self.u - float(pair.a2) * self.y[0] - float(pair.a1) * self.y[1]
        return float(pair.m2 / pair.mass) * pull

    def energy(self, pair: Pair) -> NDArray[np.float64]:
        """Return the energy of spring and bodies, J."""
        x1, v1, _, v2 = self.y
        return (float(pair.a2) * x1**2 + float(pair.m1) * v1**2 + float(pair.m2) * v2**2) / 2


def sampled(trajectory: Any) -> Curve:
    """Return points that resolve every segment, however short; of thousands of segments the first and the last."""
    return _forced(trajectory) if trajectory.scene.is_forced else _free(trajectory)


def _free(trajectory: Any) -> Curve:
    number, pair = trajectory.arithmetic.to_float, trajectory.scene.pair
    with trajectory.arithmetic.context():
        length, rate, unit = (number(one) for one in trajectory.units)
        radians = np.array([number(segment.length) for segment in trajectory.segments])
        parts = _parts(radians)
        rows, spent = [], np.zeros(2)
        for segment, long, count in zip(trajectory.segments, radians, parts, strict=True):
            start, lost = number(segment.start), np.zeros(2)
            for part in range(count + 1):
                since = segment.length * part / int(count)
                state = [number(one) for one in segment.state(since)]
                lost = np.array([number(one) for one in segment.losses(since)])
                rows.append([start + long * part / count, *state, *(spent + lost)])
            spent = spent + lost
    tau, X, V1, V2, Z, w, friction, viscous = np.array(rows, dtype=float).reshape(-1, 8).T
    speed, at = length * rate, np.repeat(np.arange(len(parts)), parts + 1)
    y = np.stack([X * length, V1 * speed, (X - Z) * length, V2 * speed])
    stick = np.array([mode is Mode.STICK for mode in trajectory.modes])[at]
    taken, resolved = np.stack([friction, viscous]) * unit, (parts >= _FEWEST * radians)[at]
    return Curve(tau / rate, y, w, taken, at, resolved, stick, 0 * tau, 0 * tau + float(pair.b))


def _forced(trajectory: Any) -> Curve:
    """Return the points of a run under a force, row by row: at a jump of u or b a row ends."""
    number, scene, dense = trajectory.arithmetic.to_float, trajectory.scene, trajectory.dense
    codes = trajectory.record.rows[: None if trajectory.reached else trajectory.knots[-1]]
    with trajectory.arithmetic.context():
        lengths = [length_of(trajectory, row) for row in range(len(codes))]
        acting = [trajectory.pieces[int(code[3])] for code in codes]
        fastest = [max([_fastest(scene.pair), *(float(one.omega) for one in piece.sines)]) for piece in acting]
        radians = np.array([number(length) for length in lengths]) * fastest
        parts = _parts(radians)
        times, states, forces, frictions = [], [], [], []
        for row, (length, piece, count) in enumerate(zip(lengths, acting, parts, strict=True)):
            long = number(length)
            t = (
                number(trajectory.time_of(row) if row else trajectory.arithmetic.number(0))
                + long * np.arange(count + 1) / count
            )
            times.append(t)
            states += [[number(x) for x in dense.after(row, length * k / int(count))] for k in range(count + 1)]
            forces.append(force_of(piece, t))
            frictions.append(np.full(count + 1, float(piece.b)))
    t, y, u, b = np.concatenate(times), np.array(states).T, np.concatenate(forces), np.concatenate(frictions)
    of_row = np.repeat(np.arange(len(parts)), parts + 1)
    segment = np.searchsorted(trajectory.knots, of_row, side="right")
    stick = np.array([mode is Mode.STICK for mode in trajectory.modes])[segment]
    curve = Curve(t, y, t, y[:2], segment, (parts >= _FEWEST * radians)[of_row], stick, u, b)
    w = curve.energy(scene.pair) / float(scene.pair.critical_energy) - 1
    return curve._replace(w=w, lost=_lost(curve, scene.pair))


def _fastest(pair: Pair) -> float:
    """Return the frequency of body 1 alone on its spring, rad/s."""
    return float(pair.a2 / pair.m1) ** 0.5


def _lost(curve: Curve, pair: Pair) -> NDArray[np.float64]:
    """Return what friction and viscosity have taken up to each point, J; the second by the trapezoidal rule."""
    slid = np.abs(np.diff(curve.y[0] - curve.y[2])) * curve.b[1:]
    damped = float(pair.a1) * np.diff(curve.t) * (curve.y[1, 1:] ** 2 + curve.y[1, :-1] ** 2) / 2
    return np.stack([np.concatenate([[0.0], np.cumsum(part)]) for part in (slid, damped)])


def _parts(radians: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return into how many parts each segment is divided, from the radians that it turns through."""
    share = _MOST * radians / max(radians.sum(), 1.0)
    parts = 6 + np.minimum(_PER_RADIAN * radians, np.maximum(share, _LEAST)).astype(int)
    if len(parts) > 10 * RESOLVED:
        parts[RESOLVED:-RESOLVED] = 2  # speeds are largest about the middle of a stick phase
    return parts


def force_of(piece: ExactPiece, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the force of one piece at times (s) of its own, N."""
    coefficients = [float(one) for one in piece.polynomial] or [0.0]
    found = np.polynomial.polynomial.polyval(t - float(piece.start), coefficients)
    for sine in piece.sines:
        found = found + float(sine.amplitude) * np.sin(float(sine.omega) * t + float(sine.phase))
    return np.asarray(found, dtype=float)
