"""The pieces of force and friction of a scene as one sequence, exact; and as the flat table that a run reads."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import accumulate
from typing import Any, overload

from numerics.arithmetic.protocol import Arithmetic
from numerics.flows.forced_records import HEAD, SINE, Drive
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


class ExactPieces(Sequence[ExactPiece]):
    """The pieces of a run in order. A whole piece may be cut in parts by seams; parts are made when they are asked for.

    Parts turn their fastest sine a few times; their lengths are a power of 2, exact in binary, but for the last one.
    """

    def __init__(self, wholes: list[ExactPiece], *, with_seams: bool) -> None:
        """Cut what is long, if seams are wanted."""
        self.wholes = wholes
        self.parts = [_part_of(whole) if with_seams else whole.length for whole in wholes]
        # the last part takes what is left, up to two parts
        counts = [max(1, -(-w.length // part) - 1) for w, part in zip(wholes, self.parts, strict=True)]
        self.firsts = [0, *accumulate(counts)]

    def __len__(self) -> int:
        """Return how many parts there are."""
        return self.firsts[-1]

    @overload
    def __getitem__(self, index: int) -> ExactPiece: ...

    @overload
    def __getitem__(self, index: slice) -> list[ExactPiece]: ...

    def __getitem__(self, index: int | slice) -> ExactPiece | list[ExactPiece]:
        """Return a part."""
        if isinstance(index, slice):
            return [self[k] for k in range(*index.indices(len(self)))]
        index = index if index >= 0 else len(self) + index
        if not 0 <= index < len(self):
            raise IndexError(index)
        at = bisect_right(self.firsts, index) - 1
        whole, part, k = self.wholes[at], self.parts[at], index - self.firsts[at]
        if self.count(at) == 1:
            return whole
        start, is_last = whole.start + k * part, k + 1 == self.count(at)
        length = whole.length - k * part if is_last else part
        moved = Piece(whole.start, whole.polynomial).moved(start).polynomial if k and whole.polynomial else None
        polynomial = whole.polynomial if moved is None else moved
        return ExactPiece(start, length, whole.b, polynomial, whole.sines, whole.is_jump and k == 0)

    def count(self, at: int) -> int:
        """Return in how many parts a whole piece is cut."""
        return self.firsts[at + 1] - self.firsts[at]

    def starts_of(self, at: int) -> list[float]:
        """Return when the parts of a whole piece begin, s, each the nearest binary64 number."""
        start, part = self.wholes[at].start, self.parts[at]
        below = math.lcm(start.denominator, part.denominator)
        first, step = int(start * below), int(part * below)
        return [(first + k * step) / below for k in range(self.count(at))]

    def float_starts(self) -> list[float]:
        """Return when all parts begin, s, each the nearest binary64 number."""
        return [start for at in range(len(self.wholes)) for start in self.starts_of(at)]


def pieces_of(scene: Scene, *, with_seams: bool = False) -> ExactPieces:
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
    return ExactPieces(found, with_seams=with_seams)


def _part_of(whole: ExactPiece) -> Fraction:
    """Return how long the parts of a piece are: its own length, or a few turns of its fastest sine."""
    fastest = max((one.omega for one in whole.sines), default=Fraction(0))
    if not 2 * _RADIANS < fastest * whole.length < _RADIANS * _MOST_SEAMS:
        return whole.length
    return Fraction(2) ** (math.frexp(float(_RADIANS / fastest))[1] - 1)


def particular(polynomial: tuple[Fraction, ...], mass: Fraction, a1: Fraction, a2: Fraction) -> list[Fraction]:
    """Return the polynomial x with mass x'' + a1 x' + a2 x = polynomial."""
    found = [Fraction(0)] * len(polynomial)
    for k in reversed(range(len(polynomial))):
        after = found[k + 1] if k + 1 < len(found) else 0
        later = found[k + 2] if k + 2 < len(found) else 0
        found[k] = (polynomial[k] - a1 * (k + 1) * after - mass * (k + 1) * (k + 2) * later) / a2
    return found


