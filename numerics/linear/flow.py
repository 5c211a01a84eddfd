"""The flow of a mode, z' = A z, in balls and in numbers of mpmath: Taylor polynomials of rows, or exp(A t).

A row of z has the Taylor coefficients (row A^k/k!) z. The rows in front of z depend on masses, damping, spring,
frequencies and the degree of the polynomial only; so they are built once and serve every start, amplitude and phase.
What a polynomial leaves out is bounded by N of a derivative of the state (LocalNorm), with m the mass on the spring:

    N(y) <= exp(mu h) (N(y(0)) + h |u^(n)|/sqrt(m))    up to h,    y the n-th derivative, n >= 1,

and |v1| <= N/sqrt(m). Where friction is one number b, body 2 adds a polynomial only and |w| is <= N/sqrt(m), too; where
it depends on the state |w| <= kappa N, kappa^2 = M/(m1 m2).

Everything that takes many steps of that length is left to exp(A t), one sine at a time, since answers add up.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from fractions import Fraction
from functools import lru_cache
from itertools import islice, zip_longest
from typing import Any, NamedTuple

import flint
import mpmath
from flint import arb, arb_mat, arb_poly
from numpy.polynomial import Polynomial

from numerics.arithmetic import multiprecision
from numerics.arithmetic.ball import Ball, widened
from numerics.linear.pieces import ExactPiece
from numerics.linear.system import FIRST, ONE, X1, X2, LinearMode, LocalNorm
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
    """The flow of stick, or of a slip in one cell of friction, under polynomials of one degree and given frequencies.

    z is that of LinearMode for side b = 1, so that the constant in it is side b (0 in stick). `coupling` is slope and
    pull of friction that depends on the state, empty where it is one number b. Rows of which there are guards are the
    load in stick, w = v1 - v2 in a slip, and where it is coupled x1 - x2 and F besides.
    """

    def __init__(
        self,
        numbers: Numbers,
        pair: Pair,
        slips: bool,
        count: int,
        omegas: tuple[Fraction, ...],
        coupling: tuple[Fraction, ...] = (),
    ) -> None:
        """Build the tables."""
        self.numbers, self.pair, self.slips, self.count, self.omegas = numbers, pair, slips, count, omegas
        self.coupling, number = coupling, Ball.number
        piece = Piece(0, (1,) * count, [Sine(1, one) for one in omegas])
        self.mode = LinearMode(pair, Fraction(1), int(slips), piece, *coupling)
        self.norm = LocalNorm(self.mode)
        self.generator = [[(j, numbers.number(c)) for j, c in enumerate(row) if c] for row in self.mode.generator()]
        self.size, self.places = self.mode.size, list(self.mode.sine_places)
        self.m2, self.root_stiff = number(pair.m2), number(pair.a2 / self.mode.mass).sqrt()
        self.rate = self.fastest = self.norm.rate
        self.turns = [number(one) for one in omegas]
        for omega in self.turns:
            self.fastest = self.fastest.max(omega)
        self.reach, self.tiny = (
            (REACH / self.fastest).lower(),
            (arb((1, -min(numbers.bits, _FINEST))) / self.fastest).mid(),
        )
        self.expand(max(_terms(numbers.bits + 8), FEW + 3))

    def expand(self, terms: int) -> None:
        """Form so many rows in front of z for x1 and x2."""
        places = (X1, X2) if self.slips else (X1,)
        self.own = [self.powers(place, terms) for place in places]
        self.all_terms = [self.numbers.products(one) for one in self.own]
        self._few_terms, self._guards = self.numbers.products(self.own[0][:4]), self.guard_rows()
        self._products: dict[int, Callable[[list[arb]], list[arb]]] = {}
        self._ends: dict[int, Callable[[list[arb]], list[arb]]] = {}

    def powers(self, place: int, terms: int) -> list[list[Any]]:
        """Return the rows of A^k/k! at a place for so many k, as long as they do not vanish."""
        number, faded = self.numbers.number, 0.0
        at: dict[int, Any] = {place: number(1)}
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
                # a ball that holds 0 and more is neither equal nor unequal to 0
                at = {j: one / len(found) for j, one in after.items() if not one == 0}  # noqa: SIM201
        return found

    def load(self, z: list[Any]) -> list[Any]:
        """Return the load and its rate, in stick."""
        x, m2 = self._few_terms(z), self.numbers.number(self.pair.m2)
        return [2 * m2 * x[2], 6 * m2 * x[3]]

    def guard_rows(self) -> list[list[list[arb]]]:
        """Return what stands in front of z in the first coefficients of every row of which there are guards."""
        one, *two = ([[arb(c) for c in row] for row in own[: FEW + 3]] for own in self.own)
        if not self.slips:
            return [[[self.m2 * (k * (k - 1)) * c for c in row] for k, row in enumerate(one)][2:]]
        both = zip_longest(one, *two, fillvalue=[arb(0)] * self.size)
        place = [[a - b for a, b in zip(*rows, strict=True)] for rows in both]
        speed = [[k * c for c in row] for k, row in enumerate(place)][1:]
        if not self.coupling:
            return [speed]
        slope, pull = map(Ball.number, self.coupling)
        force = [
            [slope * w + pull * apart for w, apart in zip(*rows, strict=True)]
            for rows in zip(speed, place, strict=False)
        ]
        force[0][ONE] += 1
        return [speed, place, force]

    def rows(self, z: Sequence[Any], bits: int) -> list[list[arb]]:
        """Return the first coefficients of every row of which there are guards, to so many bits."""
        with flint.ctx.workprec(bits):
            if bits not in self._products:
                self._products[bits] = BallNumbers.products(
                    [[+c for c in row] for rows in self._guards for row in rows]
                )
            found = iter(self._products[bits]([+arb(c) for c in z]))
            return [list(islice(found, len(rows))) for rows in self._guards]

    def rests(self, z: Sequence[Any], h: arb, order: int = FEW) -> list[arb]:
        """Return R of every row of which there are guards: without its terms from t^order on it is off by R t^order."""
        whole = math.factorial(order)
        return self.of_rows(lambda k: self.reached(order + k - 1, z, h) / whole)

    def of_rows(self, bound: Callable[[int], arb]) -> list[arb]:
        """Return bounds on these rows from those on the k-th derivative of places, which are multiples of N."""
        if not self.slips:
            return [self.m2 * self.norm.speeds[0] * bound(2)]
        speed = self.norm.apart * bound(1)
        if not self.coupling:
            return [speed]
        place, (slope, pull) = self.norm.apart * bound(0), map(Ball.number, self.coupling)
        return [speed, place, abs(slope) * speed + abs(pull) * place]

    def reached(self, order: int, z: Sequence[Any], h: arb) -> arb:
        """Return a bound on N of the order-th derivative of the state, order >= 1, up to h."""
        if order not in self._ends:
            none = [arb(0)] * self.size
            ends = ([*own[order : order + 2], none, none][:2] for own in (self.own[0], self.own[-1]))
            self._ends[order] = BallNumbers.products([[arb(c) for c in row] for pair in ends for row in pair])
        a, c, b, d = self._ends[order]([arb(one) for one in z])
        norm = self.norm.of((a, (order + 1) * c, b, (order + 1) * d)) * math.factorial(order)
        return self.norm.grown(h, norm, self.pushed(z, order, h))

    def pushed(self, z: Sequence[Any], order: int, h: arb) -> arb:
        """Return a bound on |u^(order)| from z on for a time h."""
        total, places = arb(0), range(FIRST + order, FIRST + self.count)
        for later, place in enumerate(places):
            total += abs(arb(z[place])) * h**later / math.factorial(later)
        for place, omega in zip(self.places, self.turns, strict=True):
            total += (abs(arb(z[place])) + abs(arb(z[place + 1]))) * omega**order
        return total


class Expansion:
    """The motion from a point on up to h as Taylor polynomials: x1 is `x`, x2 `y`, their derivatives `v` and `w`."""

    def __init__(self, flow: Flow, z: list[Any], h: arb) -> None:
        """Form the polynomials, both cut before the same order."""
        self.flow, self.z, curve = flow, z, flow.numbers.curve
        one, *two = (product(z) for product in flow.all_terms)
        self.order = len(one) - 1
        self.rest = flow.reached(self.order - 1, z, h) / math.factorial(self.order)
        self.x = curve(one[: self.order])
        # in stick body 2 goes with body 1
        self.y = curve(two[0][: self.order]) if two else self.x + (z[X2] - z[X1])
        self.v = self.x.derivative()
        self.w = self.y.derivative() if two else self.v

    def row(self, which: int) -> Any:
        """Return a row of which there is a guard."""
        numbers, flow = self.flow.numbers, self.flow
        if not flow.slips:
            return self.w.derivative() * numbers.number(flow.pair.m2)
        speed = self.v + self.w * -1
        if which == 0:
            return speed
        apart, (slope, pull) = self.x + self.y * -1, map(numbers.number, flow.coupling or (0, 0))
        return (apart, speed * slope + apart * pull + numbers.curve([self.z[ONE]]))[which - 1]

    def cuts(self, h: arb, *derivatives: int) -> list[arb]:
        """Return in units of N bounds on what these derivatives of x1 and x2 leave out up to h."""
        n = self.order
        return [(self.rest * math.perm(n, k) * h ** (n - k)).upper() for k in derivatives]

    def row_off(self, which: int, h: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of a row leaves out up to h."""
        return self.flow.of_rows(lambda k: self.cuts(h, derivative + k)[0])[which].upper()

    def state(self, t: Any) -> list[Any]:
        """Return the state at a time after the point."""
        within, h = self.flow.numbers.within, arb(t).abs_upper()
        cuts, bodies = self.cuts(h, 0, 1), ((self.x, self.v), (self.y, self.w))
        return [
            within(one(t), size * off)
            for curves, size in zip(bodies, self.flow.norm.speeds, strict=True)
            for one, off in zip(curves, cuts, strict=True)
        ]

    def bends(self, t: arb) -> list[arb]:
        """Return bounds on |v1'| and |v2'| over a ball of times."""
        [off], ends = self.cuts(t.upper(), 2), zip((self.v, self.w), self.flow.norm.speeds, strict=True)
        return [one.derivative()(t).abs_upper() + size * off for one, size in ends]


def filled(row: list[Any], count: int, zero: Any) -> list[Any]:
    """Return coefficients, those that vanish for ever included."""
    return [one for one, _ in zip_longest(row, range(count), fillvalue=zero)]


@lru_cache(maxsize=64)
def numbers_of(name: str, digits: int) -> Numbers:
    """Return balls, or numbers of mpmath, with so many digits."""
    return BallNumbers(digits) if name == "ball" else PointNumbers(digits)


flow_of = lru_cache(maxsize=256)(Flow)
"""A flow, built once."""


def _terms(bits: int) -> int:
    """Return how many terms leave less than 2^-bits of exp(REACH)."""
    terms, size = 1, 0.0
    while size < bits:
        terms += 1
        size += math.log2(terms / REACH)
    return terms
