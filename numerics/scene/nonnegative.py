"""A proof that friction b(t), of polynomials and sines, is never negative."""

from __future__ import annotations

from fractions import Fraction
from math import comb

from numerics.errors import InvalidScene
from numerics.scene.decimals import short
from numerics.scene.friction import Friction
from numerics.scene.pieces import Piece

_DIGITS = 14
"""To which the least value is looked for, at whatever precision flint has."""


def require_nonnegative(friction: Friction, until: Fraction) -> None:
    """Raise InvalidScene, with a time and the value there, unless b(t) >= 0 is proved up to `until` (s).

    Where the polynomial of a piece stays above the sum of the amplitudes, which b = 1 + sin t just does, that is exact.
    """
    for piece, end in zip(friction.pieces, (*friction.starts[1:], until), strict=False):
        length = min(end, until) - piece.start
        if length > 0 and least_of(piece.polynomial, length) < sum(abs(one.amplitude) for one in piece.sines):
            _prove_in_balls(piece, length)


def least_of(polynomial: tuple[Fraction, ...], length: Fraction) -> Fraction:
    """Return the least Bernstein coefficient of a polynomial on [0, length]: it is never less; exact."""
    degree = len(polynomial) - 1
    scaled = [c * length**k / comb(degree, k) for k, c in enumerate(polynomial)]
    terms = (sum(comb(i, k) * c for k, c in enumerate(scaled[: i + 1])) for i in range(degree + 1))
    return Fraction(min(terms, default=0))


def _prove_in_balls(piece: Piece, length: Fraction) -> None:
    """Prove it for some time from the start of a piece: what b falls short of a number above it is at most that."""
    from numerics.scene.largest import ball, largest_size, over  # flint, which most scenes do not need

    if piece.frequency:
        length = min(length, 7 / piece.frequency)  # more than a period
    above = sum((abs(c) * length**k for k, c in enumerate(piece.polynomial)), Fraction(0))
    begin, most = ball(piece.start), ball(above + sum(abs(one.amplitude) for one in piece.sines))
    b = over(piece)
    short_of, at = largest_size(
        lambda t, order: most * (not order) - b(t, order), begin, begin + ball(length), _DIGITS, most
    )
    if short_of <= most:
        return
    raise InvalidScene(
        f"friction from t = {short(piece.start)} s: b(t) >= 0 is not proved at t = {float(at):.6g} s, where only b >= "
        f"{float(most - short_of):.3g} N is known; raise its constant, or begin a piece where it touches 0"
    )
