"""Steps about the share r = m2/M beyond which merging by re-entry begins: all slips from S, every mass ratio (a1 = 0)."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import sympy as sp
from flint import arb

from paper_checks.engines.balls import point, precision, shown
from paper_checks.engines.exact import identity
from paper_checks.engines.roots import enclosed_root
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.formula import form, stating
from paper_checks.solvers.smt import prove
from paper_checks.steps.excursions import vanishes
from paper_checks.steps.excursions_in_balls import depth, rise
from theory.excursion import angle
from theory.merging import (
    critical_mass_ratio,
    critical_mass_ratio_residual,
    critical_share,
    half_path,
    least_excess,
    least_excess_residual,
    least_excess_slope_residual,
    next_excess,
    next_excess_residual,
    ratio,
    ratio_slope_residual,
    ray_residuals,
    share,
    slip_residuals,
    turning_function,
    turning_residual,
    turning_slope,
    turning_slope_residual,
    vertex,
    vertex_residual,
)
from theory.return_map import return_map_slope_residual

ENGINE = "python-flint"
SINE, COSINE, HALF = sp.symbols("s k phi", real=True)


@cache
def all_slips() -> tuple[Evidence, ...]:
    """Every slip from S by its half angle and half path; its excess after is a quadratic in the latter."""
    return (
        vanishes(
            r"with $\varphi=\theta/2$, $C=\varphi\cot\varphi$, $T=(d-d')/2$ every slip from $S$ has $1+d=C+T$, $u=\varphi-T\cot\varphi$, "
            r"$1+d'=C-T$, $u'=-\varphi-T\cot\varphi$; $d\geqslant 0$ is $T\geqslant 1-C$, with equality on the ray",
            sum(one**2 for one in slip_residuals()),
        ),
        stating(
            vanishes(r"$w'/q=T^2(\sin^{-2}\varphi-r)-2rT(1-C)+\varphi^2+C^2-1-r(1-C)^2$", next_excess_residual()),
            form("w'/q", next_excess()),
        ),
        identity(
            r"it falls with $r$: its derivative is $-(T+1-C)^2$, so what a share $r^*$ allows, every smaller share does",
            sp.diff(next_excess(), share),
            -((half_path + 1 - angle * sp.cos(angle) / sp.sin(angle)) ** 2),
        ),
    )


@cache
def worst_slip() -> tuple[Evidence, ...]:
    """The least w' over d >= 0 is on the ray where 2 r sin^2 <= 1, and at the vertex elsewhere, where it falls."""
    loaded = share * SINE**2
    unit = sp.Eq(SINE**2 + COSINE**2, 1)
    return (
        prove(
            r"$\sin^{-2}\varphi>r$: the quadratic is convex in $T$ ($s=\sin\varphi$)",
            [sp.Lt(share, 1), sp.Gt(SINE, 0), sp.Le(SINE, 1)],
            sp.Gt(1 - loaded, 0, evaluate=False),
        ),
        stating(
            vanishes(
                r"its vertex is at $T_v=(1-C)\,\frac{r\sin^2\varphi}{1-r\sin^2\varphi}$, which is at most $1-C$ (so the ray is the worst start) "
                r"exactly if $2r\sin^2\varphi=r(1-\cos\theta)\leqslant 1$",
                vertex_residual(),
            ),
            form("T_v", vertex()),
        ),
        stating(
            vanishes(
                r"the least value is $\varphi^2+C^2-1-\frac{r(1-C)^2}{1-r\sin^2\varphi}$", least_excess_residual()
            ),
            form("min w'/q", least_excess()),
        ),
        vanishes(
            r"its derivative in $\varphi$ is $\frac{2(1-C)(1-2r\sin^2\varphi)(\varphi-r(\varphi-\sin\varphi\cos\varphi))}"
            r"{\sin^2\varphi\,(1-r\sin^2\varphi)^2}$",
            least_excess_slope_residual(),
        ),
        prove(
            r"there $\varphi-r(\varphi-\sin\varphi\cos\varphi)>0$ if $2r\sin^2\varphi>1$ and $r<3/5$, so the least value falls "
            r"($s=\sin\varphi\leqslant\varphi$, $k=\cos\varphi$)",
            [sp.Lt(5 * share, 3), unit, sp.Gt(SINE, 0), sp.Ge(HALF, SINE), sp.Gt(2 * loaded, 1)],
            sp.Gt(HALF - share * (HALF - SINE * COSINE), 0, evaluate=False),
        ),
        vanishes(
            r"on the ray $dy'/dy=1-2r\sin^2\varphi$: $y'$ rises, falls where $2r\sin^2\varphi>1$, and rises again",
            return_map_slope_residual(),
        ),
        vanishes(r"on the ray $u=h$, $w'/q=h^2-r\,c^2$, $c=2(1-C)$", sum(one**2 for one in ray_residuals())),
    )


