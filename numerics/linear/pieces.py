"""The pieces of force and friction of a scene as one sequence, exact: on each, u is one polynomial plus sines."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from numerics.scene import Force, Friction, Scene, Sine
from numerics.scene.pieces import shifted

_AT_ONCE = np.zeros(1)


@dataclass(frozen=True, slots=True)
class ExactPiece:
    """u and b from `start` (s) for `length` (s): u = sum_k polynomial[k] (t - start)^k + sines, N. Exact.

    Sines count t from the start of the run. `is_jump`: u or b may jump where the piece begins, as on the first one.
    """

    start: Fraction
    length: Fraction
    b: Fraction
    polynomial: tuple[Fraction, ...]
    sines: tuple[Sine, ...]
    is_jump: bool


def pieces_of(scene: Scene, grid: Grid | None = None) -> Sequence[ExactPiece]:
    """Return the pieces from t = 0 up to the horizon, in order; made once and kept with the scene.

    `grid`: that of scenes before this one.
    """
    if "pieces" not in scene.made:
        scene.made["pieces"] = _pieces(scene, grid or Grid())
    found: Sequence[ExactPiece] = scene.made["pieces"]
    return found


def starts_of(scene: Scene) -> NDArray[np.float64]:
    """Return when the pieces begin, s; made once and kept with the scene."""
    if not (scene.force.pieces or scene.friction.pieces):
        return _AT_ONCE
    if "starts" not in scene.made:
        scene.made["starts"] = np.array([float(piece.start) for piece in pieces_of(scene)])
    found: NDArray[np.float64] = scene.made["starts"]
    return found


class Grid:
    """When the pieces of scenes begin and which of force and friction act; scenes of a batch may share the last one."""

    def __init__(self) -> None:
        """Begin with none."""
        self._of: tuple[object, ...] = ()
        self._found: list[tuple[Fraction, Fraction, int, int]] = []

    def of(self, force: Force, friction: Friction, until: Fraction) -> list[tuple[Fraction, Fraction, int, int]]:
        """Return of each piece start and length, s, and how many pieces of force and of friction have begun."""
        given = (friction, until, *force.starts)
        if len(given) != len(self._of) or any(one is not two for one, two in zip(given, self._of, strict=True)):
            self._of, self._found = given, _grid(force.starts, friction.starts, until)
        return self._found


def _grid(
    forces: Sequence[Fraction], frictions: Sequence[Fraction], until: Fraction
) -> list[tuple[Fraction, Fraction, int, int]]:
    starts = [Fraction(0)]
    for t in sorted((*forces, *frictions)):
        if starts[-1] < t < until:
            starts.append(t)
    ends = [*starts[1:], until]
    return [
        (start, end - start, bisect_right(forces, start), bisect_right(frictions, start))
        for start, end in zip(starts, ends, strict=True)
    ]


def _pieces(scene: Scene, grid: Grid) -> Sequence[ExactPiece]:
    found: list[ExactPiece] = []
    for start, length, forces, frictions in grid.of(scene.force, scene.friction, scene.until):
        b = scene.friction.pieces[frictions - 1][1] if frictions else scene.pair.b
        polynomial, sines = (), ()  # type: tuple[Fraction, ...], tuple[Sine, ...]
        if forces:
            piece = scene.force.pieces[forces - 1]
            polynomial, sines = piece.polynomial, piece.sines
            if polynomial and piece.start != start:
                polynomial = shifted(polynomial, start - piece.start)
        jumps = not found or _may_jump(found[-1], b, polynomial, sines)
        found.append(ExactPiece(start, length, b, polynomial, sines, jumps))
    return found


def polynomial_at(polynomial: Sequence[Fraction], t: Fraction) -> Fraction:
    """Return the value of a polynomial with these coefficients, from the constant on."""
    if not polynomial:
        return Fraction(0)
    value = polynomial[-1]
    for coefficient in polynomial[-2::-1]:
        value = value * t + coefficient
    return value


def particular(polynomial: Sequence[Fraction], mass: Fraction, a1: Fraction, a2: Fraction) -> list[Fraction]:
    """Return the polynomial x (m) with mass x'' + a1 x' + a2 x = polynomial (N)."""
    found = [Fraction(0)] * (len(polynomial) + 2)
    for k in reversed(range(len(polynomial))):
        pull = a1 * (k + 1) * found[k + 1] + mass * (k + 1) * (k + 2) * found[k + 2]
        found[k] = (polynomial[k] - pull) / a2
    return found[: len(polynomial)]


def _may_jump(before: ExactPiece, b: Fraction, polynomial: Sequence[Fraction], sines: tuple[Sine, ...]) -> bool:
    """Return whether u or b may differ on both sides of where a piece begins: sines that change count as a jump."""
    if before.b != b or before.sines != sines:
        return True
    return polynomial_at(before.polynomial, before.length) != (polynomial[0] if polynomial else 0)
