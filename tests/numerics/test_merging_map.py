"""The merging map: its cells against single runs, the edges of the set, and faults planted in it."""

import random
from fractions import Fraction
from functools import cache
from itertools import pairwise, product

import mpmath
import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from numerics import Pair
from numerics.arithmetic.ball import Ball
from numerics.free import merging as merging_cell
from numerics.free import merging_map
from numerics.free.contact import enclosed_contact, ray_contact
from numerics.free.excursions import excursions
from numerics.free.frame import Frame
from numerics.free.merging import CRITICAL_SHARE, Merging, creeping_excess, verdict
from numerics.free.merging_map import merging_cells

POINTS = 200
PROVED_TO_CREEP = 0.325  # below (pi/2 - 1)^2


def fate(ratio: Fraction, excess: Fraction) -> Merging:
    """One start on S0, followed from ray to ray until it merges or is below the proved level of creeping."""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=1, m2=ratio, a2=1, b=1))
        for one in excursions(frame, arithmetic.number(excess)):
            if one.stick is None:
                return Merging.MERGES
            if one.w_after / frame.q < PROVED_TO_CREEP:
                return Merging.CREEPS
    raise AssertionError


def contradictions(cells, points=POINTS, seed=1):
    """Decided cells, small and large alike, that a run from one of their points contradicts; corners are points."""
    draw = random.Random(seed)
    decided = [cell for cell in cells.leaves if cell.verdict is not Merging.UNDECIDED]
    found = []
    for cell in draw.choices(decided, k=points):
        ratio, excess = (
            low + (high - low) * draw.choice((0, 1, Fraction(draw.randrange(10**6), 10**6))) for low, high in cell.sides
        )
        if fate(ratio, excess) is not cell.verdict:
            found.append(cell)
    return found


@pytest.fixture(scope="module")
def chart():
    return merging_cells(6)


def test_cells_agree_with_single_runs(chart):
    assert contradictions(chart) == []
    assert {cell.verdict for cell in chart.leaves} == set(Merging)


def test_the_cells_cover_the_window(chart):
    assert sum(cell.share for cell in chart.leaves) == 1
    sides = {side for cell in chart.leaves for side in cell.sides[0]}
    assert min(sides) * 125 == max(sides) == 100
    assert chart.shares()[Merging.UNDECIDED] < 0.284


def test_up_to_the_critical_share_everything_creeps(monkeypatch):
    threshold = CRITICAL_SHARE / (1 - CRITICAL_SHARE)
    below = Fraction(1, 10), threshold
    assert {cell.verdict for cell in merging_cells(1, below).leaves} == {Merging.CREEPS}
    monkeypatch.setattr(merging_cell, "CRITICAL_SHARE", Fraction(0))  # the same without the theorem, cell by cell
    computed = merging_cells(5, below).shares()
    assert computed[Merging.MERGES] == 0
    assert computed[Merging.CREEPS] > 0.6


def test_the_critical_share_is_rounded_down():
    """r* = 1/(2 sin^2 phi) at the root of phi - sin phi cos phi = sqrt(2) (sin phi - phi cos phi), by mpmath."""
    with mpmath.workdps(30):
        phi = mpmath.findroot(
            lambda x: x - mpmath.sin(x) * mpmath.cos(x) - mpmath.sqrt(2) * (mpmath.sin(x) - x * mpmath.cos(x)), 1.9
        )
        room = 1 / (2 * mpmath.sin(phi) ** 2) - mpmath.mpf(CRITICAL_SHARE.numerator) / CRITICAL_SHARE.denominator
        assert 0 < room < mpmath.mpf(10) ** -15


def test_the_level_below_which_everything_creeps_falls_with_the_share():
    with Ball(20).context():
        assert creeping_excess(arb(1)).overlaps((arb.pi() / 2 - 1) ** 2)
        levels = [creeping_excess(arb(n) / 100) for n in range(51, 101)]
        assert all(low < high for high, low in pairwise(levels))


# next to the edge


def rise(theta):
    return theta / (1 - mpmath.cos(theta)) - mpmath.cot(theta / 2)


def depth(theta):
    return 2 - theta * mpmath.cot(theta / 2)


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
        return verdict(((ratio, ratio), (level * (1 + low), level * (1 + high))))

    assert found(-width, width) is Merging.UNDECIDED
    assert found(-3 * width, -width) is Merging.CREEPS
    assert found(width, 3 * width) is Merging.MERGES


# starts that are known by bounds only


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


@given(st.integers(51, 99), st.integers(1, 50), st.integers(5, 300), st.integers(50, 400))
def test_a_short_slip_loses_no_more_than_its_bound(share, reach, push, excess):
    """Slips from gaps up to `reach` with push < 0, by the excess of the ray that follows; before it is known to 1/100.

    @example of a weak test: what was known by bounds only before was always known exactly.
    """
    share, reach, push, excess = (n / 100 for n in (share, reach, -push, excess))
    with Ball(16).context():
        exactly = Fraction(share).limit_denominator(100)
        run = merging_cell._CellRun((exactly, exactly), (Fraction(1, 10),) * 2)
        before = run.w.constant(arb(excess)) + run.free * run.w.constant(arb(1) / 100)
        start = run._short_slip(arb(reach), arb(push), before)
        for gap, off in product((reach / 3, reach), (-0.01, 0.01)) if start else ():
            deep = depth(slip_angle(gap, push))
            assert holds(start[2].value, excess + off - share * deep * (deep + 2 * gap))


hundredths = st.integers(1, 300).map(lambda n: n / 100)
widths = st.sampled_from([0, 1e-3, 0.02, 0.1, 0.3])


@given(hundredths, hundredths, widths, widths)
def test_every_slip_of_a_ball_is_enclosed_or_none_is(gap, push, wider, faster):
    with Ball(16).context():
        found = enclosed_contact(*(arb(low).union(arb(low + by)) for low, by in ((gap, wider), (push, faster))))
        for d, u in product(*([low, low + by / 3, low + by] for low, by in ((gap, wider), (push, faster)))):
            theta = slip_angle(d, u)
            assert found is None or all(map(holds, found, (theta, depth(theta), 1 - mpmath.cos(theta))))


@given(st.integers(1, 89), st.sampled_from([0, 1e-3, 0.1]), hundredths, widths)
def test_the_excess_after_a_slip_from_a_ray_is_enclosed_in_a_cell_and_in_a_ball(share, more, excess, wider):
    share /= 100
    ends = [(share, share + more), (excess, excess + wider)]
    with Ball(16).context():
        run = merging_cell._CellRun(*(tuple(map(Fraction, pair)) for pair in ends))
        end = run._slip(run._on_ray(run.w * run.one_over_q))
        r, w = arb(share), arb(excess).union(arb(excess + wider))
        ball = ray_contact(w, arb(0), 1 - r, r, (1 - r).sqrt())[2]
        for r, w in product(*([low, (low + high) / 2, high] for low, high in ends)):
            deep = depth(slip_angle(0, mpmath.sqrt(w / (1 - r))))
            assert end is None or holds(end[2].value, w / (1 - r) - r * deep**2)
            assert r != share or holds(ball, w - r * (1 - r) * deep**2)


# a planted fault


def test_a_cell_of_which_only_the_middle_is_computed_is_seen(monkeypatch):
    def middle(sides):
        ratio, excess = (((5 * a + 4 * b) / 9, (4 * a + 5 * b) / 9) for a, b in sides)
        return verdict((ratio, excess))

    monkeypatch.setattr(merging_map, "verdict", middle)
    assert contradictions(merging_cells(5))
