"""What follows a tie Lambda = s b is said by its first derivative that does not vanish: on all sides, to any order."""

from fractions import Fraction

import pytest

from numerics import Pair, Piece
from numerics.arithmetic.ball import Ball
from numerics.linear.polynomial_root import first_crossing, touches
from numerics.linear.sine_form import SineForm
from numerics.linear.system import LinearMode
from numerics.linear.ties import mode_after


def after(pair, force, x, v, literal=False):
    """What follows x1 = x, v1 = v2 = v at once, and how many derivatives of its guard vanish."""
    state = [SineForm(one) for one in (x, v, 0, v)]
    return mode_after(pair, LinearMode.under(pair, 0, force).piece, Fraction(0), state, literal=literal)


@pytest.mark.parametrize("angle", [0, "1/3", "-1/3", -7])
def test_a_turned_form_is_that_of_its_signed_angle(angle):
    form, x = SineForm.turned(Fraction(angle), Fraction(3), Fraction(-4)), Ball.number(Fraction(angle))
    assert (form.enclosed(64) - 3 * x.sin() + 4 * x.cos()).contains(0)
    assert form.sign() == (-1 if 3 * x.sin() < 4 * x.cos() else 1)


def test_a_tie_without_a_force_is_decided_by_the_speed():
    pair = Pair("0.4", "0.6", 3, "0.3", "0.7")
    still = -pair.a1 * pair.b / pair.m2 / pair.a2  # p' = 0, and p'' < 0
    for side in (1, -1):
        for v, found in ((still - 1, (side, 2)), (still + 1, (0, 1)), (still, (0, 2))):
            x = (-pair.b * pair.mass / pair.m2 - pair.a1 * v) / pair.a2
            assert after(pair, Piece(0), side * x, side * v) == found


def test_a_crossing_is_the_first_root_of_odd_multiplicity_after_a_time():
    t = [Fraction(one) for one in (0, -4, 8, -5, 1)]  # t (t - 1) (t - 2)^2
    for after, found in ((0, (1, True)), (Fraction(1, 2), (1, True)), (1, (3, False)), (2, (3, False))):
        assert first_crossing([t], Fraction(after), Fraction(3)) == found
    assert [touches([t], Fraction(after), Fraction(3)) for after in (0, 1, 2)] == [True, True, False]
    for square, touched in (([-2, 0, 1], 0), ([-2, 4, -1, -2, 1], 1)):  # t^2 - 2, and that (t - 1)^2
        before, is_root = first_crossing([list(map(Fraction, square))], Fraction(0), Fraction(3))
        assert (touched < before and before**2 < 2, is_root) == (True, False)
    assert first_crossing([[Fraction(2), Fraction(-2), Fraction(1)]], Fraction(0), Fraction(3)) == (3, False)
