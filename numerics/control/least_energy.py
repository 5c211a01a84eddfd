"""The stuck motion from rest to rest over D in the time T with the least int u^2 dt, where |x''| <= beta.

Its acceleration a is all there is to choose, as u/M = a + c v + k x, c = a1/M, k = a2/M. Whatever w(t), nu and mu are,

    int (u/M)^2 >= 2 int w u/M - int w^2 >= 2 mu D - 2 beta int |rho| - int w^2,
    rho = w + c S + k int_t^T S + nu - mu (T - t), S = int_t^T w,

and this is attained, with w = u/M, if rho = 0 where |a| < beta and rho has the sign of -a else. With q = rho - w and
r = q' + c w these are equations for (x, v, q, r), linear but that a = -q - c v - k x is cut off at beta. The numbers
q(0), r(0) that bring it to (D, 0) are searched for by Newton's method while the limit comes down to beta. Nothing rests
on the search: the bound is computed from the force that it finds, in balls.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from flint import arb, arb_mat, arb_poly

from numerics.arithmetic.ball import exact_middle
from numerics.control.answers import number, rounded
from numerics.control.tracking import is_never_negative
from numerics.errors import NotSettled
from numerics.scene import Pair, Piece
from numerics.scene.decimals import short

_NEWTON, _MOST_PARTS, _TERMS, _CHECKS, _LEAST_STEP = 12, 1000, 39, 8, 0.9999
_LITTLE = Fraction(1, 10**20)
"""By this part the force stays below the limit of friction, so that the bodies stick beyond doubt."""


class Motion(NamedTuple):
    """The motion from rest with given q(0) and r(0).

    `parts`: its force by pieces, each with the side, 1, 0 or -1, on which its acceleration is at the limit; `ends`:
    (x, v, q, r, limit) at T, its derivatives by q(0), r(0) and the limit; `largest`: |a| before it is cut off, m/s^2.
    """

    q: arb
    r: arb
    parts: list[tuple[Piece, int]]
    ends: list[list[arb]]
    largest: arb

    def moved(self, x: arb, v: arb) -> tuple[arb, arb]:
        """Return the q(0), r(0) that add so much to x and v at T, to first order; raises ZeroDivisionError."""
        by = arb_mat([one[:2] for one in self.ends[1:3]]).transpose().solve(arb_mat([[x], [v]]))
        return (self.q + by[0, 0]).mid(), (self.r + by[1, 0]).mid()


class Search:
    """The search for the force on a pair over a distance (m) in a time (s); `bound` proves what it finds."""

    def __init__(self, pair: Pair, far: Fraction, until: Fraction) -> None:
        """Take the numbers in the arithmetic of the context."""
        self.mass, self.far, self.until = number(pair.mass), number(far), until
        self.c, self.k = c, k = number(pair.a1 / pair.mass), number(pair.a2 / pair.mass)
        self.free = arb_mat([[0, 1, 0, 0, 0], [-k, -c, 0, 0, 0], [0, 0, 0, 1, 0], [0] * 5, [0] * 5])
        self.gain, self.of_a = arb_mat([[0], [1], [-c], [k], [0]]), arb_mat([[-k, -c, -1, 0, 0]])
        """z' = free z + gain u/M of z = (x, v, q, r, limit); the row of a before it is cut off."""
        cause, remedy = "", ""
        if pair.a1:
            cause, remedy = f", or the damper a1 = {short(pair.a1)} N s/m too strong", " or a weaker damper"
        self.not_found = NotSettled(
            "no force of least energy was found: the time is next to the least one, or too long to search"
            f"{cause}; give another time{remedy}"
        )

    def follow(self, q: arb, r: arb, limit: arb) -> Motion:
        """Return the motion whose acceleration is cut off at a limit."""
        start, side, parts, largest = arb(0), 0, list[tuple[Piece, int]](), arb(0)
        ends = arb_mat([[0] * 4, [0] * 4, [q, 1, 0, 0], [r, 0, 1, 0], [limit, 0, 0, 1]])
        while (left := (number(self.until) - start).mid()) > number(self.until * _LITTLE**2):
            step = left.min((1 / (self.k.sqrt() + self.c)).mid())
            of_u = arb_mat([[self.k, self.c, 0, 0, side] if side else [0, 0, -1, 0, 0]])
            A, terms = self.free + self.gain * of_u, [ends]
            for k in range(1, _TERMS):
                terms.append(A * terms[-1] / k)
            u, a = (arb_poly([(row * one)[0, 0] for one in terms]) for row in (of_u, self.of_a))
            low = end = arb(0)
            for k in range(bool(parts), _CHECKS + 1):  # a part begins on its side
                low, end = end, (step * k / _CHECKS).mid()
                largest = largest.max(abs(a(end)).mid())
                then = int(a(end) >= limit) - int(a(end) <= -limit)
                if then != side:
                    break
            if then != side:
                high = end
                for _ in range(_NEWTON):
                    end -= (a(end) - (side or then) * limit) / a.derivative()(end)
                    end = end.mid().max(low).min(high)
            if end > 0:
                parts.append((Piece(rounded(start), [rounded(self.mass * one) for one in u.coeffs()]), side))
            ends = ((A * end).exp() * ends).mid()
            start, side = (start + end).mid(), then if side in (0, then) else 0
            if len(parts) > _MOST_PARTS:
                raise self.not_found
        return Motion(q, r, parts, ends.transpose().tolist(), largest)

    def arrive(self, q: arb, r: arb, limit: arb) -> Motion:
        """Return the motion that arrives, from q(0), r(0) near its own."""
        for _ in range(_NEWTON):
            found = self.follow(q, r, limit)
            x, v, *_ = found.ends[0]
            if abs(self.far - x) + abs(v) * number(self.until) < self.far * number(_LITTLE**2):
                return found
            try:
                q, r = found.moved(self.far - x, -v)
            except ZeroDivisionError:
                break
        raise self.not_found

    def force(self, most: Fraction) -> Motion:
        """Return the motion that arrives with |a| <= most; raises NotSettled."""
        found, share = self.arrive(arb(0), arb(0), arb(10) ** 300), arb("0.7")
        limit, last = found.largest, number(most * (1 - _LITTLE))
        while limit > last:
            lower = (limit * share).mid().max(last)
            x, v, *_ = found.ends[3]
            try:
                found = self.arrive(*found.moved((limit - lower) * x, (limit - lower) * v), lower)
                limit, share = lower, share * share
            except (NotSettled, ZeroDivisionError):
                share = share.sqrt()
                if share > _LEAST_STEP:
                    raise self.not_found from None
        return found

    def bound(self, found: Motion, most: Fraction) -> tuple[arb, arb]:
        """Return int u^2 of a force and the least that any under which the bodies stick can have, N^2 s, enclosures.

        The bound holds whatever the force is. Friction matters little where D is tiny; but who spends less than this
        force has |v| <= V = sqrt(T int (u/M)^2), as the damper and the spring add no energy, and so
        int |a| <= V (1 + c T + k T^2).
        """
        _, _, nu, mu, _ = found.ends[0]
        cost = lost = largest = once = twice = arb(0)  # S and int_t^T S at the end of a part
        until = self.until
        for piece, side in reversed(found.parts):
            length, w = number(until - piece.start), arb_poly([number(one) / self.mass for one in piece.polynomial])
            S = _from_end(w, length, once)
            R = _from_end(S, length, twice)
            rho = w + self.c * S + self.k * R + nu - mu * arb_poly([number(self.until - piece.start), -1])
            high = sum((abs(one) * length**k for k, one in enumerate(rho.coeffs())), arb(0))
            size, largest = high * length, largest.max(high)
            if side:
                little = high * number(_LITTLE)
                least = [exact_middle(one.lower()) for one in (little - side * rho).coeffs()]
                size = 2 * little * length - side * rho.integral()(length)
                if not is_never_negative(least, until - piece.start):
                    raise self.not_found
            cost, lost = cost + (w * w).integral()(length), lost + size
            once, twice, until = S(0), R(0), piece.start
        T, without = number(self.until), 2 * mu * self.far - cost  # what |rho| takes
        moved = (T * cost).sqrt() * (1 + self.c * T + self.k * T * T)
        least = (without - 2 * number(most) * lost).max(cost.min(without - 2 * largest * moved))
        return self.mass**2 * cost, self.mass**2 * least


def _from_end(f: arb_poly, length: arb, after: arb) -> arb_poly:
    """Return the integral of f from t to the end of its part, and what comes after."""
    return after + f.integral()(length) - f.integral()
