"""A motion on a surface as JSON, CSV, NumPy archive or data frame: the words of the line's, a column for each axis."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.plane.answer import PlaneSolution, PlaneState
from numerics.scene.plane import AXES
from numerics.trajectory import export
from numerics.trajectory.comparison import as_fraction
from numerics.trajectory.rendering import ball_text, right_digits_text

_UNITS = {"x1": "m", "v1": "m/s", "x2": "m", "v2": "m/s", "load": "N"}
_OF_ANGLE = {"m": "rad", "m/s": "rad/s", "N": "N m"}


def as_record(trajectory: PlaneSolution) -> dict[str, Any]:
    """Return the JSON object of the interface: decimal strings of right digits, lists by axes, radii beside balls."""
    with trajectory.context():
        return {
            "status": trajectory.status.name.lower().replace("_", "-"),
            "message": trajectory.message,
            "arithmetic": trajectory.arithmetic.name,
            "digits": trajectory.digits,
            "events": list(_events(trajectory)),
            "final": _number(trajectory, "t", trajectory.end_time)
            | {"mode": trajectory.final_mode}
            | _state(trajectory, trajectory.final_state)
            | _number(trajectory, "energy", trajectory.energy_of(trajectory.final_state)),
        }


def _events(trajectory: PlaneSolution) -> Iterator[dict[str, Any]]:
    for one in trajectory.events:
        row = _number(trajectory, "t", one.t) | {"from": one.before, "to": one.after}
        if trajectory.scene.is_forced:
            row["cause"] = one.cause
        row |= _state(trajectory, one.y) | _vector(trajectory, "direction", one.direction)
        yield row | _vector(trajectory, "load", one.load)


def _state(trajectory: PlaneSolution, y: PlaneState) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name, values in y._asdict().items():
        found |= _vector(trajectory, name, values)
    return found


def _number(trajectory: PlaneSolution, name: str, x: arb) -> dict[str, Any]:
    if trajectory.is_float:
        value = float(x.mid())
        return {name: right_digits_text(as_fraction(value), abs(x - arb(value)).upper(), 17)}
    text, radius = ball_text(x, trajectory.digits)
    return {name: text, f"{name}_radius": radius}


def _vector(trajectory: PlaneSolution, name: str, values: Sequence[arb]) -> dict[str, Any]:
    rows = [_number(trajectory, name, x) for x in values]
    return {key: [row[key] for row in rows] for key in (rows[0] if rows else {name: ""})}


def as_csv(trajectory: PlaneSolution) -> str:
    """Return events and final state as CSV text: the columns of the JSON records by axes, with units."""
    record = as_record(trajectory)
    rows = {"events": [*map(_by_axes, record["events"])], "final": _by_axes(record["final"])}
    return export.as_csv(rows, unit_of)


def _by_axes(row: dict[str, Any]) -> dict[str, str]:
    """Return a row with a column for each axis: x1_x, x1_y, x1_x_radius, ..."""
    found: dict[str, str] = {}
    for key, value in row.items():
        name = key.removesuffix("_radius")
        lists = zip(AXES, value, strict=False) if isinstance(value, list) else [("", value)]
        found |= {f"{name}_{axis}{key[len(name) :]}" if axis else key: one for axis, one in lists}
    return found


def unit_of(column: str) -> str:
    """Return the SI unit of a column; an angle has rad for m, and a torque for a force."""
    name, _, axis = column.removesuffix("_radius").partition("_")
    unit = _UNITS.get(name, "")
    return (_OF_ANGLE[unit] if axis == "phi" and unit else unit) or export.unit_of(column)


def arrays(trajectory: PlaneSolution) -> dict[str, NDArray[Any]]:
    """Return t (m,), y (4 n, m) and energy (m,), bounds t_error and y_error, modes and event_kinds; in binary64."""
    with trajectory.context():
        number = np.vectorize(lambda x: float(x.mid()) if isinstance(x, arb) else float(x), otypes=[float])
        found = {name: number(getattr(trajectory, name)) for name in ("t", "y", "energy", "t_error", "y_error")}
    kinds = [kind.value for kind in trajectory.event_kinds]
    return {**found, "modes": np.array(trajectory.modes), "event_kinds": np.array(kinds, dtype=str)}


def write_npz(trajectory: PlaneSolution, path: Path) -> None:
    """Write the `arrays` of a trajectory as a NumPy archive."""
    export.write_arrays(arrays(trajectory), path)


def dataframe(trajectory: PlaneSolution) -> Any:
    """Return t, mode, the state by axes and energy at `t` as a pandas DataFrame, in binary64. Raises MissingTool."""
    found = arrays(trajectory)
    axes = AXES[: trajectory.scene.pair.axes]
    names = [f"{name}_{axis}" for name in trajectory.final_state._fields for axis in axes]
    modes = [*trajectory.modes, trajectory.final_mode] if trajectory.t_eval is None else trajectory.mode_at(found["t"])
    columns = {"t": found["t"], "mode": modes, **dict(zip(names, found["y"], strict=True))}
    return export.frame_of(columns | {"energy": found["energy"]})
