"""Each step of a merging map's cell, and the mean value form beneath the balls, on wide balls: truth is never outside.

Truth comes from mpmath by bisection, which knows nothing of cells. Each property is also fed the faults next to it.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import product

import mpmath
import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from numerics.arithmetic import ball as balls
from numerics.arithmetic.ball import Ball
from numerics.free import contact
from numerics.free import merging as merging_cell
from numerics.free.contact import contact_next_to_binary64
from numerics.free.merging import Rectangle, Verdict, verdict

PARTS = [0, Fraction(1, 3), 1]
SLACK = 1e-12


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


def ball(low, high):
    return arb(float(low)).union(arb(float(high)))


def outside(enclosure, truth):
    """Whether a true number lies outside by more than the bisection can be wrong."""
    return not enclosure.overlaps(arb(float(truth), SLACK * max(1, abs(float(truth)))))


def points(low, high):
    return [low + (high - low) * part for part in PARTS]


# mean value forms


def mean_value_misses(low, high):
    """Points of sin on a ball that the mean value form leaves out."""
    found = balls.mean_value(arb.sin, arb.cos, ball(low, high))
    return [x for x in points(low, high) if outside(found, mpmath.sin(x))]


@given(st.integers(-700, 700), st.integers(0, 700))
def test_a_mean_value_form_holds_the_function_on_wide_balls(low, width):
    with Ball(20).context():
        assert mean_value_misses(low / 100, (low + width) / 100) == []


def test_the_slope_in_the_middle_is_not_enough(monkeypatch):
    monkeypatch.setattr(balls, "mean_value", lambda f, slope, x: f(x.mid()) + slope(x.mid()) * (x - x.mid()))
    with Ball(20).context():
        assert mean_value_misses(0.1, 3.04)


# slip angles over balls of gaps and pushes


def angle_misses(gap, push):
    """Points of a ball of gaps and pushes whose slip angle is not in the enclosure; None where there is none."""
    gaps, pushes = ball(*gap), ball(*push)
    found = contact_next_to_binary64(gaps, pushes)
    if found is None:
        return None
    return [(d, u) for d, u in product(points(*gap), points(*push)) if outside(found[0], slip_angle(d, u))]


hundredths = st.integers(1, 300).map(lambda n: n / 100)
widths = st.sampled_from([0, 1e-3, 0.02, 0.1, 0.3])


@given(hundredths, hundredths, widths, widths)
def test_every_slip_angle_of_a_ball_is_enclosed_or_none_is(gap, push, wider, faster):
    with Ball(16).context():
        assert not angle_misses((gap, gap + wider), (push, push + faster))


def test_slip_angles_are_enclosed_on_most_balls_that_the_map_meets():
    with Ball(16).context():
        tried = [angle_misses((d, d + 0.02), (u, u + 0.02)) for d, u in product((0.1, 0.5, 1.5), (0.3, 1.0, 2.0))]
    assert tried.count([]) >= 8


def test_an_interval_newton_step_that_leaves_its_region_is_no_enclosure(monkeypatch):
    """The rate in the middle instead of over the region: the enclosure is too narrow somewhere."""
    right = contact._over
    monkeypatch.setattr(contact, "_over", lambda gap, push, region: right(gap, push, region.mid()))
    with Ball(16).context():
        found = [angle_misses((d, d + 0.3), (u, u + 0.3)) for d, u in product((0.01, 0.5, 1.5), (0.1, 1.0, 2.0))]
    assert any(found)


# starts known by bounds only


def cell_run(share, excess):
    return merging_cell._CellRun((share, share), (excess, excess))


def short_slip_misses(share, reach, push, excess):
    """Slips from gaps up to `reach` with push < 0 whose excess after it is not that of the ray that follows."""
    run = cell_run(share, Fraction(1, 10))
    start = run._short_slip(arb(float(reach)), arb(float(push)), run.cell.constant(arb(float(excess))))
    if start is None:
        return None
    misses = []
    for part in PARTS[1:]:
        gap = reach * part
        deep = depth(slip_angle(gap, push))
        if outside(start.excess.value, excess - float(share) * deep * (deep + 2 * gap)):
            misses.append(gap)
    return misses


@given(st.integers(51, 99), st.integers(1, 50), st.integers(5, 300), st.integers(50, 400))
def test_a_short_slip_loses_no_more_than_its_bound(share, reach, push, excess):
    with Ball(16).context():
        assert not short_slip_misses(Fraction(share, 100), reach / 100, -push / 100, excess / 100)


def test_a_short_slip_of_half_the_length_is_too_short(monkeypatch):
    half = lambda self, bound: (self.free + self.cell.constant(arb(1))) * (bound / 8)  # noqa: E731
    monkeypatch.setattr(merging_cell._CellRun, "_from_zero_to", half)
    with Ball(16).context():
        assert short_slip_misses(Fraction(9, 10), 0.5, -0.3, 4.0)


def test_a_start_outwards_holds_every_push_of_its_gap():
    """2 d + q d^2 + u^2 = y for every gap d up to the reach."""
    with Ball(16).context():
        for share, reach, excess in product((0.6, 0.9), (0.01, 0.2), (0.6, 2.0)):
            run = cell_run(Fraction(share).limit_denominator(10), Fraction(1, 10))
            start = run._outwards(arb(reach), run.cell.constant(arb(excess)))
            assert start is not None
            for part in PARTS:
                gap = reach * part
                assert not outside(start.gap.value, gap)
                assert not outside(start.push.value, mpmath.sqrt(excess - 2 * gap - (1 - share) * gap * gap))


# false claims next to the edge


def edge(share):
    """The least scaled excess y from which a slip from a ray merges: h = sqrt(r) c, before 1 - cos theta = 1/r."""
    low, high = mpmath.mpf("0.01"), 2 * mpmath.pi - mpmath.acos(1 - 1 / mpmath.mpf(share))
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if rise(middle) ** 2 > share * depth(middle) ** 2 else (low, middle)
    return Fraction(float(rise(low) ** 2))


@pytest.mark.parametrize("share", [Fraction(3, 5), Fraction(3, 4), Fraction(9, 10)])
@pytest.mark.parametrize("width", [Fraction(1, 10**3), Fraction(1, 10**6)])
def test_a_cell_across_the_edge_has_no_verdict_and_both_sides_have_theirs(share, width):
    level = edge(float(share)) * (1 - share)
    ratio = share / (1 - share)

    def found(low, high):
        return verdict(Rectangle((ratio, ratio), (level * (1 + low), level * (1 + high))))

    assert found(-width, width) is Verdict.UNDECIDED
    assert found(-3 * width, -width) is Verdict.CREEPS
    assert found(width, 3 * width) is Verdict.MERGES
