"""The error bounds of binary64 under a force: true for every scene, not much too wide, and found out if too narrow."""

from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from forced.catalogue import ANSWER, itinerary, scene
from hypothesis import given
from reaching import LeftOut, reaching
from strategies import driven_scenes

from numerics import Force, Pair, Scene, State, solve
from numerics.arithmetic.float64 import Float64
from numerics.bounds import forced as bounds_under_force
from numerics.bounds.forced import Point, Spread, spreads
from numerics.errors import EventUndecided, OutOfRange
from numerics.run.forced import run_forced_scene
from numerics.trajectory.forced_accuracy import _start


@cache
def in_binary64(name):
    try:
        return solve(scene(name))
    except EventUndecided:
        return None


def rows(trajectory, name):
    """Yield (numbers, reference texts) of the events that are kept, and of the end."""
    for event in ANSWER[name]["events"]:
        found = trajectory.events[event["n"]]
        yield (found.t, *found.y), event["row"]
    yield (trajectory.end_time, *trajectory.final_state), ANSWER[name]["final"]


def alone(name):
    """A scene in binary64 as its own numbers have it, without the help of balls; None if it is refused."""
    try:
        return run_forced_scene(scene(name), Float64(), 10_000)
    except EventUndecided:
        return None


def excess(found, name):
    """The largest quotient of an error and its bound."""
    kept, bounds, worst = ANSWER[name]["events"], found.accuracy, Fraction(0)
    for index, (numbers, texts) in enumerate(rows(found, name)):
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
@pytest.mark.parametrize("name", sorted(ANSWER))
def test_binary64_is_within_its_own_bounds_or_refuses(name, way):
    found = way(name)
    if found is None:
        return
    assert itinerary(found) == ANSWER[name]["modes"]
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
