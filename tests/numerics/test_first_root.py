"""The first root of a guard in floats: what is clear exceeds its margin, and a root is the first one and alone."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import polynomials_of_roots

from numerics.linear.first_root import ROOT, UNDECIDED, first_root

TERMS = 24


def value(q, s):
    return np.polynomial.polynomial.polyval(s, q)


def padded(*q):
    return np.pad(np.array(q, float), (0, TERMS - len(q)))


def rooted(q, margins, theta):
    return first_root(q, margins, theta, np.zeros(8))


@given(polynomials_of_roots(TERMS), st.data())
@settings(max_examples=150)
def test_what_is_clear_exceeds_its_margin_and_a_root_is_the_first_and_alone(one, data):
    theta, q, scale = one
    m0, m1, m2 = (scale * data.draw(st.sampled_from([0.0, 0.0, 1e-12, 1e-7, 1e-3])) for _ in range(3))
    how, s, alone = rooted(q, (m0, m1, m2), theta)
    assert 0 < s <= theta
    end = s - alone
    if how != UNDECIDED:
        assert value(q, np.linspace(0, end, 801)).min() > m0 + m1 * end + m2 / end - 1e-15
    if how == ROOT:
        slopes = value(np.polynomial.polynomial.polyder(q), np.linspace(end, s + alone / 16, 801))
        assert abs(value(q, s)) <= 1e-9 * abs(q).max()
        assert slopes.max() < 0.55 * slopes.min() < 0


@pytest.mark.parametrize("power", [7, 8, 9, 14])
def test_no_power_is_left_out_of_what_is_clear(power):
    how, s, _ = rooted(padded(1, *[0] * (power - 1), -1.5), (0.0, 0.0, 0.0), 1.0)
    assert s < 1.5 ** (-1 / power) or (how == ROOT and s == pytest.approx(1.5 ** (-1 / power)))
