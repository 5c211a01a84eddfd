"""Scenes with a force in a batch: each is solved as `solve` does, and told in the rows of a batch."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.float64 import FLOAT64
from numerics.arithmetic.telling import can_compile
from numerics.errors import EventUndecided, OutOfRange
from numerics.flows.forced_work import integrals
from numerics.motion.codes import EVENT_LIMIT, OUT_OF_RANGE, REACHED
from numerics.run.forced_loop import run_forced
from numerics.run.forced_sharp import run_forced_sharply
from numerics.scene import Scene
from numerics.trajectory.forced import ForcedTrajectory
from numerics.trajectory.forced_accuracy import dissipated_of
from numerics.trajectory.record import CODES, END_CODES, END_NUMBERS, NUMBERS

Table = NDArray[np.float64]
_WORTH_COMPILING = 100
"""So many scenes cost Python what it takes numba to come."""


def solve_forced(
    scenes: Sequence[Scene], max_events: int, ends: Table, kept: Table, told: Callable[[int], None]
) -> None:
    """Solve scenes with a force in binary64 and write their ends and first events (trajectory/record.py).

    The units of these rows are those of SI. A run in doubt is one whose bounds leave the sequence of events open.
    """
    if len(scenes) >= _WORTH_COMPILING and can_compile():
        FLOAT64.compiled(run_forced)
        FLOAT64.compiled(integrals)
    for index, scene in enumerate(scenes):
        try:
            found = run_forced_sharply(scene, max_events)
        except (EventUndecided, OutOfRange) as error:
            ends[index] = np.nan
            _put(ends[index], END_CODES, {"how": OUT_OF_RANGE if isinstance(error, OutOfRange) else REACHED})
            _put(ends[index], END_CODES, dict.fromkeys(("events", "mode", "first_mode", "certain", "digits"), 0.0))
        else:
            _write(found, ends[index], kept[index])
        told(1)


def _write(found: ForcedTrajectory, end: Table, kept: Table) -> None:
    """Write a trajectory's end and as many events as there is room for."""
    bounds, final = found.accuracy, found.final_state
    assert bounds is not None  # binary64 has bounds
    x1, v1, x2, v2 = (float(one) for one in final)
    off = dict(zip(("x_error", "v1_error", "place_error", "v2_error"), bounds.final, strict=True))
    off["place_error"] = max(0.0, off["place_error"] - off["x_error"])  # of x1 - x2, as the batch reads it
    codes = {"how": found.record.how if found.reached else EVENT_LIMIT, "events": len(found.knots), "certain": 1.0}
    codes |= {"mode": found.signs[-1], "first_mode": found.signs[0], "digits": bounds.digits, **off}
    (spent, spent_error), unit = _dissipated(found), float(found.units[2])
    codes |= {"w_error": bounds.energy_excess, "spent_error": spent_error / unit, "damped_error": 0.0}
    _put(end, END_CODES, codes)
    at_start = found.scene.initial
    numbers = {"tau": float(found.end_time), "length": 0.0, "X": x1, "V1": v1, "V2": v2, "Z": x1 - x2}
    numbers |= {"w": float(found.final.w), "spent": spent / unit, "damped": 0.0, "X0": float(at_start.x1)}
    numbers |= {"V10": float(at_start.v1), "V20": float(at_start.v2), "Z0": float(at_start.x1 - at_start.x2)}
    numbers |= {"w0": float(found.initial.w), "length_unit": 1.0, "rate": 1.0, "energy_unit": unit}
    _put(end, END_NUMBERS, numbers, len(END_CODES))
    for index in range(min(len(kept), len(found.knots))):
        event, (x_off, v_off, x2_off, _) = found.events[index], bounds.y[index]
        codes = {"mode": event.after.sign, "late": float(bounds.t[index]), "x": x_off, "v": v_off}
        codes |= {"kind": 0.0, "side": 0.0, "place": max(0.0, x2_off - x_off), "relative": 0.0}
        _put(kept[index], CODES, codes)
        x1, v1, x2, _ = event.y
        numbers = {"tau": event.t, "length": 0.0, "X": x1, "V": v1, "Z": x1 - x2, "w": event.reduced.w}
        _put(kept[index], NUMBERS, numbers | {"gap": 0.0, "push": 0.0}, len(CODES))


def _dissipated(found: ForcedTrajectory) -> tuple[float, float]:
    """Return what friction and viscosity took, J, and a bound on its error; nan for a motion too stiff to integrate."""
    try:
        return dissipated_of(found)
    except OutOfRange:
        return np.nan, np.nan


def _put(row: Table, names: tuple[str, ...], values: dict[str, Any], first: int = 0) -> None:
    """Write values to the columns of their names."""
    for name, value in values.items():
        row[first + names.index(name)] = value
