"""The stuck motion from rest to rest over D in the time T that has the least of something, where |a| <= beta.

Its acceleration a is all there is to choose: with c = a1/M, k = a2/M it takes u/M = a + c v + k x. Whatever w(t), nu
and mu are, with S = int_t^T w and rho = w + c S + k int_t^T S + nu - mu (T - t),

    int w u/M = mu D + int rho a,  hence   int (u/M)^2 >= 2 (mu D - beta int |rho|) - int w^2
                                           max |u/M|   >= (mu D - beta int |rho|)/int |w|

with equality if rho = 0 where |a| < beta, rho has the sign of -a elsewhere, and w is u/M; or, for the peak, has the
sign of u, and is 0 where |u| is below its peak. With q = rho - w and r = q' + c w these are equations for a motion,

    x' = v,  v' = a,  q' = r - c w,  r' = k w

in which w = -q and u follows from w where |a| < beta; elsewhere a = +-beta, and u follows. The numbers q(0), r(0) that
bring it to (D, 0) are searched for by Newton's method while the limit comes down to beta; for the peak from those of
the least energy. Nothing rests on the search: the bound is computed from the force that it finds, in balls.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

import flint
from flint import arb, arb_mat, arb_poly

from numerics.arithmetic.ball import exact_middle, working_digits
from numerics.control.answers import number, rounded
from numerics.control.tracking import is_never_negative
from numerics.errors import NotSettled
from numerics.scene import Pair, Piece
from numerics.scene.decimals import short

_NEWTON, _MOST_PARTS, _TERMS, _CHECKS, _HALVINGS, _LEAST_STEP = 12, 400, 39, 8, 16, 0.9999
_WORSE, _ROUNDED = 4, 8
"""Newton's method is given up where it is so many times farther from arriving than it was. At the limit of friction u
may be above its peak in the last of its decimals, so many."""
_NO_LIMIT = arb(10) ** 300
LITTLE = Fraction(1, 10**20)
"""By this part the force stays below the limit of friction, so that the bodies stick beyond doubt."""
Row = Sequence[arb | int]
"""Coefficients of x, v, q, r, P and the limit."""


class Arc(NamedTuple):
    """A rule for u: the sign of w, and that of a where it is at the limit, else 0."""

    sign: int
    side: int


class ArcPart(NamedTuple):
    """An arc or some of it: u/M and w (m/s^2) by the time since its start (s)."""

    start: arb
    u: arb_poly
    w: arb_poly
    arc: Arc


class DrivenMotion(NamedTuple):
    """The motion from rest with given q(0) and r(0): its parts, (x, v, q, r) at T, the largest |a| without limit."""

    q: arb
    r: arb
    parts: list[ArcPart]
    end: list[arb]
    largest: arb


class LeastEnergy:
    """The search for a force on a pair over a distance (m) in a time (s), |a| <= most (m/s^2); `bound` proves it.

    It has the least int u^2 dt. z = (x, v, q, r, P, limit), z' = free z + moved (u/M, w). P = hypot(q(0),
    r(0)/sqrt(k)).
    """

    def __init__(self, pair: Pair, far: Fraction, until: Fraction) -> None:
        """Take the numbers in the arithmetic of the context."""
        self.pair, self.distance, self.until, self.most = pair, far, until, pair.b / pair.m2
        self.mass, self.limit = number(pair.mass), number(self.most * (1 - LITTLE))
        self.far, self.T, self.c, self.k = map(number, (far, until, pair.a1 / pair.mass, pair.a2 / pair.mass))
        nothing = [[0] * 6] * 3
        self.free = arb_mat([[0, 1, 0, 0, 0, 0], [-self.k, -self.c, 0, 0, 0, 0], [0, 0, 0, 1, 0, 0], *nothing])
        self.moved = arb_mat([[0, 0], [1, 0], [0, -self.c], [0, self.k], [0, 0], [0, 0]])
        damped = f", or the damper a1 = {short(pair.a1)} N s/m too strong" if pair.a1 else ""
        self.not_found = NotSettled(
            f"no cheapest force was found: the time is next to the least one, or too long to search{damped}"
        )

    def start(self) -> tuple[arb, arb]:
        """Return q(0), r(0) near those of the motion that arrives where there is no limit: all is linear then."""
        return arb(0), arb(0)

    def sign(self, q: arb) -> int:  # noqa: ARG002  # it depends on more than the sign
        """Return the sign of w = -q, where u depends on it alone; else 0."""
        return 0

    def rows(self, arc: Arc) -> tuple[Row, Row]:
        """Return u/M and w along an arc, as rows of z: both -q, at the limit side limit + c v + k x."""
        u = [self.k, self.c, 0, 0, 0, arc.side] if arc.side else [0, 0, -1, 0, 0, 0]
        return u, u

    def cost(self, found: DrivenMotion) -> arb:
        """Return what a force has least of, N^2 s or N."""
        squares = ((part.w * part.w).integral()(number(length)) for _, length, part in self.lengths(found))
        return self.mass**2 * sum(squares, arb(0))

    def from_below(self, gain: arb, found: DrivenMotion) -> arb:
        """Return what no cost is below, from a lower bound of mu D + int rho a."""
        return self.mass**2 * 2 * gain - self.cost(found)

    def unlimited(self, sign: int) -> arb_mat:
        """Return a without a limit, as a row of z."""
        u, _ = self.rows(Arc(sign, 0))
        return arb_mat([u]) - arb_mat([[self.k, self.c, 0, 0, 0, 0]])

    def arc(self, z: arb_mat) -> tuple[Arc, arb]:
        """Return which arc goes on from z, and a without a limit."""
        sign, limit = self.sign(z[2, 0]), z[5, 0]
        a = (self.unlimited(sign) * z)[0, 0]
        return Arc(sign, int(a >= limit) - int(a <= -limit)), a

    def size(self, q: arb, r: arb) -> arb:
        """Return P."""
        return (q * q + r * r / self.k).sqrt().mid()

    def follow(self, q: arb, r: arb, limit: arb) -> DrivenMotion:
        """Return the motion whose acceleration is cut off at a limit. Raises NotSettled."""
        start, parts, largest, size = arb(0), list[ArcPart](), arb(0), self.size(q, r)
        z, shortest = arb_mat([[one] for one in (0, 0, q, r, size, limit)]), number(self.until * LITTLE**2)
        arc, _ = self.arc(z)
        while (left := (self.T - start).mid()) > shortest:
            step, (of_u, of_w) = left.min((1 / (self.k.sqrt() + self.c)).mid()), self.rows(arc)
            A, terms = self.free + self.moved * arb_mat([of_u, of_w]), [z]
            for k in range(1, _TERMS):
                terms.append(A * terms[-1] / k)
            columns = [arb_poly([one[place, 0] for one in terms]) for place in range(6)]

            low = high = arb(0)
            for k in range(1, _CHECKS + 1):
                low, high = high, (step * k / _CHECKS).mid()
                then, a = self.arc(_at(columns, high))
                largest = largest.max(abs(a).mid())
                if then != arc:
                    high, then = self.change(arc, then, columns, low, high)
                    break
            u, w = (_dot(row, columns) for row in (of_u, of_w))
            parts.append(ArcPart(start, u, arb_poly([one.mid() for one in w.coeffs()]), arc))
            z, start, arc = ((A * high).exp() * z).mid(), (start + high).mid(), then
            if len(parts) > _MOST_PARTS:
                raise self.not_found
        return DrivenMotion(q, r, parts, z.transpose().tolist()[0][:4], largest)

    def change(self, arc: Arc, then: Arc, columns: list[arb_poly], low: arb, high: arb) -> tuple[arb, Arc]:
        """Return the first time between two at which an arc ends, about, and the arc that follows."""
        for _ in range(_HALVINGS):
            middle = ((low + high) / 2).mid()
            there, _ = self.arc(_at(columns, middle))
            low, high, then = (middle, high, then) if there == arc else (low, middle, there)
        f = columns[2]
        if then.sign == arc.sign:
            f = _dot(self.unlimited(arc.sign).tolist()[0], columns) - (then.side or arc.side) * columns[5]
        slope, t = f.derivative(), high
        for _ in range(_NEWTON):
            t = (t - f(t) / slope(t)).mid().max(low).min(high)
        return t, then

    def arrive(self, q: arb, r: arb, limit: arb) -> DrivenMotion:
        """Return the motion that arrives, by Newton's method from q(0), r(0) near its own. Raises NotSettled."""
        least = arb.pos_inf()
        for _ in range(_NEWTON):
            found = self.follow(q, r, limit)
            x, v, *_ = found.end
            off = abs(self.far - x) + abs(v) * self.T
            if off < self.far * number(LITTLE**2):
                return found
            if not off < _WORSE * least:
                break
            least, by = least.min(off), (self.size(q, r).max(self.far / self.T**2) * number(LITTLE)).mid()
            steps = by, (by * self.k.sqrt()).mid()
            beside = self.follow(q + steps[0], r, limit), self.follow(q, r + steps[1], limit)
            slopes = [[(one.end[k] - found.end[k]) / h for one, h in zip(beside, steps, strict=True)] for k in (0, 1)]
            try:
                more = arb_mat(slopes).solve(arb_mat([[self.far - x], [-v]]))
            except ZeroDivisionError:
                break
            q, r = (q + more[0, 0]).mid(), (r + more[1, 0]).mid()
        raise self.not_found

    def force(self) -> DrivenMotion:
        """Return the motion that arrives within the limit: this comes down, in shorter steps where one fails."""
        found = self.arrive(*self.start(), _NO_LIMIT)
        limit, share = found.largest, arb("0.7")
        while limit > self.limit:
            lower = (limit * share).mid().max(self.limit)
            try:
                found = self.arrive(found.q, found.r, lower)
                limit, share = lower, share * share
            except NotSettled:
                share = share.sqrt()
                if share > _LEAST_STEP:
                    raise
        return found

    def bound(self, found: DrivenMotion) -> tuple[arb, arb]:
        """Return the cost of a force, and the least that any under which the bodies stick can have.

        The bound holds whatever the force is.
        """
        *_, nu, mu = found.end
        lost = once = twice = arb(0)  # S and int_t^T S at the end of a part
        for start, length, part in reversed([*self.lengths(found)]):
            S = _from_end(part.w, number(length), once)
            R = _from_end(S, number(length), twice)
            rho = part.w + self.c * S + self.k * R + nu - mu * arb_poly([number(self.until - start), -1])
            lost, once, twice = lost + self.total(rho, -part.arc.side, length), S(0), R(0)
        return self.cost(found), self.from_below(mu * self.far - number(self.most) * lost, found)

    def lengths(self, found: DrivenMotion) -> Iterator[tuple[Fraction, Fraction, ArcPart]]:
        """Yield when each part begins and how long it lasts, s, and the part."""
        starts = [rounded(one.start, working_digits()) for one in found.parts]
        for start, end, part in zip(starts, [*starts[1:], self.until], found.parts, strict=True):
            yield start, end - start, part

    def pieces(self, found: DrivenMotion) -> list[Piece]:
        """Return the force, N, in decimals of all working digits: the cost is that of these."""
        digits = working_digits()
        return [
            Piece(rounded(one.start, digits), [rounded(self.mass * x, digits) for x in one.u.coeffs()])
            for one in found.parts
        ]

    def total(self, p: arb_poly, sign: int, length: Fraction) -> arb:
        """Return a bound of int |p| over a time (s); `sign`: that of p, but for a little; 0: p is near 0.

        Raises NotSettled where p has another sign.
        """
        time = number(length)
        high = sum((abs(one) * time**k for k, one in enumerate(p.coeffs())), arb(0)).upper()
        if not sign:
            return high * time
        little = high * number(LITTLE)
        self.require_never_negative(little + sign * p, length)
        return 2 * little * time + sign * p.integral()(time)

    def require_never_negative(self, p: arb_poly, length: Fraction) -> None:
        """Raise NotSettled if a polynomial is negative somewhere on [0, length]."""
        if not is_never_negative([exact_middle(one.lower()) for one in p.coeffs()], length):
            raise self.not_found


