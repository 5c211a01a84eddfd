"""Steps under a force u(t): which mode follows at v1 = v2, and that events do not accumulate. For a1 >= 0."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.solvers.polynomial import cleared
from paper_checks.solvers.smt import prove
from paper_checks.steps.forced_distance import one_solution
from theory import forced
from theory.model import slip
from theory.symbols import a1, a2, b, m2, t, total_mass, u, x1

NEEDED = sp.Symbol("P", real=True)
"""The load, N, as a letter for the solvers."""


@cache
def slip_rates() -> Evidence:
    """w' in slip of both signs, by the load."""
    rates = [forced.relative_rate(sign) for sign in (1, -1)]
    by_load = [forced.coupling() * (forced.load() - sign * b) for sign in (1, -1)]
    return identity(
        r"in slip of sign $s$, $\ddot z=\kappa\,(\Lambda-sb)$, $\kappa=M/(m_1m_2)$",
        sp.Matrix(rates),
        sp.Matrix(by_load),
    )


@cache
def slips_beyond() -> Evidence:
    """Beyond the strip w leaves zero with the sign of the load, whichever slip is tried."""
    rates = [cleared(forced.coupling() * (NEEDED - sign * b)) for sign in (1, -1)]
    return prove(
        r"where $\Lambda>b$ both slips have $\ddot z>0$: slip of sign $1$ goes on, slip of sign $-1$ and stick cannot (here $P=\Lambda$)",
        [sp.Gt(NEEDED, b, evaluate=False)],
        sp.And(*(sp.Gt(rate, 0, evaluate=False) for rate in rates)),
    )


@cache
def sticks_within() -> Evidence:
    """Inside the strip both slips come back to w = 0."""
    rates = [sign * cleared(forced.coupling() * (NEEDED - sign * b)) for sign in (1, -1)]
    return prove(
        r"where $|\Lambda|<b$ slip of either sign has $s\,\ddot z<0$: neither can begin",
        [sp.Lt(sp.Abs(NEEDED), b, evaluate=False)],
        sp.And(*(sp.Lt(rate, 0, evaluate=False) for rate in rates)),
    )


@cache
def deviation() -> Evidence:
    """In slip of sign s and in stick the motion beside the reference is driven by p."""
    modes = [(mode, sign) for sign in (1, -1) for mode in ("stick", "slip+" if sign > 0 else "slip-")]
    return identity(
        r"where $\Lambda=sb$, $\eta=x_1-r$ beside $r=x_1+v_1t+sbt^2/2m_2$ has $I\ddot\eta+a_1\dot\eta+a_2\eta=p(t)$ in slip of sign $s$ ($I=m_1$) and in stick ($I=M$)",
        sp.Matrix([forced.deviation_force(mode, sign) for mode, sign in modes]),
        sp.Matrix([forced.imbalance(sign) for _, sign in modes]),
    )


@cache
def excess() -> Evidence:
    """The load beside the edge is p, but for terms in y and its rate."""
    beside = [m2 / total_mass() * (forced.imbalance(s) - a1 * forced.gap_rate - a2 * forced.gap) for s in (1, -1)]
    return identity(
        r"there $\Lambda-sb=(m_2/M)(p-a_1\dot\eta-a_2\eta)$",
        sp.Matrix([forced.excess_load(sign) for sign in (1, -1)]),
        sp.Matrix(beside),
    )


@cache
def relative_is_deviation() -> Evidence:
    """In slip of sign s body 2 has the reference's acceleration, so w' is that of y."""
    rates = [sp.diff(forced.reference(s), t, 2) - slip(s).acceleration2 for s in (1, -1)]
    return identity(
        r"in slip of sign $s$ body 2 keeps the velocity $\dot r$: $\dot z=\dot\eta$", sp.Matrix(rates), sp.zeros(2, 1)
    )


