"""Section III, fields, energy rates and the switching surface: faults that must turn them."""

import pytest

from numerics.linear.modes import Mode
from paper_checks.claims import filippov
from paper_checks.evidence.finding import Verdict
from theory.filippov import EdgeContact
from theory.symbols import a2, b, m1, v1, v2, x1

from .conftest import (
    CHECKS,
    doubled,
    finding_of,
    halved,
    misread,
    negated,
    other_sign,
    plus,
    squared,
    without,
)

FIELDS = "paper_checks.claims.filippov."
VISCOUS = "paper_checks.claims.viscous."
ENERGY = "paper_checks.claims.energy."
LEVELS = "paper_checks.claims.levels."
SURFACE = "paper_checks.claims.sliding."
CAPTURE = "paper_checks.claims.capture."
SOLUTIONS = "paper_checks.claims.filippov."


def reversed_contact(contact):
    """A slip that touches S and curves back into the half-space that it came from."""
    return lambda side: EdgeContact(contact(side).first, -contact(side).second, contact(side).third)


def crossing_contact(contact):
    """A guard without the double root."""
    return lambda side: EdgeContact(contact(side).second, contact(side).second, contact(side).third)


def other_weight(weight):
    """The weight of Phi_- in the place of that of Phi_+."""
    return lambda: 1 - weight()


def not_strict(beyond):
    """The edge of the strip counted with S_+ and S_-."""
    return lambda side, strict=True: beyond(side, strict=False)


def squared_load(load):
    """A load that does not obey the oscillator's equation."""
    return lambda damped: load(damped) ** 2


STEP_FAULTS = [
    ("viscous-no-direct-effect", VISCOUS + "stick", lambda _: lambda: filippov.slip(1)),
    ("viscous-no-direct-effect", VISCOUS + "a1", lambda a1: -a1),
    ("viscous-no-direct-effect", VISCOUS + "slip", lambda _: lambda sign: filippov.stick()),
    ("viscous-no-direct-effect", VISCOUS + "mode_at_start", lambda _: lambda scene: Mode.STICK),
    ("viscous-no-direct-effect", VISCOUS + "mode_at_start", lambda _: lambda scene: Mode.SLIP_MINUS),
    ("filippov-equivalence", FIELDS + "sliding_field", doubled),
    ("filippov-equivalence", FIELDS + "free_system", other_sign),
    ("filippov-equivalence", FIELDS + "free_system", lambda field: lambda sign: field(sign / 2)),
    ("filippov-equivalence", FIELDS + "half_width", doubled),
    ("filippov-equivalence", FIELDS + "sp", misread("Lt", "Le", 0)),
    ("filippov-equivalence", FIELDS + "transversality", negated),
    ("filippov-equivalence", FIELDS + "slip", other_sign),
    ("filippov-equivalence", SOLUTIONS + "load", squared_load),
    ("filippov-equivalence", SOLUTIONS + "b", lambda friction: -friction),
    ("vector-fields", FIELDS + "phi", other_sign),
    ("vector-fields", FIELDS + "phi", doubled),
    ("vector-fields", FIELDS + "phi", without(b)),
    ("energy-rate", ENERGY + "energy", halved),
    ("energy-rate", ENERGY + "energy", plus(-m1 * v1**2)),
    ("energy-rate", ENERGY + "free_system", other_sign),
    ("energy-dissipation-places", ENERGY + "free_system", other_sign),
    ("energy-dissipation-places", ENERGY + "slip_rate", plus(b * v2)),
    ("energy-dissipation-places", ENERGY + "energy", doubled),
    ("transversality-outside", SURFACE + "transversality", negated),
    ("transversality-outside", SURFACE + "transversality", without(a2)),
    ("transversality-outside", SURFACE + "normal", negated),
    ("transversality-strip", SURFACE + "transversality", negated),
    ("transversality-strip", SURFACE + "transversality", other_sign),
    ("sliding-region", SURFACE + "sliding_weight", other_weight),
    ("sliding-region", SURFACE + "sliding_weight", halved),
    ("sliding-region", SURFACE + "half_width", doubled),
    ("sliding-region", SURFACE + "half_width", halved),
    ("sliding-region", SURFACE + "sliding_field", doubled),
    ("sliding-region", SURFACE + "stick_rate", plus(-b * v1)),
    ("sliding-region", SURFACE + "energy", plus(-a2 * x1**2)),
    ("sliding-region", SURFACE + "sp", misread("Ge", "Gt", 1)),
    ("critical-energy", LEVELS + "critical_energy", squared),
    ("critical-energy", LEVELS + "level_semi_axis", doubled),
    ("critical-energy", LEVELS + "semi_axis_margin", negated),
    ("critical-energy", LEVELS + "half_width", doubled),
    ("critical-energy", LEVELS + "sp", misread("Gt", "Ge", 0)),
    ("critical-energy", CAPTURE + "critical_energy", doubled),
    ("critical-energy", CAPTURE + "on_surface", halved),
    ("critical-energy", CAPTURE + "sp", misread("Le", "Lt", 1)),
    ("supercritical-arcs", LEVELS + "critical_energy", halved),
    ("supercritical-arcs", LEVELS + "edge_speed_squared", doubled),
    ("supercritical-arcs", LEVELS + "edge_contact", reversed_contact),
    ("supercritical-arcs", LEVELS + "edge_contact", crossing_contact),
    ("supercritical-arcs", LEVELS + "product", negated),
    ("supercritical-arcs", CAPTURE + "phi", lambda phi: lambda sign: phi(1)),
    ("supercritical-arcs", LEVELS + "sp", misread("Gt", "Ge", 0)),
    ("supercritical-arcs", LEVELS + "sliding_field", negated),
    ("return-alternatives", SURFACE + "product", negated),
    ("return-alternatives", SURFACE + "half_width", halved),
    ("return-alternatives", SURFACE + "transversality", other_sign),
    ("return-alternatives", SURFACE + "beyond", not_strict),
    ("return-alternatives", SURFACE + "edge_contact", crossing_contact),
    ("sliding-region", SURFACE + "half_width", doubled),
    ("return-alternatives", CAPTURE + "phi", lambda phi: lambda sign: phi(1)),
    ("return-alternatives", SURFACE + "sp", misread("Le", "Lt")),
]


@pytest.mark.parametrize(("claim_id", "target", "fault"), STEP_FAULTS)
def test_a_fault_in_a_step_turns_the_claim(plant, claim_id, target, fault):
    plant(target, fault)
    assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED


def without_spring(field):
    """Filippov's combination with the spring forgotten."""
    return lambda damped=False: field(damped).subs(a2, 0)


MODEL_FAULTS = [
    ("theory.energy.half_width", doubled, {"critical-energy"}),
    ("theory.energy.sliding_field", without_spring, {"sliding-region"}),
    ("theory.energy.half_width", halved, {"critical-energy", "supercritical-arcs"}),
    ("theory.filippov.slip", other_sign, {"vector-fields", "transversality-strip", "return-alternatives"}),
    ("theory.filippov.guard", negated, {"transversality-outside", "transversality-strip", "return-alternatives"}),
    ("theory.filippov.load_threshold", halved, {"supercritical-arcs"}),
]


@pytest.mark.parametrize(("target", "fault", "turned"), MODEL_FAULTS)
def test_a_fault_in_theory_turns_the_claims_that_rest_on_it(plant, target, fault, turned):
    plant(target, fault)
    for claim_id in turned:
        assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED, claim_id
