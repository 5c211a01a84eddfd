"""The excursions of a free pair from exit ray to exit ray.

On an exit ray the state is one number, w = E/E_cr - 1 > 0. The slip ends at the angle theta with h(theta) = sqrt(w/q);
then w drops by 2 r q K(theta), and the pair sticks until it reaches a ray again.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from numerics.arithmetic.protocol import Number
from numerics.free.frame import RAY, STICK, Frame
from numerics.free.motion import motions, on_ray


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
    zero = frame.arithmetic.number(0)
    ray, slip = on_ray(frame, side, zero, w, zero), zero
    for start, duration in motions(frame, ray):
        if start.kind == RAY:
            ray, slip = start, zero
        if start.kind != STICK:
            slip = slip + duration
        else:
            yield Excursion(ray.w, ray.side, slip, start.w, duration)
