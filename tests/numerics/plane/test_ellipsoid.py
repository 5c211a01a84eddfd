"""Slips on a surface: against the pair on a line, against higher precision, where they begin, graze, settle and end."""

from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from hypothesis import example, given
from plane_paths import agree, overlap, path_of
from reaching import LeftOut, reaching
from scene_files import scenes_in
from strategies import extreme_scenes, fewer, plane_scenes

from numerics import solve
from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided, NumericsError
from numerics.plane import run as running
from numerics.plane.defect import defect, slip_defect
from numerics.plane.motion import around
from numerics.plane.passage import drawn_to
from numerics.plane.series import Expansion, Point
from numerics.plane.vector import Vector
from numerics.scene.file import load_scene
from numerics.scene.plane import PlanePair, PlaneScene

SURFACES = scenes_in("surfaces")
AT_REST, OBLIQUE, REVERSALS = (scenes_in(f"surfaces/{name}") for name in ("at-rest", "oblique", "reversals"))


@pytest.mark.parametrize("name", ["along-it", "along-it-for-half-a-second"])
def test_an_oblique_line_is_the_pair_of_the_paper_digit_for_digit(name):
    """Also up to where a force on one axis leads away from it: a slip gets exactly to rest before that."""
    line, plane = (solve(OBLIQUE[one], digits=24, arithmetic="ball") for one in ("line", name))
    with Ball(40).context():
        assert len(line.events) > 1
        assert overlap(plane.event_times[: len(line.events)], line.event_times)
        assert overlap(plane.sol("0.5"), [arb(c) * true for true in line.final_state for c in ("0.6", "0.8")])
        x, y = plane.final_state.x1
        assert (3 * y - 4 * x).contains(0) == (name == "along-it")


@pytest.mark.parametrize("scene", AT_REST.values(), ids=AT_REST)
def test_what_rests_up_to_a_time_that_no_float_holds_has_its_digits(scene):
    """Zeros that are known but for rounding had none, beside a largest number that is 0 too."""
    run = solve(scene)
    assert (run.success, run.digits, run.events) == (True, 15, ())
    with run.context():
        assert all(abs(one) < 1e-30 for one in run.final_state.v1 + run.final_state.v2)


@pytest.mark.parametrize(("name", "modes"), [("drawn-through-rest", ("slip", "slip")), ("by-a-circle", ("slip",))])
def test_a_slip_passes_through_rest_where_an_ellipse_draws_it_there(name, modes):
    """b_x^2 kap > b_y kap (b_y + |Lam|): an open set of slips meets v1 = v2 and leaves at once; a round one turns."""
    assert solve(REVERSALS[name], digits=20).modes == modes


def test_a_near_reversal_turns_and_an_exact_one_passes():
    near, exact = (solve(REVERSALS[name], digits=20) for name in ("near", "exact"))
    assert (near.modes, exact.modes) == (("slip",), ("slip", "slip"))
    assert abs(near.final_state.v2[0] - exact.final_state.v2[0]) < 1e-9


def test_a_slip_ends_along_the_load_of_a_round_pair_and_its_energy_falls():
    found = solve(load_scene("plane-circle-merges"), digits=15)
    (event,) = found.events
    assert np.all(np.diff([float(x) for x in found.energy]) < 1e-18)
    with Ball(30).context():
        size = sum((x * x for x in event.load), arb(0)).sqrt()
        assert overlap(event.direction, [y / size for y in event.load])
        assert all(x.rad() < 1e-14 for x in event.direction)
        assert size < 0.5


UNCOUPLED = PlanePair([1, 2], [1, 3], [200, 120], ["0.271", "1.3"])
COUPLED = PlanePair(1, 1, [[200, 60], [60, 120]], "0.5")
LEAVING = PlanePair(1, 1, [[200, 60], [60, 120]], [1, "0.1"])
"""At rest on the edge the load of the last one goes out of K, for some directions; those of the others only fall."""


def at_rest_with(pair: PlanePair, load: tuple[Fraction, Fraction], until: str = "2") -> PlaneScene:
    """A pair at rest, its springs stretched so that sticking needs these parts of b."""
    (a, c), (_, d) = pair.a2
    u, v = (-x * b * (1 + m1 / m2) for x, b, m1, m2 in zip(load, pair.b, pair.m1, pair.m2, strict=True))
    return PlaneScene(pair, until, x1=[(d * u - c * v) / (a * d - c * c), (a * v - c * u) / (a * d - c * c)])


@pytest.mark.parametrize("load", [("0.6", "0.8"), ("-5/13", "12/13"), ("0.8", "-0.6"), (0, -1)])
@pytest.mark.parametrize("pair", [UNCOUPLED, COUPLED])
def test_a_pair_at_rest_exactly_on_the_edge_sticks_where_its_load_can_only_fall(pair, load):
    """Also where its axes swing with different frequencies."""
    load = tuple(map(Fraction, load))
    run = solve(at_rest_with(pair, load))
    assert run.modes == ("stick",)
    m1, m2, b, a2 = (np.array(one, float) for one in (pair.m1, pair.m2, pair.b, pair.a2))
    q1 = run.floats(run.sol(np.linspace(0, 2, 400)))[:2]
    strain = (m2 / (m1 + m2) / b)[:, None] * (a2 @ q1)
    assert (strain**2).sum(axis=0).max() < 1 + 1e-12
    beyond = tuple(x * (1 + Fraction(1, 10**20)) for x in load)
    assert solve(at_rest_with(pair, beyond, "0.01")).modes[0] == "slip"


