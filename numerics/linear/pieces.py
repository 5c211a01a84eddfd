"""The pieces of force and friction of a scene as one sequence, exact: on each, u is one polynomial plus sines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.pair import nearest
from numerics.scene import Piece, Scene, Sine
from numerics.scene.pieces import shifted

_AT_ONCE, _NO_FORCE, _START = np.zeros((2, 1)), Piece(0), Fraction(0)


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
    if "pieces" in scene.made:
        return scene.made["pieces"]
    found: list[ExactPiece] = []
    force, b = _NO_FORCE, scene.pair.b
    begun: list[tuple[Fraction, Piece | Fraction]] = [(piece.start, piece) for piece in scene.force.pieces]
    begun += scene.friction.steps
    changes = sorted([one for one in begun if one[0] < scene.until], key=itemgetter(0))
    for (start, change), (end, _) in pairwise([(_START, b), *changes, (scene.until, b)]):
        if isinstance(change, Piece):
            force = change
        else:
            b = change
        if start < end:
            polynomial = force.polynomial
            if len(polynomial) > 1 and force.start < start:
                polynomial = shifted(polynomial, start - force.start)
            jumps = not found or _may_jump(found[-1], b, polynomial, force.sines)
            found.append(ExactPiece(start, end - start, b, polynomial, force.sines, jumps))
    scene.made["pieces"] = found
    return found


def starts_of(scene: Scene) -> NDArray[np.float64]:
    """Return when the pieces begin (s) and what rounding left out of it, shape (2, n); kept with the scene."""
    if not (scene.force.pieces or scene.friction.steps):
        return _AT_ONCE
    if "starts" not in scene.made:
        scene.made["starts"] = np.array([nearest(piece.start) for piece in pieces_of(scene)]).T.copy()
    return scene.made["starts"]


def polynomial_at(polynomial: Sequence[Fraction], t: Fraction) -> Fraction:
    """Return the value of a polynomial with these coefficients, from the constant on."""
    value = Fraction(0)
    for coefficient in reversed(polynomial):
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
