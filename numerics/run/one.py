"""One scene, solved once in one arithmetic: the loop is told, interpreted or compiled; its record is a Trajectory."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.double_double import nearest
from numerics.arithmetic.double_numbers import DoubleDouble
from numerics.arithmetic.double_words import DOUBLE_DOUBLE
from numerics.arithmetic.float64 import FLOAT64, Float64
from numerics.arithmetic.protocol import Arithmetic
from numerics.arithmetic.questions import QUESTIONS, SIDE_OF_ZERO
from numerics.arithmetic.telling import can_compile, compiles_now
from numerics.errors import EventUndecided, OutOfRange
from numerics.motion.begin import begin, in_halves, si_numbers
from numerics.motion.codes import OUT_OF_RANGE
from numerics.motion.start import SI
from numerics.run.families import has_bounds, run_telling
from numerics.run.row import solve_row, solve_start
from numerics.run.rows import Growing
from numerics.scene import Law, Scene
from numerics.trajectory.record import CODES, NUMBERS, Record, end_length, row_length
from numerics.trajectory.trajectory import Trajectory

MAX_EVENTS = 250_000
Progress = Callable[[int, float], None]
_FEW = 256
"""numba takes a second to come: so many events are left to Python first."""
_EVENTS_PER_TURN = 3.0
"""Events that a half turn of body 1 alone is given room for at first; with more the run is made again."""
_FLOAT64, _DOUBLE = Float64(), DoubleDouble()


def run_scene(
    scene: Scene, arithmetic: Arithmetic, max_events: int = MAX_EVENTS, progress: Progress | None = None
) -> Trajectory:
    """Solve a scene once, in one arithmetic at its working precision. Raises EventUndecided, OutOfRange."""
    if scene.is_forced:
        from numerics.run.forced import run_forced_scene

        return run_forced_scene(scene, arithmetic, max_events, progress)
    if arithmetic.name == "float64" and arithmetic.telling is FLOAT64:
        return run_float64(scene, max_events, progress)
    if arithmetic.name == "double-double":
        return run_double_double(scene, max_events, progress)
    is_damped = scene.pair.a1 > 0
    with arithmetic.context():
        begun = begin(scene, arithmetic)
        horizon = begun.reduced.horizon
        rows = Growing(row_length(1), max_events, _told(arithmetic, horizon, progress))
        end = [0.0] * end_length(1)
        run_telling(arithmetic.telling, is_damped=is_damped)(solve_start)(*begun, max_events, rows, end)
    if end[0] == OUT_OF_RANGE:
        raise left_range(arithmetic, is_damped)
    return Trajectory(scene, arithmetic, Record(rows.rows, end, 1), bounded=False)


def run_float64(scene: Scene, max_events: int, progress: Progress | None = None) -> Trajectory:
    """Solve a scene in binary64 with its error bounds, compiled where numba is installed."""
    telling = run_telling(FLOAT64, is_damped=scene.pair.a1 > 0)
    end, literal = np.empty(end_length(1)), scene.law is Law.THREE_VALUED_SGN
    if worth_compiling() and (row := scene_row(scene)) is not None:
        rows = np.empty((_room(row, max_events), row_length(1)))
        count = telling.compiled(solve_row)(row, literal, max_events, rows, end)
        if count > len(rows):
            rows = np.empty((count, row_length(1)))
            count = telling.compiled(solve_row)(row, literal, max_events, rows, end)
        if count >= 0:
            return _floats(scene, rows[:count], end, progress)
    begun = begin(scene, _FLOAT64)
    return _floats(scene, *_from_start(telling, begun, 1, max_events, (scene, progress)), progress)


_SEEN = [0]
"""How many scenes were solved in float64 so far."""
_MANY = 200
"""So many short runs cost Python what it takes numba to come."""


def worth_compiling() -> bool:
    """Return whether compiled code is at hand, or there have been so many runs that it is worth the wait."""
    _SEEN[0] += 1
    return compiles_now() or (_SEEN[0] > _MANY and can_compile())


def run_double_double(scene: Scene, max_events: int, progress: Progress | None = None) -> Trajectory:
    """Solve a scene in double-double, with error bounds for a1 = 0. Raises OutOfRange."""
    is_damped = scene.pair.a1 > 0
    telling = run_telling(DOUBLE_DOUBLE, is_damped=is_damped)
    with _DOUBLE.context():
        begun = in_halves(begin(scene, _DOUBLE), _DOUBLE.halves)
    rows, end = _from_start(telling, begun, 2, max_events, (scene, progress))
    if end[0] == OUT_OF_RANGE:
        raise left_range(_DOUBLE, is_damped)
    return Trajectory(scene, _DOUBLE, Record(rows, end, 2), bounded=has_bounds("double-double", is_damped=is_damped))


def _from_start(
    telling: Any, begun: Any, width: int, max_events: int, asked: tuple[Scene, Progress | None]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the rows of a run from a start: a short one by Python, which would wait for numba longer than it runs."""
    length, end = row_length(width), np.empty(end_length(width))
    if not compiles_now():
        few = min(_FEW, max_events) if can_compile() else max_events
        told = None if asked[1] is None else _told(_FLOAT64, float(asked[0].until), asked[1])
        growing, plain = Growing(length, few, told), end.tolist()
        try:
            count = telling(solve_start)(*begun, few, growing, plain)
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            end[0] = OUT_OF_RANGE
            return np.empty((0, length)), end
        if count < few or few == max_events:
            return np.array(growing.rows).reshape(count, length), np.array(plain)
    rows = np.empty((min(max_events, 4 * _FEW), length))
    while (count := telling.compiled(solve_start)(*begun, max_events, rows, end)) > len(rows):
        rows = np.empty((count, length))
    return rows[:count], end


