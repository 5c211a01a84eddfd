"""When the relative motion is in its ring for good: against dense samples and runs, also under a force."""

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from control_scenes import DAMPED, outside
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import decimals

from numerics import Force, InvalidScene, NotSettled, Pair, Piece, Scene, Sine, State, load_scene, ring_entry, solve
from numerics.arithmetic.ball import Ball
from numerics.control import ring as rings
from numerics.control.attraction import passage_at
from numerics.control.pictures import draw_ring


@pytest.mark.parametrize(
    ("name", "radius", "rate"),
    [
        ("velocities", "0.001", 1),
        ("velocities", "0.02", 1),
        ("velocities", "0.001", 20),
        ("start-with-speed", "0.005", 1),
        ("itinerary-that-merges", "0.001", 1),
        pytest.param("start-at-6mm", "1e-4", 10, marks=pytest.mark.long),
    ],
)
def test_the_entry_is_the_last_sample_outside(name, radius, rate):
    found = ring_entry(load_scene(name), radius, rate=rate)
    entry = float(found.entry)
    late = outside(found, 2 * entry)
    assert 0 < entry - late[-1] < 2.1 * entry / 4_000


@pytest.mark.parametrize("rate", ["20", pytest.param("1/20", marks=pytest.mark.long)])
def test_a_creeping_pair_is_inside_in_the_middle_of_every_slip_to_come(rate):
    """Its slips get shorter and shorter: both what they add to w and what they slide must be small beside the ring."""
    scene = load_scene("start-with-speed")
    found = ring_entry(scene, "0.001", rate=rate, digits=8)
    run = solve(replace(scene, until=Fraction(2 * float(found.entry) + 5)))
    middles = [float(one.t + two.t) / 2 for one, two in pairwise(run.events)]
    t = np.array([at for at in middles if at > float(found.entry)])
    y = run.sol(t)
    assert len(t) > 10
    assert np.hypot(y[0] - y[2] - float(found.centre), (y[1] - y[3]) / float(found.rate)).max() < 0.001


@given(decimals(-1, 1, 2), decimals(-1, 1, 2), st.integers(1, 3))
@settings(max_examples=6)
def test_a_damped_pair_is_inside_for_good_after_its_entry(a1, speed, power):
    scene = Scene(Pair(1, 2, 50, "0.5", a1), State(x1="0.01", v1=speed), 1)
    found = ring_entry(scene, Fraction(1, 10**power))
    late = outside(found, 2 * float(found.entry) + 1)
    assert not late.size or late[-1] <= float(found.entry)


def test_the_limit_of_a_creeping_pair_is_that_of_a_long_run():
    """Averages of an alternating sequence close in on its limit; the error bound must hold what they find."""
    scene = load_scene("velocities")
    found = ring_entry(scene, "0.001", digits=20)
    run = solve(Scene(scene.pair, scene.initial, 100))
    z = [event.y[0] - event.y[2] for event in run.events[-60::2]]
    for _ in range(8):
        z = [(a + b) / 2 for a, b in pairwise(z)]
    assert z[-1] == pytest.approx(float(found.centre), abs=1e-10)


def test_a_motion_that_never_leaves_the_ring_is_inside_from_the_start():
    scene = Scene(Pair(1, 1, 200, "0.5"), State(x1="0.001"), 1)
    found = ring_entry(scene, 1)
    assert found.entry.is_zero()
    assert "stuck" in found.why
    assert draw_ring(ring_entry(load_scene("velocities"), "0.02")).axes


@pytest.mark.parametrize("wrong", [{"radius": 0}, {"radius": "x"}, {"radius": 1, "rate": -1}])
def test_bad_rings_are_refused(wrong):
    with pytest.raises(InvalidScene):
        ring_entry(load_scene("velocities"), **wrong)


def test_the_command_prints_draws_and_refuses(tmp_path, run, output):
    assert "4.755641299" in output("ring", "velocities", "--radius", "0.001", "--plot", tmp_path / "ring.svg")
    assert (tmp_path / "ring.svg").stat().st_size > 10_000
    code, _, err = run("ring", "velocities", "--radius", -1)
    assert (code, "radius = -1" in err) == (2, True)


