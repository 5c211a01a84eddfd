"""A trajectory as JSON, CSV, NumPy archive or data frame. Files appear whole under their name or not at all."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number
from numerics.errors import MissingTool
from numerics.files import whole_file
from numerics.trajectory.comparison import as_fraction, distance, require_same_sequence
from numerics.trajectory.digits import MOST_DIGITS, ROUNDING
from numerics.trajectory.rendering import right_digits_text, with_radius
from numerics.trajectory.rows import STATE
from numerics.trajectory.solution import Solution

END_NAMES = (*STATE, "energy", "energy_excess")
Written = dict[str, str]
Writer = Callable[[str, Number, int], Written]
"""Takes a name, a number, and the index of its event, or -1 for the end."""


def knows_its_digits(trajectory: Solution) -> bool:
    """Return whether radii or error bounds say which digits of a trajectory are right."""
    if trajectory.arithmetic.name == "ball":
        return True
    return trajectory.accuracy is not None and trajectory.accuracy.bounded


def as_record(trajectory: Solution, truth: Any = None, events: Iterable[int] | None = None) -> dict[str, Any]:
    """Return a trajectory as the JSON object of the interface: decimal strings of right digits, radii beside balls.

    `truth`, a solve of the same scene in balls, says which digits are right where no radius and no bound does. `events`
    are the indices of those that are wanted, all by default. Raises SequenceDiffers if the two sequences of events
    differ, so that no wrong itinerary is ever printed; ValueError if a truth is needed and none is given.
    """
    write = _writer(trajectory, truth)
    with trajectory.arithmetic.context():
        return {
            "status": trajectory.status.name.lower().replace("_", "-"),
            "message": trajectory.message,
            "arithmetic": trajectory.arithmetic.name,
            "digits": right_digits(trajectory),
            "events": list(_events(trajectory, write, events)),
            "final": _final(trajectory, write),
        }


def right_digits(trajectory: Solution) -> int:
    """Return the right digits that were asked for, else those of the error bounds, else the arithmetic's."""
    if trajectory.digits is not None:
        return trajectory.digits
    return trajectory.arithmetic.digits if trajectory.accuracy is None else trajectory.accuracy.digits


def _events(trajectory: Solution, write: Writer, wanted: Iterable[int] | None) -> Iterator[Written]:
    for index in range(trajectory.record.events) if wanted is None else wanted:
        event = trajectory.events[index]
        row = write("t", event.t, index) | {"from": event.before.value, "to": event.after.value}
        if trajectory.scene.is_forced:
            row["cause"] = event.cause
        for name, value in zip(STATE, event.y, strict=True):
            row |= write(name, value, index)
        yield row


def _final(trajectory: Solution, write: Writer) -> Written:
    row = write("t", trajectory.end_time, -1) | {"mode": trajectory.final_mode.value}
    for name, value in zip(END_NAMES, _end_values(trajectory), strict=True):
        row |= write(name, value, -1)
    return row


def _end_values(trajectory: Solution) -> tuple[Number, ...]:
    return *trajectory.final_state, trajectory.final_energy, trajectory.final.w


def _writer(trajectory: Solution, truth: Any) -> Writer:
    """Return a writer that cuts each number by its error bound, or where it parts from the true one."""
    name_of, arithmetic = trajectory.arithmetic.name, trajectory.arithmetic
    if name_of == "ball":
        return lambda name, value, _: with_radius(name, value, trajectory.digits or arithmetic.digits)
    final: tuple[Any, ...]
    if truth is not None:
        require_same_sequence(trajectory, truth)
        times, states = truth.event_times, truth.event_states
        with truth.arithmetic.context():
            final = truth.end_time, *_end_values(truth)
    elif knows_its_digits(trajectory) and (accuracy := trajectory.accuracy) is not None:
        times, states = accuracy.t, accuracy.y.T
        last = 0.0 if trajectory.reached else float(times[-1])
        late = last + abs(float(trajectory.end_time)) * 4 * ROUNDING[name_of]
        final = late, *accuracy.final, accuracy.energy, accuracy.energy_excess
    else:
        raise ValueError(
            f"this trajectory in {name_of} does not know which of its digits are right; "
            "give `truth`, a solve of the same scene in balls"
        )
    at_events, most = (times, *states), MOST_DIGITS.get(name_of, arithmetic.digits)

    def write(name: str, value: Number, index: int) -> Written:
        place = ("t", *END_NAMES).index(name)
        given = final[place] if index < 0 else at_events[place][index]
        with (truth or trajectory).arithmetic.context():
            error = arb(float(given)) if truth is None else distance(value, given)
            return {name: right_digits_text(as_fraction(value), error, most)}

    return write


