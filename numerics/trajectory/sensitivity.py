"""Sensitivities: how events, end and any moment of a trajectory move with every number of its scene.

They are found in balls (saltation.py). A trajectory of points is solved again in balls, and the derivatives rounded:
they are right to the last digits that its arithmetic has.

An initial state with v1 = v2 has neighbours with v1 != v2, which slip:

    stick   the slip has a vanishing length and keeps the momentum: both velocities change by (m1 dv1 + m2 dv2)/M
    slip    the derivative along v1 - v2 is one-sided: towards the sign of v1 - v2 that follows. On the other side the
            neighbour meets the surface at once, and its bodies share the momentum first

For a1 = 0 the derivative with respect to a1 is one-sided, towards a1 > 0. On the critical orbit (E = E_cr exactly,
stuck for ever) neighbours with more energy slip, by amounts that vanish faster: the derivatives are those of the stuck
pair. A pair that sticks under more load than b, up to b_static or under the law three-valued-sgn, comes apart on one
side of v1 = v2: then, too, the derivative is the one towards the other side. By a start at t = 0 derivatives are one-
sided, towards a later one; by `until`, if u or b jumps there, towards a shorter run. Where a piece of force and one of
friction begin together, each is moved alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from flint import arb

from numerics.arithmetic.ball import EXACT, Ball, digits_within, exact_middle
from numerics.arithmetic.precision import precision
from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import EventUndecided, InvalidScene, NotDifferentiable, OutOfRange
from numerics.habits import right_word
from numerics.linear.corners import corner
from numerics.linear.pieces import pieces_of
from numerics.meter import meter
from numerics.scene import Scene
from numerics.scene.decimals import shown
from numerics.scene.model import parameters, require_kind
from numerics.trajectory.answer import Side
from numerics.trajectory.columns import STATE, Array, Counts
from numerics.trajectory.comparison import as_ball
from numerics.trajectory.rendering import with_radius
from numerics.trajectory.rows import same_ball
from numerics.trajectory.run import run_scene
from numerics.trajectory.saltation import Chain
from numerics.trajectory.times import exact_time
from numerics.trajectory.trajectory import Trajectory
from numerics.trajectory.variation import legs

if TYPE_CHECKING:
    from numerics.scene.decimals import Times

_GUARD_BITS = 64
"""So many bits more than those of the trajectory are worked with."""
_TRIES = 6
"""So many times the precision is raised at most."""
_TABLE_DIGITS = 6


@dataclass(frozen=True)
class Sensitivity:
    """Partial derivatives in SI units with respect to `wrt`, the last axis; enclosed, if the trajectory is of balls.

    Float arrays for float64, otherwise object arrays of the arithmetic's numbers.

    >>> from numerics import load_scene, solve
    >>> slopes = sensitivities(solve(load_scene("velocities")))
    >>> slopes.wrt, slopes.t.shape, slopes.y.shape, slopes.final.shape
    (('x1', 'v1', 'x2', 'v2', 'm1', 'm2', 'a2', 'b', 'a1'), (24, 9), (24, 4, 9), (4, 9))
    >>> [round(float(one[slopes.wrt.index("b")]), 5) for one in (slopes.t[20], slopes.final[1], slopes.energy)]
    [-0.08176, -1.82476, 0.00181]
    """

    wrt: tuple[str, ...]
    t: Array
    """Of the time of every event, shape (k, p), with p = 9 without a force."""
    y: Array
    """Of x1, v1, x2, v2 at every event, shape (k, 4, p): total derivatives, the time of the event moves too."""
    final: Array
    """Of x1, v1, x2, v2 at the fixed horizon, shape (4, p); at the last event if the cap on events ended the run."""
    energy: Array
    """Of the energy there, shape (p,)."""

    def __repr__(self) -> str:
        """Return a short summary."""
        return f"Sensitivity of {len(self.t)} events and the final state by {', '.join(self.wrt)}"


@overload
def sensitivities(trajectory: Trajectory, *, wrt: Sequence[str] | None = None) -> Sensitivity: ...


@overload
def sensitivities(
    trajectory: Trajectory, t: Times, side: Side = "right", wrt: Sequence[str] | None = None
) -> Array: ...


def sensitivities(
    trajectory: Trajectory, t: Times | None = None, side: Side = "right", wrt: Sequence[str] | None = None
) -> Sensitivity | Array:
    """Return the sensitivities of a trajectory; with `t`, the derivatives of (x1, v1, x2, v2) at the time(s) t (s).

    `wrt` are names of `parameters(scene)`, in the order of the last axis; only these are computed. Left out: all of
    them, but for the numbers of a signal of more than 100 pieces. By a b = 0, of the pair or a piece, there is
    none, and none by a1 = 0 where the wall jumps.

    With `t` an array of shape (4, p) for a number, (4, p, ...) for an array of any shape: partial derivatives at that
    fixed time (0 by `until`). At an event they jump, and `side`
    says which of both is meant; a time is given as to `Trajectory.sol`.

    Enclosed for a trajectory of balls, else rounded: right to 16 digits in float64, to those of the arithmetic
    otherwise. Digits count relative to the largest derivative of the same quantity by the same number; the precision is
    raised until all have those that were asked for.

    Raises TypeError for what is no trajectory; EventUndecided if the events are not those of the trajectory, or if a
    derivative is not enclosed; OutOfRange if one leaves the range of float64; NotDifferentiable, under a force, where a
    motion has no derivative by its data, as where an event falls on a jump; ValueError for a time outside [0, end].

    A fit of b and m1 to samples of v1 by the method of Gauss and Newton:

    >>> from fractions import Fraction
    >>> import numpy as np
    >>> from numerics import Pair, Scene, State, solve
    >>> def solved(b, m1): return solve(Scene(Pair(Fraction(m1), 1, 200, Fraction(b)), State(v1="0.15"), 1))
    >>> times = np.linspace(0, 1, 20)
    >>> measured, guess = solved(0.05, 1.0).sol(times)[1], np.array([0.0525, 1.05])
    >>> for _ in range(5):
    ...     trajectory = solved(*guess)
    ...     slopes = sensitivities(trajectory, times, wrt=["b", "m1"])[1]  # of v1
    ...     guess += np.linalg.lstsq(slopes.T, measured - trajectory.sol(times)[1], rcond=None)[0]
    >>> guess.round(12).tolist()
    [0.05, 1.0]
    """
    require_kind("sensitivities", trajectory, Trajectory, "give it solve(scene) of a scene on one line")
    names = _names(trajectory, wrt)
    if t is None:
        found = enclosures(trajectory, names)
        arrays = (found.t, found.y, found.final, found.energy)
        return Sensitivity(found.wrt, *(_as_numbers(trajectory.arithmetic, one) for one in arrays))
    asked, own_rows = np.asarray(t, dtype=object), trajectory.row_at(t, side)
    begun = _rows_begun(trajectory, t)

    def at_times(balls: Trajectory, chain: Chain) -> tuple[Array, ...]:
        def slopes(rows: Counts, since: Array) -> Array:
            found = [chain.at(*one) for one in zip(rows, since, strict=True)]
            return np.reshape(found, (len(rows), 4 * len(chain.column))).T

        exact = (as_ball(one if hasattr(one, "man_exp") else exact_time(one)) for one in asked.flat)
        times = np.fromiter(exact, object, asked.size)
        if trajectory.arithmetic.name == "ball":
            times[[*begun]] = balls.row_times[[*begun.values()]]
            found = balls.row_values(slopes, times, side)
        else:  # an event is where the trajectory has it, as rounded as that is
            found = slopes(own_rows, times - balls.row_times[own_rows])
        return (np.array([*found.T.reshape(-1, 4, len(chain.column)), *(y for _, y, _ in chain.events)]),)

    rows = _enclosed(trajectory, at_times, names)[0][: asked.size]
    states = _as_numbers(trajectory.arithmetic, np.moveaxis(rows, 0, -1))
    return states.reshape(*states.shape[:2], *asked.shape)


def _rows_begun(trajectory: Trajectory, t: Times) -> dict[int, int]:
    """Return which of some times begin a row of a run in balls, at an event or with a piece, and that row.

    The same run with other digits has another ball there.
    """
    if trajectory.arithmetic.name != "ball":
        return {}
    with trajectory.context():
        times, rows = trajectory._times(t).ravel(), trajectory.row_at(t)
        both = enumerate(zip(times, rows.tolist(), strict=True))
        return {place: row for place, (time, row) in both if same_ball(trajectory.row_times[row], time)}


def _names(trajectory: Trajectory, wrt: Sequence[str] | None) -> tuple[str, ...]:
    """Return the names of the numbers by which to derive. Raises ValueError for what names none."""
    scene, numbers = trajectory.scene, parameters(trajectory.scene)
    known = {name: one for name, one in numbers.items() if one or not _is_b(name)}
    if not _takes_damper(scene):
        del known["a1"]
    if wrt is None:
        return tuple(name for name in parameters(scene, tables=False) if name in known)
    if isinstance(wrt, str) or not (names := tuple(wrt)):
        raise ValueError(f'wrt = {shown(wrt)} must be names of numbers of the scene, such as ["b", "m1"]')
    for name in names:
        if name in numbers and name not in known:
            raise ValueError(f"wrt names {shown(name)}, which is 0: by that there is no derivative; leave it out")
        if name not in known or names.count(name) > 1:
            why = "once each" if name in known else right_word(str(name), [*known])
            raise ValueError(f"wrt names {shown(name)}, which is no number of this scene, or twice: {why}")
    return names


def _takes_damper(scene: Scene) -> bool:
    """Return whether a scene may have a damper: not where the wall jumps, which would be a blow through it."""
    try:
        return scene.pair.a1 > 0 or bool(scene.replace(a1=1))
    except InvalidScene:
        return False


def _is_b(name: str) -> bool:
    """Return whether a number is the b of the pair or of a piece; that of a point may be 0 beside what is by place."""
    return name == "b" or (name.startswith("friction[") and name.endswith("].b"))


def enclosures(trajectory: Trajectory, names: tuple[str, ...] | None = None) -> Sensitivity:
    """Return the sensitivities as balls, whatever the trajectory is made of. Raises what `sensitivities` does."""
    names = names or _names(trajectory, None)

    def of_events(balls: Trajectory, chain: Chain) -> tuple[Array, ...]:
        return tuple(map(np.array, zip(*chain.events, chain.final(balls.final_state), strict=True)))

    times, states, energies = _enclosed(trajectory, of_events, names)
    return Sensitivity(names, times[:-1], states[:-1], states[-1], energies[-1])


def _enclosed(
    trajectory: Trajectory, asked: Callable[[Trajectory, Chain], tuple[Array, ...]], names: tuple[str, ...]
) -> tuple[Array, ...]:
    """Return arrays of derivatives in balls, at a precision that gives them the digits that were asked for.

    What is asked of a chain has samples along the first axis, whose largest is what digits are relative to, and all
    numbers of the scene along the last one. Raises NotDifferentiable for a scene that has no derivatives by its data.
    """
    scene, arithmetic, count = trajectory.scene, trajectory.arithmetic, trajectory.record.events
    until = math.inf if trajectory.reached else arithmetic.to_float(trajectory.event_times[-1])
    if scene.is_forced and (what := corner(scene, pieces_of(scene), until)) is not None:
        raise NotDifferentiable(f"this scene has no derivatives: {what}; change it slightly")
    balls = trajectory if arithmetic.name == "ball" else None
    wanted = (trajectory.digits or 0) if balls else 17 if arithmetic.name == "float64" else arithmetic.digits
    digits = arithmetic.digits + (0 if balls else 17)
    for attempt in range(_TRIES):
        try:
            with meter("solving") as line:  # one event more than were found shows a lost one
                balls = balls or run_scene(scene, Ball(digits), count + trajectory.reached, line)
        except EventUndecided:
            if attempt + 1 == _TRIES:
                raise
            digits *= 2
            continue
        if not np.array_equal(balls.row_signs, trajectory.row_signs):
            raise EventUndecided("are the events those of the trajectory?", f"{balls.record.events} events", digits)
        try:
            with meter("derivatives") as line, precision(Ball(digits).bits + _GUARD_BITS):
                found = asked(balls, Chain(scene, legs(balls), names, line))
                right = _right_digits(found, digits)
        except EventUndecided:
            if attempt + 1 == _TRIES:
                raise
            balls, digits = None, 2 * digits
            continue
        if right >= wanted:
            break
        balls, digits = None, max(digits + wanted - right + 3, 2 * digits if attempt else 0)
    if wrong := [one for array in found for one in array.flat if not one.is_finite()]:
        raise EventUndecided("has the scene this derivative?", str(wrong[0]), digits)
    return found


def _right_digits(arrays: tuple[Array, ...], digits: int) -> int:
    """Return the digits that all derivatives have, relative to the largest along the first axis.

    Where all of them may be 0 they count as 0 to a quarter of the digits that were worked with.
    """
    least = EXACT
    for array in arrays:
        for column in array.reshape(len(array), -1).T if len(array) else ():
            radius, largest = max(one.rad() for one in column), max(abs(one).upper() for one in column)
            is_zero = all(one.contains(0) for one in column)
            least = min(least, digits // 4 if is_zero and radius > 0 else digits_within(radius, largest, largest))
    return least


def _as_numbers(arithmetic: Arithmetic, array: Array) -> Array:
    """Return balls in the numbers of an arithmetic. Raises OutOfRange."""
    if arithmetic.name == "ball":
        return array
    in_floats = arithmetic.name == "float64"
    convert = Ball.to_float if in_floats else lambda one: arithmetic.number(exact_middle(one))
    with arithmetic.context():
        found: Array = np.vectorize(convert, otypes=[float if in_floats else object])(array)
    if in_floats and not np.isfinite(found).all():
        raise OutOfRange('a derivative left the range of float64 (1e-308 to 1e308); use arithmetic="ball"')
    return found


def add_sensitivities(record: dict[str, Any], trajectory: Trajectory) -> None:
    """Put derivatives beside the numbers of a JSON record: `"sensitivity": {"t": {"x1": ...}, ...}` in every event.

    The final state has those of x1, v1, x2, v2 and energy. Decimal strings as in the record: radii beside balls, else
    the digits that are right.
    """
    name_of, found = trajectory.arithmetic.name, enclosures(trajectory)
    digits = trajectory.digits or (17 if name_of == "float64" else trajectory.arithmetic.digits)

    def written(name: str, value: arb) -> dict[str, str]:
        if name_of == "ball":
            return with_radius(name, value, digits)
        return {name: str(value.str(digits, radius=False))}

    for row, derivatives in zip((*record["events"], record["final"]), _rows(found), strict=True):
        row["sensitivity"] = {of: reduce(or_, map(written, found.wrt, one)) for of, one in derivatives.items()}


def sensitivity_arrays(trajectory: Trajectory) -> dict[str, Array]:
    """Return the derivatives in binary64, and the names that their last axis stands for, for a NumPy archive."""
    found = sensitivities(trajectory)
    arrays = {f"sensitivity_{name}": trajectory.floats(getattr(found, name)) for name in ("t", "y", "final", "energy")}
    return arrays | {"sensitivity_wrt": np.array(found.wrt)}


def sensitivity_table(trajectory: Trajectory) -> str:
    """Return the derivatives of the last event's time and of the final state as text: SI units, right digits only."""
    found = enclosures(trajectory)
    *events, final = _rows(found)
    columns = {"the last event's t": events[-1]["t"]} if events else {}
    columns |= {f"final {name}": one for name, one in final.items()}
    rows = [("derivative", *(f"of {label}" for label in columns))]
    for name, *values in zip(found.wrt, *columns.values(), strict=True):
        rows.append((f"by {name}", *(one.str(_TABLE_DIGITS, radius=False) for one in values)))
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join("  ".join(map(str.ljust, row, widths)).rstrip() for row in rows)


def _rows(found: Sensitivity) -> Iterator[dict[str, Array]]:
    """Yield the derivatives of every event, and then those of the final state, by what they are of."""
    for t, y in zip(found.t, found.y, strict=True):
        yield {"t": t, **dict(zip(STATE, y, strict=True))}
    yield {**dict(zip(STATE, found.final, strict=True)), "energy": found.energy}
