"""A proof that friction b(t), of polynomials and sines, is never negative."""

from __future__ import annotations

from fractions import Fraction
from math import comb
from typing import Any

from numerics.errors import InvalidScene
from numerics.scene.decimals import short
from numerics.scene.friction import Friction
from numerics.scene.pieces import Piece

_MOST, _SMALLEST = 100_000, 2.0**-40
"""Intervals times sines, and the smallest part of a piece that is looked at."""


def require_nonnegative(friction: Friction, until: Fraction) -> None:
    """Raise InvalidScene, with a time and the value there, unless b(t) >= 0 is proved up to `until` (s).

    Where the polynomial of a piece stays above the sum of the amplitudes, which b = 1 + sin t just does, that is exact.
    """
    for piece, end in zip(friction.pieces, (*friction.starts[1:], until), strict=False):
        length = min(end, until) - piece.start
        if length >= 0 and least_of(piece.polynomial, length) < sum(abs(one.amplitude) for one in piece.sines):
            _prove_in_balls(piece, length)


def least_of(polynomial: tuple[Fraction, ...], length: Fraction) -> Fraction:
    """Return the least Bernstein coefficient of a polynomial on [0, length]: it is never less; exact."""
    degree = len(polynomial) - 1
    scaled = [c * length**k / comb(degree, k) for k, c in enumerate(polynomial)]
    terms = (sum(comb(i, k) * c for k, c in enumerate(scaled[: i + 1])) for i in range(degree + 1))
    return Fraction(min(terms, default=0))


def _prove_in_balls(piece: Piece, length: Fraction) -> None:
    """Prove it for some time from the start of a piece, at whatever precision flint has.

    On an interval, b is at least its value in the middle less what its slope takes up to the ends.
    """
    from flint import arb, arb_poly, fmpq  # which most scenes do not need

    def ball(value: Fraction) -> Any:
        return arb(fmpq(value.numerator, value.denominator))

    if piece.frequency:
        length = min(length, 7 / piece.frequency)  # more than a period
    b = arb_poly([ball(c) for c in piece.polynomial])
    waves = [(ball(s.amplitude), ball(s.omega), ball(s.omega * piece.start + s.phase)) for s in piece.sines]
    todo = [(0.0, 1.0)]
    for _ in range(_MOST // (1 + len(waves))):
        left, width = todo.pop()
        half = width / 2
        middle, reach = ball(length) * (left + half), ball(length) * half
        around = arb(middle, reach)
        value = b(middle) + sum(size * (omega * middle + phase).sin() for size, omega, phase in waves)
        slope = b.derivative()(around) + sum(
            size * omega * (omega * around + phase).cos() for size, omega, phase in waves
        )
        if not value - abs(slope) * reach >= 0:
            if value < 0 or half < _SMALLEST:
                break
            todo += [(left + half, half), (left, half)]
        if not todo:
            return
    at = float(middle + ball(piece.start))
    raise InvalidScene(
        f"friction from t = {short(piece.start)} s: b(t) >= 0 is not proved at t = {at:.6g} s, where b = "
        f"{float(value):.3g} N; raise its constant, or begin a piece where it touches 0"
    )
