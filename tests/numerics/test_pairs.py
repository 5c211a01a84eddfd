"""Double-double: operations and functions to a few 2^-105 of themselves, in Python and compiled alike."""

import pytest
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from numerics.arithmetic import functions
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.compiled import can_compile, compiled
from numerics.arithmetic.pair import UNIT, Pair, two_sum
from numerics.free.contact import contact

more = settings(max_examples=4 * settings().max_examples)


def pairs(low: int, high: int) -> st.SearchStrategy[Pair]:
    """Positive numbers from 2^low to 2^high, with all of their 106 bits."""
    parts = st.tuples(st.floats(1, 2), st.floats(-1, 1), st.integers(low, high - 1))
    return parts.map(lambda at: two_sum(at[0] * 2.0 ** at[2], at[1] * 2.0 ** (at[2] - 53)))


def ball(x: Pair) -> arb:
    return arb(x.high) + arb(x.low)


FUNCTIONS = {
    "sine": (lambda x: x.sin(), functions.sin, 49, 3),
    "cosine": (lambda x: x.cos(), lambda x: functions.sine_cosine(x)[1], 49, 3),
    "versine": (lambda x: 2 * (x / 2).sin() ** 2, functions.versine, 40, 4),
    "sine deficit": (lambda x: x - x.sin(), functions.sine_deficit, 40, 4),
    "cosine deficit": (lambda x: x * x / 2 - 1 + x.cos(), functions.cosine_deficit, 40, 16),
    "depth": (lambda x: 2 - x * (x / 2).cot(), lambda x: functions.depth_and_cotangent(x)[0], 2, 8),
    "arcus tangent": (lambda x: x.atan(), lambda x: functions.atan2(x, Pair(1.0, 0.0)), 40, 3),
    "root": (lambda x: x.sqrt(), functions.sqrt, 40, 2),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_are_accurate_relative_to_themselves(name):
    reference, function, highest, units = FUNCTIONS[name]

    @more
    @given(st.one_of(pairs(-160, highest), pairs(-6, min(highest, 3)), pairs(highest - 1, highest)))
    def check(x):
        with Ball(300).context():
            truth = reference(ball(x))
            reduction = 2.0**-160 * x.high if name in {"sine", "cosine"} else 0.0
            assert abs(ball(function(x)) - truth) <= units * UNIT * abs(truth) + reduction

    check()


@more
@given(pairs(-300, 300), pairs(-300, 300), st.booleans())
def test_operations_are_accurate_relative_to_their_results(a, b, close):
    if close:
        b = two_sum(a.high * (1 + 2.0**-50), -a.low)
    with Ball(300).context():
        one, two = ball(a), ball(b)
        for found, truth, units in (
            (a + b, one + two, 1.5),
            (a - b, one - two, 1.5),
            (a * b, one * two, 2.5),
            (a / b, one / two, 5),
            (3 - a * 5, 3 - one * 5, 1.5 + 2.5),
            (7 / a + 1, 7 / one + 1, 5 + 1.5),
        ):
            # a difference below the normal numbers is beyond the 300 digits of its terms
            size = abs(truth) if units <= 5 and found.high else abs(truth) + 5 * one + 7 / one
            assert truth.contains(0) or abs(ball(found) - truth) <= units * UNIT * size


@more
@given(pairs(-100, 20), pairs(-100, 20), st.sampled_from(["ray", "outwards", "inwards"]))
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


def everything(x, y):
    """All operators, with numbers on either side, and all functions."""
    sine, cosine = functions.sine_cosine(x)
    depth, cotangent = functions.depth_and_cotangent(functions.like(x, 0.5) + x / 1000000)
    total = ((x + y) * 2 - 3 * sine) / (1 + cosine * cosine) + y / 8 - 1 / (4.5 + abs(-y))
    total = total + functions.versine(x) * functions.sine_deficit(y) + functions.cosine_deficit(x) - depth * cotangent
    total, rest = functions.clock(total, y, functions.atan2(functions.sqrt(x), y))
    last = functions.signed(-1.0, functions.nonnegative(total)) + functions.two_pi(x) * functions.tolerance(x)
    return last + rest, functions.ceiling(x, 0), functions.sign(-y, 0), functions.resolved(x), x < y


@pytest.mark.slow
def test_compiled_code_has_the_same_bits():
    if not can_compile():
        pytest.skip("numba is not installed")
    fast = compiled(everything)

    @more
    @given(pairs(-30, 30), pairs(-30, 30))
    def check(x, y):
        assert fast(x, y) == everything(x, y)
        assert fast(x.high, y.high) == everything(x.high, y.high)

    check()