STUCK_AT_LAST = [Force.sine("0.2", 12), Force((Piece(0, ["0.4"]),)), Force.trapezoid(1, 0, 1, 0, 3)]


@pytest.mark.parametrize("force", STUCK_AT_LAST)
def test_the_ring_of_a_pair_that_sticks_at_last(force):
    found = ring_entry(Scene(DAMPED, State(v1=1), 5, force=force), "0.005")
    assert 0 < float(found.entry) - outside(found, 5, 5_001)[-1] < 0.0011
    assert draw_ring(found).axes


@pytest.mark.long
@pytest.mark.parametrize(("amplitude", "radius"), [("2", "0.02")])
def test_the_ring_around_a_periodic_motion(amplitude, radius):
    found = ring_entry(Scene(DAMPED, State(v1=1), 5, force=Force.sine(amplitude, 12)), radius, digits=12)
    entry = float(found.entry)
    t = np.linspace(entry - 0.1, entry + 0.4, 101)
    y, distances = solve(replace(found.scene, until=Fraction(8))).sol(t), []
    for k, at in enumerate(t):
        time = Ball.number(Fraction(at))
        x1, v1, x2, v2 = (float(one.mid()) for one in passage_at(found.orbit, time).state(time))
        distances.append(np.hypot(y[0, k] - y[2, k] - x1 + x2 - float(found.centre), y[1, k] - y[3, k] - v1 + v2))
    outside = np.array(distances) > float(radius)
    assert ring_entry(found.scene, radius, digits=5).centre.contains(found.centre)
    assert outside[:19].any()
    assert not outside[21:].any()


def test_the_ring_of_a_motion_that_slowly_closes_in_is_where_it_is_so_near_to_itself_many_periods_later():
    scene, per, periods = load_scene("forced-sine-stick-slip"), 2 * np.pi / 5, 79
    y = solve(replace(scene, until=Fraction(120))).sol
    entry = float(ring_entry(scene, "0.001", digits=12).entry)
    t = np.array([entry - 1e-6, entry + 1e-6, *np.linspace(entry + 0.01, entry + 15, 400)])
    apart = y(t) - y(t + periods * per)
    outside = np.hypot(apart[0] - apart[2], apart[1] - apart[3]) > 0.001
    assert outside[0]
    assert not outside[1:].any()


@pytest.mark.parametrize("force", [Force.step(0, "0.3"), Force((Piece(0, (), [Sine("0.3", 9)]), Piece(1, ["0.3"])))])
def test_a_pair_creeps_under_a_constant_force_as_without_one(force):
    found = ring_entry(Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), 5, force=force), "0.001")
    entry = float(found.entry)
    assert 0 < entry - outside(found, 1.2 * entry)[-1] < 1.3 * entry / 4000


def test_a_motion_that_may_never_settle_is_refused():
    scene = Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), 5, force=Force.sine("0.02", 7))
    with pytest.raises(NotSettled, match=r"not known to settle.*a larger radius does not help: the pair is not proved"):
        ring_entry(scene, "0.001")


def test_where_a_run_ends_too_early_a_later_horizon_helps_and_a_larger_ring_does_not(monkeypatch):
    monkeypatch.setattr(rings, "_FORCED", (1, 2_000))
    scene = Scene(Pair(10, 1, 1, 1, a1="0.01"), State(v1=20), 1, force=Force.step(0, "0.5"))
    for radius in ("0.1", 1000):
        with pytest.raises(NotSettled, match="a later horizon may help"):
            ring_entry(scene, radius)
    assert ring_entry(replace(scene, until=Fraction(3000)), "0.1").why == "the pair has stuck for ever"


def test_a_motion_that_is_not_proved_to_close_in_on_the_periodic_one_is_refused(monkeypatch):
    monkeypatch.setattr(rings, "periodic_settled", lambda *_: None)
    monkeypatch.setattr(rings, "_FORCED", (1, 2_000))
    with pytest.raises(NotSettled, match="closes in on the periodic motion; a larger radius may not help either"):
        ring_entry(Scene(DAMPED, State(v1=1), 1, force=Force.sine("0.5", 12)), "0.001")


def test_a_force_that_grows_has_no_ring():
    with pytest.raises(ValueError, match="grows"):
        ring_entry(Scene(DAMPED, State(), 1, force=Force((Piece(0, [0, 1]),))), 1)
