"""A slip on a surface: against the pair on a line, against higher precision, at s = 0, and broken on purpose."""

import numpy as np
import pytest
from flint import arb
from hypothesis import example, given, settings
from strategies import plane_scenes

from numerics import Force, Pair, Piece, Scene, State, solve
from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided, NumericsError
from numerics.plane.candidate import InBalls
from numerics.plane.defect import Curve, defect, slip_defect
from numerics.plane.polynomial import midpoints, rise, scaled
from numerics.plane.reduced import reduced
from numerics.plane.run import Run
from numerics.plane.series import Point, slip_series
from numerics.plane.slip import own_clock
from numerics.plane.system import System
from numerics.plane.vector import Vector
from numerics.scene.file import load_scene
from numerics.scene.plane import PlanePair, PlaneScene


def test_an_oblique_line_is_the_pair_of_the_paper_digit_for_digit():
    along, force = (Pair(1, "0.8", 200, "0.5", 1), Force.sine(3, 5))
    line = solve(Scene(along, State("0.02", "0.15", 0, "-0.1"), "0.5", force=force), digits=24, arithmetic="ball")
    e = ("0.6", "0.8")
    scene = PlaneScene(
        PlanePair(1, "0.8", 200, "0.5", 1),
        "0.5",
        x1=["0.012", "0.016"],
        v1=["0.09", "0.12"],
        v2=["-0.06", "-0.08"],
        force=[c * force for c in e],
    )
    plane = solve(scene, digits=24)
    with Ball(40).context():
        assert len(plane.events) == len(line.events) > 1
        assert all(a.t.overlaps(b.t) for a, b in zip(plane.events, line.events, strict=True))
        for part, true in zip(plane.final_state, line.final_state, strict=True):
            for c, x in zip(e, part, strict=True):
                assert x.overlaps(arb(c) * true)


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
        assert all(x.overlaps(y / size) for x, y in zip(event.direction, event.load, strict=True))
        assert all(x.rad() < 1e-14 for x in event.direction)
        assert size < 0.5


def test_an_eccentric_ellipse_never_merges():
    found = solve(load_scene("plane-ellipse-creeps"))
    assert found.arithmetic.name == "float64"
    assert found.digits >= 8
    assert len(found.events) == 7


@given(plane_scenes())
@example(PlaneScene(PlanePair(1, 1, 80, "0.2"), 1, x1="0.01"))  # a load of 0 at the end of a slip
@example(  # late: the time has more bits than the state, and a slip's clock began at a rounded one
    PlaneScene(PlanePair(6, 1, 1, "0.5"), 40, x1=["-0.15", 21], v1=["0.43", 1], v2=["0.49", "-0.18"])
)
@settings(max_examples=3)
def test_what_a_bound_says_holds_at_more_digits(scene):
    try:
        low, high = solve(scene, arithmetic="float64"), solve(scene, digits=22)
    except NumericsError:
        return
    assert [(one.before, one.after) for one in low.events] == [(one.before, one.after) for one in high.events]
    with high.context():
        for one, two in zip(low.events, high.events, strict=True):
            assert all(x.overlaps(y) for x, y in zip(one.direction, two.direction, strict=True))
        for one, two in zip(low._points, high._points, strict=True):
            assert one[0].overlaps(two[0])
            assert all(x.overlaps(y) for p, q in zip(one[1], two[1], strict=True) for x, y in zip(p, q, strict=True))
            size = max(float(abs(x)) for p in two[1] for x in p) + 1e-9
            assert all(float(x.rad()) < 1e-7 * size for p in one[1] for x in p)


def slipping():
    """A system and a point of it where s != 0."""
    system = System(reduced(load_scene("plane-circle-merges")), 30)
    place, speed, slip = (
        Vector([arb("0.004"), arb(0)]),
        Vector([arb(0), arb("0.05")]),
        Vector([arb("0.01"), arb("0.02")]),
    )
    return system, Point(0, arb(0), *(part.each(arb.mid) for part in (place, speed, slip, place)))


def test_a_defect_sees_what_is_missing():
    """A slip with one wrong coefficient is no slip: its defect is as large as what was added."""
    system, at = slipping()
    with system.fine():
        h = arb("0.1").mid()
        series = slip_series(system, at, system.degree)
        for wrong in (0.0, 1e-12):
            series.v2[0][3] = series.v2[0][3] + wrong
            t = midpoints((scaled(series.size, h) * h).integral())
            q1, v2, s = (Vector(scaled(x, h) for x in part) for part in series[:3])
            curve = Curve(0, t, q1, v2, s, q1, s * (system.pieces[0].b_squared * h))
            norm = slip_defect(system, curve, s, t.derivative() * (1 / h))[0].norm
            assert (norm < 1e-25) if wrong == 0 else (norm > 1e-16)
        _, least = slip_defect(system, curve, s, t.derivative() * (arb("1.1") / h))  # a size that is none
        assert all(least**2 < (s * s @ system.pieces[0].b_squared)(arb(n) / 8) for n in range(9))
        off = Vector([arb(0), arb("1e-9")])  # what friction is off counts for both bodies
        assert not defect(system, curve, off).norm < system.norm(system.still, off / system.m1, off / system.m2)


