"""Past the paper: which energies merge by re-entry, and from which mass ratio on."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

import sympy as sp

from paper_checks.engines.deciders import decimal, equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence
from paper_checks.ledger.theorem import C, H, R, in_angle, theorem
from theory.excursion import angle
from theory.merging import critical_mass_ratio, turning_function
from theory.merging_share import density, large_energy_limit, level, relative
from theory.return_map import (
    return_map_of_angle,
)
from theory.symbols import X, q
from theory.symbols import r as share_of_q

if TYPE_CHECKING:
    from flint import arb


ANGLE = sp.Symbol("varphi", positive=True)


def _critical_ratio() -> arb:
    from paper_checks.engines.balls import precision
    from paper_checks.steps.critical_share import critical_value

    with precision():
        return (1 - critical_value()) / critical_value()


def _bands(share: Fraction) -> Formula:
    """Return how many bands there are at least for a share; decided by the energies that balls prove to merge, and not."""

    def decide(formula: Formula) -> Evidence:
        from paper_checks.steps.merging_bands import bands

        number, found = bands(share)
        proved = formula.relation == ">=" and bool(formula.right <= number)
        return replace(found, statement=f"${formula.latex}$ for $r={share}$", passed=proved or None)

    return Formula("n", ">=", sp.Integer(9), decide)


MERGING = (
    theorem(
        "merging-set",
        clause(
            "interval",
            r"Let $r=m_2/M$ exceed $r^*$ of critical-mass-ratio. There are $0<w_a<w_b$ such that a trajectory from $S_0$ with $w=E/E_{cr}-1>0$ merges where it first meets "
            r"$S$ after it left $S_0$ exactly if $w_a\leqslant w\leqslant w_b$.",
            kernel=("merging-set",),
        ),
        clause(
            "roots",
            r"They are $w_{a,b}=w(\theta_{a,b})$ with the two roots $\theta_a<\theta_b$ in $(0,2\pi)$ of $h(\theta)=\sqrt r\,c(\theta)$, which has no others:",
            kernel=("merging-set",),
        ),
        clause(
            "leads",
            r"a slip from a ray leads "
            r"from «before» to «after».",
            before=in_angle("w", q * H**2, lambda: q * return_map_of_angle()[0]),
            after=in_angle("w'", q * (H**2 - R * C**2), lambda: q * return_map_of_angle()[1]),
        ),
        clause(
            "crossings",
            r"At the first re-entry of $S_0$, after any number of crossings of $S$, exactly the energies of one interval merge, too;",
            kernel=("merging-set",),
        ),
        clause(
            "same",
            r"and it is the same one: where a trajectory crosses $S$, once or more often, its first re-entry is above $E_{cr}$.",
            kernel=("merging-set",),
        ),
        clause("below", r"Below $w_a$ it never merges."),
        clause(
            "none",
            r"For $r<r^*$ no energy on $S_0$ above $E_{cr}$ merges where the trajectory first meets $S$.",
            kernel=("heavy-never-merges",),
        ),
        clause(
            "limits",
            r"As $m_1/m_2\to 0$ the interval $[w_a,w_b]/q$ tends to that of $r=1$; as $m_1/m_2\to\infty$ nothing merges after its "
            r"first contact with $S$.",
        ),
    ),
    theorem(
        "critical-mass-ratio",
        clause(
            "root",
            r"Let $\varphi^*$ be the one root in $(0,\pi)$ of «turning», and «ratio» at $\varphi=\varphi^*$: «digits».",
            turning=Formula(
                "K",
                "=",
                ANGLE - sp.sin(ANGLE) * sp.cos(ANGLE) - sp.sqrt(2) * (sp.sin(ANGLE) - ANGLE * sp.cos(ANGLE)),
                equals(turning_function, lambda: {ANGLE: angle}),
            ),
            ratio=Formula(r"\mu^*", "=", -sp.cos(2 * ANGLE), equals(critical_mass_ratio, lambda: {ANGLE: angle})),
            digits=Formula(r"\mu^*", "=...", sp.Rational("0.79263"), decimal(_critical_ratio)),
            kernel=("turning-point", "critical-mass-ratio-digits"),
        ),
        clause(
            "heavier",
            r"If $m_1/m_2>\mu^*$, no slip that starts on $S$ above $E_{cr}$, from a ray or beyond an edge, ends with "
            r"$E\leqslant E_{cr}$: whether a trajectory merges is decided by its energy at its first contact with $S$.",
            kernel=("no-low-level", "heavy-never-merges"),
        ),
        clause(
            "lighter",
            r"If $m_1/m_2<\mu^*$, an interval of energies on $S_0$ merges where the pair first meets $S$ after it left $S_0$, and some energy does if they are equal:",
            kernel=("merging-set",),
        ),
        clause("equal", r"then just one.", kernel=("merging-set",)),
    ),
)

SHARES = (
    theorem(
        "merging-bands",
        clause(
            "bands",
            r"The energies on $S_0$ above $E_{cr}$ that ever merge, at the first re-entry or later, form more than one band: for $r=m_2/M$ "
            r"equal to $\tfrac{3}{5}$ there are «first», for $\tfrac{7}{10}$ «second», for $\tfrac{4}{5}$ «third».",
            first=_bands(Fraction(3, 5)),
            second=_bands(Fraction(7, 10)),
            third=_bands(Fraction(4, 5)),
        ),
        open=(
            r"That there are infinitely many bands for every $r>r^*$, equally spaced in $\sqrt w$ in the limit, is seen in numbers and not proved.",
        ),
    ),
    theorem(
        "merging-share",
        clause(
            "share",
            r"Let $r\leqslant r^*$ and $e=E/E_{cr}>1$. The share (Liouville measure) of the states of energy $E$ that merge is the integral over "
            r"$X^2+V^2\leqslant 1$ of «density», where $g=|V_1-V_2|$ at the energy $E$ of the slip that ends at $(X,V)$ on $S$.",
            density=Formula(
                "f",
                "=",
                (1 - X) / relative / (2 * sp.pi * sp.sqrt(q) * sp.sqrt(R) * sp.sqrt(level)),
                equals(density, lambda: {R: share_of_q}),
            ),
        ),
        clause(
            "limit",
            r"As $E$ grows, «limit».",
            limit=Formula(r"e\,\int f", "->", 1 / (2 * sp.sqrt(q)), equals(large_energy_limit)),
        ),
    ),
)
