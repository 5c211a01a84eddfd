"""The path of a run in balls: its points, their distance to the true motion, one mode on.

The path that is followed starts anew from a point wherever a Taylor polynomial ends. Between events it is a true motion
but for the short times by which an event may be misplaced. Two motions under the same u never part in

    N = sqrt(a2 x1^2 + m1 v1^2 + m2 v2^2)    of their difference, across all events,

so the path's error is at most the sum of the local ones; in stick, where both obey one linear equation, it shrinks with
its solutions. While friction is off by 2 b for a time d, N grows by 2 b sqrt(M/(m1 m2)) d at most.

Where friction depends on the state, N^2 has g (x1 - x2)^2 besides, g = |dF/dz| in the cell of a slip, 0 in stick. While
both motions are in that cell it grows at the rate of LocalNorm; for as long as that is not known (about an event)

    N' <= kappa^2 l N + 2 kappa Lip |x1 - x2|,    l, Lip: the greatest fall of B and slope of C, kappa^2 = M/(m1 m2).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import zip_longest
from typing import NamedTuple

from flint import arb, ctx

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.precision import precision
from numerics.errors import EventUndecided, OutOfRange
from numerics.linear.cells import PLAIN, Cells
from numerics.linear.flow import Flow, Motion, flow_of
from numerics.linear.model import BELT, FRICTION, V1, V2, X1, X2
from numerics.linear.pieces import pieces_of, polynomial_at
from numerics.linear.system import BallDrive, LinearMode, LocalNorm, dot
from numerics.scene import Law, Piece, Scene

AWAY = (0, 0)
"""No derivative of a guard vanishes."""


class At(NamedTuple):
    """A point of the path: the mode, how many derivatives of its guards vanish here, the time in the piece, the state.

    The state is a point; `norm` bounds N of its distance to the true one, `far` that of x1, `place` that of x1 - x2.
    The true motion sticks from up to `late` (s) after the path on. A slip is in a `cell` of friction, its guards are
    those of cells.py; `apart` is x1 - x2 of a stick if it is known exactly, `contact` how far from its bearing body 1
    was where a slip left v1 = v2. `is_slow`: it is known exactly that a slip only touches v1 = v2, if at all.
    """

    mode: int
    orders: tuple[int, ...]
    piece: int
    local: arb
    state: Sequence[arb]
    norm: arb
    far: arb
    place: arb
    late: arb
    cell: tuple[int, int] = PLAIN
    apart: Fraction | None = None
    contact: Fraction | None = None
    is_slow: bool = False

    @property
    def order(self) -> int:
        """Return how many derivatives of the guard at whose root the mode ends vanish here."""
        return 0 if self.cell[0] else self.orders[0]


class EnclosedPath:
    """A scene in balls: the pieces, the flows of both modes, the constants of the norm; how a point moves on."""

    def __init__(self, scene: Scene, arithmetic: Ball) -> None:
        """Take a scene and the balls it is solved in; the present precision is that of the run."""
        self.scene, self.arithmetic, self.bits, self.pair = scene, arithmetic, ctx.prec, scene.pair
        self.literal = scene.law is Law.THREE_VALUED_SGN
        self.pieces, self.cells, self.varies = pieces_of(scene), Cells(scene), scene.friction.weakening is not None
        """`varies`: friction depends on the state; else it has one cell."""
        self.acting: tuple[int, BallDrive, dict[object, Flow]] = 0, BallDrive(self.pieces[0]), {}
        """The piece in which the path is, its signals, its flows."""
        self.moving: tuple[At, Motion] | None = None
        number, norm = Ball.number, LocalNorm(LinearMode(scene.pair, 1, self.pieces[0]))
        self.norm, self.kappa, self.is_fixed = norm, norm.kappa, norm.is_fixed
        self.speeds = 1 / norm.root_m1, arb(0) if self.is_fixed else 1 / norm.root_m2
        """Of v1 and v2."""
        self.falling, self.pulling, self.steep = map(number, (self.cells.falling, self.cells.pulling, self.cells.steep))
        self.undriven = self.is_fixed and scene.pair.a2 > 0 and not (scene.pair.a1 or self.varies or self.literal)
        static = scene.pair.b_static
        self.kept = number(1 - scene.pair.b / static) if static else arb(0)
        """The share of b_static by which it is above b."""

    def flow(self, at: At) -> Flow:
        """Return the flow at a point."""
        piece, key = self.pieces[at.piece], (at.mode, at.cell)
        if self.acting[0] != at.piece:
            self.acting = at.piece, BallDrive(piece), {}
        flows = self.acting[2]
        if key not in flows:
            cell = self.cells.branch(piece, at.mode, at.cell) if at.mode and self.varies else None
            flows[key] = flow_of(self.bits, self.pair, at.mode != 0, piece.layout, cell)
        return flows[key]

    def here(self, at: At) -> tuple[Flow, list[arb]]:
        """Return the flow at a point, and z."""
        flow, piece = self.flow(at), self.pieces[at.piece]
        z = [*at.state, *self.acting[1].at(at.local, at.mode)]
        if self.varies and not at.mode:
            z[piece.layout.blocks[FRICTION][0]] = self.held(at).mid()
        if self.is_fixed:
            z[V2] = dot(flow.belt, z)
            z[V1] = z[V1] if at.mode else z[V2]
        return flow, z

    def motion(self, at: At) -> Motion:
        """Return the motion from a point on."""
        if self.moving is None or self.moving[0] is not at:
            self.moving = at, Motion(*self.here(at))
        return self.moving[1]

    def is_closed(self, at: At) -> bool:
        """Return whether body 1 swings on its spring alone: no damper, ground or a belt, signals that are constants.

        In the frame of a wall that moves at a constant speed, or under a force that grows so, that is so, too.
        """
        force, force_2, belt, wall, friction = self.pieces[at.piece].signals
        is_even = self.undriven and not (force.sines or wall.sines) and len(self.bearing(at)) <= 2
        return is_even and all(one.constant is not None for one in (force_2, belt, friction))

    def bearing(self, at: At) -> tuple[Fraction, ...]:
        """Return where body 1 would be at rest without friction, a polynomial, in a piece whose signals have no sines.

        That is where the wall is, and what the force stretches the spring by.
        """
        force, *_, wall, _ = self.pieces[at.piece].signals
        both = zip_longest(wall.polynomial, force.polynomial, fillvalue=Fraction(0))
        return Piece(0, [place + u / self.pair.a2 for place, u in both]).polynomial

    def lasts(self, at: At) -> bool:
        """Return whether a mode that begins here does not end in its piece, as is known exactly.

        At rest on the ground the load stays as it is, if neither the wall moves nor the force changes.
        """
        if at.mode:
            return at.is_slow
        is_at_rest = self.is_closed(at) and self.pieces[at.piece].signals[BELT].constant == 0
        return is_at_rest and len(self.bearing(at)) <= 1

    def on_circle(self, at: At, stretch: Fraction, v1: Fraction | None = None) -> At:
        """Return a slip of a closed piece that is so far from its bearing, exactly, at a speed v1 or at v1 = v2.

        There (x1, v1) is a circle about its balance: it is slow if the belt is at all times at least as fast.
        """
        pair, belt = self.pair, self.pieces[at.piece].signals[BELT].constant or Fraction(0)
        speed = polynomial_at(self.bearing(at), Fraction(0), 1)
        away, at_most = stretch - self.balance(at, at.mode), (belt - speed) ** 2
        square = ((belt if v1 is None else v1) - speed) ** 2
        is_slow = pair.a2 * away**2 + pair.m1 * square <= pair.m1 * at_most
        return at._replace(is_slow=is_slow, contact=stretch if v1 in {None, belt} else None)

    def balance(self, at: At, side: int) -> Fraction:
        """Return how far from its bearing the spring balances the friction side * b."""
        return -side * (self.pieces[at.piece].signals[FRICTION].constant or Fraction(0)) / self.pair.a2

    def held(self, at: At) -> arb:
        """Return what friction that depends on the state holds at rest where a point is, N; for the true motion."""
        _, pull, level = self.cells.branch(self.pieces[at.piece], 1, at.cell)
        apart = at.state[X1] - at.state[X2] + arb(0, at.place)
        return Ball.number(level * self.pieces[at.piece].b) + Ball.number(pull) * apart

    def edge(self, at: At, flow: Flow, z: Sequence[arb]) -> arb:
        """Return the greatest load that friction holds at a point in stick, N."""
        return self.held(at) if self.varies else dot(flow.edge, z)

    def weight(self, at: At) -> arb:
        """Return sqrt(g) of the norm in the cell of a point; 0 in stick, and where friction is one number b."""
        return self.flow(at).norm.root_g

    def growth(self, at: At, t: arb) -> arb:
        """Return by which factor N may grow in a time in the mode of a point, while the true motion is in its cell."""
        return self.flow(at).norm.growth(t.abs_upper())

    def reweighed(self, at: At, root_g: arb) -> At:
        """Return a point with N of its own cell, where it is that of a cell with this sqrt(g)."""
        place, more = at.place, self.weight(at) ** 2 - root_g**2
        if root_g > 0:
            place = (at.norm / root_g).upper().min(place)
        norm = (at.norm * at.norm + more * place * place).sqrt().upper() if more > 0 else at.norm
        return at._replace(norm=norm, place=place)

    def left(self, at: At) -> arb:
        """Return the time that is left of the piece."""
        return (Ball.number(self.pieces[at.piece].length) - at.local).upper()

    def margin(self, at: At) -> arb:
        """Return how far the load may be off in a stick, N, since the path is."""
        margin = self.norm.load * at.norm
        return (margin + self.held(at).rad()).upper() if self.varies else margin

    def evolved(self, at: At, local: arb) -> At:
        """Return the path at a later time in the piece, in the same mode."""
        with precision(2 * self.bits):
            t = local - at.local
        return self.settled(at, self.motion(at).state(t), t)._replace(local=local, orders=AWAY)

    def ended(self, at: At) -> At:
        """Return the path at the end of the piece, to which its mode lasts."""
        return self.evolved(at, Ball.number(self.pieces[at.piece].length))

    def settled(self, at: At, state: Sequence[arb], t: arb) -> At:
        """Return a point in the midst of an enclosure, after a time in one mode; its errors grow by the radii."""
        place, norm = at.place, at.norm
        if at.mode:
            norm = norm * self.growth(at, t)
            place = self.parted(at._replace(norm=norm), t, arb(0))
        elif self.pair.a1 and not self.varies:
            norm = self.shrunk(at, (t - at.late).lower())
        x1, v1, x2, v2 = (one.rad() for one in state)
        norm = (norm + self.flow(at).norm.of((x1, v1, -x2, v2))).upper()
        if not norm.is_finite():
            raise OutOfRange("a number of this scene left the range of its arithmetic")
        points = tuple(one.mid() for one in state)
        if at.mode == 0:
            points = (points[0], points[1], points[2], points[1])
        late, far = (at.late - t).upper().max(arb(0)), self.far(at, t, x1, norm)
        return at._replace(state=points, norm=norm, far=far, place=(place + x1 + x2).upper(), late=late)

    def parted(self, at: At, t: arb, late: arb) -> arb:
        """Return a bound on the error of x1 - x2 after a time, and within `late` of then in any mode."""
        return at.place + self.kappa * at.norm * (2 * late + (t if at.mode else 0))

    def far(self, at: At, t: arb, own: arb, norm: arb) -> arb:
        """Return a bound on the error of x1 after a time: by N, or by its rate (where the spring is soft)."""
        by_time = (at.far + (at.norm + norm) / self.norm.root_m1 * t + own).upper()
        return (norm / self.norm.root_a2).upper().min(by_time) if self.norm.root_a2 > 0 else by_time

    def shrunk(self, at: At, t: arb) -> arb:
        """Return a bound on N after both motions have stuck for a time: it dies away with the flow of stick."""
        flow = self.flow(at)
        stiff, rate = -flow.A[V1, X1], -flow.A[V1, V1]
        if not (rate * t > 1 and stiff * t > rate):
            return at.norm
        exp = flow.over(t)
        # the greatest singular value of a matrix from the sum of its squares and its determinant
        entries = exp[X1, X1], exp[V1, V1], exp[V1, X1] / stiff.sqrt(), exp[X1, V1] * stiff.sqrt()
        square = sum((one * one for one in entries), arb(0))  # a power of a ball so near 0 is no number
        inner = (square * square - 4 * (-2 * rate * t).exp()).abs_upper()
        return (at.norm * ((square + inner.sqrt()) / 2).upper().sqrt().min(arb(1))).upper()

    def time(self, at: At) -> float:
        """Return the time of a point, s, for a message."""
        return float(self.pieces[at.piece].start) + float(at.local.mid())

    def undecided(self, at: At) -> EventUndecided:
        """Return the error for a point after which these digits do not tell what happens."""
        question = "which event comes next, or does its guard only touch?"
        return EventUndecided(question, f"after t = {self.time(at):.6g} s", self.arithmetic.digits)
