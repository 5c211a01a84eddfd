"""One mode in one piece, differentiated: how z at its end moves with the state at its start and with all numbers.

A number p moves A, by A_p, and the signals in z; at a fixed time y = dz/dp follows y' = A y + A_p z, so that (Van Loan)

    y(tau) = exp(A tau) y(0) + L_p z(0),    exp([[A, A_p], [0, A]] tau) = [[exp(A tau), L_p], [0, exp(A tau)]]

A_p are the slopes of model.py's matrices of power series in p, exact. The rest is enclosed by balls. As L_p knows no
state, it is formed once for all pieces of one length and layout.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from copy import copy
from fractions import Fraction
from functools import lru_cache
from math import inf, perm
from types import SimpleNamespace
from typing import Any, NamedTuple

import flint
import numpy as np
from flint import arb, arb_mat, fmpq_series

from numerics.arithmetic.ball import Ball, Parts, ball_of, magnitude_bits, parts_of
from numerics.arithmetic.precision import precision
from numerics.linear.cells import cells_of, series
from numerics.linear.model import (
    DRIVEN,
    FIRST,
    FRICTION,
    SLIP,
    STICK,
    V1,
    V2,
    Bodies,
    Cell,
    Layout,
    ModeRows,
    make_rows,
    put_rows,
    spread_omegas,
)
from numerics.linear.system import LinearMode, LocalNorm, matrix, sparse, value
from numerics.scene import Pair, Piece, Scene
from numerics.trajectory.columns import Array
from numerics.trajectory.flow import BITS_PER_SQUARING
from numerics.trajectory.trajectory import Trajectory

SIGNALS = ("force", "force_2", "belt", "wall", "friction")
_OF_A_PAIR = ("m1", "m2", "a1", "a2", "b", "b_static")
_NOTHING = Piece(0)
_FIXED = Cell(0, 0, 0)
"""The derivative of a line of friction that does not move."""
_balls = np.frompyfunc(Ball.number, 1, 1)
_slopes = np.frompyfunc(lambda x: x[1] if isinstance(x, fmpq_series) else 0, 1, 1)


class Leg(NamedTuple):
    """A motion from `start` to `end` (s) in one mode, for a `length`, everything enclosed."""

    mode: LinearMode
    start: arb
    end: arb
    length: arb
    """Of a whole piece that of the piece itself."""
    state: tuple[arb, arb, arb, arb]
    """x1, v1, x2, v2 at its start."""
    order: int
    """How many derivatives of the guard vanish at its start (record.py)."""
    is_event: bool
    """Whether the mode changes at its start."""
    begins_piece: bool
    """Whether its piece begins there."""
    cell: tuple[int, int]
    """Of a slip whose friction depends on the state (linear/cells.py)."""

    @property
    def side(self) -> int:
        """Return the sign of v1 - v2, 0 in stick."""
        return self.mode.side

    @property
    def rates(self) -> Array:
        """Return (x1, v1, x2, v2)' at its start."""
        return rates_in(self.mode, self.start, self.state)


def legs(trajectory: Trajectory) -> list[Leg]:
    """Return the legs up to the horizon; else up to the event at which the run was cut off, and one of length 0."""
    knots, begins = trajectory.record.rows, np.diff(trajectory.row_pieces, prepend=-1) != 0
    starts, lengths = trajectory.row_times.tolist(), [*trajectory.row_lengths.tolist(), arb(0)]
    all_legs = enumerate(zip(knots, starts, [*starts[1:], trajectory.end_time], begins, strict=True))
    return [
        Leg(trajectory.row_mode(k), t, end, lengths[k], (x1, v1, x2, v2), one.order, one.event, first, one.cell)
        for k, (one, t, end, first) in all_legs
        for x1, v1, x2, v2 in ([one.x1, one.v1, one.x2, one.v2],)
    ]


def rates_in(mode: LinearMode, t: arb, state: Sequence[arb]) -> Array:
    """Return (x1, v1, x2, v2)' of a state at a time (s) in a mode."""
    z = arb_mat(mode.size, 1, mode.begin(state, t))
    return np.array((matrix(mode.generator()[:FIRST]) * z).entries())


def driven(mode: LinearMode, z: Any) -> Any:
    """Return z, or derivatives of it, with the velocity that a belt gives body 2, and in stick body 1 too."""
    if mode.pair.is_fixed:
        z[V2] = value(sparse(mode.rows.others[DRIVEN]), z)
        if not mode.side:
            z[V1] = z[V2]
    return z


