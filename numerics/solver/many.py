"""Many scenes at once: arrays in, arrays out, on all cores, in memory bounded by the arrays themselves.

Every scene runs through the same engines as solve(scene, arithmetic="float64"), with the same events and error bounds.
Python only hands out chunks of rows to compiled code, where numba is installed.
"""

from __future__ import annotations

import reprlib
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from fractions import Fraction
from functools import cache, partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from numerics.arithmetic.compiled import can_compile
from numerics.arithmetic.pair import nearest
from numerics.errors import InvalidScene
from numerics.linear.record import AT, How
from numerics.scene import Force, Friction, Law, Pair, Piece, Scene, Sine, State, read_law
from numerics.scene.decimals import exact_decimal, require_function, require_whole
from numerics.scene.model import NO_FORCE, SAME_FRICTION
from numerics.scene.plane import PlaneScene
from numerics.solver.batch import SI, Batch
from numerics.solver.rows import Chunk, Columns, form_ledgers, frictions_of, of_one_kind, room
from numerics.tasks import available_cores
from numerics.trajectory.run import MAX_EVENTS

if TYPE_CHECKING:
    from numerics.solver.plane_batch import PlaneBatch

_POSITIVE = ("m1", "m2", "a2", "b", "until")
_FLOATS = np.finfo(np.float64)
_CHUNK = 4096
"""Scenes in a chunk at most: their rows fit into a core's cache."""
_TOO_FEW = 256
"""Scenes that one thread solves before another has started."""
Progress = Callable[[int, int], None]
Table = NDArray[np.float64]


