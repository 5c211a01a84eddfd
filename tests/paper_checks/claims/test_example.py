"""Section IV-A: faults that must turn them."""

import pytest
import sympy as sp

from paper_checks.claims import onset
from paper_checks.claims.points import EDGE, INSIDE, START_AT_6MM
from paper_checks.evidence.finding import Verdict
from theory.symbols import acceleration1, b, x1

from .conftest import CHECKS, doubled, finding_of, negated, squared

EXAMPLE = "paper_checks.claims.example."
ONSET = "paper_checks.claims.onset."
DISSIPATION = "paper_checks.claims.energy."


def with_entry(change):
    """Return a fault that changes one printed pair of right sides."""
    return lambda printed: lambda *sign: printed(*sign) + sp.Matrix(change)


STEP_FAULTS = [
    ("example-reduction", EXAMPLE + "printed_reduction", negated),
    ("example-reduction", EXAMPLE + "printed_reduction", with_entry([200 * x1, 0])),
    ("example-reduction", EXAMPLE + "printed_reduction", with_entry([0, b])),
    ("example-reduction", EXAMPLE + "printed_reduction", with_entry([0, acceleration1])),
    ("example-reduction", EXAMPLE + "START_AT_6MM", lambda _: INSIDE),
    ("example-reduction", EXAMPLE + "START_AT_6MM", lambda _: EDGE),
    ("example-two-modes", EXAMPLE + "residual", lambda _: lambda found: (found.x1,)),
    ("example-stiction-never-violated", ONSET + "START_AT_6MM", lambda _: EDGE),
    ("example-stiction-never-violated", ONSET + "critical_energy", doubled),
    ("example-stiction-never-violated", ONSET + "critical_energy", squared),
    ("example-stiction-never-violated", "paper_checks.claims.filippov.load_threshold", doubled),
    ("example-onset", ONSET + "INSIDE", lambda _: START_AT_6MM),
    ("example-onset", ONSET + "TOGETHER", lambda point: {**point, onset.v1: 1, onset.v2: 1}),
    ("example-onset", ONSET + "half_width", lambda width: lambda: width() / 2),
    ("example-onset", ONSET + "critical_energy", doubled),
    ("example-onset", ONSET + "edge_speed_squared", negated),
    ("example-damped-oscillations", ONSET + "amplitude_squared", lambda amplitude: lambda sign: amplitude(-sign)),
    ("example-damped-oscillations", ONSET + "LONG_SLIP", lambda point: {**point, onset.v2: 0}),
    ("example-damped-oscillations", ONSET + "DRIVEN", lambda point: {**point, onset.v1: 1}),
    ("example-damped-oscillations", DISSIPATION + "energy", doubled),
    ("example-damped-oscillations", DISSIPATION + "slip_rate", negated),
]


@pytest.mark.parametrize(("claim_id", "target", "fault"), STEP_FAULTS)
def test_a_fault_in_a_step_or_a_point_turns_the_claim(plant, claim_id, target, fault):
    plant(target, fault)
    assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED


def test_at_the_edge_the_printed_strict_inequality_fails_too(plant):
    """The counterexample needs |x1''| >= b/m2 only; the row shows the stronger >."""
    evidence = onset.exhibit("", EDGE, (sp.Abs(onset.case_study_mode(0)[0]), ">=", b))
    assert evidence.passed is True


def test_above_the_critical_energy_the_pair_does_not_stay_together(plant):
    """With < instead of <= the proof holds still; with a larger level it must fail."""
    plant(ONSET + "subcritical_level", lambda level: lambda: sp.Le(level().lhs - b**2, 0, evaluate=False))
    assert onset.stays_together()[0].passed is False
