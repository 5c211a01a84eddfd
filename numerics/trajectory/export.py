"""A trajectory as JSON, CSV, NumPy archive or data frame. Files appear whole under their name or not at all.

On a surface every x1, v1, x2, v2 is a list by axes, and a table has a column for each axis.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import arb

from numerics.exits import tool
from numerics.files import whole_file
from numerics.scene.decimals import decimal_text, exact_decimal
from numerics.scene.plane import AXES
from numerics.trajectory.columns import STATE, Array
from numerics.trajectory.comparison import as_ball, distance, require_same_sequence
from numerics.trajectory.rendering import MOST_DIGITS, with_radius
from numerics.trajectory.units import unit

if TYPE_CHECKING:
    from pandas import DataFrame

END_NAMES = (*STATE, "energy", "energy_excess")
AT_END = -1
"""Stands for the end in the place of the index of an event."""


def knows_its_digits(trajectory: Any) -> bool:
    """Return whether radii or error bounds say which digits of a trajectory are right."""
    if trajectory.arithmetic.name == "ball":
        return True
    return trajectory.accuracy is not None and bool(trajectory.accuracy.bounded)


def numbers_at(trajectory: Any, index: int) -> tuple[Any, ...]:
    """Return time and state of an event, or of the end, with energy and excess; on a surface tuples by axes."""
    if index == AT_END:
        return trajectory.end_time, *trajectory.end_numbers()
    event = trajectory.events[index]
    return event.t, *event.y, *(getattr(event, name) for name in trajectory.EVENT_COLUMNS)


def bounds_at(trajectory: Any, index: int) -> tuple[float, ...]:
    """Return the error bounds of the same numbers of a run that has some."""
    known = trajectory.accuracy
    return trajectory.end_bounds() if index == AT_END else (known.t[index], *known.y[index])


def in_balls(trajectory: Any, digits: int) -> Any:
    """Return the scene of a trajectory solved again, in balls of so many right digits, as far as it goes."""
    import numerics

    # one event more than were found shows a lost one; a run that was cut off is cut off at the same event
    limit = max(1, trajectory.record.events + trajectory.reached)
    return numerics.solve(trajectory.scene, digits=digits, arithmetic="ball", max_events=limit)


def as_record(trajectory: Any, events: Iterable[int] | None = None) -> dict[str, Any]:
    """Return a trajectory as the JSON object of the interface: decimal strings of right digits, radii beside balls.

    What neither radii nor bounds say of the digits is said by the same scene in balls. `events` are the indices of
    those that are wanted, all by default. Raises SequenceDiffers if its sequence of events is not the true one, so that
    no wrong itinerary is ever printed; EventUndecided.
    """
    truth = None
    if not knows_its_digits(trajectory):
        truth = in_balls(trajectory, 3 + (MOST_DIGITS if trajectory.bounded else trajectory.arithmetic.digits))
        require_same_sequence(trajectory, truth)
    with (truth or trajectory).context():
        wanted = range(len(trajectory.events)) if events is None else events
        *rows, final = (_row(trajectory, truth, index) for index in (*wanted, AT_END))
    return {
        "status": trajectory.status.name.lower().replace("_", "-"),
        "message": trajectory.message,
        "arithmetic": trajectory.arithmetic.name,
        "digits": right_digits(trajectory),
        "events": rows,
        "final": final,
    }


def right_digits(trajectory: Any) -> int:
    """Return the right digits that were asked for, else those of the error bounds, else the arithmetic's."""
    if trajectory.digits is not None:
        return int(trajectory.digits)
    return int(trajectory.accuracy.digits if trajectory.bounded else trajectory.arithmetic.digits)


def word(mode: Any) -> str:
    """Return a mode of a line, or of a surface, as text."""
    return str(getattr(mode, "value", mode))


def _row(trajectory: Any, truth: Any, index: int) -> dict[str, Any]:
    """Return an event, or the end."""
    if index == AT_END:
        said = {"mode": word(trajectory.final_mode)}
    else:
        event = trajectory.events[index]
        said = {"from": word(event.before), "to": word(event.after)}
        said |= {"cause": event.cause} if trajectory.scene.is_forced else {}
    texts = _texts(trajectory, truth, index)
    return {name: one for name, one in texts.items() if name in {"t", "t_radius"}} | said | texts


