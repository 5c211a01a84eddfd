"""Many scenes at once: arrays in, arrays out, on all cores, in memory bounded by the arrays themselves.

Every scene runs through the same engines as solve(scene, arithmetic="float64"), with the same events and error bounds.
Python only hands out chunks of rows to compiled code, where numba is installed.
"""

from __future__ import annotations

import math
import reprlib
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from numerics.arithmetic.compiled import can_compile
from numerics.errors import InvalidScene
from numerics.linear.batch import Columns
from numerics.meter import meter
from numerics.scene import Force, Friction, Law, Pair, Piece, Scene, Sine, State, read_law
from numerics.scene.decimals import as_printed, exact_decimal, listed, require_function, require_whole, shown
from numerics.scene.model import NO_FORCE, SAME_FRICTION
from numerics.scene.plane import PlaneScene
from numerics.solver.batch import Batch
from numerics.solver.inputs import SI, inputs_of, near
from numerics.solver.rows import BatchLimits, Progress, Work
from numerics.trajectory.columns import STATE, Array, room
from numerics.trajectory.run import MAX_EVENTS


def _limits(max_events: int, keep_events: int, jobs: int | None, progress: Progress | None) -> BatchLimits:
    """Return the limits of a batch. Raises ValueError for what is none."""
    require_whole("max_events", max_events, 1)
    require_whole("keep_events", keep_events, 0)
    if keep_events > max_events:
        most = f"max_events = {max_events}"
        raise ValueError(f"keep_events = {keep_events} must be at most {most}; give fewer, or raise it")
    require_whole("jobs", 1 if jobs is None else jobs, 1)
    if progress is not None:
        require_function("progress", progress, "(done, all)")
    return BatchLimits(max_events, keep_events, jobs)


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
    force: Force | Sequence[Force] | None = None,
    friction: Friction | Sequence[Friction] | None = None,
    law: Law | str = Law.FILIPPOV,
    max_events: int = MAX_EVENTS,
    keep_events: int = 0,
    jobs: int | None = None,
    progress: Progress | None = None,
    exact: bool = False,
) -> Batch:
    """Solve one scene for each element of arrays that broadcast together; SI units as in Pair, State and Scene.

    Each scene is solved like solve(scene, arithmetic="float64"); if the error bounds do not decide its events, its
    status and `message` say so: solve(scene) goes on in balls. With `exact`, `force` or `friction`, and where some a2
    or b is 0 or some m2 is inf, the scenes are solved one after the other, as by `solve_scenes`.

    The force on body 1: `polynomial`, arrays of u's coefficients (N, N/s, ...) in powers of t, and `sines`, triples of
    arrays (amplitude in N, omega in rad/s > 0, phase in rad); t from the start of the run. They broadcast with the
    other arrays. For jumps use `force` and `friction`: a Force, a Friction, or sequences of them that broadcast; scenes
    with them are solved one after the other.

    Numbers are read as binary64 numbers, exactly: 0.005 in an array is not 1/200, which matters for a start exactly on
    the edge of the sliding region. With `exact` they are read as by `solve`: 0.005 is 1/200, and strings such as "1/3"
    are numbers too; this is slower. `jobs`: threads of compiled code (default: all cores); without numba one thread is
    used. `progress(done, all)` is called from time to time.

    Raises InvalidScene, naming the first number that is out of bounds, ValueError (arrays that do not broadcast, bad
    arguments).

    >>> found = solve_many(1, 1, 200, 0.5, v1=[0.05, 0.15], until=5, jobs=1)
    >>> found.events.tolist(), found.mode.tolist(), bool(found.digits.min() >= 10)
    ([1, 32], [0, 0], True)
    """
    named = dict(zip(SI, (m1, m2, a2, b, x1, v1, x2, v2, until, a1), strict=True))
    polynomial = list(listed("polynomial", polynomial))
    named |= {f"polynomial[{k}]": one for k, one in enumerate(polynomial)}
    for k, sine in enumerate(listed("sines", sines)):
        if not isinstance(sine, Sequence | np.ndarray) or len(sine) != 3:
            raise InvalidScene(f"sines[{k}] = {shown(sine)} must be a triple; give amplitude, omega, phase")
        named |= {f"sines[{k}].{name}": one for name, one in zip(("amplitude", "omega", "phase"), sine, strict=True)}
    if not isinstance(exact, bool | np.bool_):
        raise ValueError(f"exact = {shown(exact)} must be True or False; leave it out for binary numbers")
    law, limits, terms = read_law(law), _limits(max_events, keep_events, jobs, progress), len(polynomial)
    with np.errstate(over="ignore"):  # of long floats; refused as inf
        arrays = {name: _numbers(name, one, exact=exact) for name, one in named.items()}
    objects = {
        "force": _all_of("force", Force, force, NO_FORCE),
        "friction": _all_of("friction", Friction, friction, SAME_FRICTION),
    }
    shape = _common_shape(arrays | objects)
    flat = room(f"{math.prod(shape)} scenes", math.prod(shape), len(arrays))
    if not exact:
        for column, (name, array) in enumerate(arrays.items()):
            flat[:, column] = np.broadcast_to(_in_bounds(name, array), shape).ravel()
    given = [np.broadcast_to(one, shape) for one in (arrays | objects).values()]
    scene_of = partial(_scene, given, terms, law, bool(exact))
    is_usual = not exact and flat[:, 2:4].all() and np.isfinite(flat[:, 1]).all()
    if not (is_usual and force is None and friction is None):
        return _one_by_one([*map(scene_of, range(len(flat)))], limits, progress, shape)
    columns = Columns(flat, terms, law is Law.THREE_VALUED_SGN) if can_compile() and len(flat) else None
    numbers = np.ascontiguousarray(flat[:, : len(SI)])
    return Work(scene_of, limits, shape, numbers, columns=columns, goes_on=False).batch(arrays.copy, progress)


