"""Values and roots of polynomials in pairs, of which only the first terms are pairs: against exact rationals."""

from fractions import Fraction

import numpy as np
import pytest

from numerics.arithmetic.pair import nearest
from numerics.linear.columns import counted
from numerics.linear.evolve import evaluate
from numerics.linear.next_event import refined
from numerics.linear.table import ORDERS, PRECISE, UNIT, WIDE_UNIT, count_roundings, make_tables

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
        x, x_low, v, v_low = evaluate(rows[:, 0, 0], s, low, H, True)
        terms = [Fraction(a) + Fraction(b) for a, b in rows[:, 0, 0].T]
        value, slope = exact(terms, Fraction(s) + Fraction(low))
        off = [abs(Fraction(x) + Fraction(x_low) - value), abs((Fraction(v) + Fraction(v_low)) * Fraction(H) - slope)]
        tables = make_tables(1, 1, TERMS)
        tables.rows[0, 0], tables.count[0] = rows, 1
        both = []
        for wide in (True, False):
            count_roundings(tables, 0, 0, wide)
            both.append([WIDE_UNIT * counted(one, np.ones(1), 1, s) for one in tables.state_own[0, 0, :2]])
        enough, few = both
        assert all(a <= b for a, b in zip(off, enough, strict=True))
        too_few += any(a > b for a, b in zip(off, few, strict=True))
    assert (too_few > 30) == (late > 0)


@pytest.mark.parametrize("side", [0, 1])
def test_the_roundings_of_a_guard_are_all_counted_at_the_ends_of_a_step_and_enough_between(side):
    """Slip: s = v1 - v2, of both bodies; stick: the load, of the slope of v2. c_k s^k takes 2 k + n + 4 roundings."""
    random, n = np.random.default_rng(5), 3
    rows = random.normal(size=(2, n, TERMS)) * 4.0 ** -np.arange(TERMS)
    tables = make_tables(1, n, TERMS)
    tables.rows[0, side, 0], tables.count[0] = rows, n
    count_roundings(tables, 0, side, False)
    sizes, k = random.uniform(0.5, 2, n), np.arange(TERMS)
    roundings = 2 * k + n + 4
    terms = sizes @ (roundings * (k * np.abs(rows).sum(axis=0) if side == 0 else k * (k - 1) * np.abs(rows[1])))
    for order in range(ORDERS):
        left = terms[1 + side + order :]  # where coefficients vanish at the start, s^order is taken out
        sums = tables.own[0, side, order]
        for s in (0.0, 1e-3, 0.1, 0.5, 0.9, 1.0):
            found, true = counted(sums, sizes, n, s), float(left @ s ** np.arange(len(left)))
            assert found == pytest.approx(true, rel=1e-12) if s in {0.0, 1.0} else found > true
        # two terms are their chord: nothing is added between the ends
        tables.rows[0, side, 0, :, :, 3 + side + order :] = 0.0
        count_roundings(tables, 0, side, False)
        assert counted(sums, sizes, n, 0.25) == pytest.approx(float(left[0] + left[1] / 4), rel=1e-12)
        tables.rows[0, side, 0] = rows
        count_roundings(tables, 0, side, False)


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
