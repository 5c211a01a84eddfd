"""Section III, where trajectories go and how fast: faults that must turn them."""

from dataclasses import replace
from fractions import Fraction
from functools import cache, partial
from types import SimpleNamespace

import pytest
import sympy as sp

from numerics.linear.modes import Mode
from numerics.scene.file import load_scene
from numerics.trajectory.status import Status
from paper_checks.claims import convergence, excursions, itineraries, near_critical
from paper_checks.decide import samples
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide
from theory.symbols import a1, a2, b, m2, q, theta, v1, v2, x1

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
    two_of_each,
    without,
)

CONVERGENCE = "paper_checks.claims.convergence."
NEAR = "paper_checks.claims.near_critical."
VISCOUS = "paper_checks.claims.viscous."
ITINERARIES = "paper_checks.claims.itineraries."
CAPTURE = "paper_checks.claims.capture."
DISSIPATION = "paper_checks.claims.energy."
SOLUTIONS = "paper_checks.claims.filippov."
EXCURSIONS = "paper_checks.claims.excursions."
CREEPING = "paper_checks.claims.excursions."
TURNED = "paper_checks.claims.convergence."


def limit_changed(name, change):
    """Return a fault that changes one of the limits along a trajectory to the critical orbit."""
    return lambda limits: lambda: replace(limits(), **{name: change(getattr(limits(), name))})


def second(change):
    """Return a fault that changes the second of two expressions."""
    return lambda original: lambda: (original()[0], change(original()[1]))


def inwards_missed(excursion):
    """The excursion with re-entry on the other side of the edge."""
    return lambda: replace(excursion(), position=2 - excursion().position)


def unbounded_sign(_):
    """Friction that may exceed b on S."""
    return lambda value, velocity: sp.And(sp.Le(sp.Abs(value), 2), sp.Lt(sp.Abs(velocity), 1))


enclosed_rate = cache(excursions.enclosed_rate)
dichotomy_samples = cache(samples.dichotomy_samples)


@pytest.fixture
def runs_are_remembered(monkeypatch):
    """Long runs in numbers are the same in every test but those that plant a fault in them."""
    monkeypatch.setattr(near_critical, "enclosed_rate", enclosed_rate)
    monkeypatch.setattr(convergence, "dichotomy_samples", dichotomy_samples)


