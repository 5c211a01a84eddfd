"""One mode under one piece of force, differentiated: how its end moves with its start and with every number.

With F = u - s b (slip, s the sign of v1 - v2, m = m1) or F = u (stick, m = m1 + m2) body 1 obeys m x'' + a1 x' + a2 x
= F(t), and at a fixed time y = dx/dp follows

    m y'' + a1 y' + a2 y = h(t),    h = dF/dp - (dm/dp) x'' - (da1/dp) x' - (da2/dp) x = row . z(t)

by every number p. Here z' = A z holds x, x' and functions of time: 1, t, t^2, ... or sin, cos, t sin, t cos. With O the
matrix of the oscillator alone and e = (0, 1/m) the answers to all components of z at once are (Van Loan)

    Q(tau) = int_0^tau exp(O (tau - s)) e z(s)^T ds,    exp([[O, e z(0)^T], [0, A^T]] tau) = [[exp(O tau), Q], [0, ...]]

so that (y, y') = exp(O tau) (y, y')(0) + Q row. Resonance and critical damping are no special cases. F is a sum of
parts, a polynomial and sines, and so is x: each part is answered by itself. Everything is enclosed by balls.
"""

from __future__ import annotations

import operator
from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import accumulate
from typing import Any, NamedTuple

import flint
import numpy as np
from flint import arb, arb_mat
from numpy.typing import NDArray

from numerics.arithmetic.ball import Ball, magnitude_bits, precision
from numerics.linear.cells import cells_of
from numerics.linear.pieces import ExactPiece
from numerics.linear.system import Row
from numerics.scene import Piece, Scene

Array = NDArray[Any]
"""Of balls."""
_BITS_PER_SQUARING = 5
"""What an exponential may lose each time that it is squared: entries are sums of a few products."""


class Part(NamedTuple):
    """A part of F: functions of time w(t) with w' = G w, and its rows over them."""

    values: Callable[[arb], list[arb]]
    generator: list[list[Any]]
    own: list[Any]
    """Of F itself."""
    by: dict[str, list[Any]]
    """Of dF/dp, by the names of its numbers."""


def _polynomial(piece: Piece, name: str) -> Part:
    """Return the polynomial part of u, in the time since the piece began."""
    start, terms, number = Ball.number(piece.start), piece.polynomial or (Fraction(0),), Ball.number
    size, slopes = len(terms), [-k * one for k, one in enumerate(terms)][1:]
    by: dict[str, list[Any]] = {
        f"{name}.polynomial[{k}]": [int(k == n) for n in range(size)] for k in range(len(piece.polynomial))
    }
    by[f"{name}.from"] = [*map(number, slopes), 0]
    generator = [[row if row == column + 1 else 0 for column in range(size)] for row in range(size)]

    def values(t: arb) -> list[arb]:
        return list(accumulate([arb(1), *[t - start] * (size - 1)], operator.mul))

    return Part(values, generator, [*map(number, terms)], by)


def _sine(piece: Piece, index: int, name: str) -> Part:
    """Return a sine of u beside its cosine, and both times t."""
    A, omega, phase = (Ball.number(getattr(piece.sines[index], key)) for key in ("amplitude", "omega", "phase"))

    def values(t: arb) -> list[arb]:
        sine, cosine = (omega * t + phase).sin_cos()
        return [sine, cosine, t * sine, t * cosine]

    generator = [[0, omega, 0, 0], [-omega, 0, 0, 0], [1, 0, 0, omega], [0, 1, -omega, 0]]
    rows = {"amplitude": [1, 0, 0, 0], "phase": [0, A, 0, 0], "omega": [0, 0, 0, A]}
    return Part(values, generator, [A, 0, 0, 0], {f"{name}.sines[{index}].{key}": row for key, row in rows.items()})