class Variation:
    """One mode in one piece and one cell, in the balls' context.

    Derivatives are by p numbers of the scene; `column` says in which place.
    """

    def __init__(self, scene: Scene, column: dict[str, int], mode: LinearMode, cell: tuple[int, int]) -> None:
        """Take the numbers of the scene."""
        piece, side, cells = mode.piece, mode.side, cells_of(scene)
        self.mode, self.column, self.is_weakened = mode, column, cells is not None
        self.asked = {name.partition(".")[0] for name in column}
        self.norm = LocalNorm(self.mode, cells.pulling if cells else None)
        self.rows, kind = self.mode.rows, SLIP if side else STICK
        self.A = _balls(self.rows.A[kind])
        self.signals = _acting(scene, piece.start)
        b = f"{self.signals[FRICTION][0]}.b" if self.signals[FRICTION][0] else "b"
        lines = cells.by_numbers(piece, side or 1, cell, b) if cells else {}
        pair, layout, line = self.mode.pair, self.mode.layout, self.mode.cell
        moving: dict[str, tuple[int, Any]] = dict.fromkeys(_OF_A_PAIR, (-1, _FIXED))
        for (name, _), (_, _, first, waves) in zip(self.signals, layout.blocks.tolist(), strict=True):
            moving |= {f"{name}.sines[{k}].omega": (first + 2 * k + 1, _FIXED) for k in range(waves)}
        moving |= {name: (-1, one) for name, one in lines.items()}
        names = [name for name in column if name in moving]
        self.moved = {name: _moved_rows(pair, layout, line, name, *moving[name]) for name in names}
        """The derivatives of the matrices by the numbers on which they may depend."""
        alike: dict[tuple[Any, ...], list[int]] = {}
        for name, moved in self.moved.items():
            alike.setdefault(tuple(moved.A[kind].flat), []).append(column[name])
        self.inputs = [(_balls(np.reshape(A, self.A.shape)), places) for A, places in alike.items() if any(A)]
        """The A_p that are not 0, with the places of p: in stick both masses have one."""
        self.flow = lru_cache(maxsize=64)(self._flow)

    def under(self, scene: Scene, mode: LinearMode) -> Variation:
        """Return the same under another piece of signals of the same layout, without sines: the matrices are shared."""
        found = copy(self)
        found.mode, found.signals = mode, _acting(scene, mode.piece.start)
        return found

    def begun(self, state: Sequence[arb], t: arb, y: Array) -> tuple[Any, Any]:
        """Return z, and its derivatives (n, p) from those of the state (4, p), at a time (s)."""
        mode, found = self.mode, np.full((self.mode.size, y.shape[1]), arb(0))
        found[:FIRST] = y
        z, blocks = np.array(mode.begin(state, t)), mode.layout.blocks.tolist()
        for which, ((name, piece), block) in enumerate(zip(self.signals, blocks, strict=True)):
            if (name or "b") not in self.asked or (which == FRICTION and self.is_weakened):
                continue  # where friction depends on the state the lines of its cell have moved all rows
            sign = (mode.side or 1) if which == FRICTION else 1
            for key, first, by in _by_numbers(piece, block, z, t, sign):
                if (place := self.column.get(f"{name}.{key}".removeprefix("."))) is not None:
                    found[first : first + len(by), place] += by
        return z, driven(mode, found)

    def over(self, state: Sequence[arb], t: arb, tau: arb, y: Array) -> Array:
        """Return the derivatives of the state tau (s) after the start of a motion, from those at its start, (4, p)."""
        z, moved = self.begun(state, t, y)
        flow, by_numbers = self.flow(*parts_of(tau))
        found = np.array((flow * arb_mat(moved.tolist())).tolist())
        for own, places in by_numbers:
            found[:, places] += (own @ z)[:, None]
        return found

    def _flow(self, middle: Parts, radius: Parts) -> tuple[arb_mat, list[tuple[Array, list[int]]]]:
        """Return exp(A tau), and L_p with the places of p, for a ball of times (s): their rows of the state."""
        tau, n, found, m, block = ball_of(middle, radius), self.mode.size, [], 0, None
        for A, places in self.inputs:
            m = n if (A[FIRST:] != 0).any() else FIRST  # nothing of the state pushes a signal
            whole = np.full((m + n, m + n), arb(0))
            whole[:m, :m], whole[:m, m:], whole[m:, m:] = self.A[:m, :m], A[:m], self.A
            block = _exponential(whole, tau)
            found.append((block[:FIRST, m:], places))
        flow = _exponential(self.A, tau) if block is None else block[m:, m:]
        return arb_mat(flow[:FIRST].tolist()), found

    def guard(self, exit_side: int, state: Sequence[arb], t: arb, y: Array) -> tuple[Array, Array, arb]:
        """Return of the guard that ends this mode, where it is 0: its row on states, its derivatives (p,), its rate.

        The derivatives are at a fixed time. The guard of a slip is v1 - v2, of a stick which ends in the slip of a sign
        the edge less that times the load.
        """
        place = (SLIP, 0) if self.mode.side else (STICK, 0 if exit_side > 0 else 1)
        z, moved = self.begun(state, t, y)
        here = _balls(self.rows.guards[place])
        by = here @ moved
        for name, one in self.moved.items():
            by[self.column[name]] += _balls(one.guards[place]) @ z
        return here[:FIRST], by, here @ (self.A @ z)


