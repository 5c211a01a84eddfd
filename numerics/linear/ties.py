"""Which mode follows on v1 = v2 right after a time, on exact data: ties are decided by derivatives, to any order.

A guard of stick that vanishes is decided by the first derivative of it along stick that does not: slip where < 0,
stick where > 0. Up to there both modes agree, so that it says what happens in either. If all vanish, which as many as z
has components settle, slip and stick are the same motion, and it is called stick.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from numerics.linear.model import FRICTION
from numerics.linear.pieces import ExactPiece, polynomial_at
from numerics.linear.sine_form import SineForm
from numerics.linear.system import LinearMode, Row, sparse
from numerics.scene import Piece, Sine

MARGINAL = 10**9
"""The order of a guard of which all derivatives vanish."""


def force_form(force: Piece, local: Fraction, order: int = 0) -> SineForm:
    """Return the derivative of this order of u at a time in a piece (s), exact."""
    return _value(force, force.start, local, order)


def signal_form(piece: ExactPiece, which: int, local: Fraction, order: int = 0) -> SineForm:
    """Return a derivative of a signal at a time in a piece (s), exact."""
    return _value(piece.signals[which], piece.start, local, order)


def _value(signal: Piece, start: Fraction, local: Fraction, order: int) -> SineForm:
    waves = (_wave(one, start + local, order) * one.omega**order for one in signal.sines)
    return sum(waves, SineForm(polynomial_at(signal.polynomial, local, order)))


def _wave(sine: Sine, t: Fraction, quarters: int) -> SineForm:
    """Return a sine at a time of the run (s), so many quarters of a turn ahead."""
    size = sine.amplitude * (-1 if quarters % 4 > 1 else 1)
    return SineForm.turned(sine.omega * t + sine.phase, *((0, size) if quarters % 2 else (size, 0)))


def exact_z(piece: ExactPiece, side: int, local: Fraction, state: Sequence[SineForm]) -> list[SineForm]:
    """Return z at a time in a piece (s), in a mode `side`."""
    t, signals, signs = piece.start + local, piece.signals, [1] * FRICTION + [side or 1]
    polynomials = (
        SineForm(polynomial_at(one.polynomial, local, k)) * sign
        for one, sign in zip(signals, signs, strict=True)
        for k in range(len(one.polynomial))
    )
    waves = (
        _wave(sine, t, quarters) * sign
        for one, sign in zip(signals, signs, strict=True)
        for sine in one.sines
        for quarters in (0, 1)
    )
    return [*state, *polynomials, *waves]


def applied(row: Row, z: Sequence[SineForm]) -> SineForm:
    """Return the value of a row."""
    return sum((z[place] * c for place, c in row), SineForm())


def derivatives(mode: LinearMode, local: Fraction, state: Sequence[SineForm]) -> Iterator[list[SineForm]]:
    """Yield the derivatives of z along a mode from a time in its piece (s), from z itself on, as many as decide all."""
    z, A = exact_z(mode.piece, mode.side, local, state), [sparse(row) for row in mode.generator()]
    for _ in range(mode.size + 1):
        yield z
        z = [applied(row, z) for row in A]


def mode_after(stick: LinearMode, local: Fraction, state: Sequence[SineForm]) -> tuple[int, int]:
    """Return the mode that follows a state with v1 = v2, and how many derivatives of its guard vanish (or MARGINAL)."""
    tied, pair = dict(zip((1, -1), stick.guards, strict=True)), stick.pair
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
