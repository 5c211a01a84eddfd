"""Steps about one slip excursion from a ray, valid for every mass ratio, and enclosed runs of many of them (a1 = 0)."""

from __future__ import annotations

from fractions import Fraction
from itertools import islice

import sympy as sp

from numerics.arithmetic.ball import Ball
from numerics.excursion_map import excursions
from numerics.scaling import Frame
from numerics.scene import Pair
from paper_checks.evidence import Evidence, EvidenceKind
from paper_checks.exact import identity
from paper_checks.smt import prove
from theory.excursion import (
    angle,
    displacement_of_angle,
    displacement_slope,
    energy_balance,
    excursion,
    guard_factors,
    guard_of_u,
    h,
    h_limits,
    h_slope,
    half_angle_slope,
    half_tangent_form,
    next_excess,
    next_excess_slope,
)
from theory.rate_bounds import no_merging_excess, reentry_depth
from theory.symbols import h_value, q, theta


def vanishes(statement: str, expression: sp.Expr) -> Evidence:
    """Return that an expression in theta, sin theta, cos theta is 0: decided by its form in theta and tan(theta/2)."""
    form = half_tangent_form(expression.subs(sp.tan(theta / 2), sp.sin(theta) / (1 + sp.cos(theta))))
    value = "0 as a fraction in theta, tan(theta/2)" if form == 0 else f"{form}"
    return Evidence(EvidenceKind.EXACT, "sympy", statement, form == 0, 1, value)


def angle_of_excursion() -> list[Evidence]:
    """The excursion ends at the one angle with h(theta) = u; h rises from 0 to infinity on (0, 2 pi)."""
    factor, increment = half_angle_slope()
    return [
        vanishes(
            r"the guard is $(1-\cos\theta)(h(\theta)-u)$: its double root at the start divided out",
            guard_of_u() - (1 - sp.cos(theta)) * (h() - h_value),
        ),
        identity(
            r"$h'(2\varphi)=(\sin\varphi-\varphi\cos\varphi)/\sin^3\varphi$",
            h_slope().subs(theta, 2 * angle),
            increment / sp.sin(angle) ** 3,
        ),
        identity(
            r"$\sin\varphi-\varphi\cos\varphi$ has the derivative $\varphi\sin\varphi>0$ on $(0,\pi)$ and is 0 at 0, so $h'>0$",
            sp.diff(increment, angle),
            angle * sp.sin(angle),
        ),
        identity(r"$\sin\varphi-\varphi\cos\varphi=0$ at $\varphi=0$", increment.subs(angle, 0), 0),
        Evidence(
            EvidenceKind.EXACT,
            "sympy",
            r"$h\to 0$ as $\theta\to 0$ and $h\to\infty$ as $\theta\to 2\pi$",
            h_limits() == (0, sp.oo),
            2,
            f"limits {h_limits()[0]} and {'unbounded' if h_limits()[1] == sp.oo else h_limits()[1]}",
        ),
        identity("the positive factor of $h'$ is $1/\\sin^3\\varphi$", factor, 1 / sp.sin(angle) ** 3),
        vanishes(
            "the guard's double root is $1-\\cos\\theta$ up to a constant",
            guard_factors()[0] / guard_factors()[0].subs(theta, sp.pi) * 2 - (1 - sp.cos(theta)),
        ),
    ]


def never_merges() -> list[Evidence]:
    """From a ray with w <= q (pi/2 - 1)^2 an excursion ends inside S0 with 0 < w' < w, for every mass ratio."""
    cosine, fraction = sp.symbols("c q", real=True)
    slope = sp.prod(next_excess_slope())
    step = sp.prod(displacement_slope())
    return [
        vanishes(r"$dw'/d\theta=2q\,h\,h'\,(1-r(1-\cos\theta))$", sp.diff(next_excess(), theta) - slope),
        prove(
            r"$1-r(1-\cos\theta)>0$ for $\theta\leqslant\pi/2$ and every mass ratio, so $w'$ rises with $\theta$ from 0",
            [sp.Gt(fraction, 0), sp.Lt(fraction, 1), sp.Ge(cosine, 0), sp.Le(cosine, 1)],
            sp.Gt(1 - (1 - fraction) * (1 - cosine), 0, evaluate=False),
        ),
        identity("$w'\\to 0$ as $\\theta\\to 0$", sp.limit(next_excess(), theta, 0, "+"), 0),
        vanishes("$w-w'=2r\\,q\\,D(\\theta)$: the friction work", energy_balance()),
        vanishes(r"$D'=(\theta-\sin\theta)\,h'>0$, so $w'<w$", sp.diff(displacement_of_angle(), theta) - step),
        identity("$D\\to 0$ as $\\theta\\to 0$", sp.limit(displacement_of_angle(), theta, 0, "+"), 0),
        vanishes(
            r"at re-entry $1-X=q(2-\theta\cot(\theta/2))$, which lies in $(0,2)$ for $\theta\leqslant\pi$: inside $S_0$",
            1 - excursion().position - reentry_depth(),
        ),
        identity(
            r"the level at $\theta=\pi/2$ is $w=q(\pi/2-1)^2$",
            no_merging_excess(),
            q * (sp.pi / 2 - 1) ** 2,
        ),
    ]


def no_merging_at_any_energy() -> Evidence:
    """For m2 <= m1 the factor 1 - r (1 - cos theta) is never negative: no excursion from a ray merges by re-entry."""
    cosine, share = sp.symbols("c r", real=True)
    return prove(
        r"for $m_2\leqslant m_1$, $1-r(1-\cos\theta)\geqslant 0$ at every angle, so $w'>0$ after every excursion from a ray",
        [sp.Gt(share, 0), sp.Le(2 * share, 1), sp.Ge(cosine, -1), sp.Le(cosine, 1)],
        sp.Ge(1 - share * (1 - cosine), 0, evaluate=False),
    )


def enclosed_rate(share: Fraction, start: Fraction, count: int, tolerance: Fraction) -> Evidence:
    """Enclose tau w over its limit 4 pi q/(9 r) after many excursions, for m1/M = share and excess `start`."""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        tau = w = arithmetic.number(start)
        tau = arithmetic.number(0)
        for one in islice(excursions(frame, w), count):
            tau, w = tau + one.slip + one.stick, one.w_after
        ratio = tau * w * 9 * frame.r / (4 * arithmetic.pi() * frame.q)
        near = abs(ratio - 1) < arithmetic.number(tolerance)
        text = str(ratio.mid().str(12, radius=False))
    return Evidence(
        EvidenceKind.ENCLOSURE,
        "numerics, balls",
        f"$m_1/M={share}$, $w_0={start}$: after {count} excursions $\\tau w$ over its limit is within {float(tolerance):.0%} of 1",
        bool(near),
        count,
        text,
    )


def enclosed_creep(share: Fraction, start: Fraction, count: int) -> Evidence:
    """Enclose the excess over many excursions: positive and falling, all re-entries inside S0."""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        run = list(islice(excursions(frame, arithmetic.number(start)), count))
        good = len(run) == count and all(one.w_after > 0 and one.w_after < one.w for one in run)
        last = str(run[-1].w_after.mid().str(12, radius=False))
    return Evidence(
        EvidenceKind.ENCLOSURE,
        "numerics, balls",
        f"$m_1/M={share}$, from $w={float(start):.6g}$: {count} excursions, each with $0<w'<w$",
        bool(good),
        count,
        f"w = {last} after the last",
    )
