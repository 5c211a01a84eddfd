"""A box: axes that nothing couples are pairs of the paper, digit for digit; all of it has the events of one path."""

from fractions import Fraction

import flint
import pytest
from flint import arb
from hypothesis import example, given
from plane_paths import agree
from strategies import fewer, plane_scenes

from numerics import Force, Piece, solve
from numerics.errors import EventUndecided, NumericsError
from numerics.plane.solve import followed
from numerics.scene.plane import PlanePair, PlaneScene

LIMITS = {"max_events": 1000, "progress": None}


@given(plane_scenes(shape="box"))
@example(  # axes 0, 1 and axis 2 are parts; all at once they have bounds 10^10 times too large
    PlaneScene(
        PlanePair(1, 1, [[200, 50, 0], [50, 120, 0], [0, 0, 90]], ["0.5", "0.3", "0.2"], shape="box"),
        "0.5",
        x1=["0.02", 0, "0.01"],
        v1=["0.1", "-0.2", "0.05"],
        force=[Force(), Force.step("0.1", 1), Force.sine(1, 7)],
    )
)
@fewer(5)
def test_both_roads_agree_and_more_digits_stay_in_the_bounds(scene):
    try:
        found, high = followed(scene, 30, LIMITS), solve(scene, digits=30)
    except NumericsError:
        return
    with high.context():
        assert agree((found.events, found._points), (high.events, high._points))


def test_mirrored_axes_have_their_events_together():
    scene = PlaneScene(PlanePair(1, 1, 200, "0.5", shape="box"), 1, x1=["0.02", "-0.02"], v1=["0.1", "-0.1"])
    found = solve(scene, digits=15)
    assert {one.after for one in found.events} == {"+-", "00", "-+"}
    x, y = found.final_state.x1
    assert x.overlaps(-y)


def test_coupled_axes_with_one_event_time_are_not_decided():
    pair = PlanePair(1, 1, [[200, 60], [60, 200]], "0.5", shape="box")
    with pytest.raises(EventUndecided, match="which axis"):
        solve(PlaneScene(pair, 1, x1="0.02", v1="0.1"), digits=10)


@pytest.mark.parametrize("coupling", [0, 1])
@pytest.mark.parametrize("at", ["0.5", "1/3"])
def test_axes_that_one_jump_lets_go_slip_at_once_and_know_the_load_behind_it(at, coupling):
    """With couplings and without, and where no binary number is the time of the jump."""
    pair = PlanePair(1, 1, [[200, coupling], [coupling, 200]], "0.5", shape="box")
    first = solve(PlaneScene(pair, 1, force=[Force.step(at, 4), Force.step(at, 3)]), digits=12).events[0]
    assert (first.before, first.after, first.cause) == ("00", "++", "jump")
    assert [float(x) for x in first.load] == [2, 1.5]
    assert first.t.overlaps(arb(flint.fmpq(*Fraction(at).as_integer_ratio())))


@pytest.mark.parametrize(("v", "modes"), [("0.1", ["-0", "00"]), ("-0.1", ["00", "+0"])])
def test_a_coupled_axis_that_begins_exactly_on_the_edge_leaves_it_the_way_its_load_goes(v, modes):
    pair = PlanePair(1, 1, [[100, 1], [1, 100]], "0.5", shape="box")
    found = solve(PlaneScene(pair, "0.6", x1=["0.01", 0], v1=[v, 0], v2=[v, 0]), digits=15)
    assert [*found.modes[:2]] == modes


@pytest.mark.parametrize("off", [0, "1e-12"])
def test_axes_with_other_data_may_stop_at_one_time_that_is_known_exactly(off):
    """Body 1 rests, m2 v2' = -b: both slips end at 1 s = m2 v2/b, or one of them a little later."""
    pair = PlanePair([1, 1], [1, 2], [1, 2], [1, 3], shape="box")
    push = [Force([Piece(0, [-1])]), Force([Piece(0, [-3])])]
    found = solve(PlaneScene(pair, 3, v2=[1, Fraction("1.5") + Fraction(off)], force=push), digits=20)
    assert found.modes == (("--", "0-", "00") if off else ("--", "00"))
    assert found.events[0].t == 1


@pytest.mark.parametrize("order", [1, -1])
def test_an_event_that_is_in_part_due_to_a_jump_is_due_to_it(order):
    """One axis comes to rest at 1 s by itself, and the force on the other jumps then."""
    push = [Force([Piece(0, [-1])]), Force.step(1, 9)][::order]
    scene = PlaneScene(PlanePair(1, 1, 1, 1, shape="box"), "1.5", v2=[1, 0][::order], force=push)
    first = solve(scene).events[0]
    assert (first.t, first.before, first.after, first.cause) == (1, "-0"[::order], "0+"[::order], "jump")


def test_a_load_where_a_force_may_just_have_changed_is_that_before_and_that_behind():
    """Axis 0 stops at 1/3 s, no binary number, by itself; the force on axis 1 jumps then, which slips on."""
    pair = PlanePair([1, 1], [1, 1], [1, 2], [1, 3], shape="box")
    force = [Force([Piece(0, [-1])]), Force([Piece(0, [-3]), Piece("1/3", [5])])]
    first = solve(PlaneScene(pair, 1, v2=["1/3", 9], force=force), digits=20).events[0]
    assert (first.before, first.after, first.cause) == ("--", "0-", "guard")
    assert first.load[1].contains(-1.5)
    assert first.load[1].contains(2.5)


@pytest.mark.parametrize("off", ["1e-9", "1e-14", "1e-22"])
def test_coupled_axes_that_leave_the_edge_however_shortly_after_one_another_leave_one_by_one(off):
    """The load of axis 0 is off * 150 N inside and rises at 11.25 N/s, that of axis 1 off * 225 N and at 7.5 N/s."""
    pair, near, v = PlanePair(1, 1, [[200, 50], [50, 200]], "0.5", shape="box"), Fraction(off), ["0.1", "0.05"]
    x1 = [Fraction("0.004") - near, Fraction("0.004") - 2 * near]
    found = solve(PlaneScene(pair, "0.1", x1=x1, v1=v, v2=v))
    assert found.modes == ("00", "-0", "--")
    assert [float(one.t.mid()) / float(near) for one in found.events] == pytest.approx([40 / 3, 30], rel=1e-6)
    assert found.digits == 15
    with found.context():
        assert all(event.t.rad() < event.t * 1e-15 for event in found.events)
