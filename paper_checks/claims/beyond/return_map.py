"""The return map from ray to ray as a power series with rational coefficients, and what its first terms leave out."""

from collections.abc import Iterator
from math import factorial
from typing import Any, NamedTuple

import flint
from flint import arb_series, fmpq, fmpq_series

from numerics.arithmetic.precision import series_terms
from paper_checks.claims.letters import C, H, R, in_angle, of_share
from paper_checks.claims.words import *
from theory.excursion import h
from theory.near_critical import cycle
from theory.return_map import (
    depth,
    depth_series,
    in_trigonometry,
    return_map_of_angle,
    scaled_excess,
)

ORDER = 8
LEFT_OUT = r"\tfrac{r}{3}(9y/4)^9"
"""Bound of what the terms after y^8 add to y', for slip angles up to 2."""


TERMS, TAIL = 24, "1e-30"
"""Terms of the entire functions, and a bound of what the others add to them and to their first Taylor coefficients there."""


EDGE, GROWTH = Fraction(1, 16), Fraction(33, 32)
"""End of the first box of slip angles, and how far apart the ends of the others are."""


def printed_depth_coefficients() -> tuple[Rational, ...]:
    """Return the coefficients of c that the theorem states."""
    return Rational(3, 2), -Rational(27, 40), Rational(243, 560)


def lost_coefficients() -> tuple[Rational, ...]:
    """Return the coefficients of c^2, from y^2 to y^ORDER: y' is y less r times this."""
    series = depth_series(ORDER - 1)
    return tuple(sum((series[i] * series[n - 2 - i] for i in range(n - 1)), Integer(0)) for n in range(2, ORDER + 1))


class Slip(NamedTuple):
    """A slip from a ray as power series in its angle: theta, h/theta and c/theta^2."""

    theta: Any
    rise: Any
    sink: Any

    @property
    def height(self) -> Any:
        """H."""
        return self.theta * self.rise

    @property
    def depth(self) -> Any:
        """C."""
        return self.theta * self.theta * self.sink


def slip_at(theta: Any) -> Slip:
    """Return the slip at a power series by three entire functions, whose quotients have no gap at theta = 0."""
    sine, versine, lag = (_entire(numbers, theta) for numbers in zip(*map(_coefficients, range(TERMS)), strict=True))
    return Slip(theta, sine / versine, lag / versine)


def _coefficients(k: int) -> tuple[fmpq, fmpq, fmpq]:
    """Return those of theta^(2k) in (theta - sin)/theta^3, (1 - cos)/theta^2 and (2 - 2 cos - theta sin)/theta^4."""
    odd, even = (-1) ** k * fmpq(1, factorial(2 * k + 3)), (-1) ** k * fmpq(1, factorial(2 * k + 4))
    return odd, (-1) ** k * fmpq(1, factorial(2 * k + 2)), odd - 2 * even


def _entire(numbers: tuple[fmpq, ...], theta: Any) -> Any:
    total = theta * 0
    for one in reversed(numbers):
        total = total * theta * theta + one
    return total if isinstance(theta, fmpq_series) else total + arb_series([arb(0, TAIL)] * flint.ctx.cap)


def less(value: Callable[[Slip], Any], coefficients: tuple[Rational, ...], power: int) -> Callable[[Slip], Any]:
    """Return a value less a polynomial in y = h^2, whose first coefficient is that of y^power."""
    exact = [fmpq(int(one.p), int(one.q)) for one in coefficients]

    def defect(slip: Slip) -> Any:
        y = slip.height * slip.height
        total = y * 0
        for one in reversed(exact):
            total = total * y + one
        return value(slip) - total * y**power

    return defect


def at_most(defect: Callable[[Slip], Any], order: int) -> arb:
    """Bound |defect|/h^order for slip angles up to 2, where the defect has a zero of this order at 0.

    Up to EDGE by Lagrange's remainder, on every box beyond by Taylor's formula about its middle. Infinite where the zero at 0
    is of a lower order.
    """
    with series_terms(order + 8):
        below = defect(slip_at(fmpq_series([0, 1])))
    if any(below[n] != 0 for n in range(order)):
        return arb("inf")
    with precision(40), series_terms(order + 1):
        near = slip_at(arb_series([arb(0).union(point(EDGE)), 1]))
        top = (abs(defect(near)[order]) / near.rise[0].lower() ** order).upper()
        for box in _boxes():
            middle, along = arb(box.mid()), slip_at(arb_series([box, 1]))
            value, at_middle = defect(along)[order], defect(slip_at(arb_series([middle, 1])))
            for n in reversed(range(order)):
                value = value * (box - middle) + at_middle[n]
            top = top.max((abs(value) / along.height[0].lower() ** order).upper())
        return top


def _boxes() -> Iterator[arb]:
    low = EDGE
    while low < 2:
        yield point(low).union(point(low * GROWTH))
        low *= GROWTH


