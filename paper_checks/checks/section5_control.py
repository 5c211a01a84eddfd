"""Section V: steering body 2, damping for tracking, and an interface that varies."""

from __future__ import annotations

import sympy as sp

from paper_checks.checks.registry import Context, check
from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.ledger import claim_named
from paper_checks.steps import forced_distance, forced_response, forced_rule, transfers
from theory import forced
from theory.energy import energy
from theory.symbols import a2, b, t, total_mass, v1, v1_other, v2, v2_other, x1

APART = {b: 2, forced.b_other: 1, v1: 1, v2: 0, v1_other: 3, v2_other: 0}
"""Two slips forwards, the slower one where friction is larger (N, m/s)."""


@check("driven-body-steered")
def driven_body_steered(context: Context) -> Finding:  # noqa: ARG001
    """Where body 2 can be brought, and what pays for it."""
    return conclude(
        Verdict.HOLDS,
        "Body 2 can be brought from rest to rest over any distance, by a force on body 1 alone. All energy comes from that force: damper and interface only take.",
        carried("unbounded", transfers.least_time()),
        carried("source", forced_distance.energy_rate()),
    )


def free_difference() -> Evidence:
    """Two stuck motions under one force, a1 = 0: their distance is that of a free oscillation, and constant."""
    frequency = sp.sqrt(a2 / total_mass())
    place = sp.cos(frequency * t)
    difference = {x1: place, v1: sp.diff(place, t), v2: sp.diff(place, t)}
    return identity(
        r"without a damper two stuck motions that differ by a free oscillation stay at one distance",
        sp.diff(energy().subs(difference, simultaneous=True), t),
        0,
    )


@check("damping-for-tracking")
def damping_for_tracking(context: Context) -> Finding:  # noqa: ARG001
    """What a damper adds to the force under which the stuck pair follows a reference."""
    return conclude(
        Verdict.HOLDS,
        "Under the force of trackable-references one motion follows the reference. With a damper and a bounded force every other motion approaches it; without a damper a free oscillation stays. The damper costs $a_1\\dot r$ "
        "in that force. It does not speed up every motion: see damping-can-desynchronise.",
        carried(
            "tracking",
            argument(
                r"The stuck motion along a reference with $|\ddot x_{\mathrm{ref}}|\leqslant b/m_2$ is a motion under its force, and any two motions under a bounded force approach each other where $a_1>0$.",
                transfers.followed(),
                forced_response.approach(),
            ),
            free_difference(),
        ),
    )


@check("varying-interface")
def varying_interface(context: Context) -> Finding:  # noqa: ARG001
    """b(t) keeps the contraction; b(x) does not."""
    rate = forced.place_dependent_rate(1)
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "For friction that varies in time the problem is not open: nothing in the theory asks for a constant $b$. For friction that varies with the state it is, and the tool that settles the other case fails.",
        forced_distance.friction_in_time().as_counterexample(),
        carried(
            "time",
            argument(
                r"At each time the equations are those of a constant friction with the value $b(t)$; at a jump of $b$ the strip changes and the state does not.",
                forced_distance.friction_in_time(),
            ).as_correction(),
        ),
        carried("rule", forced_rule.strict_rule().as_correction(), forced_rule.tie_rule().as_correction()),
        carried(
            "state",
            exhibit(
                "both slip forwards; the slower pair has the larger friction, and their distance grows",
                APART,
                (rate, ">", 0),
                (v1 - v2, ">", 0),
                (v1_other - v2_other, ">", 0),
            ).as_correction(),
            identity(
                r"where both frictions are equal this is the contraction's friction term of two slips of one sign: 0",
                rate.subs(forced.b_other, b),
                0,
            ).as_correction(),
        ),
        corrected=claim_named("varying-interface").corrected,
        counterexample="For $b(t)$ the effect is known: from every start there is one solution, and two solutions never move apart in $N^2=a_2(x_1-\\tilde x_1)^2+m_1(v_1-\\tilde v_1)^2+m_2(v_2-\\tilde v_2)^2$.",
    )
