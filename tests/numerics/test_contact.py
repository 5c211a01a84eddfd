"""The contact that ends a slip, in balls: it encloses that of every point, by bisection in another arithmetic."""

from fractions import Fraction
from functools import cache
from itertools import product
from random import Random

import mpmath
import pytest
from flint import arb
from hypothesis import example, given
from hypothesis import strategies as st
from strategies import decimals

from numerics import EventUndecided
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.free.contact import contact, ray_contact


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


@given(st.integers(1, 89), hundredths, widths)
def test_the_excess_after_a_slip_from_a_ray_is_enclosed(share, excess, wider):
    with Ball(16).context():
        r, w = arb(share) / 100, arb(excess).union(arb(excess + wider))
        ball = ray_contact(w, arb(0), 1 - r, r)[2]
        for w in (excess, excess + wider / 2, excess + wider):
            deep = depth(slip_angle(0, mpmath.sqrt(w / (1 - share / 100))))
            assert holds(ball, w - share / 100 * (1 - share / 100) * deep**2)


def test_the_contact_of_balls_holds_those_of_points_inside():
    """One argument is a wide ball, so that no other one covers for it."""
    random = Random(2)
    with Ball(40).context():
        for _ in range(300):
            gap, push, w = (arb(10 ** random.uniform(-3, 1.3)) for _ in range(3))
            sign, off, q = random.choice([-1, 1]), 10 ** random.uniform(-9, -2), arb(random.uniform(0.02, 0.98))
            for end in (
                lambda x, gap=gap, push=sign * push: contact(gap * x, push),
                lambda x, gap=gap, push=sign * push: contact(gap, push * x),
                lambda x, push=push: contact(arb(0), push * x),
                lambda x, w=w, q=q: ray_contact(w * x, (w * x / q).sqrt(), q, 1 - q),
            ):
                wide = end(1 + off * arb(0, 1))
                for place in (-1, 1):
                    inside = end(1 + off * arb(place) * (1 - 1e-6))
                    assert all(one.overlaps(two) for one, two in zip(wide, inside, strict=True))


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