def drive_of(scene: Scene, pieces: ExactPieces, arithmetic: Arithmetic) -> Drive:
    """Return the table of the pieces in numbers of an arithmetic, each narrowed once from what is exact."""
    numbers: list[Any] = []
    places: list[tuple[int, int, int, int]] = []
    reduce = arithmetic.name in {"float64", "double-double"}
    for at, whole in enumerate(pieces.wholes):
        first, count, sines = pieces.firsts[at], pieces.count(at), _sines_of(scene, whole, arithmetic)
        if arithmetic.name == "float64" and count > 1 and len(whole.polynomial) < 2:
            rows = _parts_of_sines(pieces, at, _row(scene, pieces[first], arithmetic, sines, reduce=reduce))
        else:
            parts = (pieces[first + k] for k in range(count))
            rows = (_row(scene, one, arithmetic, sines, reduce=reduce) for one in parts)
        for k, row in enumerate(rows):
            is_jump = whole.is_jump and k == 0
            places.append((len(numbers), len(whole.polynomial), len(whole.sines), int(is_jump)))
            numbers += row
    return Drive(numbers, places)


def _sines_of(scene: Scene, whole: ExactPiece, arithmetic: Arithmetic) -> list[tuple[list[Any], list[Any]]]:
    """Return the numbers of each sine that stand before its phase and after it."""
    pair, number, found = scene.pair, arithmetic.number, []
    for sine in whole.sines:
        after: list[Any] = []
        for m in (pair.m1, pair.mass):
            square = (4 * pair.a2 * m - pair.a1**2) / (4 * m * m)
            after += [number(square - sine.omega**2), number(pair.a2 - m * sine.omega**2)]
        found.append(([number(sine.amplitude), number(sine.omega)], after))
    return found


def _row(
    scene: Scene, piece: ExactPiece, arithmetic: Arithmetic, sines: list[tuple[list[Any], list[Any]]], *, reduce: bool
) -> list[Any]:
    """Return the numbers of one part (flows/forced_records.py)."""
    pair, number = scene.pair, arithmetic.number
    row = [number(piece.start), number(piece.length), number(piece.b), *map(number, piece.polynomial)]
    for m in (pair.m1, pair.mass):
        row += map(number, particular(piece.polynomial, m, pair.a1, pair.a2))
    for sine, (before, after) in zip(piece.sines, sines, strict=True):
        phase = sine.omega * piece.start + sine.phase
        row += [*before, number(_reduced(phase) if reduce else phase), *after]
    return row


def _parts_of_sines(pieces: ExactPieces, at: int, first: list[float]) -> Iterator[list[float]]:
    """Yield the rows of all parts of a piece in binary64, where only start, length and phases change.

    Phases go on in whole numbers of 2^-320 rad, so that each is narrowed once.
    """
    whole, part, count = pieces.wholes[at], pieces.parts[at], pieces.count(at)
    turn, unit = int(_turn(320) * 2**320), 1 << 320
    phases = [int(_reduced(sine.omega * whole.start + sine.phase) * unit) for sine in whole.sines]
    steps = [int(_reduced(sine.omega * part) * unit) for sine in whole.sines]
    places = [HEAD + 3 * len(whole.polynomial) + SINE * k + 2 for k in range(len(phases))]
    yield first
    for k, start in enumerate(pieces.starts_of(at)):
        if k == 0:
            continue
        row = first.copy()
        row[0] = start
        for n, place in enumerate(places):
            phase = phases[n] + steps[n]
            phase -= turn if 2 * phase > turn else -turn if 2 * phase < -turn else 0
            phases[n], row[place] = phase, phase / unit
        if k + 1 == count:
            row[1] = float(whole.length - k * part)
        yield row


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
    size = round(abs(phase)).bit_length()
    turn = _turn(256 * (2 + size // 256))
    return phase - round(phase / turn) * turn
