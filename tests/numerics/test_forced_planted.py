"""The bounds in N, with errors far above those of rounding planted at the start: true, or told to be in doubt.

A run is told how far its start may be off; every motion that begins so near has to keep within its bounds, event by
event, in the same modes, or the run has to be in doubt.
"""

import math
from fractions import Fraction
from unittest.mock import patch

import pytest
from forced.catalogue import itinerary
from hypothesis import given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import driven_scenes, scaled_speed

from numerics import Force, Pair, Piece, Scene, State
from numerics.arithmetic.float64 import Float64
from numerics.errors import EventUndecided, OutOfRange
from numerics.motion.forced_exact import exact_knots
from numerics.run import forced
from numerics.run.forced import run_forced_scene
from numerics.trajectory.forced_units import unit_of_time

PAIR, ZERO, CUBIC = Pair(1, 1, 200, "0.05"), Force((Piece(0),)), Force((Piece(0, (0, 0, 0, "1e-9")),))
EVENTS = 40
NAMES = ("late", "x1_error", "v1_error", "x2_error", "v2_error")


def first_knot(scene, pieces):
    """Numbers from the start on, where nothing is a tie: an exact start knows no errors."""
    knot = exact_knots(scene, pieces)[0]
    if knot.order or unit_of_time(scene) != 1:
        raise LeftOut
    return [knot._replace(quiet=knot.local)]


def run(scene, by=(0, 0, 0, 0)):
    """A run in binary64 that is told that x1, v1, x2 and v2 may be off by so much."""
    begun = forced._start

    def started(knot, pair, *arithmetic):
        start, (x1, v1, _, v2) = begun(knot, pair, *arithmetic), (abs(float(one)) for one in by)
        off = math.sqrt(pair.a2 * x1 * x1 + pair.m1 * v1 * v1 + pair.m2 * v2 * v2)
        return start._replace(norm=start.norm + off, place=start.place + abs(float(by[0] - by[2])))

    with patch.object(forced, "_start", started), patch.object(forced, "exact_knots", first_knot):
        return run_forced_scene(scene, Float64(), EVENTS)


def beside(scene, by):
    at = scene.initial
    moved = State(at.x1 + by[0], at.v1 + by[1], at.x2 + by[2], at.v2 + by[3])
    return Scene(scene.pair, moved, scene.until, scene.law, scene.force, scene.friction)


def quotients(scene, by):
    """Differences of two motions over the first one's bounds: of (t, x1, v1, x2, v2) at each event, and of the end."""
    one, two = run(scene, by), run(beside(scene, by))
    assert itinerary(one) == itinerary(two)
    found = []
    for index, (here, there) in enumerate(zip(one.events, two.events, strict=True)):
        bounds = [one.record.numbers(name, one.knots)[index] for name in NAMES]
        found.append(
            [off(a, b, bound) for a, b, bound in zip((here.t, *here.y), (there.t, *there.y), bounds, strict=True)]
        )
    ends = zip(one.final_state, two.final_state, (one.record.number(-1, name) for name in NAMES[1:]), strict=True)
    return found, [off(a, b, bound) for a, b, bound in ends]


def off(one, two, bound):
    return max(0.0, abs(one - two) - 1e-12 * (abs(one) + 1e-3)) / max(bound, 1e-300)


MOVING = Scene(
    Pair(1, 2, 200, "0.05", "0.5"), State(v1="0.3"), 6, force=Force.sine("0.6", 5) + Force.sine("0.3", "7.3")
)


@pytest.mark.parametrize("name", ["x1", "v1", "x2", "v2"])
@pytest.mark.parametrize("masses", [(1, 2), (2, "0.5")])
def test_planted_errors_stay_within_bounds_that_are_not_much_too_wide(masses, name):
    """For 0.7 s, in which nothing is damped away: by the times of events, and what is largest at the end."""
    by = [Fraction(one == name, 10**7) for one in ("x1", "v1", "x2", "v2")]
    short = Scene(Pair(*masses, 200, "0.05", "0.5"), MOVING.initial, Fraction(7, 10), force=MOVING.force)
    events, end = quotients(short, by)
    assert max(map(max, events)) < 1
    assert 0.1 < max(*events[0], *end) < 1


