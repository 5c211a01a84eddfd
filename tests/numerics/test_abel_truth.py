"""The Abel functions' error bounds against the truth."""

from fractions import Fraction
from functools import cache
from itertools import islice

import pytest
from flint import arb

from numerics import EventUndecided, Pair
from numerics.arithmetic.ball import Ball
from numerics.free.abel import AbelFunctions
from numerics.free.excursions import excursions
from numerics.free.frame import Frame

FAR = 400
"""Excursions after which a function of any order is known to many more digits than at the start."""
in_200_digits = cache(AbelFunctions)
"""The functions of a share and an order, made in the precision of the one test that uses them."""


@pytest.mark.parametrize("share", [Fraction(1, 5), Fraction(1, 2), Fraction(9, 10)])
@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize("part", [Fraction(999, 1000), Fraction(1, 100), Fraction(1, 10**12)])
def test_low_orders_enclose_the_truth(share, order, part):
    """From the rim of what is certified far inwards, where a bound with a zero of too high an order is too small.

    The truth is that of order 24 after many excursions: alpha(y) = alpha(y_n) - n, beta(y) = beta(y_n) - time, and
    slide(y) = (y - y_1) - (y_1 - y_2) + ... + slide(y_n), n being even.
    """
    arithmetic = Ball(200)
    with arithmetic.context():
        functions, exact = in_200_digits(share, order), in_200_digits(share, 24)
        y = arithmetic.number(functions.largest_argument * part)
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        time, after, slid, side = arb(0), frame.q * y, arb(0), 1
        for one in islice(excursions(frame, after), FAR):
            time, after, slid = time + one.slip + one.stick, one.w_after, slid + side * (one.w - one.w_after) / frame.q
            side = -side
        last = after / frame.q
        alpha, beta = exact.alpha(last) - FAR, exact.beta(last) - time
        found = functions.alpha(y), functions.beta(y)
        assert found[0].contains(alpha.mid())
        assert found[1].contains(beta.mid())
        assert functions.slide(y).contains((slid + exact.slide(last)).mid())
        # beta's part beyond pi alpha has a bound of its own
        epsilon, half = (frame.q * y).sqrt(), arb(0)
        for coefficient in reversed(functions.beta_coefficients):
            half = (half + arb(coefficient)) * epsilon
        missed = abs(half - (beta - arb.pi() * alpha)).mid()
        assert missed <= found[1].rad() - arb.pi() * found[0].rad() * (1 - arb(10) ** -8) + found[0].rad() * 1e-6


def test_beyond_what_is_certified_nothing_is_said():
    with Ball(30).context():
        functions = AbelFunctions(Fraction(1, 2), 4)
        with pytest.raises(EventUndecided, match="within the certified"):
            functions.alpha(Ball(30).number(functions.largest_argument * Fraction(1001, 1000)))
