"""The sensitivities of a trajectory as JSON, as arrays and as a table."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number
from numerics.solver.solve import solve
from numerics.trajectory.comparison import as_fraction, distance, require_same_sequence
from numerics.trajectory.export import STATE_NAMES, Written
from numerics.trajectory.rendering import ball_text, right_digits_text
from numerics.trajectory.trajectory import Trajectory

_TABLE_DIGITS = 6
Writer = Callable[[str, Number, Number], Written]
"""Takes a name, a number and the ball that holds the true one."""


def add_sensitivities(record: dict[str, Any], trajectory: Trajectory) -> None:
    """Put derivatives beside the numbers of a JSON record: `"sensitivity": {"t": {"x1": ...}, ...}` in every event.

    The final state has those of x1, v1, x2, v2 and energy. Decimal strings as in the record: right digits for float64
    and mpmath, found by solving once more in balls; radii beside balls.
    """
    digits = trajectory.digits or (17 if trajectory.arithmetic.name == "float64" else trajectory.arithmetic.digits)

    def with_radius(name: str, value: Number, _: Number) -> Written:
        text, radius = ball_text(value, digits)
        return {name: text, f"{name}_radius": radius}

    write = with_radius if trajectory.arithmetic.name == "ball" else _right_digits(trajectory, digits)
    for row, derivatives in zip([*record["events"], record["final"]], _records(trajectory, write, digits), strict=True):
        row["sensitivity"] = derivatives


def sensitivity_arrays(trajectory: Trajectory) -> dict[str, NDArray[Any]]:
    """Return the derivatives in binary64, and the names that their last axis stands for, for a NumPy archive."""
    found, number = trajectory.sensitivity, trajectory.arithmetic.to_float
    named = {"t": found.t, "y": found.y, "final": found.final, "energy": found.energy}
    with trajectory.arithmetic.context():
        arrays = {
            f"sensitivity_{name}": np.array([number(one) for one in array.flat]).reshape(array.shape)
            for name, array in named.items()
        }
    return arrays | {"sensitivity_wrt": np.array(found.wrt)}


def sensitivity_table(trajectory: Trajectory) -> str:
    """Return the derivatives of the last event's time and of the final state as text: SI units, right digits only."""
    records = _records(trajectory, _right_digits(trajectory, _TABLE_DIGITS), _TABLE_DIGITS)
    named = [("the last event's t", records[-2]["t"])] if len(records) > 1 else []
    named += [(f"final {name}", derivatives) for name, derivatives in records[-1].items()]
    rows = [("derivative", *(f"of {label}" for label, _ in named))]
    rows += [(f"by {wrt}", *(derivatives[wrt] for _, derivatives in named)) for wrt in trajectory.sensitivity.wrt]
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = ("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) for row in rows)
    return "\n".join(line.rstrip() for line in lines)


def _right_digits(trajectory: Trajectory, digits: int) -> Writer:
    """Return a writer that cuts a number where it parts from its ball, or a ball at its radius."""
    if trajectory.arithmetic.name == "ball":
        return lambda name, value, _: {name: str(value.str(digits, radius=False))}
    return lambda name, value, ball: {name: right_digits_text(as_fraction(value), distance(value, ball), digits)}


def _records(trajectory: Trajectory, write: Writer, digits: int) -> list[dict[str, Written]]:
    """Return one record of derivatives for every event, and then that of the final state."""
    balls = trajectory if trajectory.arithmetic.name == "ball" else _proved(trajectory, digits)
    with balls.arithmetic.context():
        return [
            {name: _row(trajectory, write, values, proved[name]) for name, values in one.items()}
            for one, proved in zip(_named(trajectory), _named(balls), strict=True)
        ]


def _row(trajectory: Trajectory, write: Writer, values: NDArray[Any], proved: NDArray[Any]) -> Written:
    row: Written = {}
    for name, value, ball in zip(trajectory.sensitivity.wrt, values, proved, strict=True):
        row |= write(name, value, ball)
    return row


def _named(trajectory: Trajectory) -> list[dict[str, NDArray[Any]]]:
    found = trajectory.sensitivity
    events = [{"t": t} | dict(zip(STATE_NAMES, y, strict=True)) for t, y in zip(found.t, found.y, strict=True)]
    return [*events, dict(zip(STATE_NAMES, found.final, strict=True)) | {"energy": found.energy}]


def _proved(trajectory: Trajectory, digits: int) -> Trajectory:
    """Return the trajectory in balls, with some digits more."""
    limit = len(trajectory.events) + (1 if trajectory.success else 0)
    balls = solve(trajectory.scene, digits=digits + 3, arithmetic="ball", max_events=limit)
    require_same_sequence(trajectory, balls)
    return balls
