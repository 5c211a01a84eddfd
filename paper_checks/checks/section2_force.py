"""Section II: what the force u(t) stands for, and in which direction friction acts."""

from __future__ import annotations

import sympy as sp

from paper_checks.checks.registry import Context, check
from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.ledger import claim_named
from paper_checks.ledger.points import EXAMPLE_PAIR
from paper_checks.ledger.section2 import DISTURBANCE, REFERENCE, REFERENCE_RATE, STIFFNESS, VISCOSITY
from paper_checks.steps import forced_distance, transfers
from theory import forced
from theory.energy import sigma
from theory.model import driven_equation, driving_equation
from theory.symbols import a1, a2, b, m2, u, v1, v2, x1

AT_REST = {**EXAMPLE_PAIR, u: sp.Rational("0.01"), x1: sp.Rational("0.00005")}


@check("force-as-reference-or-disturbance")
def force_as_reference_or_disturbance(context: Context) -> Finding:  # noqa: ARG001
    """Put a feedback into (3), and a reference in the place of the force."""
    virtual = {a1: a1 + VISCOSITY, a2: a2 + STIFFNESS}
    feedback = -STIFFNESS * (x1 - REFERENCE) - VISCOSITY * (v1 - REFERENCE_RATE) + DISTURBANCE
    entering = STIFFNESS * REFERENCE + VISCOSITY * REFERENCE_RATE + DISTURBANCE
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "Feedback terms do join spring and damper, and what is left is an exogenous force. A reference trajectory is a place in m, though, and $u$ a force in N: the reference enters as the force that the gains "
        "make of it.",
        exhibit(
            "with $u=x_{\\mathrm{ref}}=0.01$ the pair of Section IV rests at $x_1=0.00005$, not at $0.01$",
            AT_REST,
            (a2 * x1, "=", u),
            (x1, "!=", u),
        ).as_counterexample(),
        carried(
            "input",
            identity(
                r"(3) under the feedback is (3) with the gains beside $a_2$, $a_1$, under $u=k_1x_{\mathrm{ref}}+k_2\dot x_{\mathrm{ref}}+u_d$",
                driving_equation().subs(u, feedback),
                driving_equation().subs(virtual, simultaneous=True).subs(u, entering),
            ).as_correction(),
            identity(
                r"(4) has no $u$, $a_1$, $a_2$",
                sp.Matrix([sp.diff(driven_equation(), one) for one in (u, a1, a2)]),
                sp.zeros(3, 1),
            ).as_correction(),
        ),
        corrected=claim_named("force-as-reference-or-disturbance").corrected,
        counterexample="$m_1=m_2=1$, $a_2=200$, $b=0.5$, at rest under the constant $u=x_{\\mathrm{ref}}=0.01$: by (3) it is $x_1=x_{\\mathrm{ref}}/a_2=0.00005$, not $x_{\\mathrm{ref}}$.",
    )


SLIPPING = {b: sp.Rational(1, 2), u: 0, a1: 0, sigma: 1, v1: sp.Rational("0.15"), v2: 0}
"""The start of Fig. 4 (b), in slip with z' > 0."""


@check("free-interface")
def free_interface(context: Context) -> Finding:  # noqa: ARG001
    """The direction of friction, by the power that it takes, and what bounds it."""
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "Friction is tangential; the normal load is not its effect but limits it. The second body is free along the surface, as the paper says. A force normal to the surface takes no power "
        "from a motion along it, and friction does.",
        exhibit(
            r"at the start of Fig. 4 (b) friction takes the power $b\dot z=0.075$ W from a motion along the surface; a normal force takes none",
            SLIPPING,
            (forced.energy_rate(), "=", -sp.Rational("0.075")),
            (v1 - v2, ">", 0),
        ).as_counterexample(),
        carried(
            "tangential",
            identity(
                r"$m_2\dot v_2=b\sigma$: friction is all that acts on body 2 along its motion",
                m2 * forced.forced_system(sigma)[2],
                b * sigma,
            ).as_correction(),
            forced_distance.energy_rate().as_correction(),
        ),
        carried("bounded", transfers.gentle().as_correction()),
        corrected=claim_named("free-interface").corrected,
        counterexample="Fig. 4 (b), $b=0.5$, $\\dot x_1=0.15$, $\\dot x_2=0$: the interface takes 0.075 W, which no force normal to the surface does.",
    )
