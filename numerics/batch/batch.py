"""Many scenes at once: arrays in, arrays out, on all cores, in memory bounded by the arrays themselves.

Every scene runs through the same float64 texts as `solve`, compiled where numba is installed, with the same bits, the
same certified first events and the same error bounds. Python only hands out chunks of rows.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from numerics.batch.answer import Batch
from numerics.batch.forced import solve_forced
from numerics.batch.parallel import available_cores
from numerics.batch.rows import Chunk, room
from numerics.batch.threads import in_threads
from numerics.errors import InvalidScene
from numerics.motion.begin import si_numbers
from numerics.motion.start import SI
from numerics.run.one import MAX_EVENTS, halved
from numerics.scene import Force, Friction, Law, Pair, Scene, State, read_law
from numerics.scene.decimals import require_whole

_POSITIVE = ("m1", "m2", "a2", "b", "until")
_MUST_BE_POSITIVE = [SI._fields.index(name) for name in _POSITIVE]
_CHUNK = 4096
"""Scenes in a chunk at most: their rows fit into a core's cache."""
_TOO_FEW = 256
"""Scenes that one thread solves before another has started."""
Progress = Callable[[int, int], None]
Table = NDArray[np.float64]


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
    force: Any = None,
    friction: Any = None,
    law: Law | str = Law.FILIPPOV,
    max_events: int = MAX_EVENTS,
    keep_events: int = 0,
    jobs: int | None = None,
    progress: Progress | None = None,
    exact: bool = False,
) -> Batch:
    """Solve the scenes of all numbers in arrays that broadcast together, in SI units as in Pair, State and Scene.

    Every scene runs through the texts of `solve`: its reduced numbers have the same bits.

    The numbers are taken as the binary64 numbers that they are, exactly: 0.005 in an array is not 1/200, which matters
    to a pair that starts on the very edge. With `exact` they are read as `solve` reads them: 0.005 is 1/200, and texts
    such as "1/3" are numbers too, at the price of Python's time for every scene. `jobs`: threads of compiled code
    (default: all cores); without numba one thread does it all. `progress(done, all)` is called now and then.

    `force` and `friction`: a Force, a Friction, or sequences of them that broadcast with the numbers.

    Raises InvalidScene, naming the first number that is out of bounds, ValueError (arrays that do not broadcast, bad
    arguments).

    >>> found = solve_many(1, 1, 200, 0.5, v1=[0.05, 0.15], until=5, jobs=1)
    >>> found.events.tolist(), found.mode.tolist(), bool(found.digits.min() >= 10)
    ([1, 32], [0, 0], True)
    """
    numbers = (m1, m2, a2, b, x1, v1, x2, v2, until, a1)
    if exact or force is not None or friction is not None:
        acts = (Force() if force is None else force, Friction() if friction is None else friction)
        given = numbers if exact else tuple(_as_binary(one) for one in numbers)
        return _solve_decimals(given, acts, law, max_events, keep_events, jobs, progress)
    table, shape = _table(numbers)
    _check(max_events, keep_events, jobs)
    law = read_law(law)
    return _solved(
        table, lambda row: _exact_scene(table[row, ::2], law), shape, law, (max_events, keep_events, jobs, progress)
    )


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
    if any(scene.is_forced for scene in scenes):
        return _solve_mixed(scenes, (max_events, keep_events, jobs, progress))
    limits, shape = (max_events, keep_events, jobs, progress), (len(scenes),)
    table = np.zeros((len(scenes), 20))
    for index, scene in enumerate(scenes):
        halves = halved(si_numbers(scene))
        table[index] = np.nan if halves is None else halves
    laws = {scene.law for scene in scenes}
    if len(laws) <= 1:
        return _solved(table, scenes.__getitem__, shape, next(iter(laws), Law.FILIPPOV), limits)
    ends, kept = room(len(scenes), keep_events)
    for law in laws:
        rows = np.array([index for index, scene in enumerate(scenes) if scene.law is law])
        own = [scenes[row] for row in rows]
        found = _solved(table[rows], own.__getitem__, (len(rows),), law, limits)
        ends[rows], kept[rows] = found.ends, found.kept
    return Batch(ends, kept, shape)


def _solve_mixed(scenes: Sequence[Scene], limits: tuple[int, int, int | None, Progress | None]) -> Batch:
    """Solve scenes some of which have a force: those one by one, the others as ever."""
    max_events, keep_events, jobs, progress = limits
    ends, kept = room(len(scenes), keep_events)
    forced = np.array([scene.is_forced for scene in scenes])
    free = [scene for scene in scenes if not scene.is_forced]
    found = solve_scenes(free, max_events=max_events, keep_events=keep_events, jobs=jobs)
    ends[~forced], kept[~forced] = found.ends, found.kept
    done = [len(free)]

    def told(count: int) -> None:
        done[0] += count
        if progress is not None:
            progress(done[0], len(scenes))

    own_ends, own_kept = room(int(forced.sum()), keep_events)
    solve_forced([scene for scene in scenes if scene.is_forced], max_events, own_ends, own_kept, told)
    ends[forced], kept[forced] = own_ends, own_kept
    return Batch(ends, kept, (len(scenes),))


