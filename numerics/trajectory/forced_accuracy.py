"""Error bounds of a trajectory under a force in points: how far the path may be from the true motion."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.bounds.forced import Point, spreads
from numerics.flows.forced_records import Start
from numerics.trajectory.digits import Accuracy, rounding_of
from numerics.trajectory.forced_units import unit_of_time

_STATE = ("x1", "v1", "x2", "v2")
_TINY = 2.0**-1060


_PLENTY = 12
"""Right digits of binary64 by the bounds in N with which the sharper ones are left aside, which take some time."""


def accuracy_of(trajectory: Any) -> Accuracy:
    """Return the bounds in SI units, binary64; `dissipated` is what energy and work leave open."""
    found = _bounded_by(trajectory, None)
    if trajectory.arithmetic.name != "float64" or found.digits >= _PLENTY:
        return found
    return _bounded_by(trajectory, spreads_of(trajectory))


def _bounded_by(trajectory: Any, sharper: tuple[Any, Any] | None) -> Accuracy:
    """Return the bounds in N, or by components where those are smaller."""
    record, number, (rounding, most) = trajectory.record, trajectory.arithmetic.to_float, rounding_of(trajectory)

    def errors(name: str) -> Any:
        if isinstance(record.rows, np.ndarray):
            return record.column(name)[trajectory.knots]
        return [number(one) for one in record.numbers(name, trajectory.knots)]

    late = np.array(errors("late"))
    states = trajectory.event_states.astype(float).T
    y = np.array([errors(f"{name}_error") for name in _STATE]).T.reshape(-1, 4)
    final = np.array([number(record.number(-1, f"{name}_error")) for name in _STATE])
    norm = number(record.number(-1, "norm"))
    if sharper is not None:
        rows, last = sharper
        late, y, final = np.minimum(late, rows[:, 0]), np.minimum(y, rows[:, 1:]), np.minimum(final, last)
    y, t = y + rounding * abs(states), late + 4 * rounding * trajectory.event_times.astype(float)
    state = np.array([number(one) for one in trajectory.final_state])
    final = final + rounding * abs(state) + _TINY
    pair, energy = trajectory.scene.pair, number(trajectory.final_energy)
    norm = min(norm, math.sqrt(pair.a2 * final[0] ** 2 + pair.m1 * final[1] ** 2 + pair.m2 * final[3] ** 2))
    root = math.sqrt(2 * energy)
    energy_error = norm * (root + norm) + 8 * rounding * energy + _TINY
    critical = float(pair.critical_energy)
    excess = energy_error / critical + 8 * rounding * (1 + energy / critical)
    scales = np.maximum(abs(states).max(axis=0, initial=0.0), abs(state))
    scales = np.maximum(scales, scales[[2, 3, 0, 1]])  # both positions, and both velocities, have one
    worst = [
        _digits(t, trajectory.event_times.astype(float), np.array(0.0)),
        _digits(y, states, scales),
        _digits(final, state, scales),
        _digits(np.array([energy_error]), np.array([energy]), np.array(0.0)),
    ]
    digits = max(0, min(most, *worst))
    return Accuracy(t, y, final, energy_error, excess, energy_error, True, digits)


def spreads_of(trajectory: Any) -> tuple[Any, Any]:
    """Return the bounds of bounds/forced.py in SI: (t, x1, v1, x2, v2) of each event, (x1, v1, x2, v2) at the end."""
    followed, unit = trajectory.in_unit, float(unit_of_time(trajectory.scene))
    record, (pair, drive) = followed.record, followed.tables
    points = [Point(_start(row), row[1] == 1.0, row[2] == 1.0, float(row[12])) for row in record.rows]
    rows, last = spreads(pair, drive, points, _start(record.end_row))
    speed = np.array([1.0, 1.0 / unit, 1.0, 1.0 / unit])
    return rows[trajectory.knots] * np.array([unit, *speed]), last * speed


def _start(row: Any) -> Start:
    """Return the start that a row tells of."""
    numbers = [float(one) for one in row[5:12]]
    return Start._make((int(row[0]), int(row[4]), int(row[3]), *numbers, 0.0))


def dissipated_of(trajectory: Any) -> tuple[float, float]:
    """Return what friction and viscosity took in a run in binary64, J, and a bound on its error.

    In truth it is what the initial energy and the work of u leave of the final energy; the ledger's residual says by
    how much it is not. Raises OutOfRange.
    """
    ledger, unit = trajectory.ledger, float(unit_of_time(trajectory.scene))
    sizes = ledger.initial + abs(ledger.work) + ledger.final + ledger.friction + ledger.viscous
    off = trajectory.parts.off / unit**2 + trajectory.accuracy.energy + 8 * rounding_of(trajectory)[0] * sizes
    return ledger.friction + ledger.viscous, abs(ledger.residual) + off


def _digits(error: Any, value: Any, scale: Any) -> int:
    """Return the least number of digits that errors leave right, relative to each value.

    As for balls (digits.py): a value that may be 0 counts as 0 to n digits below 10^(-4 n) of its scale; where
    its scale is 0 too, it has none.
    """
    may_be_zero = error >= abs(value)
    size = np.where(may_be_zero, scale, abs(value))
    with np.errstate(divide="ignore", invalid="ignore"):
        digits = -np.log10(np.where(error <= 2 * _TINY, 0.0, error / size))
    digits = np.where(may_be_zero, digits / 4, digits)
    return math.floor(min(digits.min(initial=99.0), 99.0)) if (digits > 0).all() else 0
