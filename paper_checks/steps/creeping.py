"""Trajectories that never merge: how they tend to the critical orbit, and how fast (a1 = 0)."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.steps import capture
from paper_checks.steps.excursions import angle_of_excursion, never_merges
from paper_checks.steps.turned_back import merges_or_creeps
from theory.energy import critical_energy
from theory.near_critical import cycle_limit, inverse_step, quadratic_coefficient, rate_constant
from theory.symbols import a2, b, m1, m2, q, r

EVENTUALLY = (
    "The trajectory tends to one motion on the critical ellipse. Near its crossing of $x_1=0$ both fields push to $S$, so the "
    "trajectory is on $S_0$ there from some time on; it then sticks up to a ray, which it leaves with a small excess $w$, and the "
    "excursion ends inside $S_0$ again."
)


@cache
def creeps_for_ever() -> Evidence:
    """From S0 slightly above E_cr the pair never merges, and tends to the critical orbit."""
    return argument(
        "On $S_0$ above $E_{cr}$ the pair sticks up to a ray. From there with $w\\leqslant q(\\pi/2-1)^2$ every excursion ends inside "
        "$S_0$ with $0<w'<w$, by induction without end; so $E>E_{cr}$ for ever, and the trajectory tends to the critical orbit.",
        *capture.leaves_above_critical(),
        *angle_of_excursion(),
        *never_merges(),
        merges_or_creeps(),
    )


def printed_rate_constant() -> sp.Expr:
    """Return the sharp constant of the 1/t law as the report states it, J s."""
    return b**2 * (m1 + m2) ** 2 / (2 * a2 * m2**2) * 4 * sp.pi / 9 * m1 / m2 * sp.sqrt((m1 + m2) / a2)


@cache
def sharp_limit() -> Evidence:
    """Return that t (E - E_cr) tends to the sharp constant."""
    return argument(
        "Along the exits $1/w$ gains $9r/(4q)$ and the time $\\pi/\\Omega$ per cycle, both in the limit, so $1/(t\\,w)$ tends to their "
        "quotient; between two exits $w$ lies between its values there, whose ratio tends to 1, as does that of the times.",
        creeps_for_ever(),
        identity("$1/w'-1/w\\to 9r/(4q)$ as $w\\to 0$", inverse_step(), 9 * r / (4 * q)),
        identity("equivalently $w'=w-\\tfrac{9r}{4q}w^2+\\dots$", quadratic_coefficient(), 9 * r / (4 * q)),
        identity("the time of a cycle tends to $\\pi/\\Omega$", cycle_limit(), sp.pi),
        identity(
            "so $t\\,(E-E_{cr})\\to E_{cr}\\,\\tfrac{4\\pi}{9}\\tfrac{m_1}{m_2}\\sqrt{(m_1+m_2)/a}$",
            rate_constant(),
            printed_rate_constant(),
        ),
        identity("with $E_{cr}$ as derived", critical_energy(), b**2 * (m1 + m2) ** 2 / (2 * a2 * m2**2)),
        cites=("Stolz and Cesàro",),
    )


@cache
def two_sided() -> Evidence:
    """Return that t (E - E_cr) is bounded from both sides, by numbers that depend on E(0) alone."""
    return argument(
        "A continuous positive $t\\,w(t)$ with a positive limit is bounded from both sides on $[t_0,\\infty)$. A start on $S_0$ with "
        "$E(0)>E_{cr}$ is on one of two arcs, mirror images of each other, on which only the time to the ray, at most half a "
        "period, depends on the start: over these times the bounds are attained, so they depend on $E(0)$ and $t_0$ alone.",
        sharp_limit(),
    )
