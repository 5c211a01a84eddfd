"""The peaks of v1 in Fig. 5 (a), enclosed: what each cycle takes from them."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from flint import arb

from numerics.linear.modes import Mode
from numerics.scene import Pair, Scene
from numerics.scene.file import load_scene
from numerics.trajectory.events import Segment
from numerics.trajectory.trajectory import Trajectory

TEETH = 10
SLIPS = (Mode.SLIP_PLUS, Mode.SLIP_MINUS) * TEETH + (Mode.SLIP_PLUS,)
"""The itinerary up to the first adhesion: twenty crossings."""


def velocities_scene(friction: Fraction | None = None) -> Scene:
    """Return the scene of Fig. 5 (a) up to 8 s, with another b (N) where one is given."""
    scene = replace(load_scene("velocities"), until=Fraction(8))
    pair = scene.pair
    return scene if friction is None else replace(scene, pair=Pair(m1=pair.m1, m2=pair.m2, a2=pair.a2, b=friction))


def positive_peaks(trajectory: Trajectory) -> list[arb]:
    """Return the positive peaks of v1 (m/s) before the first adhesion, each proved to lie in a slip+ segment.

    There x1 turns about -b/a2, so v1 peaks where x1 passes that centre upwards, at the speed that the circle gives.
    Raises ValueError where a passage is not proved.
    """
    frame, pair = trajectory.frame, trajectory.scene.pair
    found = []
    with trajectory.arithmetic.context():
        centre = frame.arithmetic.number(-pair.b / pair.a2)
        square = frame.arithmetic.number(pair.a2 / pair.m1)
        for segment in trajectory.segments[1 : _slips(trajectory)]:
            if segment.mode is Mode.SLIP_PLUS:
                (x, v), (end, _) = _ends(trajectory, segment)
                if not (x < centre < end):
                    raise ValueError("x1 is not proved to pass the centre of its oscillation in this slip")
                found.append((v * v + square * (x - centre) ** 2).sqrt())
    return found


def _slips(trajectory: Trajectory) -> int:
    return next(n for n, segment in enumerate(trajectory.segments) if segment.mode is Mode.STICK)


def _ends(trajectory: Trajectory, segment: Segment) -> tuple[tuple[arb, arb], tuple[arb, arb]]:
    """Return (x1, v1) at both ends of a segment, SI."""
    first, last = (segment.state(since)[:2] for since in (trajectory.arithmetic.number(0), segment.length))
    return first, last


def peak_after_adhesion(trajectory: Trajectory) -> arb:
    """Return the next positive peak of v1, m/s: where the first stick phase from x1 < 0 to l_+ passes x1 = 0."""
    frame = trajectory.frame
    with trajectory.arithmetic.context():
        for segment in trajectory.segments[_slips(trajectory) + 1 :]:
            (x, v), (end, _) = _ends(trajectory, segment)
            if segment.mode is Mode.STICK and x < 0 < end and v > 0:
                return frame.speed * (1 + trajectory.reduced(segment.start).w).sqrt()
    raise ValueError("no such stick phase in the solved time; solve further")


def decrements(trajectory: Trajectory) -> tuple[list[arb], list[arb]]:
    """Return the positive peaks of v1 before the first adhesion, and what each cycle takes from them, m/s."""
    peaks = positive_peaks(trajectory)
    with trajectory.arithmetic.context():
        return peaks, [before - after for before, after in pairwise(peaks)]
