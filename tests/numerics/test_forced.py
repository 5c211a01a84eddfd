"""Scenes with a force in every arithmetic and seen from all sides: files, batches, causes, symmetries, extremes."""

import json
import pickle
from fractions import Fraction
from time import process_time

import numpy as np
import pytest
from flint import arb
from forced.catalogue import itinerary, scene
from hypothesis import given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import MODERATE, forces, frictions, pairs, states

from numerics import (
    Force,
    Friction,
    Law,
    Pair,
    Piece,
    Scene,
    State,
    solve,
    solve_many,
    solve_scenes,
)
from numerics.__main__ import main
from numerics.arithmetic.ball import precision
from numerics.arithmetic.float64 import Float64
from numerics.errors import EventUndecided, InvalidScene, OutOfRange
from numerics.linear.modes import Mode
from numerics.scene.file import load_scene, shipped_scenes
from numerics.scene.writing import scene_text
from numerics.trajectory.comparison import distance
from numerics.trajectory.run import run_scene as run_forced_scene

PAIR = Pair(1, 1, 200, "0.05")


@pytest.mark.parametrize("arithmetic", ["ball", "mpmath"])
def test_more_digits_than_a_float_has_decades_are_reached_at_once(arithmetic):
    """Beyond 308 digits what is rough is 0: it once ended Newton's method early, and no precision was enough."""
    few, many = (solve(scene("sine-stick-slip"), digits=n, arithmetic=arithmetic, max_digits=500) for n in (360, 400))
    with precision(2000):
        for one, two in zip(few.event_times, many.event_times, strict=True):
            texts = (run.arithmetic.text(t, 380) for run, t in ((few, one), (many, two)))
            assert abs(arb(next(texts)) - arb(next(texts))) < arb("1e-355")


@pytest.mark.parametrize(
    "name", ["sine-stick-slip", "damping-heavy", "tie-by-second-derivative-slips", "resonance-in-slip"]
)
def test_the_other_arithmetics_agree(name):
    balls = solve(scene(name), digits=30, arithmetic="ball")
    for arithmetic, digits, tolerance in (("mpmath", 25, 1e-20), ("double-double", None, 1e-20)):
        found = solve(scene(name), digits=digits, arithmetic=arithmetic)
        assert itinerary(found) == itinerary(balls)
        for one, two in zip(found.event_times, balls.event_times, strict=True):
            with balls.arithmetic.context():
                assert distance(one, two) < tolerance


@reaching
@given(pairs(MODERATE, damped=None), st.data())
@settings(max_examples=15)
def test_a_force_of_zero_is_no_force(pair, data):
    start = data.draw(states(pair))
    free = Scene(pair, start, 2)
    nothing = Scene(pair, start, 2, force=Force((Piece(0), Piece(1))))
    try:
        one, two = (
            solve(each, digits=15, arithmetic="ball", max_events=30, max_digits=100) for each in (free, nothing)
        )
    except (EventUndecided, OutOfRange):
        raise LeftOut from None
    assert itinerary(one) == itinerary(two)
    assert all(a.overlaps(b) for a, b in zip(one.event_times, two.event_times, strict=True))
    if one.reached and two.reached:
        assert all(a.overlaps(b) for a, b in zip(one.final_state, two.final_state, strict=True))


@reaching
@given(pairs(MODERATE, damped=None), forces(3), frictions(2), st.data())
@settings(max_examples=25)
def test_ledgers_close_and_opposite_scenes_are_opposite(pair, force, friction, data):
    at = data.draw(states(pair))
    until = Fraction(data.draw(st.integers(1, 4)), 2)
    given_scene = Scene(pair, at, until, force=force, friction=friction)
    opposite = Scene(pair, State(-at.x1, -at.v1, -at.x2, -at.v2), until, force=-force, friction=friction)
    try:
        one, two = (
            solve(each, digits=12, arithmetic="ball", max_events=15, max_digits=90) for each in (given_scene, opposite)
        )
    except (EventUndecided, OutOfRange):
        raise LeftOut from None
    assert [-sign for sign in one.signs] == two.signs
    assert all((a + b).contains(0) for a, b in zip(one.final_state, two.final_state, strict=True))
    if one.reached and (pair.a1 / pair.m1) ** 2 < 100 * pair.a2 / pair.m1:  # a stiff one takes many panels
        try:
            assert one.ledger.residual.contains(0)
        except OutOfRange:
            raise LeftOut from None


