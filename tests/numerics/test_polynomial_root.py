"""The first sign change of polynomials is exact: roots of any multiplicity, touches passed over."""

from fractions import Fraction

from numerics.linear.polynomial_root import first_crossing, touches


def test_a_crossing_is_the_first_root_of_odd_multiplicity_after_a_time():
    t = [Fraction(one) for one in (0, -4, 8, -5, 1)]  # t (t - 1) (t - 2)^2
    for after, found in ((0, (1, True)), (Fraction(1, 2), (1, True)), (1, (3, False)), (2, (3, False))):
        assert first_crossing([t], Fraction(after), Fraction(3)) == found
    assert [touches([t], Fraction(after), Fraction(3)) for after in (0, 1, 2)] == [True, True, False]
    for square, touched in (([-2, 0, 1], 0), ([-2, 4, -1, -2, 1], 1)):  # t^2 - 2, and that (t - 1)^2
        before, is_root = first_crossing([list(map(Fraction, square))], Fraction(0), Fraction(3))
        assert (touched < before and before**2 < 2, is_root) == (True, False)
    assert first_crossing([[Fraction(2), Fraction(-2), Fraction(1)]], Fraction(0), Fraction(3)) == (3, False)
