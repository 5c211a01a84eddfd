"""The merging map: its cells against single runs, its checkpoints, its roads, and faults planted in it."""

from __future__ import annotations

import json
import random
import sys
from fractions import Fraction
from itertools import pairwise
from math import acos, cos, pi, tan

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from numerics.__main__ import main
from numerics.arithmetic.ball import Ball
from numerics.errors import InvalidMap, MissingTool
from numerics.long_time.excursion_map import excursions
from numerics.merging import cell as merging_cell
from numerics.merging import map as merging_map
from numerics.merging.cell import CRITICAL_SHARE, Rectangle, Verdict, creeping_excess, verdict
from numerics.merging.centred_form import Cell
from numerics.merging.figure import COLOURS, raster
from numerics.merging.map import Window, merging_cells
from numerics.motion.frame import Frame
from numerics.quadtree import tree
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
    grid = raster(chart)
    assert grid.shape == (64, 64)
    assert set(grid.ravel()) == set(range(len(COLOURS)))
    sides = {side for cell in chart.cells for side in cell.rectangle.ratio}
    assert (min(sides), max(sides)) == Window().ratio


def test_a_finer_map_contradicts_no_coarser_one(chart):
    coarse, fine = raster(merging_cells(Window(), 5)).repeat(2, axis=0).repeat(2, axis=1), raster(chart)
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


# roads, checkpoints


def test_processes_change_nothing(chart):
    pytest.importorskip("joblib")
    assert merging_cells(Window(), 6, jobs=2) == chart


@pytest.mark.slow
def test_a_dask_cluster_changes_nothing():
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
    ) as cluster:
        found = merging_cells(Window(), 4, dask=cluster.scheduler_address)
    assert found == merging_cells(Window(), 4)


@pytest.mark.parametrize(("module", "road"), [("joblib", {"jobs": 2}), ("distributed", {"dask": "tcp://127.0.0.1:1"})])
def test_a_missing_package_is_named(monkeypatch, module, road):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(MissingTool, match=module):
        merging_cells(Window(), 4, **road)
    assert merging_cells(Window(), 1).cells


def test_a_run_goes_on_where_it_stopped(tmp_path, chart):
    file, counts = tmp_path / "cells.jsonl", []
    assert merging_cells(Window(), 6, resume=file) == chart
    lines = file.read_text().splitlines(keepends=True)
    assert len(lines) == 65
    file.write_text("".join(lines[:41]) + lines[41][:30])  # 40 blocks and a torn line
    assert merging_cells(Window(), 6, resume=file, progress=lambda *done: counts.append(done)) == chart
    assert counts == [(n, 64) for n in range(41, 65)]
    assert sorted(file.read_text().splitlines()) == sorted("".join(lines).splitlines())
    assert merging_cells(Window(), 6, resume=file, progress=lambda *_: pytest.fail("nothing is left to do")) == chart


def test_a_foreign_or_damaged_checkpoint_is_refused(tmp_path):
    file = tmp_path / "cells.jsonl"
    merging_cells(Window(), 4, resume=file)
    with pytest.raises(InvalidMap, match="another map"):
        merging_cells(Window(), 3, resume=file)
    lines = file.read_text().splitlines(keepends=True)
    uncut = next(k for k, line in enumerate(lines) if "+" in line)
    for damaged in ("{}\n", "nonsense\n", lines[uncut].replace("+", ""), lines[uncut].replace('"}', 'm"}')):
        file.write_text("".join([*lines[:uncut], damaged, *lines[uncut + 1 :]]))
        with pytest.raises(InvalidMap, match=r"damaged|finished part"):
            merging_cells(Window(), 4, resume=file)


def test_a_damaged_title_is_refused(tmp_path):
    file = tmp_path / "notes.txt"
    file.write_text("my notes\n")
    with pytest.raises(InvalidMap, match="damaged"):
        merging_cells(Window(), 1, resume=file)
    assert file.read_text() == "my notes\n"


@pytest.mark.parametrize(("ratio", "energy"), [((2, 1), (2, 3)), ((0, 1), (2, 3)), ((1, 2), (1, 2)), ((1, 2), (3, 3))])
def test_windows_that_are_none_are_refused(ratio, energy):
    with pytest.raises(InvalidMap, match="give A and B from"):
        Window(tuple(map(Fraction, ratio)), tuple(map(Fraction, energy)))