def unit_of(column: str) -> str:
    """Return the SI unit of a column of a record, or of its radius; none for modes and what is dimensionless."""
    return {"t": "s", "x1": "m", "v1": "m/s", "x2": "m", "v2": "m/s", "energy": "J"}.get(
        column.removesuffix("_radius"), ""
    )


def as_csv(record: dict[str, Any], unit_of: Callable[[str], str] = unit_of) -> str:
    """Return the events and the final state of a record as CSV text: the columns of the JSON records, with units."""
    rows = [{"from": "", "to": "", **event} for event in record["events"]]
    last = dict(record["final"])
    rows.append({"from": last.pop("mode"), "to": "", **last})
    columns = list(dict.fromkeys(key for row in rows for key in row))
    buffer = io.StringIO()
    writer = csv.DictWriter(buffer, columns, restval="", lineterminator="\n")
    writer.writerow({name: f"{name} ({unit})" if (unit := unit_of(name)) else name for name in columns})
    writer.writerows(rows)
    return buffer.getvalue()


def arrays(trajectory: Solution) -> dict[str, NDArray[Any]]:
    """Return t (m,), y (4, m), energy and energy_excess (m,), modes and event_kinds; numbers in binary64."""
    with trajectory.arithmetic.context():
        number = trajectory.floats
        return {
            "t": number(trajectory.t),
            "y": number(trajectory.y),
            "energy": number(trajectory.energy),
            "energy_excess": number(_excess(trajectory)),
            "modes": np.array([mode.value for mode in trajectory.modes]),
            "event_kinds": np.array([kind.value for kind in trajectory.event_kinds], dtype=str),
        }


def _excess(trajectory: Solution) -> NDArray[Any]:
    """Return E/E_cr - 1 at `t`."""
    if trajectory.t_eval is not None:
        found = [trajectory.reduced(one).w for one in trajectory.t]
    else:
        end = [trajectory.final.w] if trajectory.reached else []
        found = [trajectory.initial.w, *(event.reduced.w for event in trajectory.events), *end]
    return np.array(found, dtype=object)


def write_npz(trajectory: Solution, path: Path, extra: dict[str, NDArray[Any]] | None = None) -> None:
    """Write the `arrays` of a trajectory, and `extra` ones by their names, as a NumPy archive."""
    write_arrays(arrays(trajectory) | (extra or {}), path)


def write_arrays(found: dict[str, NDArray[Any]], path: Path) -> None:
    """Write arrays by their names as a NumPy archive."""
    with whole_file(path) as file:
        np.savez(file, **found)  # type: ignore[arg-type]


def dataframe(trajectory: Solution) -> Any:
    """Return t, mode, x1, v1, x2, v2, energy and energy_excess at `t` as a pandas DataFrame, numbers in binary64.

    The mode at an event is the one after it. Raises MissingTool.
    """
    if trajectory.t_eval is None:
        modes = [*trajectory.modes, trajectory.final_mode]
    else:
        modes = list(trajectory.mode_at(trajectory.t_eval))
    found = arrays(trajectory)
    state = dict(zip(STATE, found["y"], strict=True))
    return frame_of(
        {"t": found["t"], "mode": [mode.value for mode in modes], **state}
        | {name: found[name] for name in ("energy", "energy_excess")}
    )


def frame_of(columns: dict[str, Any]) -> Any:
    """Return columns as a pandas DataFrame. Raises MissingTool."""
    try:
        import pandas as pd
    except ImportError:
        raise MissingTool("a data frame needs pandas, which is not installed; use t, y and energy") from None
    return pd.DataFrame(columns)
