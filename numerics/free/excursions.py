"""One motion after the other, in plain Python: runs in mpmath and balls, and the excursions from ray to ray.

On an exit ray the state is one number, w = E/E_cr - 1 > 0. The slip ends at the angle theta with h(theta) = sqrt(w/q);
then w drops by 2 r q K(theta), and the pair sticks until it reaches a ray again.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from numerics.arithmetic.functions import clock, finite
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.arithmetic.questions import QUESTIONS, SIDE_OF_ZERO
from numerics.errors import EventUndecided, OutOfRange
from numerics.free.frame import Frame
from numerics.free.motion import OUT_OF_RANGE, RAY, STICK, STUCK, Parameters, next_event, on_ray, resolve
from numerics.free.slip import Start


def motions(arithmetic: Arithmetic, at: Parameters, start: Start) -> Iterator[tuple[Start, Number | None]]:
    """Yield each motion's start and its reduced time to the next event, None for a stick that lasts for ever: the last.

    Inside the arithmetic's context. Raises EventUndecided and OutOfRange, each for what is asked.
    """
    while True:
        how, duration, end = next_event(at, start)
        if how == STUCK:
            yield start, None
            return
        if how == OUT_OF_RANGE:
            raise left_range(arithmetic)
        yield start, duration
        start = resolve(at, start, end, *clock(start.tau, start.rest, duration))
        if not finite(start.w):
            raise left_range(arithmetic)


def left_range(arithmetic: Arithmetic) -> Exception:
    """Return what says that a number left the range, or that balls know nothing of one any more."""
    if arithmetic.name == "ball":
        return EventUndecided(QUESTIONS[SIDE_OF_ZERO], "a number that is not finite", arithmetic.digits)
    return OutOfRange(
        f"a number of this scene left the range of {arithmetic.name} on the way, or one slip turns through an angle "
        f'that {arithmetic.digits} digits do not resolve; use arithmetic="ball"'
    )


class Excursion(NamedTuple):
    """One excursion: its excess energy w on the exit ray, the side of that ray, the reduced times of slip and stick.

    `w_after` is the excess after the slip; `stick` is None if the pair has merged (w_after <= 0). Dimensionless.
    """

    w: Number
    side: int
    slip: Number
    w_after: Number
    stick: Number | None


def excursions(frame: Frame, w: Number, side: int = 1) -> Iterator[Excursion]:
    """Yield the excursions of a pair that leaves S0 by the ray `side` with excess w > 0, until it merges.

    Crossings of S outside S0 belong to the excursion in which they happen. Raises EventUndecided, OutOfRange. Call it
    inside the arithmetic's context.
    """
    zero, at = frame.arithmetic.number(0), frame.parameters
    ray, slip = on_ray(at, float(side), zero, w, zero, zero, zero), zero
    for start, duration in motions(frame.arithmetic, at, ray):
        if start.kind == RAY:
            ray, slip = start, zero
        if start.kind != STICK:
            slip = slip + duration
        else:
            yield Excursion(ray.w, int(ray.side), slip, start.w, duration)
