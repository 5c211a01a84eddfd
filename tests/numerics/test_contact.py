"""The contact that ends a slip, in balls: it encloses that of every point, by bisection in another arithmetic."""

from functools import cache
from itertools import product

import mpmath
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from numerics.arithmetic.ball import Ball
from numerics.free.contact import enclosed_contact, ray_contact


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
def test_every_slip_of_a_ball_is_enclosed_or_none_is(gap, push, wider, faster):
    with Ball(16).context():
        found = enclosed_contact(*(arb(low).union(arb(low + by)) for low, by in ((gap, wider), (push, faster))))
        for d, u in product(*([low, low + by / 3, low + by] for low, by in ((gap, wider), (push, faster)))):
            theta = slip_angle(d, u)
            assert found is None or all(map(holds, found, (theta, depth(theta), 1 - mpmath.cos(theta))))


@given(st.integers(1, 89), hundredths, widths)
def test_the_excess_after_a_slip_from_a_ray_is_enclosed(share, excess, wider):
    with Ball(16).context():
        r, w = arb(share) / 100, arb(excess).union(arb(excess + wider))
        ball = ray_contact(w, arb(0), 1 - r, r, (1 - r).sqrt())[2]
        for w in (excess, excess + wider / 2, excess + wider):
            deep = depth(slip_angle(0, mpmath.sqrt(w / (1 - share / 100))))
            assert holds(ball, w - share / 100 * (1 - share / 100) * deep**2)
