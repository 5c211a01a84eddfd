"""The contact that ends a slip: in balls it encloses that of every point, and other arithmetics have the same."""

from fractions import Fraction

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

hundredths = st.integers(1, 300).map(lambda n: n / 100)
widths = st.sampled_from([0, 1e-3, 0.02, 0.1, 0.3])


@given(hundredths, hundredths, widths, widths, st.floats(0, 1), st.floats(0, 1))
@example(1.0, 1.0, 1e-3, 1e-3, 0.0, 1.0)
def test_every_slip_of_a_ball_is_enclosed_or_none_is(gap, push, wider, faster, part, share):
    inside = arb(gap) + part * wider, arb(push) + share * faster
    with Ball(16).context():
        try:
            found = contact(*(arb(low).union(arb(low + by)) for low, by in ((gap, wider), (push, faster))))
        except EventUndecided:
            assert max(wider, faster) > 1e-3
            return
    with Ball(40).context():
        assert all(one.overlaps(two) for one, two in zip(found, contact(*inside), strict=True))


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