@pytest.mark.parametrize("name", ["many-causes", "damping-heavy", "resonance-in-slip", "sweep", "friction-by-pieces"])
def test_compiled_and_plain_python_give_the_same_answers(name, monkeypatch):
    pytest.importorskip("numba")
    compiled = run_forced_scene(scene(name), Float64(), 1000)
    monkeypatch.setattr("numerics.linear.engine.compiled", lambda function: function)
    plain = run_forced_scene(scene(name), Float64(), 1000)
    assert plain.modes == compiled.modes
    assert (abs(plain.event_times - compiled.event_times) <= plain.accuracy.t + compiled.accuracy.t).all()
    assert (abs(plain.event_states.T - compiled.event_states.T) <= plain.accuracy.y + compiled.accuracy.y).all()


@pytest.mark.parametrize("name", [name for name in shipped_scenes() if load_scene(name).is_forced])
def test_the_shipped_scenes_with_a_force(name):
    given_scene = load_scene(name)
    points, balls = solve(given_scene), solve(given_scene, digits=20, arithmetic="ball")
    assert itinerary(points) == itinerary(balls)
    assert len(points.events) >= 5
    if "entrained" in name:
        assert balls.status.name == "STUCK_FOR_EVER"
    if "non-stop" in name:
        assert "0" not in itinerary(balls)[-10:]
    if "resonance" in name:
        assert balls.final_energy > 10 * balls.arithmetic.number(given_scene.pair.critical_energy)


def test_a_scene_seen_from_all_sides():
    force = Force.sine("0.3", 7) + Force.step(1, "0.2") + Force.ramp(2, 3, "-0.4")
    moving = Scene(Pair(1, 1, 200, "0.05", "0.5"), State(v1="0.15"), 5, force=force)
    found = solve(moving)
    assert found.success
    assert abs(found.ledger.residual) < 1e-14
    assert found.ledger.work != 0
    assert np.allclose(found.sol(found.event_times), found.event_states, atol=1e-12)
    assert found.sol([0, 5]).shape == (4, 2)
    assert np.array_equal(found.but(t_eval=[0, 5]).y, found.sol([0, 5]))
    assert list(found.mode_at([0, 5])) == [Mode.SLIP_PLUS, found.final_mode]
    assert [len(one) for one in found.t_events] == [
        found.event_kinds.count(kind) for kind in type(found.event_kinds[0])
    ]
    assert pickle.loads(pickle.dumps(found)) == found
    assert "events" in repr(found)
    balls = solve(moving, digits=20, arithmetic="ball")
    assert pickle.loads(pickle.dumps(balls)) == balls
    with pytest.raises(ValueError, match="outside"):
        found.sol(6)
    limited = solve(moving, max_events=3)
    assert (len(limited.events), limited.success) == (3, False)


def test_nothing_but_the_law_keeps_a_pair_together():
    held = Scene(PAIR, State(), 2, Law.THREE_VALUED_SGN, Force.step(1, 10))
    assert itinerary(solve(held)) == "0"
    assert itinerary(solve(Scene(PAIR, State(), 2, force=Force.step(1, 10))))[:2] == "0+"


def test_friction_that_drops_lets_go_and_says_why():
    load = Force((Piece(0, (0, "0.1", 0, "5/3")),))  # x1 = 0.05 t^3/6, load 0.05 t
    found = solve(Scene(PAIR, State(), 1, force=load, friction=Friction((("0.5", "0.02"),))))
    assert [(str(event.t), event.cause) for event in found.events] == [("0.5", "jump")]


def test_causes_are_written(tmp_path, capsys):
    path = tmp_path / "scene.toml"
    path.write_text(scene_text(Scene(PAIR, State(), 2, force=Force.step(1, 10))), "utf-8")
    assert main(["solve", str(path), "--digits", "20", "--json"]) == 0
    events = json.loads(capsys.readouterr().out)["events"]
    assert events[0]["cause"] == "jump"
    assert {event["cause"] for event in events[1:]} == {"guard"}
    assert main(["solve", str(path), "--arithmetic", "float64", "--csv"]) == 0
    assert ",cause," in capsys.readouterr().out
    assert main(["solve", str(path)]) == 0


