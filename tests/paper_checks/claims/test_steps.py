"""Another scene, another printed formula, another bound: what must not pass does not."""

import tomllib
from dataclasses import replace
from fractions import Fraction
from functools import partial
from pathlib import Path

import pytest
import sympy as sp

from numerics import Pair, Scene, State, load_scene
from paper_checks.claims.beyond import merging_share, uniform_rate
from paper_checks.claims.section_4 import velocities
from paper_checks.decide.enclosure import solved
from paper_checks.evidence.clause import Formula
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide

from .conftest import CHECKS

STEPS = tomllib.loads(Path(__file__).with_name("steps.toml").read_text("utf-8"))


@pytest.mark.parametrize("row", STEPS["otherwise"], ids=" ".join)
def test_another_scene_or_another_printed_formula_does_not_carry_the_verdict(row):
    name, argument, value, *until = row
    claim, given = CHECKS[name], load_scene(value) if argument == "scene" else Fraction(value)
    if until:
        given = given.replace(until=until[0])
    assert decide(replace(claim, case=partial(claim.case, **{argument: given})), Context()).verdict is Verdict.UNDECIDED


def test_a_share_that_is_larger_by_a_fifth_is_found(plant):
    plant("paper_checks.claims.beyond.merging_share.by_quadrature", lambda share: lambda *given: 1.2 * share(*given))
    assert merging_share.random_states(Fraction(3, 10), Fraction(4), 2000, 0).passed is not True


def test_what_is_not_there_is_not_found(plant):
    """Two bands of one outcome, a peak of a slip that ends before its centre."""
    plant("paper_checks.claims.beyond.merging_share.outcome", lambda _: lambda share, run: "merges")
    assert merging_share.bands(Fraction(3, 5))[0] < 2
    short = Scene(Pair(m1=1, m2=5, a2=200, b="0.5"), State(v1="0.144", v2="0.048"), until=2)
    with pytest.raises(ValueError, match="not proved to pass the centre"):
        velocities.positive_peaks(solved(short))


def test_the_threshold_has_fifty_digits():
    """The share r*, both mass ratios and the angle theta*."""
    values = " ".join(item.value for item in CHECKS["merging-set"].decide().evidence)
    for digits in (
        "0.5578390907215263120660191803836715226398464348069",
        "0.7926316327286585619957260792416169570660259003587",
        "1.261620100320081235309400233086105366758358277743",
        "3.797275743253600858209591026138283661307880652212",
    ):
        assert digits in values


LETTERS = {"y": uniform_rate.EXCESS, "r": uniform_rate.SHARE}


@pytest.mark.parametrize(
    ("found", "relation", "right"), [(found, *row) for found, rows in STEPS["bounds"].items() for row in rows]
)
def test_bounds_of_the_error_next_to_the_edge(found, relation, right):
    bound = Formula("R_n", relation, sp.sympify(right, locals=LETTERS), uniform_rate.bounds_error)
    passed = uniform_rate.bounds_error(bound).passed
    assert passed is (found == "hold") or (found == "open" and not passed)
