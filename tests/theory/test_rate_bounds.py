"""The manifest signs behind the 1/t bound and the absence of merging, and the bounds at numbers."""

import pytest
from sympy import Rational, S, limit, pi

from theory import near_critical, rate_bounds
from theory.excursion import angle, excursion, next_excess_slope
from theory.symbols import q, r, theta

ANGLES = [Rational(1, 1000), Rational(1, 3), S(1), pi / 2]
FRACTIONS = [Rational(1, 50), Rational(1, 2), Rational(49, 50)]


def close(expression, **choices):
    point = {theta: choices.get("theta", S(1)), q: choices.get("q", Rational(1, 3)), angle: Rational(1, 2)}
    return abs(expression.subs(point).evalf(40)) < 1e-30


@pytest.mark.parametrize("fraction", FRACTIONS)
def test_the_bounds_hold_for_every_smaller_angle(fraction):
    lower, upper = (bound.subs(q, fraction) for bound in rate_bounds.inverse_step_bounds())
    exact = rate_bounds.inverse_step().subs(q, fraction)
    for largest in ANGLES:
        for part in (Rational(1, 100), Rational(1, 2), S(1)):
            value = exact.subs(theta, part * largest).evalf(50)
            assert lower.subs(theta, largest).evalf(50) <= value <= upper.subs(theta, largest).evalf(50)


def test_the_bounds_close_on_the_constant_of_the_law(same):
    for bound in rate_bounds.inverse_step_bounds():
        assert same(limit(bound, theta, 0), near_critical.inverse_step())
        assert same(limit(bound, theta, 0), 9 * r / (4 * q))


@pytest.mark.parametrize("fraction", FRACTIONS)
def test_no_excursion_merges_below_the_level(fraction, same):
    assert same(rate_bounds.no_merging_excess(), q * (pi / 2 - 1) ** 2)
    one = excursion()
    assert close((one.excess - rate_bounds.no_merging_excess()).subs(theta, pi / 2), q=fraction)
    for part in ANGLES:
        at = {theta: part, q: fraction}
        assert 0 < one.next_excess.subs(at).evalf(40) < one.excess.subs(at).evalf(40)
        assert -1 < one.position.subs(at).evalf(40) < 1
        assert next_excess_slope()[3].subs(at).evalf(40) > 0
