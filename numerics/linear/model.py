"""Mechanics as matrices: behind this file nothing knows a mass, a spring or a friction force.

On a piece of its signals a scene is z' = A z in each of its modes, z = (x1, v1, x2, v2, blocks), where a signal's block
is its polynomial with all derivatives and, of each of its sines, amplitude times sine and cosine of the phase. With

    U = u - a2 (x1 - y) - a1 (v1 - y')    force u on body 1, displacement y of the wall
    f, c, b                               force on body 2, velocity of the belt, friction

the modes and their guards, rows of z that are positive in the mode, are

    slip s    m1 v1' = U - s b,  m2 v2' = f + s b     s (v1 - v2), behind it a contact
    stick     v1' = v2' = (U + f)/M                   b_static - s Lambda, behind it slip s (s = +1, -1)

Lambda = (m2 U - m1 f)/M is the load, the friction force on body 2 that sticking needs; where v1 = v2, stick follows if
|Lambda| < b_static, else the slip of its sign. If m2 is infinite v2' = c' in both, v1' = c' in stick, and
Lambda = U - m1 c'. One slip serves both signs: in a slip s the block of b is multiplied by s.

Two motions under the same signals do not part in N, N^2 = a2 x1^2 + m1 v1^2 + m2 v2^2 of their difference.
"""

from __future__ import annotations

import math
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from flint import fmpq

from numerics.scene import Pair

X1, V1, X2, V2, FIRST = range(5)
SLIP, STICK = 0, 1
FORCE, FORCE_2, BELT, WALL, FRICTION = range(5)
"""The signals, in the order of their blocks."""
FLOOR, CEILING, AHEAD = range(3)
"""The guards of a slip in a cell of friction (cells.py): |v1 - v2| falls to where the cell begins, or v1 = v2, or rises
to where it ends; x1 - x2, which only rises in a slip + and only falls in a slip -, gets to the end that is ahead."""
LOAD, EDGE, KINETIC, DRIVEN = range(4)
"""Rows that are no guard: Lambda, b_static, b, and the velocity of an infinite body 2."""


class Bodies(NamedTuple):
    """The numbers of a pair, exact, in floats or as power series; 1/m2 and 1/M are 0, m2/M is 1 for an infinite m2."""

    m1: Any
    a1: Any
    a2: Any
    inverse_1: Any
    inverse_2: Any
    inverse_both: Any
    share_1: Any
    """m1/M"""
    share_2: Any
    """m2/M"""
    static: Any
    """b_static/b"""

    @classmethod
    def of(cls, pair: Pair) -> Bodies:
        """Return the exact numbers of a pair."""
        static = 1 if pair.b_static is None else pair.b_static / pair.b
        if pair.m2 == math.inf:
            return cls(pair.m1, pair.a1, pair.a2, 1 / pair.m1, 0, 0, 0, 1, static)
        mass = pair.mass
        shares = pair.m1 / mass, pair.m2 / mass
        return cls(pair.m1, pair.a1, pair.a2, 1 / pair.m1, 1 / pair.m2, 1 / mass, *shares, static)


class Norm(NamedTuple):
    """What N of an error says of rows, floats or arrays of them: |row| <= number N."""

    root_a2: Any
    root_m1: Any
    root_m2: Any
    """0 for an infinite m2"""
    kappa: Any
    """of v1 - v2"""
    bend: Any
    """of v1' in one mode"""
    load: Any
    """of Lambda in stick"""
    steep: Any
    """the most of a slope of friction in any cell, times kappa^2"""
    pull: Any
    """the most of its pull, times kappa"""


def norm_of(bodies: Bodies) -> Norm:
    """Return the numbers of the norm where friction is constant, rounded upwards; of floats or arrays of them."""
    slack, root_m1, is_finite = 1.0 + 1e-12, np.sqrt(bodies.m1), bodies.inverse_2 > 0.0
    root_m2 = np.where(is_finite, np.sqrt(1.0 / np.where(is_finite, bodies.inverse_2, 1.0)), 0.0)
    pull = np.hypot(np.sqrt(bodies.a2), bodies.a1 / root_m1)
    kappa = np.sqrt(bodies.inverse_1 + bodies.inverse_2)
    bounds = kappa * slack, pull * bodies.inverse_1 * slack, bodies.share_2 * pull * slack
    return Norm(np.sqrt(bodies.a2), root_m1, root_m2, *bounds, 0.0 * kappa, 0.0 * kappa)


class Layout(NamedTuple):
    """Of each signal, in this order: the number of its coefficients and the frequencies of its sines (rad/s)."""

    terms: tuple[int, ...]
    omegas: tuple[tuple[Any, ...], ...]

    @property
    def size(self) -> int:
        """Return the number of components of z."""
        return FIRST + sum(self.terms) + 2 * sum(map(len, self.omegas))

    @property
    def blocks(self) -> np.ndarray[Any, np.dtype[np.int64]]:
        """Return (5, 4): where the polynomial of a signal begins, its coefficients, where its sines do, how many.

        All polynomials come first.
        """
        return _blocks(self.terms, tuple(map(len, self.omegas)))


@lru_cache(maxsize=256)
def _blocks(terms: tuple[int, ...], waves: tuple[int, ...]) -> np.ndarray[Any, np.dtype[np.int64]]:
    first = FIRST + np.cumsum([0, *terms[:-1]])
    sines = FIRST + sum(terms) + 2 * np.cumsum([0, *waves[:-1]])
    return np.array([first, terms, sines, waves], dtype=np.int64).T.copy()


