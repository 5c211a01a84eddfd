"""One mode in one piece, differentiated: how z at its end moves with the state at its start and with all numbers.

A number p moves A, by A_p, and the signals in z; at a fixed time y = dz/dp follows y' = A y + A_p z, so that (Van Loan)

    y(tau) = exp(A tau) y(0) + sum_i Q_i a_i,    Q_i = int_0^tau exp(A (tau - s)) e_i z(s)' ds

with a_i the rows of A_p, and Q_i from exp([[A, e_i z(0)'], [0, A']] tau): few rows depend on numbers, however many
there are. Entries of A are polynomials of degree 3 or less in those of model.Bodies: A_p is an exact difference.
Everything is enclosed by balls.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from math import perm
from typing import Any, NamedTuple

import flint
import numpy as np
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, magnitude_bits
from numerics.arithmetic.precision import precision
from numerics.linear.cells import cells_of, mode_in
from numerics.linear.model import (
    FIRST,
    FRICTION,
    KINETIC,
    LOAD,
    SLIP,
    STICK,
    Bodies,
    Layout,
    Rows,
    make_rows,
    put_rows,
    spread_omegas,
)
from numerics.linear.pieces import pieces_of
from numerics.linear.record import Knot
from numerics.linear.system import Cell, Motion
from numerics.scene import Pair, Piece, Scene
from numerics.trajectory.columns import Array
from numerics.trajectory.trajectory import Trajectory

_BITS_PER_SQUARING = 5
"""What an exponential may lose each time that it is squared: entries are sums of a few products."""
SIGNALS = ("force", "force_2", "belt", "wall", "friction")
_DIFFERENCE = {-2: Fraction(1, 12), -1: Fraction(-2, 3), 1: Fraction(2, 3), 2: Fraction(-1, 12)}
"""The derivative at 0 of a polynomial of degree 4, from its values."""


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


class Guard(NamedTuple):
    """What is 0 at an event: its row on the state, its derivatives at a fixed time (p,), and its rate."""

    by_state: Array
    moved: Array
    rate: arb


class Variation:
    """The mode `side` (+1, -1: the sign of v1 - v2; 0: stick) in one piece and one cell, in the balls' context.

    Derivatives are by p numbers of the scene; `column` says in which place.
    """

    def __init__(self, scene: Scene, column: dict[str, int], index: int, side: int, cell: tuple[int, int]) -> None:
        """Take the numbers of the scene, in the piece of this index."""
        piece, self.column, self.side, cells = pieces_of(scene)[index], column, side, cells_of(scene)
        self.mode, self.is_weakened = mode_in(scene, piece, side, cell), cells is not None
        self.rows = self.mode.rows
        self.A = _balls(self.rows.A[SLIP if side else STICK])
        self.signals = _acting(scene, piece.start)
        b = f"{self.signals[FRICTION][0]}.b" if self.signals[FRICTION][0] else "b"
        lines = cells.by_numbers(piece, side, cell, b) if cells and side else {}
        self.lines = {name: one for name, one in lines.items() if name in column}
        self.moved = self._moved()
        self.inputs: dict[int, list[tuple[int, Array]]] = {}
        """Rows of A_p that are not 0, with the places of p."""
        for name, one in self.moved.items():
            A = one.A[SLIP if side else STICK]
            for row in np.flatnonzero((A != 0).any(axis=1)).tolist():
                self.inputs.setdefault(row, []).append((column[name], _balls(A[row])))

    def _moved(self) -> dict[str, Rows]:
        """Return the derivatives of the matrices by the numbers on which they depend."""
        pair, layout, cell = self.mode.pair, self.mode.layout, self.mode.cell
        found = {name: one for name in self.column if (one := _by_body(pair, layout, cell, name)) is not None}
        for name, (_, slope, pull) in self.lines.items():
            found[name] = _moved_rows(pair, layout, cell, (), (), (slope, pull))
        for (name, piece), (_, _, first, _) in zip(self.signals, layout.blocks.tolist(), strict=True):
            for k in range(len(piece.sines)):
                omega = f"{name}.sines[{k}].omega"
                if omega in self.column:
                    found[omega] = _moved_rows(pair, layout, cell, (), ((first + 2 * k + 1, Fraction(1)),), None)
        return found

    def begun(self, state: Sequence[arb], t: arb, y: Array) -> tuple[Array, Array]:
        """Return z, and its derivatives (n, p) from those of the state (4, p), at a time (s)."""
        found = np.full((self.mode.size, y.shape[1]), arb(0))
        found[:FIRST] = y
        blocks = self.mode.layout.blocks.tolist()
        for which, ((name, piece), (first, terms, sines, _)) in enumerate(zip(self.signals, blocks, strict=True)):
            sign = (self.side or 1) if which == FRICTION else 1
            if which == FRICTION and self.is_weakened:
                for number, line in self.lines.items():
                    found[first, self.column[number]] += sign * Ball.number(line.offset)
                continue
            self._by_polynomial(name, piece, t, found[first : first + terms], sign)
            for k, sine in enumerate(piece.sines):
                height, omega, phase = (Ball.number(one) for one in (sine.amplitude, sine.omega, sine.phase))
                s, c = (omega * t + phase).sin_cos()
                turned = np.array([height * c, -height * s])
                for key, by in (("amplitude", np.array([s, c])), ("phase", turned), ("omega", turned * t)):
                    if (place := self.column.get(f"{name}.sines[{k}].{key}")) is not None:
                        found[sines + 2 * k : sines + 2 * k + 2, place] += by * sign
        return np.array(self.mode.begin(state, t)), found

    def _by_polynomial(self, name: str, piece: Piece, t: arb, block: Array, sign: int) -> None:
        """Write how a polynomial and its derivatives move with its coefficients and its start."""
        since, start = t - Ball.number(piece.start), self.column.get(f"{name}.from")
        of_b, power = f"{name}.b" if name else "b", [arb(1)]
        for _ in piece.polynomial[1:]:
            power.append(power[-1] * since)  # ** has no powers of a ball that holds 0
        for j, own in enumerate(piece.polynomial):
            place = self.column.get(f"{name}.polynomial[{j}]", self.column.get(of_b))
            for k in range(j + 1):
                if place is not None:
                    block[k, place] += sign * perm(j, k) * power[j - k]
                if start is not None and k < j:
                    block[k, start] -= sign * Ball.number(own) * perm(j, k + 1) * power[j - k - 1]

    def over(self, state: Sequence[arb], t: arb, tau: arb, y: Array) -> Array:
        """Return the derivatives of the state tau (s) after the start of a motion, from those at its start, (4, p)."""
        z, moved = self.begun(state, t, y)
        n = len(z)
        flow, found = None, np.full((FIRST, y.shape[1]), arb(0))
        for row, numbers in self.inputs.items():
            whole = np.full((2 * n, 2 * n), arb(0))
            whole[:n, :n], whole[row, n:], whole[n:, n:] = self.A, z, self.A.T
            block = _exponential(whole * tau)[:FIRST]
            flow = block[:, :n]
            for place, one in numbers:
                found[:, place] += block[:, n:] @ one
        flow = _exponential(self.A * tau)[:FIRST] if flow is None else flow
        return found + np.array((arb_mat(flow.tolist()) * arb_mat(moved.tolist())).tolist())

    def guard(self, end: Variation, exit_side: int, state: Sequence[arb], t: arb, y: Array) -> Guard:
        """Return the guard that ends this mode where it is 0: its row on states, its derivatives, and its rate.

        That of a slip is v1 - v2; that of a stick which ends in the slip of a sign is the edge less that times the
        load, where friction depends on the state by the slip's line in the cell of `end`.
        """
        own = end if self.is_weakened and not self.side else self
        z, moved = own.begun(state, t, y)
        if self.side:
            return Guard(
                _balls(self.rows.guards[SLIP, 0])[:FIRST], moved[1] - moved[3], (self.A @ z)[1] - (self.A @ z)[3]
            )

        def row(rows: Rows) -> Array:
            if own is end:
                return _balls(rows.others[KINETIC] - exit_side * rows.others[LOAD])
            return _balls(rows.guards[STICK, 0 if exit_side > 0 else 1])

        here, by = row(own.rows), np.full(y.shape[1], arb(0))
        by += here @ moved
        for name, one in own.moved.items():
            by[self.column[name]] += row(one) @ z
        return Guard(here[:FIRST], by, here @ (_balls(own.rows.A[STICK]) @ z))

    def field(self, state: Sequence[arb], t: arb) -> Array:
        """Return (x1, v1, x2, v2)' of a state at a time, s."""
        return np.asarray(self.A[:FIRST] @ np.array(self.mode.begin(state, t)))


