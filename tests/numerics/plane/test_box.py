"""A box: axes that nothing couples are pairs of the paper, digit for digit; all of it has the events of one path."""

from fractions import Fraction

import pytest
from hypothesis import example, given
from plane_paths import agree
from scene_files import scenes_in
from strategies import fewer, plane_scenes

from numerics import solve
from numerics.arithmetic.ball import Ball
from numerics.errors import NumericsError
from numerics.plane.solve import followed
from numerics.scene.plane import PlanePair, PlaneScene

SURFACES = scenes_in("surfaces")


@given(plane_scenes(shape="box"))
@example(SURFACES["a-pair-of-axes-and-one-alone"])
@fewer(5)
def test_both_roads_agree_and_more_digits_stay_in_the_bounds(scene):
    try:
        found, high = followed(scene, 30, 1000), solve(scene, digits=30)
    except NumericsError:
        return
    with high.context():
        assert agree((found.events, found._own_moments), (high.events, high._own_moments))


def test_mirrored_axes_have_their_events_together():
    found = solve(SURFACES["mirrored-axes"], digits=15)
    assert {one.after for one in found.events} == {"+-", "00", "-+"}
    x, y = found.final_state.x1
    assert x.overlaps(-y)


AT_ONCE = """
a-jump-lets-go-of-both                      | 00 ++ 1/2 jump | 2 1.5
a-jump-lets-go-of-both-at-no-binary-number  | 00 ++ 1/3 jump | 2 1.5
a-jump-lets-go-of-both-which-are-coupled    | 00 ++ 1/3 jump | 2 1.5
both-stop                                   | -- 00 1 guard  | -0.5 -2
one-stops-a-little-later                    | -- 0- 1 guard  | -0.5 -2
one-stops-and-a-jump-lets-go-of-the-other   | -0 0+ 1 jump   | -0.5 6
a-jump-lets-go-of-one-and-the-other-stops   | 0- +0 1 jump   | 4.5 -2
one-stops-where-there-is-a-jump-in-which-the-other-slips-on | -- 0- 1/3 guard | -0.5 -2 -0.5 3.33
"""
"""The modes before and after the first event, its time and its cause; its loads, of the last row before and behind."""


@pytest.mark.parametrize("row", AT_ONCE.strip().splitlines())
def test_what_happens_at_one_time_that_is_known_exactly_is_one_event(row):
    (name,), (before, after, t, cause), loads = map(str.split, row.split("|"))
    found = solve(scenes_in("at-once")[name], digits=20)
    first = found.events[0]
    assert (*found.modes[:2], first.cause) == (before, after, cause)
    assert first.t.overlaps(Ball.number(Fraction(t)))
    assert all(first.load[k % 2].contains(float(load)) for k, load in enumerate(loads))


@pytest.mark.parametrize(("way", "modes"), [("outwards", ("-0", "00")), ("inwards", ("00", "+0"))])
def test_a_coupled_axis_that_begins_exactly_on_the_edge_leaves_it_the_way_its_load_goes(way, modes):
    assert solve(SURFACES[f"a-box-from-the-edge-{way}"], digits=15).modes[:2] == modes


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
