"""The return map from ray to ray as a power series with rational coefficients."""

from collections.abc import Iterator
from fractions import Fraction
from functools import cache

import sympy as sp
from flint import acb, arb, fmpq, fmpq_series

from numerics.arithmetic.precision import series_terms
from paper_checks.claims.beyond.slips import depth_grows, landings, rise_is_convex
from paper_checks.claims.letters import C, H, R, in_angle, of_share
from paper_checks.claims.words import *
from paper_checks.decide.balls import point, precision
from theory.near_critical import cycle
from theory.return_map import depth_series, return_map_of_angle, return_map_series, scaled_excess

ORDER = 8
RADIUS = 2
"""Radius of the disc of slip angles on whose rim the remainder is bounded; h and c are analytic up to 2 pi."""


ARCS = 512
LEFT_OUT = r"\tfrac{r}{3}(9y/4)^9"
"""Bound of what the terms after y^8 add to y', for 0 < y <= 4/9."""


def printed_depth_coefficients() -> tuple[Rational, ...]:
    """Return the coefficients of c that the theorem states."""
    return Rational(3, 2), -Rational(27, 40), Rational(243, 560)


@cache
def coefficients() -> Steps:
    """c(y) and y'(y) with exact coefficients."""
    found = depth_series(ORDER - 1)
    polynomial = expand(return_map_series(ORDER))
    scaled = sp.collect(expand(q * polynomial.subs(Symbol("y", positive=True), w / q)), w, sp.factor)
    return (
        stating(
            identity(
                r"$c=\tfrac{3}{2}y-\tfrac{27}{40}y^2+\tfrac{243}{560}y^3-\cdots$ in powers of $y=h^2$",
                found[:3],
                printed_depth_coefficients(),
            ),
            form("coefficients of c", list(found)),
        ),
        identity(
            r"$w'=w-\tfrac{9r}{4q}w^2+\tfrac{81r}{40q^2}w^3-\cdots$",
            [scaled.coeff(w, 2), scaled.coeff(w, 3)],
            [-9 * r / (4 * q), 81 * r / (40 * q**2)],
        ),
    )


def _divided(series: fmpq_series, power: int) -> fmpq_series:
    return fmpq_series([series[k] for k in range(power, series.length())])


def lost_coefficients() -> tuple[Rational, ...]:
    """Return the coefficients of c^2, from y^2 to y^ORDER: y' is y less r times this."""
    series = depth_series(ORDER - 1)
    return tuple(sum((series[i] * series[n - 2 - i] for i in range(n - 1)), Integer(0)) for n in range(2, ORDER + 1))


@cache
def remainder() -> Steps:
    """Bound c^2 less its Taylor polynomial on the rim |theta| = RADIUS; by Schwarz's lemma then inside."""
    with precision(20):
        lost = [arb(fmpq(int(c.p), int(c.q))) for c in lost_coefficients()]
        bound = arb(0)
        for theta in quarter_rim():
            half = theta / 2
            height = (theta - theta.sin()) / (2 * half.sin() ** 2)
            y = height * height
            value = (2 - theta * half.cot()) ** 2
            for n, term in enumerate(lost, start=2):
                value -= acb(term) * y**n
            bound = bound.max(abs(value).upper())
        text = f"|c**2 - polynomial| <= {bound.str(5)} on |theta| = {RADIUS}"
        small = bool(bound.is_finite() and bound < point(Fraction(1, 3)))
        printed = f"|y' - polynomial| <= r/3*(9*y/4)**{ORDER + 1} for 0 < y <= 4/9"
    return (
        identity(
            r"$c^2-P_8(y)$ has a zero of order $18$ at $\theta=0$: its coefficients, in exact series of $\theta$, vanish",
            defect_in_angle(),
        ),
        enclosed(
            f"$|c^2-P_8(y)|<\\tfrac{{1}}{{3}}$ on the rim $|\\theta|={RADIUS}$, where $h$ and $c$ are analytic inside; its zero at $0$ is of order "
            f"${2 * ORDER + 2}$ in $\\theta$ and $\\theta\\leqslant 3h$ ($h$ convex), so $|y'-P(y)|\\leqslant {LEFT_OUT}$ for $y\\leqslant 4/9$",
            small,
            f"{text}; {printed}",
            ARCS,
        ),
    )


