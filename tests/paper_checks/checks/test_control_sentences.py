"""What the paper says of control: the verdicts, and faults that must turn them."""

import pytest

from paper_checks.checks import section1_control, section2_force, section5_control
from paper_checks.checks.registry import Context
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import decide
from theory import forced
from theory.symbols import b, u

from .conftest import doubled, finding_of, halved, negated, plus, recorded, unreadable

CHECKS = {
    "one-active-one-passive": section1_control.one_active_one_passive,
    "ring-of-tolerance": section1_control.ring_of_tolerance,
    "target-or-set-point": section1_control.target_or_set_point,
    "force-as-reference-or-disturbance": section2_force.force_as_reference_or_disturbance,
    "driven-body-steered": section5_control.driven_body_steered,
    "damping-for-tracking": section5_control.damping_for_tracking,
    "varying-interface": section5_control.varying_interface,
}
FORCED, CONTROL = "theory.forced.", "theory.forced_control."
ONE, TWO, FIVE = (f"paper_checks.checks.{name}." for name in ("section1_control", "section2_force", "section5_control"))


@pytest.mark.parametrize("claim_id", CHECKS)
def test_the_verdict_is_the_one_on_record(claim_id):
    finding = finding_of(CHECKS[claim_id])
    assert finding.verdict.value == recorded(claim_id), finding.missing
    assert unreadable(finding) == []


@pytest.mark.parametrize(
    ("claim_id", "target", "fault"),
    [
        ("one-active-one-passive", CONTROL + "strongest", doubled),
        ("ring-of-tolerance", CONTROL + "ring_ratio", halved),
        ("ring-of-tolerance", ONE + "INSIDE", lambda point: {**point, section1_control.x1: 1}),
        ("ring-of-tolerance", FORCED + "contraction_rate", negated),
        ("target-or-set-point", CONTROL + "least_time", halved),
        ("target-or-set-point", CONTROL + "stuck_force", negated),
        ("force-as-reference-or-disturbance", TWO + "AT_REST", lambda point: {**point, section2_force.x1: 1}),
        ("force-as-reference-or-disturbance", TWO + "driving_equation", plus(u)),
        ("driven-body-steered", FORCED + "energy_rate", plus(b)),
        ("driven-body-steered", CONTROL + "spread", doubled),
        ("damping-for-tracking", FIVE + "energy", lambda _: lambda: section5_control.x1**2),
        ("varying-interface", FORCED + "place_dependent_rate", negated),
        ("varying-interface", FIVE + "APART", lambda point: {**point, forced.b_other: 3}),
    ],
)
def test_a_fault_turns_the_verdict(plant, claim_id, target, fault):
    plant(target, fault)
    assert decide([CHECKS[claim_id]], Context()).verdict is Verdict.UNDECIDED
