"""The flow of a mode, z' = A z, in balls and in numbers of mpmath: Taylor polynomials of rows, or exp(A t).

A row of z has the Taylor coefficients (row A^k/k!) z. The rows in front of z depend on masses, damping, spring,
frequencies and the degree of the polynomial only; so they are built once and serve every start, amplitude and phase.
What a polynomial leaves out is bounded by energy: with y the n-th derivative of x1, n >= 1,

    m y'' + a1 y' + a2 y = u^(n),    so that    sqrt(a2 y^2 + m y'^2) grows by int |u^(n)| dt/sqrt(m) at most.

Everything that takes many steps of that length is left to exp(A t), one sine at a time, since answers add up.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

import flint
import mpmath
from flint import arb, arb_mat, arb_poly
from numpy.polynomial import Polynomial

from numerics.arithmetic import multiprecision
from numerics.arithmetic.ball import Ball, widened
from numerics.linear.pieces import ExactPiece
from numerics.linear.system import FIRST, X1, X2, LinearMode, Row, W
from numerics.scene import Pair, Piece, Sine

REACH = 2
"""A Taylor polynomial is used while the fastest rate turns through so many radians."""
FEW = 14
"""The degree of the polynomials by which a guard is scanned."""
_EXTRA_BITS, _FINEST = 24, 1_100
"""Working bits beyond those asked for; intervals that are shorter by so many bits than a turn are not looked at."""


class BallNumbers:
    """What the engine needs of an arithmetic besides + - * /: flint balls."""

    def __init__(self, digits: int) -> None:
        """Work with so many decimal digits, and some bits more."""
        self.bits = math.ceil(digits * math.log2(10)) + _EXTRA_BITS
        self.number, self.sine_cosine, self.curve = Ball.number, arb.sin_cos, arb_poly
        self.middle, self.point, self.radius, self.within = arb.mid, arb.mid, arb.rad, widened

    def context(self, bits: int = 0) -> AbstractContextManager[Any]:
        """Set the working precision, or another one."""
        return flint.ctx.workprec(bits or self.bits)

    @staticmethod
    def products(rows: list[list[arb]]) -> Callable[[list[arb]], list[arb]]:
        """Return what multiplies a matrix by a vector."""
        matrix, columns = arb_mat(rows), len(rows[0])
        return lambda z: (matrix * arb_mat(columns, 1, z)).entries()

    def exponential(self, generator: list[list[Fraction]], t: arb, z: list[arb]) -> list[arb]:
        """Return exp(A t) z; long times are formed with more bits, since errors double with each squaring."""
        size = Ball.number(max(sum(map(abs, row)) for row in generator)) * t.abs_upper()
        squarings = max(0, math.ceil(float(size.mid().log().mid()) / math.log(2))) if size > 1 else 0
        with flint.ctx.workprec(self.bits + 3 * squarings + 16):
            flow = (arb_mat([[Ball.number(one) for one in row] for row in generator]) * t).exp()
        return (flow * arb_mat(len(z), 1, z)).entries()


class PointNumbers:
    """The same for numbers of mpmath, which have no radius."""

    def __init__(self, digits: int) -> None:
        """Work with so many decimal digits, and some bits more."""
        self.bits = math.ceil(digits * math.log2(10)) + _EXTRA_BITS
        self.number, self.sine_cosine = multiprecision.Multiprecision.number, multiprecision.sine_cosine
        self.curve = _Curve

    def context(self, bits: int = 0) -> AbstractContextManager[Any]:
        """Set the working precision, or another one."""
        return mpmath.workprec(bits or self.bits)

    def point(self, x: arb) -> Any:
        """Return the midpoint of a ball."""
        mantissa, exponent = x.mid().man_exp()
        return mpmath.ldexp(int(mantissa), int(exponent))

    def middle(self, x: Any) -> Any:
        """Return the number."""
        return x

    def radius(self, x: Any) -> arb:  # noqa: ARG002
        """Return 0."""
        return arb(0)

    def within(self, x: Any, by: arb) -> Any:  # noqa: ARG002
        """Return the number."""
        return x

    def products(self, rows: list[list[Any]]) -> Callable[[list[Any]], list[Any]]:
        """Return what multiplies a matrix by a vector."""
        return lambda z: [mpmath.fdot(row, z) for row in rows]

    def exponential(self, generator: list[list[Fraction]], t: Any, z: list[Any]) -> list[Any]:
        """Return exp(A t) z."""
        size = self.number(max(sum(map(abs, row)) for row in generator)) * t
        with mpmath.extraprec(16 + 3 * max(0, int(mpmath.mag(size)))):
            flow = mpmath.expm(mpmath.matrix([[self.number(one) for one in row] for row in generator]) * t)
        return [mpmath.fdot(flow[k, :], z) for k in range(len(z))]


Numbers = BallNumbers | PointNumbers


class _Curve(Polynomial):
    """A polynomial in numbers of mpmath."""

    def derivative(self) -> _Curve:
        """Return the derivative, by flint's name."""
        return self.deriv()


