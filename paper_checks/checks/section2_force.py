"""Section II: what the force u(t) stands for."""

from __future__ import annotations

import sympy as sp

from paper_checks.checks.registry import Context, check
from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.ledger import claim_named
from paper_checks.ledger.points import EXAMPLE_PAIR
from paper_checks.ledger.section2 import DISTURBANCE, REFERENCE, REFERENCE_RATE, STIFFNESS, VISCOSITY
from theory.model import driven_equation, driving_equation
from theory.symbols import a1, a2, u, v1, x1

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
