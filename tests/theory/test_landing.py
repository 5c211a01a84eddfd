"""Where a slip from S ends: every closed form against the slip by hand, in 50 digits."""

from collections.abc import Iterator

import mpmath
import pytest
from slip_by_hand import DIGITS, SLIPS, TOLERANCE, SlipByHand, at
from sympy import Rational, cot

from theory import return_map
from theory.symbols import theta


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(DIGITS + 10):
        yield


def test_the_slip_by_hand_solves_its_equations():
    """Against a Taylor integrator, so that the yardstick itself does not rest on the closed form."""
    with mpmath.workdps(25):
        slip = SlipByHand(Rational(1, 3), Rational(2, 5), Rational(3, 4))

        def field(_, y):
            return [y[1], -(y[0] - slip.r) / slip.q, mpmath.mpf(-1)]

        integrated = mpmath.odefun(field, 0, list(slip.start))(slip.root)
        assert all(abs(one - other) < 1e-20 for one, other in zip(integrated, slip.state(1), strict=True))


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_ends_where_the_contact_condition_vanishes(slip):
    end = slip.end()
    assert 0 < end < 2 * mpmath.pi
    assert abs(at(return_map.contact_condition(), d=slip.d, nu=slip.u, theta=end)) < TOLERANCE
    wrong = return_map.contact_condition() + 2 * return_map.gap * cot(theta / 2)
    assert slip.d == 0 or abs(at(wrong, d=slip.d, nu=slip.u, theta=end)) > 1e-6


def landed(slip, landing, end):
    """(gap, push, change of the excess) by the closed forms minus those of the slip by hand."""
    x, _, v2 = slip.state(end)
    known = {"q": slip.q, "d": slip.d, "nu": slip.u, "theta": end}
    return (
        at(landing.gap, **known) - (x - 1) / slip.q,
        at(landing.push, **known) - v2 / slip.root,
        at(landing.excess_change, **known) - (slip.excess(end) - slip.excess(mpmath.mpf(0))),
    )


@pytest.mark.parametrize("slip", SLIPS)
def test_where_a_slip_lands(slip):
    assert all(abs(difference) < TOLERANCE for difference in landed(slip, return_map.landing(), slip.end()))
