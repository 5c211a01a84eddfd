"""A scene with a force in binary64 that has its digits right: where rounding leaves few, by way of balls."""

from __future__ import annotations

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.errors import EventUndecided, OutOfRange
from numerics.run.forced import Progress, run_forced_scene
from numerics.scene import Scene
from numerics.trajectory.forced import ForcedTrajectory
from numerics.trajectory.forced_rounded import rounded_to_float64

_FLOAT64 = Float64()
_ENOUGH = 10
"""Right digits with which the numbers of binary64 are left as they are: one goes with the cut of the text."""
_FEW_EVENTS = 1000
"""Up to so many events balls make up for digits that binary64's bounds do not leave: they take some ms each."""
_WORKING = (34, 68, 136)
"""Working digits of the balls, as they are tried; more have not told a tie from its neighbour where data are exact."""


class Seamed(Ball):
    """Balls whose long pieces are cut as those of binary64 are: for what is rounded to it."""

    seams = True


def run_forced_sharply(scene: Scene, max_events: int, progress: Progress | None = None) -> ForcedTrajectory:
    """Solve a scene with a force in binary64. Raises EventUndecided, OutOfRange.

    Next to a tie, or where a slip is so short that its end is lost in rounding, binary64 leaves the events open or few
    digits right. Then the scene is solved in balls, and what they enclose is rounded; `tried` says so.
    """
    found, undecided, why = None, None, "float64 leaves the sequence of events open"
    try:
        found = run_forced_scene(scene, _FLOAT64, max_events, progress)
    except OutOfRange:
        why = "a number leaves the range of float64 on the way"
    except EventUndecided as error:
        undecided = error
    if found is not None:
        if len(found.knots) > _FEW_EVENTS or (digits := found.right_digits) >= _ENOUGH:
            return found
        why = f"float64 has {digits} right digits by its error bounds"
    most = min(max_events, _FEW_EVENTS)
    for working in _WORKING:
        try:
            rounded = rounded_to_float64(run_forced_scene(scene, Seamed(working), most, progress))
            if most < max_events and not rounded.reached:
                break
        except EventUndecided:
            if found is None and working == _WORKING[-1]:
                raise
            continue
        except OutOfRange:
            if found is None:
                raise
            break
        if rounded.right_digits >= _ENOUGH or (found is None and working == _WORKING[-1]):
            return rounded.but(tried=f"{why}; balls with {working} working digits, rounded")
    if found is None:
        raise undecided or OutOfRange(f'{why}, and there are more than {_FEW_EVENTS} events; use arithmetic="ball"')
    return found