class LeastPeak(LeastEnergy):
    """The same for the least max |u|: without a limit it is P everywhere, and changes its sign with w."""

    def start(self) -> tuple[arb, arb]:
        """Return those of the least energy."""
        search = LeastEnergy(self.pair, self.distance, self.until)
        found = search.arrive(*search.start(), _NO_LIMIT)
        return found.q, found.r

    def force(self) -> DrivenMotion:
        """Return the motion that waits, where more time brings nothing; else the one that is searched for."""
        return self.waiting() or super().force()

    def waiting(self) -> DrivenMotion | None:
        """Return a motion whose peak its end alone needs, after a wait; None where T or D is too small for this one.

        It accelerates by beta, keeps u/M = P if it gets there, brakes by beta until u/M has risen to P once more, where
        v = c beta/k, and comes to rest under P = k D - beta exp(-2 psi tan psi), sin psi = c/(2 sqrt(k)).
        """
        c, k, beta = self.c, self.k, self.limit
        speed, swing, peak = c * beta / k, (k - c * c / 4).sqrt(), self.least_at_end(beta)
        place, rest = (peak + beta - c * speed) / k, 2 * (c / (2 * k.sqrt())).asin() / swing
        turn, fast = beta * place + speed * speed / 2, ((c * c + 2 * k * (peak / beta - 1)).sqrt() - c) * beta / k
        x, v, kept = turn / (2 * beta), turn.sqrt(), arb(0)
        if v <= fast:
            fast = v
        elif (arc := self.arc_at(peak, fast, turn)) is not None:
            kept, x, v = arc
        else:
            return None
        rising, falling = [beta, c * beta, k * beta / 2], [c * v + k * x - beta, k * v - c * beta, -k * beta / 2]
        arcs = (fast / beta, rising, 1), (kept, [peak], 0), ((v - speed) / beta, falling, -1), (rest, [peak], 0)
        start, nothing = (self.T - sum((time for time, *_ in arcs), arb(0))).mid(), arb_poly([])
        if not start >= 0:
            return None
        parts = [ArcPart(arb(0), nothing, nothing, Arc(1, 0))]
        for time, u, side in arcs:
            if time > 0:
                parts.append(ArcPart(start, arb_poly(u), nothing, Arc(1, side)))
            start = (start + time).mid()
        # q and r of the size P; nu = mu = 0: its bound is `least_at_end`
        return DrivenMotion(peak, arb(0), parts, [self.far, arb(0), arb(0), arb(0)], beta)

    def arc_at(self, peak: arb, fast: arb, turn: arb) -> tuple[arb, arb, arb] | None:
        """Return how long u/M = P is kept after a speed is reached, and x and v then: v^2 + 2 beta x = 2 turn.

        None where a reaches -beta before, or v falls below c beta/k.
        """
        if not fast > 0:
            return None
        c, k, beta = self.c, self.k, self.limit
        flow, begin = arb_mat([[0, 1], [-k, -c]]), arb_mat([[fast * fast / (2 * beta) - peak / k], [fast]])

        def at(t: arb) -> tuple[arb, arb]:
            y, v = ((flow * t).exp() * begin).entries()
            return y + peak / k, v

        low, high = arb(0), (arb.pi() / (k - c * c / 4).sqrt()).mid()
        for _ in range(flint.ctx.prec):
            x, v = at(middle := ((low + high) / 2).mid())
            goes_on = v * v + 2 * beta * x < 2 * turn and peak - c * v - k * x > -beta
            low, high = (middle, high) if goes_on else (low, middle)
        x, v = at(high)
        is_met = v * v + 2 * beta * x > 2 * turn * number(1 - LITTLE**2) and v > c * beta / k
        return (high, x, v) if is_met else None

    def least_at_end(self, beta: arb) -> arb:
        """Return the least max u/M that the end of a long time needs, |a| <= beta; no number if c^2 >= 4 k.

        It is the bound above for w = v exp(c s), s the time since the brakes were off, v the velocity that comes to
        rest under P, after a bump of w at s = 0 of weight beta/k, as short as one likes: rho is 0 elsewhere.
        """
        angle = (self.c / (2 * self.k.sqrt())).asin()
        return self.k * self.far - beta * (-2 * angle * angle.tan()).exp()

    def sign(self, q: arb) -> int:
        """Return that of -q."""
        return -1 if q > 0 else 1

    def rows(self, arc: Arc) -> tuple[Row, Row]:
        """Return u/M = sign P and w = -q, at the limit u/M = side limit + c v + k x and w = 0."""
        if arc.side:
            return [self.k, self.c, 0, 0, 0, arc.side], [0] * 6
        return [0, 0, 0, 0, arc.sign, 0], [0, 0, -1, 0, 0, 0]

    def cost(self, found: DrivenMotion) -> arb:
        """Return M P. Raises NotSettled where u is above it at the limit, but for the rounding of its decimals."""
        peak = self.size(found.q, found.r)
        high = peak * (1 + arb(10) ** (_ROUNDED - working_digits()))
        for _, length, part in self.lengths(found):
            for u in (part.u, -part.u) if part.arc.side else ():
                self.require_never_negative(high - u, length)
        return self.mass * peak

    def from_below(self, gain: arb, found: DrivenMotion) -> arb:
        """Return gain/int |w|; of a motion that waits, what the end alone needs."""
        parts = [(part.w, 0 if part.arc.side else part.arc.sign, length) for _, length, part in self.lengths(found)]
        weight = sum((self.total(*one) for one in parts), arb(0))
        return self.mass * (gain / weight if weight > 0 else self.least_at_end(number(self.most)))


def _at(columns: list[arb_poly], t: arb) -> arb_mat:
    return arb_mat([[one(t)] for one in columns])


def _dot(row: Row, columns: list[arb_poly]) -> arb_poly:
    return sum((x * one for x, one in zip(row, columns, strict=True)), arb_poly([]))


def _from_end(f: arb_poly, length: arb, after: arb) -> arb_poly:
    """Return the integral of f from t to the end of its part, and what comes after."""
    return after + f.integral()(length) - f.integral()
