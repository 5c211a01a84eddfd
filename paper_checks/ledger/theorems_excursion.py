"""Past the paper: every slip that starts on S, and the return map from ray to ray."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from paper_checks.engines.deciders import decimal, equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.ledger.theorem import C, H, R, in_angle, of_share, theorem
from theory.excursion import h, half_tangent_form
from theory.near_critical import cycle
from theory.return_map import (
    contact_condition,
    depth,
    depth_series,
    gap,
    in_trigonometry,
    landing,
    push,
    return_map_of_angle,
    scaled_excess,
)
from theory.scaling import to_si
from theory.symbols import epsilon, m1, m2, q, r, theta, w

if TYPE_CHECKING:
    from flint import arb


def _crossing_depth() -> sp.Expr:
    """Return the depth at which a slip from a ray ends at the other edge, X' = -1."""
    return sp.solve(1 + q * landing().gap.subs({gap: 0, depth(): C}) + 1, C)[0]


def _turning_angle() -> arb:
    from paper_checks.engines.balls import precision
    from paper_checks.steps.monotone_slips import turning_angle

    with precision():
        return turning_angle()


EXCURSIONS = (
    theorem(
        "excursion-closed-form",
        clause(
            "contact",
            r"Every slip that starts on $S$, mirrored to $x_1=L(1+q\,d)$, $v_1=v_2=L\Omega\sqrt q\,\nu$ with $d\geqslant 0$, "
            r"$v_1<v_2$ (and $\nu>0$ if $d=0$), ends at the one angle $\theta=\sqrt{a/m_1}\,t\in(0,2\pi)$ with «contact», «rise».",
            contact=in_angle(r"\nu", H - gap * sp.cot(theta / 2), lambda: sp.solve(contact_condition(), push)[0]),
            rise=Formula("h", "=", (theta - sp.sin(theta)) / (1 - sp.cos(theta)), equals(h)),
        ),
        clause(
            "landing",
            r"A slip with that $\nu$ for an angle $\theta$ ends there with «gap», «push» and «loss», where «depth», «share», «rest», $M=m_1+m_2$, $w=E/E_{cr}-1$.",
            share=Formula(q, "=", m1 / (m1 + m2), equals(lambda: to_si(q))),
            rest=Formula("r", "=", m2 / (m1 + m2), equals(lambda: to_si(r))),
            gap=in_angle("d'", -(gap + C), lambda: landing().gap),
            push=in_angle(r"\nu'", push - theta, lambda: landing().push),
            loss=in_angle("w'-w", -q * R * C * (C + 2 * gap), lambda: landing().excess_change),
            depth=Formula("c", "=", 2 - theta * sp.cot(theta / 2), equals(depth)),
            kernel=("gap-slip",),
        ),
        clause(
            "stays",
            r"From a ray a slip of the angle $\theta$ re-enters $S_0$ if $c(\theta)\leqslant c^*$, «edge», and crosses $S$ otherwise;",
            edge=Formula("c^*", "=", 2 / q, equals(_crossing_depth)),
            kernel=("re-entry", "ray-crossing"),
        ),
        clause(
            "leaves",
            r"having re-entered with $w'>0$ the pair leaves by the opposite ray if $\theta<\theta_v$, $\tan\theta_v=\theta_v$, "
            r"«turn», and by the same ray if $\theta>\theta_v$.",
            turn=Formula(r"\theta_v", "=...", sp.Rational("4.4934"), decimal(_turning_angle)),
        ),
    ),
    theorem(
        "excursion-monotone",
        clause(
            "rise",
            r"«rise» increases from $0$ to $\infty$ on $(0,2\pi)$ and is convex; the condition that ends a slip is monotone in "
            r"$\theta$ for every start on $S$;",
            rise=Formula("h", "=", (theta - sp.sin(theta)) / (1 - sp.cos(theta)), equals(h)),
        ),
        clause(
            "depth",
            r"the depth $c$, «slope», increases from $0$ to $\infty$ and is concave as a function of $y=h^2$. Exit speed, duration, "
            r"depth and energy lost of an excursion from a ray increase together.",
            slope=Formula(
                "c'",
                "=",
                H,
                equals(
                    lambda: half_tangent_form(sp.diff(in_trigonometry(depth()), theta)),
                    lambda: {H: half_tangent_form(h())},
                ),
            ),
        ),
    ),
    theorem(
        "return-map-expansion",
        clause(
            "map",
            r"With $y=w/q$ the return map from ray to ray is «map», where «series», up to $y^3$, is one power series with rational "
            r"coefficients, the same for every mass ratio.",
            map=in_angle("y'", H**2 - R * C**2, lambda: return_map_of_angle()[1]),
            series=Formula(
                "c",
                "=",
                sp.Rational(3, 2) * scaled_excess
                - sp.Rational(27, 40) * scaled_excess**2
                + sp.Rational(243, 560) * scaled_excess**3,
                equals(lambda: sum(one * scaled_excess**n for n, one in enumerate(depth_series(3), start=1))),
            ),
        ),
        clause(
            "remainder",
            r"What the terms after $y^8$ add to $y'$ is at most $\tfrac{r}{3}(9y/4)^9$ for $0<y\leqslant 4/9$,",
        ),
        clause(
            "time",
            r"and the reduced time of a cycle, up to $w^{3/2}$, is «time».",
            time=of_share(
                "T",
                sp.pi + 9 * R / (8 * q) * w ** sp.Rational(3, 2),
                lambda: sum(sp.expand(cycle().cycle_duration).coeff(epsilon, n) * sp.sqrt(w) ** n for n in range(4)),
            ),
        ),
    ),
)
