"""The pieces of force and friction of a scene as one sequence, exact: on each, u is one polynomial plus sines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from numerics.scene import Scene, Sine
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


def pieces_of(scene: Scene) -> Sequence[ExactPiece]:
    """Return the pieces from t = 0 up to the horizon, in order; made once and kept with the scene."""
    if "pieces" not in scene.made:
        scene.made["pieces"] = _pieces(scene)
    found: Sequence[ExactPiece] = scene.made["pieces"]
    return found


def starts_of(scene: Scene) -> NDArray[np.float64]:
    """Return when the pieces begin, s; made once and kept with the scene."""
    if not scene.is_forced:
        return _AT_ONCE
    if "starts" not in scene.made:
        scene.made["starts"] = np.array([float(piece.start) for piece in pieces_of(scene)])
    found: NDArray[np.float64] = scene.made["starts"]
    return found


def _pieces(scene: Scene) -> Sequence[ExactPiece]:
    force, friction, until = scene.force, scene.friction, scene.until
    starts = [Fraction(0)]
    for t in sorted((*force.starts, *friction.starts)):
        if starts[-1] < t < until:
            starts.append(t)
    found: list[ExactPiece] = []
    b, piece, forces, frictions = scene.pair.b, None, 0, 0
    for start, end in zip(starts, [*starts[1:], until], strict=True):
        while frictions < len(friction.pieces) and friction.pieces[frictions][0] <= start:
            b, frictions = friction.pieces[frictions][1], frictions + 1
        while forces < len(force.pieces) and force.pieces[forces].start <= start:
            piece, forces = force.pieces[forces], forces + 1
        polynomial, sines = (piece.polynomial, piece.sines) if piece is not None else ((), ())
        if piece is not None and piece.start != start:
            polynomial = shifted(polynomial, start - piece.start)
        jumps = not found or _may_jump(found[-1], b, polynomial, sines)
        found.append(ExactPiece(start, end - start, b, polynomial, sines, jumps))
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
