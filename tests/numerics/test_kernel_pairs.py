"""Values and roots of polynomials in pairs, of which only the first terms are pairs: against exact rationals."""

from fractions import Fraction

import numpy as np
import pytest

from numerics.arithmetic.pair import nearest
from numerics.linear.columns import PRECISE, UNIT, WIDE_UNIT, sizes
from numerics.linear.evolve import evaluate
from numerics.linear.first_root import value_slope
from numerics.linear.next_event import refined

TERMS, H = 36, 0.125


def exact(terms, s):
    """Value and slope of sum_k terms[k] s^k."""
    value, slope = Fraction(0), Fraction(0)
    for one in reversed(terms):
        value, slope = value * s + one, slope * s + value
    return value, slope


@pytest.mark.parametrize("late", [0.0, 1.0])
def test_a_value_in_pairs_is_off_by_what_is_counted_also_where_late_terms_are_large(late):
    """These, floats, must count as roundings of float64: roundings of double-double would be too few."""
    random, too_few = np.random.default_rng(3), 0
    for _ in range(60):
        rows = np.zeros((2, 2, 1, TERMS))
        rows[0, 0, 0] = random.normal(size=TERMS) * np.where(np.arange(TERMS) < PRECISE, 1.0, late)
        rows[1, 0, 0, :PRECISE] = rows[0, 0, 0, :PRECISE] * random.uniform(-0.5, 0.5, PRECISE) * 2.0**-53
        s = random.uniform(0.1, 1)
        low = s * random.uniform(-1, 1) * 2.0**-54
        x, x_low, v, v_low = evaluate(rows.transpose(0, 2, 1, 3)[:, 0], 0, s, low, H, True)
        terms = [Fraction(a) + Fraction(b) for a, b in rows[:, 0, 0].T]
        value, slope = exact(terms, Fraction(s) + Fraction(low))
        off = [abs(Fraction(x) + Fraction(x_low) - value), abs((Fraction(v) + Fraction(v_low)) * Fraction(H) - slope)]
        counted = [np.zeros((2, TERMS)) for _ in range(2)]
        for most, wide in zip(counted, (True, False), strict=True):
            sizes(rows, np.array([[TERMS], [0]]), np.ones(1), 1, most, wide)
        enough, few = ([one * WIDE_UNIT for one in value_slope(most[0], s)] for most in counted)
        assert all(a <= b for a, b in zip(off, enough, strict=True))
        too_few += any(a > b for a, b in zip(off, few, strict=True))
    assert (too_few > 30) == (late > 0)


@pytest.mark.parametrize("order", [0, 2])
def test_what_is_left_of_a_guard_at_its_root_in_pairs_is_said(order):
    """From starts that are off by up to a millionth of the way to another root, near or far."""
    random, largest = np.random.default_rng(4 + order), 0.0
    for _ in range(200):
        root, gap = Fraction(random.uniform(0.2, 0.8)) + Fraction(random.normal()) / 2**60, 10 ** random.uniform(-3, 0)
        other, bend = root + Fraction(gap), Fraction(random.uniform(-0.5, 0.5))
        # (root - s) (other - s) (1 + bend s)
        terms = [root * other, bend * root * other - root - other, 1 - bend * (root + other), bend]
        g = np.zeros((2, TERMS))
        for k, one in enumerate(terms):
            g[:, k + order] = nearest(one)
        start = float(root) * (1 + random.choice([-1, 1]) * gap * 10 ** random.uniform(-17, -6))
        high, low, left = refined(g, order, start, gap / 8)
        found = Fraction(high) + Fraction(low)
        value, steep = exact(terms, found)
        rounding = 8 * WIDE_UNIT * float(sum(abs(one) for one in terms))
        assert abs(value) <= left + rounding
        assert left <= 1e3 * UNIT * UNIT * (1 + abs(float(steep)) / gap)
        largest = max(largest, float(abs(found - root)) * gap)
    assert largest < 2.0**-96
