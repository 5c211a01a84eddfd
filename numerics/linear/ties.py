"""Which mode follows on v1 = v2 right after a time, on exact data: ties are decided by derivatives, to any order.

With s the side of the load, the tie Lambda = s b is decided by the first derivative of Lambda = m2 v2' along stick that
does not vanish: slip s where s Lambda^(k) > 0, stick where < 0. From x = x1 + v1 t + s (b/m2) t^2/2 stick parts by y,

    M y'' + a1 y' + a2 y = p = u - a2 x - a1 x' - s b M/m2,

so m2 y'' = Lambda - s b = (m2/M) p (1 + O(t)), and p vanishes if as many of its derivatives do as it has coefficients.
Then slip s and stick are the same motion, and it is called stick.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import count, islice
from math import perm

from numerics.linear.pieces import ExactPiece, polynomial_at
from numerics.linear.sine_form import SineForm
from numerics.linear.system import V1, V2, LinearMode
from numerics.scene import Pair, Piece

MARGINAL = 10**9
"""The order of a guard of which all derivatives vanish."""


def force_form(piece: Piece | ExactPiece, local: Fraction, order: int = 0) -> SineForm:
    """Return the derivative of this order of u at a time in a piece (s), exact."""
    derived = [perm(n, order) * c for n, c in enumerate(piece.polynomial)][order:]
    total = SineForm(polynomial_at(derived, local))
    for sine in piece.sines:
        angle = sine.omega * (piece.start + local) + sine.phase
        height = sine.amplitude * sine.omega**order * (-1 if order % 4 > 1 else 1)
        total += SineForm.turned(angle, *((Fraction(0), height) if order % 2 else (height, Fraction(0))))
    return total


def load_form(pair: Pair, piece: ExactPiece, local: Fraction, x: SineForm, v: SineForm) -> SineForm:
    """Return the load m2 (u - a2 x1 - a1 v1)/M, N, exact."""
    return (force_form(piece, local) - x * pair.a2 - v * pair.a1) * (pair.m2 / pair.mass)


def derivatives(mode: LinearMode, local: Fraction, state: Sequence[SineForm]) -> Iterator[list[SineForm]]:
    """Yield the derivatives of (x1, v1, x2, v2, 1) along a mode from a time in its piece (s), from the first on."""
    A, moved = replace(mode, piece=Piece(0)).generator(), (V1,) if mode.side else (V1, V2)
    z = [*state, SineForm(1)]
    for order in count():
        z = [sum((one * c for one, c in zip(z, row, strict=True) if c), SineForm()) for row in A]
        push = force_form(mode.piece, local, order) * (1 / mode.mass)
        for place in moved:
            z[place] += push
        yield z


def mode_after(
    pair: Pair, piece: ExactPiece, local: Fraction, x: SineForm, v: SineForm, *, literal: bool
) -> tuple[int, int]:
    """Return the mode that follows v1 = v2 = v, x1 = x, and how many derivatives of its guard vanish (or MARGINAL)."""
    load = load_form(pair, piece, local, x, v)
    side = 1 if load.sign() >= 0 else -1
    beyond = (load * side - piece.b).sign()
    if literal or beyond < 0:
        return 0, 0
    if beyond > 0:
        return side, 1
    along = derivatives(LinearMode(pair, piece.b, 0, piece), local, (x, v, x, v))
    for k, z in enumerate(islice(along, len(piece.polynomial) + 2 * len(piece.sines) + 4)):
        sign = side * z[V2].sign()
        if k and sign:
            return (side, k + 1) if sign > 0 else (0, k)
    return 0, MARGINAL
