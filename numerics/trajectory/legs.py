"""A trajectory of balls as legs: one mode in one piece of force and friction, from knot to knot of its record."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.linear.cells import mode_in
from numerics.linear.pieces import pieces_of
from numerics.linear.record import Knot
from numerics.linear.system import Motion
from numerics.scene import Scene
from numerics.trajectory.trajectory import Trajectory


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

    def motion(self, scene: Scene) -> Motion:
        """Return the motion from its start on, of the scene to which it belongs."""
        return mode_in(scene, pieces_of(scene)[self.piece], self.side, self.cell).motion(self.state, self.start)


def legs(trajectory: Trajectory) -> list[Leg]:
    """Return the legs up to the horizon; else up to the event at which the run was cut off, and one of length 0."""
    knots: list[Knot] = trajectory.record.rows
    starts = trajectory.row_times.tolist()
    with trajectory.arithmetic.context():  # a time is known, whatever a box of starts is
        last = Ball.number(trajectory.scene.until) if trajectory.reached else starts[-1]
    begins = [True, *(one.piece != two.piece for one, two in pairwise(knots))]
    return [
        Leg(one.mode, one.piece, start, end, (one.x1, one.v1, one.x2, one.v2), one.event, first, one.cell)
        for one, start, end, first in zip(knots, starts, [*starts[1:], last], begins, strict=True)
    ]
