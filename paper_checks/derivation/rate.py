"""The 1/t law: what an excursion adds to 1/w, how long it takes, and the constant."""

from __future__ import annotations

from paper_checks.claims.beyond.excursions import EVENTUALLY, printed_rate_constant, two_sided
from paper_checks.claims.letters import ECR, RATE, R
from paper_checks.claims.section_3.convergence import merges_or_creeps
from paper_checks.claims.words import *
from paper_checks.derivation.line import Line, Stage, equation, gathered, of_clause
from paper_checks.derivation.surface import FREE
from theory.near_critical import inverse_step, rate_constant, reduced_rate_constant

LIMIT = "sharp-rate-constant/limit"
BOTH = f"{LIMIT} rate-one-over-t/limit"
STICKS, SLIPS = "stick-durations/sticks", "slip-durations/slips"


def gained(formula: Formula) -> Evidence:
    """Decide what 1/w gains in the limit by the series of the return map."""
    return identity(f"${formula.latex}$", sp.sympify(formula.right).subs(R, r), inverse_step())


def summed(formula: Formula) -> Evidence:
    """Decide the limit of tau w: an inference over the quotient of both limits."""
    same = identity(
        f"${formula.latex}$ is their quotient", sp.sympify(formula.right).subs(R, r), reduced_rate_constant()
    )
    return argument(f"${formula.latex}$, along the exits and in $t$", same, cites=("Stolz and Cesàro",))


LAW = Stage(
    "derivation-rate",
    "The $1/t$ law and its constant",
    f"{FREE}, $b$ constant; the motion never merges, that is $E>E_{{cr}}$ at all times.",
    (
        r"""
        Near $E_{cr}$ the pair slips for a short time, loses an excess of the order $w^2$, sticks for about half a period, and
        slips again. A quantity that loses a multiple of its square in each period decays like $1/t$: its reciprocal grows by the
        same amount each time. The quotient of time and growth is the constant. Every motion from $S_0$ slightly above $E_{cr}$
        is one that never merges, as the slope of the return map showed.
        """,
        Line(
            r"""
            A motion that never merges tends to the ellipse of $E_{cr}$, and from some time on it slips and sticks in turn,
            from ray to ray, with $w\to 0$. It sticks for the times $t_k\leqslant t\leqslant\tau_k$ and slips between them:
            """,
            f"{BOTH} {STICKS} {SLIPS}",
            lambda: (*of_clause(STICKS, "limit")(), *of_clause(SLIPS, "limit")()),
            steps=lambda: (argument(EVENTUALLY, merges_or_creeps),),
            kernel="exit-and-entry-times",
        ),
        Line(
            "Divide: in one excursion $1/w$ gains, in the limit $w\\to 0$,",
            BOTH,
            lambda: Formula(r"\frac1{w'}-\frac1w", "->", 9 * R / (4 * q), gained),
        ),
        Line(
            r"Add the times of slip and stick, and expand, up to $w^{3/2}$: a cycle takes, in units of $1/\Omega$,",
            "return-map-expansion/time",
            of_clause("return-map-expansion/time", "time"),
        ),
        Line(
            r"""
            Sum over the cycles. $1/w$ grows by $9r/(4q)$ while $\tau$ grows by $\pi$, so $1/(\tau w)$ tends to the quotient
            along the exits; between two exits $w$ lies between its values there, whose ratio tends to $1$.
            """,
            BOTH,
            lambda: Formula(r"\tau\,w", "->", 4 * pi * q / (9 * R), summed),
            kernel="sharp-law",
        ),
        Line(
            r"Substitute the units, $\tau=\Omega t$ and $w=E/E_{cr}-1$: the $1/t$ law.",
            BOTH,
            lambda: equation(r"t\,(E-E_{cr})", gathered(rate_constant() / critical_energy() * ECR), RATE, "->"),
            kernel="sharp-law",
        ),
        Line(
            r"Substitute $E_{cr}$: the constant in the parameters of the pair alone.",
            BOTH,
            lambda: equation(r"t\,(E-E_{cr})", rate_constant(), printed_rate_constant(), "->"),
        ),
        "![sharp-rate]",
        Line(
            r"""
            A positive continuous function with a positive limit is bounded from both sides: $c_1/t\leqslant E-E_{cr}\leqslant c_2/t$
            from any $t_0>0$ on. For starts on $S_0$ both constants depend on $E(0)$ and $t_0$ alone.
            """,
            "rate-one-over-t/two-sided",
            steps=lambda: (two_sided(),),
            kernel="one-over-t",
        ),
    ),
)
STAGES = (LAW,)
