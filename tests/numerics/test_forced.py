"""Scenes with a force against an independent reference (tests/forced), in every arithmetic, and seen from all sides."""

import json
import pickle
from fractions import Fraction
from functools import cache
from pathlib import Path
from time import process_time

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import MODERATE, driven_scenes, forces, frictions, pairs, states

from numerics import (
    Force,
    Friction,
    Law,
    Pair,
    Piece,
    Scene,
    Sine,
    State,
    solve,
    solve_many,
    solve_scenes,
)
from numerics.__main__ import main
from numerics.arithmetic.ball_words import precision
from numerics.arithmetic.float64 import Float64
from numerics.bounds import forced as bounds_under_force
from numerics.bounds.forced import Point, Spread, spreads
from numerics.errors import EventUndecided, InvalidScene, OutOfRange
from numerics.motion.forced_pieces import drive_of, pieces_of
from numerics.motion.modes import Mode
from numerics.run.forced import run_forced_scene
from numerics.scene.file import load_scene, shipped_scenes
from numerics.scene.writing import scene_text
from numerics.trajectory.comparison import distance
from numerics.trajectory.forced_accuracy import _start

FOLDER = Path(__file__).resolve().parent.parent / "forced"
ANSWERS = json.loads((FOLDER / "answers.json").read_text("utf-8"))
SLOW = {"four-thousand-events", "fast-ripple", "thousand-pieces"}
REFUSED_EXACTLY = {"touches-at-irrational-times"}
"""What no number that is known nearly can decide."""
SIGNS = {"stick": "0", "slip+": "+", "slip-": "-"}
PAIR = Pair(1, 1, 200, "0.05")


def scene(name):
    return load_scene(FOLDER / "scenes" / f"{name}.toml")


@cache
def in_binary64(name):
    try:
        return solve(scene(name))
    except EventUndecided:
        return None


def itinerary(trajectory):
    return "".join(SIGNS[mode.value] for mode in trajectory.modes)


def rows(trajectory, name):
    """Yield (numbers, reference texts, cause or None) of the events that are kept, and of the end."""
    for event in ANSWERS[name]["events"]:
        found = trajectory.events[event["n"]]
        yield (found.t, *found.y), event["row"], (found.cause, event["cause"])
    yield (trajectory.end_time, *trajectory.final_state), ANSWERS[name]["final"], None


@pytest.mark.parametrize("name", sorted(set(ANSWERS) - SLOW - REFUSED_EXACTLY))
def test_balls_hold_the_reference_to_its_last_digit(name):
    found = solve(scene(name), digits=40, arithmetic="ball", max_digits=300)
    assert itinerary(found) == ANSWERS[name]["modes"]
    with precision(260):
        for numbers, texts, cause in rows(found, name):
            assert cause is None or cause[1] in (cause[0], "both")
            for number, text in zip(numbers, texts, strict=True):
                assert number.overlaps(arb(text, abs(arb(text)) * arb("1e-58") + arb("1e-45")))


@pytest.mark.parametrize("arithmetic", ["ball", "mpmath"])
def test_more_digits_than_a_float_has_decades_are_reached_at_once(arithmetic):
    """Beyond 308 digits what is rough is 0: it once ended Newton's method early, and no precision was enough."""
    few, many = (solve(scene("sine-stick-slip"), digits=n, arithmetic=arithmetic, max_digits=500) for n in (360, 400))
    with precision(2000):
        for one, two in zip(few.event_times, many.event_times, strict=True):
            texts = (run.arithmetic.text(t, 380) for run, t in ((few, one), (many, two)))
            assert abs(arb(next(texts)) - arb(next(texts))) < arb("1e-355")


def alone(name):
    """A scene in binary64 as its own numbers have it, without the help of balls; None if it is refused."""
    try:
        return run_forced_scene(scene(name), Float64(), 10_000)
    except EventUndecided:
        return None


def excess(found, name):
    """The largest quotient of an error and its bound."""
    kept, bounds, worst = ANSWERS[name]["events"], found.accuracy, Fraction(0)
    for index, (numbers, texts, _) in enumerate(rows(found, name)):
        late = (
            [bounds.t[kept[index]["n"]], *bounds.y[kept[index]["n"]]]
            if index < len(kept)
            else [2e-16 * float(texts[0]), *bounds.final]
        )
        for number, text, error in zip(numbers, texts, late, strict=True):
            beyond = abs(Fraction(float(number)) - Fraction(text)) - Fraction(1, 10**25)
            worst = max(worst, beyond / max(Fraction(float(error)), Fraction(1, 10**40)))
    return worst