@pytest.mark.parametrize("turned", [True, False])
def test_what_turns_a_slip_adds_up_by_squares_and_what_is_along_it_does_not(turned):
    """A step with a wrong s is as far from the right one as N says, or nearer, and not much nearer."""
    system, at = slipping()
    wrong, before = arb("1e-9"), arb("1e-6")
    with system.fine():
        h, end = arb("0.1").mid(), arb(1)
        slips = InBalls(system, at)
        right = own_clock(system, at, slips.drawn(h), h, arb(0))
        x, y = (part(arb("0.9")) for part in right.curve.s)
        way = Vector([-y, x] if turned else [x, y]) / system.length(right.curve.s.each(lambda p: p(end)))
        for row, one in zip(slips.s, way, strict=True):
            row[8] += one * wrong / h**8
        step, later = (own_clock(system, at, slips.drawn(h), h, norm) for norm in (arb(0), before))
        x = rise(right.curve.t, step.curve.t(end))
        true, here = ([p(z) for part in one.curve[2:5] for p in part] for one, z in ((right, x), (step, end)))
        off = [y - x for x, y in zip(true, here, strict=True)]
        q1, v2, s = (Vector(off[k : k + 2]) for k in (0, 2, 4))
        off = (system.a2 @ q1 @ q1 + system.m1 * (v2 + s) @ (v2 + s) + system.m2 * v2 @ v2).sqrt()
        assert right.norm < wrong * 1e-6
        assert off < step.norm < 4 * off
        # along the slip N grows as much whatever it was before; across it hardly
        grown = (later.norm - before) / step.norm
        assert grown < 0.3 if turned else grown > 0.6


def test_the_state_at_any_time_lies_between_the_events():
    found = solve(load_scene("plane-slip-turns"), digits=15)
    with found.context():
        for event in found.events:
            assert all(x.overlaps(y) for x, y in zip(found.sol(event.t), [z for p in event.y for z in p], strict=True))
    assert found.y.shape == (12, len(found.events) + 2)
    energy = [float(x) for x in solve(load_scene("plane-circle-merges"), digits=15).energy]
    assert np.all(np.diff(energy) < 1e-18)
    with pytest.raises(ValueError, match="outside"):
        found.sol(2)


@pytest.mark.parametrize(
    ("x1", "v1", "sticks"),
    [
        (("0.005", 0), (0, "0.05"), True),  # a circle
        (("0.003", "0.004"), ("-0.04", "0.03"), True),
        ((0, "0.003"), ("0.05", 0), True),  # an ellipse whose greater half axis is L
        (("0.003", "0.004"), (0, 0), True),  # a line
        (("0.003", "0.004"), ("-0.04", "0.0300000001"), False),
        (("0.0049", 0), ("0.03", "0.03"), False),  # inside the edge at t = 0, and with v/W
    ],
)
def test_ellipses_that_touch_the_edge_are_stuck_for_ever_and_larger_ones_slip(x1, v1, sticks):
    pair = PlanePair(1, 1, 200, "0.5")
    found = solve(PlaneScene(pair, 1, x1=x1, v1=v1, v2=v1), digits=10)
    assert (found.modes == ("stick",)) == sticks
    weaker = PlaneScene(pair, 1, x1=x1, v1=v1, v2=v1, friction=[("0.7", "0.499")])
    assert not sticks or solve(weaker, digits=10).modes[:2] == ("stick", "slip")


def test_an_ellipse_of_two_frequencies_on_the_edge_is_not_decided():
    with pytest.raises(EventUndecided, match="leave the friction set"):
        solve(PlaneScene(PlanePair(1, 1, [200, 50], "0.5"), 3, x1=["0.004", "0.012"]), digits=10)


@pytest.mark.parametrize(("v", "before"), [("0.05", "slip"), ("-0.05", "stick")])
def test_a_start_exactly_on_the_edge_leaves_it_the_way_the_load_goes(v, before):
    """Its first numbers are as good as all others: 20 digits at t = 0 need no more working digits than later on."""
    pair = PlanePair(1, 1, 200, "0.5")
    found = solve(PlaneScene(pair, "0.25", x1=["0.003", "0.004"], v1=[v, 0], v2=[v, 0]), digits=20)
    assert (found.modes[0], found.arithmetic.digits) == (before, 26)


def test_events_are_capped():
    run = Run(System(reduced(load_scene("plane-ellipse-creeps")), 20), 2, 10_000)
    run.follow()
    assert (len(run.events), run.reached) == (2, False)
