"""Many scenes at once: arrays in, arrays out, on all cores, in memory bounded by the arrays themselves.

Every scene runs through the same float64 kernels as `solve` (kernel/), compiled where numba is installed, with the same
bits, the same certified first events and the same error bounds. Python only hands out chunks of rows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from numerics.batch.chunk import ANSWERS, EVENTS, ROW_ORDER, Solved, solve_exact, solve_table
from numerics.batch.parallel import available_cores, run_tasks
from numerics.errors import InvalidScene
from numerics.kernel.bounds import ULP
from numerics.kernel.compilation import can_compile
from numerics.kernel.state import EVENT_LIMIT, OUT_OF_RANGE, REACHED, STUCK
from numerics.scene import Law, Scene, read_law
from numerics.solver.solve import MAX_EVENTS, require_whole

_POSITIVE = ("m1", "m2", "a2", "b", "until")
_CHUNK = 4096
"""Scenes in a chunk at most: their rows fit into a core's cache."""
_TINY = 2.0**-1060
"""More than products with SI units can lose below the normal numbers."""
ENDINGS = {
    REACHED: "reached the horizon",
    STUCK: "reached the horizon; the pair has stuck for ever",
    EVENT_LIMIT: "stopped at the cap on events before the horizon; raise max_events",
    OUT_OF_RANGE: "left the range of float64; use solve(scene, digits=...)",
}
"""What the codes in Batch.status say."""
Progress = Callable[[int, int], None]
Table = NDArray[np.float64]


@dataclass(frozen=True)
class Batch:
    """The ends of many runs; every array has the broadcast shape of the inputs, `y` and `y_error` (4, ...) in front.

    status         a key of ENDINGS               events    how many there were
    mode           -1, 0, +1: sign of v1 - v2     t         s, the horizon or the last event
    y              x1, v1, x2, v2 (m, m/s)        energy_excess   E/E_cr - 1, accurate in itself
    dissipated     J, the sum of what friction and viscosity took in every mode, which never cancels
    *_error        bounds on the errors of these  digits    right digits of every event and of the end, by the bounds
    certain        whether no bound reaches as far as another sequence of events
    event_t, event_y, event_mode   the first `keep_events` events: (..., k), (4, ..., k), (..., k); nan and 0 beyond
    event_t_error, event_y_error   bounds on their errors
    """

    status: NDArray[np.int64]
    events: NDArray[np.int64]
    mode: NDArray[np.int64]
    t: Table
    y: Table
    energy_excess: Table
    dissipated: Table
    y_error: Table
    energy_excess_error: Table
    dissipated_error: Table
    digits: NDArray[np.int64]
    certain: NDArray[np.bool_]
    event_t: Table
    event_y: Table
    event_mode: NDArray[np.int64]
    event_t_error: Table
    event_y_error: Table

    @property
    def success(self) -> NDArray[np.bool_]:
        """Return which runs got to their horizon."""
        return (self.status == REACHED) | (self.status == STUCK)