def test_what_is_free_only_says_so(tmp_path, capsys):
    path = tmp_path / "scene.toml"
    path.write_text(scene_text(Scene(PAIR, State(), 2, force=Force.step(1, 10))), "utf-8")
    assert main(["energy", str(path), "--at", "10"]) == 2
    assert "force" in capsys.readouterr().err


def test_batches_over_forces_are_the_single_answers():
    amplitudes = [Fraction(k, 20) for k in range(1, 9)]
    found = solve_many(
        1, 1, 200, 0.05, v1=[[0.0], [0.125]], until=3, force=[Force.sine(one, 5) for one in amplitudes], keep_events=2
    )
    assert found.y.shape == (4, 2, len(amplitudes))
    for row, speed in enumerate((0, Fraction(1, 8))):
        for column, amplitude in enumerate(amplitudes):
            one = Scene(Pair(1, 1, 200, Fraction(0.05)), State(v1=speed), 3, force=Force.sine(amplitude, 5))
            alone = solve(one)
            at = row, column
            assert found.events[at] == len(alone.events)
            assert found.success[at]
            assert np.allclose(found.y[:, row, column], alone.final_state, rtol=0, atol=1e-16)
            assert np.allclose(found.event_t[at][: len(alone.events)], alone.event_times[:2], rtol=1e-15, atol=0)


def test_free_and_forced_scenes_in_one_batch():
    free, forced = Scene(PAIR, State(v1="0.15"), 3), Scene(PAIR, State(), 3, force=Force.step(1, 1))
    tie = scene("touches-at-irrational-times")
    found = solve_scenes([free, forced, tie])
    assert found.events[:2].tolist() == [len(solve(free).events), len(solve(forced).events)]
    assert found.success.tolist() == [True, True, False]
    with pytest.raises(InvalidScene):
        solve_many(1, 1, 200, float("nan"), until=1, force=Force.step(0, 1))


def test_a_cap_on_events_ends_at_the_last_event():
    moving = Scene(PAIR, State(), 30, force=Force.sine("0.35", 50))
    points, balls = solve(moving, max_events=7), solve(moving, digits=15, arithmetic="ball", max_events=7)
    assert not points.success
    assert float(points.end_time) == pytest.approx(float(balls.end_time.mid()))
    assert points.final_state == pytest.approx([float(one.mid()) for one in balls.final_state], abs=1e-12)


def test_a_light_body_oscillates_a_thousand_times_in_one_slip():
    light = Scene(Pair("1e-6", 10, 600, "1e-3"), State(v2="0.01"), 3, force=Force.sine("1e-3", 2))
    balls, points = solve(light, digits=12, arithmetic="ball", max_events=12), solve(light, max_events=12)
    assert itinerary(balls) == itinerary(points)


def test_ten_million_radians_of_a_fast_sine_are_passed_by_their_amplitude():
    fast = Scene(Pair(1, 1, 1, 1), State(v1=1), 1, force=Force.sine(1, "1e7"))
    balls, points = solve(fast, digits=20, arithmetic="ball"), solve(fast)
    assert itinerary(balls) == itinerary(points) == "+0"
    assert len(balls.record.rows) == 2


@pytest.mark.long
def test_ten_thousand_periods_take_a_fraction_of_a_second():
    """All that a solve gives but the bounds, which are made when they are looked at: 40,000 events."""
    scene = Scene(Pair(1, 1, 200, "0.05", a1="0.5"), State(), 12566, force=Force.sine("0.35", 5))
    solve(scene, max_events=7000)  # numba comes
    began = process_time()
    found = solve(scene)
    assert len(found.event_times) == 40001
    assert process_time() - began < 1
    assert found.accuracy.t.max() < 1e-8


def test_what_begins_at_a_tie_of_high_order_may_end_soon():
    """With u = 2 b + c t^2/2 - d t^3/6 and a soft spring a slip begins at once and ends at 4 c/d, nearly."""
    force = Force((Piece(0, (2, 0, Fraction(1, 2), -10)),))
    for arithmetic in ("ball", "float64"):
        found = solve(Scene(Pair(1, 1, "1e-6", 1), State(), 1, force=force), arithmetic=arithmetic)
        assert itinerary(found) == "+0-"
        assert abs(float(found.event_times[0]) - 4 / 60) < 1e-7
