"""The engine: any scene, solved once in one arithmetic, as a Record.

float64 and double-double run the compiled kernel (kernel.py); balls and mpmath the loop of enclosed.py. Where the
kernel is in doubt the run starts again from what is known exactly: ties, touches, jumps that meet an event.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compiled
from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import EventUndecided, OutOfRange
from numerics.linear.exact_start import ExactKnot, exact_knots
from numerics.linear.kernel import NO_ROOM, TOO_MANY, follow
from numerics.linear.prepare import Prepared, halves, prepare
from numerics.linear.record import AT, END_ROW, ROW, How, Record, finish
from numerics.scene import Scene

Progress = Callable[[int, float], None]
_MOST_ORDER = 7
"""Derivatives of a guard that may vanish at an exact start (table.ORDERS less one)."""


def run_linear(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene once, at the arithmetic's working precision. Raises EventUndecided, OutOfRange."""
    if arithmetic.name in {"float64", "double-double"}:
        if scene.friction.weakening:
            raise OutOfRange('friction that depends on the state is solved in balls only; use arithmetic="ball"')
        return run_pairs(scene, wide=arithmetic.name == "double-double", max_events=max_events, progress=progress)
    from numerics.linear.enclosed import run_enclosed

    return run_enclosed(scene, arithmetic, max_events, progress)


@np.errstate(all="ignore")  # where nothing is compiled numpy's scalars warn of what the kernel itself looks for
def run_pairs(scene: Scene, *, wide: bool, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene in float64, or in double-double if `wide`. Raises EventUndecided, OutOfRange."""
    prepared = prepare(scene, wide=wide)
    how, rows, end = _run(prepared, prepared.start, prepared.is_decided, -1.0, max_events, wide=wide)
    if how == How.DOUBT:
        known = exact_knots(scene, prepared.pieces)
        if len(known) > 1 or known[-1].order > 0 or known[-1].quiet > known[-1].local:
            how, rows, end = _from_exact(prepared, known, max_events, wide=wide)
    _require_answer(how, prepared, end, wide=wide)
    if progress is not None:
        progress(int(end[AT["events"]]), 1.0)
    if not compiled(finish)(rows, end, *prepared.units):
        raise OutOfRange(f'a number of this scene is beyond the range of {_name(wide)}; use arithmetic="ball"')
    friction, viscous = float(end[AT["friction"]]), float(end[AT["viscous"]])
    return Record(
        rows, end, How(how), int(end[AT["events"]]), True, friction, viscous, float(end[AT["dissipated_error"]])
    )


def _run(
    prepared: Prepared, start: NDArray[np.float64], is_decided: bool, clear: float, most: int, *, wide: bool
) -> tuple[int, NDArray[np.float64], NDArray[np.float64]]:
    """Return how the kernel ended, its rows, and the row of the end."""
    run, room, end = compiled(follow), prepared.room, np.zeros(END_ROW)
    while True:
        rows = np.empty((room, ROW))
        pair, drive, tables = prepared.pair, prepared.drive, prepared.tables
        try:
            how, count = run(pair, drive, tables, start, is_decided, clear, most, wide, rows, end)
        except (ZeroDivisionError, OverflowError, ValueError):  # plain Python has no nan to carry on with
            return How.OUT_OF_RANGE, rows[:0], end
        if how != NO_ROOM:
            return how, rows[:count], end
        room *= 8


def _from_exact(
    prepared: Prepared, known: Sequence[ExactKnot], most: int, *, wide: bool
) -> tuple[int, NDArray[np.float64], NDArray[np.float64]]:
    """Return the run from the last start that is known exactly, the exact ones before it."""
    events = [index for index, one in enumerate(known) if one.is_event]
    if len(events) > most:
        rows = _exact_rows(prepared, known[: events[most - 1] + 1])
        end = np.zeros(END_ROW)
        end[:ROW], end[AT["how"]], end[AT["events"]], end[AT["certain"]] = rows[-1], How.EVENT_LIMIT, most, 1.0
        return How.EVENT_LIMIT, rows, end
    if known[-1].order > _MOST_ORDER and not known[-1].quiet > known[-1].local:
        return How.DOUBT, np.empty((0, ROW)), np.zeros(END_ROW)
    first, last = _exact_rows(prepared, known[:-1]), _exact_rows(prepared, known[-1:])[0]
    order, last[AT["order"]] = last[AT["order"]], min(last[AT["order"]], _MOST_ORDER)
    clear = halves(known[-1].quiet, prepared.units.time)[0]
    how, rows, end = _run(prepared, last, True, clear, most - len(events), wide=wide)
    if len(rows):
        rows[0, [AT["event"], AT["jump"], AT["order"]]] = known[-1].is_event, known[-1].is_jump, order
    if len(first) and len(rows):
        for number, one in enumerate(known[1:], start=1):
            (first if number < len(first) else rows)[number if number < len(first) else 0][
                AT["length"] : AT["length"] + 2
            ] = halves(_time(prepared, one) - _time(prepared, known[number - 1]), prepared.units.time)
    end[AT["events"]] += len(events)
    return how, np.concatenate([first, rows]), end


def _time(prepared: Prepared, knot: ExactKnot):  # type: ignore[no-untyped-def]
    return prepared.pieces[knot.piece].start + knot.local


def _exact_rows(prepared: Prepared, known: Sequence[ExactKnot]) -> NDArray[np.float64]:
    """Return the rows of starts that are known exactly, in the kernel's units."""
    rows, units = np.zeros((len(known), ROW)), prepared.units
    for row, one in zip(rows, known, strict=True):
        for name, value in (("mode", one.mode), ("order", one.order), ("piece", one.piece)):
            row[AT[name]] = value
        row[AT["event"]], row[AT["jump"]] = one.is_event, one.is_jump
        row[AT["local"] : AT["local"] + 2] = halves(one.local, units.time)
        speed = units.of(length=1, time=-1)
        for name, form, exponent in (
            ("x1", one.x1, units.length),
            ("v1", one.v1, speed),
            ("x2", one.x2, units.length),
            ("v2", one.v2, speed),
        ):
            row[AT[name] : AT[name] + 2] = halves(form.rounded(256), exponent)
        row[AT["excess"]] = row[AT["excess_low"]] = np.nan
    return rows


def _name(wide: bool) -> str:
    return "double-double" if wide else "float64"


def _require_answer(how: int, prepared: Prepared, end: NDArray[np.float64], *, wide: bool) -> None:
    """Raise what says why a run could not go on."""
    if how in {How.REACHED, How.STUCK, How.EVENT_LIMIT}:
        return
    if how == How.OUT_OF_RANGE:
        raise OutOfRange(f'a number of this scene left the range of {_name(wide)} on the way; use arithmetic="ball"')
    local = np.ldexp(end[AT["local"]], prepared.units.time)
    at = float(prepared.pieces[int(end[AT["piece"]])].start) + local
    if how == TOO_MANY:
        raise OutOfRange(
            f"the mode at t = {at:.6g} s would take more than 400000 steps; shorten the horizon, leave a fast sine "
            "out, or begin on the tie that it begins next to"
        )
    if how == How.DOUBT:
        raise EventUndecided(
            "which event comes next under this force, or does its guard only touch?",
            f"after t = {at:.6g} s",
            31 if wide else 15,
        )
