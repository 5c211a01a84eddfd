"""Which mode follows on v1 = v2 right after a time, on exact data: ties are decided by derivatives, to any order.

With s the side of the load, the tie Lambda = s b is decided by the first k with p^(k) != 0: slip s where s p^(k) > 0,
stick where < 0. p' = u' - a2 v1 - a1 s b/m2, p'' = u'' - a2 s b/m2, p^(k) = u^(k) for k > 2, from the right.
Along x1 + v1 t + s (b/m2) t^2/2 both modes agree, and Lambda - s b = (m2/M) p (1 + O(t)) in either. If all vanish,
slip s and stick are the same motion, and it is called stick.
"""

from __future__ import annotations

from fractions import Fraction
from math import perm

from numerics.linear.pieces import ExactPiece, polynomial_at
from numerics.linear.sine_form import SineForm
from numerics.scene import Pair

MARGINAL = 10**9
"""The order of a guard of which all derivatives vanish."""


def force_form(piece: ExactPiece, local: Fraction, order: int = 0) -> SineForm:
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
    brake = side * piece.b / pair.m2
    for k in range(1, len(piece.polynomial) + 2 * len(piece.sines) + 4):
        found = force_form(piece, local, k)
        if k == 1:
            found = found - v * pair.a2 - pair.a1 * brake
        elif k == 2:
            found = found - pair.a2 * brake
        sign = side * found.sign()
        if sign != 0:
            return (side, k + 1) if sign > 0 else (0, k)
    return 0, MARGINAL
