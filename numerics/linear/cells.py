"""Friction of the state cut into cells: speed interval k, place interval j, in which F is linear in z. Exact.

In a slip of sign s, F = s (B(|w|) + C(z)) with B = p_k + beta_k |w| and C = q_j + gamma_j z is

    F = s (p_k + q_j) + beta_k w + s gamma_j z

so a slip is one linear mode in each cell. F is continuous across the knots |w| = v_k and z = z_j: a crossing is no
event, and at a tie the first derivative of w (of z) that does not vanish is the same in both cells. Where b changes in
time all of F is scaled by b(t)/b.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise, product
from typing import Any

from flint import fmpq, fmpq_series

from numerics.errors import InvalidScene
from numerics.linear.model import AHEAD, CEILING, FLOOR, V1, V2, Cell
from numerics.linear.pieces import ExactPiece
from numerics.linear.sine_form import SineForm
from numerics.linear.system import LinearMode
from numerics.linear.ties import MARGINAL, derivatives
from numerics.scene import Pair, Scene, Weakening
from numerics.scene.decimals import short

Line = tuple[Fraction, Fraction]
"""p + q x as (p, q)."""


Start = tuple[tuple[int, int], tuple[int, int]]
"""Where a slip begins: its cell, and how many derivatives of FLOOR and CEILING vanish there."""
VANISHES = 3
"""Behind the guards of a slip: B + C gets to 0."""
PLAIN = (0, 0)


class Cells:
    """The cells of one scene; k counts from 0 at |w| = 0, j from 0 left of the first place."""

    def __init__(self, scene: Scene) -> None:
        """Cut B and C of a scene that has them."""
        weakening = scene.friction.weakening or Weakening()
        self.pair: Pair = scene.pair
        self.points = ((Fraction(0), self.pair.b), *weakening.speed)
        self.flat = weakening.place or ((Fraction(0), Fraction(0)),)
        self.speeds, self.places = [w for w, _ in self.points], [z for z, _ in weakening.place]
        self.by_speed = [*_lines(self.points), _line(self.points[-1:], weakening.last_slope)]
        self.by_place = [_line(self.flat[:1], Fraction(0)), *_lines(self.flat)]
        if weakening.place:
            self.by_place.append(_line(self.flat[-1:], Fraction(0)))
        varies = scene.friction.weakening is not None
        most = max([self.pair.b, *(b for _, b in scene.friction.steps)]) / self.pair.b if varies else Fraction(1)
        self.falling = most * max(Fraction(0), *(-slope for _, slope in self.by_speed))
        """At any time, at most: -B', N s/m; |C'|, N/m; |B'| next to rest."""
        self.pulling, self.steep = most * max(abs(slope) for _, slope in self.by_place), most * abs(self.by_speed[0][1])
        self.begun = [self.place_line(scene.initial.x1 - scene.initial.x2, side) for side in (-1, 1)]
        """The intervals of z in which slip - and slip + begin, from a stick at the start."""
        cells = list(product(range(len(self.by_speed)), range(len(self.by_place))))
        self.all = [*product((1, -1), cells), (1, (0, self.begun[1]))]
        """The cells as the kernel counts them, with the sign of the slip; the last one is the stick at the start."""
        self.guards = lru_cache(maxsize=None)(self._guards)

    def scale(self, piece: ExactPiece) -> Fraction:
        """Return b(t)/b of a piece."""
        return piece.b / self.pair.b

    def branch(self, piece: ExactPiece, side: int, cell: tuple[int, int]) -> Cell:
        """Return friction in a cell, in a slip or as what holds a stick."""
        scale, (p, slope), (q, pull) = self.scale(piece), self.by_speed[cell[0]], self.by_place[cell[1]]
        return Cell(scale * slope, scale * (side or 1) * pull, (p + q) / self.pair.b)

    def mode(self, piece: ExactPiece, side: int, cell: tuple[int, int]) -> LinearMode:
        """Return a linear mode in a cell."""
        return LinearMode(self.pair, side, piece, self.branch(piece, side, cell))

    def by_numbers(self, piece: ExactPiece, side: int, cell: tuple[int, int], b: str) -> dict[str, Cell]:
        """Return the derivatives of friction in a cell by the numbers in it; `b` is the name of the piece's b."""
        (k, j), last, speed, place = cell, "weakening.last_slope", "weakening.speed[{}].{}", "weakening.place[{}].{}"
        numbers = {"b": self.pair.b, b: piece.b, last: self.by_speed[-1][1]}
        speeds, places, found = list[tuple[str, str]](), list[tuple[str, str]](), dict[str, Cell]()
        for n, point in enumerate(self.points[k : k + 2], k):
            speeds.append((speed.format(n - 1, "w"), speed.format(n - 1, "b") if n else "b"))
            numbers |= zip(speeds[-1], point, strict=True)
        for n in range(max(j - 1, 0), min(j + 1, len(self.flat))):
            places.append((place.format(n, "z"), place.format(n, "c")))
            numbers |= zip(places[-1], self.flat[n], strict=True)
        for name in numbers:
            at = {key: series(one, key == name) for key, one in numbers.items()}
            p, slope = _line([(at[x], at[y]) for x, y in speeds], at[last])
            q, pull = _line([(at[x], at[y]) for x, y in places], 0)
            scale = at[b] / at["b"]
            moved = ((scale * one)[1] for one in (slope, side * pull, p + q))
            slope, pull, level = (Fraction(int(one.p), int(one.q)) for one in moved)
            found[name] = Cell(slope, pull, level / piece.b)
        return found

    def place_line(self, z: float | Fraction, side: int = 1) -> int:
        """Return the interval of a place; at a knot that towards which z moves."""
        return (bisect_right if side > 0 else bisect_left)(self.places, z)

    def ends(self, cell: tuple[int, int]) -> tuple[Fraction | None, ...]:
        """Return the ends of a cell: |w| from and to, z from and to; None where there is none."""
        (k, j), last = cell, len(self.places)
        above = self.speeds[k + 1] if k + 1 < len(self.speeds) else None
        return self.speeds[k], above, self.places[j - 1] if j else None, self.places[j] if j < last else None

    def _guards(self, side: int, cell: tuple[int, int]) -> tuple[list[tuple[int, int, Fraction]], bool]:
        """Return kind, sign and offset of the guards of a slip in a cell, and whether friction may vanish within."""
        low, high, *sides = self.ends(cell)
        ends = (low, side), (high, -side), (sides[side > 0], -side)
        at = [
            (kind, sign, -sign * end * (1 if kind == AHEAD else side))
            for kind, (end, sign) in enumerate(ends)
            if end is not None
        ]
        return at, self.limit(cell) is not None

    def limit(self, cell: tuple[int, int]) -> Fraction | None:
        """Return the |w| of a cell up to which B + C > 0 at all its places; None where it is positive everywhere."""
        low, (_, high, *sides) = self.speeds[cell[0]], self.ends(cell)
        (p, slope), (q, pull) = self.by_speed[cell[0]], self.by_place[cell[1]]
        least = p + q + min([pull * z for z in sides if z is not None], default=Fraction(0))
        if slope < 0:
            return -least / slope if high is None or least + slope * high < 0 else None
        return None if least + slope * low > 0 else low

    def behind(self, side: int, cell: tuple[int, int], kind: int) -> tuple[int, int]:
        """Return the cell behind an end of a cell."""
        k, j = cell
        return {FLOOR: (k - 1, j), CEILING: (k + 1, j), AHEAD: (k, j + side)}[kind]

    def is_open(self, cell: tuple[int, int]) -> bool:
        """Return whether B + C > 0 at all places of a cell at first."""
        limit = self.limit(cell)
        return limit is None or limit > self.speeds[cell[0]]

    def vanishing(self, w: float | Fraction, z: float | Fraction, at: str = "") -> InvalidScene:
        """Return the error for a motion that gets to a place where friction is not positive."""
        return InvalidScene(
            f"B + C <= 0 at |w| = {short(Fraction(w))} m/s, z = x1 - x2 = {short(Fraction(z))} m{at}: friction must be "
            "positive wherever the motion goes; raise B or C there"
        )

    def start(self, piece: ExactPiece, side: int, local: Fraction, state: Sequence[SineForm], order: int) -> Start:
        """Return where a mode begins from an exact state, whose w vanishes to an order; ties by derivatives."""
        x1, v1, x2, v2 = state
        w, z = (v1 - v2) * (side or 1), (x1 - x2).constant  # z is rational: it is that of the start
        j, k = self.place_line(z, side or 1), bisect_right(self.speeds, w) - 1
        (p, slope), (q, pull) = self.by_speed[k], self.by_place[j]
        if (w * slope + (p + q + pull * z)).sign() <= 0:
            raise self.vanishing(w.rounded(64), z, " at t = 0")
        if w == 0:
            return (0, j), (order, 0)
        orders = [0, 0]
        if w == self.speeds[k]:
            rising, m = self._leaves(self.mode(piece, side, (k, j)), local, state)
            k, orders[FLOOR if rising else CEILING] = k - (not rising), m
        return (k, j), (orders[0], orders[1])

    def _leaves(self, mode: LinearMode, local: Fraction, state: Sequence[SineForm]) -> tuple[bool, int]:
        """Return whether |w| rises from a knot, and which derivative says so (MARGINAL: none, it stays there)."""
        for order, z in enumerate(derivatives(mode, local, state)):
            sign = mode.side * (z[V1] - z[V2]).sign()
            if order and sign:
                return sign > 0, order
        return True, MARGINAL


