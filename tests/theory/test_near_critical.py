"""The asymptotics: series against 60-digit excursions, and the 1/t law against the iterated map."""

import mpmath
import pytest
from sympy import Rational, S, pi, sqrt

from theory import near_critical as near
from theory.symbols import a2, b, epsilon, m1, m2, q, r, total_mass, v1_0, x1_0

FRACTIONS = ["0.5", "0.2", "0.9"]


def exact_excursion(fraction, angle):
    """(eps, X, V, w', stick duration) at a slip angle, from typed formulas in mpmath."""
    height = (angle - mpmath.sin(angle)) / (1 - mpmath.cos(angle))
    start = mpmath.sqrt(fraction) * height
    position = 1 - fraction * (1 - mpmath.cos(angle)) + fraction * height * mpmath.sin(angle)
    velocity = mpmath.sqrt(fraction) * (height - angle)
    after = position**2 + velocity**2 - 1
    leave = mpmath.atan2(mpmath.sqrt(after), -1)
    enter = mpmath.atan2(-velocity, position)
    return start, position, velocity, after, leave - enter


def value(expression, fraction, start):
    return mpmath.mpf(str(expression.subs({q: Rational(fraction), epsilon: S(mpmath.nstr(start, 60))}).evalf(60)))


@pytest.mark.parametrize("fraction", FRACTIONS)
def test_every_series_has_its_order(fraction):
    """Halving the angle divides the error by 2^order or more: the coefficients kept are all right."""
    found = near.cycle()
    series = [found.slip_angle, found.position, found.velocity, found.next_excess, found.stick_duration]
    with mpmath.workdps(60):
        errors = []
        for angle in (mpmath.mpf("1e-3"), mpmath.mpf("5e-4")):
            start, *rest = exact_excursion(mpmath.mpf(fraction), angle)
            exact = [angle, *rest]
            errors.append([abs(value(s, fraction, start) - e) for s, e in zip(series, exact, strict=True)])
        orders = [mpmath.log(coarse / fine, 2) for coarse, fine in zip(*errors, strict=True)]
    least = [near.ORDER] * 4 + [near.ORDER - 1]
    assert all(order > expected - 0.1 for order, expected in zip(orders, least, strict=True))


def test_the_cycle_is_slip_plus_stick(same):
    found = near.cycle()
    total = found.slip_duration + found.stick_duration
    assert same(total.series(epsilon, 0, near.ORDER - 1).removeO(), found.cycle_duration)
    assert same(found.slip_duration, sqrt(q) * found.slip_angle)


def test_the_stick_rotation_is_a_rotation_on_one_level(same):
    """cos^2 + sin^2 = 1 exactly where entry and exit have the same energy: X^2 + V^2 = 1 + epsilon^2."""
    cosine, sine = near.stick_rotation()
    norm = (cosine**2 + sine**2) * (x1_0**2 + v1_0**2)
    assert same(norm, 1 + epsilon**2)


def test_the_rate_law(same):
    assert same(near.quadratic_coefficient(), 9 * r / (4 * q))
    assert same(near.inverse_step(), near.quadratic_coefficient())
    assert near.cycle_limit() == pi
    assert near.excess_ratio_limit() == 1
    assert same(near.reduced_rate_constant(), 4 * pi * q / (9 * r))
    mass = total_mass()
    printed = b**2 * mass**2 / (2 * a2 * m2**2) * (4 * pi / 9) * (m1 / m2) * sqrt(mass / a2)
    assert same(near.rate_constant(), printed)
    assert near.rate_constant().free_symbols == {m1, m2, a2, b}