def defect_in_angle() -> list[Rational]:
    """Return the coefficients of c^2 - P_8(h^2) in the slip angle below the power 2 ORDER + 2, exact."""
    with series_terms(2 * ORDER + 6):
        theta = fmpq_series([0, 1])
        sine, cosine = theta.sin(), theta.cos()
        height = _divided(theta - sine, 2) / _divided(1 - cosine, 2)
        depth = 2 - _divided(theta * sine, 2) / _divided(1 - cosine, 2)
        defect, y = depth * depth, height * height
        power = y
        for term in lost_coefficients():
            power = power * y
            defect = defect - power * fmpq(int(term.p), int(term.q))
        return [Rational(int(defect[n].p), int(defect[n].q)) for n in range(2 * ORDER + 2)]


def quarter_rim() -> Iterator[acb]:
    """Yield boxes that cover a quarter of the rim; the function is even and real on the real axis."""
    for k in range(ARCS):
        step = arb.pi() / (2 * ARCS)
        argument = step * (k + point(Fraction(1, 2))) + arb(0, (step / 2).upper())
        yield acb(RADIUS * argument.cos(), RADIUS * argument.sin())


@cache
def cycle_time() -> Evidence:
    """The reduced time of slip and stick as a series."""
    found = expand(cycle().cycle_duration)
    return stating(
        identity(
            r"the reduced time of a cycle is $\pi+\frac{9r}{8q}\varepsilon^3+O(\varepsilon^5)$, $\varepsilon=\sqrt w$",
            [found.coeff(epsilon, power) for power in range(4)],
            [pi, 0, 0, 9 * r / (8 * q)],
        ),
        form("cycle time", sp.collect(found, epsilon, sp.factor)),
    )


@theorem(
    "return-map-expansion",
    clause(
        "map",
        """
        With $y=w/q$ the return map from ray to ray is «map», where «series», up to $y^3$, is one power series with
        rational coefficients, the same for every mass ratio.
        """,
        map=in_angle("y'", H**2 - R * C**2, lambda: return_map_of_angle()[1]),
        series=equal(
            "c",
            Rational(3, 2) * scaled_excess
            - Rational(27, 40) * scaled_excess**2
            + Rational(243, 560) * scaled_excess**3,
            lambda: sum(one * scaled_excess**n for n, one in enumerate(depth_series(3), start=1)),
        ),
    ),
    clause(
        "remainder",
        f"The terms after $y^8$ add at most ${LEFT_OUT}$ to $y'$ for $0<y\\leqslant 4/9$,",
    ),
    clause(
        "time",
        r"and the reduced time of a cycle, up to $w^{3/2}$, is «time».",
        time=of_share(
            "T",
            pi + 9 * R / (8 * q) * w ** Rational(3, 2),
            lambda: sum(expand(cycle().cycle_duration).coeff(epsilon, n) * sqrt(w) ** n for n in range(4)),
        ),
    ),
)
def return_map_expansion() -> Case:
    """c as one power series in y; the mass ratio enters as a factor only."""
    terms = [
        f"{'+' if c > 0 and n > 1 else ''}{latex(c)}y^{{{n}}}" for n, c in enumerate(depth_series(ORDER - 1), start=1)
    ]
    return because(
        r"""
        One power series with rational coefficients gives the return map of every pair; the mass ratio is a factor in
        it. $h^2$ and $c$ are even analytic functions of the slip angle, $h^2=\theta^2/9+\cdots$, so $c$ is a power
        series in $y=h^2$ without any parameter, and $y'=y-r\,c^2$. Its Taylor polynomials are exact; the remainder is
        bounded in ball arithmetic on the rim of a disc and by Schwarz's lemma inside.
        """,
        *landings()[3:],
        *coefficients(),
        *rise_is_convex(),
        depth_grows()[0],
        *remainder(),
        cycle_time(),
        derivation=("$$c(y)=" + "".join(terms) + "+\\cdots$$",),
        figure="return-map",
    )
