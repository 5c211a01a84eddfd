"""Steps about the 1/t law with an error, from what one cycle adds to it (a1 = 0, every mass ratio)."""

from __future__ import annotations

from functools import cache

import sympy as sp
from flint import arb

from paper_checks.engines.balls import point, precision, shown
from paper_checks.engines.exact import identity
from paper_checks.evidence.clause import Formula
from paper_checks.evidence.evidence import Evidence, EvidenceKind, argument
from paper_checks.steps.excursions import angle_of_excursion, never_merges
from paper_checks.steps.monotone_slips import landings
from paper_checks.steps.rate import one_cycle
from paper_checks.steps.rate_error import ranges
from theory.long_time import abel_defect, leading_coefficient, map_coefficients
from theory.near_critical import cycle
from theory.symbols import epsilon, q, r

EXCESS, SHARE, LOST = sp.symbols("y_0 r s", positive=True)


@cache
def one_more_cycle() -> Evidence:
    """What a cycle adds to both sides of the law, in the numbers that are enclosed."""
    first = map_coefficients()[0]
    after = EXCESS * (1 - r * LOST)
    return argument(
        "With $s=c^2/y$ a cycle takes $y$ to $y'=y(1-rs)$ and adds $1+G$ to $\\frac{1}{\\alpha y}+B\\ln y$, $G=\\frac{4}{9}\\frac{s/y}{1-rs}"
        "-1+(1-\\frac{2}{5r})\\ln(1-rs)$, and $\\pi+F$ to the time, $F=\\sqrt q\\,\\theta-\\arctan\\sqrt{w'}-\\arctan\\frac{-V'}{X'}$.",
        *angle_of_excursion(),
        *never_merges(),
        *landings()[3:],
        *one_cycle(),
        identity(
            r"$\frac{1}{\alpha y'}-\frac{1}{\alpha y}=\frac{4}{9}\,\frac{s/y}{1-rs}$ with $\alpha=\frac{9r}{4}$",
            (1 / after - 1 / EXCESS) / first,
            sp.Rational(4, 9) * LOST / EXCESS / (1 - r * LOST),
        ),
        identity(r"$\frac{\pi}{\alpha y}=\frac{C}{w}$", sp.pi / first * q, leading_coefficient()),
        identity(r"$G=O(y^2)$", abel_defect()),
        identity(
            r"$F=O(y^{3/2})$",
            sp.Matrix([sp.expand(cycle().cycle_duration).coeff(epsilon, n) for n in range(3)]),
            sp.Matrix([sp.pi, 0, 0]),
        ),
    )


@cache
def enclosed() -> Evidence:
    """The bounds of both quotients."""
    (low, high), (short, long) = ranges()
    good = all(end.is_finite() for end in (low, high, short, long))
    texts = [f"{end.str(5, radius=False)}" for end in (low, high, short, long)]
    return Evidence(
        EvidenceKind.ENCLOSURE,
        "python-flint",
        r"for $0<\theta\leqslant\pi/2$ and every $r\in(0,1)$: bounds of $\pi G\,r/(y-y')$ and of $F\,r/(\sqrt y-\sqrt{y'})$, by Taylor "
        r"polynomials with Cauchy's estimate near $\theta=0$ and centred forms beyond",
        good,
        4,
        f"{texts[0]} to {texts[1]}, and {texts[2]} to {texts[3]}",
    )


@cache
def law_with_error() -> Evidence:
    """The bounds of R_n."""
    return argument(
        "Along the exits $y$ falls, so $\\sum(y_k-y_{k+1})\\leqslant y_0$ and $\\sum(\\sqrt{y_k}-\\sqrt{y_{k+1}})\\leqslant\\sqrt{y_0}$: what the "
        "cycles add, $\\pi G-F$ each, sums up to $R_n$ within the bounds of the quotients.",
        one_more_cycle(),
        enclosed(),
    )


def bounds_error(formula: Formula) -> Evidence:
    """Decide a bound of R_n of the form (A y0 + B sqrt(y0))/r: A and B exceed what the cycles can add, or fall short of it."""
    scaled = sp.expand(sp.sympify(formula.right) * SHARE)
    factors = [scaled.coeff(EXCESS), scaled.coeff(sp.sqrt(EXCESS))]
    rest = sp.simplify(scaled - factors[0] * EXCESS - factors[1] * sp.sqrt(EXCESS))
    (low, high), (short, long) = ranges()
    with precision(25):
        at_most, at_least = (high, -short), (low, -long)
        given = [point_of(one) for one in factors] if rest == 0 and all(one.is_Rational for one in factors) else None
        if given is None:
            passed = None
        elif formula.relation == "<=":
            passed = all(bool(one >= end.max(arb(0))) for one, end in zip(given, at_most, strict=True))
        elif formula.relation == ">=":
            passed = all(bool(one <= end.min(arb(0))) for one, end in zip(given, at_least, strict=True))
        else:
            passed = None
        text = ", ".join(shown(end, 6) for end in (*at_least, *at_most))
    return Evidence(
        EvidenceKind.ENCLOSURE, "python-flint", f"${formula.latex}$", passed, 2, f"least and largest: {text}"
    )


def point_of(value: sp.Rational) -> arb:
    """Return a ball around a rational number of sympy."""
    return point(int(value.p)) / point(int(value.q))