@cache
def remainders() -> Steps:
    """What the first terms of c and of c^2 leave out."""
    beyond = at_most(less(lambda slip: slip.depth, printed_depth_coefficients(), 1), 8)
    lost = at_most(less(lambda slip: slip.depth * slip.depth, lost_coefficients(), 2), 2 * ORDER + 2)
    method = "Lagrange's remainder near $0$, Taylor's formula on boxes beyond, after exact coefficients"
    return (
        enclosed(
            rf"for $0<\theta\leqslant 2$: $|c-\tfrac{{3}}{{2}}y+\tfrac{{27}}{{40}}y^2-\tfrac{{243}}{{560}}y^3|\leqslant\tfrac{{1}}{{2}}y^4$, $y=h^2$ ({method})",
            bool(beyond < point(Fraction(1, 2))),
            f"at most {beyond.str(5)} y**4",
        ),
        enclosed(
            rf"for $0<\theta\leqslant 2$: $|c^2-P_8(y)|\leqslant\tfrac{{1}}{{3}}(9y/4)^9$, $P_8$ the terms of $c^2$ up to $y^8$ ({method})",
            bool(lost < point(Fraction(1, 3) * Fraction(9, 4) ** 9)),
            f"at most {lost.str(5)} y**9",
        ),
    )


SHARES, PARTS = 24, 32
"""Boxes of sqrt q, and of the slip angle, on which the time is enclosed."""


def delay(slip: Slip, root: Any, atan: Callable[[Any], Any], sqrt: Callable[[Any], Any]) -> Any:
    """Return the reduced time of a cycle less pi, by the slip and sqrt q, and less its first term."""
    rest, share = 1 - root * root, slip.theta * slip.sink / slip.rise
    onward = root * slip.height * sqrt(1 - rest * share * share)
    inward = root * slip.theta * (1 - slip.rise) / (1 - root * root * slip.depth)
    return root * slip.theta - atan(onward) - atan(inward) - rest * root * slip.height**3 * 9 / 8


@cache
def cycle_time() -> Steps:
    """The reduced time of slip and stick, and what its first term leaves out."""
    root = Symbol("p", positive=True)
    near = Slip(theta, taylor(h() / theta, theta, 5), taylor(in_trigonometry(depth()) / theta**2, theta, 5))
    first = taylor(delay(near, root, sp.atan, sp.sqrt), theta, 5)
    top = arb(0)
    with precision(20), series_terms(6):
        for m in range(SHARES):
            share = point(Fraction(m, SHARES)).union(point(Fraction(m + 1, SHARES)))
            for n in range(PARTS):
                box = point(Fraction(n, PARTS)).union(point(Fraction(n + 1, PARTS)))
                rest = delay(slip_at(arb_series([box, 1])), share, arb_series.atan, arb_series.sqrt)
                top = top.max(abs(rest[5]).upper())
    return (
        identity(
            r"$\sqrt q\,\theta-\arctan(\sqrt q\sqrt{h^2-r\,c^2})-\arctan\frac{\sqrt q\,(\theta-h)}{1-q\,c}-\frac{9r}{8q}(q\,h^2)^{3/2}=O(\theta^5)$",
            first,
            0,
        ),
        enclosed(
            r"for $0<\theta\leqslant 1$ and every mass ratio it is at most $\theta^5$ in size (Lagrange's remainder)",
            bool(top < 1),
            f"at most {top.str(5)} theta**5",
            SHARES * PARTS,
        ),
    )


@theorem(
    "return-map-expansion",
    clause(
        "map",
        r"With $y=w/q$ the return map from ray to ray is «map» while $\theta\leqslant\pi$ and $y'>0$,",
        map=in_angle("y'", H**2 - R * C**2, lambda: return_map_of_angle()[1]),
        kernel="cycle",
    ),
    clause(
        "series",
        r"where for every mass ratio «series», up to at most $\tfrac{1}{2}y^4$ for $\theta\leqslant 2$.",
        series=equal(
            "c",
            Rational(3, 2) * scaled_excess
            - Rational(27, 40) * scaled_excess**2
            + Rational(243, 560) * scaled_excess**3,
            lambda: sum(one * scaled_excess**n for n, one in enumerate(depth_series(3), start=1)),
        ),
    ),
    clause("remainder", rf"The terms of $c^2$ after $y^8$ add at most ${LEFT_OUT}$ to $y'$ for $\theta\leqslant 2$,"),
    clause(
        "time",
        r"and the reduced time of a cycle is «time», up to at most $\theta^5$ for $\theta\leqslant 1$.",
        time=of_share(
            "T",
            pi + 9 * R / (8 * q) * w ** Rational(3, 2),
            lambda: sum(expand(cycle().cycle_duration).coeff(epsilon, n) * sqrt(w) ** n for n in range(4)),
        ),
    ),
)
def return_map_expansion() -> Case:
    """c as one power series in y; the mass ratio enters as a factor only."""
    beyond, lost = remainders()
    return because(
        r"""
        One power series with rational coefficients gives the return map of every pair; the mass ratio is a factor in
        it. $h^2$ and $c$ are even analytic functions of the slip angle, $h^2=\theta^2/9+\cdots$, so $c$ is a power
        series in $y=h^2$ without any parameter, and $y'=y-r\,c^2$. Its Taylor polynomials are exact.
        """,
        carried("series", beyond),
        carried("remainder", lost),
        carried("time", kernel.step("cycle-time-exact"), cycle_time),
    )