@pytest.mark.parametrize("way", [in_binary64, alone])
@pytest.mark.parametrize("name", sorted(ANSWERS))
def test_binary64_is_within_its_own_bounds_or_refuses(name, way):
    found = way(name)
    if found is None:
        return
    assert itinerary(found) == ANSWERS[name]["modes"]
    assert excess(found, name) <= 1


@pytest.mark.parametrize(
    "name", ["four-thousand-events", "damping-heavy", "mass-ratio-1e6", "jump-at-contact-reverses"]
)
def test_bounds_a_thousandth_as_wide_are_found_out(name):
    assert excess(alone(name), name) > Fraction(1, 1000)


@pytest.mark.parametrize("name", ["mass-ratio-1e-6", "light-body-2", "damping-heavy", "four-thousand-events"])
def test_components_are_told_from_the_norm(name):
    """@example of a found fault: N says of a light body's velocity, and of x2 after many events, nearly nothing."""
    found = alone(name)
    state, number = abs(np.array(found.final_state)), found.record.number
    by_norm = np.array([number(-1, f"{one}_error") for one in ("x1", "v1", "x2", "v2")])
    assert (found.accuracy.final <= by_norm + 1e-15 * state).all()
    assert max(by_norm / found.accuracy.final) > 30


MOVING = Scene(
    Pair(1, 2, 200, "0.05", "0.5"), State(v1="0.3"), 6, force=Force.sine("0.6", 5) + Force.sine("0.3", "7.3")
)


def planted(spreads, name, by):
    """The largest quotient of a difference of two motions and its bound: one starts beside the other by so much."""
    at = {one: getattr(MOVING.initial, one) + (by if one == name else 0) for one in ("x1", "v1", "x2", "v2")}
    one = run_forced_scene(MOVING, Float64(), 1000)
    two = run_forced_scene(Scene(MOVING.pair, State(**at), MOVING.until, force=MOVING.force), Float64(), 1000)
    assert itinerary(one) == itinerary(two)
    assert {event.kind.name for event in one.events} == {"ENTRY", "EXIT", "CROSSING"}
    points = [Point(_start(row), row[1] == 1.0, row[2] == 1.0, np.inf) for row in one.record.rows]
    begun = Spread(np.ones(4), np.where(np.array(["x1", "v1", "v2", "x2"]) == name, float(by), 1e-16))
    found, last = spreads(*one.tables, points, _start(one.record.end_row), begun)
    numbers = [(event.t, *event.y) for event in one.events], [(event.t, *event.y) for event in two.events]
    ratios = abs(np.subtract(*numbers)) / found[one.knots]
    return max(ratios.max(), *(abs(np.subtract(one.final_state, two.final_state)) / last))


@pytest.mark.parametrize("name", ["x1", "v1", "x2", "v2"])
def test_errors_are_carried_through_every_kind_of_event(name):
    """Planted errors a million times those of rounding stay within their bounds, which are not much too wide."""
    assert 0.2 < planted(spreads, name, Fraction(1, 10**9)) < 1


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("rows[_V2, _V1:_X2] = share * (1.0 - kept), ", "rows[_V2, _V1:_X2] = 0.5 * share * (1.0 - kept), "),
        ("share + (1.0 - share) * kept, (1.0 - share)", "share + (1.0 - share) * kept, 0.5 * (1.0 - share)"),
        ("kept = new / old if at.mode else 0.0", "kept = 0.0"),
        ("[0.0, 0.0, tau, 1.0]", "[0.0, 0.0, 0.0, 1.0]"),
        ("[one[0] - 1.0, two[0], 0.0, 1.0]", "[0.0, 0.0, 0.0, 1.0]"),
        ("[one[1], two[1], 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]", "[one[1], -two[1], 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]"),
        ("late = min(point.late, 1.25 * off / slope)", "late = 0.5 * off / slope"),
        ("late = min(point.late, 1.25 * (spread.width", "late = min(point.late, 0.5 * (spread.width"),
    ],
)
def test_errors_that_are_lost_on_the_way_are_found_out(old, new):
    source = Path(bounds_under_force.__file__).read_text("utf-8")
    assert source.count(old) == 1
    wrong = {"__name__": bounds_under_force.__name__}
    exec(compile(source.replace(old, new), "wrong", "exec"), wrong)
    names = ("x1", "v1", "x2", "v2")
    assert any(planted(wrong["spreads"], name, Fraction(1, 10**9)) > 1 for name in names)


