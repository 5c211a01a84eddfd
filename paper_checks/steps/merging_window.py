"""Steps about the energies on S0 that merge at the first re-entry, for shares r = m2/M above r* (a1 = 0)."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import sympy as sp
from flint import arb

from paper_checks.engines.balls import point, precision, shown
from paper_checks.engines.roots import enclosed_root
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.solvers.smt import prove
from paper_checks.steps.critical_share import ENGINE, half_angle
from paper_checks.steps.excursions import vanishes
from paper_checks.steps.excursions_in_balls import depth, rise
from theory.excursion import angle
from theory.merging import half_angle_form, ratio, ray_excess, share

SHARES = (Fraction(3, 5), Fraction(7, 10), Fraction(4, 5), Fraction(9, 10), Fraction(99, 100), Fraction(1))
DIGITS = 30


@cache
def sign_of_excess() -> tuple[Evidence, ...]:
    """w' on the ray has the sign of R^2 - r; where it is not positive the pair is on S0."""
    position, velocity = sp.symbols("X V", real=True)
    deep = 2 * (1 - angle * sp.cos(angle) / sp.sin(angle))
    return (
        vanishes(
            r"$w'/q=c^2\,(R^2-r)$: the pair merges at this re-entry exactly if $R^2\leqslant r$, that is on one closed interval of angles",
            half_angle_form(ray_excess() - deep**2 * (ratio() ** 2 - share)),
        ),
        prove(
            r"$w'\leqslant 0$ on $S$, $X^2+V^2\leqslant 1$, is on $S_0$: the pair sticks there, for ever",
            [sp.Le(position**2 + velocity**2, 1)],
            sp.Le(position**2, 1),
        ),
    )


@cache
def never_from_below() -> tuple[Evidence, ...]:
    """Below the window 0 < y' < y: the same holds again after every excursion."""
    rise_value, deep, y_a = sp.symbols("h c y_a", positive=True)
    return (
        prove(
            r"for $\theta<\theta_a$, where $R^2>r$: $0<y'=h^2-r\,c^2<y=h^2<y_a$, and so on without end: each "
            r"re-enters $S_0$, as $c$ rises with $\theta$ and $w'=0$ at $\theta_a$ puts its end into $|X'|\leqslant 1$",
            [sp.Lt(share, 1), sp.Gt(rise_value**2, share * deep**2), sp.Lt(rise_value**2, y_a)],
            sp.And(
                sp.Gt(rise_value**2 - share * deep**2, 0, evaluate=False),
                sp.Lt(rise_value**2 - share * deep**2, y_a, evaluate=False),
            ),
        ),
    )


def window(value: arb) -> tuple[arb, arb]:
    """Return (theta_a, theta_b) for a share above r*, the roots of h = sqrt(r) c; call inside `precision`."""
    turning = Fraction(379727574, 10**8)

    def excess(theta: arb) -> arb:
        return rise(theta) - value.sqrt() * depth(theta)

    return (
        enclosed_root(excess, Fraction(1, 2), turning, DIGITS),
        enclosed_root(excess, turning, Fraction(628, 100), DIGITS),
    )


@cache
def windows() -> Evidence:
    """Both roots and the interval of y = w/q for some shares, and in the limit r = 1, m1/m2 -> 0."""
    texts = []
    with precision(DIGITS):
        straddled = True
        for one in SHARES:
            low, high = window(point(one))
            straddled = straddled and bool(low < 2 * half_angle() and high > 2 * half_angle())
            levels = ", ".join(shown(rise(theta) ** 2, 25) for theta in (low, high))
            texts.append(f"r = {one}: w/q from and to {levels}")
    return Evidence(
        EvidenceKind.ENCLOSURE,
        ENGINE,
        r"$\theta_a<\theta^*<\theta_b$ and the interval of $w/q$ that merges at the first re-entry, for some shares $r$ and in the limit $r=1$ "
        r"($m_1/m_2\to 0$)",
        straddled,
        len(SHARES),
        "; ".join(texts),
    )
