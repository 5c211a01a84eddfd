"""A slip on a surface: against the pair on a line, against higher precision, at s = 0, and broken on purpose."""

from itertools import chain

import numpy as np
import pytest
from flint import arb
from hypothesis import example, given
from plane_paths import agree, overlap, path_of
from strategies import fewer, plane_scenes

from numerics import Force, Pair, Piece, Scene, State, solve
from numerics.arithmetic.ball import Ball
from numerics.errors import NumericsError
from numerics.plane.defect import defect, slip_defect
from numerics.plane.series import Expansion, Point
from numerics.plane.vector import Vector
from numerics.scene.file import load_scene
from numerics.scene.plane import PlanePair, PlaneScene


@pytest.mark.parametrize("later", [0, 1])
def test_an_oblique_line_is_the_pair_of_the_paper_digit_for_digit(later):
    """Also up to where a force on one axis leads away from it: a slip gets exactly to rest before that."""
    along, force = (Pair(1, "0.8", 200, "0.5", 1), Force.sine(3, 5))
    line = solve(Scene(along, State("0.02", "0.15", 0, "-0.1"), "0.5", force=force), digits=24, arithmetic="ball")
    e = ("0.6", "0.8")
    scene = PlaneScene(
        PlanePair(1, "0.8", 200, "0.5", 1),
        "0.6",
        x1=["0.012", "0.016"],
        v1=["0.09", "0.12"],
        v2=["-0.06", "-0.08"],
        force=[c * force + k * Force.step("0.5", later) for k, c in enumerate(e)],
    )
    plane = solve(scene, digits=24)
    with Ball(40).context():
        assert len(line.events) > 1
        assert overlap(plane.event_times[: len(line.events)], line.event_times)
        assert overlap(plane.sol("0.5"), [arb(c) * true for true in line.final_state for c in e])
        x, y = plane.final_state.x1
        assert (3 * y - 4 * x).contains(0) == (not later)


def test_a_slip_passes_through_rest_where_an_ellipse_draws_it_there():
    """b_x^2 kap > b_y kap (b_y + |Lam|): an open set of slips meets v1 = v2 and leaves at once; a round one turns."""
    push = [Force(), Force((Piece(0, ["0.6"]),))]
    for b, kinds in ((["0.5", "0.2"], [("slip", "slip")]), ("0.2", [])):
        pair = PlanePair(2, 2, "0.001", b)
        found = solve(PlaneScene(pair, 1, v1=["0.02", "-0.2"], force=push), digits=20)
        assert [(one.before, one.after) for one in found.events] == kinds


def test_a_near_reversal_turns_and_an_exact_one_passes():
    pair, push = PlanePair(1, 1, "0.5", "0.5"), [Force((Piece(0, [2]),))]
    near = solve(PlaneScene(pair, "0.3", v1=["-0.3", "1e-11"], force=push), digits=20)
    exact = solve(PlaneScene(pair, "0.3", v1=["-0.3", 0], force=push), digits=20)
    assert (near.events, [one.after for one in exact.events]) == ((), ["slip"])
    assert abs(near.final_state.v2[0] - exact.final_state.v2[0]) < 1e-9


def test_a_slip_ends_along_the_load_of_a_round_pair():
    (event,) = solve(load_scene("plane-circle-merges"), digits=15).events
    with Ball(30).context():
        size = sum((x * x for x in event.load), arb(0)).sqrt()
        assert overlap(event.direction, [y / size for y in event.load])
        assert all(x.rad() < 1e-14 for x in event.direction)
        assert size < 0.5


@given(plane_scenes())
@example(PlaneScene(PlanePair(1, 1, 80, "0.2"), 1, x1="0.01"))  # a load of 0 at the end of a slip
@example(  # late: the time has more bits than the state, and a slip's clock began at a rounded one
    PlaneScene(PlanePair(6, 1, 1, "0.5"), 40, x1=["-0.15", 21], v1=["0.43", 1], v2=["0.49", "-0.18"])
)
@fewer(5)
def test_what_a_bound_says_holds_at_more_digits(scene):
    try:
        low, high = solve(scene), solve(scene, digits=22)
    except NumericsError:
        return
    with high.context():
        assert agree((low.events, low._points), (high.events, high._points))
    assert low.digits == 15


def test_a_defect_sees_what_friction_lacks():
    """What friction is off counts for both bodies, and a size that is none of the slip bounds no size."""
    system = path_of(load_scene("plane-circle-merges"), 30).system
    place, speed, s = (Vector(map(arb, one)) for one in (("0.004", 0), (0, "0.05"), ("0.01", "0.02")))
    lacking = Vector([arb(0), arb("1e-9")])
    with system.fine():
        at, h = Point(0, arb(0), *(part.each(arb.mid) for part in (place, speed, s, place))), arb("0.1").mid()
        step, added = Expansion(system, at).drawn(h), (lacking / m for m in (system.m1, system.m2))
        assert not defect(system, step, lacking).norm < system.norm(system.still, *added)
        slip, rate = step.curve.s, step.curve.t.derivative()
        _, least = slip_defect(system, step, slip, rate * (arb("1.1") / h))
        squares = slip * slip @ system.pieces[0].b_squared
        assert all(least**2 < squares(arb(n) / 8) for n in range(9))


def test_the_state_at_any_time_lies_between_the_events():
    found = solve(load_scene("plane-slip-turns"), digits=15)
    with found.context():
        assert all(overlap(found.sol(event.t), [*chain(*event.y)]) for event in found.events)
    assert found.y.shape == (12, len(found.events) + 2)
    energy = [float(x) for x in solve(load_scene("plane-circle-merges"), digits=15).energy]
    assert np.all(np.diff(energy) < 1e-18)


BY_THE_EDGE = """
0.005 0     |  0     0.05         | sticks   a circle
0.003 0.004 | -0.04  0.03         | sticks
0     0.003 |  0.05  0            | sticks   an ellipse whose greater half axis is L
0.003 0.004 |  0     0            | sticks   a line
0.003 0.004 | -0.04  0.0300000001 | slips
0.0049 0    |  0.03  0.03         | slips    inside the edge at t = 0, and with v/W
"""


@pytest.mark.parametrize("row", BY_THE_EDGE.strip().splitlines())
def test_ellipses_that_touch_the_edge_are_stuck_for_ever_and_larger_ones_slip(row):
    x1, v1, (then, *_) = map(str.split, row.split("|"))
    scene = PlaneScene(PlanePair(1, 1, 200, "0.5"), 1, x1=x1, v1=v1, v2=v1)
    assert (solve(scene, digits=10).modes == ("stick",)) == (then == "sticks")
    weaker = scene.replace(friction=[("0.7", "0.499")])
    assert then == "slips" or solve(weaker, digits=10).modes[:2] == ("stick", "slip")


@pytest.mark.parametrize(("v", "before"), [("0.05", "slip"), ("-0.05", "stick")])
def test_a_start_exactly_on_the_edge_leaves_it_the_way_the_load_goes(v, before):
    """Its first numbers are as good as all others: 20 digits at t = 0 need no more working digits than later on."""
    pair = PlanePair(1, 1, 200, "0.5")
    found = solve(PlaneScene(pair, "0.25", x1=["0.003", "0.004"], v1=[v, 0], v2=[v, 0]), digits=20)
    assert (found.modes[0], found.arithmetic.digits) == (before, 26)
