"""Past the paper: what a force makes body 2 do, the tolerance ring, and damping that breaks adhesion."""

from __future__ import annotations

from paper_checks.checks.registry import Context, check
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.steps import tolerance, transfers, two_laws


@check("trackable-references")
def trackable_references(context: Context) -> Finding:  # noqa: ARG001
    """Friction is the only force on body 2."""
    return conclude(
        Verdict.HOLDS,
        "Friction is all that the interface can pass on to body 2. Every reference that asks for no more can be followed, by a pair that sticks, under a force that can be written down.",
        carried("iff", transfers.followed()),
        carried("literal", two_laws.stuck_below_the_limit()),
        carried("sticks", transfers.must_stick()),
        carried("force", transfers.stuck_force()),
    )


@check("minimum-transfer-time")
def minimum_transfer_time(context: Context) -> Finding:  # noqa: ARG001
    """A bound for every control, and what attaining it costs."""
    return conclude(
        Verdict.HOLDS,
        "The least time is set by the interface alone, whatever the force. How strong a force must be is another matter: body 1 can run ahead of body 2 through the first half and be met at half time, which takes less than to stick all the way.",
        carried("reach", transfers.spread()),
        carried("least", transfers.least_time()),
        carried("literal", two_laws.stuck_below_the_limit()),
        carried("stuck", transfers.stuck_amplitude()),
        carried("slip", transfers.slipping_amplitude()),
        carried("slip-undamped", transfers.undamped_slipping_amplitude(), transfers.slipping_amplitude()),
        carried("weak", transfers.weak_force()),
        derivation=(r"$$g(t_{1/2}+s)-2g(s)\leqslant g(t_{1/2})-g(s)\leqslant g(t_{1/2})\,(1-s/t_{1/2}).$$",),
    )


@check("tolerance-ring")
def tolerance_ring(context: Context) -> Finding:  # noqa: ARG001
    """The distance never grows; its image in the relative plane."""
    return conclude(
        Verdict.HOLDS,
        "A ring that holds the image of the tube is reached no later than the tube, and not left after that. The energy distance does not see the relative displacement, so the ring is centred on its limit.",
        carried("tube", tolerance.entered_once()),
        carried("ring", tolerance.ring_contains()),
        carried("blind", tolerance.blind_to_x2()),
        carried("centre", tolerance.centre()),
    )


@check("damping-can-desynchronise")
def damping_can_desynchronise(context: Context) -> Finding:  # noqa: ARG001
    """A damper pulls at body 1 only."""
    return conclude(
        Verdict.HOLDS,
        "A damper acts on body 1 alone, so a strong one tears a moving pair apart that would have stuck for ever without it: more damping is not always faster synchronisation.",
        carried("sticks", tolerance.sticks_without()),
        carried("breaks", tolerance.breaks_with()),
        carried("heavy", tolerance.heavy_damping()),
    )
