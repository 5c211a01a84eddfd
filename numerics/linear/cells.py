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
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.ball import Ball
from numerics.errors import InvalidScene
from numerics.linear.pieces import ExactPiece
from numerics.linear.sine_form import SineForm
from numerics.linear.system import LinearMode
from numerics.linear.ties import MARGINAL
from numerics.scene import Pair, Piece, Scene
from numerics.scene.decimals import short

Line = tuple[Fraction, Fraction]
"""p + q x as (p, q)."""


class Branch(NamedTuple):
    """F = side offset + slope w + pull z, N: friction in one cell."""

    offset: Fraction
    slope: Fraction
    pull: Fraction


class Start(NamedTuple):
    """Where a slip begins: its cell, and how many derivatives of its guards vanish there (FLOOR to RIGHT)."""

    cell: tuple[int, int]
    orders: tuple[int, int, int, int]


FLOOR, CEILING, LEFT, RIGHT, FORCE = range(5)
"""The guards of a slip: |w| falls to v_k (v_0 = 0 ends the slip), rises to v_k+1; z at either end; B + C gets to 0."""
PLAIN = (0, 0)


class Cells:
    """The cells of one scene; k counts from 0 at |w| = 0, j from 0 left of the first place."""

    def __init__(self, scene: Scene) -> None:
        """Cut B and C of a scene that has them."""
        weakening = scene.friction.weakening
        if weakening is None:
            raise InvalidScene("this scene's friction does not depend on the state; give it a Weakening")
        self.pair: Pair = scene.pair
        points = ((Fraction(0), self.pair.b), *weakening.speed)
        self.speeds, self.places = [w for w, _ in points], [z for z, _ in weakening.place]
        (w, b), flat = points[-1], weakening.place or ((Fraction(0), Fraction(0)),)
        self.by_speed: list[Line] = [*_lines(points), (b - weakening.last_slope * w, weakening.last_slope)]
        self.by_place: list[Line] = [(flat[0][1], Fraction(0)), *_lines(flat)]
        if weakening.place:
            self.by_place.append((flat[-1][1], Fraction(0)))
        self.falling = max(Fraction(0), *(-slope for _, slope in self.by_speed))
        """The greatest -B', N s/m, and the greatest |C'|, N/m."""
        self.pulling = max(abs(slope) for _, slope in self.by_place)
        most = max((b for _, b in scene.friction.pieces), default=self.pair.b) / self.pair.b
        self.falling, self.pulling = (one * max(Fraction(1), most) for one in (self.falling, self.pulling))

    def scale(self, piece: ExactPiece) -> Fraction:
        """Return b(t)/b of a piece."""
        return piece.b / self.pair.b

    def branch(self, piece: ExactPiece, side: int, cell: tuple[int, int]) -> Branch:
        """Return friction in a cell."""
        scale, (p, slope), (q, pull) = self.scale(piece), self.by_speed[cell[0]], self.by_place[cell[1]]
        return Branch(scale * (p + q), scale * slope, scale * side * pull)

    def mode(self, piece: ExactPiece, side: int, cell: tuple[int, int]) -> LinearMode:
        """Return the linear mode of a slip in a cell."""
        offset, slope, pull = self.branch(piece, side, cell)
        driven = Piece(piece.start, piece.polynomial, piece.sines)
        return LinearMode(self.pair, offset, side, driven, slope, pull)

    def by_numbers(self, piece: ExactPiece, side: int, cell: tuple[int, int], b: str) -> dict[str, Branch]:
        """Return the derivatives of friction in a cell by the numbers in it; `b` is the name of the piece's b."""
        (k, j), (w, z), last = cell, (self.speeds, self.places), len(self.speeds) - 1
        (p, slope), (q, pull), scale = self.by_speed[k], self.by_place[j], self.scale(piece)
        speeds = ["", *(f"weakening.speed[{n}]" for n in range(last))]
        found: dict[str, tuple[Fraction, Fraction, Fraction]] = {}
        if k < last:
            for n, (name_w, name_b) in ((n, (f"{speeds[n]}.w", f"{speeds[n]}.b" if n else "b")) for n in (k, k + 1)):
                line = _by_height(w[k : k + 2], n - k)
                found[name_b] = (*line, Fraction(0))
                found[name_w] = (-slope * line[0], -slope * line[1], Fraction(0))
        else:
            found["weakening.last_slope"] = (-w[k], Fraction(1), Fraction(0))
            found[f"{speeds[k]}.b" if k else "b"] = (Fraction(1), Fraction(0), Fraction(0))
            found[f"{speeds[k]}.w"] = (-slope, Fraction(0), Fraction(0))
        ends = [n for n in (j - 1, j) if 0 <= n < len(z)]
        for n in ends:
            line = _by_height([z[one] for one in ends], n - ends[0]) if len(ends) == 2 else (Fraction(1), Fraction(0))
            found[f"weakening.place[{n}].c"] = (line[0], Fraction(0), line[1])
            found[f"weakening.place[{n}].z"] = (-pull * line[0], Fraction(0), -pull * line[1])
        found.pop(".w", None)  # w = 0 is no number of the scene
        scaled = {
            name: Branch(scale * one, scale * two, scale * side * three) for name, (one, two, three) in found.items()
        }
        if b != "b":
            whole = Branch(p + q, slope, side * pull)
            scaled[b] = Branch(*(one / self.pair.b for one in whole))
            own = scaled.get("b", Branch(Fraction(0), Fraction(0), Fraction(0)))
            scaled["b"] = Branch(*(one - scale / self.pair.b * two for one, two in zip(own, whole, strict=True)))
        return scaled

    def growth(self, branch: Branch) -> arb:
        """Return the greatest rate, 1/s, at which N of a difference of two motions in one cell grows."""
        kappa2, g = self.pair.mass / (self.pair.m1 * self.pair.m2), self.pulling
        rate = Ball.number(kappa2 * max(Fraction(0), -branch.slope))
        return rate + Ball.number(kappa2 * (g - branch.pull) ** 2 / (4 * g)).sqrt() if g else rate

    def held(self, piece: ExactPiece, z: arb) -> arb:
        """Return B(0) + C over a ball of places x1 - x2."""
        found: arb | None = None
        for j, (q, pull) in enumerate(self.by_place):
            _, _, low, high = self.ends((0, j))
            if not ((low is not None and z < Ball.number(low)) or (high is not None and z > Ball.number(high))):
                one = Ball.number(self.pair.b + q) + Ball.number(pull) * z
                found = one if found is None else found.union(one)
        return (arb("nan") if found is None else found) * Ball.number(self.scale(piece))

    def place_line(self, z: float | Fraction, side: int = 1) -> int:
        """Return the interval of a place; at a knot that towards which z moves."""
        return (bisect_right if side > 0 else bisect_left)(self.places, z)

    def at_rest(self, z: Fraction) -> Fraction:
        """Return B(0) + C(z), for b itself, exact; raises InvalidScene unless it is > 0."""
        q, slope = self.by_place[self.place_line(z)]
        if self.pair.b + q + slope * z <= 0:
            raise self.vanishing(Fraction(0), z)
        return self.pair.b + q + slope * z

    def relative(self, w: NDArray[np.float64], z: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return (B(|w|) + C(z))/b in binary64, for drawing."""
        lines = [np.array(one, dtype=float) for one in (self.by_speed, self.by_place)]
        k, j = (
            np.searchsorted(np.array(at, dtype=float), x) for at, x in ((self.speeds[1:], abs(w)), (self.places, z))
        )
        force = lines[0][k, 0] + lines[0][k, 1] * abs(w) + lines[1][j, 0] + lines[1][j, 1] * z
        return np.asarray(force / float(self.pair.b))

    def stuck_pieces(self, pieces: Sequence[ExactPiece], z: Fraction) -> list[ExactPiece]:
        """Return the pieces with what friction can hold at a place for b: so long as the bodies stick it stays."""
        held = self.at_rest(z) / self.pair.b
        return [replace(one, b=one.b * held) for one in pieces]

    def ends(self, cell: tuple[int, int]) -> tuple[Fraction | None, ...]:
        """Return the ends of a cell: |w| from and to, z from and to; None where there is none."""
        (k, j), last = cell, len(self.places)
        above = self.speeds[k + 1] if k + 1 < len(self.speeds) else None
        return self.speeds[k], above, self.places[j - 1] if j else None, self.places[j] if j < last else None

    def may_vanish(self, cell: tuple[int, int]) -> bool:
        """Return whether B + C <= 0 somewhere in a cell."""
        (low, high, *sides), (p, slope), (q, pull) = self.ends(cell), self.by_speed[cell[0]], self.by_place[cell[1]]
        if high is None and slope < 0:
            return True
        b = min(p + slope * w for w in (low, high) if w is not None)
        return b + q + min([pull * z for z in sides if z is not None], default=Fraction(0)) <= 0

    def vanishing(self, w: float | Fraction, z: float | Fraction, at: str = "") -> InvalidScene:
        """Return the error for a motion that gets to a place where friction is not positive."""
        return InvalidScene(
            f"B + C <= 0 at |w| = {short(Fraction(w))} m/s, z = x1 - x2 = {short(Fraction(z))} m{at}: friction must be "
            "positive wherever the motion goes; raise B or C there"
        )

    def start(self, piece: ExactPiece, side: int, local: Fraction, state: Sequence[SineForm], order: int) -> Start:
        """Return where a slip begins from an exact state, whose w vanishes to an order; ties by derivatives."""
        x1, v1, x2, v2 = state
        w, z = ((v1 - v2) * side).rational, (x1 - x2).rational
        if w is None or z is None:
            raise ArithmeticError("a slip begins from rational w and z")
        if w == 0:
            j = self.place_line(z, side)
            at = order + 1 if z in self.places else 0
            return Start((0, j), (order, 0, at * (side > 0), at * (side < 0)))
        j, tie = self.place_line(z, side), int(z in self.places)
        k = bisect_right(self.speeds, w) - 1
        (p, slope), (q, pull) = self.by_speed[k], self.by_place[j]
        if p + q + slope * w + pull * z <= 0:
            raise self.vanishing(w, z, " at t = 0")
        orders = [0, 0, tie * (side > 0), tie * (side < 0)]
        if w == self.speeds[k]:
            rising, m = self._leaves(self.mode(piece, side, (k, j)), piece, local, state)
            k, orders[FLOOR if rising else CEILING] = k - (not rising), m
        return Start((k, j), (orders[0], orders[1], orders[2], orders[3]))

    def _leaves(
        self, mode: LinearMode, piece: ExactPiece, local: Fraction, state: Sequence[SineForm]
    ) -> tuple[bool, int]:
        """Return whether |w| rises from a knot, and which derivative says so (MARGINAL: none, it stays there)."""
        z, A = mode.exact_start(state, piece.start + local), mode.generator()
        for order in range(1, mode.size + 1):
            z = [sum((one * c for one, c in zip(z, row, strict=True) if c), SineForm()) for row in A]
            sign = mode.side * (z[1] - z[3]).sign()
            if sign:
                return sign > 0, order
        return True, MARGINAL


def cells_of(scene: Scene) -> Cells | None:
    """Return the cells of a scene, made once and kept with it; None where friction does not depend on the state."""
    if scene.friction.weakening is None:
        return None
    if "cells" not in scene.made:
        scene.made["cells"] = Cells(scene)
    found: Cells = scene.made["cells"]
    return found


def _by_height(ends: Sequence[Fraction], which: int) -> Line:
    """Return the derivative of the line between two points by the height of one of them."""
    slope = 1 / (ends[which] - ends[1 - which])
    return -slope * ends[1 - which], slope


def mode_in(scene: Scene, piece: ExactPiece, side: int, cell: tuple[int, int]) -> LinearMode:
    """Return the linear mode `side` of any scene in a piece, and in a cell where it has any."""
    cells = cells_of(scene)
    if cells is not None and side:
        return cells.mode(piece, side, cell)
    return LinearMode(scene.pair, piece.b, side, Piece(piece.start, piece.polynomial, piece.sines))


def _lines(points: Sequence[tuple[Fraction, Fraction]]) -> list[Line]:
    """Return the lines between neighbouring points."""
    slopes = [((y2 - y1) / (x2 - x1), x1, y1) for (x1, y1), (x2, y2) in pairwise(points)]
    return [(y - slope * x, slope) for slope, x, y in slopes]
