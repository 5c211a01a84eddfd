"""Balls: proved, disproved, and neither; of a root both ends of the bracket are proved, and none is made up."""

import pytest
import sympy as sp
from flint import arb

from numerics import Mode, load_scene
from paper_checks.decide.balls import precision
from paper_checks.decide.enclosure import ball, compare, itinerary, rounded, solved, stuck_for_ever
from paper_checks.decide.roots import enclosed_root

from .formulas import asked


@pytest.mark.parametrize(("compared", "passed"), asked("comparisons"))
def test_a_comparison_is_proved_or_disproved_or_open(compared, passed):
    left, relation, right = compared
    assert compare("balls", arb(left), relation, arb(right)).passed is passed


def test_an_itinerary_has_to_be_the_proved_one():
    trajectory = solved(load_scene("start-at-6mm"))
    assert itinerary("right", trajectory, [Mode.SLIP_MINUS, Mode.STICK]).passed is True
    assert itinerary("wrong", trajectory, [Mode.STICK]).passed is False
    assert itinerary("the other way round", trajectory, [Mode.STICK, Mode.SLIP_MINUS]).passed is False
    assert itinerary("nothing", trajectory, []).passed is None
    assert itinerary("more than there is", trajectory, (*trajectory.modes, Mode.STICK)).passed is False
    assert stuck_for_ever("not yet", trajectory).passed is False
    assert stuck_for_ever("read literally", solved(load_scene("start-at-6mm-literal"))).passed is True


@pytest.mark.parametrize("value", [sp.pi, sp.sqrt(2) / 10**9, -sp.exp(40), sp.Rational(1, 3), sp.pi**2 / 4])
def test_a_ball_contains_its_constant(value):
    with precision(150):
        assert ball(value).contains(arb(str(value.evalf(250))))
        assert ball(value).rel_accuracy_bits() > 150


@pytest.mark.parametrize(
    "row", ["4.54976948 4 4.5498", "-0.0004 3 0.000", "-0.0016 3 -0.002", "64.9 0 65", "0.5 1 0.5"]
)
def test_a_ball_is_rounded_to_decimals(row):
    value, places, shown = row.split()
    assert rounded(arb(value), int(places)) == shown


def test_a_ball_that_rounds_to_two_decimals_is_refused():
    with pytest.raises(ArithmeticError, match="no unique decimal"):
        rounded(arb("1.25").union(arb("1.35")), 1)


@pytest.mark.parametrize("sign", [1, -1])
def test_a_root_is_inside_its_ball(sign):
    with precision():
        found = enclosed_root(lambda x: sign * (x * x - 2), 1, 2, 20)
        assert found.contains(arb(2).sqrt())
        assert found.rad() < arb(10) ** -22


@pytest.mark.parametrize(
    ("function", "said"),
    [
        (lambda x: x * x + 1, "no change of sign"),
        (lambda x: x - 1, "the sign at 1 is not decided"),
        (lambda x: 2 * x - 3, "the sign at 3/2 is not decided"),
    ],
)
def test_a_sign_that_does_not_change_or_is_open_is_no_root(function, said):
    with pytest.raises(ArithmeticError, match=said):
        enclosed_root(function, 1, 2)