def test_a_load_that_springs_or_velocities_draw_out_of_the_edge_is_not_said_to_stick():
    out = Fraction("0.6"), Fraction("-0.8")
    inside = tuple(x * (1 - Fraction(1, 10**6)) for x in out)
    assert solve(at_rest_with(LEAVING, inside, "0.1")).modes[:2] == ("stick", "slip")
    moving = at_rest_with(UNCOUPLED, inside, "0.1").replace(v1=[0, "0.1"], v2=[0, "0.1"])
    assert solve(moving).modes[:2] == ("stick", "slip")
    with pytest.raises(EventUndecided):
        solve(at_rest_with(LEAVING, out))


@pytest.mark.parametrize("kind", ["any", *(pytest.param(one, marks=pytest.mark.long) for one in ("ellipsoid", "box"))])
def test_what_a_bound_says_holds_at_more_digits(kind):
    @reaching
    @given((extreme_scenes | {"any": plane_scenes()})[kind])
    @example(SURFACES["a-load-of-0-at-the-end-of-a-slip"])
    @example(SURFACES["late"])
    @fewer(5 if kind == "any" else 1)
    def hold(scene):
        try:
            low, high = (solve(scene, digits=digits, max_events=30, max_digits=2000) for digits in (15, 22))
        except NumericsError:
            raise LeftOut from None
        with high.context():
            assert agree(*((one.events, one._own_moments, one.final_mode) for one in (low, high)))
        assert low.digits == 15

    hold()


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


@pytest.mark.parametrize(("way", "before"), [("outwards", "slip"), ("inwards", "stick")])
def test_a_start_exactly_on_the_edge_leaves_it_the_way_the_load_goes(way, before):
    """Its first numbers are as good as all others: 20 digits at t = 0 need no more working digits than later on."""
    found = solve(SURFACES[f"from-the-edge-{way}"], digits=20)
    assert (found.modes[0], found.arithmetic.digits) == (before, 26)


@pytest.mark.parametrize(
    ("body", "times"),
    [
        (1, (0.049482916423, 0.258800302582, 0.432707525554)),
        (2, (0.046005759020, 0.252563273982, 0.435031547776)),
    ],
)
def test_an_axis_with_a_light_body_settles_alone(body, times):
    """Its direction settles a million times quicker than things change: few steps, and the events of Radau's method."""
    run = path_of(SURFACES[f"a-light-body-{body}-on-one-axis"], 30, legs=250)
    run.follow()
    assert [one.after for one in run.events] == ["slip", "stick", "slip"]
    assert [float(one.t.mid()) for one in run.events] == pytest.approx(times, abs=1e-11)


def test_a_slip_that_has_settled_is_the_one_that_steps_find(monkeypatch):
    scene = load_scene("plane-circle-merges")
    settled = solve(scene, digits=15)
    monkeypatch.setattr(running, "_OFTEN", 10**9)
    (event,), (other,) = settled.events, solve(scene, digits=15).events
    with settled.context():
        assert agree(([event],), ([other],))


def test_what_holds_in_a_window_holds_and_a_window_that_is_too_long_is_refused():
    scene = load_scene("plane-slip-turns")
    run, found = path_of(scene, 30), solve(scene, digits=15)
    window = Fraction(1, 1000)
    with run.system.fine():
        near = around(run.system, run.at, arb(0), Ball.number(window))
        moved, passed = found.sol(window)[3:6] - found.sol(0)[3:6], Ball.number(window)
        assert all(abs(x) < rate * passed for x, rate in zip(moved, near.first, strict=True))
        assert not all(abs(x) < rate * passed / 4 for x, rate in zip(moved, near.first, strict=True))
        with pytest.raises(EventUndecided, match="how far does the motion get in a window near t = 0 s"):
            around(run.system, run.at, arb(0), arb(1))


@pytest.mark.parametrize(("load", "passes"), [("1.04", True), ("1.06", False)])
def test_a_slip_is_drawn_through_rest_up_to_the_load_at_which_its_direction_is_no_minimum(load, passes):
    """b_x^2 kap = b_y kap (b_y + |Lam|) at |Lam| = 1.05: PLANE's condition, at its edge."""
    system = path_of(REVERSALS["at-the-edge-of-a-minimum"], 30).system
    with system.fine():
        along = Vector([arb(0, 1e-6), arb(-1, 1e-6)])
        drawn = drawn_to(system, system.pieces[0], Vector([arb(0), arb(load)]), along)
        assert (drawn is not None) == passes
        assert passes != (drawn is None or not drawn.psi > 1)
        assert drawn_to(system, system.pieces[0], Vector([arb(0), arb(load)]), Vector([arb(0, 1), arb(-1)])) is None


def test_a_slip_settles_on_two_axes_quickly_and_slowly_on_the_third():
    """The two are followed as settled while the third is not yet: else the same slip takes many more steps."""
    run = path_of(SURFACES["two-axes-settle-quickly"], 20, legs=250)
    run.follow()
    assert [(one.after, float(one.t.mid())) for one in run.events] == [("stick", pytest.approx(0.31313599107375))]
