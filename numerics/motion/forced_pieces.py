"""The pieces of force and friction of a scene as one sequence, exact; and as the flat table that a run reads."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

from numerics.arithmetic.protocol import Arithmetic
from numerics.flows.forced_records import Drive
from numerics.scene import Piece, Scene, Sine

_RADIANS = 8
"""A piece of binary64 numbers turns through so many radians or so: longer ones get seams, and phases stay sharp."""
_MOST_SEAMS = 20_000
"""A piece that would get more has none: its phases are as sharp as binary64 has them, and the bounds say so."""


def has_seams(arithmetic: Arithmetic) -> bool:
    """Return whether long pieces are cut for an arithmetic: for binary64, and for balls that are rounded to it."""
    return bool(getattr(arithmetic, "seams", arithmetic.name == "float64"))


@dataclass(frozen=True, slots=True)
class ExactPiece:
    """u and b from `start` for `length` s: u = sum_k polynomial[k] (t - start)^k + sines; may u or b jump there?"""

    start: Fraction
    length: Fraction
    b: Fraction
    polynomial: tuple[Fraction, ...]
    sines: tuple[Sine, ...]
    is_jump: bool


def pieces_of(scene: Scene, *, with_seams: bool = False) -> list[ExactPiece]:
    """Return the pieces up to the horizon, in order; each has one polynomial, its sines and one b."""
    force, friction, until = scene.force, scene.friction, scene.until
    starts = sorted({Fraction(0), *(t for t in (*force.starts, *friction.starts) if t < until)})
    found, b, own, forces, frictions = [], scene.pair.b, 0, force.pieces, friction.pieces
    piece, at = None, 0
    for start, end in zip(starts, [*starts[1:], until], strict=True):
        while own < len(frictions) and frictions[own][0] <= start:
            b, own = frictions[own][1], own + 1
        while at < len(forces) and forces[at].start <= start:
            piece, at = forces[at], at + 1
        here = None if piece is None else piece if piece.start == start else piece.moved(start)
        polynomial, sines = ((), ()) if here is None else (here.polynomial, here.sines)
        found.append(ExactPiece(start, end - start, b, polynomial, sines, True))
    return [one for whole in found for one in _cut(whole)] if with_seams else found


def _cut(whole: ExactPiece) -> Iterator[ExactPiece]:
    """Yield a piece in parts of a few turns of its fastest sine; their lengths are powers of 2, exact in binary."""
    fastest = max((one.omega for one in whole.sines), default=Fraction(0))
    if not 2 * _RADIANS < fastest * whole.length < _RADIANS * _MOST_SEAMS:
        yield whole
        return
    part = Fraction(2) ** (math.frexp(float(_RADIANS / fastest))[1] - 1)
    start, left = whole.start, whole.length
    while left > 0:
        length = part if left > 2 * part else left
        moved = Piece(whole.start, whole.polynomial).moved(start).polynomial if whole.polynomial else ()
        yield ExactPiece(start, length, whole.b, moved, whole.sines, whole.is_jump and start == whole.start)
        start, left = start + length, left - length


def particular(polynomial: tuple[Fraction, ...], mass: Fraction, a1: Fraction, a2: Fraction) -> list[Fraction]:
    """Return the polynomial x with mass x'' + a1 x' + a2 x = polynomial."""
    found = [Fraction(0)] * len(polynomial)
    for k in reversed(range(len(polynomial))):
        after = found[k + 1] if k + 1 < len(found) else 0
        later = found[k + 2] if k + 2 < len(found) else 0
        found[k] = (polynomial[k] - a1 * (k + 1) * after - mass * (k + 1) * (k + 2) * later) / a2
    return found


def drive_of(scene: Scene, pieces: list[ExactPiece], arithmetic: Arithmetic) -> Drive:
    """Return the table of the pieces in numbers of an arithmetic, each narrowed once from what is exact."""
    pair, number = scene.pair, arithmetic.number
    numbers: list[Any] = []
    places: list[tuple[int, int, int, int]] = []
    known: dict[int, tuple[list[Any], list[Any]]] = {}
    masses, reduce = (pair.m1, pair.mass), arithmetic.name in {"float64", "double-double"}
    square = [(4 * pair.a2 * m - pair.a1**2) / (4 * m * m) for m in masses]
    for piece in pieces:
        places.append((len(numbers), len(piece.polynomial), len(piece.sines), int(piece.is_jump)))
        numbers += [number(piece.start), number(piece.length), number(piece.b), *map(number, piece.polynomial)]
        for m in masses:
            numbers += map(number, particular(piece.polynomial, m, pair.a1, pair.a2))
        for sine in piece.sines:
            phase = sine.omega * piece.start + sine.phase
            if id(sine) not in known:  # all parts of a piece have the same ones
                known[id(sine)] = [number(sine.amplitude), number(sine.omega)], []
                for m, frequency in zip(masses, square, strict=True):
                    known[id(sine)][1].extend((number(frequency - sine.omega**2), number(pair.a2 - m * sine.omega**2)))
            before, after = known[id(sine)]
            numbers += [*before, number(_reduced(phase) if reduce else phase), *after]
    return Drive(numbers, places)


@cache
def _turn(bits: int) -> Fraction:
    """Return 2 pi to so many bits behind the point, by Machin's formula in whole numbers."""
    one = 1 << (bits + 16)

    def arctangent(n: int) -> int:
        power = total = one // n
        k, sign = 1, 1
        while power:
            power //= n * n
            k, sign = k + 2, -sign
            total += sign * (power // k)
        return total

    return Fraction(8 * (4 * arctangent(5) - arctangent(239)), one)


def _reduced(phase: Fraction) -> Fraction:
    """Return a phase less whole turns, in (-pi, pi], as far as 200 bits go; 0 exactly for 0."""
    if abs(phase) < 4:
        return phase
    size = max(0, phase.numerator.bit_length() - phase.denominator.bit_length())
    turn = _turn(256 * (2 + size // 256))
    return phase - round(phase / turn) * turn
