"""Slips that graze or settle, against their own steps; what windows and passages claim, at the edge of the truth."""

from fractions import Fraction

import pytest
from flint import arb
from plane_paths import agree, path_of

from numerics import solve
from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided
from numerics.plane import run as running
from numerics.plane.passage import drawn_to
from numerics.plane.vector import Vector
from numerics.plane.window import around
from numerics.scene.file import load_scene
from numerics.scene.plane import PlanePair, PlaneScene


@pytest.mark.parametrize(
    ("m1", "m2", "times"),
    [
        ([1, "1e-6"], 1, (0.049482916423, 0.258800302582, 0.432707525554)),
        (1, [1, "1e-6"], (0.046005759020, 0.252563273982, 0.435031547776)),
    ],
)
def test_an_axis_with_a_light_body_settles_alone(m1, m2, times):
    """Its direction settles a million times quicker than things change: few steps, and the events of Radau's method."""
    scene = PlaneScene(PlanePair(m1, m2, [100, 120], "0.5"), "0.5", x1=["0.01", "0.004"], v1=["0.1", "0.2"])
    run = path_of(scene, 30, legs=250)
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
    system = path_of(PlaneScene(PlanePair(2, 2, 1, ["0.5", "0.2"]), 1, x1=["0.1", "0.1"]), 30).system
    with system.fine():
        along = Vector([arb(0, 1e-6), arb(-1, 1e-6)])
        drawn = drawn_to(system, system.pieces[0], Vector([arb(0), arb(load)]), along)
        assert (drawn is not None) == passes
        assert passes != (drawn is None or not drawn.psi > 1)
        assert drawn_to(system, system.pieces[0], Vector([arb(0), arb(load)]), Vector([arb(0, 1), arb(-1)])) is None


def test_a_slip_settles_on_two_axes_quickly_and_slowly_on_the_third():
    """The two are followed as settled while the third is not yet: else the same slip takes 1500 steps."""
    pair = PlanePair("0.5", 1, 200, ["0.5", "0.5", "0.02"])
    start = {"v1": ["0", "0.0433433", "0.0001"], "v2": ["0", "0.0433433", "0.0001"]}
    found = solve(PlaneScene(pair, 1, x1=["0.00375375", 0, "0.00001"], **start))
    assert [one.after for one in found.events] == ["stick"]
    assert len(found.motion.legs) < 400
    assert found.digits >= 12
