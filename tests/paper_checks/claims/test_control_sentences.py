"""What the paper says of control: faults that must turn them."""

from dataclasses import replace

import pytest

from paper_checks.claims import force, steering
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide
from theory import forced, plane
from theory.symbols import b, u, x1

from .conftest import CHECKS, doubled, halved, misread, negated, plus

FORCED, CONTROL = "theory.forced.", "theory.forced_control."
ONE, TWO, FIVE = (f"paper_checks.claims.{name}." for name in ("control", "force", "steering"))


@pytest.mark.parametrize(
    ("claim_id", "target", "fault"),
    [
        ("one-active-one-passive", CONTROL + "strongest", doubled),
        ("ring-of-tolerance", CONTROL + "ring_ratio", halved),
        ("ring-of-tolerance", "paper_checks.claims.tolerance.INSIDE", lambda point: {**point, x1: 1}),
        ("ring-of-tolerance", FORCED + "contraction_rate", negated),
        ("target-or-set-point", CONTROL + "least_time", halved),
        ("target-or-set-point", CONTROL + "stuck_force", negated),
        ("force-as-reference-or-disturbance", TWO + "AT_REST", lambda point: {**point, force.x1: 1}),
        ("force-as-reference-or-disturbance", TWO + "driving_equation", plus(u)),
        ("driven-body-steered", FORCED + "energy_rate", plus(b)),
        ("driven-body-steered", CONTROL + "spread", doubled),
        ("damping-for-tracking", FIVE + "PLACE", lambda place: place + 1),
        ("damping-for-tracking", FIVE + "SINE", lambda scene: replace(scene, initial=steering.State())),
        ("damping-for-tracking", "theory.forced.contraction_rate", negated),
        ("motions-on-a-surface", "theory.plane.against_slip", doubled),
        ("motions-on-a-surface", "theory.plane.by_components", lambda _: plane.by_direction),
        ("motions-on-a-surface", "theory.plane.by_direction", lambda _: lambda slip: b * slip),
        ("motions-on-a-surface", "theory.plane.contraction_by_friction", negated),
        ("motions-on-a-surface", "theory.plane.energy_rate", negated),
        ("free-interface", TWO + "SLIPPING", lambda point: {**point, force.sigma: 0}),
        ("free-interface", CONTROL + "strongest", doubled),
        ("varying-interface", "paper_checks.claims.contraction.sp", misread("Ge", "Le", 1)),
        ("varying-interface", FORCED + "place_dependent_rate", negated),
        ("varying-interface", FIVE + "APART", lambda point: {**point, forced.b_other: 3}),
    ],
)
def test_a_fault_turns_the_verdict(plant, claim_id, target, fault):
    plant(target, fault)
    assert decide(CHECKS[claim_id], Context()).verdict is Verdict.UNDECIDED