def _acting(scene: Scene, t: Fraction) -> list[tuple[str, Piece]]:
    """Return the pieces of all signals that act from a time on, as they were given, with their names; "": none."""
    found = []
    for name in SIGNALS:
        pieces = scene.pieces[name]
        k = bisect_right(pieces, t, key=lambda one: one.start) - 1
        nothing = Piece(0, (scene.pair.b,)) if name == "friction" else Piece(0)
        found.append((f"{name}[{k}]", pieces[k]) if k >= 0 else ("", nothing))
    return found


@lru_cache(maxsize=1024)
def _by_body(pair: Pair, layout: Layout, cell: Cell, name: str) -> Rows | None:
    """Return the derivative of the matrices by a number of the pair, if they depend on it."""
    one, m1, m2 = Fraction(1), pair.m1, pair.m2
    by: dict[str, dict[str, Fraction]] = {"a1": {"a1": one}, "a2": {"a2": one}}
    by["m1"] = {"m1": one, "inverse_1": -1 / m1**2}
    if not pair.is_fixed:
        mass = pair.mass
        by["m1"] |= {"inverse_both": -1 / mass**2, "share_1": m2 / mass**2, "share_2": -m2 / mass**2}
        by["m2"] = {"inverse_2": -1 / m2**2, "inverse_both": -1 / mass**2}
        by["m2"] |= {"share_1": -m1 / mass**2, "share_2": m1 / mass**2}
    if pair.b_static is not None:
        by |= {"b_static": {"static": 1 / pair.b}, "b": {"static": -pair.b_static / pair.b**2}}
    return _moved_rows(pair, layout, cell, tuple(by[name].items()), (), None) if name in by else None


