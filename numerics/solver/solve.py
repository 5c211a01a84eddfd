"""The solver: an explicit mode state machine, locate -> flow -> snap -> record. It never samples."""

from __future__ import annotations

import operator
import sys
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Literal

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.double_double import DoubleDouble
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.protocol import Arithmetic, decide_sign
from numerics.errors import EventUndecided, OutOfRange, PrecisionExhausted
from numerics.kernel.compilation import can_compile
from numerics.motion.frame import Frame
from numerics.motion.modes import event_kind
from numerics.old.binary64 import solve_binary64
from numerics.old.binary64_viscous import solve_viscous
from numerics.old.double_double import solve_double_double
from numerics.old.motion import Motion
from numerics.old.start import initial_motion
from numerics.scene import Scene
from numerics.trajectory.trajectory import Event, Segment, Status, Trajectory

ArithmeticName = Literal["float64", "double-double", "mpmath", "ball"]
MAX_EVENTS = 250_000
MAX_DIGITS = 20_000
_GUARD_DIGITS = 12
"""Working digits beyond those asked for, where nothing is known of the scene."""
_FLOAT64_DIGITS, _DOUBLE_DOUBLE_DIGITS, _SPARE_DIGITS = 16, 32, 4
"""Digits that are there before a run; what it loses of them, and a few to spare, balls will need beyond those asked."""
_IN_FLOAT64 = 15
_WITHIN_DOUBLE_DOUBLE = 37
"""Digits asked for and digits to spare, up to which double-double is worth a try: it has 16 more than float64."""
_MANY_EVENTS = 20_000
"""So many events cost balls more than the second that numba takes to come."""


def solve(
    scene: Scene,
    *,
    digits: int | None = None,
    arithmetic: ArithmeticName | None = None,
    max_events: int = MAX_EVENTS,
    max_digits: int = MAX_DIGITS,
    progress: Callable[[int, float], None] | None = None,
) -> Trajectory:
    """Solve a scene and return its Trajectory.

    With `digits` = N and no arithmetic, the cheapest one that delivers N right digits of every event time and state and
    of the final state, relative to each value. (In balls a value that may be 0 counts as right if it is below
    10^(-4 N) of its scale.) First float64, if its own error bounds (Trajectory.accuracy) leave so many. Then
    double-double (a1 = 0; 31 digits, some of them lost), if its bounds do and numba is in use already, or so many
    events make it worth the second that it takes to come. Else balls, their precision raised until the digits are
    proved. `tried` says what was chosen and why. Without `digits`, float64; mpmath works with `digits` or 30.
    `progress(events, fraction)` is called now and then.

    Raises EventUndecided (what could not be decided, at the cap on precision), PrecisionExhausted (N digits were not
    reached), OutOfRange (a number does not fit float64), ValueError (bad arguments).
    """
    for name, value in (("digits", digits), ("max_events", max_events), ("max_digits", max_digits)):
        if value is not None:
            require_whole(name, value, 1)
    if arithmetic is None and digits is not None:
        return _solve_cheaply(scene, digits, max_events, max_digits, progress)
    if arithmetic in {None, "float64"}:
        if digits is not None:
            raise ValueError("float64 works with 53 bits; leave digits out, or leave the choice of arithmetic out")
        return _solve_in_float64(scene, max_events, progress)
    if arithmetic == "double-double":
        if digits is not None:
            raise ValueError(
                "double-double works with 31 digits; leave digits out, or leave the choice of arithmetic out"
            )
        return _solve_in_double_double(scene, max_events, progress)
    if arithmetic == "mpmath":
        working = (digits or 30) + _GUARD_DIGITS
        _require_within_cap(working, digits or 30, max_digits)
        return integrate(scene, Multiprecision(working), max_events, progress)
    if arithmetic == "ball":
        return _solve_to_digits(scene, digits or 15, _GUARD_DIGITS, max_events, max_digits, progress)
    raise ValueError(f"arithmetic = {arithmetic!r} is not one of float64, double-double, mpmath, ball")


def require_whole(name: str, value: Any, least: int) -> None:
    """Raise ValueError, naming the argument, unless it is a whole number from `least` to 2^62."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise ValueError(f"{name} = {str(value)[:40]!r} must be a whole number")
    if not least <= operator.index(value) <= 2**62:
        raise ValueError(f"{name} = {str(value)[:40]} must be at least {least} and at most 2^62")


def _solve_in_float64(scene: Scene, max_events: int, progress: Callable[[int, float], None] | None) -> Trajectory:
    """Solve a scene by the kernels; where a number leaves the range, the general loop tells which."""
    kernels = solve_viscous if scene.pair.a1 > 0 else solve_binary64
    found = kernels(scene, max_events, progress)
    return found or integrate(scene, Float64(), max_events, progress)


def _solve_in_double_double(scene: Scene, max_events: int, progress: Callable[[int, float], None] | None) -> Trajectory:
    """Solve a scene by the kernels; the general loop has the same digits for a1 > 0 and beyond the kernels' range."""
    found = solve_double_double(scene, max_events, progress) if scene.pair.a1 == 0 else None
    return found or integrate(scene, DoubleDouble(), max_events, progress)


