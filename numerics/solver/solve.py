"""Solve a scene: choose the arithmetic that the asked digits need, by the scene and the digits alone."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.double_numbers import DoubleDouble
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.errors import EventUndecided, OutOfRange, PrecisionExhausted
from numerics.run.forced_sharp import run_forced_sharply
from numerics.run.one import MAX_EVENTS, Progress, run_scene
from numerics.scene import Scene
from numerics.scene.decimals import require_whole
from numerics.trajectory.digits import proved_digits
from numerics.trajectory.trajectory import Trajectory

ArithmeticName = Literal["float64", "double-double", "mpmath", "ball"]
MAX_DIGITS = 20_000
_GUARD_DIGITS = 12
"""Working digits beyond those asked for, where nothing is known of the scene."""
_FLOAT64_DIGITS, _DOUBLE_DOUBLE_DIGITS, _SPARE_DIGITS = 16, 32, 4
"""Digits that are there before a run; what it loses of them, and a few to spare, balls will need beyond those asked."""
_IN_FLOAT64, _IN_DOUBLE_DOUBLE = 15, 28
"""Digits up to which each is worth a try."""


def solve(
    scene: Scene,
    *,
    digits: int | None = None,
    arithmetic: ArithmeticName | None = None,
    t_eval: Any = None,
    max_events: int = MAX_EVENTS,
    max_digits: int = MAX_DIGITS,
    progress: Progress | None = None,
) -> Trajectory:
    """Solve a scene and return its Trajectory.

    With `digits` = N and no arithmetic, the cheapest one that delivers N right digits of every event time and state and
    of the final state, relative to each value. (In balls a value that may be 0 counts as right if it is below
    10^(-4 N) of its scale.) First float64, if its own error bounds (Trajectory.accuracy) leave so many; then
    double-double (a1 = 0; 31 digits, some of them lost), if its bounds do; else balls, their precision raised until the
    digits are proved. The choice depends on the scene and the digits alone; `tried` says what was chosen and why.
    Without `digits`, float64 (under a force, where its bounds leave less than 10 digits of 1000 events or fewer, balls
    that are rounded to it); mpmath works with `digits` or 30. `t_eval`: times (s) at which `t`, `y` and `energy` are
    given, instead of at the events. `progress(events, fraction)` is called now and then.

    A float in a scene is read as the decimal that it shows: 0.1 is 1/10. (`solve_many` reads arrays as binary numbers.)

    Raises EventUndecided (what could not be decided, at the cap on precision), PrecisionExhausted (N digits were not
    reached), OutOfRange (a number does not fit float64), TypeError (no scene), ValueError (bad arguments).
    """
    if not isinstance(scene, Scene):
        raise TypeError(
            f"solve takes a Scene, not a {type(scene).__name__}; build Scene(Pair(...), State(...), until=...)"
        )
    if digits is not None or max_events is not MAX_EVENTS or max_digits is not MAX_DIGITS:
        for name, value in (("digits", digits), ("max_events", max_events), ("max_digits", max_digits)):
            if value is not None:
                require_whole(name, value, 1)
    found = _solve(scene, digits, arithmetic, (max_events, max_digits, progress))
    if t_eval is None:
        return found
    if np.ndim(t_eval) != 1:
        raise ValueError(f"t_eval = {str(t_eval)[:40]!r} must be a sequence of times in seconds")
    return found.but(t_eval=t_eval)


def _solve(
    scene: Scene, digits: int | None, arithmetic: str | None, limits: tuple[int, int, Progress | None]
) -> Trajectory:
    max_events, max_digits, progress = limits
    if arithmetic is None and digits is not None:
        return _solve_cheaply(scene, digits, limits)
    if arithmetic in {None, "float64", "double-double"}:
        if digits is not None:
            has = "53 bits" if arithmetic == "float64" else "31 digits"
            raise ValueError(f"{arithmetic} works with {has}; leave digits out, or leave the choice of arithmetic out")
        if scene.is_forced and arithmetic != "double-double":
            return run_forced_sharply(scene, max_events, progress)
        return run_scene(scene, _DOUBLE_DOUBLE if arithmetic == "double-double" else _FLOAT64, max_events, progress)
    if arithmetic == "mpmath":
        working = (digits or 30) + _GUARD_DIGITS
        _require_within_cap(working, digits or 30, max_digits)
        return run_scene(scene, Multiprecision(working), max_events, progress)
    if arithmetic == "ball":
        return _solve_to_digits(scene, digits or 15, _GUARD_DIGITS, limits)
    raise ValueError(f"arithmetic = {arithmetic!r} is not one of float64, double-double, mpmath, ball")


_FLOAT64, _DOUBLE_DOUBLE = Float64(), DoubleDouble()


def _solve_cheaply(scene: Scene, digits: int, limits: tuple[int, int, Progress | None]) -> Trajectory:
    """Return a trajectory in float64, or double-double, if its error bounds leave enough digits, else a proved one.

    What one of them has lost of its digits is also what the next will lose.
    """
    tried, guard = [], _GUARD_DIGITS
    if digits <= _IN_FLOAT64:
        found, reached, why = _attempt(scene, _FLOAT64, limits)
        tried.append(why)
        if found is not None and reached >= digits:
            return found.but(digits=digits, tried=why)
        guard = _FLOAT64_DIGITS + _SPARE_DIGITS - reached if reached else guard
    if scene.pair.a1 == 0 and digits + guard - _SPARE_DIGITS <= _DOUBLE_DOUBLE_DIGITS and digits <= _IN_DOUBLE_DOUBLE:
        found, reached, why = _attempt(scene, _DOUBLE_DOUBLE, limits)
        tried.append(why)
        if found is not None and reached >= digits:
            return found.but(digits=digits, tried="; ".join(tried))
        guard = _DOUBLE_DOUBLE_DIGITS + _SPARE_DIGITS - reached if reached else guard
    balls = _solve_to_digits(scene, digits, guard, limits)
    return balls.but(tried="; ".join([*tried, f"{digits} are asked for"]))


def _attempt(
    scene: Scene, arithmetic: Any, limits: tuple[int, int, Progress | None]
) -> tuple[Trajectory | None, int, str]:
    """Return a trajectory that bounds its errors, the digits that they leave, and words on both."""
    max_events, _, progress = limits
    try:
        found = run_scene(scene, arithmetic, max_events, progress)
    except (EventUndecided, OutOfRange, ArithmeticError) as error:
        return None, 0, f"{arithmetic.name} cannot: {error}"
    if not found.certain:
        return found, 0, f"{arithmetic.name} leaves the sequence of events open"
    reached = found.right_digits
    return found, reached, f"{arithmetic.name} has {reached} right digits by its error bounds"


def _require_within_cap(working: int, digits: int, max_digits: int) -> None:
    if working > max_digits:
        raise PrecisionExhausted(f"{digits} right digits need more than {max_digits} working digits; raise max_digits")


def _solve_to_digits(scene: Scene, digits: int, guard: int, limits: tuple[int, int, Progress | None]) -> Trajectory:
    """Raise the working precision until `digits` digits are right; the digits lost in one try are added in the next."""
    max_events, max_digits, progress = limits
    working = digits + guard
    while True:
        _require_within_cap(working, digits, max_digits)
        undecided: EventUndecided | None = None
        try:
            trajectory = run_scene(scene, Ball(working), max_events, progress)
            reached = proved_digits(trajectory)
        except EventUndecided as error:
            undecided, reached = error, 0
        if undecided is None and reached >= digits:
            return trajectory.but(digits=digits)
        if undecided is not None and working * 2 > max_digits:
            raise undecided
        working = max(working + (digits - reached) + 5, working * 2 if undecided else 0)
