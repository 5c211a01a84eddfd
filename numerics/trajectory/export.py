"""A trajectory as JSON, CSV, NumPy archive or data frame. Files appear whole under their name or not at all.

On a surface every x1, v1, x2, v2 is a list by axes, and a table has a column for each axis.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import arb

from numerics.arithmetic.protocol import Number
from numerics.exits import tool
from numerics.files import whole_file
from numerics.scene.decimals import decimal_text, exact_decimal
from numerics.scene.plane import AXES
from numerics.trajectory.columns import STATE, Array
from numerics.trajectory.comparison import as_fraction, distance, require_same_sequence
from numerics.trajectory.rendering import MOST_DIGITS, right_digits_text, with_radius
from numerics.trajectory.units import unit

if TYPE_CHECKING:
    from pandas import DataFrame

END_NAMES = (*STATE, "energy", "energy_excess")
Written = dict[str, str]
Writer = Callable[[str, Number, int], Written]
"""Takes a name, a number, and the index of its event, or -1 for the end."""


def knows_its_digits(trajectory: Any) -> bool:
    """Return whether radii or error bounds say which digits of a trajectory are right."""
    if trajectory.arithmetic.name == "ball":
        return True
    return trajectory.accuracy is not None and bool(trajectory.accuracy.bounded)


def as_record(trajectory: Any, truth: Any = None, events: Iterable[int] | None = None) -> dict[str, Any]:
    """Return a trajectory as the JSON object of the interface: decimal strings of right digits, radii beside balls.

    `truth`, a solve of the same scene in balls, says which digits are right where no radius and no bound does. `events`
    are the indices of those that are wanted, all by default. Raises SequenceDiffers if the two sequences of events
    differ, so that no wrong itinerary is ever printed; ValueError if a truth is needed and none is given.
    """
    write = _writer(trajectory, truth)
    with trajectory.context():
        wanted = range(len(trajectory.events)) if events is None else events
        return {
            "status": trajectory.status.name.lower().replace("_", "-"),
            "message": trajectory.message,
            "arithmetic": trajectory.arithmetic.name,
            "digits": right_digits(trajectory),
            "events": [_event(trajectory, write, index) for index in wanted],
            "final": write("t", trajectory.end_time, -1)
            | {"mode": word(trajectory.final_mode)}
            | _numbers(write, zip(END_NAMES, trajectory.end_numbers(), strict=False), -1),
        }


def right_digits(trajectory: Any) -> int:
    """Return the right digits that were asked for, else those of the error bounds, else the arithmetic's."""
    if trajectory.digits is not None:
        return int(trajectory.digits)
    return int(trajectory.accuracy.digits if trajectory.bounded else trajectory.arithmetic.digits)


def word(mode: Any) -> str:
    """Return a mode of a line, or of a surface, as text."""
    return str(getattr(mode, "value", mode))


def _event(trajectory: Any, write: Writer, index: int) -> dict[str, Any]:
    event = trajectory.events[index]
    row = write("t", event.t, index) | {"from": word(event.before), "to": word(event.after)}
    if trajectory.scene.is_forced:
        row["cause"] = event.cause
    more = ((name, getattr(event, name)) for name in trajectory.EVENT_COLUMNS)
    return row | _numbers(write, (*zip(STATE, event.y, strict=True), *more), index)


def _numbers(write: Writer, named: Iterable[tuple[str, Any]], index: int) -> dict[str, Any]:
    """Return numbers as text; a tuple by axes as lists."""
    found: dict[str, Any] = {}
    for name, value in named:
        if isinstance(value, tuple):
            rows = [write(name, one, index) for one in value]
            found |= {key: [row[key] for row in rows] for key in rows[0]}
        else:
            found |= write(name, value, index)
    return found


def _writer(trajectory: Any, truth: Any) -> Writer:
    """Return a writer that cuts each number by its error bound, or where it parts from the true one."""
    arithmetic, digits = trajectory.arithmetic, right_digits(trajectory)
    if arithmetic.name == "ball":
        return lambda name, value, _: with_radius(name, value, digits)
    most, given = MOST_DIGITS if arithmetic.name == "float64" else arithmetic.digits, truth or trajectory
    if truth is not None:
        require_same_sequence(trajectory, truth)
        with truth.context():
            by_event, final = (truth.event_times, *truth.event_states), (truth.end_time, *truth.end_numbers())
    elif not knows_its_digits(trajectory):
        raise ValueError(
            f"the number of right digits of this trajectory in {arithmetic.name} is not known; "
            "give `truth`, a solve of the same scene in balls"
        )
    else:
        by_event, final = (trajectory.accuracy.t, *trajectory.accuracy.y.T), trajectory.end_bounds()

    def write(name: str, value: Number, index: int) -> Written:
        with given.context():
            if isinstance(value, arb):
                shown = float(value.mid())
                error = distance(shown, value).upper()
            else:
                shown, place = value, ("t", *END_NAMES).index(name)
                known = final[place] if index < 0 else by_event[place][index]
                error = arb(float(known)) if truth is None else distance(value, known)
            return {name: right_digits_text(as_fraction(shown), error, most)}

    return write