def _by_numbers(piece: Piece, block: Sequence[int], z: Array, t: arb, sign: int) -> Iterator[tuple[str, int, Array]]:
    """Yield of every number of a signal its name, and the derivatives of the components of z from a place on."""
    first, terms, sines, _ = block
    yield "from", first, -z[first + 1 : first + terms]
    powers = [arb(sign)]  # ** has no powers of a ball that holds 0
    yield "b", first, np.array(powers[:terms])
    for j in range(terms):
        yield f"polynomial[{j}]", first, np.array([perm(j, k) * powers[j - k] for k in range(j + 1)])
        powers.append(powers[-1] * (t - Ball.number(piece.start)))
    for k, sine in enumerate(piece.sines):
        height, omega, phase = (Ball.number(one) for one in (sign * sine.amplitude, sine.omega, sine.phase))
        s, c = (omega * t + phase).sin_cos()
        turned = np.array([height * c, -height * s])
        named = {"amplitude": sign * np.array([s, c]), "phase": turned, "omega": turned * t}
        yield from ((f"sines[{k}].{key}", sines + 2 * k, by) for key, by in named.items())


def _acting(scene: Scene, t: Fraction) -> list[tuple[str, Piece]]:
    """Return the pieces of all signals that act from a time on, as they were given, with their names; "": none."""
    found = []
    for name in SIGNALS:
        pieces = scene.pieces[name]
        k = bisect_right(pieces, t, key=lambda one: one.start) - 1
        found.append((f"{name}[{k}]", pieces[k]) if k >= 0 else ("", _NOTHING))
    return found


@lru_cache(maxsize=1024)
def _moved_rows(pair: Pair, layout: Layout, cell: Cell, name: str, place: int, line: Cell) -> ModeRows:
    """Return the derivative of the matrices by a number of the pair, of the frequency at a place, of a line."""
    given = {key: getattr(pair, key) for key in _OF_A_PAIR}
    made = {key: one if one in {None, inf} else series(one, key == name) for key, one in given.items()}
    numbers = SimpleNamespace(**made)
    numbers.mass = numbers.m1 if pair.is_fixed else numbers.m1 + numbers.m2
    omegas = np.frompyfunc(series, 2, 1)(spread_omegas(layout), np.arange(layout.size) == place)
    rows = ModeRows(*(np.full(one.shape, 0, dtype=object) for one in make_rows(layout.size)))
    bodies, own = Bodies.of(numbers), map(series, cell, line)  # type: ignore[arg-type]
    put_rows(Bodies(*map(_one, bodies)), layout.blocks, omegas, tuple(map(_one, own)), rows)
    return ModeRows(*map(_slopes, rows))


def _one(number: object) -> Array:
    """Return a number as an array (1,): numpy takes a series for a sequence."""
    found = np.empty(1, dtype=object)
    found[0] = number
    return found


def _exponential(matrix: Array, tau: arb) -> Array:
    """Return the exponential of a matrix times a time."""
    exact = arb_mat(matrix.tolist()) * tau
    squarings = max(0, 1 + magnitude_bits((exact * exact.transpose()).trace().mid()) // 2)
    with precision(flint.ctx.prec + BITS_PER_SQUARING * squarings):
        return np.array(exact.exp().tolist())
