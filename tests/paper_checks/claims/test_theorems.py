"""Theorems past the paper: faults in their steps that must turn them."""

from functools import cache

import pytest
import sympy as sp
from flint import arb

from paper_checks.claims import long_time, merging_share
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide
from theory.symbols import q, theta

from .conftest import (
    CHECKS,
    doubled,
    halved,
    misread,
    negated,
    plus,
    squared,
    two_of_each,
)

SLIPS = "paper_checks.claims.slips."
SHARE = "paper_checks.claims.critical_ratio."
WINDOW = "paper_checks.claims.merging."
MAP = "paper_checks.claims.return_map."
RATE = "paper_checks.claims.rate."
LATE = "paper_checks.claims.long_time."
REENTRY = "paper_checks.claims.merging."
UNIFORM = "paper_checks.claims.uniform_rate."
MEASURE = "paper_checks.claims.merging_share."
BANDS = "paper_checks.claims.merging_share."


def entry(index, change):
    """Return a fault that changes one of several expressions."""

    def fault(original):
        def changed(*arguments):
            found = list(original(*arguments))
            found[index] = change(found[index])
            return tuple(found)

        return changed

    return fault


def raised(value):
    return value + sp.Rational(1, 100)


STEP_FAULTS = [
    ("excursion-closed-form", SLIPS + "guard_residual", plus(theta)),
    ("excursion-closed-form", SLIPS + "contact_slope_residual", plus(1)),
    ("excursion-closed-form", SLIPS + "landing_residuals", entry(2, lambda zero: zero + q)),
    ("excursion-closed-form", SLIPS + "depth_slope_residual", plus(theta)),
    ("excursion-closed-form", SLIPS + "guard_factors", entry(0, lambda factor: -factor)),
    ("excursion-closed-form", SLIPS + "depth", negated),
    ("excursion-closed-form", SLIPS + "turning_angle", plus(1)),
    ("excursion-closed-form", SLIPS + "sp", misread("Gt", "Ge")),
    ("excursion-monotone", SLIPS + "cusa_huygens", negated),
    ("excursion-monotone", SLIPS + "cusa_huygens", plus(theta**3)),
    ("excursion-monotone", SLIPS + "h", squared),
    ("excursion-monotone", SLIPS + "depth_slope_residual", plus(1)),
    ("return-map-expansion", MAP + "printed_depth_coefficients", entry(1, lambda c: -c)),
    ("return-map-expansion", MAP + "printed_depth_coefficients", entry(2, raised)),
    ("return-map-expansion", MAP + "depth_series", entry(6, raised)),
    ("return-map-expansion", MAP + "lost_coefficients", entry(6, raised)),
    ("return-map-expansion", MAP + "RADIUS", lambda radius: radius + 2),
    ("sharp-rate-constant", RATE + "depth_series", entry(0, raised)),
    ("rate-bounds-explicit", RATE + "stick_rotation", entry(1, lambda sine: -sine)),
    ("rate-bounds-explicit", RATE + "sp", misread("Ge", "Le", 0)),
    ("rate-bounds-explicit", RATE + "sp", misread("Le", "Ge", 0)),
    ("rate-bounds-explicit", RATE + "bounds", lambda bounds: lambda *numbers: bounds(*numbers)[::-1]),
    ("rate-bounds-explicit", RATE + "depth_of_angle", doubled),
    ("uniform-rate", UNIFORM + "first_contact_bound", halved),
    ("uniform-rate", UNIFORM + "sp", misread("Ge", "Le", 0)),
    ("merging-share", MEASURE + "flux", doubled),
    ("merging-share", MEASURE + "dissipation", doubled),
    ("merging-share", MEASURE + "sphere", halved),
    ("merging-share", MEASURE + "divergence", plus(1)),
    ("merging-share", MEASURE + "large_energy_limit", squared),
    ("merging-set", WINDOW + "ray_excess", plus(1)),
    ("merging-set", WINDOW + "ratio", doubled),
    ("merging-set", WINDOW + "half_angle", doubled),
    ("merging-set", WINDOW + "sp", misread("Le", "Ge", 0)),
    ("merging-set", WINDOW + "sp", misread("Gt", "Lt", 0)),
    ("critical-mass-ratio", SHARE + "ratio_slope_residual", plus(1)),
    ("critical-mass-ratio", SHARE + "turning_function", negated),
    ("critical-mass-ratio", SHARE + "turning_slope", entry(1, lambda factor: 2 * factor)),
    ("merging-set", SHARE + "critical_share", doubled),
    ("merging-set", SHARE + "critical_mass_ratio_residual", plus(theta)),
    ("merging-set", SHARE + "half_angle", lambda f: lambda: f() + arb("1e-40")),
    ("long-time-expansion", LATE + "map_coefficients", entry(1, lambda c: 2 * c)),
    ("long-time-expansion", LATE + "logarithm_coefficient", halved),
    ("long-time-expansion", LATE + "balanced_share", squared),
    ("long-time-expansion", LATE + "abel_defect", plus(q)),
]


constant_found_again = cache(long_time.constant_found_again)
random_states, bands = cache(merging_share.random_states), cache(merging_share.bands)


@pytest.fixture
def runs_are_remembered(monkeypatch):
    """Long runs in numbers are the same in every test but those that plant a fault in them."""
    monkeypatch.setattr(long_time, "constant_found_again", constant_found_again)
    monkeypatch.setattr(merging_share, "random_states", random_states)
    monkeypatch.setattr(merging_share, "bands", bands)


@pytest.mark.usefixtures("runs_are_remembered")
@pytest.mark.parametrize(("claim_id", "target", "fault"), two_of_each(STEP_FAULTS))
def test_a_fault_in_a_step_turns_the_theorem(plant, claim_id, target, fault):
    plant(target, fault)
    assert decide(CHECKS[claim_id], Context()).verdict is Verdict.UNDECIDED