class Variation:
    """The mode `side` (+1, -1: the sign of v1 - v2; 0: stick) in one piece; to be used in the balls' context.

    Derivatives are by all numbers of the scene, p of them; `column` says in which place.
    """

    def __init__(self, scene: Scene, piece: ExactPiece, side: int, column: dict[str, int]) -> None:
        """Take the numbers of the scene."""
        pair, force = scene.pair, bisect_right(scene.force.starts, piece.start) - 1
        friction = bisect_right(scene.friction.starts, piece.start) - 1
        self.side, self.column = side, column
        self.by_b = column["b" if friction < 0 else f"friction[{friction}].b"]
        self.m2, self.mass, self.a1, self.a2, self.b = map(
            Ball.number, (pair.m2, pair.m1 if side else pair.mass, pair.a1, pair.a2, piece.b)
        )
        self.parts = [Part(lambda _: [arb(1)], [[0]], [arb(0)], {})]
        if force >= 0:
            name, given = f"force[{force}]", scene.force.pieces[force]
            sines = (_sine(given, index, name) for index in range(len(given.sines)))
            self.parts = [_polynomial(given, name), *sines]
        self.parts[0].own[0] -= side * self.b
        self.oscillator = [[arb(0), arb(1)], [-self.a2 / self.mass, -self.a1 / self.mass]]
        self.systems, self.rows = zip(*map(self._system, self.parts), strict=True)
        self.rows[0][2, self.by_b] -= side

    def _system(self, part: Part) -> tuple[Array, Array]:
        """Return A of x, x' and a part (n, n), and the rows of all numbers (n, p)."""
        size, column = 2 + len(part.own), self.column
        system, rows = np.full((size, size), arb(0)), np.full((size, len(column)), arb(0))
        system[:2, :2], system[2:, 2:] = self.oscillator, part.generator
        system[1, 2:] = np.array(part.own) / self.mass
        rows[:, column["m1"]], rows[:, column["m2"]] = -system[1], -system[1] * (self.side == 0)
        rows[0, column["a2"]] = rows[1, column["a1"]] = arb(-1)
        for name, row in part.by.items():
            rows[2:, column[name]] = row
        return system, rows

    def _states(self, state: Sequence[arb], t: arb) -> list[Array]:
        """Return z of every part at a time (s); the whole of x and x' is given to the first."""
        zero = [arb(0), arb(0)]
        return [np.array([*(zero if k else state[:2]), *part.values(t)]) for k, part in enumerate(self.parts)]

    def force(self, t: arb) -> arb:
        """Return u at a time (s), N."""
        terms = (w * c for part in self.parts for w, c in zip(part.values(t), part.own, strict=True))
        return sum(terms, self.side * self.b)

    def over(self, state: Sequence[arb], t: arb, tau: arb) -> tuple[Array, Array]:
        """Return the derivatives at tau (s) after the start of a motion, which is at t (s) with this state.

        By (x1, v1, x2, v2) at the start, (4, 4), and by the numbers at a fixed start, (4, p).
        """
        flow, columns = np.full((4, 4), arb(0)), np.full((4, len(self.column)), arb(0))
        for system, rows, z in zip(self.systems, self.rows, self._states(state, t), strict=True):
            whole = np.full((2 + len(z), 2 + len(z)), arb(0))
            whole[:2, :2], whole[1, 2:], whole[2:, 2:] = self.oscillator, z / self.mass, system.T
            block = _exponential(whole * tau)
            flow[:2, :2], columns[:2] = block[:2, :2], columns[:2] + block[:2, 2:] @ rows
        if self.side:
            flow[2:, 2:] = [[arb(1), tau], [arb(0), arb(1)]]
            slid = np.array([tau * tau / 2, tau]) * self.side / self.m2
            columns[2:, self.by_b] = slid
            columns[2:, self.column["m2"]] = -slid * self.b / self.m2
        else:
            flow[2:, :2], columns[2:] = flow[:2, :2], columns[:2]
            flow[2] += [-1, 0, 1, 0]
        return flow, columns

    def guard(self, state: Sequence[arb], t: arb, field: Array, exit_side: int) -> tuple[Array, Array, arb]:
        """Return the derivatives of the guard by the state (4,) and by the numbers (p,), and its rate, where it is 0.

        The guard of a slip is v1 - v2; that of a stick which ends in the slip s = `exit_side` is b - s m2 x1''. `field`
        is (v1, v1', v2, v2') there.
        """
        by_numbers = np.full(len(self.column), arb(0))
        if self.side:
            return np.array([0, 1, 0, -1]), by_numbers, field[1] - field[3]
        later, share = arb(0), -exit_side * self.m2 / self.mass
        for part, rows, z in zip(self.parts, self.rows, self._states(state, t), strict=True):
            by_numbers += share * (z @ rows)
            later += np.array(part.own) @ (np.array(part.generator) @ z[2:])
        by_numbers[self.column["m2"]] -= exit_side * field[1]
        by_numbers[self.by_b] += 1
        by_state = share * np.array([-self.a2, -self.a1, arb(0), arb(0)])
        return by_state, by_numbers, share * later + by_state[:2] @ field[:2]