class _Limits(NamedTuple):
    law: Law
    max_events: int
    keep_events: int
    jobs: int | None
    progress: Progress | None


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
    polynomial: Sequence[ArrayLike] = (),
    sines: Sequence[tuple[ArrayLike, ArrayLike, ArrayLike]] = (),
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

    Every scene runs as by solve(scene, arithmetic="float64"); an event that its bounds leave open is a status. Where
    friction depends on the state it runs in balls, one after the other.

    The force on body 1: `polynomial`, arrays of u's coefficients (N, N/s, ...) in powers of t, and `sines`, triples of
    arrays (amplitude in N, omega in rad/s > 0, phase in rad); t from the start of the run. They broadcast with the
    numbers. For jumps, `force` and `friction`: a Force, a Friction, or sequences of them that broadcast; one Friction
    for all beside `sines` costs no more than `sines` alone.

    The numbers are taken as the binary64 numbers that they are, exactly: 0.005 in an array is not 1/200, which matters
    to a pair that starts on the very edge. With `exact` they are read as `solve` reads them: 0.005 is 1/200, and texts
    such as "1/3" are numbers too, at the price of Python's time for every scene. `jobs`: threads of compiled code
    (default: all cores); without numba one thread does it all. `progress(done, all)` is called now and then.

    Raises InvalidScene, naming the first number that is out of bounds, ValueError (arrays that do not broadcast, bad
    arguments).

    >>> found = solve_many(1, 1, 200, 0.5, v1=[0.05, 0.15], until=5, jobs=1)
    >>> found.events.tolist(), found.mode.tolist(), bool(found.digits.min() >= 10)
    ([1, 32], [0, 0], True)
    """
    named = dict(zip(SI, (m1, m2, a2, b, x1, v1, x2, v2, until, a1), strict=True))
    for name, given in (("polynomial", polynomial), ("sines", sines)):
        if not _is_list(given):
            raise InvalidScene(f"{name} = {str(given)[:40]!r} must be a list: of coefficients, or of triples of a sine")
    named |= {f"polynomial[{k}]": one for k, one in enumerate(polynomial)}
    for k, sine in enumerate(sines):
        if not _is_list(sine) or len(sine) != 3:
            raise InvalidScene(f"sines[{k}] must be a triple: amplitude, omega, phase")
        named |= {f"sines[{k}].{name}": one for name, one in zip(("amplitude", "omega", "phase"), sine, strict=True)}
    for name, values in named.items():
        if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
            raise InvalidScene(f"{name} has masked numbers; leave those scenes out, e.g. by .compressed()")
    limits = _limits(read_law(law), max_events, keep_events, jobs, progress)
    acts = None
    if force is not None or friction is not None:
        acts = Force() if force is None else force, Friction() if friction is None else friction
    # a polynomial would have to begin anew with each piece of friction
    shared = force is None and len(polynomial) < 2 and _fits_in_columns(friction)
    if exact or (acts is not None and not shared):
        return _solve_objects(named, acts, len(polynomial), limits, binary=not exact)
    same = friction if shared else SAME_FRICTION
    columns, shape = _columns(named, len(polynomial), same)

    def scene_of(row: int) -> Scene:
        coefficients, waves = columns.polynomial[row], columns.sines[row]
        numbers = [Fraction(float(one)) for one in (*columns.table[row, ::2], *coefficients, *waves.ravel())]
        return _scene(numbers, len(coefficients), limits.law, {}, friction=same)

    later = columns.table[:, 2 * SI.index("until")] <= float(max(same.starts, default=0))
    return _solved(columns, scene_of, columns.table, shape, limits, later)


@overload
def solve_scenes(scenes: Sequence[PlaneScene], **options: Any) -> PlaneBatch: ...


@overload
def solve_scenes(scenes: Sequence[Scene], **options: Any) -> Batch: ...


def solve_scenes(  # type: ignore[misc]  # the options are those below
    scenes: Sequence[Scene] | Sequence[PlaneScene],
    *,
    max_events: int = MAX_EVENTS,
    keep_events: int = 0,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> Batch | PlaneBatch:
    """Solve scenes as `solve_many` does, from their exact decimals; arrays of shape (len(scenes),).

    Scenes on a surface, with one number of axes, run each by itself, in `jobs` processes, which need joblib (default:
    all cores if it is there), and make a PlaneBatch.

    Raises TypeError for what is no list of scenes of one kind, ValueError for bad arguments, MissingTool.

    >>> from numerics import load_scene
    >>> solve_scenes([load_scene("velocities"), load_scene("at-rest")], jobs=1).events.tolist()
    [24, 0]
    """
    kept = of_one_kind(scenes)
    if kept and isinstance(kept[0], PlaneScene):
        from numerics.solver.plane_batch import solve_surfaces

        return solve_surfaces(kept, *_limits(Law.FILIPPOV, max_events, keep_events, jobs, progress)[1:])
    laws = {scene.law for scene in kept}
    if any(scene.friction.weakening for scene in kept):
        jobs = 1  # they are solved in balls, whose precision all threads share
    limits = _limits(next(iter(laws), Law.FILIPPOV), max_events, keep_events, jobs, progress)
    plain = len(laws) <= 1 and not any(scene.is_forced for scene in kept)
    table = np.array([_halves(scene, lows=plain) for scene in kept]).reshape(len(kept), 2 * len(SI))
    columns = Columns(table, np.zeros((len(kept), 0)), np.zeros((len(kept), 0, 3)), frictions_of(SAME_FRICTION))
    later = np.array([scene.changes_later for scene in kept], bool)
    held = columns if plain and np.isfinite(table).all() else None
    return _solved(held, kept.__getitem__, table, (len(kept),), limits, later)


def _fits_in_columns(friction: Any) -> bool:
    """Return whether all rows have this friction, and pairs of floats tell its pieces apart and hold its numbers."""
    if not isinstance(friction, Friction) or friction.weakening:
        return False
    starts = (Fraction(0), *(start for start in friction.starts if start))
    lengths = [end - start for start, end in pairwise(starts)]
    is_held = all(2.0**-900 < one < 2.0**900 for one in (*lengths, *starts[1:], *(b for _, b in friction.pieces)))
    return is_held and all(end < 2**80 * one for end, one in zip(starts[1:], lengths, strict=True))


def _limits(law: Law, max_events: int, keep_events: int, jobs: int | None, progress: Progress | None) -> _Limits:
    require_whole("max_events", max_events, 1)
    require_whole("keep_events", keep_events, 0)
    require_whole("jobs", 1 if jobs is None else jobs, 1)
    if progress is not None:
        require_function("progress", progress, "(done, all)")
    return _Limits(law, max_events, keep_events, jobs, progress)


def _halves(scene: Scene, *, lows: bool) -> list[float]:
    """Return the SI numbers of a scene as halves, or high halves and 0; nan where one is beyond binary64."""
    pair, at = scene.pair, scene.initial
    numbers = (pair.m1, pair.m2, pair.a2, pair.b, at.x1, at.v1, at.x2, at.v2, scene.until, pair.a1)
    try:
        halves = [half for one in numbers for half in (nearest(one) if lows else (float(one), 0.0))]
    except OverflowError:
        return [np.nan] * 20
    if not lows:
        return halves
    same = halves[10:12] == halves[14:16]  # halves must not make two velocities equal that are not
    return halves if same == (at.v1 == at.v2) else [np.nan] * 20


def _scene(
    numbers: Sequence[Any],
    terms: int,
    law: Law,
    pairs: dict[tuple[int, ...], Pair],
    force: Any = NO_FORCE,
    friction: Any = SAME_FRICTION,
) -> Scene:
    """Return the scene of its SI numbers, the coefficients of a polynomial, the numbers of sines, and what acts too.

    `pairs` keeps the pair of the very same numbers, which most scenes of a batch share.
    """
    m1, m2, a2, b, x1, v1, x2, v2, until, a1, *rest = numbers
    same = (id(m1), id(m2), id(a2), id(b), id(a1))
    pair = pairs[same] if same in pairs else pairs.setdefault(same, Pair(m1, m2, a2, b, a1))
    waves = [Sine(*rest[k : k + 3]) for k in range(terms, len(rest), 3)]
    if any(rest[:terms]) or any(s.amplitude for s in waves):
        own = Force((Piece(0, rest[:terms], waves),))
        force = own if force is NO_FORCE else own + force
    return Scene(pair, State(x1, v1, x2, v2), until, law, force, friction)


def _solve_objects(
    named: dict[str, ArrayLike], acts: tuple[Any, Any] | None, terms: int, limits: _Limits, *, binary: bool
) -> Batch:
    """Solve arrays of exact numbers, or of binary ones with forces of any kind, scene by scene."""
    given = list(named.values())
    if binary:
        floats = [_numbers(name, values) for name, values in named.items()]
        for name, array in zip(named, floats, strict=True):
            _refuse(name, array)
        given = [np.vectorize(Fraction, otypes=[object])(array) if array.size else array for array in floats]
    objects = [np.asarray(one, dtype=object) for one in (*given, *(acts or ()))]
    for kind, some in zip((Force, Friction), objects[len(given) :], strict=False):
        if wrong := [one for one in some.flat if not isinstance(one, kind)]:
            name = kind.__name__
            raise InvalidScene(f"{name.lower()} holds {str(wrong[0])[:40]!r}; give a {name}([...]), or a list of them")
    shape = _common_shape(dict(zip((*named, "force", "friction"), objects, strict=False)))
    arrays = [np.broadcast_to(one, shape) for one in objects]
    rows, pairs = zip(*[one.ravel() for one in arrays], strict=True), dict[tuple[int, ...], Pair]()
    scenes = [_scene(row[: len(named)], terms, limits.law, pairs, *row[len(named) :]) for row in rows]
    _, max_events, keep, jobs, progress = limits
    found = solve_scenes(scenes, max_events=max_events, keep_events=keep, jobs=jobs, progress=progress)
    return Batch(found.table, found.ends, found.kept, arrays[0].shape)


def _solved(
    columns: Columns | None,
    exact: Callable[[int], Scene],
    table: Table,
    shape: tuple[int, ...],
    limits: _Limits,
    later: NDArray[np.bool_],
) -> Batch:
    """Solve rows in chunks; `later`: where another piece begins at the horizon or after it, no stick is for ever."""
    ends, kept = room(len(table), limits.keep_events)
    size, done, literal = _chunk(len(table), limits.jobs), 0, limits.law is Law.THREE_VALUED_SGN
    chunks = []
    for start in range(0, len(table), size):
        part = slice(start, start + size)
        own = None if columns is None else columns.part(part)

        def exact_here(row: int, start: int = start) -> Scene:
            return exact(start + row)

        chunks.append(Chunk(own, exact_here, ends[part], kept[part], literal, limits.max_events))
    for count in _in_threads([chunk.solve for chunk in chunks], limits.jobs):
        done += count
        if limits.progress is not None:
            limits.progress(done, len(table))
    ends[later & (ends[:, AT["how"]] == How.STUCK), AT["how"]] = How.REACHED
    form = None if columns is None else partial(_form_ledgers, columns, literal, limits.max_events, limits.jobs)
    return Batch(table, ends, kept, shape, form)


def _form_ledgers(columns: Columns, literal: bool, max_events: int, jobs: int | None, ends: Table) -> None:
    """Form the ledgers that the runs have left out, in chunks."""
    size = _chunk(len(ends), jobs)
    parts = [slice(start, start + size) for start in range(0, len(ends), size)]
    tasks = [partial(form_ledgers, columns.part(one), literal, max_events, ends[one]) for one in parts]
    list(_in_threads(tasks, jobs))


def _in_threads(tasks: Sequence[Callable[[], int]], jobs: int | None) -> Iterator[int]:
    """Yield how many scenes each chunk had, as they finish; compiled code runs in threads, Python in turn."""
    if jobs == 1 or len(tasks) <= 1 or not can_compile():
        yield from (task() for task in tasks)
        return
    pool = ThreadPoolExecutor(min(jobs or available_cores(), len(tasks)))
    try:
        futures: list[Future[int]] = [pool.submit(task) for task in tasks]
        for future in as_completed(futures):
            yield future.result()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _chunk(count: int, jobs: int | None) -> int:
    """Return how many scenes go into one chunk: four chunks for every core, so that all end at about the same time."""
    if count <= _TOO_FEW:
        return _TOO_FEW
    return max(_TOO_FEW, min(_CHUNK, -(-count // (4 * (jobs or available_cores())))))


def _columns(named: dict[str, ArrayLike], terms: int, friction: Friction) -> tuple[Columns, tuple[int, ...]]:
    """Return numbers as columns, and the shape that their arrays have together; checked."""
    arrays = {name: _numbers(name, values) for name, values in named.items()}
    shape = _common_shape(arrays)
    wide = np.zeros((*shape, len(arrays)))
    for index, array in enumerate(arrays.values()):
        wide[..., index] = array
    if not (wide.size and _allowed(wide, np.array([_least(name) for name in arrays])).all()):
        for name, array in arrays.items():
            _refuse(name, np.asarray(array))
    flat = wide.reshape(-1, len(arrays))
    table = np.zeros((len(flat), 2 * len(SI)))
    table[:, ::2] = flat[:, : len(SI)]
    rest = flat[:, len(SI) :]
    count = (len(arrays) - len(SI) - terms) // 3
    return Columns(table, rest[:, :terms], rest[:, terms:].reshape(len(flat), count, 3), frictions_of(friction)), shape


def _common_shape(arrays: dict[str, Any]) -> tuple[int, ...]:
    """Return the shape to which arrays broadcast. Raises ValueError, which names them."""
    shapes = {name: array.shape for name, array in arrays.items()}
    try:
        return np.broadcast_shapes(*{shape for shape in shapes.values() if shape})
    except ValueError:
        given = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise ValueError(f"these shapes do not broadcast together: {given}; give arrays of one shape") from None


def _is_list(given: Any) -> bool:
    """Return whether an argument lists something; a text does not, whose letters nobody means."""
    if isinstance(given, np.ndarray):
        return given.ndim > 0
    return isinstance(given, Sequence) and not isinstance(given, str | bytes)


def _has_truth_values(values: Any) -> bool:
    """Return whether there are truth values in a list, of which NumPy would make 0 and 1."""
    if isinstance(values, list | tuple):  # mostly of numbers, which their types say at once
        return not set(map(type, values)) <= {float, int} and any(map(_has_truth_values, values))
    return isinstance(values, bool) or getattr(getattr(values, "dtype", None), "kind", "") == "b"


def _numbers(name: str, values: Any) -> Table:
    """Return values as an array of binary64 numbers."""
    try:
        given = np.asarray(values)
        if given.dtype.kind in "OUS":  # texts are read as in a scene
            given = np.vectorize(lambda one: float(exact_decimal(one, name)), otypes=[np.float64])(
                given.astype(str) if given.dtype.kind == "S" else given
            )
        # NumPy would make real numbers of complex ones, dates and truth values, too
        if given.dtype.kind in "iuf" and not _has_truth_values(values):
            if given.dtype == np.float64:
                return given
            with np.errstate(over="ignore"):  # of long floats; refused as inf
                return np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        pass
    raise InvalidScene(
        f"{name} = {reprlib.repr(values)[:60]} must be real numbers in SI units; give a number or an array"
    )


def _refuse(name: str, array: Table) -> None:
    """Raise InvalidScene, naming the first number that is out of bounds, if there is one."""
    least = _least(name)
    wrong = ~_allowed(array, least)
    if np.any(wrong):
        first = tuple(int(i) for i in np.argwhere(wrong)[0])
        place = f"{name}{list(first) if first else ''} = {array[first]:g}"
        bound = "finite" if least < 0 else ">= 0 and finite" if least == 0 else "> 0 and finite"
        raise InvalidScene(f"{place} must be {bound}; correct it, or leave that scene out")


@cache
def _least(name: str) -> float:
    """Return the least number that a quantity may be."""
    if name in _POSITIVE or name.endswith(".omega"):
        return float(_FLOATS.smallest_subnormal)
    return 0.0 if name == "a1" else float(_FLOATS.min)


def _allowed(array: Table, least: Any) -> NDArray[np.bool_]:
    return np.asarray((array >= least) & (array <= _FLOATS.max))
