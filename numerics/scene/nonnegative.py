"""A proof in balls that b(t) >= 0, for polynomials and sines; at whatever precision, it holds."""

from __future__ import annotations

from fractions import Fraction

from flint import arb, arb_poly, fmpq

from numerics.errors import InvalidScene
from numerics.scene.decimals import short
from numerics.scene.pieces import Piece

_MOST, _SMALLEST = 10_000, 2.0**-40
"""Intervals times sines, and the smallest part of a piece that is looked at."""


def require_nonnegative(piece: Piece, length: Fraction) -> None:
    """Raise InvalidScene, with a place, unless b(t) >= 0 is proved for some time from the start of a piece.

    On an interval, b is at least its value in the middle less what its slope takes up to the ends.
    """
    if piece.frequency:
        length = min(length, 7 / piece.frequency)  # more than a period
    b = arb_poly([_ball(c) for c in piece.polynomial])
    waves = [(_ball(s.amplitude), _ball(s.omega), _ball(s.omega * piece.start + s.phase)) for s in piece.sines]
    todo = [(0.0, 1.0)]
    for _ in range(_MOST // (1 + len(waves))):
        left, width = todo.pop()
        half = width / 2
        middle, reach = _ball(length) * (left + half), _ball(length) * half
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
    at = float(middle + _ball(piece.start))
    raise InvalidScene(
        f"friction from t = {short(piece.start)} s: b = {float(value):.3g} at t = {at:.6g} s, and b(t) >= 0 must be "
        "proved; raise its constant, or begin a piece where it touches 0"
    )


def _ball(value: Fraction) -> arb:
    return arb(fmpq(value.numerator, value.denominator))
