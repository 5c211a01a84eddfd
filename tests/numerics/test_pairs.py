"""Double-double: operations and the contact to a few 2^-105 of themselves."""

from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from strategies import wide_numbers

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.pair import UNIT, Pair, two_sum
from numerics.free.contact import contact

more = settings(max_examples=4 * settings().max_examples)


def ball(x: Pair) -> arb:
    return arb(x.high) + arb(x.low)


@more
@given(wide_numbers(-300, 300), wide_numbers(-300, 300), st.booleans())
def test_operations_are_accurate_relative_to_their_results(a, b, close):
    if close:
        b = two_sum(a.high * (1 + 2.0**-50), -a.low)
    with Ball(700).context():
        one, two = ball(a), ball(b)
        for found, truth, units in (
            (a + b, one + two, 1.5),
            (a - b, one - two, 1.5),
            (a * b, one * two, 2.5),
            (a / b, one / two, 5),
            (3 - a * 5, 3 - one * 5, 1.5 + 2.5),
            (7 / a + 1, 7 / one + 1, 5 + 1.5),
        ):
            # a difference below the normal numbers has fewer digits
            size = abs(truth) if units <= 5 and found.high else abs(truth) + 5 * one + 7 / one
            assert truth.contains(0) or abs(ball(found) - truth) <= units * UNIT * size


@more
@given(wide_numbers(-100, 20), wide_numbers(-100, 20), st.sampled_from(["ray", "outwards", "inwards"]))
def test_the_contact_is_that_of_balls(gap, push, kind):
    if kind == "ray":
        gap = Pair(0.0, 0.0)
    if kind == "inwards":
        push = -push
        assume(abs(push.high) < 2.0**30 * gap.high)  # else theta is gap/push next to nothing
    theta, depth, _ = contact(gap, push)
    with Ball(200).context():
        true_theta, true_depth, _ = contact(ball(gap), ball(push))
        assert abs(ball(theta) - true_theta) <= 32 * UNIT * abs(true_theta)
        assert abs(ball(depth) - true_depth) <= 64 * UNIT * abs(true_depth)