class ModeRows(NamedTuple):
    """A scene's matrices on one kind of piece, exact or in floats; of a slip those of slip +."""

    A: Any
    """(2, n, n), of slip and stick"""
    guards: Any
    """(2, 2, n): v1 - v2 alone in slip; b_static - Lambda and b_static + Lambda in stick"""
    others: Any
    """(4, n): LOAD, EDGE, KINETIC, DRIVEN"""
    powers: Any
    """(2, 6, 2, n), of slip and stick: powers as products of two rows, in the order of TAKEN"""


TAKEN = ("friction", "viscous", "force", "force_2", "belt", "wall")
"""What friction and damper take, and what forces, belt and wall give (W); E' is the sum of these less that of those."""


def make_rows(n: int) -> ModeRows:
    """Return room for the matrices of n components, in floats."""
    return ModeRows(np.zeros((2, n, n)), np.zeros((2, 2, n)), np.zeros((4, n)), np.zeros((2, 6, 2, n)))


def add_signal(row: Any, block: Any, factor: Any) -> None:
    """Add a multiple of a signal to a row."""
    if block[1] > 0:
        row[block[0]] += factor
    for k in range(block[3]):
        row[block[2] + 2 * k] += factor


def put_rows(bodies: Bodies, blocks: Any, omegas: Any, cell: tuple[Any, ...], rows: ModeRows) -> None:
    """Write the matrices of a pair, in the numbers of `bodies`; omegas (n,): that of a sine stands at its cosine.

    Several pairs of one layout may stand along a last axis of all these.

    `cell`: slope (N s/m), pull (N/m) and level of friction, level b + slope (v1 - v2) + pull (x1 - x2) in a slip +.
    """
    (A, guards, others, powers), (slope, pull, level) = rows, cell
    signals, state = 0 * powers[:, :5, 0], 0 * others
    put_signals(blocks, omegas, A, signals)
    for k in range(FIRST):
        state[k, k] += 1
    (x1, v1, x2, v2), (u, f, c, y, b) = state, signals[0]
    belt_rate, wall_rate = signals[1, BELT], signals[1, WALL]
    w, stretching, apart = v1 - v2, v1 - wall_rate, (x1 - x2) * pull
    spring = (y - x1) * bodies.a2 - stretching * bodies.a1
    push = spring + u
    load = push * bodies.share_2 - f * bodies.share_1 - belt_rate * bodies.m1
    edge, kinetic = b * level * bodies.static + apart, b * level + w * slope + apart
    A[:, X1] += v1
    A[:, X2] += v2
    A[SLIP, V1] += (push - kinetic) * bodies.inverse_1
    A[SLIP, V2] += (f + kinetic) * bodies.inverse_2 + belt_rate
    A[STICK, V1] += (push + f) * bodies.inverse_both + belt_rate
    A[STICK, V2] += A[STICK, V1]
    guards[SLIP, 0], guards[STICK], others[:] = w, (edge - load, edge + load), (load, edge, kinetic, c)
    powers[SLIP, 0] = kinetic, w
    for mode, held in ((SLIP, kinetic), (STICK, load)):
        powers[mode, 1:] = (stretching * bodies.a1, stretching), (u, v1), (f, v2), (-held, c), (spring, wall_rate)


def put_signals(blocks: Any, omegas: Any, A: Any, signals: Any) -> None:
    """Write how polynomials and sines go on, and the rows of each signal and of its derivative."""
    for signal in range(blocks.shape[0]):
        first, terms, sines, waves = blocks[signal]
        add_signal(signals[0, signal], blocks[signal], 1)
        if terms > 1:
            signals[1, signal, first + 1] += 1
        for place in range(sines + 1, sines + 2 * waves, 2):
            signals[1, signal, place] += omegas[place]
            for mode in range(2):
                A[mode, place - 1, place] += omegas[place]
                A[mode, place, place - 1] -= omegas[place]
        for k in range(first, first + terms - 1):
            A[SLIP, k, k + 1] += 1
            A[STICK, k, k + 1] += 1


class Cell(NamedTuple):
    """Friction of a slip s is s level b(t) + slope w + pull z, N (put_rows)."""

    slope: Any
    pull: Any
    level: Any


CONSTANT = Cell(Fraction(0), Fraction(0), Fraction(1))


@lru_cache(maxsize=256)
def exact_rows(pair: Pair, layout: Layout, cell: Cell = CONSTANT) -> ModeRows:
    """Return the exact matrices of a pair, arrays of Fraction and 0; `cell` as in `put_rows`."""
    rows = ModeRows(*(np.full(one.shape, fmpq(0)) for one in make_rows(layout.size)))
    bodies, omegas = Bodies(*map(_ratio, Bodies.of(pair))), np.array([*map(_ratio, spread_omegas(layout))])
    put_rows(bodies, layout.blocks, omegas, tuple(map(_ratio, cell)), rows)
    return ModeRows(*map(_fractions, rows))


_fractions = np.frompyfunc(lambda x: Fraction(int(x.p), int(x.q)) if x else 0, 1, 1)


def _ratio(x: Fraction) -> fmpq:
    """Return a number in which exact matrices are formed: FLINT's are ten times faster."""
    return fmpq(x.numerator, x.denominator)


def spread_omegas(layout: Layout) -> np.ndarray[Any, Any]:
    """Return (n,): the frequency of each sine at the place of its cosine, 0 elsewhere."""
    found = np.full(layout.size, Fraction(0))
    for (_, _, first, _), omegas in zip(layout.blocks, layout.omegas, strict=True):
        for k, omega in enumerate(omegas):
            found[first + 2 * k + 1] = omega
    return found
