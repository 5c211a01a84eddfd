"""Another scene, another printed formula, another bound: what must not pass does not."""

from dataclasses import replace
from fractions import Fraction
from functools import partial

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


@pytest.mark.parametrize(("name", "changed"), OTHERWISE)
def test_another_scene_or_another_printed_formula_does_not_carry_the_verdict(name, changed):
    claim = CHECKS[name]
    assert decide(replace(claim, case=partial(claim.case, **changed)), Context()).verdict is Verdict.UNDECIDED


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


Y, R = uniform_rate.EXCESS, uniform_rate.SHARE
ROOT = sp.sqrt(Y)


@pytest.mark.parametrize(
    ("relation", "right", "passed"),
    [
        ("<=", 5 * Y, True),
        ("<=", sp.Rational(47, 10) * Y, False),
        ("<=", 5 * Y - ROOT / 20, False),
        (">=", -sp.Rational(9, 20) * (Y + ROOT) / R, True),
        (">=", -sp.Rational(2, 5) * (Y + ROOT) / R, False),
        ("<=", -sp.Rational(9, 20) * (Y + ROOT), False),
        ("<=", 5 * Y**2, None),
        ("<=", 5 * Y - Y**2, None),
        ("<=", 5 * Y / R, None),
        ("=", 5 * Y, None),
    ],
)
def test_bounds_of_the_error_next_to_the_edge(relation, right, passed):
    found = uniform_rate.bounds_error(Formula("R_n", relation, right, uniform_rate.bounds_error)).passed
    assert found is passed or (passed is None and not found)
