"""Which mode follows on v1 = v2 right after a time, on exact data: ties are decided by derivatives, to any order.

A guard of stick that vanishes is decided by the first derivative of it along stick that does not: slip where < 0,
stick where > 0. Up to there both modes agree, so that it says what happens in either. If all vanish, which as many as z
has components settle, slip and stick are the same motion, and it is called stick.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain
from math import perm

from numerics.linear.model import FORCE, FRICTION
from numerics.linear.pieces import ExactPiece, polynomial_at
from numerics.linear.sine_form import SineForm
from numerics.linear.system import LinearMode, Row, sparse
from numerics.scene import Pair, Piece

MARGINAL = 10**9
"""The order of a guard of which all derivatives vanish."""


def force_form(piece: Piece | ExactPiece, local: Fraction, order: int = 0) -> SineForm:
    """Return the derivative of this order of u at a time in a piece (s), exact."""
    return _value(piece if isinstance(piece, Piece) else piece.signals[FORCE], piece.start, local, order)


def signal_form(piece: ExactPiece, which: int, local: Fraction, order: int = 0) -> SineForm:
    """Return a derivative of a signal at a time in a piece (s), exact."""
    return _value(piece.signals[which], piece.start, local, order)


def _value(signal: Piece, start: Fraction, local: Fraction, order: int = 0) -> SineForm:
    polynomial, waves = blocks_of(signal, start, local, order)
    return sum(waves[::2], polynomial[0] if polynomial else SineForm())


def blocks_of(signal: Piece, start: Fraction, local: Fraction, order: int = 0) -> tuple[list[SineForm], list[SineForm]]:
    """Return what of z is a derivative of a signal at a time in a piece: polynomial, sines; it begins at `start`."""
    terms, waves = signal.polynomial, []
    derivatives = ([perm(n, k) * c for n, c in enumerate(terms)][k:] for k in range(order, len(terms)))
    for sine in signal.sines:
        angle, height = sine.omega * (start + local) + sine.phase, sine.amplitude * sine.omega**order
        for k in (order, order + 1):
            size = -height if k % 4 > 1 else height
            waves.append(SineForm.turned(angle, *((Fraction(0), size) if k % 2 else (size, Fraction(0)))))
    return [SineForm(polynomial_at(one, local)) for one in derivatives], waves


def exact_z(piece: ExactPiece, side: int, local: Fraction, state: Sequence[SineForm]) -> list[SineForm]:
    """Return z at a time in a piece (s), in a mode `side`."""
    signs = [1] * FRICTION + [side or 1]
    found = [blocks_of(one, piece.start, local) for one in piece.signals]
    kinds = (
        [one * sign for sign, kind in zip(signs, kinds, strict=True) for one in kind]
        for kinds in zip(*found, strict=True)
    )
    return [*state, *chain.from_iterable(kinds)]


def applied(row: Row, z: Sequence[SineForm]) -> SineForm:
    """Return the value of a row."""
    return sum((z[place] * c for place, c in row), SineForm())


def derivatives(mode: LinearMode, local: Fraction, state: Sequence[SineForm]) -> Iterator[list[SineForm]]:
    """Yield the derivatives of z along a mode from a time in its piece (s), from z itself on, as many as decide all."""
    z, A = exact_z(mode.piece, mode.side, local, state), [sparse(row) for row in mode.generator()]
    for _ in range(mode.size + 1):
        yield z
        z = [applied(row, z) for row in A]


def load_form(pair: Pair, piece: ExactPiece, local: Fraction, state: Sequence[SineForm]) -> SineForm:
    """Return the load, N, exact."""
    return applied(LinearMode(pair, 0, piece).load, exact_z(piece, 0, local, state))


def mode_after(
    pair: Pair, piece: ExactPiece, local: Fraction, state: Sequence[SineForm], *, literal: bool
) -> tuple[int, int]:
    """Return the mode that follows a state with v1 = v2, and how many derivatives of its guard vanish (or MARGINAL)."""
    stick = LinearMode(pair, 0, piece)
    if literal:
        return 0, 0
    tied = dict(zip((1, -1), stick.guards, strict=True))
    for k, z in enumerate(derivatives(stick, local, state)):
        for side, row in list(tied.items()):
            sign = applied(row, z).sign()
            if sign < 0:
                # with more friction at rest the slip begins with a rate of its own
                return side, k + 1 if pair.b_static in {None, pair.b} else 1
            if sign > 0:
                del tied[side]
        if not tied:
            return 0, k
    return 0, MARGINAL
