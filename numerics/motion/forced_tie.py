"""How long a guard with a multiple root at its start is sure to stay positive, by Taylor's formula on exact data."""

from __future__ import annotations

from fractions import Fraction
from math import factorial
from typing import Any

from numerics.motion.forced_pieces import ExactPiece
from numerics.motion.forced_rules import force_form
from numerics.scene import Pair


def quiet_after_tie(pair: Pair, piece: ExactPiece, knot: Any) -> Fraction:
    """Return a time in the piece up to which the guard of a mode, of whose derivatives `order` vanish, is positive.

    With g^(k) the first derivative that does not vanish and |g^(k+1)| <= B for a time h, g > 0 up to
    min(h, (k+1) g^(k)/B); half of that is taken. In a slip g^(k) is that of s (v1 - v2), in stick of b - s Lambda.
    """
    mass, order = (pair.m1 if knot.mode else pair.mass), knot.order
    n = order + (1 if knot.mode else 2)  # g^(k) is x1^(n), but for a factor
    weight = 1.0 if knot.mode else float(pair.m2)
    derivatives = _derivatives(pair, piece, knot, mass, n + 1)
    lead, one = (abs(float(derivatives[k].enclosed(256).mid())) for k in (n, n + 1))
    h = float(piece.length - knot.local)
    # |x^(n+1)| grows by int |u^(n)|/m at most (flows/forced_jet.py)
    push = sum(float(abs(s.amplitude) * s.omega**n) for s in piece.sines)
    for k in range(n, len(piece.polynomial)):
        top = factorial(k) // factorial(k - n)
        push += float(abs(piece.polynomial[k]) * top) * float(piece.length) ** (k - n)
    bound = 1.01 * ((float(pair.a2 / mass) * lead * lead + one * one) ** 0.5 + h * push / float(mass))
    h = min(h, (order + 1) * lead / bound) / 2
    while not knot.mode and 1.5 * weight * lead * h**order / factorial(order) > float(piece.b):
        h /= 2  # so long the load does not get as far as the other edge
    return knot.local + Fraction(f"{h:.6g}")  # half of the bound leaves room for the rounding


def _derivatives(pair: Pair, piece: ExactPiece, knot: Any, mass: Fraction, most: int) -> list[Any]:
    """Return x1 and its derivatives up to the order `most`, exact."""
    found = [knot.x1, knot.v1]
    for k in range(most - 1):
        force = force_form(piece, knot.local, k)
        if k == 0:
            force = force - knot.mode * piece.b
        found.append((force - found[k + 1] * pair.a1 - found[k] * pair.a2) * (1 / mass))
    return found
