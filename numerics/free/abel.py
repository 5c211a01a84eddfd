"""The Abel (Fatou) function of the return map: iterate counts beyond counting, with an enclosure of the error.

From ray to ray y = w/q goes to F(y) = y (1 - G), G = r c^2/y, and the cycle takes the reduced time pi + t(epsilon),
epsilon = sqrt(w). Two functions turn iteration into addition:

    alpha(F(y)) = alpha(y) + 1          alpha = 1/(a y) + B ln y + c_1 y + ... ,  a = 9 r/4
    beta(F(y))  = beta(y) + pi + t      beta  = pi alpha + g_1 epsilon + g_2 epsilon^2 + ...

A third sums what the slips, to one side and the other in turn, move the bodies apart: slide(F(y)) = y - F(y) -
slide(y), slide = s_1 y + s_2 y^2 + ... .

Their series are computed over the rationals. What a truncated series misses of its equation is analytic in the slip
angle theta on a disc, bounded on its rim by balls, and has a zero of known order at 0: Schwarz's lemma bounds it
inside, and the sum over all later iterates, which y_k - y_{k+1} >= a' y_k^2 makes finite, bounds the function's error.
By the inequality of Cusa and Huygens h is convex on (0, 2 pi), so h(theta) >= theta/3 and c is concave in y.

The third one says where a pair that creeps ends up (`creeping_place`): a slip from a ray with y = w/q moves
z = x1 - x2 by E_cr q (y - F(y))/b.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import flint
from flint import acb, acb_poly, arb, arb_poly, fmpq, fmpq_series

from numerics.arithmetic.ball import Ball, undecided, widened
from numerics.arithmetic.precision import precision, series_terms
from numerics.linear.modes import EventKind
from numerics.scene import Pair

ORDER = 24
"""Terms of alpha beyond the logarithm; beta has twice as many, as it runs in half powers of y."""
_ARCS = 1024
_RIM_BITS = 80
_RADII = (Fraction(6, 5), Fraction(1), Fraction(4, 5), Fraction(3, 5), Fraction(2, 5), Fraction(1, 5))


class AbelFunctions:
    """alpha, beta and slide of one mass fraction q = m1/(m1+m2), exact rational in (0, 1); values are enclosures."""

    def __init__(self, q: Fraction, order: int = ORDER) -> None:
        """Compute the series to `order` and the bounds of what they miss."""
        self.q, self.r, self.order = q, 1 - q, order
        with series_terms(2 * order + 12):
            self._compute_series()
        with precision(_RIM_BITS):
            certified = ((radius, sup) for radius in _RADII if (sup := self._defects_on_rim(radius)) is not None)
            try:
                self.radius, self._rims = next(certified)
            except StopIteration:
                raise ArithmeticError(f"no disc around the critical orbit is certified for q = {float(q):g}") from None
            # y_k - y_{k+1} = r c^2 >= decay y_k^2: c is concave in y, and c(0) = 0
            height, deep = height_and_depth(acb(Ball.number(self.radius)))
            self._decay = Ball.number(self.r) * (deep / (height * height)).real.lower() ** 2
        # a y up to which all is certified: a lower bound of h(radius)^2, as h(theta) >= theta/3
        self.largest_argument = (self.radius / 3) ** 2

    def _compute_series(self) -> None:
        q, r = fmpq(self.q.numerator, self.q.denominator), fmpq(self.r.numerator, self.r.denominator)
        x, one = fmpq_series([0, 1]), fmpq_series([1])
        # theta(u) = h^-1(u) and c(u) as series in u: c' = h, so dc = u dtheta
        height = (x - x.sin()) / (1 - x.cos())
        angle = height.reversion()
        depth = (x * angle.derivative()).integral()
        # a power u^k is epsilon^k q^(-k/2): odd series keep one factor 1/sqrt(q), which the definitions below absorb
        slip = _scaled(angle, q, shift=1)  # sqrt(q) theta
        deep = _scaled(depth, q, shift=0)  # c
        falls = deep * deep * (r * q) / (x * x)  # G = r c^2/y in epsilon
        after = x * (one - falls).sqrt()
        time = slip - after.atan() - ((slip - x) / (one - deep * q)).atan()  # t(epsilon)
        self.a = fmpq(9, 4) * r
        self.beta_coefficients = _solved(-time, after, -1, 2, 2 * self.order)
        falls = fmpq_series([falls[2 * k] * q**k for k in range((falls.length() + 1) // 2)])  # in y = epsilon^2/q
        left = falls / (one - falls) / (x * self.a) - 1  # (1/F - 1/y)/a - 1
        self.log_coefficient = left[1] / self.a
        left = left + (one - falls).log() * self.log_coefficient
        self.alpha_coefficients = _solved(left, x * (one - falls), -1, 1, self.order)
        self.slide_coefficients = _solved(-x * falls, x * (one - falls), 1, 0, self.order + 1)

    def alpha(self, y: arb) -> arb:
        """Return an enclosure of alpha(y) for 0 < y <= largest_argument; raises EventUndecided beyond."""
        if not y <= Ball.number(self.largest_argument):
            raise undecided(f"is this excess within the certified {float(self.largest_argument):g}?", y)
        value = 1 / (arb(self.a) * y) + arb(self.log_coefficient) * y.log() + _polynomial(self.alpha_coefficients)(y)
        return widened(value, self._missed(y, 0, 2 * self.order + 4))

    def beta(self, y: arb) -> arb:
        """Return an enclosure of beta(y), the reduced time that iteration adds up."""
        epsilon = (y * Ball.number(self.q)).sqrt()
        value = arb.pi() * self.alpha(y) + _polynomial(self.beta_coefficients)(epsilon)
        return widened(value, self._missed(y, 1, 2 * self.order + 3))

    def slide(self, y: arb) -> arb:
        """Return an enclosure of (y - y_1) - (y_1 - y_2) + (y_2 - y_3) - ..., y_k the iterates of y."""
        return widened(_polynomial(self.slide_coefficients)(y), self._missed(y, 2, 2 * self.order + 4))

    def alpha_inverse(self, value: arb, start: arb) -> arb:
        """Return an enclosure of the y in (0, start] with alpha(y) = value >= alpha(start); alpha falls.

        By 1/(a y) = value - (alpha(y) - 1/(a y)), whose right side hardly depends on y, then by a bracket whose ends
        are proved to lie on either side. Raises EventUndecided where the bracket is not found at this precision.
        """
        a, y, unit = arb(self.a), start.mid(), arb(2) ** (4 - flint.ctx.prec)
        for _ in range(400):
            before, y = y, (1 / (a * (value - self.alpha(y)) + 1 / y)).min(start).mid()
            if not abs(y - before) > y * unit:
                break
        width = 2 * abs(y - before) + 16 * y * unit
        for _ in range(60):
            low, high = (y - width).mid(), (y + width).mid()
            if self.alpha(low) > value and self.alpha(high) < value:
                return low.union(high)
            width = 2 * width
        raise undecided("which energy has this Abel function?", y)

    def _missed(self, y: arb, which: int, zero_order: int) -> arb:
        """Return a bound of sum_k |defect(y_k)| over all later iterates: rim (theta_k/radius)^n, theta <= 3 sqrt(y).

        The zeros at theta = 0 are those of alpha(F) - alpha - 1 and of slide(F) + slide - y + F, which begin at
        y^(order + 2), and of beta(F) - beta - pi - t, whose part beyond pi alpha begins at epsilon^(2 order + 3).
        """
        half = arb(zero_order) / 2
        scale = 9 * y / Ball.number(self.radius) ** 2
        return self._rims[which] * scale**half * (1 + 1 / (y * self._decay * (half - 1)))

    def _defects_on_rim(self, radius: Fraction) -> list[arb] | None:
        """Return the sup of each defect on |theta| = radius; None if a factor may vanish inside.

        By the maximum principle |G| < 1, |q c| < 1, |eps'| < 1 and |landing| < 1 on the rim hold on the disc.
        """
        (q, r), sup = map(Ball.number, (self.q, self.r)), [arb(0)] * 3
        all_series = self.alpha_coefficients, self.beta_coefficients, self.slide_coefficients
        of_alpha, of_beta, of_slide = (acb_poly(_polynomial(one)) for one in all_series)
        for theta in arcs(radius):
            height, deep = height_and_depth(theta)
            y, falls = height * height, r * (deep / height) ** 2
            after, epsilon = y * (1 - falls), q.sqrt() * height
            epsilon_after = epsilon * (1 - falls).sqrt()
            landed = q.sqrt() * (theta - height) / (1 - q * deep)
            if not all(abs(one) < 1 for one in (falls, q * deep, epsilon_after, landed)):
                return None
            defects = (
                falls / (arb(self.a) * after) - 1 + arb(self.log_coefficient) * (1 - falls).log()
                + of_alpha(after) - of_alpha(y),
                of_beta(epsilon_after) - of_beta(epsilon) - (q.sqrt() * theta - epsilon_after.atan() - landed.atan()),
                of_slide(y) + of_slide(after) - y * falls,
            )  # fmt: skip
            sup = [worst.max(abs(one).upper()) for worst, one in zip(sup, defects, strict=True)]
        return sup if all(one.is_finite() for one in sup) else None


_kept = lru_cache(maxsize=8)(AbelFunctions)


def reach_of(digits: int) -> float:
    """Return the largest y = w/q to jump from: there the terms left out are below the digits asked for."""
    return float(0.12 * 10.0 ** (-digits / (_order_for(digits) + 1)))


def _order_for(digits: int) -> int:
    """Return the number of terms that lets the jump start early enough for this many digits."""
    return max(24, min(80, digits))


def abel_functions(share: Fraction, digits: int, y: arb) -> AbelFunctions | None:
    """Return the functions of a mass share, made once, with so many digits at y and below; None if y is too large."""
    if not y < reach_of(digits):
        return None
    found = _kept(share, _order_for(digits))
    return found if y <= Ball.number(found.largest_argument) else None


@dataclass(frozen=True)
class RestingPlace:
    """The limit of x1 - x2 (m), an enclosure, and what is known from some event on.

    From event `index` (counted from 0; -1: the start) on |z - limit| <= `reach` (m) and |w| <= `speed` (m/s), for ever.
    """

    limit: arb
    index: int
    reach: arb
    speed: arb


def creeping_place(trajectory: Any, pair: Pair, near: float, since: Fraction) -> RestingPlace | None:
    """Return the resting place of a pair that creeps, read from an exit after the time `since` (s), or None.

    From then on no force acts on the pair, or a constant one, which only shifts x1. a1 = 0. `near`: from the event on
    reach and speed are at most this, each in its SI unit. The trajectory is of balls; in the arithmetic's context.
    """
    if pair.a1 > 0:
        return None
    number, digits = Ball.number, trajectory.arithmetic.digits
    unit = number(pair.critical_energy * pair.share / pair.b)
    for index, event in enumerate(trajectory.events):
        x1, v1, x2, _ = event.y
        # on the ray the spring has the energy E_cr, a constant force shifts x1 only: the excess is that of the velocity
        y = number(pair.mass / (2 * pair.critical_energy * pair.share)) * v1 * v1
        is_exit = event.kind is EventKind.EXIT and event.t > number(since)
        abel = abel_functions(pair.share, digits, y) if is_exit else None
        if abel is None:
            continue
        # c(y) <= 3 y/2 bounds a slip's way; its angle is at most 3 sqrt(y), and w'' <= (a2/m1)|v1| while body 1 moves
        # outwards
        reach = (unit * number(1 - pair.share) * (9 * y * y / 4)).upper()
        speed = (abs(v1) * 9 * y / 2).upper()
        if reach.max(speed) < near:
            limit = x1 - x2 + event.after.sign * unit * abel.slide(y)
            return RestingPlace(limit, index, reach, speed)
    return None


def height_and_depth(theta: acb) -> tuple[acb, acb]:
    """Return h(theta) and c(theta) for a complex slip angle away from 0."""
    half = theta / 2
    return (theta - theta.sin()) / (2 * half.sin() ** 2), 2 - theta * half.cot()


def arcs(radius: Fraction) -> Iterator[acb]:
    """Yield boxes that cover the rim |theta| = radius; by symmetry the upper half suffices."""
    rim = Ball.number(radius)
    for k in range(_ARCS):
        angle = arb.pi() * (arb(2 * k + 1) / (2 * _ARCS)) + arb(0, (arb.pi() / (2 * _ARCS)).upper())
        yield acb(rim * angle.cos(), rim * angle.sin())


def _solved(left: fmpq_series, after: fmpq_series, sign: int, place: int, count: int) -> list[fmpq]:
    """Return c_1, c_2, ... with left + sum c_k (after^k + sign x^k) = 0, order by order.

    after = x - ..., and the k-th bracket begins at the power k + place: `left` must not begin before the first one.
    """
    if any(left[k] != 0 for k in range(1 + place)):
        raise ArithmeticError("the return map must be y - a y^2, and the time of a cycle pi, up to the third order")
    power, power_after, found = fmpq_series([1]), fmpq_series([1]), []
    for k in range(1, count + 1):
        power, power_after = power * fmpq_series([0, 1]), power_after * after
        bracket = power_after + power * sign
        found.append(-left[k + place] / bracket[k + place])
        left = left + bracket * found[-1]
    return found


def _scaled(series: fmpq_series, q: fmpq, shift: int) -> fmpq_series:
    """Return sum s_k q^((shift - k)/2) eps^k of a series whose powers all have the parity of `shift`."""
    terms = [series[k] * (q ** ((shift - k) // 2) if series[k] else 0) for k in range(series.length())]
    return fmpq_series(terms)


def _polynomial(coefficients: list[fmpq]) -> arb_poly:
    """Return c_1 x + c_2 x^2 + ..., a function of balls, with coefficients at the precision that is set."""
    return arb_poly([0, *coefficients])