@cache
def leading_term() -> Evidence:
    """If p begins with c t^k, so does the load beside the edge; y and its rate are of higher order."""
    k, c, inertia = (
        sp.Symbol("k", nonnegative=True, integer=True),
        sp.Symbol("c", real=True),
        sp.Symbol("I", positive=True),
    )
    rate = c * t ** (k + 1) / (inertia * (k + 1))
    return argument(
        r"Let $p=c\,t^k(1+O(t))$, $c\neq 0$. From $\eta=\dot\eta=0$ at $t=0$, with $m_1\leqslant I\leqslant M$ even where the modes take turns, Gronwall's inequality gives "
        r"$|\dot\eta|\leqslant C|t|^{k+1}$, $|\eta|\leqslant C|t|^{k+2}$ on both sides of $0$. So $\Lambda-sb=(m_2/M)\,p\,(1+O(t))$ has the sign of $p$ near $0$, and in slip "
        r"$\dot z=\dot\eta=c\,t^{k+1}(1+O(t))/((k+1)m_1)$.",
        deviation(),
        excess(),
        relative_is_deviation(),
        identity(r"$\frac{d}{dt}\frac{c\,t^{k+1}}{I(k+1)}=\frac{c\,t^k}{I}$", sp.diff(rate, t), c * t**k / inertia),
        cites=("Gronwall's inequality",),
    )


@cache
def strict_rule() -> Evidence:
    """The rule off the edges."""
    return argument(
        r"$\Lambda$ is continuous from the right. Where $s\Lambda>b$ the slip of sign $s$ from $\dot z=0$ has $s\dot z>0$ for a while, so it is a solution; where $|\Lambda|<b$ stick "
        r"meets its condition for a while. There is one solution, so it is this one.",
        slips_beyond(),
        sticks_within(),
        slip_rates(),
        one_solution(),
    )


@cache
def tie_rule() -> Evidence:
    """The rule on an edge."""
    return argument(
        r"If the first nonzero $s\,p^{(k)}$ is positive, the slip of sign $s$ has $s\dot z>0$ right after, and is a solution. If it is negative, stick has $s\Lambda<b$ right after, "
        r"and is one. There is one solution, so it is this one.",
        leading_term(),
        one_solution(),
    )


@cache
def marginal_rule() -> Evidence:
    """All derivatives zero: p = 0 for a while, so y = 0 in both modes."""
    return argument(
        r"An analytic $p$ with all derivatives zero is zero for a while. Then $\eta=0$ in both modes: both have $x_1=r$, $\dot z=0$ and $\Lambda=sb$.",
        deviation(),
        excess(),
        relative_is_deviation(),
    )


@cache
def jump_moves_the_strip() -> Evidence:
    """The load takes the jump of u, the state does not: it has bounded accelerations."""
    jump = sp.Symbol("j", real=True)
    moved = forced.load().subs({u: u + jump, x1: x1 + jump / a2}, simultaneous=True)
    return argument(
        r"Positions and velocities are integrals of bounded functions. The load after the jump is that before it in the strip moved by the jump$/a_2$.",
        identity(r"$\Lambda(u+j,\,x_1+j/a_2)=\Lambda(u,x_1)$", moved, forced.load()),
        strict_rule(),
    )


@cache
def finitely_many_events() -> Evidence:
    """No accumulation of events, from the right or from the left."""
    return argument(
        r"From the right events cannot accumulate: the rule names a mode that lasts. Let them accumulate from the left at a time, $t=0$. Then $\dot z(0)=0$, and $u$, $b$ are analytic up to "
        r"$0$. If $|\Lambda(0)|\neq b$, either $|\Lambda|<b$ near $0$, and once stuck the pair sticks up to $0$; or $s\Lambda>b$, and $s\dot z$ increases in every mode, so $\dot z$ has one "
        r"zero. Let $\Lambda(0)=sb$. Near $0$ slip of sign $-s$ has $s\ddot z>0$, so it does not begin, and only slip of sign $s$ and stick are left. If $p=0$ near $0$, "
        r"$\eta=0$ and $\ddot z=0$ there in both modes: no event. Else $\Lambda-sb$ has one sign on some $(-\epsilon,0)$: if it is that of $s$ there is no stick, and $s\dot z$ increases; if not, "
        r"a pair once stuck sticks up to $0$. In each case only finitely many events are left. With a friction $b(t)$ by pieces, analytic in each, the same holds with "
        r"$m_2\ddot r=sb(t)$.",
        leading_term(),
        marginal_rule(),
        strict_rule(),
        tie_rule(),
    )