def as_csv(record: dict[str, Any]) -> str:
    """Return the events and the final state of a record as CSV text: the columns of the JSON records, with units."""
    final = {"from": record["final"]["mode"], "to": "", **record["final"]}
    rows = [{"from": "", "to": "", **_by_axes(row)} for row in (*record["events"], final)]
    return table([{key: one for key, one in row.items() if key != "mode"} for row in rows])


def table(rows: list[dict[str, str]]) -> str:
    """Return rows as CSV text whose header has the units."""
    columns = list(dict.fromkeys(key for row in rows for key in row))
    buffer = io.StringIO()
    writer = csv.DictWriter(buffer, columns, restval="", lineterminator="\n")
    writer.writerow({name: f"{name} ({of})" if (of := unit(name)) and name != "from" else name for name in columns})
    writer.writerows(rows)
    return buffer.getvalue()


def _by_axes(row: dict[str, Any]) -> dict[str, str]:
    """Return a row with a column for each axis of a list: x1_x, x1_y, x1_x_radius, ..."""
    found: dict[str, str] = {}
    for key, value in row.items():
        name = key.removesuffix("_radius")
        lists = zip(AXES, value, strict=False) if isinstance(value, list) else ()
        found |= {f"{name}_{axis}{key[len(name) :]}": one for axis, one in lists} or {key: value}
    return found


def at_times(trajectory: Any) -> list[dict[str, str]]:
    """Return time, mode, state and energy of a run in balls at the times t_eval, as decimal texts of right digits."""
    names, digits, times = [*_state_names(len(trajectory.y)), "energy"], right_digits(trajectory), trajectory.t_eval
    rows = []
    with trajectory.context():
        for t, mode, *numbers in zip(times, trajectory.mode_at(times), *trajectory.y, trajectory.energy, strict=True):
            row = {"t": decimal_text(exact_decimal(t, "t")), "mode": word(mode)}
            row |= {name: with_radius(name, x, digits)[name] for name, x in zip(names, numbers, strict=True)}
            rows.append(row)
    return rows


def _state_names(rows: int) -> list[str]:
    """Return the names of the rows of y: on a surface one for each axis."""
    axes = AXES[: rows // len(STATE)]
    return [f"{name}_{axis}" for name in STATE for axis in axes] if len(axes) > 1 else [*STATE]


def arrays(trajectory: Any) -> dict[str, Array]:
    """Return t (m,), y (4, m), on a surface (4 n, m), energy (m,), modes and event_kinds; numbers in binary64.

    On a line energy_excess (m,), on a surface bounds t_error and y_error.
    """
    with trajectory.context():
        found = {name: trajectory.floats(getattr(trajectory, name)) for name in trajectory.COLUMNS}
    kinds = [kind.value for kind in trajectory.event_kinds]
    return found | {"modes": np.array([*map(word, trajectory.modes)]), "event_kinds": np.array(kinds, dtype=str)}


def write_npz(trajectory: Any, path: Path, extra: dict[str, Array] | None = None) -> None:
    """Write the `arrays` of a trajectory, and `extra` ones by their names, as a NumPy archive."""
    with whole_file(path) as file:
        np.savez(file, **arrays(trajectory), **(extra or {}))  # type: ignore[arg-type]


def dataframe(trajectory: Any) -> DataFrame:
    """Return t, mode, the state (a column for each axis) and energies at `t` as a pandas DataFrame, in binary64.

    The mode at an event is the one after it. `.attrs["units"]` has the units. Raises MissingTool.
    """
    asked, found = trajectory.t_eval, arrays(trajectory)
    modes = [*trajectory.modes, trajectory.final_mode] if asked is None else trajectory.mode_at(asked)
    state = zip(_state_names(len(found["y"])), found["y"], strict=True)
    columns = {"t": found["t"], "mode": [*map(word, modes)], **dict(state)}
    frame: DataFrame = tool("pandas").DataFrame(
        columns | {name: found[name] for name in ("energy", "energy_excess") if name in found}
    )
    frame.attrs["units"] = {name: unit(name) for name in frame}
    return frame
