"""The signals of a scene as one sequence of pieces, exact: on each, every signal is one polynomial plus sines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import perm
from typing import TypeVar

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.pair import nearest
from numerics.arithmetic.precision import cached_property
from numerics.linear.model import BELT, FORCE, FRICTION, WALL, Layout
from numerics.scene import Piece, Scene, Sine

Number = TypeVar("Number", Fraction, arb)
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


def polynomial_at(terms: Sequence[Number], t: Number, order: int = 0) -> Number:
    """Return a derivative of a polynomial with these coefficients, from the constant on."""
    value = 0 * t
    for k in range(len(terms) - 1, order - 1, -1):
        value = value * t + terms[k] * perm(k, order)
    return value


def particular(polynomial: Sequence[Number], mass: Number, a1: Number, a2: Number) -> list[Number]:
    """Return the polynomial x with mass x'' + a1 x' + a2 x = polynomial."""
    found = [0 * a2] * (len(polynomial) + 2)
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
    ends = (piece, before.length), (after, Fraction(0))
    values = ([polynomial_at(one.polynomial, at, k) for k in range(orders)] for one, at in ends)
    return next(values) != next(values)
