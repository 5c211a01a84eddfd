"""The signals of a scene as one sequence of pieces, exact: on each, every signal is one polynomial plus sines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.pair import nearest
from numerics.arithmetic.precision import cached_property
from numerics.linear.model import BELT, FORCE, FRICTION, WALL, Layout
from numerics.scene import Piece, Scene, Sine

_NOTHING = Piece(0)


@dataclass(frozen=True)
class ExactPiece:
    """The signals from `start` (s) for `length` (s), in the order of model.py: force, force_2, belt, wall, friction.

    Of each the polynomial is one of t - start, and sines count t from the start of the run. `is_jump`: something that
    friction has to balance may jump where the piece begins, as on the first one; `belt_jumps`: the belt's velocity may.
    """

    start: Fraction
    length: Fraction
    signals: tuple[Piece, ...]
    is_jump: bool
    belt_jumps: bool = False

    @property
    def polynomial(self) -> tuple[Fraction, ...]:
        """Return the coefficients of u."""
        return self.signals[FORCE].polynomial

    @property
    def sines(self) -> tuple[Sine, ...]:
        """Return the sines of u."""
        return self.signals[FORCE].sines

    @property
    def b(self) -> Fraction:
        """Return the friction force of a piece on which it is one number, N."""
        b = self.signals[FRICTION].constant
        if b is None:
            raise ArithmeticError("friction varies on this piece")
        return b

    def with_friction(self, b: Fraction) -> ExactPiece:
        """Return the piece with another friction force, N."""
        return replace(self, signals=(*self.signals[:FRICTION], Piece(0, (b,))))

    @cached_property
    def layout(self) -> Layout:
        """Return what of the signals the matrices of the modes depend on."""
        omegas = tuple(tuple(sine.omega for sine in one.sines) for one in self.signals)
        return Layout(tuple(len(one.polynomial) for one in self.signals), omegas)


@lru_cache(maxsize=128)
def pieces_of(scene: Scene) -> Sequence[ExactPiece]:
    """Return the pieces from t = 0 up to the horizon, in order."""
    acting = [_NOTHING, _NOTHING, _NOTHING, _NOTHING, Piece(0, (scene.pair.b,))]
    given = enumerate(scene.pieces.values())  # in the order of model.py
    begun = [(piece.start, signal, piece) for signal, pieces in given for piece in pieces if piece.start < scene.until]
    changes = [(Fraction(0), FRICTION, acting[-1]), *sorted(begun, key=lambda one: one[:2])]
    ends = [*(start for start, *_ in changes[1:]), scene.until]
    found: list[ExactPiece] = []
    for (start, signal, piece), end in zip(changes, ends, strict=True):
        is_lifted_off = signal == FRICTION and not (piece.polynomial or piece.sines)
        acting[signal] = Piece(piece.start, (0,)) if is_lifted_off else piece
        if start < end:
            signals = tuple(one.moved(start) if len(one.polynomial) > 1 else one for one in acting)
            jumps = [not found or _may_jump(found[-1], k, one) for k, one in enumerate(signals)]
            found.append(ExactPiece(start, end - start, signals, any(jumps), jumps[BELT]))
    return found


@lru_cache(maxsize=128)
def starts_of(scene: Scene) -> NDArray[np.float64]:
    """Return when the pieces begin (s) and what rounding left out of it, shape (2, n)."""
    return np.array([nearest(piece.start) for piece in pieces_of(scene)]).T.copy()


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


def _may_jump(before: ExactPiece, signal: int, after: Piece) -> bool:
    """Return whether a signal, or of belt and wall its derivative, may differ on both sides of where a piece begins.

    Sines that change count as a jump.
    """
    piece = before.signals[signal]
    if piece is after or (piece.sines != after.sines):
        return piece is not after
    orders = 2 if signal in {BELT, WALL} else 1
    return any(_derivative_at(piece, k, before.length) != _derivative_at(after, k, Fraction(0)) for k in range(orders))


def _derivative_at(piece: Piece, order: int, local: Fraction) -> Fraction:
    polynomial = list(piece.polynomial)
    for _ in range(order):
        polynomial = [k * c for k, c in enumerate(polynomial)][1:]
    return polynomial_at(polynomial, local)