def solve_scenes(
    scenes: Sequence[Scene] | Sequence[PlaneScene],
    *,
    max_events: int = MAX_EVENTS,
    keep_events: int = 0,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> Batch:
    """Solve each scene in float64, in balls where that is in doubt or has too many steps; arrays (len(scenes),).

    Scenes on a surface must have the same number of axes; they run in balls, in `jobs` processes, which need joblib
    (default: all cores if it is installed). Scenes on a line run in one thread; `solve_many` is
    faster.

    Raises TypeError for anything but a list of scenes of one kind, ValueError for bad arguments, MissingTool.

    >>> from numerics import load_scene
    >>> solve_scenes([load_scene("velocities"), load_scene("at-rest")], jobs=1).events.tolist()
    [24, 0]
    """
    given, limits = _of_one_kind(scenes), _limits(max_events, keep_events, jobs, progress)
    if given and isinstance(given[0], PlaneScene):
        from numerics.solver.plane_batch import solve_surfaces

        with meter("solving", progress) as line:
            return solve_surfaces(given, *limits, line)
    return _one_by_one(given, limits, progress, (len(given),))


def _one_by_one(
    scenes: Sequence[Scene], limits: BatchLimits, progress: Progress | None, shape: tuple[int, ...]
) -> Batch:
    """Return the answers of scenes that are solved one after the other, in a shape."""
    numbers = np.array([_numbers_in(scene) for scene in scenes]).reshape(-1, len(SI))
    walls = np.array([bool(one.wall.pieces) for one in scenes], dtype=bool).reshape(shape)
    work = Work(scenes.__getitem__, limits._replace(jobs=1), shape, numbers, walls)
    return work.batch(partial(inputs_of, scenes, shape), progress)


def _of_one_kind(given: Any) -> Any:
    """Return what was given as a list of scenes of one kind. Raises TypeError."""
    kept = list(given) if isinstance(given, Iterable) else [given]
    if not isinstance(given, Iterable) or not all(isinstance(one, Scene | PlaneScene) for one in kept):
        raise TypeError("solve_scenes takes a list of Scenes, or of PlaneScenes; for one scene there is solve")
    kinds = {f"{one.pair.axes} axes" if isinstance(one, PlaneScene) else "one line" for one in kept}
    if len(kinds) > 1:
        raise TypeError(f"these scenes have {' and '.join(sorted(kinds))}; solve each kind in a separate call")
    return kept


def _numbers_in(scene: Scene) -> Any:
    """Return the SI numbers of a scene as floats, nan beyond their range."""
    own = {"until": scene.until} | dict(zip(STATE, scene.initial, strict=True))
    return [near(own[name] if name in own else getattr(scene.pair, name)) for name in SI]


_pair = lru_cache(maxsize=1000)(Pair)
"""Which most scenes of a batch share."""


def _scene(given: Sequence[Any], terms: int, law: Law, exact: bool, row: int) -> Scene:
    """Return the scene of a row of SI numbers, coefficients of a polynomial, numbers of sines, force and friction."""
    *numbers, force, friction = (one.flat[row] for one in given)
    if not exact:
        numbers = [Fraction(one) if math.isfinite(one) else one for one in numbers]
    m1, m2, a2, b, x1, v1, x2, v2, until, a1, *rest = numbers
    waves = [Sine(*rest[k : k + 3]) for k in range(terms, len(rest), 3)]
    if any(rest[:terms]) or any(s.amplitude for s in waves):
        own = Force((Piece(0, rest[:terms], waves),))
        force = own if force is NO_FORCE else own + force
    return Scene(_pair(m1, m2, a2, b, a1), State(x1, v1, x2, v2), until, law, force, friction)


def _all_of(name: str, kind: type, given: Any, none: Any) -> Any:
    """Return objects of one kind as an array. Raises InvalidScene."""
    array = np.asarray(none if given is None else given, dtype=object)
    if wrong := [one for one in array.flat if not isinstance(one, kind)]:
        how = "a Friction([(start, b)])" if kind is Friction else "Force.constant(3), Force.sine(amplitude, omega)"
        raise InvalidScene(f"{name} holds {shown(wrong[0])}; give {how}, or a list of them")
    return array


def _common_shape(arrays: dict[str, Any]) -> tuple[int, ...]:
    """Return the shape to which arrays broadcast. Raises ValueError, which names them."""
    shapes = {name: array.shape for name, array in arrays.items()}
    try:
        return np.broadcast_shapes(*{shape for shape in shapes.values() if shape})
    except ValueError:
        given = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise ValueError(f"these shapes do not broadcast together: {given}; give arrays of one shape") from None


def _numbers(name: str, values: Any, *, exact: bool) -> Array:
    """Return values as an array of binary64 numbers; exact ones as they are."""
    if np.ma.is_masked(values):
        raise InvalidScene(f"{name} has masked numbers; leave those scenes out, e.g. by .compressed()")
    if exact:
        return np.asarray(values, object)
    try:
        given = as_printed(np.asarray(values))
        if given.dtype.kind in "OU":  # texts are read as in a scene
            given = np.vectorize(
                lambda one: math.inf if one == "inf" else float(exact_decimal(one, name)), otypes=[np.float64]
            )(given)
        # NumPy would make real numbers of complex ones, dates and truth values, too
        if given.dtype.kind in "iuf":
            return np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        pass
    raise InvalidScene(
        f"{name} = {reprlib.repr(values)[:60]} must be real numbers in SI units; give a number or an array"
    )


def _in_bounds(name: str, array: Array) -> Array:
    """Return an array as it is. Raises InvalidScene, naming the first number that is out of bounds."""
    least, bound = -np.inf, ""
    if name in {"m1", "m2", "until"} or name.endswith(".omega"):
        least, bound = 0.0, "> 0 and "
    elif name in {"a1", "a2", "b"}:
        least, bound = -5e-324, ">= 0 and "
    wrong = ~((array > least) & ((array < np.inf) | (name == "m2")))
    if wrong.any():
        first = tuple(np.argwhere(wrong)[0].tolist())
        place = f"{name}{list(first) if first else ''} = {array[first]:g}"
        raise InvalidScene(f"{place} must be {bound}finite; correct it, or leave that scene out")
    return array
