"""A reduced scene in balls: masses, springs, what acts; the norm in which two motions never part."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import reduce
from typing import Any

from flint import arb, arb_mat

from numerics.arithmetic.ball import BITS_PER_DIGIT, Ball
from numerics.arithmetic.precision import precision, series_terms
from numerics.errors import EventUndecided
from numerics.plane.reduced import Acting, ReducedPlane
from numerics.plane.vector import Vector, exact

SPARE_BITS = 40
"""Bits beyond those to which series are cut: the terms of a long step are larger than their sum."""

_MORE_BITS = {True: 2, False: 12}
"""Bits beyond the digits that a path is asked for: few more cost less than bounds by components, in linear modes most.

So N alone is a bound as good as any.
"""


class System:
    """A pair on n axes. With N^2 = q1.A2 q1 + v1.M1 v1 + v2.M2 v2 of the difference of two motions N never grows.

    `groups` are the axes that stick and slip together: each axis of a box, all of an ellipsoid.
    """

    def __init__(self, given: ReducedPlane, digits: int) -> None:
        """Take the data, and the working precision in decimal digits."""
        self.given, self.digits = given, digits
        self.bits = math.ceil(digits * BITS_PER_DIGIT) + _MORE_BITS[given.is_round]
        self.n, self.degree, self.eps = len(given.m1), max(12, int(0.4 * self.bits)), arb((1, -self.bits))
        self.axes = range(self.n)
        self.groups = [[*self.axes]] if given.is_round else [[i] for i in self.axes]
        with self.fine():
            self.m1, self.m2 = exact(given.m1), exact(given.m2)
            self.a1, self.a2 = exact(given.a1 if any(map(any, given.a1)) else ()), exact(given.a2)
            self.mass = self.m1 + self.m2
            self.kappa, self.share = self.mass / (self.m1 * self.m2), self.m2 / self.mass
            self.still, ones = Vector([arb(0)] * self.n), Vector([arb(1)] * self.n)
            self.root_m1, self.root_m2 = (m.each(arb.sqrt) for m in (self.m1, self.m2))
            # q.A2 q <= sum_i r_i q_i^2, and |q_i| <= N sqrt((A2^-1)_ii)
            self.spring = (abs(self.a2) @ ones).each(arb.sqrt)
            inverse = arb_mat([*self.a2]).inv()
            self.soft = Vector(inverse[i, i].sqrt() for i in self.axes)
            stiff = Vector(self.a2[i][i] for i in self.axes)
            self.period = highest((self.mass / stiff).each(arb.sqrt))
            # an error N moves component i of the load by load_error[i] N at most, and of v1 - v2 by apart[i] N
            self.load_error = self.share * (stiff.each(arb.sqrt) + abs(self.a1) @ (1 / self.root_m1))
            self.apart = self.kappa.each(arb.sqrt)
            self.pieces = [PlaneDrive(self, piece) for piece in given.pieces]
            self.start, b = [*map(exact, given.start)], self.pieces[0].b
            self.size = highest(Vector((*self.start[0], *(b / stiff))))
            self.speed = highest(Vector((*self.start[1], *self.start[2], *(b / (self.mass * stiff).each(arb.sqrt)))))
            self.place, self.force, self.at_first = exact(given.place), exact(given.force), exact(given.apart)

    @contextmanager
    def fine(self) -> Iterator[None]:
        """Compute with all bits: what defects show is where series are cut, no rounding. No series is cut by flint."""
        bits = self.bits + SPARE_BITS
        with precision(bits), series_terms(bits):
            yield

    def drive(self, at: Any) -> PlaneDrive:
        """Return what acts at a point of the path."""
        return self.pieces[min(at.piece, len(self.pieces) - 1)]

    def time(self, at: Any) -> float:
        """Return the time at a point of the path, s, for messages."""
        return float(self.drive(at).acting.start) + float(at.t.mid())

    def undecided(self, question: str, at: Any, norm: arb) -> EventUndecided:
        """Return the error for a point after which these digits do not tell what happens."""
        return EventUndecided(f"{question} near t = {self.time(at):.6g} s", f"N <= {norm.str(3)}", self.digits)

    def word(self, mode: str) -> str:
        """Return a mode as it is shown: of a box by axes."""
        return mode if not self.given.is_round else "stick" if "0" in mode else "slip"

    def push(self, u: Vector, q1: Vector, v1: Vector) -> Vector:
        """Return u - A2 q1 - A1 v1, of numbers, of polynomials or of series."""
        found: Vector = u - self.a2 @ q1 - self.a1 @ v1
        return found

    def load(self, u: Vector, q1: Vector, v1: Vector) -> Vector:
        """Return Lam = M2 (M1 + M2)^-1 (u - A2 q1 - A1 v1)."""
        found: Vector = self.push(u, q1, v1) * self.share
        return found

    def norm(self, q1: Vector, v1: Vector, v2: Vector) -> arb:
        """Return a bound on N of a difference with these components, given by their sizes."""
        return (self.spring @ abs(q1) + self.root_m1 @ abs(v1) + self.root_m2 @ abs(v2)).upper()

    def length(self, s: Vector) -> arb:
        """Return |s|_{kap^-1}."""
        return (s * s @ (1 / self.kappa)).sqrt()


class PlaneDrive:
    """What acts in a piece: u of the time from its beginning, and b."""

    def __init__(self, system: System, acting: Acting) -> None:
        """Take what acts, exact."""
        number = Ball.number
        self.acting, self.length = acting, number(acting.end - acting.start)
        terms, powers = acting.terms, [one for one in acting.terms if isinstance(one, int)]
        self.polynomial = [exact(terms.get(k, system.given.m1 * 0)) for k in range(max(powers, default=-1) + 1)]
        self.sines = [(*map(number, key), exact(a)) for key, a in terms.items() if isinstance(key, tuple)]
        self.b_squared = exact(acting.b_squared)
        self.b = self.b_squared.each(arb.sqrt)
        self.heavy = 1 / (system.kappa * self.b_squared)
        """D = (B kap B)^-1: a direction settles at the rate 1/(D h(s))."""
        self.weak = reduce(arb.min, self.b * system.apart)
        self.reach = highest(self.b * system.apart) * arb(1 + 1e-9)
        """h of a difference of two slips is at most that times N."""

    def swing(self, t: Any) -> list[tuple[Any, Any]]:
        """Return sine and cosine of each phase at a time, a number or a series."""
        return [(omega * t + phase).sin_cos() for omega, phase, _ in self.sines]

    def force(self, t: Any, swing: Sequence[tuple[Any, Any]] | None = None) -> Vector:
        """Return u at a time from the beginning of the piece: a number, a series, or a polynomial with its `swing`."""
        found = Vector([t * 0] * len(self.b))
        for one in reversed(self.polynomial):
            found = found * t + one
        for (*_, amplitudes), (sine, _) in zip(self.sines, self.swing(t) if swing is None else swing, strict=True):
            found = found + amplitudes * sine
        return found

    def friction(self, s: Vector) -> tuple[Vector, arb]:
        """Return f(s) and h(s) of a slip s != 0."""
        size = (self.b_squared @ (s * s)).sqrt()
        return self.b_squared * s / size, size

    def strain(self, load: Vector, axes: Sequence[int]) -> Any:
        """Return |B^-1 Lam|^2 of some axes, at most 1 where the load is in K; of numbers or of polynomials."""
        return sum((load[i] * load[i] * (1 / self.b_squared[i]) for i in axes), arb(0))


def highest(values: Vector) -> arb:
    """Return the largest size, as a point."""
    return reduce(arb.max, (abs(one).mid() for one in values))