@st.composite
def planted_scenes(draw):
    """A scene and a motion beside it: both stick at the start, or slip to one side; up to a tenth of its own size."""
    scene = draw(driven_scenes())
    pair, at = scene.pair, scene.initial
    size = Fraction(1, 10 ** draw(st.integers(1, 7)))
    x = pair.half_width * size
    v = scaled_speed(pair, size)
    weights = st.integers(-3, 3)
    by = [draw(weights) * x / 3, draw(weights) * v / 3, draw(weights) * x / 3, draw(weights) * v / 3]
    if at.v1 == at.v2:
        by[3] = by[1]
    return scene, by


@reaching
@given(planted_scenes())
@settings(max_examples=50)
def test_whoever_begins_near_keeps_within_the_bounds_or_they_say_doubt(planted):
    scene, by = planted
    try:
        other = run(beside(scene, by))
        events, end = quotients(scene, by)
    except (EventUndecided, OutOfRange):
        raise LeftOut from None
    assert other
    assert max(map(max, events), default=0) <= 1
    assert max(end) <= 1


def slip(x1, v1, v2, until, pair=PAIR, force=ZERO):
    return Scene(pair, State(x1, v1, 0, v2), until, force=force)


FAMILIES = {
    # name: a motion by one number of its start, the errors that go with it, two numbers with other modes, a hair
    "a slip ends where it may reverse": (
        lambda p: slip(p, "-0.001", "-0.01", "0.04030123"),
        (1, 0, 0, 0),
        ("0.00068609", "0.00068615", "1e-8"),
    ),
    "a jump of u lets go": (
        lambda p: slip(p, 0, 0, "0.031", force=Force.step("0.03", "0.12")),
        (1, 0, 0, 0),
        ("-0.0004", "0.0004", "4e-7"),
    ),
    "a free load reaches b": (lambda p: slip(0, p, p, 1), (0, 1, 0, 1), ("0.004", "0.0063", "1e-6")),
    "a load reaches b": (lambda p: slip(0, p, p, "0.4", force=CUBIC), (0, 1, 0, 1), ("0.004", "0.0063", "1e-6")),
    "a slip's gap closes": (lambda p: slip("-0.00025", 1, p, "0.4"), (0, 0, 0, 1), ("-1.1", "-0.9", "1e-4")),
    "a gap closes in the last of four turns": (
        lambda p: slip("-0.000005", 1, p, "1.56", pair=Pair(1, 1, 200, "0.001")),
        (0, 0, 0, 1),
        ("-1.1", "-0.9", "1e-4"),
    ),
    "a slip ends before the run": (lambda p: slip(0, p, 0, "0.02"), (0, 1, 0, 0), ("0.001", "0.004", "2e-6")),
}


def edge(scene_at, low, high):
    """A number at which the itinerary changes, to 1/30,000 of what is between the two; or next to which it is open."""
    before = itinerary(run(scene_at(low)))
    for _ in range(15):
        middle = (low + high) / 2
        try:
            same = itinerary(run(scene_at(middle))) == before
        except EventUndecided:
            return middle
        low, high = (middle, high) if same else (low, middle)
    return low


@pytest.mark.parametrize("name", FAMILIES)
@pytest.mark.parametrize("side", [1, -1])
def test_what_planted_errors_could_turn_is_in_doubt(name, side):
    """A hair from the edge between two itineraries: with errors that reach past it nothing may be decided."""
    scene_at, errors, ends = FAMILIES[name]
    low, high, hair = map(Fraction, ends)
    at, hair = edge(scene_at, low, high), side * hair
    here = scene_at(at + hair)
    assert itinerary(run(here)) != itinerary(run(scene_at(at - hair)))
    with pytest.raises(EventUndecided):
        run(here, [one * hair * Fraction(6, 5) for one in errors])
    run(here, [one * hair / 10**6 for one in errors])


def near_a_touch(part):
    """The errors of a contact near a touch over their bounds, where body 2 may be faster by a part of what is left."""
    scene = slip("-0.0000005", 1, -1, "0.22", pair=Pair(1, "0.01", 200, "0.0001"))
    events, _ = quotients(scene, (0, 0, 0, -part * Fraction("0.002227")))
    assert itinerary(run(scene)) == "+-"
    return max(events[0])


def test_near_a_touch_the_time_of_a_contact_is_within_its_bound_or_in_doubt():
    """The guard's slope changes within the errors of its root, by a quarter where three fifths of the gap are open."""
    assert 0.75 < near_a_touch(Fraction(1, 20)) < 1
    for part in range(2, 20):
        with pytest.raises(EventUndecided):
            assert near_a_touch(Fraction(part, 20)) < 1
