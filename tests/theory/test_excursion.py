"""The series of one excursion against 100 digits of the closed form typed here."""

import mpmath
import pytest
from sympy import Rational

from theory import near_critical
from theory.symbols import epsilon


def exact_excursion(q, angle):
    """(eps, theta, X, V, w', stick duration) at a slip angle, from typed formulas in mpmath."""
    height = (angle - mpmath.sin(angle)) / (1 - mpmath.cos(angle))
    position = 1 - q * (1 - mpmath.cos(angle)) + q * height * mpmath.sin(angle)
    velocity = mpmath.sqrt(q) * (height - angle)
    after = position**2 + velocity**2 - 1
    stick = mpmath.atan2(mpmath.sqrt(after), -1) - mpmath.atan2(-velocity, position)
    return mpmath.sqrt(q) * height, angle, position, velocity, after, stick


@pytest.mark.parametrize("fraction", ["0.5", "0.2", "0.9"])
def test_every_series_has_its_order(fraction):
    """Halving the angle divides the error by 2^order or more: the coefficients kept are all right."""
    found, errors = near_critical.cycle(), []
    series = [found.slip_angle, found.position, found.velocity, found.next_excess, found.stick_duration]
    with mpmath.workdps(100):
        for angle in ("1e-3", "5e-4"):
            start, *exact = exact_excursion(mpmath.mpf(fraction), mpmath.mpf(angle))
            at = {"q": Rational(fraction), epsilon.name: Rational(mpmath.nstr(start, 100))}
            numbers = [one.subs({letter: at[letter.name] for letter in one.free_symbols}).evalf(100) for one in series]
            errors.append([abs(mpmath.mpf(str(one)) - true) for one, true in zip(numbers, exact, strict=True)])
        orders = [mpmath.log(coarse / fine, 2) for coarse, fine in zip(*errors, strict=True)]
    least = [near_critical.ORDER] * 4 + [near_critical.ORDER - 1]
    assert all(order > expected - 0.1 for order, expected in zip(orders, least, strict=True))
