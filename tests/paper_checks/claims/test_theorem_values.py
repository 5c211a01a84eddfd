"""Theorems past the paper: their values, what is true next to their edges, and solved motions beside them."""

import math
from fractions import Fraction
from itertools import islice

import pytest
import sympy as sp
from flint import arb

from numerics import Pair, Scene, State, solve
from numerics.arithmetic.ball import Ball
from numerics.free.excursions import excursions
from numerics.free.frame import Frame
from numerics.linear.modes import EventKind
from numerics.trajectory.status import Status
from paper_checks.claims import long_time, merging, merging_share, rate, return_map, slips, uniform_rate
from paper_checks.decide.balls import precision
from paper_checks.evidence.clause import Formula

from .conftest import CHECKS


def value_of(claim_id, beginning):
    texts = [part for item in CHECKS[claim_id].decide().evidence for part in item.value.split("; ")]
    return next(text for text in texts if text.startswith(beginning))


def test_the_threshold_has_fifty_digits():
    assert "0.5578390907215263120660191803836715226398464348069" in value_of("merging-set", "r* =")
    assert "0.7926316327286585619957260792416169570660259003587" in value_of("merging-set", "m1/m2 = -cos")
    assert "1.261620100320081235309400233086105366758358277743" in value_of("merging-set", "m2/m1 =")
    assert "3.797275743253600858209591026138283661307880652212" in value_of("merging-set", "theta* =")


def test_the_same_ray_is_not_the_opposite_one():
    assert slips.exits_twice_by(Fraction(1, 5), Fraction(15), same=False).passed is False


def test_bounds_that_are_too_tight_fail(plant):
    plant("paper_checks.claims.rate.bounds", lambda bounds: lambda *numbers: (bounds(*numbers)[1], bounds(*numbers)[1]))
    assert rate.bounded_run(Fraction(1, 2), Fraction(3, 2), 5).passed is False


def test_the_constant_depends_on_the_start():
    with precision(60):
        one, other = (long_time.constant_at(Fraction(1, 2), Fraction(n, 10), "1e12") for n in (15, 11))
        assert abs(one - other) > 1


def test_no_window_below_the_threshold():
    with precision(30), pytest.raises(ArithmeticError, match="no change of sign"):
        merging.window(arb("0.5578"))


def test_the_remainder_needs_all_its_terms(plant):
    plant("paper_checks.claims.return_map.lost_coefficients", lambda original: lambda: original()[:-1])
    assert return_map.remainder()[0].passed is False


def test_the_constant_is_not_found_again_too_early(plant):
    plant("paper_checks.claims.long_time.TIMES", lambda times: (times[0], "1e4", times[2]))
    assert long_time.constant_found_again(Fraction(1, 2), Fraction(3, 2)).passed is False


def error_bound(relation, right):
    return uniform_rate.bounds_error(Formula("R_n", relation, right, uniform_rate.bounds_error)).passed


def test_bounds_of_the_error_next_to_the_edge():
    y, r = uniform_rate.EXCESS, uniform_rate.SHARE
    root = sp.sqrt(y)
    assert error_bound("<=", (5 * y + root / 10) / r) is True
    assert error_bound("<=", (sp.Rational(47, 10) * y + root / 10) / r) is False
    assert error_bound("<=", (5 * y + root / 20) / r) is False
    assert error_bound(">=", -sp.Rational(9, 20) * (y + root) / r) is True
    assert error_bound(">=", -sp.Rational(2, 5) * (y + root) / r) is False
    assert error_bound("<=", -sp.Rational(9, 20) * (y + root) / r) is False
    assert error_bound("<=", (5 * y**2 + root / 10) / r) is not True
    assert error_bound("<=", (5 * y - y**2 + root / 10) / r) is not True
    assert error_bound("<=", 5 * y + root / 10) is not True


@pytest.mark.parametrize("share", [Fraction(1, 5), Fraction(1, 2), Fraction(9, 10)])
def test_a_run_is_within_the_error(share):
    """The law with its error along 200 excursions in balls, from the largest start."""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=1 - share, m2=share, a2=1, b=1))
        y = (arb.pi() / 2 - 1) ** 2
        r, time, first = frame.r, arb(0), frame.q * y
        law, weight = 4 * arb.pi() * frame.q / (9 * r), 1 - 2 / (5 * r)
        for one in islice(excursions(frame, first), 200):
            time += one.slip + one.stick
            rest = law / one.w_after + arb.pi() * weight * (one.w_after / first).log() - law / first - time
            assert rest < (5 * y + y.sqrt() / 10) / r
            assert rest > -(y + y.sqrt()) * 9 / 20 / r


def test_a_family_with_one_energy_has_no_lower_bound():
    """Solved in balls: the same E(0), and less and less excess from the first contact on."""
    pair = Pair(m1="0.5", m2="0.5", a2=1, b="0.5")
    for delta in (Fraction(1, 100), Fraction(1, 10**6)):
        contact = (1 - 0.25 + float(delta)) ** 0.5
        angle = 2.0
        x = 0.5 - contact * 0.5**0.5 * math.sin(angle)
        start = State(x1=x, v1=contact * math.cos(angle), v2=contact + 0.5**0.5 * angle)
        run = solve(Scene(pair, start, until=40), digits=15, arithmetic="ball")
        assert run.events[0].kind is EventKind.ENTRY
        assert 0 < run.events[0].reduced.w < 1.01 * float(delta)
        assert run.status is not Status.STUCK_FOR_EVER


def test_another_share_is_not_that_of_random_states(plant):
    plant("paper_checks.claims.merging_share.by_quadrature", lambda f: lambda *numbers: 1.2 * f(*numbers))
    assert merging_share.random_states(Fraction(3, 10), Fraction(4), 2000, 0).passed is False


def test_one_outcome_is_one_band(plant):
    plant("paper_checks.claims.merging_share.outcome", lambda _: lambda share, run: "merges")
    assert merging_share.bands(Fraction(3, 5))[0] < 2
