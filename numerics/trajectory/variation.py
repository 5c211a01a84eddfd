"""One mode under one piece of force, differentiated: how its end moves with its start and with every number.

With F = u - s b (slip, s the sign of v1 - v2, m = m1) or F = u (stick, m = m1 + m2) body 1 obeys m x'' + a1 x' + a2 x
= F(t), and at a fixed time y = dx/dp follows

    m y'' + a1 y' + a2 y = h(t),    h = dF/dp - (dm/dp) x'' - (da1/dp) x' - (da2/dp) x = row . z(t)

by every number p. Here z' = A z holds x, x' and functions of time: 1, t, t^2, ... or sin, cos, t sin, t cos. With O the
matrix of the oscillator alone and e = (0, 1/m) the answers to all components of z at once are (Van Loan)

    Q(tau) = int_0^tau exp(O (tau - s)) e z(s)^T ds,    exp([[O, e z(0)^T], [0, A^T]] tau) = [[exp(O tau), Q], [0, ...]]

so that (y, y') = exp(O tau) (y, y')(0) + Q row. Resonance and critical damping are no special cases. F is a sum of
parts, a polynomial and sines, and so is x: each part is answered by itself. Where friction depends on the state, O is
that of both bodies, and numbers act on v2' as well, by e = (0, 0, 0, 1/m2). Everything is enclosed by balls.
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
from numerics.linear.cells import PLAIN, Branch, cells_of, mode_in
from numerics.linear.pieces import ExactPiece
from numerics.linear.system import LinearMode
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
    """The mode `side` (+1, -1: the sign of v1 - v2; 0: stick) in one piece and one cell, in the balls' context.

    Derivatives are by all numbers of the scene, p of them; `column` says in which place. Where friction depends on the
    state, body 2 is part of the oscillator, and numbers act on it too: its row of the inputs.
    """

    def __init__(
        self,
        scene: Scene,
        piece: ExactPiece,
        side: int,
        column: dict[str, int],
        cell: tuple[int, int] = PLAIN,
    ) -> None:
        """Take the numbers of the scene."""
        pair, force = scene.pair, bisect_right(scene.force.starts, piece.start) - 1
        place = bisect_right(scene.friction.starts, piece.start) - 1
        b, cells = "b" if place < 0 else f"friction[{place}].b", cells_of(scene) if side else None
        self.side, self.column, self.by_b, self.mode = side, column, column[b], mode_in(scene, piece, side, cell)
        self.m2, self.mass, self.a1, self.a2, self.b = map(
            Ball.number, (pair.m2, self.mode.mass, pair.a1, pair.a2, self.mode.b)
        )
        self.parts = [Part(lambda _: [arb(1)], [[0]], [arb(0)], {})]
        if force >= 0:
            name, given = f"force[{force}]", scene.force.pieces[force]
            sines = (_sine(given, index, name) for index in range(len(given.sines)))
            self.parts = [_polynomial(given, name), *sines]
        self.size = 2 if cells is None else 4
        self.branches = {b: Branch(Fraction(1), Fraction(0), Fraction(0))} if side else {}
        if cells is not None:
            self.branches = cells.by_numbers(piece, side, cell, b)
        self.systems = [self._system(part, part is self.parts[0]) for part in self.parts]

    def _system(self, part: Part, first: bool) -> tuple[Array, Array]:
        """Return A of the oscillator and a part (n, n), and what all numbers do to each of its bodies (k, n, p)."""
        n, column = self.size, self.column
        size = n + len(part.own)
        system, inputs = np.full((size, size), arb(0)), np.full((n // 2, size, len(column)), arb(0))
        friction = self._friction(self.mode, size, first)
        system[0, 1], system[1, :2], system[n:, n:] = arb(1), [-self.a2, -self.a1], part.generator
        system[1, n:] = part.own
        system[1] = (system[1] - friction) / self.mass
        inputs[0, :, column["m1"]], inputs[0, :, column["m2"]] = -system[1], -system[1] * (self.side == 0)
        inputs[0, 0, column["a2"]] = inputs[0, 1, column["a1"]] = arb(-1)
        for name, row in part.by.items():
            inputs[0, n:, column[name]] = row
        if n == 4:
            system[2, 3], system[3] = arb(1), friction / self.m2
            inputs[1, :, column["m2"]] = -system[3]
        for name, (b, slope, pull) in self.branches.items():
            acting = self._friction(replace(self.mode, b=b, slope=slope, pull=pull), size, first)
            inputs[0, :, column[name]] -= acting
            inputs[1:, :, column[name]] += acting
        return system, inputs

    def _friction(self, mode: LinearMode, size: int, first: bool) -> Array:
        """Return friction on body 2 over a system; its constant belongs to the first part."""
        found = np.full(size, arb(0))
        for place, factor in mode.friction:
            if place < self.size or first:
                found[min(place, self.size)] += Ball.number(factor)
        return found

    def _states(self, state: Sequence[arb], t: arb) -> list[Array]:
        """Return z of every part at a time (s); the whole of the oscillator is given to the first."""
        own = list(state[: self.size])
        return [np.array([*([arb(0)] * self.size if k else own), *p.values(t)]) for k, p in enumerate(self.parts)]

    def over(self, state: Sequence[arb], t: arb, tau: arb) -> tuple[Array, Array]:
        """Return the derivatives at tau (s) after the start of a motion, which is at t (s) with this state.

        By (x1, v1, x2, v2) at the start, (4, 4), and by the numbers at a fixed start, (4, p).
        """
        flow, columns, n = np.full((4, 4), arb(0)), np.full((4, len(self.column)), arb(0)), self.size
        for (system, inputs), z in zip(self.systems, self._states(state, t), strict=True):
            for place, mass, rows in zip((1, 3), (self.mass, self.m2), inputs, strict=False):
                whole = np.full((n + len(z), n + len(z)), arb(0))
                whole[:n, :n], whole[place, n:], whole[n:, n:] = system[:n, :n], z / mass, system.T
                block = _exponential(whole * tau)
                flow[:n, :n], columns[:n] = block[:n, :n], columns[:n] + block[:n, n:] @ rows
        if n == 4:
            return flow, columns
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
        for part, (_, inputs), z in zip(self.parts, self.systems, self._states(state, t), strict=True):
            by_numbers += share * (z @ inputs[0])
            later += np.array(part.own) @ (np.array(part.generator) @ z[2:])
        by_numbers[self.column["m2"]] -= exit_side * field[1]
        by_numbers[self.by_b] += 1
        by_state = share * np.array([-self.a2, -self.a1, arb(0), arb(0)])
        return by_state, by_numbers, share * later + by_state[:2] @ field[:2]


def _exponential(matrix: Array) -> Array:
    """Return the exponential of a matrix."""
    exact = arb_mat(matrix.tolist())
    squarings = max(0, *map(magnitude_bits, exact.mid().entries()))
    with precision(flint.ctx.prec + _BITS_PER_SQUARING * squarings):
        return np.array(exact.exp().tolist())
