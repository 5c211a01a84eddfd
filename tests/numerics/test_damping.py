"""When a free pair sticks for good and when it rests: against the reference, scipy, and the known limits."""

import math
from fractions import Fraction

import pytest
from control_scenes import referred

from numerics import NotSettled, Pair, Scene, State, damping, load_scene, solve
from numerics.control import damping as dampers
from numerics.control.pictures import draw_damping

FIGURE = load_scene("velocities")
UNEVEN = Scene(Pair(4, 1, 10, "0.3"), State(v1="0.9"), 1)
MOVING = FIGURE.replace(v2="0.1")
STUCK = Scene(Pair(1, 1, 1, 1), State(-4, 1, 0, 1), 1)


@pytest.fixture(autouse=True)
def few_dampers(monkeypatch):
    """The search takes seconds; those that test it have it whole."""
    monkeypatch.setattr(dampers, "_PER_OCTAVE", 1)
    monkeypatch.setattr(dampers, "_OCTAVES", 1)
    monkeypatch.setattr(dampers, "_ZOOMS", 1)


def own(scene, tolerance="0.001", **asked):
    return damping(scene, tolerance, digits=10, **asked).own


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


def test_more_damping_is_not_always_sooner():
    times = [float(own(FIGURE.replace(a1=a1)).stuck) for a1 in ("0.56", "0.63", "0.64", "1")]
    assert times[0] < times[1] > times[2] > times[3]
    assert [own(STUCK.replace(a1=a1)).stuck > 0 for a1 in (0, 4, 7)] == [True, False, True]


@pytest.mark.parametrize(("scene", "a1"), [(FIGURE, "0.0001"), (UNEVEN, "0.001")])
def test_a_light_damper_takes_a_time_like_the_root_of_its_inverse(scene, a1):
    """sqrt(a1) T tends to pi^(3/2)/3 sqrt(m1 M/(m2 Omega)), and what is left of T to a number."""
    pair = scene.pair
    rate = math.sqrt(pair.a2 / pair.mass)
    limit = math.pi**1.5 / 3 * math.sqrt(pair.m1 * pair.mass / pair.m2 / rate)
    lighter, light = (float(own(scene.replace(a1=one), "0.05").stuck) for one in (float(a1) / 4, float(a1)))
    assert (lighter - light) * math.sqrt(float(a1)) == pytest.approx(limit, rel=0.02)


def test_heavy_dampers_tend_to_their_limits():
    for scene, tolerance in ((MOVING, "0.001"), (MOVING.replace(x1="-0.0005"), "0.001"), (FIGURE, "0.001")):
        limits = damping(scene, tolerance, digits=6).heavy
        heavy = own(scene.replace(a1="1e9"), tolerance)
        assert [float(one) for one in heavy] == pytest.approx([float(one) for one in limits], abs=1e-6)
    found = damping(MOVING.replace(x1="0.01", a1="1e6"), "0.001", digits=6)
    assert not found.heavy.rest.is_finite()
    assert float(found.own.rest) / (1e6 / 200) == pytest.approx(math.log(10), rel=1e-4)


@pytest.mark.parametrize(
    ("scene", "tolerance", "stuck", "rest"),
    [
        (FIGURE, "0.001", math.inf, 4.3691554),
        (FIGURE, "0.0005", math.inf, math.inf),  # the half width of the sliding region: E tends to that of it
        (FIGURE.replace(v1=0, x1="0.0004"), "0.0001", 0, math.inf),
        (FIGURE.replace(v1=0, x1="0.0004"), "0.0004", 0, 0),
        (FIGURE.replace(v1=0, x1="0.0005"), "0.0005", 0, 0),
        (load_scene("at-rest"), "1e-30", 0, 0),
        (
            load_scene("itinerary-that-merges"),
            "0.0001",
            float(solve(load_scene("itinerary-that-merges")).events[-1].t),
            math.inf,
        ),
        (FIGURE.replace(a1="1e30"), "0.001", 0, 0),
        (FIGURE.replace(a1=5), "1e-40", 0.9569008, 68.447688),
        (FIGURE.replace(a1=5, until="1e-9"), "0.001", 0.9569008, 0.71862),
        (FIGURE.replace(m2="1e6", a1=1), "0.001", 2.3298057, 2.0204716),
    ],
)
def test_extremes(scene, tolerance, stuck, rest):
    assert [float(one) for one in own(scene, tolerance)] == pytest.approx([stuck, rest], rel=1e-6, abs=1e-20)


def test_next_to_the_best_damper_rest_takes_longer(monkeypatch):
    monkeypatch.undo()
    scene = FIGURE.replace(v1=0, x1="0.0004")
    found = damping(scene, "0.0001", digits=10)
    for factor in ("0.99", "1.01"):
        assert found.at_best.rest < own(scene.replace(a1=found.best * Fraction(factor)), "0.0001").rest
    assert found.at_best.rest < min(one.rest for _, one in found.sampled) + 1e-3
    assert draw_damping(found).axes[0].get_legend()


def test_where_heavier_dampers_are_better_without_end_none_is_best():
    found = damping(FIGURE.replace(a1=5), "0.001", digits=6)
    assert (found.best, found.at_best, float(found.heavy.rest)) == (None, None, 0)
    assert draw_damping(found).axes


def test_too_many_slips_are_said(monkeypatch):
    monkeypatch.setattr(dampers, "_MOST_EVENTS", 20)
    with pytest.raises(NotSettled, match=r"after 20 events at t = .* a larger damper"):
        own(FIGURE.replace(a1="0.01"))


def test_the_command_prints_what_the_function_finds(output, record, tmp_path):
    said = output("damping", "start-at-6mm", "--tolerance", "0.0001", "--plot", tmp_path / "drawn.svg")
    found = record("damping", "start-at-6mm", "--tolerance", "0.0001")
    assert (found["own"], found["heavy"]["rest"]) == ({"stuck": "inf", "rest": "inf"}, "inf")
    assert f"dampers tried: a1 = {found['a1']} N s/m" in said
    assert f"at rest from {found['best']['rest']} s" in said
    assert (tmp_path / "drawn.svg").stat().st_size > 10_000
    assert record("damping", "at-rest", "--tolerance", 1)["best"] is None
    said = output("damping", "at-rest", "--tolerance", 1)
    assert "the heavier, the better" in said
