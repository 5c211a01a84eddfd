"""Abstract and Section I: the passive body, the tolerance ring of Fig. 1, targets and set-points."""

from __future__ import annotations

import sympy as sp

from paper_checks.checks.registry import Context, check
from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit
from paper_checks.evidence.evidence import argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.ledger import claim_named
from paper_checks.ledger.points import INSIDE
from paper_checks.steps import forced_response, tolerance, transfers, two_laws
from theory import forced
from theory.energy import critical_energy, on_surface, sigma
from theory.symbols import m1, u, v1, x1, x2

OTHER_PLACE = sp.Symbol(r"\tilde{x}_2", real=True)


@check("one-active-one-passive")
def one_active_one_passive(context: Context) -> Finding:  # noqa: ARG001
    """Where the force stands in the equations of motion."""
    field = forced.forced_system(sigma)
    return conclude(
        Verdict.HOLDS,
        "The force acts on body 1 alone. Body 2 feels nothing but friction, which is never more than b: it moves only as the interface lets it.",
        carried(
            "freedoms",
            argument(
                "A degree of freedom is active if the control acts on it, passive if only the interface does.",
                identity(
                    r"$u$ stands in the equation of body 1 alone",
                    sp.Matrix([sp.diff(entry, u) * mass for entry, mass in zip(field, (1, m1, 1), strict=True)]),
                    sp.Matrix([0, 1, 0]),
                ),
                transfers.gentle(),
            ),
        ),
    )


@check("ring-of-tolerance")
def ring_of_tolerance(context: Context) -> Finding:  # noqa: ARG001
    """What the contraction gives of Fig. 1, and the coordinate that it does not see."""
    start, moved = {**INSIDE, x2: 0}, {**INSIDE, x2: sp.Rational("0.001")}
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "With a damper the ring of Fig. 1 is reached and not left, in the relative velocity and around the one response. In the relative displacement there is no orbit that attracts: nothing "
        "acts on it, so each start keeps its own.",
        exhibit(
            "both starts are on $S$ with $E\\leqslant E_{cr}$, so both pairs stick for ever",
            start,
            (on_surface(), "<=", critical_energy()),
            (v1, "=", 0),
        ).as_counterexample(),
        tolerance.sticks_for_ever_below().as_counterexample(),
        tolerance.blind_to_x2().as_counterexample(),
        exhibit(
            "their relative displacements stay 1 mm apart",
            {**start, OTHER_PLACE: moved[x2]},
            (sp.Abs((x1 - x2) - (x1 - OTHER_PLACE)), "=", sp.Rational("0.001")),
        ).as_counterexample(),
        carried("response", forced_response.one_response().as_correction(), tolerance.entered_once().as_correction()),
        carried("velocity", tolerance.ring_contains().as_correction()),
        carried("displacement", tolerance.centre().as_correction()),
        corrected=claim_named("ring-of-tolerance").corrected,
        counterexample="The pair of Section IV with $b=0.5$, at rest at $x_1=0.004$, once with $x_2(0)=0$ and once with $x_2(0)=0.001$: both stick for ever, and the relative motions "
        "$(x_1-x_2,\\dot x_1-\\dot x_2)$ rest at $(0.004,0)$ and at $(0.003,0)$. No ring narrower than 1 mm that holds one of them is ever reached by the other.",
        derivation=(r"$$\tfrac12\tfrac{d}{dt}N^2\leqslant 0,\qquad (\dot z-\dot{\tilde z})^2\leqslant\kappa\,N^2.$$",),
    )


@check("target-or-set-point")
def target_or_set_point(context: Context) -> Finding:  # noqa: ARG001
    """Which targets and which set-points there are."""
    return conclude(
        Verdict.HOLDS,
        "There is such control, and a set-point is the simpler of the two: from rest every one can be reached, in no less than $2\\sqrt{m_2D/b}$, and held, while a target trajectory can be followed exactly if "
        "it never asks for more acceleration than $b/m_2$. At just $b/m_2$ that is so under Coulomb's law, which (3)–(4) then are not; below it under both.",
        carried("target", transfers.followed(), two_laws.stuck_below_the_limit()),
        carried("set-point", transfers.least_time(), two_laws.stuck_below_the_limit()),
    )
