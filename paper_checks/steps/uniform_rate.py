"""Steps about all trajectories with one E(0): an upper bound of w that it fixes, and why there is no lower one (a1 = 0)."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.solvers.smt import prove
from paper_checks.steps.creeping import creeps_for_ever
from paper_checks.steps.monotone_slips import contact, depth_grows, landings, one_contact
from paper_checks.steps.rate import one_step
from paper_checks.steps.turned_back import contact_again
from theory.symbols import q, r, w
from theory.uniform_rate import backwards, family_excess, family_guard, first_contact_bound, slowness

DEPTH, GAP, EDGE = sp.symbols("c d k", positive=True)  # k = 1/q


@cache
def few_crossings() -> Evidence:
    """Each slip that crosses S loses a fixed part of y."""
    crosses = [sp.Ge(DEPTH + GAP, 2 * EDGE)]
    return argument(
        "A slip that crosses has $c+d\\geqslant 2/q$ and loses $r\\,c\\,(c+2d)$ of $y$. If $d\\leqslant 1/q$ that is at least $2r/q^2$. "
        "If $d\\geqslant 1/q$ it is at least $2r\\,c/q$, and $c$ is not small: for $\\theta\\leqslant\\pi$, $d\\cot(\\theta/2)=h-u"
        "\\leqslant\\frac{\\pi}{2}+\\sqrt{y_0}$, as $h\\leqslant\\pi/2$ and $u^2\\leqslant y\\leqslant y_0$; beyond, $c\\geqslant 2$. So there are at "
        "most $N$ of them, each shorter than $2\\pi\\sqrt q$.",
        contact(),
        *one_contact(),
        *landings(),
        *depth_grows(),
        prove(
            r"$c+d\geqslant 2/q$ and $d\leqslant 1/q$ give $c\,(c+2d)\geqslant 2/q^2$ (here $k=1/q$)",
            [*crosses, sp.Le(GAP, EDGE)],
            sp.Ge(DEPTH * (DEPTH + 2 * GAP), 2 * EDGE**2, evaluate=False),
        ),
        prove(
            r"$d\geqslant 1/q$ gives $c\,(c+2d)\geqslant 2c/q$",
            [sp.Ge(GAP, EDGE)],
            sp.Ge(DEPTH * (DEPTH + 2 * GAP), 2 * DEPTH * EDGE, evaluate=False),
        ),
    )


@cache
def upper() -> Evidence:
    """The bound of w from above."""
    return argument(
        "$S$ is met by $\\tau_1$. From ray to ray $1/y$ gains at least $\\rho$, as $y-y'\\geqslant r\\,c^2$ after the first slip, $c/y$ falls with "
        "$y$, and $y\\leqslant y_0$; it takes at most $\\pi(1+2\\sqrt q)$, but for slips that cross, of which there are at most $N$ in all. So "
        "the $n$-th exit is not after $\\tau^*+(n+1)\\,\\pi(1+2\\sqrt q)$, and $w$ never grows.",
        contact_again(),
        identity(
            r"the bound of a stay, in units of $1/\Omega$, is $2\sqrt{(1+w)/r}$",
            first_contact_bound() ** 2,
            4 * (1 + w) / r,
        ),
        few_crossings(),
        *depth_grows(),
        one_step()[0],
    )


@cache
def no_lower() -> Evidence:
    """A family with one E(0) and as little w as one likes from a bounded time on."""
    cosine, velocity, angle = sp.symbols("k V s", real=True)
    return argument(
        "Let the pair meet $S$ at $X=r$, $V=\\sqrt{1-r^2+\\delta}$ with a small $\\delta>0$. Before that it has slipped with $v_1<v_2$ for "
        "ever: $V_1-V_2<0$ for all earlier times, so going back $w$ grows without bound and passes every $w_0>\\delta$. A start there has "
        "$E(0)=E_0$ and meets $S$ first by $\\tau_1$; from then on $w\\leqslant\\delta$, and it never merges.",
        contact_again(),
        creeps_for_ever(),
        identity(
            r"at the slip angle $\sigma$ before the contact $V_1-V_2=V(\cos\sigma-1)-\sqrt q\,\sigma$",
            family_guard(),
            slowness * (sp.cos(backwards) - 1) - sp.sqrt(q) * backwards,
        ),
        identity(r"at the contact $w=r^2+V^2-1$", family_excess(), r**2 + slowness**2 - 1),
        prove(
            r"$V(k-1)-s<0$ for $V>0$, $k\leqslant 1$, $s>0$ (here $k=\cos\sigma$, $s=\sqrt q\,\sigma$)",
            [sp.Gt(velocity, 0), sp.Le(cosine, 1), sp.Gt(angle, 0)],
            sp.Lt(velocity * (cosine - 1) - angle, 0, evaluate=False),
        ),
    )
