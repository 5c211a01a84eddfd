"""Steps on the tolerance ring, and on a damper that breaks adhesion."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.solvers.smt import prove
from paper_checks.steps import capture, dissipation, solutions
from paper_checks.steps.forced_distance import never_apart
from paper_checks.steps.forced_response import approach
from paper_checks.steps.forced_rule import strict_rule
from theory import forced
from theory import forced_control as control
from theory.energy import critical_energy, on_surface, sigma
from theory.symbols import a1, a2, b, m1, m2, total_mass, u, v1, v2, x1, x2


@cache
def entered_once() -> Evidence:
    """A quantity that never grows passes a level once."""
    return argument(
        r"$N$ never grows, so $N\leqslant\varepsilon$ lasts from its first time on. With $a_1>0$ and a bounded force $N\to 0$.",
        never_apart(),
        approach(),
    )


@cache
def ring_contains() -> Evidence:
    """(dw)^2 <= kappa N^2, attained where both momenta cancel."""
    return argument(
        r"By the Cauchy-Schwarz inequality; at $m_1v_1+m_2v_2=0$, $x_1=0$ both sides are equal.",
        prove(
            r"$m_1m_2(v_1-v_2)^2\leqslant M(a_2x_1^2+m_1v_1^2+m_2v_2^2)$",
            [],
            sp.Le(m1 * m2 * (v1 - v2) ** 2, total_mass() * (a2 * x1**2 + m1 * v1**2 + m2 * v2**2), evaluate=False),
        ),
        identity(r"the ratio is attained: $\kappa=M/(m_1m_2)$", control.ring_ratio(), total_mass() / (m1 * m2)),
        identity(
            r"$\sqrt\kappa\,\varepsilon$ is the largest relative velocity in the ellipsoid $N\leqslant\varepsilon$",
            control.ring_radius(),
            sp.sqrt(control.ring_ratio()) * control.tolerance,
        ),
    )


@cache
def blind_to_x2() -> Evidence:
    """No acceleration depends on x2."""
    return identity(
        r"no acceleration depends on $x_2$: a start moved by $c$ in $x_2$ keeps $c$ for ever",
        sp.Matrix([sp.diff(entry, x2) for entry in forced.forced_system(sigma)]),
        sp.zeros(3, 1),
    )


@cache
def centre() -> Evidence:
    """Nothing depends on x2; the path of the relative displacement is paid."""
    return argument(
        r"A motion with $x_2(0)$ moved by $c$ is the same motion with $x_2$ moved by $c$. Without a force $b\int_t^\infty|\dot z|\,ds\leqslant E(t)-E_\infty$, so $x_1-x_2$ has a limit and is no further from it than $(E(t)-E_\infty)/b$.",
        blind_to_x2(),
        identity(r"of the energy lost $\mathrm dE$ friction takes $b\,|\mathrm dz|$", control.path_per_energy(), 1 / b),
        *dissipation.in_every_mode()[:4],
    )


@cache
def sticks_for_ever_below() -> Evidence:
    """On S with E <= E_cr the free pair is captured."""
    return argument(
        r"On $S$ with $E\leqslant E_{cr}$ the pair is in $S_0$; stuck it keeps its energy, so it sticks for ever.",
        capture.stays_below_critical(),
        capture.stick_is_a_motion(),
        solutions.one_solution(),
    )


@cache
def sticks_without() -> Evidence:
    """Below the critical energy on S the free pair is captured."""
    return argument(
        r"At $x_1=0$ on $S$ the energy is $Mv_1^2/2$.",
        identity(
            r"$Mv_1^2/2=E_{cr}$ at $v_1^2=b^2M/(a_2m_2^2)$",
            on_surface().subs({x1: 0, v1: sp.sqrt(b**2 * total_mass() / (a2 * m2**2))}),
            critical_energy(),
        ),
        sticks_for_ever_below(),
    )


@cache
def breaks_with() -> Evidence:
    """At x1 = 0 the damper's share alone is beyond the strip."""
    damping, speed = sp.Symbol("k", positive=True), sp.Symbol("v", positive=True)
    load = forced.load().subs({u: 0, x1: 0, v1: speed, a1: damping}, simultaneous=True)
    numerator, denominator = sp.fraction(sp.cancel(load))
    return argument(
        r"There $\Lambda=-m_2a_1v_1/M<-b$: beyond the strip the pair slips at once.",
        prove(
            r"$a_1>bM/(m_2v)$ gives $\Lambda<-b$ at $x_1=0$, $v_1=v$ (here $k=a_1$)",
            [sp.Gt(damping * m2 * speed, b * total_mass(), evaluate=False)],
            sp.Lt(numerator, -b * denominator, evaluate=False),
        ),
        strict_rule(),
    )


@cache
def heavy_damping() -> Evidence:
    """A body 1 that creeps: body 2 comes to rest on it."""
    load = forced.load().subs({u: 0, x1: (forced.creeping_load() - a1 * v1) / a2}, simultaneous=True)
    return argument(
        r"$E$ never grows, so $|a_2x_1+b\sigma|\leqslant F$ with an $F$ that does not depend on $a_1$, and $|v_1|\leqslant|v_1(0)|e^{-a_1t/m_1}+F/a_1$: but for a time of order $\ln a_1/a_1$ body 1 has a velocity of order $1/a_1$. While $|v_2|$ exceeds it, it "
        r"falls at the rate $b/m_2$, so both velocities meet at $m_2|v_2(0)|/b$, but for terms that tend to $0$. In slip $p=a_2x_1+a_1v_1$ obeys $\dot p=a_2v_1-(a_1/m_1)(p+b\sigma)$: it is at $-b\sigma$, but for terms of order $1/a_1$, when they meet. There "
        r"$|\Lambda|=bm_2/M$ and smaller terms, less than $b$, so the pair sticks, and $\dot p=a_2v_1-(a_1/M)p$ lets $|p|$ fall from then on: it sticks for ever.",
        dissipation.energy_never_grows(),
        identity(r"there the load is $m_2b\sigma/M$", load, m2 * b * sigma / total_mass()),
        identity(
            r"in slip $m_1\dot v_1=-(p+b\sigma)$, in stick $M\dot v_1=-p$",
            sp.Matrix(
                [
                    m1 * forced.forced_system(sigma)[1].subs(u, 0) + a2 * x1 + a1 * v1 + b * sigma,
                    total_mass() * forced.load().subs(u, 0) / m2 + a2 * x1 + a1 * v1,
                ]
            ),
            sp.zeros(2, 1),
        ),
        solutions.never_apart(),
        strict_rule(),
    )