def _solve_cheaply(
    scene: Scene, digits: int, max_events: int, max_digits: int, progress: Callable[[int, float], None] | None
) -> Trajectory:
    """Return a trajectory in float64, or double-double, if its error bounds leave enough digits, else a proved one.

    What one of them has lost of its digits is also what the next will lose.
    """
    tried, guard, events = [], _GUARD_DIGITS, 0
    numba_is_here = can_compile() and "numba" in sys.modules
    if digits <= _IN_FLOAT64 or not numba_is_here:
        floats, reached, why = _attempt(_solve_in_float64, scene, max_events, progress)
        tried.append(f"float64 {why}")
        if floats is not None and reached >= digits:
            return replace(floats, digits=digits, tried=tried[0])
        events = 0 if floats is None else len(floats.events)
        guard = _FLOAT64_DIGITS + _SPARE_DIGITS - reached if reached else guard
    # in plain Python double-double is slower than balls
    fast = numba_is_here or (can_compile() and events > _MANY_EVENTS)
    if fast and scene.pair.a1 == 0 and digits + guard <= _WITHIN_DOUBLE_DOUBLE:
        doubles, reached, why = _attempt(_solve_in_double_double, scene, max_events, progress)
        tried.append(f"double-double {why}")
        if doubles is not None and reached >= digits:
            return replace(doubles, digits=digits, tried="; ".join(tried))
        guard = _DOUBLE_DOUBLE_DIGITS + _SPARE_DIGITS - reached if reached else guard
    balls = _solve_to_digits(scene, digits, guard, max_events, max_digits, progress)
    return replace(balls, tried="; ".join([*tried, f"{digits} are asked for"]))


def _attempt(
    method: Callable[..., Trajectory], scene: Scene, max_events: int, progress: Callable[[int, float], None] | None
) -> tuple[Trajectory | None, int, str]:
    """Return a trajectory of a method that bounds its errors, the digits that they leave, and words on both."""
    from numerics.trajectory.accuracy import bounded_digits, kernel_accuracy

    try:
        found = method(scene, max_events, progress)
    except (EventUndecided, OutOfRange, ArithmeticError) as error:
        return None, 0, f"cannot: {error}"
    if found.bounds is None:
        return found, 0, "has no error bounds here"
    if not found.bounds.end.certain:
        return found, 0, "leaves the sequence of events open"
    reached = bounded_digits(found) if isinstance(found.arithmetic, DoubleDouble) else kernel_accuracy(found).digits
    return found, reached, f"has {reached} right digits by its error bounds"


def _require_within_cap(working: int, digits: int, max_digits: int) -> None:
    if working > max_digits:
        raise PrecisionExhausted(
            f"{digits} right digits need more than {max_digits} working digits; raise max_digits (--max-digits)"
        )


def _solve_to_digits(
    scene: Scene,
    digits: int,
    guard: int,
    max_events: int,
    max_digits: int,
    progress: Callable[[int, float], None] | None,
) -> Trajectory:
    """Raise the working precision until `digits` digits are right; the digits lost in one try are added in the next."""
    from numerics.trajectory.accuracy import proved_digits

    working = digits + guard
    while True:
        _require_within_cap(working, digits, max_digits)
        undecided: EventUndecided | None = None
        try:
            trajectory = integrate(scene, Ball(working), max_events, progress)
            reached = proved_digits(trajectory)
        except EventUndecided as error:
            undecided, reached = error, 0
        if undecided is None and reached >= digits:
            return replace(trajectory, digits=digits)
        if undecided is not None and working * 2 > max_digits:
            raise undecided
        working = max(working + (digits - reached) + 5, working * 2 if undecided else 0)


def integrate(
    scene: Scene,
    arithmetic: Arithmetic,
    max_events: int = MAX_EVENTS,
    progress: Callable[[int, float], None] | None = None,
) -> Trajectory:
    """Solve a scene once, in one arithmetic at its working precision. Raises EventUndecided, OutOfRange."""
    with arithmetic.context():
        frame = Frame(arithmetic, scene.pair)
        horizon = frame.rate * arithmetic.number(scene.until)
        segments: list[Segment] = []
        events: list[Event] = []
        motion: Motion = initial_motion(frame, scene)
        start = rest = arithmetic.number(0)
        while True:
            duration = motion.duration()  # locate
            if duration is None:
                status = Status.STUCK_FOR_EVER
                break
            end, end_rest = arithmetic.accumulate(start, rest, duration)
            if decide_sign(arithmetic, end - horizon, "does the next event come before the horizon?") > 0:
                status = Status.REACHED_HORIZON
                break
            if len(events) == max_events:
                status = Status.EVENT_LIMIT
                break
            segments.append(Segment(motion, start, end, duration))
            following = motion.successor()  # flow and snap
            events.append(_event(frame, motion, following, end))
            motion, start, rest = following, end, end_rest
            if progress is not None and len(events) % 1000 == 0:
                progress(len(events), arithmetic.to_float(end / horizon))
        if status is not Status.EVENT_LIMIT:
            segments.append(Segment(motion, start, horizon, (horizon - start) - rest))
        return Trajectory(scene, frame, tuple(segments), tuple(events), status)


def _event(frame: Frame, before: Motion, after: Motion, tau: object) -> Event:
    reduced = after.start
    kind = event_kind(before.mode, after.mode)
    return Event(frame.si_time(tau), kind, before.mode, after.mode, frame.si_state(reduced), reduced)
