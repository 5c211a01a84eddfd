"""A trajectory of balls as legs: one mode in one piece of force and friction, from knot to knot of its record."""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple

from flint import arb

from numerics.arithmetic.ball import Ball, widened
from numerics.linear.pieces import pieces_of
from numerics.linear.record import Knot


class Leg(NamedTuple):
    """A motion from `start` to `end` (s) in the mode `side` (the sign of v1 - v2; 0: stick), everything enclosed."""

    side: int
    piece: int
    """Index in `pieces_of(scene)`."""
    start: arb
    end: arb
    state: tuple[arb, arb, arb, arb]
    """x1, v1, x2, v2 at its start."""
    is_event: bool
    """Whether the mode changes at its start."""
    begins_piece: bool
    """Whether its piece begins there."""
    cell: tuple[int, int]
    """Of a slip whose friction depends on the state (linear/cells.py)."""


def legs(trajectory: Any) -> list[Leg]:
    """Return the legs up to the horizon; else up to the event at which the run was cut off, and one of length 0."""
    pieces, number = pieces_of(trajectory.scene), Ball.number
    with trajectory.arithmetic.context():
        knots: list[Knot] = trajectory.record.rows
        starts = [widened(number(pieces[one.piece].start) + one.local, arb(one.late)) for one in knots]
        last = number(trajectory.scene.until) if trajectory.reached else starts[-1]
        ends = [*starts[1:], last]
        begins = [True, *(one.piece != two.piece for one, two in pairwise(knots))]
        return [
            Leg(one.mode, one.piece, start, end, _state(one), one.event, first, one.cell)
            for one, start, end, first in zip(knots, starts, ends, begins, strict=True)
        ]


def _state(knot: Knot) -> tuple[arb, arb, arb, arb]:
    """Return the state of a knot with its bounds."""
    x1, v1, x2, v2 = (
        widened(getattr(knot, name), arb(getattr(knot, f"{name}_error"))) for name in ("x1", "v1", "x2", "v2")
    )
    return x1, v1, x2, v2
