"""The sensitivities of a trajectory as JSON, as arrays and as a table."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import or_
from typing import Any

import numpy as np
from flint import arb

from numerics.arithmetic.ball import exact_middle
from numerics.trajectory.columns import STATE, Array
from numerics.trajectory.export import Written
from numerics.trajectory.rendering import right_digits_text, with_radius
from numerics.trajectory.sensitivity import enclosures, sensitivities
from numerics.trajectory.trajectory import Trajectory

TABLE_DIGITS = 6


def add_sensitivities(record: dict[str, Any], trajectory: Trajectory) -> None:
    """Put derivatives beside the numbers of a JSON record: `"sensitivity": {"t": {"x1": ...}, ...}` in every event.

    The final state has those of x1, v1, x2, v2 and energy. Decimal strings as in the record: radii beside balls, else
    the digits that are right.
    """
    name_of = trajectory.arithmetic.name
    digits = trajectory.digits or (17 if name_of == "float64" else trajectory.arithmetic.digits)

    def written(name: str, value: arb) -> Written:
        if name_of == "ball":
            return with_radius(name, value, digits)
        return {name: right_digits_text(exact_middle(value), value.rad(), digits)}

    for row, found in zip((*record["events"], record["final"]), _records(trajectory, written), strict=True):
        row["sensitivity"] = found


def sensitivity_arrays(trajectory: Trajectory) -> dict[str, Array]:
    """Return the derivatives in binary64, and the names that their last axis stands for, for a NumPy archive."""
    found = sensitivities(trajectory)
    named = {"t": found.t, "y": found.y, "final": found.final, "energy": found.energy}
    arrays = {f"sensitivity_{name}": trajectory.floats(array) for name, array in named.items()}
    return arrays | {"sensitivity_wrt": np.array(found.wrt)}


def sensitivity_table(trajectory: Trajectory) -> str:
    """Return the derivatives of the last event's time and of the final state as text: SI units, right digits only."""
    records = _records(trajectory, lambda name, value: {name: value.str(TABLE_DIGITS, radius=False)})
    named = [("the last event's t", records[-2]["t"])] if len(records) > 1 else []
    named += [(f"final {name}", derivatives) for name, derivatives in records[-1].items()]
    rows = [("derivative", *(f"of {label}" for label, _ in named))]
    rows += [(f"by {wrt}", *(derivatives[wrt] for _, derivatives in named)) for wrt in named[0][1]]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ("  ".join(map(str.ljust, row, widths)) for row in rows)
    return "\n".join(line.rstrip() for line in lines)


def _records(trajectory: Trajectory, written: Callable[[str, arb], Written]) -> list[dict[str, Written]]:
    """Return one record of derivatives for every event, and then that of the final state."""
    found = enclosures(trajectory)
    rows = [{"t": t, **dict(zip(STATE, y, strict=True))} for t, y in zip(found.t, found.y, strict=True)]
    rows.append({**dict(zip(STATE, found.final, strict=True)), "energy": found.energy})
    return [{name: reduce(or_, map(written, found.wrt, values)) for name, values in row.items()} for row in rows]
