"""When a free pair sticks for good and when it rests: against the reference, scipy, and the known limits."""

import math
from fractions import Fraction

import pytest
from control_scenes import referred

from numerics import NotSettled, Pair, Scene, State, damping, load_scene, solve
from numerics.control import damping as dampers
from numerics.control.pictures import draw_damping

FIGURE = load_scene("velocities")
MOVING = FIGURE.replace(v2="0.1")
STUCK = Scene(Pair(1, 1, 1, 1), State(-4, 1, 0, 1), 1)


@pytest.fixture(autouse=True)
def few_dampers(monkeypatch):
    """The search takes seconds; those that test it have it whole."""
    for name in ("_PER_OCTAVE", "_OCTAVES", "_ZOOMS"):
        monkeypatch.setattr(dampers, name, 1)


def own(scene, tolerance="0.001"):
    return damping(scene, tolerance, digits=10).own


@pytest.mark.parametrize(
    "scene", [FIGURE.replace(a1=a1) for a1 in ("0.56", "0.63", "28.3", 1000)] + [MOVING.replace(a1=3)]
)
def test_both_times_are_those_of_the_independent_reference(scene):
    found = own(scene)
    run = referred(scene.replace(until=float(found.stuck) + 1))
    assert float(found.stuck) == pytest.approx(float(run.events[-1].t), rel=1e-9)
    assert run.events[-1].after == 0
    x1, v1, _, v2 = (float(one) for one in referred(scene.replace(until=float(found.rest))).state())
    assert 200 * x1**2 + v1**2 + v2**2 == pytest.approx(200 * 0.001**2, rel=1e-7)


@pytest.mark.parametrize(("a1", "slips"), [(0, True), (4, False), (7, True)])
def test_a_pair_that_starts_in_stick_may_slip_with_more_damping(a1, slips):
    assert (own(STUCK.replace(a1=a1)).stuck > 0) is slips


def changed(scene, changes):
    """A scene with other numbers, as `a1=5 x1=0.01`."""
    return scene.replace(**dict(one.split("=") for one in changes.split()))


LIMITS = """
v2=0.1            | 1e-6
v2=0.1 x1=-0.0005 | 1e-6
v2=-0.01 x1=0.001 | 1e-3
                  | 1e-6
x1=0.001          | 1e-6
v2=0.1 x1=-0.001  | 1e-3   as the root of 1/a1
"""


@pytest.mark.parametrize("row", LIMITS.strip().splitlines())
def test_heavy_dampers_tend_to_their_limits(row):
    changes, close = row.split("|")
    scene, off = changed(FIGURE, changes), float(close.split()[0])
    limits, heavy = damping(scene, "0.001", digits=6).heavy, own(scene.replace(a1="1e9"))
    assert [*map(float, heavy)] == pytest.approx([*map(float, limits)], abs=off)


def test_the_time_to_rest_under_a_heavy_damper_goes_with_it():
    found = damping(MOVING.replace(x1="0.01", a1="1e6"), "0.001", digits=6)
    assert not found.heavy.rest.is_finite()
    assert float(found.own.rest) / (1e6 / 200) == pytest.approx(math.log(10), rel=1e-4)


EXTREMES = """
                     | 0.001  | inf       | 4.3691554
                     | 0.0005 | inf       | inf         the half width of the sliding region: E tends to that of it
v1=0 x1=0.0004       | 0.0001 | 0         | inf
v1=0 x1=0.0004       | 0.0004 | 0         | 0
v1=0 x1=0.0005       | 0.0005 | 0         | 0
v1=0                 | 1e-30  | 0         | 0
a1=1e30              | 0.001  | 0         | 0
a1=5                 | 1e-40  | 0.9569008 | 68.447688
a1=3 x1=0.004 v1=0   | 0.0039999999999999999999999999999999999 | 0.8694036 | 2.1380899e-18
a1=5 until=1e-9      | 0.001  | 0.9569008 | 0.71862
a1=1 m2=1e6          | 0.001  | 2.3298057 | 2.0204716
"""


@pytest.mark.parametrize("row", EXTREMES.strip("\n").splitlines())
def test_extremes(row):
    """Numbers of the scene, the tolerance, and both times."""
    changes, tolerance, *times = row.split("|")
    found = own(changed(FIGURE, changes), tolerance.strip())
    expected = [float(one.split()[0]) for one in times]
    assert [float(one) for one in found] == pytest.approx(expected, rel=1e-6, abs=1e-20)


def test_a_pair_that_merges_with_its_critical_orbit_never_rests():
    scene = load_scene("itinerary-that-merges")
    assert [*map(float, own(scene, "0.0001"))] == pytest.approx([solve(scene).events[-1].t, math.inf], rel=1e-6)


@pytest.fixture(scope="module")
def searched():
    return damping(FIGURE.replace(v1=0, x1="0.0004"), "0.0001", digits=10)


def test_next_to_the_best_damper_rest_takes_longer(searched):
    found, scene = searched, searched.scene
    for factor in ("0.99", "1.01"):
        assert found.at_best.rest < own(scene.replace(a1=found.best * Fraction(factor)), "0.0001").rest
    assert found.at_best.rest < min(one.rest for _, one in found.sampled) + 1e-3
    assert draw_damping(found).axes[0].get_legend()


def test_what_was_tried_is_right_however_small_the_tolerance_is():
    """In float64 the tolerance was below its rounding: what was best was not."""
    for a1, tried in damping(FIGURE.replace(a1=20), "1e-20", digits=6).sampled:
        assert [*tried] == pytest.approx([*map(float, own(FIGURE.replace(a1=a1), "1e-20"))], rel=1e-5)


def test_too_many_slips_are_said(monkeypatch):
    monkeypatch.setattr(dampers, "_MOST_EVENTS", 20)
    with pytest.raises(NotSettled, match=r"after 20 events at t = .* a larger damper"):
        own(FIGURE.replace(a1="0.01"))


def test_the_command_prints_what_the_function_finds(output, record, tmp_path):
    asked = "damping", "start-at-6mm", "--tolerance", "0.0001"
    said, found = output(*asked, "--plot", tmp_path / "drawn.svg"), record(*asked)
    assert (found["own"], found["heavy"]["rest"]) == ({"stuck": "inf", "rest": "inf"}, "inf")
    assert f"dampers tried: a1 = {found['a1']} N s/m" in said
    assert f"at rest from {found['best']['rest']} s" in said
    assert (tmp_path / "drawn.svg").stat().st_size > 10_000
    assert "no damper" not in said


def test_where_no_damper_is_before_the_limit_none_is_best_and_it_is_said(output):
    found = damping(FIGURE.replace(a1=5), "0.001", digits=6)
    assert (found.best, found.at_best, float(found.heavy.rest)) == (None, None, 0)
    assert draw_damping(found).axes
    assert "a1 = infinity is as good as any" in output("damping", "at-rest", "--tolerance", 1)
