"""How the loop is told: for both kinds of motion, in every arithmetic, with error bounds or without."""

from __future__ import annotations

from functools import cache

from numerics.arithmetic.telling import Telling
from numerics.bounds import damped as damped_bounds
from numerics.bounds import none as no_bounds
from numerics.bounds import undamped as undamped_bounds
from numerics.motion.tellings import motion_telling, namesakes
from numerics.run.rows import damped_remembered, remembered

_BOUNDS = ("initial", "when_stuck", "after_event", "before_horizon", "at_event", "at_horizon", "at_last_event")


def has_bounds(arithmetic: str, *, is_damped: bool) -> bool:
    """Return whether error bounds are carried: in float64, and in double-double for undamped motions."""
    return arithmetic == "float64" or (arithmetic == "double-double" and not is_damped)


@cache
def run_telling(base: Telling, *, is_damped: bool) -> Telling:
    """Return the telling of the loop for one kind of motion in one arithmetic, whose own telling is `base`."""
    motions = motion_telling(base, is_damped=is_damped)
    if not has_bounds(base.name, is_damped=is_damped):
        own = {remembered: damped_remembered} if is_damped else {}
        return motions.but("unbounded", own | namesakes(undamped_bounds, no_bounds, _BOUNDS))
    if is_damped:
        return motions.but(
            "bounded", {remembered: damped_remembered} | namesakes(undamped_bounds, damped_bounds, _BOUNDS)
        )
    return motions
