"""Section II: faults that must turn them."""

from dataclasses import replace

import pytest
import sympy as sp

from paper_checks.claims import filippov
from paper_checks.claims.points import INSIDE, START_AT_6MM, at_rest
from paper_checks.evidence.finding import Verdict
from theory.model import RELATIVE_SIGN, STICTION_SIGN
from theory.symbols import acceleration1, b, m2

from .conftest import CHECKS, doubled, finding_of, negated

RESTING_ON_3_AND_4 = {"sgn-three-valued", "modes-from-closed-form", "stiction-bracket", "interface-force-balance"}


def friction_reversed(equation):
    """Eq (4) with the friction force on body 2 reversed."""
    return lambda: equation() - 2 * b * RELATIVE_SIGN


def friction_doubled(equation):
    """Eq (3) with twice the friction force."""
    return lambda: equation() + b * RELATIVE_SIGN


def bracket_reversed(equation):
    """Eq (4) with the stiction bracket 1 + sgn(...) instead of 1 - sgn(...)."""
    return lambda: equation().subs(STICTION_SIGN, -STICTION_SIGN)


def half_forgotten(equation):
    """Eq (4) without the factor 1/2."""
    adhesion = m2 * acceleration1 * (1 - sp.Abs(RELATIVE_SIGN)) * (1 - STICTION_SIGN) / 2
    return lambda: equation() + adhesion


MODEL_FAULTS = [
    ("theory.model.driven_equation", friction_reversed, RESTING_ON_3_AND_4 - {"stiction-bracket"}),
    ("theory.model.driving_equation", friction_doubled, RESTING_ON_3_AND_4 - {"stiction-bracket"}),
    ("theory.model.driven_equation", bracket_reversed, RESTING_ON_3_AND_4),
    ("theory.model.driven_equation", half_forgotten, RESTING_ON_3_AND_4),
]


@pytest.mark.parametrize(
    ("target", "fault", "turned"), MODEL_FAULTS, ids=lambda value: getattr(value, "__name__", None)
)
def test_a_fault_in_the_model_turns_the_claims_that_rest_on_it(plant, target, fault, turned):
    plant(target, fault)
    if fault in (bracket_reversed, half_forgotten):
        plant("paper_checks.claims.filippov.driven_equation", fault)
    for claim_id in turned:
        assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED, claim_id


STEPS, LAWS = "paper_checks.claims.filippov.", "paper_checks.claims.signum."
SIGNUM = "paper_checks.claims.signum."
MODEL = "paper_checks.claims.model."


def failing(original):
    """A step that has failed."""
    return lambda *given: replace(original(*given), passed=False)


STEP_FAULTS = [
    ("sgn-three-valued", STEPS + "sliding_field", doubled),
    ("sgn-three-valued", STEPS + "load_threshold", doubled),
    ("sgn-three-valued", STEPS + "load", negated),
    ("sgn-three-valued", STEPS + "contraction_rate", negated),
    ("sgn-three-valued", STEPS + "contraction_terms", lambda terms: lambda: (terms()[0], -terms()[1])),
    ("sgn-three-valued", STEPS + "_share", doubled),
    ("sgn-three-valued", SIGNUM + "transversality", negated),
    ("sgn-three-valued", SIGNUM + "INSIDE", lambda _: at_rest("0")),
    ("sgn-three-valued", SIGNUM + "CONTROL", lambda control: 2 * control),
    ("sgn-three-valued", SIGNUM + "INSIDE", lambda _: START_AT_6MM),
    ("sgn-three-valued", SIGNUM + "residual", lambda _: lambda found: (found.x1,)),
    ("sgn-three-valued", LAWS + "spurious_branch", failing),
    ("modes-from-closed-form", "theory.forced.load", doubled),
    ("modes-from-closed-form", MODEL + "START_AT_6MM", lambda _: INSIDE),
    ("modes-from-closed-form", MODEL + "EDGE", lambda _: INSIDE),
    ("modes-from-closed-form", MODEL + "mode_equations", lambda modes: lambda sign: modes(-sign)),
    ("stiction-bracket", MODEL + "INSIDE", lambda _: START_AT_6MM),
    ("stiction-bracket", MODEL + "EDGE", lambda _: START_AT_6MM),
    ("stiction-bracket", MODEL + "adhesion_factor", doubled),
    ("interface-force-balance", MODEL + "START_AT_6MM", lambda _: INSIDE),
    ("interface-force-balance", MODEL + "EDGE", lambda _: START_AT_6MM),
]


@pytest.mark.parametrize(("claim_id", "target", "fault"), STEP_FAULTS)
def test_a_fault_in_a_step_or_a_point_turns_the_claim(plant, claim_id, target, fault):
    plant(target, fault)
    assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED


def test_the_strict_inequality_is_what_lets_the_spurious_branches_leave(plant):
    """With |x1''| >= 0 instead of >= b/m2 they could stay: the proof must fail."""
    plant("paper_checks.claims.filippov.b", lambda _: sp.Integer(0))
    assert filippov.spurious_branches_leave().passed is not True


def test_a_value_outside_the_set_valued_sign_breaks_the_contraction(plant):
    """Friction that may exceed b on S would let two solutions move apart."""
    plant(
        "paper_checks.claims.filippov.set_valued_sign",
        lambda _: lambda value, velocity: sp.And(sp.Le(sp.Abs(value), 2), sp.Lt(sp.Abs(velocity), 1)),
    )
    assert filippov.never_apart().passed is False
