"""Another scene, another printed formula, a step without one of its conditions: what must not pass does not."""

from dataclasses import replace
from fractions import Fraction
from functools import partial

import pytest
import sympy as sp

from numerics import Mode, Pair, Scene, State, load_scene, solve
from numerics.trajectory.status import Status
from paper_checks.claims import (
    CLAIMS,
    claim_named,
    excursions,
    filippov,
    onset,
    stuck,
    tolerance,
    transfers,
    velocities,
)
from paper_checks.claims.points import EDGE
from paper_checks.decide import samples
from paper_checks.decide.enclosure import solved
from paper_checks.evidence.claim import Kind
from paper_checks.evidence.evidence import closure
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide
from theory.model import RELATIVE_SIGN, STICTION_SIGN
from theory.symbols import acceleration1, b, m2

from .conftest import CHECKS
from .faults import confused, unbounded_sign

S = sp.Symbol("s")


MERGES, CREEPS = map(load_scene, ("itinerary-that-merges", "itinerary-that-creeps"))
OTHERWISE = [
    ("itinerary-that-merges", {"scene": CREEPS}),
    ("itinerary-that-merges", {"scene": replace(MERGES, until=Fraction(1, 10**4))}),
    ("itinerary-that-creeps", {"scene": MERGES}),
    ("itinerary-that-creeps", {"scene": load_scene("velocities")}),
    ("start-at-6mm-sticks", {"start": Fraction(5, 1000)}),  # on the edge: it does stick for ever
    ("start-with-speed-synchronises", {"speed": Fraction(8, 100)}),  # merges at its first contact
    ("relative-motion-converges", {"speed": Fraction(5, 1000)}),  # merges: it takes no infinite time
    ("constant-damping-rate", {"friction": Fraction(2, 10)}),
    ("saw-tooth", {"friction": Fraction(6, 100)}),
    ("synchronisation-time", {"friction": Fraction(6, 100)}),
    ("synchronisation-time", {"time": Fraction(456, 100)}),  # inside the first adhesion
]


@pytest.mark.parametrize(("row", "changed"), OTHERWISE)
def test_another_scene_or_another_printed_formula_does_not_carry_the_verdict(row, changed):
    claim = CHECKS[row]
    assert decide(replace(claim, case=partial(claim.case, **changed)), Context()).verdict is Verdict.UNDECIDED


# eqs (3) and (4)

RESTING_ON_THEM = {"sgn-three-valued", "modes-from-closed-form", "interface-force-balance"}
ADHESION = m2 * acceleration1 * (1 - sp.Abs(RELATIVE_SIGN)) * (1 - STICTION_SIGN) / 2
IN_THE_MODEL = {
    "friction on body 2 reversed": ("driven_equation", lambda right: right - 2 * b * RELATIVE_SIGN, ()),
    "twice the friction on body 1": ("driving_equation", lambda right: right + b * RELATIVE_SIGN, ()),
    "1 + sgn(...) in the bracket": (
        "driven_equation",
        lambda right: right.subs(STICTION_SIGN, -STICTION_SIGN),
        ("stiction-bracket",),
    ),
    "without the factor 1/2": ("driven_equation", lambda right: right + ADHESION, ("stiction-bracket",)),
}


@pytest.mark.parametrize("fault", IN_THE_MODEL)
def test_a_fault_in_the_model_turns_the_claims_that_rest_on_it(plant, fault):
    name, change, more = IN_THE_MODEL[fault]
    for module in ("theory.model", *(["paper_checks.claims.filippov"] if more else [])):
        plant(f"{module}.{name}", lambda equation: lambda: change(equation()))
    for row in RESTING_ON_THEM.union(more):
        assert decide(CHECKS[row], Context()).verdict is Verdict.UNDECIDED, row


# what a step needs


@pytest.mark.parametrize(
    ("target", "fault", "step"),
    [
        # with |x1''| >= 0 instead of >= b/m2 the spurious branches could stay
        ("filippov.b", lambda _: sp.Integer(0), lambda: [filippov.spurious_branches_leave()]),
        ("filippov.set_valued_sign", unbounded_sign, lambda: [filippov.never_apart()]),
        # without m2 <= m1 an excursion from a ray may merge
        ("excursions.prove", confused("<=", ">=", 0), lambda: [excursions.no_merging_at_any_energy()]),
        (
            "onset.subcritical_level",
            lambda level: lambda: sp.Le(level().lhs - b**2, 0, evaluate=False),
            onset.stays_together,
        ),
    ],
)
def test_a_step_without_one_of_its_conditions_does_not_pass(plant, target, fault, step):
    plant(f"paper_checks.claims.{target}", fault)
    assert step()[0].passed is not True


def test_at_the_edge_the_printed_strict_inequality_fails_too():
    """The counterexample needs |x1''| >= b/m2 only; the row shows the stronger >."""
    assert onset.exhibit("", EDGE, (sp.Abs(onset.case_study_mode(0)[0]), ">=", b)).passed is True


def test_a_peak_that_is_not_proved_is_not_passed_over():
    """A slip that ends before x1 comes to the centre of its oscillation."""
    short = Scene(Pair(m1=1, m2=5, a2=200, b="0.5"), State(v1="0.144", v2="0.048"), until=2)
    with pytest.raises(ValueError, match="not proved to pass the centre"):
        velocities.positive_peaks(solved(short))


# samples, and what is cited or open


def test_one_sample_that_neither_merges_nor_creeps_turns_the_dichotomy(plant):
    plant("paper_checks.decide.samples._merged_or_creeping", lambda _: lambda one: one.final.w > 0)
    assert decide(CHECKS["dichotomy"], Context()).verdict is Verdict.UNDECIDED


def test_the_samples_see_an_excess_that_grows():
    runs = map(solve, samples.scenes(0, 20))
    creeping = next(one for one in runs if one.status is not Status.STUCK_FOR_EVER and one.modes.count(Mode.STICK) > 2)
    assert samples._merged_or_creeping(creeping)
    backwards = creeping.but()
    backwards.__dict__["events"] = creeping.events[::-1]
    assert not samples._merged_or_creeping(backwards)


def test_no_step_of_the_proofs_under_a_force_is_a_sample():
    subjects = ("forced_modes", "contraction", "response", "entrainment", "control", "tolerance")
    ours = [one for one in CLAIMS if one.kind is Kind.THEOREM and one.case.__module__.rpartition(".")[2] in subjects]
    assert len(ours) == 10
    assert all(step.kind.decisive for claim in ours for step in closure(claim.decide().evidence))


def test_what_is_open_is_said_and_steps_name_what_they_cite():
    assert all(
        claim_named(name).open for name in ("entrainment-threshold", "forced-resonance-bound", "minimum-transfer-time")
    )
    assert any("nonexpansive" in cite for step in closure([stuck.sticks_for_ever()]) for cite in step.cites)
    assert not any(step.cites for step in closure([transfers.weak_force(), tolerance.ring_contains()]))
