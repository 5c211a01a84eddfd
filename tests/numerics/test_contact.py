"""The contact that ends a slip, in balls: it encloses that of every point, by bisection in another arithmetic."""

from fractions import Fraction
from functools import cache
from itertools import product

import mpmath
import pytest
from flint import arb
from hypothesis import example, given
from hypothesis import strategies as st
from strategies import decimals

from numerics import EventUndecided
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.free.contact import contact


def rise(theta):
    return theta / (1 - mpmath.cos(theta)) - mpmath.cot(theta / 2)


def depth(theta):
    return 2 - theta * mpmath.cot(theta / 2)


@cache
def slip_angle(gap, push):
    """The angle at which u + d cot(theta/2) = h(theta): the left side less the right one falls on (0, 2 pi)."""
    low, high = mpmath.mpf(10) ** -9, 2 * mpmath.pi - mpmath.mpf(10) ** -9
    for _ in range(50):
        middle = (low + high) / 2
        if push + gap / mpmath.tan(middle / 2) > rise(middle):
            low = middle
        else:
            high = middle
    return low


def holds(enclosure, truth):
    """Whether a ball holds a true number, but for what the bisection can be wrong by."""
    return enclosure.overlaps(arb(float(truth), 1e-12 * max(1, abs(float(truth)))))


hundredths = st.integers(1, 300).map(lambda n: n / 100)
widths = st.sampled_from([0, 1e-3, 0.02, 0.1, 0.3])


@given(hundredths, hundredths, widths, widths)
@example(1.0, 1.0, 1e-3, 1e-3)
def test_every_slip_of_a_ball_is_enclosed_or_none_is(gap, push, wider, faster):
    with Ball(16).context():
        try:
            found = contact(*(arb(low).union(arb(low + by)) for low, by in ((gap, wider), (push, faster))))
        except EventUndecided:
            assert max(wider, faster) > 1e-3
            return
        for d, u in product(*([low, low + by / 3, low + by] for low, by in ((gap, wider), (push, faster)))):
            theta = slip_angle(d, u)
            assert all(map(holds, found, (theta, depth(theta), 1 - mpmath.cos(theta))))


@given(decimals(-40, 40), decimals(-40, 40) | decimals(-3, 1), st.booleans(), st.booleans())
@example(Fraction(1), Fraction(6), True, False)  # beyond half a turn, where 1 - cos falls
def test_a_contact_in_mpmath_is_that_of_balls(gap, push, on_ray, back):
    d, u = (0 if on_ray else gap), (-push if back and not on_ray else push)
    balls, points = Ball(60), Multiprecision(60)
    with balls.context():
        theta, deep, _ = contact(balls.number(d), balls.number(u))
    with points.context():
        ours = contact(points.number(d), points.number(u))
    with Ball(90).context():
        for one, two in zip((theta, deep), ours, strict=False):
            assert abs(one / arb(mpmath.nstr(two, 70)) - 1) < 1e-25


@pytest.mark.parametrize(("gap", "push"), [(-1, 1), (0, 0), (1, "nan"), ("inf", 1)])
def test_a_slip_that_does_not_exist_is_refused(gap, push):
    with Ball(16).context(), pytest.raises(EventUndecided, match="existence"):
        contact(arb(gap), arb(push))