@lru_cache(maxsize=1024)
def _moved_rows(
    pair: Pair,
    layout: Layout,
    cell: Cell,
    bodies: tuple[tuple[str, Fraction], ...],
    omegas: tuple[tuple[int, Fraction], ...],
    line: Cell | None,
) -> Rows:
    """Return the derivative of the matrices where these of the numbers of bodies, frequencies and a cell move."""
    found: list[Any] = []
    for k, weight in _DIFFERENCE.items():
        rows = Rows(*(np.full(one.shape, Fraction(0)) for one in make_rows(layout.size)))
        own, turns = Bodies.of(pair), spread_omegas(layout)
        for place, rate in omegas:
            turns[place] += k * rate
        here = cell if line is None else (cell[0] + k * line[0], cell[1] + k * line[1])
        moved = own._replace(**{name: getattr(own, name) + k * rate for name, rate in bodies})
        put_rows(moved, layout.blocks, turns, here, rows)
        parts = [weight * one for one in rows]
        found = [one + two for one, two in zip(found, parts, strict=True)] if found else parts
    return Rows(*found)


def _balls(matrix: Array) -> Array:
    """Return an exact array as balls."""
    convert = np.frompyfunc(Ball.number, 1, 1)
    return np.asarray(convert(matrix))


def _exponential(matrix: Array) -> Array:
    """Return the exponential of a matrix."""
    exact = arb_mat(matrix.tolist())
    squarings = max(0, *map(magnitude_bits, exact.mid().entries()))
    with precision(flint.ctx.prec + _BITS_PER_SQUARING * squarings):
        return np.array(exact.exp().tolist())
