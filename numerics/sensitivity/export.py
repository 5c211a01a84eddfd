"""The sensitivities of a trajectory as JSON, as arrays and as a table."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number
from numerics.sensitivity.sensitivity import Sensitivity, sensitivities
from numerics.trajectory.comparison import as_fraction, distance
from numerics.trajectory.export import STATE_NAMES, Written
from numerics.trajectory.rendering import ball_text, right_digits_text
from numerics.trajectory.trajectory import Trajectory

TABLE_DIGITS = 6
_Writer = Callable[[str, Number, Number], Written]
"""Takes a name, a number and the ball that holds the true one."""


def record_digits(trajectory: Trajectory) -> int:
    """Return how many digits of a derivative a JSON record shows at most."""
    return trajectory.digits or (17 if trajectory.arithmetic.name == "float64" else trajectory.arithmetic.digits)


def add_sensitivities(record: dict[str, Any], trajectory: Trajectory, balls: Trajectory) -> None:
    """Put derivatives beside the numbers of a JSON record: `"sensitivity": {"t": {"x1": ...}, ...}` in every event.

    The final state has those of x1, v1, x2, v2 and energy. Decimal strings as in the record: radii beside balls, else
    the digits in which they agree with `balls`, the same scene solved in balls (the trajectory itself, if it is so).
    """
    digits = record_digits(trajectory)

    def with_radius(name: str, value: Number, _: Number) -> Written:
        text, radius = ball_text(value, digits)
        return {name: text, f"{name}_radius": radius}

    write = with_radius if trajectory is balls else _right_digits(digits)
    for row, derivatives in zip([*record["events"], record["final"]], _records(trajectory, balls, write), strict=True):
        row["sensitivity"] = derivatives


def sensitivity_arrays(trajectory: Trajectory) -> dict[str, NDArray[Any]]:
    """Return the derivatives in binary64, and the names that their last axis stands for, for a NumPy archive."""
    found, number = sensitivities(trajectory), trajectory.arithmetic.to_float
    named = {"t": found.t, "y": found.y, "final": found.final, "energy": found.energy}
    with trajectory.arithmetic.context():
        arrays = {
            f"sensitivity_{name}": np.array([number(one) for one in array.flat]).reshape(array.shape)
            for name, array in named.items()
        }
    return arrays | {"sensitivity_wrt": np.array(found.wrt)}


def sensitivity_table(trajectory: Trajectory, balls: Trajectory) -> str:
    """Return the derivatives of the last event's time and of the final state as text: SI units, right digits only."""

    def without_radius(name: str, value: Number, _: Number) -> Written:
        return {name: str(value.str(TABLE_DIGITS, radius=False))}

    records = _records(trajectory, balls, without_radius if trajectory is balls else _right_digits(TABLE_DIGITS))
    named = [("the last event's t", records[-2]["t"])] if len(records) > 1 else []
    named += [(f"final {name}", derivatives) for name, derivatives in records[-1].items()]
    rows = [("derivative", *(f"of {label}" for label, _ in named))]
    rows += [(f"by {wrt}", *(derivatives[wrt] for _, derivatives in named)) for wrt in named[0][1]]
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = ("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) for row in rows)
    return "\n".join(line.rstrip() for line in lines)


def _right_digits(digits: int) -> _Writer:
    """Return a writer that cuts a number where it parts from its ball."""
    return lambda name, value, ball: {name: right_digits_text(as_fraction(value), distance(value, ball), digits)}


def _records(trajectory: Trajectory, balls: Trajectory, write: _Writer) -> list[dict[str, Written]]:
    """Return one record of derivatives for every event, and then that of the final state."""
    found = sensitivities(trajectory)
    true = found if trajectory is balls else sensitivities(balls)
    with balls.arithmetic.context():
        return [
            {name: _row(found.wrt, write, values, proved[name]) for name, values in one.items()}
            for one, proved in zip(_named(found), _named(true), strict=True)
        ]


def _row(wrt: tuple[str, ...], write: _Writer, values: NDArray[Any], proved: NDArray[Any]) -> Written:
    row: Written = {}
    for name, value, ball in zip(wrt, values, proved, strict=True):
        row |= write(name, value, ball)
    return row


def _named(found: Sensitivity) -> list[dict[str, NDArray[Any]]]:
    events = [{"t": t} | dict(zip(STATE_NAMES, y, strict=True)) for t, y in zip(found.t, found.y, strict=True)]
    return [*events, dict(zip(STATE_NAMES, found.final, strict=True)) | {"energy": found.energy}]
