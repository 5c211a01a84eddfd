"""Is creeping robust? Static friction above kinetic, by any jump, ends it."""

from functools import cache

from paper_checks.claims.words import *
from theory.forced import load
from theory.model import slip


@cache
def slip_rate() -> Evidence:
    """Return how the relative velocity of a slip changes, by the load."""
    there = slip(1)
    return identity(
        r"a slip of sign $+$ has $\ddot z=\kappa(\Lambda-b)$, $\kappa=\frac1{m_1}+\frac1{m_2}$",
        there.acceleration1 - there.acceleration2,
        (1 / m1 + 1 / m2) * (load() - b),
    )


@theorem(
    "static-friction-stops-creeping",
    clause(
        "costs",
        r"""
        Let friction be $b_k>0$ in slip and up to $b_s>b_k$ at rest, $u=0$, $a_1\geqslant 0$, and let a pair with $\dot
        z=0$ stick while its load has $|\Lambda|<b_s$, also where a slip ends that could go over into the other. Then a
        slip from a contact to the next one lasts longer than $h_0$ and dissipates at least $e_0$:
        $h_0=(b_s-b_k)/\bigl(2C+(b_s-b_k)\sqrt{a_2/m_1}\bigr)$, $e_0=b_k\kappa\,(b_s-b_k)\,h_0^2/16$,
        $\kappa=\frac1{m_1}+\frac1{m_2}$, and
        $C=\frac{m_2}{m_1+m_2}\bigl(a_2\sqrt{2E/m_1}+\frac{a_1}{m_1}(a_2\sqrt{2E/a_2}+a_1\sqrt{2E/m_1}+b_s)\bigr)$ with
        $E=E(0)$.
        """,
        kernel="static-slip-costs",
    ),
    clause("few", r"So there are at most $E(0)/e_0$ such slips,", kernel="static-few-slips"),
    clause("sticks", r"and the pair sticks permanently from a finite time on.", kernel="static-sticks-at-last"),
    clause(
        "choice",
        r"""
        That sticks are kept must be assumed: for $a_1=0$ a stuck pair with $b_k<|\Lambda|<b_s$ has motions that leave
        the stick at each time of an interval.
        """,
        kernel="jump-ill-posed",
    ),
    clause("exists", r"A motion that keeps them exists from every state.", kernel="static-kept"),
    open=(
        "With a friction that falls from rest on with a finite slope, whether $t(E-E_{cr})$ keeps its limit is not decided here.",
    ),
    assuming="$m_1,m_2,a_2>0$, $a_1\\geqslant 0$. No force, $u=0$; and not Coulomb's law with one $b$: friction at rest is larger than in slip.",
)
def static_friction_stops_creeping() -> Case:
    """Every slip begins with more than friction takes, and so costs a fixed energy."""
    return because(
        "With static friction above kinetic the free pair sticks permanently from a finite time on, if sticks are kept. A stick that is kept up to $b_s$ ends with a load that exceeds kinetic friction by $b_s-b_k$, and the load changes at a bounded rate: the slip that follows has a least duration and a least loss. Without the jump slips may lose arbitrarily little, and so some motions never merge.",
        slip_rate(),
        figure="static-friction",
    )