@lru_cache(maxsize=128)
def cells_of(scene: Scene) -> Cells | None:
    """Return the cells of a scene; None where friction does not depend on the state."""
    return None if scene.friction.weakening is None else Cells(scene)


def mode_in(scene: Scene, piece: ExactPiece, side: int, cell: tuple[int, int]) -> LinearMode:
    """Return the linear mode `side` of any scene in a piece, and in a cell where it has any."""
    cells = cells_of(scene)
    return LinearMode(scene.pair, side, piece) if cells is None else cells.mode(piece, side, cell)


def first_mode(scene: Scene, piece: ExactPiece, side: int) -> LinearMode:
    """Return a linear mode in the cell in which bodies that stick from the start are."""
    cells = cells_of(scene)
    return mode_in(scene, piece, side, (0, cells.begun[1]) if cells else PLAIN)


def _lines(points: Sequence[tuple[Fraction, Fraction]]) -> list[Line]:
    """Return the lines between neighbouring points."""
    return [_line(pair, 0) for pair in pairwise(points)]


def _line(points: Sequence[tuple[Any, Any]], slope: Any) -> tuple[Any, Any]:
    """Return the line through two points, or through one with a slope."""
    (x, y), *others = points
    for x2, y2 in others:
        slope = (y2 - y) / (x2 - x)
    return y - slope * x, slope


def series(value: Fraction, slope: Fraction | int) -> fmpq_series:
    """Return value + slope e as a power series in e, cut after e: what is computed of it is differentiated."""
    return fmpq_series([fmpq(one.numerator, one.denominator) for one in (value, slope)], prec=2)
