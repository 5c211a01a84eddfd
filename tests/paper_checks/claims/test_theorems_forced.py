"""Theorems under a force: faults in theory and in the steps that must turn them."""

from dataclasses import replace

import pytest
import sympy as sp

from paper_checks.claims import CLAIMS, claim_named, stuck, tolerance, transfers
from paper_checks.evidence.claim import Kind
from paper_checks.evidence.evidence import closure
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide
from theory.symbols import a1, b, v1

from .conftest import CHECKS, doubled, finding_of, misread, negated, plus, two_of_each

FORCED, RESPONSE, CONTROL = "theory.forced.", "theory.forced_response.", "theory.forced_control."
JUMP, TWO_LAWS = "theory.jumping_force.", "paper_checks.claims.signum."
RULE, DISTANCE = "paper_checks.claims.forced_modes.", "paper_checks.claims.contraction."
TRANSFERS, TOLERANCE = "paper_checks.claims.transfers.", "paper_checks.claims.tolerance."
AHEAD = sp.Matrix([0, 1, 0])


def broken(original):
    """Return a step that has failed."""
    return lambda *given: replace(original(*given), passed=False)


def entry(index, change):
    """Return a fault that changes one of several expressions."""
    return lambda original: (
        lambda *given: tuple(change(one) if place == index else one for place, one in enumerate(original(*given)))
    )


STEP_FAULTS = [
    ("forced-mode-rule", FORCED + "coupling", doubled),
    ("forced-no-zeno", FORCED + "excess_load", doubled),
    ("varying-interface", RULE + "sp", misread("Lt", "Le", 0)),
    ("varying-interface", RULE + "sp", misread("Gt", "Ge", 0)),
    ("forced-no-zeno", FORCED + "deviation_force", plus(b)),
    ("forced-contraction", FORCED + "energy_rate", plus(a1 * v1**2)),
    ("forced-contraction", FORCED + "distance_rate", doubled),
    ("forced-contraction", DISTANCE + "sp", misread("Le", "Ge", 0)),
    ("forced-periodic-response", FORCED + "undamped_difference", entry(1, lambda value: -value)),
    ("forced-periodic-response", JUMP + "contact_state", plus(AHEAD)),
    ("forced-periodic-response", JUMP + "after_half_period", negated),
    ("forced-periodic-response", JUMP + "loads", entry(1, lambda value: value / 2)),
    ("forced-periodic-response", JUMP + "apart_squared", doubled),
    ("forced-periodic-response", JUMP + "slowest_and_fastest", entry(1, lambda value: value + 1)),
    ("forced-resonance-bound", RESPONSE + "mean_absolute_cosine", doubled),
    ("forced-resonance-bound", RESPONSE + "path_beside", doubled),
    ("entrainment-threshold", RESPONSE + "stuck_impedance", negated),
    ("entrainment-threshold", RESPONSE + "harmonic_slope", plus(1)),
    ("entrainment-threshold", RESPONSE + "square_wave", entry(0, lambda value: 2 * value)),
    ("entrainment-threshold", RESPONSE + "half_turn", plus(1)),
    ("entrainment-threshold", RESPONSE + "non_stop_parts", entry(1, lambda value: -value)),
    ("entrainment-threshold", RESPONSE + "short_slip", entry(1, lambda value: value / 2)),
    ("entrainment-threshold", RESPONSE + "two_stop_conditions", entry(2, lambda value: value + 1)),
    ("driven-body-steered", CONTROL + "strongest", doubled),
    ("trackable-references", CONTROL + "stuck_force", negated),
    ("minimum-transfer-time", CONTROL + "switching", entry(0, lambda value: value / 2)),
    ("minimum-transfer-time", CONTROL + "pressed", doubled),
    ("driven-body-steered", CONTROL + "farthest", doubled),
    ("minimum-transfer-time", TWO_LAWS + "sp", misread("Gt", "Ge", 0)),
    ("trackable-references", TWO_LAWS + "spurious_branch", broken),
    ("minimum-transfer-time", TRANSFERS + "sp", misread("Ge", "Le", 0)),
    ("tolerance-ring", CONTROL + "ring_ratio", doubled),
    ("tolerance-ring", CONTROL + "ring_radius", doubled),
    ("ring-of-tolerance", CONTROL + "path_per_energy", doubled),
    ("tolerance-ring", TOLERANCE + "sp", misread("Le", "Ge", 0)),
    ("damping-can-desynchronise", FORCED + "creeping_load", negated),
]


@pytest.mark.parametrize(("claim_id", "target", "fault"), two_of_each(STEP_FAULTS))
def test_a_fault_in_a_step_turns_the_theorem(plant, claim_id, target, fault):
    plant(target, fault)
    assert decide(CHECKS[claim_id], Context()).verdict is Verdict.UNDECIDED


def test_no_step_of_these_proofs_is_a_sample():
    subjects = ("forced_modes", "contraction", "response", "entrainment", "control", "tolerance")
    ours = [one for one in CLAIMS if one.kind is Kind.THEOREM and one.case.__module__.rpartition(".")[2] in subjects]
    assert len(ours) == 10
    for claim in ours:
        assert all(step.kind.decisive for step in closure(finding_of(claim).evidence))


def test_what_is_open_is_said():
    for name in ("entrainment-threshold", "forced-resonance-bound", "minimum-transfer-time"):
        assert claim_named(name).open


def test_steps_name_what_they_cite():
    cited = {cite for step in closure([stuck.sticks_for_ever()]) for cite in step.cites}
    assert any("nonexpansive" in one for one in cited)
    assert not any(step.cites for step in closure([transfers.weak_force(), tolerance.ring_contains()]))
