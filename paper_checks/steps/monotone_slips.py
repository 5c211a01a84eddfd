"""Steps about every slip that starts on S: its one end, and what grows with its angle (a1 = 0, every mass ratio)."""

from __future__ import annotations

from functools import cache

import sympy as sp
from flint import arb

from paper_checks.engines.balls import precision, shown
from paper_checks.engines.exact import identity
from paper_checks.engines.roots import enclosed_root
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.formula import form, stating
from paper_checks.solvers.smt import prove
from paper_checks.steps.excursions import vanishes
from theory.excursion import guard_factors, h, half_tangent_form
from theory.return_map import (
    contact_condition,
    contact_slope,
    contact_slope_residual,
    depth,
    depth_slope_residual,
    gap,
    guard_residual,
    in_trigonometry,
    landing,
    landing_residuals,
    push,
    return_map_of_angle,
    return_map_residuals,
)
from theory.symbols import q, theta

ENGINE = "python-flint"


@cache
def contact() -> Evidence:
    """The guard with its root at the start divided out."""
    return stating(
        vanishes(
            r"the guard is $\sqrt q\,(1-\cos\theta)\,(h(\theta)-d\cot(\theta/2)-\nu)$: its root at the start is divided out, and the "
            "slip ends at the first zero of the last factor",
            guard_residual(),
        ),
        form("0", contact_condition()),
        form("h", h()),
    )


@cache
def one_contact() -> tuple[Evidence, ...]:
    """The last factor rises from below zero to infinity."""
    push_slope, gap_slope = contact_slope()
    at_zero = sp.limit(contact_condition().subs(gap, 1), theta, 0, "+")
    at_turn = sp.limit(contact_condition().subs({gap: 1, push: 0}), theta, 2 * sp.pi, "-")
    return (
        stating(
            vanishes(
                r"it rises: its derivative is $h'+\frac{d}{1-\cos\theta}$, $d\geqslant 0$", contact_slope_residual()
            ),
            form("derivative", push_slope + gap_slope),
        ),
        Evidence(
            EvidenceKind.EXACT,
            "sympy",
            r"from $-\infty$ (from $-\nu<0$, if $d=0$) at $\theta=0$ to $\infty$ at $\theta=2\pi$: one zero, and there only the guard ends",
            (at_zero, at_turn) == (-sp.oo, sp.oo),
            2,
            "both limits at d = 1 are unbounded with these signs"
            if (at_zero, at_turn) == (-sp.oo, sp.oo)
            else "other limits",
        ),
    )


@cache
def landings() -> tuple[Evidence, ...]:
    """Where a slip ends, from the solution of the slip's differential equation."""
    claimed, (before, after) = landing(), return_map_of_angle()
    names = ("d' = -(d+c)", "u' = u-\\theta", "w'-w = -q\\,r\\,c\\,(c+2d)")
    forms = (("d'", claimed.gap), ("u'", claimed.push), ("w' - w", claimed.excess_change))
    ends = [
        stating(vanishes(f"at the end ${name}$", residual), form(*closed))
        for name, residual, closed in zip(names, landing_residuals(), forms, strict=True)
    ]
    start, end = return_map_residuals()
    return (
        *ends,
        stating(vanishes("from a ray, with $y=w/q$: $y=h^2$", start), form("y", before)),
        stating(vanishes("and $y'=h^2-r\\,c^2$", end), form("y'", after)),
    )


def cusa_huygens() -> sp.Expr:
    """Return theta (2 + cos theta) - 3 sin theta, which the inequality of Cusa and Huygens says is positive."""
    return theta * (2 + sp.cos(theta)) - 3 * sp.sin(theta)


@cache
def rise_is_convex() -> tuple[Evidence, ...]:
    """h'' > 0 by the inequality of Cusa and Huygens, itself proved here."""
    slope = 4 * sp.sin(theta / 2) * (sp.sin(theta / 2) - theta / 2 * sp.cos(theta / 2))
    difference = (sp.diff(cusa_huygens(), theta) - slope).subs(theta, 2 * theta)
    return (
        vanishes(
            r"$h''=\frac{\theta(2+\cos\theta)-3\sin\theta}{(1-\cos\theta)^2}$",
            sp.diff(h(), theta, 2) - cusa_huygens() / (1 - sp.cos(theta)) ** 2,
        ),
        vanishes(
            r"Cusa–Huygens, $\theta(2+\cos\theta)-3\sin\theta>0$: its derivative is "
            r"$4\sin\frac{\theta}{2}\,(\sin\frac{\theta}{2}-\frac{\theta}{2}\cos\frac{\theta}{2})>0$ on $(0,2\pi)$",
            difference,
        ),
        identity("and it is $0$ at $\\theta=0$", cusa_huygens().subs(theta, 0)),
    )