class Drive(NamedTuple):
    """A piece in numbers: b, its polynomial, and of each sine amplitude, omega and the phase where the piece begins."""

    b: Any
    polynomial: list[Any]
    sines: list[tuple[Any, Any, Any]]

    @classmethod
    def of(cls, numbers: Numbers, piece: ExactPiece) -> Drive:
        """Return a piece in numbers."""
        number = numbers.number
        sines = [(number(s.amplitude), number(s.omega), number(s.omega * piece.start + s.phase)) for s in piece.sines]
        return cls(number(piece.b), [number(c) for c in piece.polynomial], sines)

    def force(self, numbers: Numbers, local: Any, count: int) -> list[Any]:
        """Return the part of z that the force is: derivatives of its polynomial, and each sine beside its cosine."""
        parts, terms, zero = [], self.polynomial, 0 * local
        for order in range(count):
            value = zero
            for k in range(len(terms) - 1, order - 1, -1):
                value = value * local + terms[k] * math.perm(k, order)
            parts.append(value)
        for amplitude, omega, phase in self.sines:
            sine, cosine = numbers.sine_cosine(phase + omega * local)
            parts += [amplitude * sine, amplitude * cosine]
        return parts


class Flow:
    """The flow of stick, or of a slip, under polynomials of one degree and sines of given frequencies.

    z is that of LinearMode for b = 1 and side +1, so that the constant in it is side b (0 in stick). The guard is the
    row w = v1 - v2 in a slip, the load in stick; `few` gives its first Taylor coefficients, `x1` those of x1 and `x2`
    those of x2 in a slip, of x2 - x1 in stick, which is a polynomial.
    """

    def __init__(self, numbers: Numbers, pair: Pair, slips: bool, count: int, omegas: tuple[Fraction, ...]) -> None:
        """Build the tables."""
        self.numbers, self.pair, self.slips, self.count, self.omegas = numbers, pair, slips, count, omegas
        self.mode = self.mode_of(Piece(0, (1,) * count, [Sine(1, one) for one in omegas]))
        rows, number, mass = self.mode.generator(), Ball.number, self.mode.mass
        self.generator = [[(j, numbers.number(c)) for j, c in enumerate(row) if c] for row in rows]
        self.size, self.places = self.mode.size, list(self.mode.sine_places)
        self.mass, self.m2, self.root_stiff = number(mass), number(pair.m2), number(pair.a2 / mass).sqrt()
        self.heights: dict[tuple[int, int], list[arb]] = {}
        self.rate = self.rate_of(number(pair.a1 / mass) + self.root_stiff)
        self.fastest = self.rate
        for omega in omegas:
            self.fastest = self.fastest.max(number(omega))
        self.reach, self.tiny = (
            (REACH / self.fastest).lower(),
            (arb((1, -min(numbers.bits, _FINEST))) / self.fastest).mid(),
        )
        self.terms = max(_terms(numbers.bits + 8), FEW + 2)
        self.begin_rows()

    def mode_of(self, piece: Piece) -> LinearMode:
        """Return the mode in which the constant in z is the friction force."""
        return LinearMode(self.pair, Fraction(1), int(self.slips), piece)

    def rate_of(self, rate: arb) -> arb:
        """Return a bound on the mode's own rates from those of body 1 on its spring."""
        return rate

    def begin_rows(self) -> None:
        """Form the rows in front of z."""
        numbers, slips = self.numbers, self.slips
        apart: Row = ((X2, Fraction(1)),) if slips else ((X2, Fraction(1)), (X1, Fraction(-1)))
        self.x1, self.x2 = (numbers.products(self.powers(row, self.terms)) for row in (((X1, Fraction(1)),), apart))
        self._first = self.powers(W if slips else self.mode.load, FEW + 1)
        self.load = numbers.products(self._first[:2])
        """Of stick: the load and its rate."""
        self._few: dict[int, Callable[[list[arb]], list[arb]]] = {}

    def powers(self, row: Row, terms: int) -> list[list[Any]]:
        """Return row A^k/k! for so many k, as long as they do not vanish."""
        number, faded = self.numbers.number, 0.0
        at: dict[int, Any] = {place: number(factor) for place, factor in row}
        zero = number(0)
        found: list[list[Any]] = []
        while len(found) < terms and at:
            found.append([at.get(place, zero) for place in range(self.size)])
            after: dict[int, Any] = {}
            # what counts little within the reach needs few bits
            faded = max(0.0, faded + math.log2(len(found) / REACH))
            with self.numbers.context(max(64, self.numbers.bits + 16 - int(faded))):
                for i, one in at.items():
                    for j, c in self.generator[i]:
                        after[j] = after[j] + one * c if j in after else one * c
                at = {j: one / len(found) for j, one in after.items() if one != 0}
        return found

    def few(self, z: list[Any], bits: int) -> list[arb]:
        """Return the first coefficients of the guard, one more than the degree that a scan takes, to so many bits."""
        with flint.ctx.workprec(bits):
            if bits not in self._few:
                self._few[bits] = BallNumbers.products([[+arb(c) for c in row] for row in self._first])
            return self._few[bits]([+arb(c) for c in z])

    def rows(self, z: list[Any], bits: int) -> list[list[arb]]:
        """Return the coefficients of every row of which there are guards: here of one."""
        return [self.few(z, bits)]

    def rests(self, rows: Sequence[Sequence[arb]], z: list[Any], h: arb) -> list[arb]:
        """Return R of these rows from order FEW on, up to h."""
        return [self.guard_rest(rows[0], FEW, z, h)]

    def expansion(self, z: list[Any]) -> Expansion:
        """Return the motion from z on."""
        return Expansion(self, z)

    def rest(self, last: Sequence[Any], order: int, pushed: arb) -> arb:
        """Return R: a Taylor polynomial without its terms from t^order on is off by R t^order at most.

        `last` are the coefficients of t^(order-1) and t^order; `pushed` is what the force adds to that of t^order.
        """
        return (self.root_stiff * abs(arb(last[0])) / order + abs(arb(last[1])) + pushed).upper()

    def pushed(self, z: Sequence[Any], order: int, more: int, h: arb) -> arb:
        """Return h/(m order!) times a bound on |u^(order + more)| from z on for a time h."""
        derivative, total = order + more, arb(0)
        for later in range(self.count - derivative):
            total += abs(arb(z[FIRST + derivative + later])) * h**later / math.factorial(later)
        if derivative < self.count:
            total = total / (self.mass * math.factorial(order))
        if self.places:
            key = order, more
            if key not in self.heights:
                below = self.mass * math.factorial(order)
                self.heights[key] = [Ball.number(omega) ** derivative / below for omega in self.omegas]
            for place, height in zip(self.places, self.heights[key], strict=True):
                total += (abs(arb(z[place])) + abs(arb(z[place + 1]))) * height
        return h * total

    def guard_rest(self, row: Sequence[Any], order: int, z: Sequence[Any], h: arb) -> arb:
        """Return R of the guard: the equation of w has u' for u, that of the load m2 u''."""
        pushed = self.pushed(z, order, 0, h) if self.slips else self.pushed(z, order, 1, h) * self.m2
        return self.rest(row[order - 1 : order + 1], order, pushed)


