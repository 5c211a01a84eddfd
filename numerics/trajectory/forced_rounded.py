"""A trajectory under a force in balls, rounded to binary64: every number next to the true one, its bound beside it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from flint import arb

from numerics.arithmetic.float64 import UNIT, Float64
from numerics.errors import OutOfRange
from numerics.trajectory.forced import ForcedTrajectory
from numerics.trajectory.forced_record import CODES, NUMBERS, ForcedRecord

_STATE = ("x1", "v1", "x2", "v2")
_FLOAT64 = Float64()
_SMALLEST = 5e-324


def rounded_to_float64(balls: ForcedTrajectory) -> ForcedTrajectory:
    """Return the same trajectory in binary64; its pieces must be those of binary64, seams and all (Seamed).

    What rounding and the ball's radius leave open is added to the bounds of each row. Raises OutOfRange.
    """
    with balls.arithmetic.context():
        pair = [float(root.upper()) for root in balls.tables[0][7:10]]
        rows = [_rounded(row, pair) for row in balls.record.rows]
        end = _rounded(balls.record.end_row, pair)
    kept = np.array(rows, dtype=float).reshape(-1, len(CODES) + len(NUMBERS))
    return ForcedTrajectory(balls.scene, _FLOAT64, ForcedRecord(kept, np.array(end), balls.record.how, 1), bounded=True)


def _rounded(row: Any, roots: list[float]) -> list[float]:
    """Return a row in binary64: numbers to the nearest, bounds upwards; `roots` of a2, m1 and m2."""
    one = dict(zip(NUMBERS, row[len(CODES) :], strict=True))
    off = {name: _upwards(one[name]) for name in NUMBERS[5:]}
    near = {name: _nearest(one[name]) for name in NUMBERS[:5]}
    for name in _STATE:
        off[f"{name}_error"] += _upwards(one[name] - near[name])
    off["late"] += _upwards(one["local"] - near["local"])
    lost = [UNIT * abs(near[name]) for name in ("x1", "v1", "v2")]
    off["norm"] += sum(root * by for root, by in zip(roots, lost, strict=True))
    off["place"] += lost[0] + UNIT * abs(near["x2"])
    found = near | off
    return [*row[: len(CODES)], *(found[name] for name in NUMBERS)]


def _nearest(x: arb) -> float:
    """Return the binary64 number nearest to the middle of a ball."""
    number = _FLOAT64.to_float(float(x.mid()))
    if not math.isfinite(number):
        raise OutOfRange('a number of this scene is beyond the range of float64; use arithmetic="ball"')
    return number


def _upwards(bound: arb) -> float:
    """Return a binary64 number that is not below the size of a ball."""
    return float(abs(arb(bound)).upper()) * (1.0 + 4.0 * UNIT) + (0.0 if arb(bound).is_zero() else _SMALLEST)