def solve_many(
    m1: ArrayLike,
    m2: ArrayLike,
    a2: ArrayLike,
    b: ArrayLike,
    *,
    until: ArrayLike,
    a1: ArrayLike = 0.0,
    x1: ArrayLike = 0.0,
    v1: ArrayLike = 0.0,
    x2: ArrayLike = 0.0,
    v2: ArrayLike = 0.0,
    law: Law | str = Law.FILIPPOV,
    max_events: int = MAX_EVENTS,
    keep_events: int = 0,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> Batch:
    """Solve the scenes of all numbers in arrays that broadcast together, in SI units as in Pair, State and Scene.

    Every scene runs through the kernels of `solve`: its reduced numbers have the same bits.

    The numbers are taken as the binary64 numbers that they are, exactly: 0.005 in an array is not 1/200, which matters
    to a pair that starts on the very edge; `solve_scenes` takes exact decimals. `jobs`: threads of compiled code
    (default: all cores), processes by joblib without numba (default: 1). `progress(done, all)` is called now and then.

    Raises InvalidScene, naming the first number that is out of bounds, ValueError (arrays that do not broadcast, bad
    arguments), MissingTool (jobs > 1 without numba and joblib).

    >>> found = solve_many(1, 1, 200, 0.5, v1=[0.05, 0.15], until=5, jobs=1)
    >>> found.events.tolist(), found.mode.tolist(), bool(found.digits.min() >= 10)
    ([1, 32], [0, 0], True)
    """
    given = dict(zip(ROW_ORDER, (m1, m2, a2, b, x1, v1, x2, v2, until, a1), strict=True))
    columns = {name: _numbers(name, values) for name, values in given.items()}
    shape = np.broadcast_shapes(*(column.shape for column in columns.values()))
    table = np.stack([np.broadcast_to(columns[name], shape).ravel() for name in ROW_ORDER], axis=1)
    literal = read_law(law) is Law.THREE_VALUED_SGN
    _check(max_events, keep_events, jobs)
    size = _chunk(len(table), jobs)
    chunks = [(start, table[start : start + size]) for start in range(0, len(table), size)]
    work = partial(solve_table, literal=literal, max_events=max_events, keep=keep_events)
    return _gathered(_results(work, chunks, jobs, progress, len(table)), len(table), shape, keep_events)


def solve_scenes(
    scenes: Sequence[Scene],
    *,
    max_events: int = MAX_EVENTS,
    keep_events: int = 0,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> Batch:
    """Solve scenes as `solve_many` does, from their exact decimals; arrays of shape (len(scenes),)."""
    _check(max_events, keep_events, jobs)
    size = _chunk(len(scenes), jobs)
    chunks = [(start, scenes[start : start + size]) for start in range(0, len(scenes), size)]
    work = partial(solve_exact, max_events=max_events, keep=keep_events)
    results = _results(work, chunks, jobs, progress, len(scenes))
    return _gathered(results, len(scenes), (len(scenes),), keep_events)


def _chunk(count: int, jobs: int | None) -> int:
    """Return how many scenes go into one chunk: four chunks for every core, so that all end at about the same time."""
    return max(1, min(_CHUNK, -(-count // (4 * (jobs or available_cores())))))


def _numbers(name: str, values: ArrayLike) -> Table:
    """Return values as binary64 numbers, checked; the message names the first one that is out of bounds."""
    if np.ma.is_masked(values):
        raise InvalidScene(f"{name} has masked numbers; leave those scenes out, e.g. by .compressed()")
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InvalidScene(f"{name} must be an array of real numbers in SI units") from None
    wrong = ~np.isfinite(array) | ((array <= 0) if name in _POSITIVE else (array < 0) & (name == "a1"))
    if np.any(wrong):
        first = tuple(int(i) for i in np.argwhere(wrong)[0])
        place = f"{name}{list(first) if first else ''} = {array[first]:g}"
        bound = "> 0 and finite" if name in _POSITIVE else ">= 0 and finite" if name == "a1" else "finite"
        raise InvalidScene(f"{place} must be {bound}; correct it, or leave that scene out")
    return array


def _check(max_events: int, keep_events: int, jobs: int | None) -> None:
    require_whole("max_events", max_events, 1)
    require_whole("keep_events", keep_events, 0)
    require_whole("jobs", 1 if jobs is None else jobs, 1)


def _results(
    work: Callable[[Any], Solved], chunks: list[Any], jobs: int | None, progress: Progress | None, whole: int
) -> Iterator[Solved]:
    """Yield the results of all chunks as they finish, from threads of compiled code or from processes."""
    if can_compile():
        results = _in_threads(work, chunks, jobs or available_cores())
    else:
        results = run_tasks(work, chunks, jobs=jobs or 1)
    done = 0
    for result in results:
        done += len(result.answers)
        if progress is not None:
            progress(done, whole)
        yield result


def _in_threads(work: Callable[[Any], Solved], chunks: list[Any], jobs: int) -> Iterator[Solved]:
    if jobs == 1 or len(chunks) <= 1:
        yield from map(work, chunks)
        return
    pool = ThreadPoolExecutor(min(jobs, len(chunks)))
    try:
        futures: list[Future[Solved]] = [pool.submit(work, chunk) for chunk in chunks]
        for future in as_completed(futures):
            yield future.result()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _gathered(results: Iterator[Solved], count: int, shape: tuple[int, ...], keep: int) -> Batch:
    """Return all chunks' answers in SI units, in the shape of the inputs."""
    answers, units = np.empty((count, len(ANSWERS))), np.empty((3, count))
    kept = np.empty((count, keep, len(EVENTS)))
    for done in results:
        rows = slice(done.first, done.first + len(done.answers))
        answers[rows], kept[rows], units[:, rows] = done.answers, done.kept, done.units
    end = dict(zip(ANSWERS, answers.T, strict=True))
    length, rate, energy = units
    speed = length * rate
    y = np.stack([length * end["X"], speed * end["V1"], length * (end["X"] - end["Z"]), speed * end["V2"]])
    placed = length * (end["x_error"] + end["place_error"])
    y_error = np.stack([length * end["x_error"], speed * end["v1_error"], placed, speed * end["v2_error"]])
    y_error += 8 * ULP * abs(y) + np.where((abs(y) < 1e-290) & (y != 0), _TINY, 0.0)
    event = dict(zip(EVENTS, np.moveaxis(kept, -1, 0), strict=True))
    taken = end["spent"] + end["damped"]
    numbers = {
        "status": end["how"].astype(np.int64),
        "events": end["events"].astype(np.int64),
        "mode": np.nan_to_num(end["mode"]).astype(np.int64),
        "t": end["tau"] / rate,
        "energy_excess": end["w"],
        "dissipated": energy * taken,
        "energy_excess_error": end["w_error"],
        "dissipated_error": energy * (end["spent_error"] + end["damped_error"] + 8 * ULP * taken)
        + np.where((energy * taken < 1e-290) & (taken > 0), _TINY, 0.0),
        "digits": _digits(end, y, y_error),
        "certain": end["certain"] == 1.0,
    }
    shaped = {name: value.reshape(shape) for name, value in numbers.items()}
    shaped |= {name: value.reshape(4, *shape) for name, value in (("y", y), ("y_error", y_error))}
    for name, value in _event_arrays(event, length, rate).items():
        shaped[name] = value.reshape((4, *shape, keep) if value.ndim == 3 else (*shape, keep))
    return Batch(**shaped)


def _digits(end: dict[str, Table], y: Table, y_error: Table) -> NDArray[np.int64]:
    """Return how many digits of every event, and of state, excess and energy at the end, the bounds leave right."""
    with np.errstate(divide="ignore", invalid="ignore"):
        w, w_error = abs(end["w"]), end["w_error"]
        energy = abs(1 + end["w"])
        energy_error = w_error + 16 * ULP * (energy + w)
        errors = np.stack([*y_error, w_error + 4 * ULP * w, energy_error]) / abs(np.stack([*y, w, energy]))
        errors = np.where(np.isnan(errors), np.where(np.isnan(y[0]), np.inf, 0.0), errors)
        worst = np.maximum(end["worst"], errors.max(axis=0)).clip(1e-17)
        digits = np.floor(-np.log10(worst))
    return np.where((end["certain"] == 1.0) & (digits > 0), digits, 0).astype(np.int64)


def _event_arrays(event: dict[str, Table], length: Table, rate: Table) -> dict[str, Any]:
    """Return t, y and mode of the kept events, and the bounds on their errors, in SI units."""
    L, speed, rate = length[:, None], (length * rate)[:, None], rate[:, None]
    t, v = event["tau"] / rate, speed * event["V"]
    y = np.stack([L * event["X"], v, L * (event["X"] - event["Z"]), v])
    t_error, v_error = event["late"] / rate + 8 * ULP * t, speed * event["v"]
    y_error = np.stack([L * event["x"], v_error, L * (event["x"] + event["place"]), v_error]) + 8 * ULP * abs(y)
    mode = np.nan_to_num(event["mode"]).astype(np.int64)
    return {"event_t": t, "event_y": y, "event_mode": mode, "event_t_error": t_error, "event_y_error": y_error}