@cache
def one_turning_point() -> tuple[Evidence, ...]:
    """R = h/c falls from infinity to its one minimum sqrt(r*) and rises to infinity."""
    ends = sp.limit(ratio(), angle, 0, "+"), sp.limit(ratio(), angle, sp.pi, "-")
    first, second = turning_slope()
    return (
        stating(
            vanishes(
                r"with $R=h/c$: $\frac{dR}{d\varphi}=\sin^{-2}\varphi-2R^2$",
                ratio_slope_residual(),
            ),
            form("R", ratio()),
        ),
        vanishes(
            r"$2R^2\sin^2\varphi=\frac{A^2}{2B^2}$, $A=\varphi-\sin\varphi\cos\varphi$, $B=\sin\varphi-\varphi\cos\varphi$, both positive: $R$ falls "
            r"exactly where $K=A-\sqrt2B>0$",
            turning_residual(),
        ),
        identity(
            r"$K'=\sin\varphi\,(2\sin\varphi-\sqrt2\,\varphi)$",
            sp.Matrix(
                [turning_slope_residual(), first * second - sp.sin(angle) * (2 * sp.sin(angle) - sp.sqrt(2) * angle)]
            ),
            sp.Matrix([0, 0]),
        ),
        identity(
            r"$\sin\varphi/\varphi$ falls, with derivative $-B/\varphi^2$, so $K$ rises from $0$ and then falls to $\pi(1-\sqrt2)<0$: one zero "
            r"$\varphi^*$ in $(0,\pi)$",
            sp.Matrix(
                [
                    sp.diff(sp.sin(angle) / angle, angle) * angle**2,
                    turning_function().subs(angle, 0),
                    turning_function().subs(angle, sp.pi),
                ]
            ),
            sp.Matrix([angle * sp.cos(angle) - sp.sin(angle), 0, sp.pi * (1 - sp.sqrt(2))]),
        ),
        Evidence(
            EvidenceKind.EXACT,
            "sympy",
            r"$R\to\infty$ at both ends of $(0,\pi)$",
            ends == (sp.oo, sp.oo),
            2,
            "both unbounded" if ends == (sp.oo, sp.oo) else "other limits",
        ),
    )


def half_angle() -> arb:
    """Return phi*, the zero of K in (0, pi), enclosed; call inside `precision`."""
    root_two = arb(2).sqrt()
    return enclosed_root(
        lambda x: x - x.sin() * x.cos() - root_two * (x.sin() - x * x.cos()), Fraction(3, 2), Fraction(5, 2)
    )


def critical_value() -> arb:
    """Return r* = 1/(2 sin^2 phi*), enclosed; call inside `precision`."""
    return 1 / (2 * half_angle().sin() ** 2)


@cache
def threshold() -> tuple[Evidence, ...]:
    """r* and both mass ratios in closed form at the root, to 50 digits."""
    with precision():
        root, value = half_angle(), critical_value()
        theta = 2 * root
        ratios = (value, (1 - value) / value, value / (1 - value))
        agree = all(
            one.overlaps(other)
            for one, other in zip(
                ratios, ((rise(theta) / depth(theta)) ** 2, -theta.cos(), -1 / theta.cos()), strict=True
            )
        )
        names = ("r* = 1/(2*sin(phi*)**2)", "m1/m2 = -cos(theta*)", "m2/m1 = -1/cos(theta*)")
        texts = [
            f"theta* = {shown(theta)}",
            *(f"{name} = {shown(one)}" for name, one in zip(names, ratios, strict=True)),
        ]
        beyond = root > arb.pi() / 2 and value < point(Fraction(3, 5)) and value > point(Fraction(1, 2))
    return (
        identity(
            r"at $\varphi^*$, where $A=\sqrt2B$: $r^*=R^2=\frac{1}{2\sin^2\varphi^*}$, which is $r(1-\cos\theta^*)=1$",
            2 * critical_share() * sp.sin(angle) ** 2,
            1,
        ),
        stating(
            vanishes(r"so $m_1/m_2=(1-r^*)/r^*=2\sin^2\varphi^*-1=-\cos\theta^*$", critical_mass_ratio_residual()),
            form("m1/m2", critical_mass_ratio()),
        ),
        Evidence(
            EvidenceKind.ENCLOSURE,
            ENGINE,
            r"$\theta^*$, $r^*$ and both mass ratios at the threshold; $R(\theta^*)^2$, $-\cos\theta^*$ and $-1/\cos\theta^*$ agree with them",
            agree,
            3,
            "; ".join(texts),
        ),
        Evidence(
            EvidenceKind.ENCLOSURE,
            ENGINE,
            r"$\varphi^*>\pi/2$, so $\varphi^*$ is the upper end of $2r^*\sin^2\varphi>1$; $1/2<r^*<3/5$",
            bool(beyond),
            2,
            shown(value, 12),
        ),
    )