STEP_FAULTS = [
    ("infinitely-many-crossings", CAPTURE + "phi", other_sign),
    ("infinitely-many-crossings", CAPTURE + "phi", doubled),
    ("infinitely-many-crossings", CAPTURE + "dwell_time_bound", halved),
    ("infinitely-many-crossings", CAPTURE + "energy", plus(-m2 * v2**2 / 4)),
    ("infinitely-many-crossings", CAPTURE + "sp", misread("Le", "Ge", 0)),
    ("infinitely-many-crossings", DISSIPATION + "slip_rate", negated),
    ("dichotomy", CAPTURE + "critical_energy", doubled),
    ("dichotomy", CAPTURE + "critical_energy", halved),
    ("dichotomy", CAPTURE + "half_width", halved),
    ("dichotomy", CAPTURE + "transversality", negated),
    ("dichotomy", CAPTURE + "sp", misread("Le", "Lt", 6)),
    ("dichotomy", SOLUTIONS + "contraction_rate", negated),
    ("dichotomy", SOLUTIONS + "set_valued_sign", unbounded_sign),
    ("dichotomy", CONVERGENCE + "stick_rate", plus(-b * v1)),
    ("relative-displacement-limit", DISSIPATION + "energy", doubled),
    ("relative-displacement-limit", DISSIPATION + "energy", plus(a2 * x1)),
    ("relative-displacement-limit", DISSIPATION + "free_system", other_sign),
    ("relative-displacement-limit", DISSIPATION + "slip_rate", without(a1, b)),
    ("global-stability", SOLUTIONS + "contraction_rate", negated),
    ("global-stability", SOLUTIONS + "contraction_rate", without(a1)),
    ("global-stability", SOLUTIONS + "contraction_terms", second(lambda term: -term)),
    ("global-stability", CAPTURE + "critical_energy", squared),
    ("global-stability", CAPTURE + "on_surface", halved),
    ("stick-durations", NEAR + "critical_limits", limit_changed("stick_duration", lambda value: 2 * value)),
    ("stick-durations", NEAR + "critical_limits", limit_changed("stick_duration", lambda value: value**2)),
    ("stick-durations", NEAR + "m2", lambda mass: -mass),
    ("stick-durations", EXCURSIONS + "half_angle_slope", second(lambda increment: -increment)),
    ("stick-durations", EXCURSIONS + "excursion", lambda one: lambda: replace(one(), velocity=-one().velocity)),
    ("slip-durations", NEAR + "critical_limits", limit_changed("slip_duration", lambda value: value + 1)),
    ("slip-durations", NEAR + "cycle", lambda cycle: lambda: replace(cycle(), slip_duration=2 * cycle().slip_duration)),
    ("slip-durations", EXCURSIONS + "guard_of_u", negated),
    ("slip-durations", EXCURSIONS + "h_limits", lambda limits: lambda: (limits()[0], sp.Integer(1))),
    ("slip-durations", EXCURSIONS + "h_slope", squared),
    ("exits-near-endpoints", NEAR + "critical_limits", limit_changed("entry_position", lambda value: -value)),
    ("exits-near-endpoints", NEAR + "critical_limits", limit_changed("exit_position", lambda value: value / 2)),
    ("exits-near-endpoints", NEAR + "critical_limits", limit_changed("entry_velocity", lambda value: value + b)),
    ("exits-near-endpoints", NEAR + "b", lambda symbol: symbol**2),
    ("exits-near-endpoints", EXCURSIONS + "excursion", inwards_missed),
    ("no-merging-near-critical", CAPTURE + "critical_energy", halved),
    ("no-merging-near-critical", EXCURSIONS + "no_merging_excess", doubled),
    ("no-merging-near-critical", EXCURSIONS + "no_merging_excess", squared),
    ("no-merging-near-critical", EXCURSIONS + "excursion", inwards_missed),
    ("no-merging-near-critical", EXCURSIONS + "depth", negated),
    ("no-merging-near-critical", EXCURSIONS + "depth", plus(theta)),
    ("no-merging-near-critical", EXCURSIONS + "sp", misread("Ge", "Gt", 2)),
    ("no-merging-near-critical", EXCURSIONS + "sp", misread("Ge", "Le", 0)),
    ("no-merging-near-critical", EXCURSIONS + "sp", misread("Gt", "Lt", 0)),
    ("no-merging-near-critical", "theory.return_map.depth", halved),
    ("no-merging-near-critical", "theory.return_map.r", lambda share: -share),
    ("no-merging-near-critical", "theory.return_map.h", doubled),
    ("slower-than-exponential", NEAR + "excess_ratio_limit", halved),
    ("slower-than-exponential", NEAR + "cycle_limit", doubled),
    ("slower-than-exponential", NEAR + "cycle_limit", squared),
    ("slower-than-exponential", EXCURSIONS + "return_map_slope_residual", plus(q)),
    ("rate-one-over-t", CREEPING + "inverse_step", doubled),
    ("rate-one-over-t", CREEPING + "quadratic_coefficient", negated),
    ("rate-one-over-t", CREEPING + "cycle_limit", doubled),
    ("rate-one-over-t", CREEPING + "rate_constant", squared),
    ("rate-one-over-t", CREEPING + "printed_rate_constant", halved),
    ("rate-one-over-t", CREEPING + "critical_energy", doubled),
    ("rate-one-over-t", NEAR + "sp", misread("Le", "Ge", 0)),
    ("rate-one-over-t", NEAR + "sp", misread("Eq", "Ge", 0)),
    ("rate-one-over-t", NEAR + "enclosed_rate", lambda run: lambda q, w, n, tolerance: run(q, w, n // 100, tolerance)),
    ("viscous-energy-rate", "paper_checks.claims.energy.energy", doubled),
    ("viscous-energy-rate", "paper_checks.claims.energy.free_system", other_sign),
    ("viscous-energy-rate", VISCOUS + "stick_rate", doubled),
    ("viscous-energy-rate", CAPTURE + "free_system", other_sign),
    ("viscous-origin-stable", VISCOUS + "sliding_field", lambda field: lambda damped: -field(damped)),
    ("viscous-origin-stable", VISCOUS + "sliding_field", lambda field: lambda damped: field(False)),
    ("viscous-origin-stable", VISCOUS + "damping_ratio", doubled),
    ("viscous-origin-stable", VISCOUS + "damping_ratio", squared),
    ("viscous-origin-stable", DISSIPATION + "captive_energy", doubled),
    ("viscous-origin-stable", DISSIPATION + "load", lambda load: lambda damped: load(False)),
    ("viscous-origin-stable", DISSIPATION + "lipschitz_constant", without(a1)),
    ("dichotomy", SOLUTIONS + "contraction_rate", plus(a1 * v1**2)),
    ("dichotomy", TURNED + "rates", negated),
    ("dichotomy", TURNED + "energy_parts", halved),
    ("dichotomy", TURNED + "half_width", halved),
    ("dichotomy", TURNED + "relative_rate", negated),
    ("relative-displacement-limit", DISSIPATION + "energy", halved),
    ("exits-near-endpoints", "theory.near_critical.exit_speed", plus(1)),
]


@pytest.mark.usefixtures("runs_are_remembered")
@pytest.mark.parametrize(("claim_id", "target", "fault"), two_of_each(STEP_FAULTS))
def test_a_fault_in_a_step_turns_the_claim(plant, claim_id, target, fault):
    plant(target, fault)
    assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED


OTHER_SCENES = [
    ("itinerary-that-merges", lambda: load_scene("itinerary-that-creeps")),
    ("itinerary-that-merges", lambda: load_scene("start-at-6mm")),
    ("itinerary-that-merges", lambda: replace(load_scene("itinerary-that-merges"), until=Fraction(1, 10**4))),
    ("itinerary-that-creeps", lambda: load_scene("itinerary-that-merges")),
    ("itinerary-that-creeps", lambda: load_scene("velocities")),
    ("itinerary-that-creeps", lambda: replace(load_scene("itinerary-that-creeps"), until=Fraction(1, 10))),
]


@pytest.mark.parametrize(("claim_id", "scene"), OTHER_SCENES)
def test_another_scene_does_not_have_the_itinerary(claim_id, scene):
    claim = CHECKS[claim_id]
    planted = replace(claim, case=partial(claim.case, scene=scene()))
    assert decide(planted, Context()).verdict is Verdict.UNDECIDED


ITINERARY_FAULTS = [
    ("itinerary-that-merges", ITINERARIES + "Status", lambda _: SimpleNamespace(STUCK_FOR_EVER=Status.REACHED_HORIZON)),
    ("itinerary-that-merges", ITINERARIES + "exact", lambda exact: lambda value: exact(value - 1)),
    ("itinerary-that-merges", ITINERARIES + "PLUS", lambda _: itineraries.MINUS),
    ("itinerary-that-creeps", ITINERARIES + "PLUS", lambda _: itineraries.MINUS),
    ("itinerary-that-creeps", ITINERARIES + "exact", lambda exact: lambda value: exact(value + 3)),
    ("itinerary-that-creeps", "paper_checks.claims.itineraries.h", doubled),
]


@pytest.mark.parametrize(("claim_id", "target", "fault"), ITINERARY_FAULTS)
def test_a_fault_in_what_is_asked_of_the_itinerary_turns_it(plant, claim_id, target, fault):
    plant(target, fault)
    assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED


def test_the_bound_on_the_mass_ratio_is_needed(plant):
    """Without m2 <= m1 an excursion from a ray may merge."""
    plant(EXCURSIONS + "sp", misread("Le", "Ge", 0))
    assert excursions.no_merging_at_any_energy().passed is False


def test_one_sample_that_neither_merges_nor_creeps_turns_the_dichotomy(plant):
    plant("paper_checks.decide.samples._merged_or_creeping", lambda _: lambda one: one.final.w > 0)
    assert finding_of(CHECKS["dichotomy"]).verdict is Verdict.UNDECIDED


def test_the_samples_see_an_excess_that_grows():
    solved = samples.solved_samples(0, 20)
    creeping = next(
        one for one in solved if one.status is not Status.STUCK_FOR_EVER and one.modes.count(Mode.STICK) > 2
    )
    assert samples._merged_or_creeping(creeping)
    backwards = creeping.but()
    backwards.__dict__["events"] = creeping.events[::-1]
    assert not samples._merged_or_creeping(backwards)
