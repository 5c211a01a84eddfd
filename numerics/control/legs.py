"""A solved trajectory as motions between events and jumps, in balls: for what is asked of every moment of it."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.control.linear import LinearMode, Motion
from numerics.scene import Piece, Scene


@dataclass(frozen=True)
class Stretch:
    """One motion from the time `start` (s) for `length` (s): one mode under one piece of force and one friction."""

    start: arb
    length: arb
    motion: Motion

    @property
    def side(self) -> int:
        """Return the sign of w in it, 0 for a stick phase."""
        return self.motion.mode.side


def stretches(trajectory: Any) -> Iterator[Stretch]:
    """Yield the stretches of a trajectory in balls, from t = 0 to its horizon; in the arithmetic's context."""
    scene, number = trajectory.scene, Ball.number
    jumps = sorted({at for at in (*scene.force.starts, *scene.friction.starts) if 0 < at < scene.until})
    at = scene.initial
    state = tuple(number(one) for one in (at.x1, at.v1, at.x2, at.v2))
    now, sides = arb(0), [mode.sign for mode in trajectory.modes]
    ends = [(event.t, event.y) for event in trajectory.events] + [(number(scene.until), None)]
    waiting = list(jumps)
    held = Fraction(0)
    for side, (end, known) in zip(sides, ends, strict=False):
        while waiting and number(waiting[0]) < end:
            held = waiting.pop(0)
            one = _stretch(scene, side, _before(jumps, held), state, now, number(held))
            yield one
            state, now = one.motion.state(one.length), number(held)
        if waiting and not number(waiting[0]) > end:  # the event is the jump itself
            held = waiting.pop(0)
            yield _stretch(scene, side, _before(jumps, held), state, now, end)
        else:
            yield _stretch(scene, side, held, state, now, end)
        if known is not None:
            state, now = known, end


def _before(jumps: list[Fraction], at: Fraction) -> Fraction:
    """Return the jump before one, or 0: from it on hold the piece and the friction that act up to `at`."""
    place = jumps.index(at)
    return jumps[place - 1] if place else Fraction(0)


def _stretch(scene: Scene, side: int, since: Fraction, state: Any, start: arb, end: arb) -> Stretch:
    """Return a stretch under the piece and the friction that hold right after the time `since`."""
    piece: Piece = scene.force.piece_at(since)
    places = bisect_right(scene.friction.starts, since)
    b = scene.friction.pieces[places - 1][1] if places else scene.pair.b
    return Stretch(start, end - start, LinearMode(scene.pair, b, side, piece).motion(state, start))