class Expansion:
    """The motion from a point on as Taylor polynomials: x1 is `x`, x2 is `y`; `v` and `w` are their derivatives."""

    def __init__(self, flow: Flow, z: list[Any]) -> None:
        """Form the polynomials."""
        one, curve = flow.x1(z), flow.numbers.curve
        self.flow, self.z, self.last, self.order = flow, z, one[-2:], len(one) - 1
        self.x, self.y = curve(one[:-1]), curve(flow.x2(z))
        if not flow.slips:
            self.y = self.x + self.y
        self.v, self.w = self.x.derivative(), self.y.derivative()

    def row(self, _: int) -> Any:
        """Return a guard's row: v1 - v2 in a slip, m2 v2' in stick."""
        if self.flow.slips:
            return self.v + self.w * -1
        return self.w.derivative() * self.flow.numbers.number(self.flow.pair.m2)

    def row_off(self, _: int, h: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of a row leaves out up to h."""
        if self.flow.slips:
            return self.left_out(h, 1 + derivative)
        return self.flow.m2 * self.left_out(h, 2 + derivative)

    def rest(self, h: arb) -> arb:
        """Return R of x up to h (Flow.rest)."""
        return self.flow.rest(self.last, self.order, self.flow.pushed(self.z, self.order, -1, h))

    def left_out(self, h: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of x leaves out up to h."""
        return (self.rest(h) * math.perm(self.order, derivative) * h ** (self.order - derivative)).upper()

    def state(self, t: Any) -> list[Any]:
        """Return the state at a time after the point."""
        within, h = self.flow.numbers.within, arb(t).abs_upper()
        speed_off = self.rest(h) * h ** (self.order - 1)
        off = speed_off * h
        x, v, y, w = within(self.x(t), off), within(self.v(t), speed_off * self.order), self.y(t), self.w(t)
        return [x, v, y, w] if self.flow.slips else [x, v, within(y, off), v]

    def bends(self, t: arb) -> list[arb]:
        """Return bounds on |v1'| and |v2'| over a ball of times."""
        off = self.left_out(t.upper(), 2)
        one = self.v.derivative()(t).abs_upper() + off
        return [one, self.w.derivative()(t).abs_upper() if self.flow.slips else one]


@lru_cache(maxsize=64)
def numbers_of(name: str, digits: int) -> Numbers:
    """Return balls, or numbers of mpmath, with so many digits."""
    return BallNumbers(digits) if name == "ball" else PointNumbers(digits)


@lru_cache(maxsize=64)
def flow_of(numbers: Numbers, pair: Pair, slips: bool, count: int, omegas: tuple[Fraction, ...]) -> Flow:
    """Return a flow, built once."""
    return Flow(numbers, pair, slips, count, omegas)


def _terms(bits: int) -> int:
    """Return how many terms leave less than 2^-bits of exp(REACH)."""
    terms, size = 1, 0.0
    while size < bits:
        terms += 1
        size += math.log2(terms / REACH)
    return terms
