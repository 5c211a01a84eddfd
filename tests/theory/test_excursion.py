"""The slip excursion: exact identities, and signs on the whole range of angles."""

from sympy import Integer, Rational, S, cos, diff, expand, limit, pi, simplify, sin, sqrt

from theory import excursion as exc
from theory import scaling
from theory.symbols import V1, V2, X, a2, epsilon, h_value, m1, overshoot, q, r, tau, theta

ANGLES = [Rational(1, 1000), Rational(1, 2), S(2), S(3), Rational(9, 2), S(6), Rational(628, 100)]


def identical(left, right):
    """Equality by the decision procedure, confirmed in 40 digits at angles of the range."""
    difference = left - right
    exact = exc.half_tangent_form(difference) == 0
    numbers = [{theta: angle, q: Rational(1, 3), epsilon: Rational(2, 7), h_value: S(2)} for angle in ANGLES[1:4]]
    numeric = all(abs(difference.subs(point).evalf(40)) < 1e-30 for point in numbers)
    assert exact == numeric
    return exact


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


def test_the_guard_and_its_factors():
    guard = exc.slip_from_ray().guard
    square, simple = exc.guard_factors()
    assert identical(guard, square * simple)
    assert not identical(guard, square * (simple + 2 * epsilon / sqrt(q)))
    assert [limit(diff(square, theta, n), theta, 0) for n in (0, 1)] == [0, 0]
    assert identical(exc.guard_of_u(), theta - sin(theta) - h_value * (1 - cos(theta)))


def test_the_end_of_the_excursion():
    one = exc.excursion()
    height = exc.h()
    assert identical(one.start_velocity, sqrt(q) * height)
    assert identical(one.position, 1 - q * (1 - cos(theta)) + q * height * sin(theta))
    assert identical(one.velocity, sqrt(q) * (height - theta))
    assert identical(one.excess, q * height**2)
    assert not identical(one.position, 1 - q * (1 - cos(theta)) - q * height * sin(theta))
    # Both bodies end with the same velocity.
    slip = exc.slip_from_ray()
    assert identical(slip.V1.subs(epsilon, one.start_velocity), slip.V2.subs(epsilon, one.start_velocity))


def test_displacement_and_energy():
    one = exc.excursion()
    printed = (theta - sin(theta)) ** 2 / (1 - cos(theta)) - theta**2 / 2 + 1 - cos(theta)
    assert identical(exc.displacement_of_angle(), printed)
    assert exc.energy_balance() == 0
    assert identical(one.next_excess, exc.next_excess())
    assert identical(exc.next_excess(), exc.h() ** 2 * q - 2 * r * q * printed)
    assert not identical(one.next_excess, exc.h() ** 2 * q - r * q * printed)
    assert not identical(one.next_excess, exc.h() ** 2 * q - 2 * q * q * printed)


def test_the_duration_in_si(same):
    assert same(exc.duration_in_si(), theta * sqrt(m1 / a2))
    in_units = scaling.to_si(exc.excursion().duration) / scaling.stick_frequency()
    assert same(in_units, exc.duration_in_si())


def test_the_half_tangent_form_decides():
    assert exc.half_tangent_form(sin(theta) ** 2 + cos(theta) ** 2 - 1) == 0
    assert exc.half_tangent_form(sin(2 * theta) - 2 * sin(theta) * cos(theta)) == 0
    assert exc.half_tangent_form(sin(theta) - theta) != 0
    assert exc.half_tangent_form(Integer(1) - cos(theta)) != 0
    assert limit(exc.h(), theta, pi) == pi / 2
