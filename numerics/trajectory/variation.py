"""A leg: one mode in one piece of force and friction; differentiated: how its end moves with its start and all numbers.

With F = u - s b (slip, s the sign of v1 - v2, m = m1) or F = u (stick, m = m1 + m2) body 1 obeys m x'' + a1 x' + a2 x
= F(t), and at a fixed time y = dx/dp follows

    m y'' + a1 y' + a2 y = h(t),    h = dF/dp - (dm/dp) x'' - (da1/dp) x' - (da2/dp) x = row . z(t)

by every number p. Here z' = A z holds x, x' and functions of time: 1, t, t^2, ... and sin, cos, t sin, t cos. With O
the matrix of the oscillator alone and e = (0, 1/m) the answers to all components of z at once are (Van Loan)

    Q(tau) = int_0^tau exp(O (tau - s)) e z(s)^T ds,    exp([[O, e z(0)^T], [0, A^T]] tau) = [[exp(O tau), Q], [0, ...]]

so that (y, y') = exp(O tau) (y, y')(0) + Q row. Resonance and critical damping are no special cases. Where friction
depends on the state, O is that of both bodies, and numbers act on v2' as well, by e = (0, 0, 0, 1/m2). Everything is
enclosed by balls.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

import flint
import numpy as np
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, magnitude_bits
from numerics.arithmetic.precision import precision
from numerics.linear.cells import FrictionLine, cells_of, mode_in
from numerics.linear.pieces import pieces_of
from numerics.linear.record import Knot
from numerics.linear.system import Motion
from numerics.scene import Piece, Scene
from numerics.trajectory.columns import Array
from numerics.trajectory.trajectory import Trajectory

_BITS_PER_SQUARING = 5
"""What an exponential may lose each time that it is squared: entries are sums of a few products."""


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


class Variation:
    """The mode `side` (+1, -1: the sign of v1 - v2; 0: stick) in one piece and one cell, in the balls' context.

    Derivatives are by all numbers of the scene, p of them; `column` says in which place. Where friction depends on the
    state, body 2 is part of the oscillator, and numbers act on it too: its row of the inputs.

    z is the oscillator (2 or 4 components), the powers of the time since the piece of force began, and of every sine
    sin, cos, t sin, t cos. `system` is A, (n, n); `inputs` what all numbers do to each body, (1 or 2, n, p), N.
    """

    def __init__(self, scene: Scene, column: dict[str, int], index: int, side: int, cell: tuple[int, int]) -> None:
        """Take the numbers of the scene, in the piece of this index."""
        pair, number, self.cells, self.piece = scene.pair, Ball.number, cells_of(scene), pieces_of(scene)[index]
        place, began = (bisect_right(of.starts, self.piece.start) - 1 for of in (scene.friction, scene.force))
        name = f"force[{began}]"
        self.b = "b" if place < 0 else f"friction[{place}].b"
        """The name of the friction that acts."""
        self.force = scene.force.pieces[began] if began >= 0 else Piece(0)
        self.side, self.column, self.mode = side, column, mode_in(scene, self.piece, side, cell)
        self.m2, self.mass = number(pair.m2), number(self.mode.mass)
        terms, sines = self.force.polynomial or (Fraction(0),), self.force.sines
        n = self.size = 4 if side and self.cells else 2
        size = n + len(terms) + 4 * len(sines)
        self.system = system = np.full((size, size), arb(0))
        self.inputs = inputs = np.full((n // 2, size, len(column)), arb(0))
        system[0, 1], system[1, :2] = arb(1), [-number(pair.a2), -number(pair.a1)]
        inputs[0, 0, column["a2"]] = inputs[0, 1, column["a1"]] = arb(-1)
        for k, one in enumerate(terms):
            system[1, n + k] = number(one)
            if k:
                system[n + k, n + k - 1] = arb(k)
                inputs[0, n + k - 1, column[f"{name}.from"]] = number(-k * one)
            if self.force.polynomial:
                inputs[0, n + k, column[f"{name}.polynomial[{k}]"]] = arb(1)
        for k, sine in enumerate(sines):
            at, omega, height = n + len(terms) + 4 * k, number(sine.omega), number(sine.amplitude)
            for turned in (at, at + 2):
                system[turned, turned + 1], system[turned + 1, turned] = omega, -omega
            system[at + 2, at] = system[at + 3, at + 1] = arb(1)
            system[1, at] = height
            for key, by, factor in (("amplitude", 0, arb(1)), ("phase", 1, height), ("omega", 3, height)):
                inputs[0, at + by, column[f"{name}.sines[{k}].{key}"]] = factor
        friction = self._friction(FrictionLine(self.mode.b, *self.mode.cell))
        system[1] = (system[1] - friction) / self.mass
        inputs[0, :, column["m1"]], inputs[0, :, column["m2"]] = -system[1], -system[1] * (side == 0)
        if n == 4:
            system[2, 3], system[3] = arb(1), friction / self.m2
            inputs[1, :, column["m2"]] = -system[3]
        for name, (offset, slope, pull) in self._by_numbers(side, cell).items() if side else ():
            acting = self._friction(FrictionLine(offset, slope, pull))
            inputs[0, :, column[name]] -= acting
            inputs[1:, :, column[name]] += acting

    def _by_numbers(self, side: int, cell: tuple[int, int]) -> dict[str, FrictionLine]:
        """Return the derivatives of the friction of a slip by the numbers in it."""
        if self.cells:
            return self.cells.by_numbers(self.piece, side, cell, self.b)
        return {self.b: FrictionLine(Fraction(1), Fraction(0), Fraction(0))}

    def _friction(self, line: FrictionLine) -> Array:
        """Return friction on body 2 over z; of a stick none."""
        found = np.full(len(self.system), arb(0))
        found[self.size] += Ball.number(self.side * line.offset)
        if self.size == 4:
            slope, pull = Ball.number(line.slope), Ball.number(line.pull)
            found[:4] += [pull, slope, -pull, -slope]
        return found

    def _begun(self, state: Sequence[arb], t: arb) -> Array:
        """Return z at a time (s)."""
        since, found = t - Ball.number(self.force.start), [*state[: self.size], arb(1)]
        for _ in self.force.polynomial[1:]:
            found.append(found[-1] * since)
        for one in self.force.sines:
            sine, cosine = (Ball.number(one.omega) * t + Ball.number(one.phase)).sin_cos()
            found += [sine, cosine, t * sine, t * cosine]
        return np.array(found)

    def over(self, state: Sequence[arb], t: arb, tau: arb) -> tuple[Array, Array]:
        """Return the derivatives at tau (s) after the start of a motion, which is at t (s) with this state.

        By (x1, v1, x2, v2) at the start, (4, 4), and by the numbers at a fixed start, (4, p).
        """
        flow, columns, n = np.full((4, 4), arb(0)), np.full((4, len(self.column)), arb(0)), self.size
        z = self._begun(state, t)
        for place, mass, rows in zip((1, 3), (self.mass, self.m2), self.inputs, strict=False):
            whole = np.full((n + len(z), n + len(z)), arb(0))
            whole[:n, :n], whole[place, n:], whole[n:, n:] = self.system[:n, :n], z / mass, self.system.T
            block = _exponential(whole * tau)
            flow[:n, :n], columns[:n] = block[:n, :n], columns[:n] + block[:n, n:] @ rows
        if n == 4:
            return flow, columns
        if self.side:
            flow[2:, 2:] = [[arb(1), tau], [arb(0), arb(1)]]
            slid = np.array([tau * tau / 2, tau]) * self.side / self.m2
            columns[2:, self.column[self.b]] = slid
            columns[2:, self.column["m2"]] = -slid * Ball.number(self.mode.b) / self.m2
        else:
            flow[2:, :2], columns[2:] = flow[:2, :2], columns[:2]
            flow[2] += [-1, 0, 1, 0]
        return flow, columns

    def guard(self, after: Leg, field: Array) -> tuple[Array, Array, arb]:
        """Return the derivatives of the guard by the state (4,) and by the numbers (p,), and its rate, where it is 0.

        The guard of a slip is v1 - v2; that of a stick which ends in the slip s of the leg `after` is F - s m2 x1'',
        F = b, or B(0) + C(x1 - x2). `field` is (v1, v1', v2, v2') there.
        """
        (x1, _, x2, _), exit_side, cell = after.state, after.side, (0, after.cell[1])
        by_state, by_numbers = np.full(4, arb(0)), np.full(len(self.column), arb(0))
        if self.side:
            return np.array([0, 1, 0, -1]), by_numbers, field[1] - field[3]
        z, load = self._begun(after.state, after.start), -exit_side * self.m2 * self.system[1]
        by_numbers += -exit_side * self.m2 / self.mass * (z @ self.inputs[0])
        by_numbers[self.column["m2"]] -= exit_side * field[1]
        by_state[:2] = load[:2]
        for name, one in self._by_numbers(1, cell).items():
            by_numbers[self.column[name]] += Ball.number(one.offset) + Ball.number(one.pull) * (x1 - x2)
        if self.cells:
            pull = Ball.number(self.cells.branch(self.piece, 1, cell).pull)
            by_state += [pull, 0, -pull, 0]
        return by_state, by_numbers, load @ (self.system @ z)


def _exponential(matrix: Array) -> Array:
    """Return the exponential of a matrix."""
    exact = arb_mat(matrix.tolist())
    squarings = max(0, *map(magnitude_bits, exact.mid().entries()))
    with precision(flint.ctx.prec + _BITS_PER_SQUARING * squarings):
        return np.array(exact.exp().tolist())
