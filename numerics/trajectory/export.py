"""A trajectory as JSON, CSV or NumPy archive. Files appear whole under their name or not at all."""

from __future__ import annotations

import csv
import io
import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number
from numerics.solver.solve import solve
from numerics.trajectory.accuracy import rounding_of
from numerics.trajectory.comparison import as_fraction, distance, require_same_sequence
from numerics.trajectory.rendering import ball_text, right_digits_text
from numerics.trajectory.trajectory import Trajectory

STATE_NAMES = ("x1", "v1", "x2", "v2")
Written = dict[str, str]


def as_record(trajectory: Trajectory) -> dict[str, Any]:
    """Return a trajectory as the JSON object of the interface: decimal strings of right digits, radii beside balls.

    For float64 and mpmath the right digits are found by solving once more in balls; raises SequenceDiffers if the
    two event sequences differ, so that no wrong itinerary is ever printed.
    """
    write = _ball_writer(trajectory) if trajectory.arithmetic.name == "ball" else _point_writer(trajectory)
    rows = list(_rows(trajectory, write))
    return {
        "status": trajectory.status.name.lower().replace("_", "-"),
        "message": trajectory.message,
        "arithmetic": trajectory.arithmetic.name,
        "digits": _digits(trajectory),
        "events": rows[:-1],
        "final": rows[-1],
    }


def _digits(trajectory: Trajectory) -> int:
    """Return the right digits that were asked for, else those of the error bounds, else the arithmetic's."""
    if trajectory.digits is not None:
        return trajectory.digits
    return trajectory.arithmetic.digits if trajectory.accuracy is None else trajectory.accuracy.digits


def _rows(trajectory: Trajectory, write: Callable[[str, Number, int], Written]) -> Iterator[dict[str, str]]:
    """Yield one record an event, and then the final state's."""
    with trajectory.arithmetic.context():
        for index, event in enumerate(trajectory.events):
            row = write("t", event.t, index)
            row |= {"from": event.before.value, "to": event.after.value}
            for name, value in zip(STATE_NAMES, event.y, strict=True):
                row |= write(name, value, index)
            yield row
        final = trajectory.final
        last = trajectory.segments[-1]
        row = write("t", trajectory.frame.si_time(last.end), -1) | {"mode": trajectory.final_mode.value}
        values = (*trajectory.frame.si_state(final), trajectory.frame.energy(final), final.w)
        for name, value in zip((*STATE_NAMES, "energy", "energy_excess"), values, strict=True):
            row |= write(name, value, -1)
        yield row


def _ball_writer(trajectory: Trajectory) -> Callable[[str, Number, int], Written]:
    digits = trajectory.digits or trajectory.arithmetic.digits

    def write(name: str, value: Number, index: int) -> Written:  # noqa: ARG001
        text, radius = ball_text(value, digits)
        return {name: text, f"{name}_radius": radius}

    return write


def _point_writer(trajectory: Trajectory) -> Callable[[str, Number, int], Written]:
    """Return a writer that cuts each number by its error bound, or where it parts from balls if it has none."""
    accuracy = trajectory.accuracy
    if accuracy is None or not accuracy.bounded:
        return _compared_writer(trajectory)
    events = [dict(zip(("t", *STATE_NAMES), (t, *y), strict=True)) for t, y in zip(accuracy.t, accuracy.y, strict=True)]
    final = (0.0, *accuracy.final, accuracy.energy, accuracy.energy_excess)
    rows = [*events, dict(zip(("t", *STATE_NAMES, "energy", "energy_excess"), final, strict=True))]
    rounding, most = rounding_of(trajectory)

    def write(name: str, value: Number, index: int) -> Written:
        if index < 0 and name == "t":
            error = 0.0 if trajectory.success else float(accuracy.t[-1])
            return {name: right_digits_text(as_fraction(value), arb(error + abs(float(value)) * 4 * rounding), most)}
        return {name: right_digits_text(as_fraction(value), arb(float(rows[index][name])), most)}

    return write


def _compared_writer(trajectory: Trajectory) -> Callable[[str, Number, int], Written]:
    """Return a writer that cuts each number where it parts from a ball solve of the same scene."""
    digits = 17 if trajectory.arithmetic.name == "float64" else trajectory.arithmetic.digits
    # one event more than were found shows a lost one; a run that was cut off is cut off at the same event
    limit = len(trajectory.events) + (1 if trajectory.success else 0)
    balls = solve(trajectory.scene, digits=digits + 3, arithmetic="ball", max_events=limit)
    require_same_sequence(trajectory, balls)
    with balls.arithmetic.context():
        rows = [dict(zip(("t", *STATE_NAMES), (event.t, *event.y), strict=True)) for event in balls.events]
        final, frame = balls.final, balls.frame
        values = (frame.si_time(balls.segments[-1].end), *frame.si_state(final), frame.energy(final), final.w)
        rows.append(dict(zip(("t", *STATE_NAMES, "energy", "energy_excess"), values, strict=True)))

    def write(name: str, value: Number, index: int) -> Written:
        with balls.arithmetic.context():
            return {name: right_digits_text(as_fraction(value), distance(value, rows[index][name]), digits)}

    return write


def as_csv(trajectory: Trajectory) -> str:
    """Return the events and the final state as CSV text, the columns of the JSON records."""
    record = as_record(trajectory)
    rows = [{"from": "", "to": "", **event} for event in record["events"]]
    last = dict(record["final"])
    rows.append({"from": last.pop("mode"), "to": "", **last})
    columns = list(dict.fromkeys(key for row in rows for key in row))
    buffer = io.StringIO()
    writer = csv.DictWriter(buffer, columns, restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return buffer.getvalue()


def write_npz(trajectory: Trajectory, path: Path, extra: dict[str, NDArray[Any]] | None = None) -> None:
    """Write t (m,), y (4, m), energy and energy_excess (m,), modes and event_kinds as a NumPy archive (binary64).

    `extra` holds more arrays by their names.
    """
    number = trajectory.arithmetic.to_float
    with trajectory.arithmetic.context(), whole_file(path) as file:
        np.savez(
            file,
            t=np.vectorize(number, otypes=[float])(trajectory.t),
            y=np.vectorize(number, otypes=[float])(trajectory.y),
            energy=np.vectorize(number, otypes=[float])(trajectory.energy),
            energy_excess=np.array(
                [number(one.motion.state(trajectory.arithmetic.number(0)).w) for one in trajectory.segments]
                + [number(trajectory.final.w)]
            ),
            modes=np.array([mode.value for mode in trajectory.modes]),
            event_kinds=np.array([kind.value for kind in trajectory.event_kinds], dtype=str),
            **(extra or {}),  # type: ignore[arg-type]
        )


@contextmanager
def whole_file(path: Path) -> Iterator[Any]:
    """Open a binary file that takes its name only when the block ends well; otherwise nothing is left behind."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as file:
            yield file
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise
