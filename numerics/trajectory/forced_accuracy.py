"""Error bounds of a trajectory under a force in points: how far the path may be from the true motion."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.trajectory.digits import Accuracy, rounding_of

_STATE = ("x1", "v1", "x2", "v2")
_TINY = 2.0**-1060


def accuracy_of(trajectory: Any) -> Accuracy:
    """Return the bounds in SI units, binary64; `dissipated` is what energy and work leave open."""
    record, number, (rounding, most) = trajectory.record, trajectory.arithmetic.to_float, rounding_of(trajectory)

    def errors(name: str) -> list[float]:
        return [number(one) for one in record.numbers(name, trajectory.knots)]

    t = np.array(errors("late")) + 4 * rounding * trajectory.event_times.astype(float)
    states = trajectory.event_states.astype(float).T
    y = np.array([errors(f"{name}_error") for name in _STATE]).T.reshape(-1, 4) + rounding * abs(states)
    final = np.array([number(record.number(-1, f"{name}_error")) for name in _STATE])
    state = np.array([number(one) for one in trajectory.final_state])
    final = final + rounding * abs(state) + _TINY
    pair, energy = trajectory.scene.pair, number(trajectory.final_energy)
    norm, root = number(record.number(-1, "norm")), math.sqrt(2 * energy)
    energy_error = norm * (root + norm) + 8 * rounding * energy + _TINY
    critical = float(pair.critical_energy)
    excess = energy_error / critical + 8 * rounding * (1 + energy / critical)
    worst = [
        *_relative(t, trajectory.event_times.astype(float)),
        *_relative(y.ravel(), states.ravel()),
        *_relative(final, state),
        *_relative(np.array([energy_error]), np.array([energy])),
    ]
    largest = max([*worst, rounding / 8])
    digits = max(0, min(most, math.floor(-math.log10(largest)))) if largest < 1 else 0
    return Accuracy(t, y, final, energy_error, excess, energy_error, True, digits)


def _relative(error: Any, value: Any) -> list[float]:
    """Return errors relative to their values; what is 0 to within a rounding of the smallest number counts as exact."""
    return [
        0.0 if e <= 2 * _TINY else e / abs(v) if v else math.inf
        for e, v in zip(error.tolist(), value.tolist(), strict=True)
    ]