def _texts(trajectory: Any, truth: Any, index: int) -> dict[str, Any]:
    """Return the numbers of an event, or of the end, by their names, as text; of balls with their radii."""
    names = ("t", *END_NAMES) if index == AT_END else ("t", *STATE, *trajectory.EVENT_COLUMNS)
    values = numbers_at(trajectory, index)
    if trajectory.arithmetic.name != "ball":
        most = MOST_DIGITS if trajectory.bounded else trajectory.arithmetic.digits
        errors = map(distance, values, numbers_at(truth, index)) if truth else bounds_at(trajectory, index)
        points = (arb(as_ball(one).mid(), error) for one, error in zip(values, errors, strict=False))
        return {name: point.str(most, radius=False) for name, point in zip(names, points, strict=False)}
    found, digits = dict[str, Any](), right_digits(trajectory)
    for name, value in zip(names, values, strict=False):
        if isinstance(value, tuple):
            parts = [with_radius(name, one, digits) for one in value]
            found |= {key: [part[key] for part in parts] for key in parts[0]}
        else:
            found |= with_radius(name, value, digits)
    return found


def as_csv(record: dict[str, Any]) -> str:
    """Return the events and the final state of a record as CSV text: the columns of the JSON records, with units."""
    final = {"from": record["final"]["mode"], "to": "", **record["final"]}
    rows = [{"from": "", "to": "", **by_axes(row)} for row in (*record["events"], final)]
    return table([{key: one for key, one in row.items() if key != "mode"} for row in rows])


def table(rows: list[dict[str, str]]) -> str:
    """Return rows as CSV text whose header has the units."""
    columns = list(dict.fromkeys(key for row in rows for key in row))
    buffer = io.StringIO()
    writer = csv.DictWriter(buffer, columns, restval="", lineterminator="\n")
    writer.writerow({name: f"{name} ({of})" if (of := unit(name)) and name != "from" else name for name in columns})
    writer.writerows(rows)
    return buffer.getvalue()


def by_axes(row: dict[str, Any]) -> dict[str, str]:
    """Return a row with a column for each axis of a list: x1_x, x1_y, x1_x_radius, ..."""
    found: dict[str, str] = {}
    for key, value in row.items():
        name = key.removesuffix("_radius")
        lists = zip(AXES, value, strict=False) if isinstance(value, list) else ()
        found |= {f"{name}_{axis}{key[len(name) :]}": one for axis, one in lists} or {key: value}
    return found


def _columns(trajectory: Any) -> dict[str, Any]:
    """Return time, mode, state (on a surface a column for each axis) and energies at `t`; the mode after an event."""
    asked, axes = trajectory.t_eval, AXES[: len(trajectory.y) // len(STATE)]
    modes = (*trajectory.modes, trajectory.final_mode) if asked is None else trajectory.mode_at(asked)
    names = [f"{name}_{axis}" for name in STATE for axis in axes] if len(axes) > 1 else STATE
    found = {"t": trajectory.t, "mode": [*map(word, modes)]} | dict(zip(names, trajectory.y, strict=True))
    return found | {name: getattr(trajectory, name) for name in trajectory.ENERGIES}


def at_times(trajectory: Any) -> list[dict[str, str]]:
    """Return time, mode, state and energy of a run in balls at the times t_eval, as decimal texts of right digits."""
    digits, columns = right_digits(trajectory), _columns(trajectory)
    columns["t"] = [decimal_text(exact_decimal(t, "t")) for t in trajectory.t_eval]
    columns.pop("energy_excess", None)
    with trajectory.context():
        for name, numbers in columns.items():
            columns[name] = [one if isinstance(one, str) else with_radius(name, one, digits)[name] for one in numbers]
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def arrays(trajectory: Any) -> dict[str, Array]:
    """Return t (m,), y (4, m), on a surface (4 n, m), energies (m,), modes and event_kinds; numbers in binary64."""
    found = {name: trajectory.floats(getattr(trajectory, name)) for name in ("t", "y", *trajectory.ENERGIES)}
    kinds = [kind.value for kind in trajectory.event_kinds]
    return found | {"modes": np.array([*map(word, trajectory.modes)]), "event_kinds": np.array(kinds, dtype=str)}


def write_npz(trajectory: Any, path: Path, extra: dict[str, Array] | None = None) -> None:
    """Write the `arrays` of a trajectory, and `extra` ones by their names, as a NumPy archive."""
    with whole_file(path) as file:
        np.savez(file, **arrays(trajectory), **(extra or {}))  # type: ignore[arg-type]


def dataframe(trajectory: Any) -> DataFrame:
    """Return what `_columns` has as a pandas DataFrame, in binary64; `.attrs["units"]`. Raises MissingTool."""
    columns = _columns(trajectory)
    floats = {name: one if name == "mode" else trajectory.floats(one) for name, one in columns.items()}
    frame: DataFrame = tool("pandas").DataFrame(floats)
    frame.attrs["units"] = {name: unit(name) for name in frame}
    return frame