def test_forgotten_roundings_are_found_out(monkeypatch):
    monkeypatch.setattr(bounds_under_force.Spread, "carried", forgetful)
    assert max(excess(alone(name), name) for name in ("damping-heavy", "sine-stick-slip", "sweep")) > 1


def forgetful(spread, matrix, local):
    spread.mapped(matrix, 1e-6 * local)


@reaching
@given(driven_scenes())
def test_the_errors_of_any_scene_are_within_their_bounds(given_scene):
    try:
        found = run_forced_scene(given_scene, Float64(), 1000)
        balls = solve(given_scene, digits=25, arithmetic="ball", max_digits=200)
    except (EventUndecided, OutOfRange):
        raise LeftOut from None
    bounds = found.accuracy
    assert itinerary(found) == itinerary(balls)
    with balls.arithmetic.context():
        for one, two, late, errors in zip(found.events, balls.events, bounds.t, bounds.y, strict=True):
            assert abs(two.t - one.t) <= late + 1e-25
            assert all(abs(b - a) <= off + 1e-25 for a, b, off in zip(one.y, two.y, errors, strict=True))
        ends = zip(found.final_state, balls.final_state, bounds.final, strict=True)
        assert all(abs(b - a) <= off + 1e-25 for a, b, off in ends)


def test_binary64_refuses_only_what_no_digits_decide():
    assert {name for name in ANSWERS if in_binary64(name) is None} == REFUSED_EXACTLY


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
def test_compiled_code_gives_the_same_bits(name, monkeypatch):
    pytest.importorskip("numba")
    plain = run_forced_scene(scene(name), Float64(), 1000)
    monkeypatch.setattr("numerics.run.forced._FEW", 1)
    compiled = run_forced_scene(scene(name), Float64(), 1000)
    assert np.array_equal(plain.record.rows, compiled.record.rows)


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


@pytest.mark.parametrize("polynomial", [(), ("0.3",), ("0.3", "-0.01", "0.002")])
def test_parts_of_a_piece_are_the_whole_piece(polynomial):
    """Where seams cut, what each part says of start, phase and polynomial is that of the exact piece, narrowed once."""
    sines = [Sine("0.2", "7.3", "0.4"), Sine("0.1", "11/3", "-100")]
    scene = Scene(Pair(1, 2, 200, "0.05"), State(), 200, force=Force([Piece("0.1", polynomial, sines)]))
    pieces = pieces_of(scene, with_seams=True)
    drive, starts = drive_of(scene, pieces, Float64()), pieces.float_starts()
    whole = pieces.wholes[1]
    assert len(pieces) == len(drive.places) == len(starts) > 100
    assert sum(one.length for one in pieces) == 200
    assert pieces[-1] == pieces[len(pieces) - 1] == pieces[-2:][1]
    with pytest.raises(IndexError):
        pieces[len(pieces)]
    turn = 2 * Fraction(314159265358979323846264338327950288419716939937510582097494, 10**59)
    for k, (piece, (first, count, number, is_jump), before) in enumerate(
        zip(pieces, drive.places, pieces[:1] + pieces[:], strict=False)
    ):
        assert piece.start == (before.start + before.length if k else 0)
        assert (count, number, is_jump) == (len(piece.polynomial), len(piece.sines), int(k < 2))
        assert drive.numbers[first : first + 3] == [float(piece.start), float(piece.length), 0.05]
        assert starts[k] == float(piece.start)
        at = first + 3 + 3 * count
        for sine, phase in zip(piece.sines, drive.numbers[at + 2 :: 7], strict=False):
            off = (sine.omega * piece.start + sine.phase - Fraction(phase)) / turn
            assert abs(off - round(off)) * turn <= 2.0**-53 * max(abs(phase), 1e-9)
        assert [float(c) for c in piece.polynomial] == drive.numbers[first + 3 : first + 3 + count]
        time = piece.start - whole.start
        if k and polynomial:
            assert piece.polynomial[0] == sum(Fraction(c) * time**n for n, c in enumerate(polynomial))


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
