"""Root exclusion: bounds from below that hold and are sharp; CLEAR, ROOT and UNDECIDED only where they are true."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import polynomials_of_roots, reaches

from numerics.linear.first_root import (
    BERNSTEIN,
    CLEAR,
    ROOT,
    UNDECIDED,
    bounds,
    crossing,
    first_root,
)

TERMS, ROOM, NONE = 24, np.zeros(8), np.inf
seeds = st.integers(0, 2**32 - 1)


def value(q, s):
    return np.polynomial.polynomial.polyval(s, q)


def grid(start, end):
    return np.linspace(start, end, 801)


def padded(q):
    return np.pad(q, (0, TERMS - len(q)))


def tail(random):
    """Coefficients beyond those that Bernstein's basis takes, of one sign or of both."""
    return random.choice([0, 0.01, 1]) * random.choice([-1, 1], TERMS - 8) / np.arange(1, TERMS - 7)


@given(seeds, reaches)
def test_bounds_hold_and_are_sharp_where_the_least_and_largest_coefficients_are_the_ends(seed, theta):
    random = np.random.default_rng(seed)
    c = random.uniform(0.5, 2, 8)
    c[0], c[7] = random.permutation([random.uniform(0, 0.5), 2]) if seed % 2 else (2, random.uniform(-1, 0.5))
    high = tail(random)
    q = np.concatenate([np.linalg.solve(BERNSTEIN.T, c) / theta ** np.arange(8), high])
    tails = abs(high) @ theta ** np.arange(8, TERMS)
    low, most = bounds(q, theta, ROOM)
    values = value(q, grid(0, theta))
    assert low - 1e-9 <= values.min() <= values.max() <= most + 1e-9
    assert abs(low - (c.min() - tails)) < 1e-6
    assert abs(most - (c.max() + tails)) < 1e-6
    guess, which = crossing(ROOM, theta, NONE)
    assert (guess >= 0) == (c.min() <= 0)
    assert which == 0
    guess, which = crossing(ROOM, theta, 1.1 * c[0])
    assert (guess >= 0) == (c.min() <= 0 or c.max() >= 1.1 * c[0])
    assert which == 0 or c.max() >= 1.1 * c[0]


def holds(q, order, top, margins, theta):
    """Whether what is found is true of dense values; return how."""
    m0, m1, m2, m_other = margins
    how, s, room, which, *_ = first_root(q, order, top, margins, theta, ROOM)
    other = np.concatenate([[top], np.zeros(order + TERMS - 1)])
    other[order : order + TERMS] -= q
    assert 0 < s <= theta
    end = s - room if how == ROOT else s
    if how != UNDECIDED:
        assert value(q, grid(0, end)).min() > m0 + m1 * end + m2 / end - 1e-15
        assert top == NONE or value(other, grid(0, end)).min() > m_other - 1e-15
    if how == ROOT:
        assert not (which and order)
        one = other if which else q
        slopes = value(np.polynomial.polynomial.polyder(one), grid(s - room, s + room / 16))
        assert room > 0
        assert abs(value(one, s)) <= 1e-9 * abs(one).max()
        assert slopes.max() < 0.55 * slopes.min() < 0
    return how


@given(polynomials_of_roots(TERMS), st.data())
@settings(max_examples=150)
def test_what_is_clear_exceeds_its_margin_and_a_root_is_the_first_and_alone(one, data):
    theta, q, scale = one
    small = st.sampled_from([0.0, 0.0, 1e-12, 1e-7, 1e-3]).map(lambda x: x * scale)
    margins = tuple(data.draw(small) for _ in range(4))
    top = data.draw(st.sampled_from([NONE, 1.1, 2.0, 5.0]).map(lambda x: x * max(abs(q[0]), 1e-3 * scale)))
    holds(q, data.draw(st.sampled_from([0, 0, 1, 2])), top, margins, theta)


@given(st.floats(0.02, 0.98), st.sampled_from([-0.4, 0.0, 0.3]), st.sampled_from([0.0, 1e-9]), reaches, st.booleans())
def test_a_single_root_is_found_in_either_guard_and_a_double_one_never(part, slope, margin, theta, swap):
    r = part * theta
    single, double = padded(np.array([1, slope - 1 / r, -slope / r])), padded(np.array([1, -2 / r, 1 / r**2]))
    one = padded(np.array([5.0])) - single if swap else single  # of the other guard, 5 less it
    how, s, room, which, *_ = first_root(one, 0, 5.0, (margin, 0, 0, margin), theta, ROOM)
    assert (how, which) == (ROOT, int(swap))
    assert abs(s - r) < 1e-9
    assert room > 0.05 * r
    assert room * abs(2 * slope) <= 0.26 * abs(1 + slope * r)  # the slope keeps its sign there
    how, s, *_ = first_root(double, 0, NONE, (margin, 0, 0, 0), theta, ROOM)
    assert how == UNDECIDED or (how == CLEAR and s < r)


@given(st.floats(0.1, 0.9), st.sampled_from(range(4)), reaches)
def test_a_margin_is_the_sum_of_its_parts(value_at_end, part, theta):
    """A guard that falls to a value at the end is clear with a margin a little below it, not a little above."""
    q = padded(np.array([1, (value_at_end - 1) / theta]))
    weights = np.array([1, theta, 1 / theta, 1])
    for factor, is_clear in ((0.999, True), (1.001, False)):
        margins = np.where(np.arange(4) == part, factor * value_at_end / weights, 0)
        guards = (padded(np.array([5.0])) - q, 0, 5.0) if part == 3 else (q, 0, NONE)
        how, s, *_ = first_root(*guards, margins, theta, ROOM)
        assert (how == CLEAR and s == theta) == is_clear
        if part < 3:  # a root is looked for from half of its time on
            root = value_at_end * theta
            margins = np.where(np.arange(4) == part, factor / 2 / np.array([1, root / 2, 2 / root, 1]), 0)
            how, *_ = first_root(padded(np.array([1, -1 / root])), 0, NONE, margins, theta, ROOM)
            assert (how == ROOT) == is_clear
