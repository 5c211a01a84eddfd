"""The boxes on a rim or a line cover it, and what is enclosed there holds inside."""

from fractions import Fraction

import pytest
from flint import acb, arb

from paper_checks.claims.beyond import rate_error, return_map
from paper_checks.decide.balls import point, precision


def test_the_boxes_cover_a_quarter_of_the_rim():
    radius = rate_error.RIM
    with precision(20):
        found = list(rate_error._rim())
        for n in range(4 * len(found) + 1):
            turn = arb.pi() / 2 * n / (4 * len(found))
            place = acb(point(Fraction(radius)) * turn.cos(), point(Fraction(radius)) * turn.sin())
            assert any(box.contains(acb(place.real.mid(), place.imag.mid())) for box in found)


@pytest.mark.parametrize("quotient", [rate_error.of_map, rate_error.of_time])
@pytest.mark.parametrize("p", ["0", "0.3", "0.7", "0.99"])
def test_enclosures_of_a_quotient_hold_its_values(quotient, p):
    """Near zero and beyond, on boxes: the value at points of them, from 200 digits."""
    with precision(20):
        box = arb(p).union(arb(p) + arb("0.005"))
        slips = rate_error.near()
        near = rate_error.near_zero(quotient, slips, box, rate_error.rest(quotient, slips, box))
        wide = rate_error.beyond(quotient, rate_error.slips_on(arb("0.9").union(arb("0.95"))), box)
    with precision(100):
        for inside in (arb(p), arb(p) + arb("0.0025"), arb(p) + arb("0.005")):
            for theta in ("0.05", "0.2", "0.5", "0.8", "0.9", "0.925", "0.95"):
                above, below = quotient(rate_error.plain(arb(theta)), inside)
                assert (near if theta < "0.9" else wide).contains((above / below).mid())


def test_the_logarithm_refuses_what_its_series_does_not_reach():
    with precision(20):
        assert rate_error.logarithm(arb("0.5")).overlaps((arb("0.5")).log() / arb("0.5"))
        assert rate_error.logarithm(arb(0)).contains(-1)
        with pytest.raises(ArithmeticError, match="not proved to converge"):
            rate_error.logarithm(arb("0.81"))


def test_what_the_first_terms_leave_out_is_no_more_than_is_said():
    """At points, from 100 digits; and a defect that has a zero of a lower order has no bound."""
    cubic = return_map.less(lambda slip: slip.depth, return_map.printed_depth_coefficients(), 1)
    most = return_map.at_most(cubic, 8)
    with precision(100):
        for angle in ("0.01", "0.0625", "0.3", "1", "2"):
            exact = rate_error.plain(arb(angle))
            y = exact.height * exact.height
            left = exact.depth - 3 * y / 2 + 27 * y * y / 40 - 243 * y * y * y / 560
            assert abs(left) < most * y**4
    assert not return_map.at_most(cubic, 10).is_finite()
