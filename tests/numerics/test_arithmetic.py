"""Functions in both arithmetics against their definitions; pairs of floats, wide balls, what is no number, roots."""

from fractions import Fraction

import mpmath
from flint import arb
from hypothesis import example, given, settings
from hypothesis import strategies as st
from strategies import near_quarter_turns, positive_floats, two_floats

from numerics.arithmetic import functions
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.pair import TwoFloats, nearest, plus, product, quotient, times, two_product, two_sum
from numerics.arithmetic.precision import precision

BITS = 8000
"""Of the truth."""
more = settings(max_examples=4 * settings().max_examples)
FUNCTIONS = {
    "sqrt": (functions.sqrt, lambda x: x.sqrt(), (-830, 830)),
    "sin": (lambda x: functions.sine_cosine(x)[0], lambda x: x.sin(), (-830, 30)),
    "cos": (lambda x: functions.sine_cosine(x)[1], lambda x: x.cos(), (-830, 30)),
    "atan2(x, 1)": (lambda x: functions.atan2(x, x * 0 + 1), lambda x: x.atan(), (-660, 660)),
    "versine": (functions.versine, lambda x: 1 - x.cos(), (-400, 30)),
    "sine_deficit": (functions.sine_deficit, lambda x: x - x.sin(), (-265, 30)),
    "cosine_deficit": (functions.cosine_deficit, lambda x: x * x / 2 - 1 + x.cos(), (-200, 30)),
    "depth": (lambda x: functions.depth_and_cotangent(x)[0], lambda x: 2 - x * (x / 2).cot(), (-400, 2)),
}
"""Each with its definition in balls, and the powers of 2 between which its value is normal."""


def arguments(name):
    """A function, and floats at which its value is normal."""
    low, high = FUNCTIONS[name][2]
    near = [near_quarter_turns()] if high == 30 else []
    return st.tuples(st.just(name), st.one_of(positive_floats(low, high), positive_floats(-10, min(10, high)), *near))


@more
@given(st.sampled_from(sorted(FUNCTIONS)).flatmap(arguments), st.integers(3, 25), st.floats(0, 1))
@example(("versine", 1 / 3), 3, 1.0)
@example(("sine_deficit", 1 / 3), 3, 1.0)
@example(("cosine_deficit", 1 / 3), 3, 1.0)
def test_functions_are_accurate_relative_to_themselves_in_both_arithmetics_and_hold_every_point_of_a_ball(at, n, part):
    (name, x), radius = at, at[1] / 10**n
    value, truth, _ = FUNCTIONS[name]
    with Multiprecision(30).context():
        found = mpmath.nstr(value(mpmath.mpf(x)), 40)
    with Ball(30).context():
        point, wide = value(arb(x)), value(arb(x, radius))
    with precision(BITS):
        true, inside = truth(arb(x)), [arb(x) + side * part * arb(radius) for side in (-1, 1)]
        assert abs(arb(found) - true) <= abs(true) * arb(10) ** -28
        assert point.overlaps(true)
        assert all(wide.overlaps(truth(one)) for one in inside)
        if n > 5 and x < 0.1:  # x^4 moves four times as much as x, relatively
            assert wide.rad() <= 8 * abs(true) * arb(10) ** -n


def whole(x):
    return Fraction(x.high) + Fraction(x.low)


@more
@given(two_floats(-300, 300), two_floats(-300, 300), st.sampled_from([1, -1]))
@example(TwoFloats(1.0, 2.0**-54 * (1 + 2.0**-30)), TwoFloats(1.0, -(2.0**-54)), -1)
def test_what_a_rounding_leaves_out_is_kept(a, b, sign):
    """Sums and products of floats are exact; what u^2 = 2^-106 counts is as proved (pair.py)."""
    one, two = whole(a), sign * whole(b)
    b = TwoFloats(sign * b.high, sign * b.low)
    assert whole(two_sum(a.high, b.high)) == Fraction(a.high) + Fraction(b.high)
    assert whole(two_product(a.high, b.high)) == Fraction(a.high) * Fraction(b.high)
    assert abs(whole(plus(a, b)) - one - two) <= (abs(one) + abs(two)) / 2**104
    for found, true, most in (
        (times(a, b.high), one * Fraction(b.high), 5),
        (product(a, b), one * two, 5),
        (quotient(a, b), one / two, 10),
        (nearest(one / 3), one / 3, 1),
    ):
        assert abs(whole(found) - true) <= most * abs(true) / 2**106


def test_a_ball_of_0_has_the_sign_0_and_one_that_reaches_below_0_a_root_all_the_same():
    with Ball(20).context():
        assert functions.sign(arb(0), "a graze?") == 0
        assert functions.sqrt(arb(0, 1e-30)).contains(arb(1e-15))
