"""Section V: faults that must turn them."""

from dataclasses import replace

import pytest
import sympy as sp

from paper_checks.claims.points import INSIDE, START_AT_6MM
from paper_checks.evidence.finding import Verdict
from theory.symbols import a1, b, m1, v2

from .conftest import CHECKS, doubled, finding_of, negated, other_sign, squared, two_of_each

SYNCHRONISATION = "paper_checks.claims.synchronisation."
DISCUSSION = "paper_checks.claims.discussion."
DISSIPATION = "paper_checks.claims.energy."
SOLUTIONS = "paper_checks.claims.filippov."
SLIPS = "paper_checks.claims.itineraries."


def without(*symbols):
    """Return a fault that drops the terms with these symbols from an expression."""
    return lambda original: lambda: original().subs(dict.fromkeys(symbols, 0))


STEP_FAULTS = [
    ("synchronisation-all-parameters", DISSIPATION + "energy", negated),
    ("synchronisation-all-parameters", DISSIPATION + "free_system", other_sign),
    ("synchronisation-all-parameters", DISSIPATION + "energy", lambda energy: lambda: energy() / 2),
    ("synchronisation-all-parameters", DISSIPATION + "energy", lambda energy: lambda: energy() - m1 * v2**2),
    ("synchronisation-all-parameters", DISSIPATION + "lipschitz_constant", without(b)),
    ("synchronisation-all-parameters", DISSIPATION + "lipschitz_constant", lambda bound: lambda: bound() / 2),
    ("synchronisation-all-parameters", DISSIPATION + "sliding_field", lambda _: lambda damped: sp.Matrix([0, b, -b])),
    (
        "finite-time-then-alternation",
        "paper_checks.claims.excursions.half_angle_slope",
        lambda f: lambda: (f()[0], 2 * f()[1]),
    ),
    ("finite-time-then-alternation", SLIPS + "exact", lambda exact: lambda _: exact(1)),
    ("finite-time-then-alternation", SLIPS + "next_excess", doubled),
    ("finite-time-then-alternation", SLIPS + "next_excess", squared),
    ("finite-time-then-alternation", SLIPS + "r", lambda r: 3 * r),
    ("finite-time-then-alternation", SYNCHRONISATION + "INSIDE", lambda _: START_AT_6MM),
    ("finite-time-then-alternation", "paper_checks.claims.capture.critical_energy", doubled),
    ("viscous-accelerates", SYNCHRONISATION + "captive_energy", lambda level: lambda: level() / 2),
    ("viscous-accelerates", DISSIPATION + "captive_energy", squared),
    ("viscous-accelerates", DISSIPATION + "load", negated),
    ("viscous-accelerates", DISSIPATION + "load_threshold", doubled),
    ("viscous-accelerates", SYNCHRONISATION + "DAMPED", lambda point: {**point, a1: 0}),
    ("two-descriptions", DISCUSSION + "APART", lambda apart: 2 * apart),
    ("two-descriptions", DISCUSSION + "START_AT_6MM", lambda _: INSIDE),
    ("two-descriptions", DISCUSSION + "phi", lambda phi: lambda sign: phi(-sign)),
    ("two-descriptions", DISCUSSION + "sliding_field", doubled),
    ("two-descriptions", SOLUTIONS + "contraction_rate", negated),
    ("acceleration-bound", DISCUSSION + "START_AT_6MM", lambda _: INSIDE),
    ("acceleration-bound", DISCUSSION + "b", lambda b: 2 * b),
    ("acceleration-bound", DISCUSSION + "load_threshold", doubled),
    ("acceleration-bound", DISCUSSION + "sliding_field", lambda field: lambda damped=False: 2 * field(damped)),
]


@pytest.mark.parametrize(("claim_id", "target", "fault"), two_of_each(STEP_FAULTS))
def test_a_fault_in_a_step_or_a_point_turns_the_claim(plant, claim_id, target, fault):
    plant(target, fault)
    assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED


def test_a_strict_bound_of_the_acceleration_fails_at_the_edge():
    """|x2''| < b/m2 instead of <=: the edge of S0 is a counterexample."""
    bound = next(one for one in CHECKS["acceleration-bound"].correction if one.id == "modes").formulas["stick"]
    assert bound.evidence().passed is True
    assert replace(bound, relation="<").evidence().passed is False