@pytest.mark.parametrize(("low", "high"), [("1.000001", "1.000001001"), ("1000000", "1001000.999"), ("1", "1000001")])
def test_a_refused_range_of_energies_is_told_in_terms_of_what_was_given(low, high):
    """The edges that the refusal names are the true ones: (B - 1)/(A - 1) >= 1.001 between 1.000001 and 1000001."""
    energy = (Fraction(low), Fraction(high))
    inside = Fraction("1.000001") <= energy[0] and energy[1] <= 1000001
    if inside and (energy[1] - 1) >= Fraction("1.001") * (energy[0] - 1):
        assert Window(energy=energy).rectangle.excess[0] > 0
        return
    with pytest.raises(InvalidMap, match=rf"E/E_cr: {low} to {high} is no range; give A and B from 1.000001 to"):
        Window(energy=energy)


# command line


def test_command_line(capsys, tmp_path):
    picture = tmp_path / "map.png"
    assert main(["map", "--depth", "4", "--ratio", "1", "8", "--out", str(picture), "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert (record["ratio"], record["energy"], record["depth"]) == (["1", "8"], ["101/100", "101"], 4)
    assert sum(record["shares"].values()) == pytest.approx(1)
    for low, high, least, most, name in record["cells"]:
        assert 1 <= Fraction(low) < Fraction(high) <= 8
        assert 1 < Fraction(least) < Fraction(most) <= 101
        assert name in {"merges", "creeps", "undecided"}
    assert main(["map", "--depth", "2"]) == 0
    assert "of the window" in capsys.readouterr().out


@pytest.mark.parametrize(
    "arguments",
    [["--depth", "40"], ["--ratio", "2", "1"], ["--energy", "x", "2"], ["--out", "map.txt"], ["--out", "no/m.png"]],
)
def test_command_line_refuses(capsys, arguments):
    assert main(["map", *arguments]) == 2
    assert capsys.readouterr().err.startswith("error: ")


def test_an_interrupted_command_says_how_to_go_on(monkeypatch, capsys, tmp_path):
    road = tree.run_tasks

    def interrupted(function, tasks, **roads):
        yield from road(function, tasks[:5], **roads)
        raise KeyboardInterrupt

    monkeypatch.setattr(tree, "run_tasks", interrupted)
    file = tmp_path / "cells.jsonl"
    assert main(["map", "--depth", "4", "--resume", str(file)]) == 130
    assert "goes on" in capsys.readouterr().err
    assert len(file.read_text().splitlines()) == 6
    assert main(["map", "--depth", "4"]) == 130
    assert "nothing was written" in capsys.readouterr().err


# centred forms

sides = st.tuples(st.integers(1, 1000), st.integers(1, 100)).map(lambda s: (Fraction(s[0], 100), Fraction(sum(s), 100)))
inside = st.fractions(0, 1, max_denominator=1000)


@given(sides, sides, inside, inside)
def test_a_centred_form_holds_every_value_and_no_more_than_twice_the_width(first, second, s, t):
    """For f = (x y - y) sqrt(x) + 3 x over a cell, and over one whose sides are a thousandth of their distance."""
    with Ball(20).context():
        x, y = (low + (high - low) * part for (low, high), part in ((first, s), (second, t)))
        ranges = _form(Cell(first, second))
        exact = _value(x, y)
        assert ranges.value.contains(exact) or ranges.value.overlaps(exact)
        small = _form(Cell((x, x * Fraction(1001, 1000)), (y, y * Fraction(1001, 1000)))).value
        corners = [_value(a, b) for a in (x, x * Fraction(1001, 1000)) for b in (y, y * Fraction(1001, 1000))]
        hull = corners[0].union(corners[1]).union(corners[2]).union(corners[3])
        assert small.rad() < 2 * hull.rad() + arb(10) ** -12


def _form(cell):
    x, y = cell.parameters
    return cell.tight((x * y - y) * x.sqrt() + x * 3)


def _value(x, y):
    a, b = (arb(fmpq(one.numerator, one.denominator)) for one in (x, y))
    return (a * b - b) * a.sqrt() + a * 3