@cache
def depth_grows() -> tuple[Evidence, ...]:
    """c' = h > 0 from 0 to infinity; c is concave in y = h^2."""
    limits = sp.limit(depth(), theta, 0, "+"), sp.limit(depth(), theta, 2 * sp.pi, "-")
    slope = half_tangent_form(sp.diff(in_trigonometry(depth()), theta) / sp.diff(h() ** 2, theta))
    return (
        stating(vanishes("$c'=h>0$", depth_slope_residual()), form("c", depth())),
        Evidence(
            EvidenceKind.EXACT,
            "sympy",
            r"$c\to 0$ as $\theta\to 0$ and $c\to\infty$ as $\theta\to 2\pi$",
            limits == (0, sp.oo),
            2,
            "0 and unbounded" if limits == (0, sp.oo) else "other limits",
        ),
        vanishes(
            r"$\frac{dc}{dy}=\frac{1}{2h'}$ with $y=h^2$, which falls as $h'$ rises: $c$ is concave in $y$, and $c/y$ falls, as $c(0)=0$",
            slope - half_tangent_form(1 / (2 * sp.diff(h(), theta))),
        ),
    )


def turning_angle() -> arb:
    """Return theta_v in (pi, 2 pi) with tan theta = theta, enclosed; call inside `precision`."""
    return enclosed_root(lambda x: x.sin() - x * x.cos(), 4, 5)


@cache
def turns_back() -> tuple[Evidence, ...]:
    """V' = sqrt(q)(h - theta) changes its sign once, at theta_v."""
    velocity = sp.sin(theta) - theta * sp.cos(theta)
    with precision():
        root = turning_angle()
        share = 2 / (1 + (1 + root * root).sqrt())
        inside = root > arb.pi() and root < 3 * arb.pi() / 2
    return (
        vanishes(
            r"at re-entry $V'=\sqrt q\,(h-\theta)=-\sqrt q\,\frac{\sin\theta-\theta\cos\theta}{1-\cos\theta}$",
            (landing().push.subs(push, h()) * (1 - sp.cos(theta)) + velocity),
        ),
        identity(
            r"$\sin\theta-\theta\cos\theta$, with the derivative $\theta\sin\theta$, rises from $0$ on $(0,\pi)$ and falls to $-2\pi$ on "
            r"$(\pi,2\pi)$: one zero, $\tan\theta_v=\theta_v$",
            sp.Matrix([sp.diff(velocity, theta), velocity.subs(theta, 0), velocity.subs(theta, 2 * sp.pi)]),
            sp.Matrix([theta * sp.sin(theta), 0, -2 * sp.pi]),
        ),
        Evidence(
            EvidenceKind.ENCLOSURE,
            ENGINE,
            r"$\theta_v\in(\pi,3\pi/2)$",
            bool(inside),
            1,
            f"theta_v = {shown(root)}",
        ),
        Evidence(
            EvidenceKind.ENCLOSURE,
            ENGINE,
            r"$c(\theta_v)=1+\sqrt{1+\theta_v^2}$, so $\theta_v<\theta_c(q)$, $c(\theta_c)=2/q$, exactly for $q<2/(1+\sqrt{1+\theta_v^2})$",
            bool(share > 0 and share < 1),
            1,
            f"q_v = 2/(1 + sqrt(1 + theta_v**2)) = {shown(share)}",
        ),
    )


@cache
def stays_or_crosses() -> tuple[Evidence, ...]:
    """X' = 1 - q c meets -1 at one angle beyond pi; inside S0 above E_cr the velocity keeps its sign."""
    position, velocity = sp.symbols("X V", real=True)
    return (
        identity(
            r"$c(\pi)=2$ and $X'=1-q\,c$: with $c$ rising to $\infty$, $X'=-1$ at one angle $\theta_c(q)\in(\pi,2\pi)$",
            depth().subs(theta, sp.pi),
            2,
        ),
        prove(
            r"on $S_0$ above $E_{cr}$, $X^2+V^2>1$ with $|X|\leqslant 1$: $V\neq 0$, so the stick moves on to the edge that $V'$ points to",
            [sp.Gt(position**2 + velocity**2, 1), sp.Le(position**2, 1)],
            sp.Ne(velocity, 0),
        ),
    )


def first_factor_positive() -> Evidence:
    """The factor divided out has no zero inside (0, 2 pi)."""
    return identity(
        r"the factor divided out is $\sqrt q\,(1-\cos\theta)>0$", guard_factors()[0], sp.sqrt(q) * (1 - sp.cos(theta))
    )
