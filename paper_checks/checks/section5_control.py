"""Section V: steering body 2, damping for tracking, and an interface that varies."""

from __future__ import annotations

import sympy as sp

from numerics.linear.modes import Mode
from numerics.scene import Force, Pair, Scene, State
from paper_checks.checks.registry import Context, check
from paper_checks.engines.enclosure import ball, compare, exact, itinerary, rounded, solved
from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.ledger import claim_named
from paper_checks.steps import (
    entrainment,
    forced_distance,
    forced_response,
    forced_rule,
    tolerance,
    transfers,
    two_laws,
)
from theory import forced
from theory.energy import energy
from theory.model import stick
from theory.symbols import a1, a2, b, m1, m2, t, total_mass, u, v1, v1_other, v2, v2_other, x1

APART = {b: 2, forced.b_other: 1, v1: 1, v2: 0, v1_other: 3, v2_other: 0}
"""Two slips forwards, the slower one where friction is larger (N, m/s)."""


@check("driven-body-steered")
def driven_body_steered(context: Context) -> Finding:  # noqa: ARG001
    """Where body 2 can be brought, and what pays for it."""
    return conclude(
        Verdict.HOLDS,
        "Body 2 can be brought from rest to rest over any distance, by a force on body 1 alone, under (3)–(4) and under Coulomb's law (in just the least time by a stuck pair: under the latter only). All energy comes "
        "from that force: damper and interface only take.",
        carried("unbounded", two_laws.stuck_below_the_limit(), transfers.least_time()),
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


SINE = Scene(Pair(1, 1, 1, 1, 1), State(x2="-1/4", v2="-1/4"), until=60, force=Force.sine("1/2", 1))
"""A pair under u = sin(t)/2 N; body 2 starts with the place and the velocity of the stuck response, body 1 at rest."""
PLACE = -(sp.sin(t) + sp.cos(t)) / 4
"""That response, m: unit masses, a1 = a2 = b = 1 in SI units."""


def is_the_response() -> Evidence:
    """The place that is called the reference solves the equation of the stuck pair, with less than all of the friction."""
    known = {m1: 1, m2: 1, a1: 1, a2: 1, b: 1, u: sp.sin(t) / 2, x1: PLACE, v1: sp.diff(PLACE, t)}
    return identity(
        r"$x_{\mathrm{ref}}=-(\sin t+\cos t)/4$ is stuck under $u=\frac12\sin t$, with $\ddot x_{\mathrm{ref}}^2=(1+\sin 2t)/16<1$",
        sp.Matrix([stick().acceleration1.subs(known), sp.diff(PLACE, t, 2) ** 2]),
        sp.Matrix([sp.diff(PLACE, t, 2), (1 + 2 * sp.sin(t) * sp.cos(t)) / 16]),
    )


def off_the_place() -> tuple[Evidence, ...]:
    """The pair solved in balls: at the end velocities agree with the reference, body 2 is away from it."""
    run = solved(SINE)
    end, time = run.sol(SINE.until), sp.Rational(SINE.until)
    place, velocity = ball(PLACE.subs(t, time)), ball(sp.diff(PLACE, t).subs(t, time))
    return (
        is_the_response(),
        itinerary("the pair slips with $\\dot z>0$, then sticks", run, [Mode.SLIP_PLUS, Mode.STICK]),
        compare(
            "after 60 s body 2 has the velocity of the reference (difference, m/s)",
            abs(end[3] - velocity),
            "<",
            exact(sp.Rational(1, 10**6)),
        ),
        compare("and is far from its place (m)", abs(end[2] - place), ">", exact(sp.Rational(1, 4))),
    )


@check("damping-for-tracking")
def damping_for_tracking(context: Context) -> Finding:  # noqa: ARG001
    """What a damper adds to the force under which the stuck pair follows a reference, and what it leaves."""
    apart = solved(SINE).sol(SINE.until)[2] - ball(PLACE.subs(t, sp.Rational(SINE.until)))
    offset = off_the_place()
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "The velocity of body 2 tracks, its place may be left with an offset. Under the force of trackable-references one motion follows the reference. With a damper and a bounded "
        "force every other motion approaches it in $(x_1,v_1,v_2)$; without a damper a free oscillation stays. But no force depends on $x_2$, of which the paper says that it is a variable of interest. The damper costs "
        "$a_1\\dot x_{\\mathrm{ref}}$ in that force. It does not speed up every motion: see damping-can-desynchronise.",
        *(item.as_counterexample() for item in offset),
        carried("approach", forced_response.approach().as_correction()),
        carried(
            "velocity",
            argument(
                r"The stuck motion along a reference with $|\ddot x_{\mathrm{ref}}|\leqslant b/m_2$ is a motion under its force, and any two motions under a bounded force approach each other where $a_1>0$.",
                transfers.followed(),
                forced_response.approach(),
            ).as_correction(),
        ),
        carried("place", tolerance.blind_to_x2().as_correction()),
        carried(
            "offset",
            argument(
                "Near the response the load stays inside the strip, so the stick of the example lasts, and $x_2-x_1$ with it, while $x_1$ tends to the reference.",
                *offset,
                entrainment.sticks_for_ever(),
            ).as_correction(),
        ),
        free_difference(),
        corrected=claim_named("damping-for-tracking").corrected,
        counterexample="$m_1=m_2=a_1=a_2=b=1$, $u=\\frac12\\sin t$, $x_{\\mathrm{ref}}=-\\frac14(\\sin t+\\cos t)$, $x_2(0)=x_{\\mathrm{ref}}(0)$, "
        "$v_2(0)=\\dot x_{\\mathrm{ref}}(0)$, body 1 at rest at $0$: after 60 s $v_2$ is right to $10^{-6}$ m/s, and $x_2-x_{\\mathrm{ref}}=$ "
        f"${rounded(1000 * apart, 1)}$ mm, where $x_{{\\mathrm{{ref}}}}$ has the amplitude 354 mm.",
    )


@check("varying-interface")
def varying_interface(context: Context) -> Finding:  # noqa: ARG001
    """b(t) keeps the contraction; b(x) does not."""
    rate = forced.place_dependent_rate(1)
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "For friction that varies in time the problem is not open: nothing in the theory asks for a constant $b$. Where it varies with the state two motions may move apart, but a start still has one motion, and friction that "
        "stays above some least value still brakes every relative motion down; how the long run looks then is open.",
        forced_distance.friction_in_time().as_counterexample(),
        carried(
            "time",
            argument(
                r"At each time the equations are those of a constant friction with the value $b(t)$; at a jump of $b$ the strip changes and the state does not.",
                forced_distance.friction_in_time(),
            ).as_correction(),
        ),
        carried("rate", forced_distance.pieces_without_end().as_correction()),
        carried("unique", forced_distance.friction_of_the_state().as_correction()),
        carried("synchronises", forced_distance.braked().as_correction()),
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