class CoupledVariation(Variation):
    """The same for a slip in one cell of a friction that depends on the state: x1 and x2 are coupled.

    With Z = (x1, v1, x2, v2, parts) and Z' = A Z the numbers act on v1' and on v2': y' = S y + e1 R1 Z/m1 + e3 R3 Z/m2.
    """

    def __init__(
        self, scene: Scene, piece: ExactPiece, side: int, column: dict[str, int], cell: tuple[int, int]
    ) -> None:
        """Take the numbers of the scene."""
        cells = cells_of(scene)
        assert cells is not None
        super().__init__(scene, replace(piece, b=Fraction(0)), side, column)
        mode, size = cells.mode(piece, side, cell), 4 + sum(len(part.own) for part in self.parts)
        name = next(name for name, place in column.items() if place == self.by_b)
        self.system, self.inputs = np.full((size, size), arb(0)), np.full((2, size, len(column)), arb(0))
        A, inputs, friction = self.system, self.inputs, _over(mode.friction, size)
        A[0, 1] = A[2, 3] = arb(1)
        A[1, :2], at = [-self.a2, -self.a1], 4
        for part in self.parts:
            own = slice(at, at + len(part.own))
            A[1, own], A[own, own], at = part.own, part.generator, own.stop
            for key, row in part.by.items():
                inputs[0, own, column[key]] = row
        A[1], A[3] = (A[1] - friction) / self.mass, friction / self.m2
        inputs[0, :, column["m1"]], inputs[1, :, column["m2"]] = -A[1], -A[3]
        inputs[0, 0, column["a2"]] = inputs[0, 1, column["a1"]] = arb(-1)
        for key, branch in cells.by_numbers(piece, side, cell, name).items():
            acting = _over(replace(mode, b=branch.offset, slope=branch.slope, pull=branch.pull).friction, size)
            inputs[0, :, column[key]] -= acting
            inputs[1, :, column[key]] += acting

    def over(self, state: Sequence[arb], t: arb, tau: arb) -> tuple[Array, Array]:
        """Return the derivatives at tau (s) after the start of a motion, as `Variation.over`."""
        z = np.array([*state, *(one for part in self.parts for one in part.values(t))])
        columns, size = np.full((4, len(self.column)), arb(0)), len(z)
        for place, mass, inputs in ((1, self.mass, self.inputs[0]), (3, self.m2, self.inputs[1])):
            whole = np.full((4 + size, 4 + size), arb(0))
            whole[:4, :4], whole[place, 4:], whole[4:, 4:] = self.system[:4, :4], z / mass, self.system.T
            block = _exponential(whole * tau)
            columns = columns + block[:4, 4:] @ inputs
        return block[:4, :4], columns


def _over(row: Row, size: int) -> Array:
    """Return a row over z as a vector."""
    found = np.full(size, arb(0))
    for place, factor in row:
        found[place] += Ball.number(factor)
    return found


def _exponential(matrix: Array) -> Array:
    """Return the exponential of a matrix."""
    exact = arb_mat(matrix.tolist())
    squarings = max(0, *map(magnitude_bits, exact.mid().entries()))
    with precision(flint.ctx.prec + _BITS_PER_SQUARING * squarings):
        return np.array(exact.exp().tolist())