def _floats(scene: Scene, rows: Any, end: Any, progress: Progress | None) -> Trajectory:
    """Return the trajectory of a run in binary64; raises OutOfRange."""
    if end[0] == OUT_OF_RANGE:
        raise left_range(_FLOAT64, scene.pair.a1 > 0)
    if progress is not None:
        progress(len(rows), 1.0)
    return Trajectory(scene, _FLOAT64, Record(rows, end, 1), bounded=True)


def left_range(arithmetic: Arithmetic, is_damped: bool) -> Exception:
    """Return what says that a number left the range, or that balls know nothing of one any more."""
    if arithmetic.name == "ball" and not is_damped:
        return EventUndecided(QUESTIONS[SIDE_OF_ZERO], "a number that is not finite", arithmetic.digits)
    many = (
        "; or one slip lasts more than 100000 half oscillations: make |v1 - v2| smaller, or a1 = 0" if is_damped else ""
    )
    if arithmetic.name == "ball":
        return OutOfRange(f"the oscillation of one slip is beyond what is inspected{many}")
    return OutOfRange(
        f"a number of this scene left the range of {arithmetic.name} on the way, or one slip turns through an angle "
        f'that {arithmetic.digits} digits do not resolve; use arithmetic="ball"{many}'
    )


def _told(arithmetic: Arithmetic, horizon: Any, progress: Progress | None) -> Callable[[int, Any], None] | None:
    """Return what hears of a thousandth row."""
    if progress is None:
        return None
    tau = len(CODES) + NUMBERS.index("tau")
    return lambda index, row: progress(index, arithmetic.to_float(row[tau] / horizon))


def scene_row(scene: Scene) -> NDArray[np.float64] | None:
    """Return a scene as compiled code reads it, ten SI numbers as high and low halves; None if it must be exact.

    It is made once and kept with the scene.
    """
    if scene.row is None:
        object.__setattr__(scene, "row", (halved(si_numbers(scene)),))
    return scene.row[0]


def halved(si: SI) -> NDArray[np.float64] | None:
    """Return SI numbers as halves; None where those would make two velocities equal that are not, or overflow."""
    try:
        halves = [half for number in si for half in nearest(number)]
    except OverflowError:
        return None
    same = halves[10:12] == halves[14:16]
    return np.array(halves) if same == (si.v1 == si.v2) else None


def _room(row: NDArray[np.float64], max_events: int) -> int:
    """Return for how many events there should be room, at a guess: pair, horizon and share of the mass say it."""
    m1, a2, until = row[0], row[4], row[16]
    turns = until * math.sqrt(a2 / m1) / math.pi
    return int(min(max_events, 16 + _EVENTS_PER_TURN * min(turns, 1e6)))
