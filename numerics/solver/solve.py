"""Solve a scene: the cheapest arithmetic that is sure of the events, or has the digits that are asked for."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import takewhile
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypedDict, Unpack, get_args, overload

from numerics.arithmetic.attempts import SPARE_DIGITS, exhausted, to_digits
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import EventUndecided, InvalidScene, NumericsError, OutOfRange
from numerics.meter import meter
from numerics.scene import Scene
from numerics.scene.decimals import Exact, require_digits, require_function, require_one_of, shown
from numerics.scene.model import BUILD, require_kind
from numerics.scene.plane import PlaneScene
from numerics.trajectory.columns import Array
from numerics.trajectory.digits import proved_digits
from numerics.trajectory.run import MAX_EVENTS, Progress, run_scene
from numerics.trajectory.times import require_times
from numerics.trajectory.trajectory import Trajectory

if TYPE_CHECKING:
    from numerics.plane.trajectory import PlaneTrajectory

ArithmeticName = Literal["float64", "mpmath", "ball"]
MAX_DIGITS = 20_000
DIGITS = 15
"""Proved digits of balls where none are asked for."""
_WORTH_A_TRY = 15
"""Right digits up to which float64 is tried."""
_MOST_IN_BALLS = 10_000
"""With more events what float64 has stands, also without digits: balls would take minutes."""
_FLOAT64 = Float64()
_MANY_DIGITS = 560
_LADDER = (_FLOAT64, *map(Ball, (34, 68, 136, *(_MANY_DIGITS << k for k in range(11)))))
"""What decides a sequence, and finds digits, in the order in which they are tried: all that MOST_DIGITS allow."""
_OF_A_SURFACE = 6, 2
"""Working digits beyond those that are wanted, and how often they are doubled, where a surface decides nothing."""


class Limits(NamedTuple):
    """What bounds a solve, and what takes its progress."""

    events: int = MAX_EVENTS
    digits: int = MAX_DIGITS
    progress: Progress | None = None

    def allow(self, arithmetic: Arithmetic) -> bool:
        """Return whether an arithmetic may be tried."""
        return arithmetic is _FLOAT64 or arithmetic.digits <= self.digits

    def run(self, scene: Any, arithmetic: Arithmetic) -> Any:
        """Solve a scene once."""
        if not isinstance(scene, PlaneScene):
            return run_scene(scene, arithmetic, self.events, self.progress)
        from numerics.plane.solve import run_plane

        line = partial(solve_to_digits, limits=self._replace(digits=MAX_DIGITS))
        return run_plane(scene, arithmetic.digits, self.events, self.progress, line)


class _Options(TypedDict, total=False):
    digits: int | None
    arithmetic: ArithmeticName | None
    t_eval: Sequence[Exact] | Array | None
    max_events: int
    max_digits: int
    progress: Progress | None


@overload
def solve(scene: PlaneScene, **options: Unpack[_Options]) -> PlaneTrajectory: ...


@overload
def solve(scene: Scene, **options: Unpack[_Options]) -> Trajectory: ...


def solve(
    scene: Scene | PlaneScene,
    *,
    digits: int | None = None,
    arithmetic: ArithmeticName | None = None,
    t_eval: Sequence[Exact] | Array | None = None,
    max_events: int = MAX_EVENTS,
    max_digits: int = MAX_DIGITS,
    progress: Progress | None = None,
) -> Trajectory | PlaneTrajectory:
    """Solve a scene and return its Trajectory; for a PlaneScene, a PlaneTrajectory, in balls: `digits` (15) are proved.

    `arithmetic.name` of the result is the arithmetic used; `tried` lists those tried before, and why they failed.

    Without `digits` and `arithmetic`: float64 with error bounds (Trajectory.accuracy). If these do not decide the
    sequence of events, or leave no right digit of a quantity (trajectory/digits.py): balls of 34, 68, 136 and 560
    working digits, and of more while these lead further. If none up to `max_digits` has a right digit, the status is
    NO_RIGHT_DIGIT and `success` is False.

    With `digits` = N: N right digits of every event time and state, and of state, energy and excess at the end. This
    is float64 where its bounds leave N <= 15 digits, else balls, whose precision is raised until the digits are proved.
    Digits of a time are relative to that time; all others are relative to the largest such quantity along the run
    (trajectory/digits.py): x1 and x2 to the largest |position|, v1 and v2 to the largest |velocity|.

    With `arithmetic`: "float64" only; "ball" with `digits` or 15 proved digits; "mpmath" with `digits` or 30, without
    bounds: a second, independent computation of the free pair (a1 = 0, no force, constant b), and of no other scene.

    `max_digits`: limit on working digits; float64 keeps its 15 under any limit.
    `t_eval`: times (s), in order, at which `t`, `y` and `energy` are given, instead of at the events.
    `progress(events, fraction)` is called from time to time. A float in a scene is read as the decimal that it prints:
    0.1 is 1/10. (`solve_many` reads arrays as binary numbers.)

    Threads may call it at once; above 64 bits they take turns, as flint and mpmath have one precision for all of them.

    Raises EventUndecided (at the limit on precision), PrecisionExhausted (N digits were not reached), OutOfRange (a
    number does not fit float64), TypeError (no scene), ValueError (bad arguments).

    >>> from numerics import load_scene
    >>> scene = load_scene("velocities")
    >>> run = solve(scene)
    >>> run.arithmetic.name, len(run.events), round(run.events[0].t, 6), run.y.shape
    ('float64', 24, 0.106887, (4, 26))
    >>> proved = solve(scene, digits=40)
    >>> proved.arithmetic.name, proved.events[0].t.str(40, radius=False)
    ('ball', '0.1068865420206447367884349575982909425797')
    >>> solve(scene, t_eval=[0, 0.5, 1]).y.shape
    (4, 3)
    """
    if not isinstance(scene, PlaneScene):
        require_kind("solve", scene, Scene, BUILD)
    if arithmetic is not None:
        require_one_of("arithmetic", arithmetic, get_args(ArithmeticName))
    if digits is not None or max_events is not MAX_EVENTS or max_digits is not MAX_DIGITS:
        require_digits(1 if digits is None else digits, max_digits, max_events=max_events)
        if digits is not None and arithmetic == "float64":
            raise ValueError(
                f"digits = {digits} with float64, which has its own digits; leave digits out, or arithmetic"
            )
        if digits is not None and digits > max_digits:
            raise exhausted(digits, max_digits)
    if progress is not None:
        require_function("progress", progress, "(events, fraction)")
    if t_eval is not None:
        require_times(t_eval, scene.until)
    with meter("solving", progress, ticks=False) as line:
        found = _solve(scene, digits, arithmetic, Limits(max_events, max_digits, line))
    return found if t_eval is None else found.but(t_eval=t_eval)


def _solve(scene: Any, digits: int | None, arithmetic: str | None, limits: Limits) -> Any:
    on_surface = isinstance(scene, PlaneScene)
    if on_surface and arithmetic not in (None, "ball"):
        why = "is available on a line only: a surface is solved in balls; leave it out"
        raise InvalidScene(f"arithmetic = {shown(arithmetic)} {why}")
    if arithmetic == "ball" or on_surface:
        return solve_to_digits(scene, digits or DIGITS, limits)
    if arithmetic is None:
        return _solve_surely(scene, limits) if digits is None else _solve_cheaply(scene, digits, limits)
    if arithmetic == "float64":
        return limits.run(scene, _FLOAT64)
    working = (digits or 30) + SPARE_DIGITS
    if working > limits.digits:
        raise exhausted(working - SPARE_DIGITS, limits.digits)
    return limits.run(scene, Multiprecision(working))


def _solve_surely(scene: Scene, limits: Limits) -> Trajectory:
    """Return a trajectory in float64; where its bound leaves the events open, or no digit, in the next arithmetic.

    The first one that knows the events, where none has a right digit of everything.
    """
    best: Trajectory | None = None
    refused: NumericsError | None = None
    tried: list[str] = []
    places = [""]
    for arithmetic in takewhile(limits.allow, _LADDER):
        if best is None and arithmetic.digits > _MANY_DIGITS and places[-1] in places[-2:-1]:
            break  # what more digits have not led beyond is a tie; else they lead further
        if best is not None and best.record.events > _MOST_IN_BALLS:
            break
        try:
            found = limits.run(scene, arithmetic)
        except (EventUndecided, OutOfRange) as error:
            refused = error
            places.append(error.enclosure if isinstance(error, EventUndecided) else places[-1])
            tried.append(f"{arithmetic.name} with {arithmetic.digits} digits: {error}")
            continue
        if not found.without_digits:
            return found.but(tried="; ".join(tried)) if tried else found
        best = found if best is None else best
        tried.append(f"{arithmetic.name} has no right digit of the {' and '.join(found.without_digits)}")
    if best is None:
        raise refused or EventUndecided("which event comes next", "", 0)
    return best.but(tried="; ".join(tried))


def _solve_cheaply(scene: Scene, digits: int, limits: Limits) -> Trajectory:
    """Return a trajectory in float64, if its error bounds leave enough digits, else a proved one."""
    tried = ""
    if digits <= _WORTH_A_TRY:
        try:
            found = limits.run(scene, _FLOAT64)
            tried = f"float64 has {found.right_digits} right digits by its error bounds"
            if found.right_digits >= digits:
                return found.but(digits=digits, tried=tried)
        except (EventUndecided, OutOfRange) as error:
            tried = f"float64 cannot: {error}"
        tried += "; "
    return solve_to_digits(scene, digits, limits).but(tried=f"{tried}{digits} are asked for")


def solve_to_digits(scene: Any, digits: int, limits: Limits) -> Any:
    """Raise the working precision until `digits` digits are right; the digits lost in one try are added in the next."""

    def attempt(arithmetic: Ball) -> tuple[Any, int]:
        found = limits.run(scene, arithmetic)
        return found, proved_digits(found) if found.digits is None else found.digits

    how = _OF_A_SURFACE if isinstance(scene, PlaneScene) else ()
    return to_digits(attempt, digits, limits.digits, *how).but(digits=digits)
