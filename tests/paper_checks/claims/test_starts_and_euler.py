"""Section IV-B: faults that must turn them."""

from dataclasses import replace
from fractions import Fraction
from functools import partial

import pytest

from numerics.scene import Pair, Scene, State
from numerics.scene.file import load_scene
from numerics.trade.comparisons.forward_euler import forward_euler
from paper_checks.claims import euler, velocities
from paper_checks.claims.itineraries import never_merges
from paper_checks.decide.enclosure import solved
from paper_checks.decide.euler_in_balls import STEPS, euler_in_balls, run
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide

from .conftest import CHECKS, doubled, finding_of, negated, squared

OTHER_SCENES = [
    ("start-at-6mm-sticks", {"start": Fraction(5, 1000)}),  # on the edge: it does stick for ever
    ("start-at-6mm-sticks", {"start": Fraction(7, 1000)}),
    ("start-with-speed-synchronises", {"speed": Fraction(8, 100)}),  # merges at its first contact
    ("relative-motion-converges", {"speed": Fraction(5, 1000)}),  # merges: it takes no infinite time
    ("constant-damping-rate", {"friction": Fraction(2, 10)}),
    ("saw-tooth", {"friction": Fraction(6, 100)}),
    ("synchronisation-time", {"friction": Fraction(6, 100)}),
    ("synchronisation-time", {"time": Fraction(456, 100)}),  # inside the first adhesion
]


@pytest.mark.parametrize(("claim_id", "changed"), OTHER_SCENES)
def test_another_scene_does_not_carry_the_verdict(claim_id, changed):
    claim = CHECKS[claim_id]
    finding = decide(replace(claim, case=partial(claim.case, **changed)), Context())
    assert finding.verdict is Verdict.UNDECIDED


def named(check):
    """A partial with the name that an error message asks for."""
    check.__name__ = check.func.__name__
    return check


ENDLESS = {
    "start-at-6mm-sticks",
    "start-with-speed-synchronises",
    "relative-motion-converges",
    "synchronisation-time",
}
THEORY_FAULTS = [
    ("paper_checks.claims.starts.half_width", doubled, {"start-at-6mm-sticks"}),
    ("paper_checks.claims.starts.transversality", negated, {"start-at-6mm-sticks"}),
    ("paper_checks.claims.itineraries.next_excess", doubled, ENDLESS),
    ("paper_checks.claims.itineraries.h", squared, ENDLESS),
    ("paper_checks.claims.itineraries.guard_of_u", doubled, ENDLESS - {"start-at-6mm-sticks"}),
]


@pytest.mark.parametrize(("target", "fault", "turned"), THEORY_FAULTS)
def test_a_fault_in_theory_turns_the_claims_that_rest_on_it(plant, target, fault, turned):
    plant(target, fault)
    for claim_id in turned:
        assert decide(CHECKS[claim_id], Context()).verdict is Verdict.UNDECIDED, claim_id


def test_a_fault_in_the_slip_field_turns_the_saw_tooth_and_the_decay(monkeypatch):
    """The branch of the other sign in slip."""
    original = velocities.slip
    monkeypatch.setattr(velocities, "slip", lambda sign: original(-sign))
    for claim_id in ("saw-tooth", "constant-damping-rate"):
        assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED


def test_a_fault_in_the_sliding_field_turns_the_euler_claim(monkeypatch):
    original = euler.sliding_field
    monkeypatch.setattr(euler, "sliding_field", lambda: 2 * original())
    assert finding_of(euler.euler_reproduces_figures).verdict is Verdict.UNDECIDED


def test_a_run_that_meets_the_surface_turns_the_euler_claim(monkeypatch):
    """From v1 = 2 one step of 1 s takes exactly 2 from z': it lands on z' = 0."""
    scene = Scene(Pair(m1=1, m2=1, a2=1, b=1), State(v1=2), until=3)
    landed = euler_in_balls(scene, Fraction(1), Fraction(3))
    assert landed.contact == 1
    monkeypatch.setattr(euler, "run", lambda name, h: replace(run(name, h), contact=landed.contact))
    assert finding_of(euler.euler_reproduces_figures).verdict is Verdict.UNDECIDED


def test_euler_in_balls_is_the_program_without_rounding():
    scene = load_scene("start-with-speed")
    program, method = forward_euler(scene, 1e-3), euler_in_balls(scene, Fraction(1, 1000), Fraction(5))
    assert method.chatter == program.chatter
    assert float(method.energy_ratio.mid()) == pytest.approx(program.energy[-1] / program.energy[0], rel=1e-9)


@pytest.mark.parametrize("changed", [{"b": "0.05", "m2": 2}])
def test_the_argument_for_endless_slips_refuses_a_heavier_driven_body(changed):
    scene = replace(load_scene("velocities"), pair=Pair(m1=1, a2=200, **changed))
    with pytest.raises(ValueError, match="m2 <= m1"):
        never_merges(solved(scene), "heavier")


def test_the_steps_of_euler_reach_over_three_decades():
    assert max(STEPS) / min(STEPS) == 1000
