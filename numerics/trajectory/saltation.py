"""The chain rule along a trajectory of balls: derivatives from leg to leg, across events and jumps of u and b.

Along a motion of one mode derivatives at a fixed time follow the linearised equation (variation.py). Between two
motions, with f- and f+ the field y' on either side, they jump:

    guard   dtau = -(g_y dy + g_p)/g',   dy+ = dy- + (f- - f+) dtau   (g = v1 - v2, or b - s m2 x1'')
    piece   its start is a number of the scene: dtau = 1 by that number, else 0

At an event, which moves, the state has the derivatives dy- + f- dtau. An exit by a guard leaves f as it is.

At a fixed time two solutions of the linearised equations never part in the norm

    N^2 = a2 y1^2 + m1 y2^2 + m2 y4^2

across all events. So what is carried on are points, with bounds that are sums of local radii; of x1 - x2, which N does
not know, the bound grows by that of |v1 - v2| in a slip. Where friction depends on the state N grows at the rate of
each cell (cells.py), and a crossing of a knot, where the field is continuous, is no jump.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache, partial
from typing import NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball, widened
from numerics.errors import NotDifferentiable
from numerics.linear.cells import cells_of, mode_in
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.system import LocalNorm
from numerics.linear.ties import force_form
from numerics.scene import Law, Piece, Scene
from numerics.trajectory.columns import STATE, Array
from numerics.trajectory.variation import Leg, Variation

_radius = np.frompyfunc(lambda x: x.rad(), 1, 1)
_middle = np.frompyfunc(lambda x: x.mid(), 1, 1)
_widened = np.frompyfunc(widened, 2, 1)


class CarriedDerivatives(NamedTuple):
    """Derivatives of the state at a fixed time, (4, p), with bounds (p,) on their errors: in N, and of x1 - x2."""

    y: Array
    norm: Array
    place: Array


class Chain:
    """Derivatives along the legs of one trajectory; to be used in the balls' context.

    `t`, `y`: of the times (p,) and of the states (4, p) of all events, which move; `before`: of the state at the fixed
    time right before each, (4, p); `starts`: what is carried into every leg.
    """

    def __init__(self, scene: Scene, legs: Sequence[Leg], names: Sequence[str]) -> None:
        """Follow all legs; `names` are those of all numbers, the last axis of every array."""
        self.scene, self.legs, self.pieces, self.cells = scene, legs, pieces_of(scene), cells_of(scene)
        self.column = {name: index for index, name in enumerate(names)}
        pair, number = scene.pair, Ball.number
        self.a2, self.m1, self.m2, self.a1, self.mass = map(number, (pair.a2, pair.m1, pair.m2, pair.a1, pair.mass))
        self.roots = [one.sqrt() for one in (self.a2, self.m1, self.m2)]
        self.variation = cache(partial(Variation, scene, self.column))
        self.t: list[Array] = []
        self.y: list[Array] = []
        self.before: list[Array] = []
        y = self._zeros(4)
        y[range(4), [self.column[name] for name in STATE]] = arb(1)
        if legs[0].side == 0:  # stuck neighbours share their momentum at once
            y[1] = y[3] = (self.m1 * y[1] + self.m2 * y[3]) / self.mass
        self.starts = [self._into_piece(CarriedDerivatives(y, self._zeros(), self._zeros()), 0)]
        self.starts.extend(map(self._crossed, range(len(legs) - 1)))

    def at(self, index: int, tau: arb) -> Array:
        """Return the derivatives of the state at a fixed time, tau (s) after the start of a leg, enclosed, (4, p)."""
        return self._enclosed(self._ahead(index, tau))

    def final(self, state: Sequence[arb]) -> Array:
        """Return the derivatives of the last state, whose value is given, (4, p)."""
        last = self.legs[-1]
        if last.start is last.end:
            return self.y[-1]
        y = self.at(len(self.legs) - 1, last.end - last.start)
        if "until" in self.column:
            y[:, self.column["until"]] += self._field(self.pieces[last.piece], last.end, state, last)
        return y

    def energy(self, state: Sequence[arb], y: Array) -> Array:
        """Return the derivatives of (a2 x1^2 + m1 v1^2 + m2 v2^2)/2, J, from those of a state, (p,)."""
        x1, v1, _, v2 = state
        found = y[0] * (self.a2 * x1) + y[1] * (self.m1 * v1) + y[3] * (self.m2 * v2)
        for name, value in (("a2", x1), ("m1", v1), ("m2", v2)):
            found[self.column[name]] += value * value / 2
        return found

    def _zeros(self, *rows: int) -> Array:
        return np.full((*rows, len(self.column)), arb(0))

    def _ahead(self, index: int, tau: arb) -> CarriedDerivatives:
        """Return the derivatives tau (s) after the start of a leg: of the point that is carried, and the bounds."""
        leg, (y, norm, place) = self.legs[index], self.starts[index]
        flow, columns = self.variation(leg.piece, leg.side, leg.cell).over(leg.state, leg.start, tau)
        if self.cells and leg.side:
            mode = self.cells.mode(self.pieces[leg.piece], leg.side, leg.cell)
            norm = norm * LocalNorm(mode, self.cells.pulling).growth(tau.abs_upper())
        return CarriedDerivatives(
            flow @ y + columns, norm, place + norm * self._guard_by_norm(1) * abs(tau) * abs(leg.side)
        )

    def _guard_by_norm(self, side: int) -> arb:
        """Return the most that |v1 - v2| in slip, or m2 x1'' in stick, can be for N = 1."""
        if side:
            return (self.mass / (self.m1 * self.m2)).sqrt()
        return self.m2 / self.mass * (self.a2 + self.a1 * self.a1 / self.mass).sqrt()

    def _pointed(self, found: CarriedDerivatives) -> CarriedDerivatives:
        """Return the middles of balls, their radii added to the bounds."""
        x1, v1, x2, v2 = _radius(found.y)
        norm = found.norm + x1 * self.roots[0] + v1 * self.roots[1] + v2 * self.roots[2]
        if self.cells:
            norm = norm + (x1 + x2) * Ball.number(self.cells.pulling).sqrt()
        return CarriedDerivatives(_middle(found.y), norm, found.place + x1 + x2)

    def _enclosed(self, found: CarriedDerivatives) -> Array:
        """Return balls that hold the true derivatives."""
        x1, v1, v2 = (found.norm / root for root in self.roots)
        return _widened(found.y, np.array([x1, v1, found.place + x1, v2]))

    def _crossed(self, index: int) -> CarriedDerivatives:
        """Return the derivatives at the start of the next leg; those of an event are kept."""
        leg, after = self.legs[index], self.legs[index + 1]
        ended = self._ahead(index, after.start - leg.start)
        if after.begins_piece:
            return self._into_piece(ended, index + 1)
        return self._after_guard(leg, after, ended) if after.is_event else self._pointed(ended)

    def _after_guard(self, leg: Leg, after: Leg, ended: CarriedDerivatives) -> CarriedDerivatives:
        """Return the derivatives after an event by a guard."""
        piece, enclosed = self.pieces[leg.piece], self._enclosed(ended)
        before, behind = (self._field(piece, after.start, after.state, one) for one in (leg, after))
        by_state, by_numbers, rate = self.variation(leg.piece, leg.side, leg.cell).guard(after, before)
        t = -(by_state @ ended.y + by_numbers) / rate
        off = ended.norm * self._guard_by_norm(leg.side) + ended.place * abs(by_state[2])
        late = _widened(t, off / abs(rate))
        y, total = enclosed + np.outer(before, late), ended.y + np.outer(before, t)
        if leg.side:
            y[1], total[1] = y[3], total[3]  # a slip ends where both velocities are one
            ended = ended._replace(y=total - np.outer(behind, t))
        self._keep(late, y, enclosed)
        return self._pointed(ended)

    def _into_piece(self, found: CarriedDerivatives, index: int) -> CarriedDerivatives:
        """Return the derivatives at the start of a leg that begins a piece; those of an event are kept."""
        enclosed, t, y = self._enclosed(found), self._zeros(), +found.y
        moving = +enclosed
        for name, (before, after) in self._jumps(index).items():
            place = self.column[name]
            t[place] += 1
            moving[:, place] += before
            y[:, place] += before - after
        if self.legs[index].is_event:
            self._keep(t, moving, enclosed)
        return self._pointed(found._replace(y=y))

    def _keep(self, t: Array, y: Array, before: Array) -> None:
        """Keep the derivatives of the time and the state of an event, and of the state right before it."""
        self.t.append(t)
        self.y.append(y)
        self.before.append(before)

    def _jumps(self, index: int) -> dict[str, tuple[Array, Array]]:
        """Return y' before and after each start at the beginning of a leg that begins a piece, by its name.

        Where u and b jump together, each does so after the other. What does not jump, or does nothing in stick, is left
        out. Raises NotDifferentiable if the order of two jumps counts.
        """
        leg, last, scene = self.legs[index], self.legs[max(index - 1, 0)], self.scene
        here, at, literal = self.pieces[leg.piece], (leg.start, leg.state), scene.law is Law.THREE_VALUED_SGN
        # before the run there is no force, and the pair's own b
        still = replace(here, signals=(Piece(0), *here.signals[1:])).with_friction(scene.pair.b)
        before = self.pieces[last.piece] if index else still
        jumping = []  # with the starts of all such pieces, and the piece in front of this jump alone
        if force_form(before, before.length) != force_form(here, Fraction(0)):
            jumping.append(("force", scene.force.starts, before.with_friction(here.b)))
        if before.b != here.b:
            jumping.append(("friction", scene.friction.starts, here.with_friction(before.b)))
        fields = [self._field_from_contact(alone, *at) for *_, alone in jumping]
        if index and len(jumping) == 2 and (leg.is_event or not (leg.side or literal or all(one[1] for one in fields))):
            when = f"at t = {float(leg.start):.6g} s force and friction both jump, and which of them comes first"
            raise NotDifferentiable(f"this scene has no derivatives: {when} counts; change one of them slightly")
        found, after = {}, self._field(here, *at, leg)
        for (kind, starts, alone), (from_contact, _) in zip(jumping, fields, strict=True):
            name = f"{kind}[{bisect_left(starts, here.start)}].from"
            if not index and scene.initial.v1 == scene.initial.v2 and not literal:
                found[name] = from_contact, after
            elif kind == "force" or leg.side or last.side:
                found[name] = self._field(alone, *at, last), after
        return found

    def _field(self, piece: ExactPiece, t: arb, state: Sequence[arb], leg: Leg) -> Array:
        """Return (v1, v1', v2, v2') of a state in the mode of a leg at a time, s."""
        motion = mode_in(self.scene, piece, leg.side, leg.cell).motion(state, t)
        return np.array(motion.rate(motion.begin).entries()[:4])

    def _field_from_contact(self, piece: ExactPiece, t: arb, state: Sequence[arb]) -> tuple[Array, bool]:
        """Return the same in the mode that follows v1 = v2, and whether that is surely a stick."""
        v1, rate, v2, _ = self._field(piece, t, state, self.legs[0]._replace(side=0))
        held = self.cells.held(piece, state[0] - state[2]) if self.cells else Ball.number(piece.b)
        push = (self.m2 * rate).min(held).max(-held)
        return np.array([v1, (self.mass * rate - push) / self.m1, v2, push / self.m2]), abs(self.m2 * rate) < held
