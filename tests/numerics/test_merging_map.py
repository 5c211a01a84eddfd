"""The merging map: its cells against single runs, the edges of the set, and faults planted in it."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise
from math import acos, cos, pi, tan

import mpmath
import pytest
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.free import merging as merging_cell
from numerics.free import merging_map
from numerics.free.excursions import excursions
from numerics.free.frame import Frame
from numerics.free.merging import CRITICAL_SHARE, Rectangle, Verdict, creeping_excess, verdict
from numerics.free.merging_map import COLOURS, Window, merging_cells
from numerics.scene import Pair
from theory.excursion import h, half_tangent_form
from theory.return_map import depth, gap, half_cotangent, in_trigonometry
from theory.symbols import q, r

POINTS = 200
PROVED_TO_CREEP = 0.325  # below (pi/2 - 1)^2


def fate(ratio: Fraction, excess: Fraction) -> Verdict:
    """One start on S0, followed from ray to ray until it merges or is below the proved level of creeping."""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=1, m2=ratio, a2=1, b=1))
        for one in excursions(frame, arithmetic.number(excess)):
            if one.stick is None:
                return Verdict.MERGES
            if one.w_after / frame.q < PROVED_TO_CREEP:
                return Verdict.CREEPS
    raise AssertionError


def contradictions(cells, points=POINTS, seed=1):
    """Decided cells, small and large alike, that a run from one of their points contradicts; corners are points."""
    draw = random.Random(seed)
    decided = [cell for cell in cells.cells if cell.verdict is not Verdict.UNDECIDED]
    found = []
    for cell in draw.choices(decided, k=points):
        ratio, excess = (
            low + (high - low) * draw.choice((0, 1, Fraction(draw.randrange(10**6), 10**6)))
            for low, high in cell.rectangle
        )
        if fate(ratio, excess) is not cell.verdict:
            found.append(cell)
    return found


@pytest.fixture(scope="module")
def chart():
    return merging_cells(Window(), 6)


def test_cells_agree_with_single_runs(chart):
    assert contradictions(chart) == []
    assert {cell.verdict for cell in chart.cells} == set(Verdict)


def test_the_cells_cover_the_window(chart):
    assert sum(cell.share for cell in chart.leaves) == 1
    assert abs(sum(chart.shares().values()) - 1) < 1e-12
    grid = chart.raster()
    assert grid.shape == (64, 64)
    assert set(grid.ravel()) == set(range(len(COLOURS)))
    sides = {side for cell in chart.cells for side in cell.rectangle.ratio}
    assert (min(sides), max(sides)) == Window().ratio


def test_a_finer_map_contradicts_no_coarser_one(chart):
    coarse, fine = merging_cells(Window(), 5).raster().repeat(2, axis=0).repeat(2, axis=1), chart.raster()
    undecided = list(COLOURS).index(Verdict.UNDECIDED)
    assert (fine[coarse != undecided] == coarse[coarse != undecided]).all()
    assert chart.shares()[Verdict.UNDECIDED] < 0.3


@pytest.mark.parametrize("ratio", [Fraction(3, 2), Fraction(2), Fraction(10), Fraction(1000)])
def test_the_lower_edge_is_where_h_is_sqrt_r_times_c(ratio):
    """The least energy that merges: first root of h = sqrt(r) c by mpmath, a thousandth to either side of it."""
    share = float(ratio / (1 + ratio))
    theta = mpmath.findroot(
        lambda x: (x - mpmath.sin(x)) / (1 - mpmath.cos(x)) - mpmath.sqrt(share) * (2 - x * mpmath.cot(x / 2)),
        (1.5, 4.0 if ratio < 2 else 3.3),
        solver="anderson",
    )
    height = (theta - mpmath.sin(theta)) / (1 - mpmath.cos(theta))
    edge = Fraction(float(height**2 * (1 - share)))
    narrow = (ratio, ratio * Fraction(10**6 + 1, 10**6))
    assert verdict(Rectangle(narrow, (edge * Fraction(998, 1000), edge * Fraction(999, 1000)))) is Verdict.CREEPS
    assert verdict(Rectangle(narrow, (edge * Fraction(1001, 1000), edge * Fraction(1002, 1000)))) is Verdict.MERGES
    assert verdict(Rectangle(narrow, (edge * Fraction(999, 1000), edge * Fraction(1001, 1000)))) is Verdict.UNDECIDED


def test_up_to_the_critical_share_everything_creeps(monkeypatch):
    threshold = CRITICAL_SHARE / (1 - CRITICAL_SHARE)
    below = Window((Fraction(1, 10), threshold))
    assert {cell.verdict for cell in merging_cells(below, 1).cells} == {Verdict.CREEPS}
    monkeypatch.setattr(merging_cell, "CRITICAL_SHARE", Fraction(0))  # the same without the theorem, cell by cell
    computed = merging_cells(below, 5).shares()
    assert computed[Verdict.MERGES] == 0
    assert computed[Verdict.CREEPS] > 0.6


def test_the_critical_share_is_rounded_down():
    """r* = 1/(2 sin^2 phi) at the root of phi - sin phi cos phi = sqrt(2) (sin phi - phi cos phi), by mpmath."""
    with mpmath.workdps(30):
        phi = mpmath.findroot(
            lambda x: x - mpmath.sin(x) * mpmath.cos(x) - mpmath.sqrt(2) * (mpmath.sin(x) - x * mpmath.cos(x)), 1.9
        )
        room = 1 / (2 * mpmath.sin(phi) ** 2) - mpmath.mpf(CRITICAL_SHARE.numerator) / CRITICAL_SHARE.denominator
        assert 0 < room < mpmath.mpf(10) ** -15


def test_just_beyond_the_critical_share_something_merges():
    """By a millionth: around the least excess after a slip from a ray, at 1 - cos theta = 1/r beyond pi."""
    share = float(CRITICAL_SHARE) * (1 + 1e-6)
    theta = 2 * pi - acos(1 - 1 / share)
    height = theta / (1 - cos(theta)) - 1 / tan(theta / 2)
    ratio, excess = Fraction(share / (1 - share)), Fraction(height**2 * (1 - share))
    assert verdict(Rectangle((ratio, ratio), (excess, excess))) is Verdict.MERGES


def test_creeping_level_rests_on_an_identity():
    """y' = (q + k^2) d^2 + (k^2 + q - r) c d + h^2 - r c^2 after a slip from S; and the level at both its ends."""
    k = half_cotangent()
    c = in_trigonometry(depth())
    push = h() - gap * k
    after = 2 * gap + q * gap**2 + push**2 - r * c * (c + 2 * gap)
    claimed = (q + k**2) * gap**2 + (k**2 + q - r) * c * gap + h() ** 2 - r * c**2
    assert half_tangent_form((after - claimed).subs(q, 1 - r)) == 0
    with Ball(20).context():
        assert creeping_excess(arb(1)).overlaps((arb.pi() / 2 - 1) ** 2)
        assert creeping_excess(arb("0.5001")) < (arb.pi() / 2) ** 2
        levels = [creeping_excess(arb(n) / 100) for n in range(51, 101)]
        assert all(low < high for high, low in pairwise(levels))


# planted faults


def test_a_threshold_set_too_high_is_seen(monkeypatch):
    monkeypatch.setattr(merging_cell, "CRITICAL_SHARE", Fraction("0.62"))
    assert contradictions(merging_cells(Window((Fraction(13, 10), Fraction(3, 2))), 4))


def test_a_wrong_sign_in_the_return_map_is_seen(monkeypatch):
    right = merging_cell._CellRun._slip

    def gains(self, start):
        end = right(self, start)
        return end and end._replace(excess=start.excess * 2 - end.excess)

    monkeypatch.setattr(merging_cell._CellRun, "_slip", gains)
    monkeypatch.setattr(merging_cell, "MAX_SLIPS", 20)
    assert contradictions(merging_cells(Window((Fraction(2), Fraction(4)), (Fraction(11, 10), Fraction(3))), 4))


def test_a_cell_of_which_only_the_middle_is_computed_is_seen(monkeypatch):
    def middle(rectangle):
        return verdict(Rectangle(*(((5 * a + 4 * b) / 9, (4 * a + 5 * b) / 9) for a, b in rectangle)))

    monkeypatch.setattr(merging_map, "verdict", middle)
    assert contradictions(merging_cells(Window(), 5))
