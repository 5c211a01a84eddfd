"""One excursion: it solves the reduced field, and its series against 100 digits of the closed form typed here."""

import mpmath
import pytest
from sympy import Rational, S, diff, expand, simplify, sqrt

from theory import excursion as exc
from theory import near_critical, return_map, scaling
from theory.symbols import V1, V2, X, epsilon, overshoot, q, tau, theta


def test_the_slip_solves_the_reduced_field():
    slip = exc.slip_from_outside()
    along = {X: slip.X, V1: slip.V1, V2: slip.V2}
    for sign, solved in ((-1, True), (1, False)):
        field = scaling.reduced_slip(sign).subs(along, simultaneous=True)
        rates = [diff(entry.subs(theta, tau / sqrt(q)), tau).subs(tau, sqrt(q) * theta) for entry in along.values()]
        left = [simplify(value - expected) == 0 for value, expected in zip(rates, field, strict=True)]
        assert all(left) == solved
    start = [entry.subs(theta, 0) for entry in along.values()]
    assert [expand(entry) for entry in start] == [1 + overshoot, epsilon, epsilon]


def exact_excursion(fraction, angle):
    """(eps, X, V, w', stick duration) at a slip angle, from typed formulas in mpmath."""
    height = (angle - mpmath.sin(angle)) / (1 - mpmath.cos(angle))
    start = mpmath.sqrt(fraction) * height
    position = 1 - fraction * (1 - mpmath.cos(angle)) + fraction * height * mpmath.sin(angle)
    velocity = mpmath.sqrt(fraction) * (height - angle)
    after = position**2 + velocity**2 - 1
    stick = mpmath.atan2(mpmath.sqrt(after), -1) - mpmath.atan2(-velocity, position)
    return start, position, velocity, after, stick


def value(expression, **numbers):
    point = {symbol: Rational(numbers[symbol.name]) for symbol in expression.free_symbols if symbol.name in numbers}
    return mpmath.mpf(str(S(expression).subs(point).evalf(100)))


@pytest.mark.parametrize("fraction", ["0.5", "0.2", "0.9"])
def test_every_series_has_its_order(fraction):
    """Halving the angle divides the error by 2^order or more: the coefficients kept are all right."""
    found = near_critical.cycle()
    excess = {n: q * return_map.return_map_series(n).subs(return_map.scaled_excess, epsilon**2 / q) for n in (2, 3, 8)}
    series = [found.slip_angle, found.position, found.velocity, found.next_excess, found.stick_duration]
    with mpmath.workdps(100):
        errors = []
        for angle in (mpmath.mpf("1e-3"), mpmath.mpf("5e-4")):
            start, *rest = exact_excursion(mpmath.mpf(fraction), angle)
            at = {"q": fraction, epsilon.name: mpmath.nstr(start, 100)}
            exact = [angle, *rest, *[rest[2]] * len(excess)]
            errors.append([abs(value(s, **at) - e) for s, e in zip((*series, *excess.values()), exact, strict=True)])
        orders = [mpmath.log(coarse / fine, 2) for coarse, fine in zip(*errors, strict=True)]
    order = near_critical.ORDER
    least = [order] * 4 + [order - 1] + [2 * n + 2 for n in excess]
    assert all(order > expected - 0.1 for order, expected in zip(orders, least, strict=True))