def _as_binary(values: ArrayLike) -> ArrayLike:
    """Return numbers as the exact rationals that they are in binary."""
    array = np.asarray(_numbers("a number", values))
    if not np.isfinite(array).all():
        raise InvalidScene("numbers of a batch must be finite; correct them, or leave those scenes out")
    return np.array([Fraction(float(one)) for one in array.ravel()], dtype=object).reshape(array.shape)


def _solve_decimals(
    numbers: tuple[ArrayLike, ...],
    acts: tuple[Any, Any],
    law: Law | str,
    max_events: int,
    keep_events: int,
    jobs: int | None,
    progress: Progress | None,
) -> Batch:
    """Solve arrays of exact numbers: texts, decimals, fractions, or floats read as the decimals that they show."""
    arrays = np.broadcast_arrays(*[np.asarray(one, dtype=object) for one in (*numbers, *acts)])
    shape = arrays[0].shape
    scenes = []
    for m1, m2, a2, b, x1, v1, x2, v2, until, a1, *both in zip(*[one.ravel() for one in arrays], strict=True):
        scenes.append(Scene(Pair(m1, m2, a2, b, a1), State(x1, v1, x2, v2), until, law, *both))
    found = solve_scenes(scenes, max_events=max_events, keep_events=keep_events, jobs=jobs, progress=progress)
    return Batch(found.ends, found.kept, shape)


def _exact_scene(numbers: Table, law: Law) -> Scene:
    """Return the scene of binary64 numbers, exact."""
    m1, m2, a2, b, x1, v1, x2, v2, until, a1 = (Fraction(float(one)) for one in numbers)
    return Scene(Pair(m1, m2, a2, b, a1), State(x1, v1, x2, v2), until, law)


def _solved(
    table: Table,
    exact: Callable[[int], Scene],
    shape: tuple[int, ...],
    law: Law,
    limits: tuple[int, int, int | None, Progress | None],
) -> Batch:
    """Solve rows of SI numbers in chunks."""
    max_events, keep_events, jobs, progress = limits
    ends, kept = room(len(table), keep_events)
    size, done, literal = _chunk(len(table), jobs), 0, law is Law.THREE_VALUED_SGN
    chunks = []
    for start in range(0, len(table), size):
        part = slice(start, start + size)
        chunks.append(
            Chunk(table[part], lambda row, start=start: exact(start + row), ends[part], kept[part], literal, max_events)
        )
    for count in in_threads(chunks, jobs):
        done += count
        if progress is not None:
            progress(done, len(table))
    return Batch(ends, kept, shape)


def _chunk(count: int, jobs: int | None) -> int:
    """Return how many scenes go into one chunk: four chunks for every core, so that all end at about the same time."""
    if count <= _TOO_FEW:
        return _TOO_FEW
    return max(_TOO_FEW, min(_CHUNK, -(-count // (4 * (jobs or available_cores())))))


def _table(numbers: tuple[ArrayLike, ...]) -> tuple[Table, tuple[int, ...]]:
    """Return SI numbers as rows of halves (n, 20), and the shape that their arrays have together; checked."""
    columns = [_numbers(name, values) for name, values in zip(SI._fields, numbers, strict=True)]
    if all(isinstance(column, float) for column in columns):
        shape, table = (), np.zeros((1, 20))
        table[0, ::2] = columns
    else:
        shape = np.broadcast_shapes(*[column.shape for column in columns if not isinstance(column, float)])
        table = np.zeros((*shape, 20))
        for index, column in enumerate(columns):
            table[..., 2 * index] = column
        table = table.reshape(-1, 20)
    given = table[:, ::2]
    if not (np.isfinite(given).all() and (given[:, _MUST_BE_POSITIVE] > 0).all() and (given[:, -1] >= 0).all()):
        for name, column in zip(SI._fields, columns, strict=True):
            _refuse(name, np.asarray(column))
    return table, shape


def _numbers(name: str, values: Any) -> Table | float:
    """Return values as binary64 numbers: an array, or a float."""
    if isinstance(values, (int, float)):
        return float(values) if abs(values) < 2**1023 else np.inf
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise InvalidScene(f"{name} has masked numbers; leave those scenes out, e.g. by .compressed()")
    try:
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InvalidScene(f"{name} must be an array of real numbers in SI units") from None


def _refuse(name: str, array: Table) -> None:
    """Raise InvalidScene, naming the first number that is out of bounds, if there is one."""
    wrong = ~np.isfinite(array) | ((array <= 0) if name in _POSITIVE else (array < 0) & (name == "a1"))
    if np.any(wrong):
        first = tuple(int(i) for i in np.argwhere(wrong)[0])
        place = f"{name}{list(first) if first else ''} = {array[first]:g}"
        bound = "> 0 and finite" if name in _POSITIVE else ">= 0 and finite" if name == "a1" else "finite"
        raise InvalidScene(f"{place} must be {bound}; correct it, or leave that scene out")


def _check(max_events: int, keep_events: int, jobs: int | None) -> None:
    require_whole("max_events", max_events, 1)
    require_whole("keep_events", keep_events, 0)
    require_whole("jobs", 1 if jobs is None else jobs, 1)
