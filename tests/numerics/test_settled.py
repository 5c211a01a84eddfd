"""What is said of all later times, held against what follows: stuck for ever, or near its periodic motion."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import decimals, signed

from numerics.arithmetic.ball import Ball
from numerics.control.attraction import place_at
from numerics.control.orbit import Orbit
from numerics.control.response import last_drive, response, stuck_state
from numerics.control.settled import Settled, periodic_settled, stuck_settled
from numerics.run.one import run_scene
from numerics.scene import Force, Pair, Scene, State
from numerics.solver.solve import solve

HEAVY = Pair(1, 1, 1, 1, 10)
"""Its velocity loads the interface much more than its place does."""
FAST = Pair(3, "0.5", 2_000_000, "0.5", 300)
"""In a period of it at 1200 rad/s it can slide far less, in metres, than its speed in metres a second."""


@reaching
@settings(max_examples=40)
@given(
    st.integers(-16, 16),
    st.sampled_from([-1, 1]),
    signed(decimals(-2, -1, 2)),
    signed(decimals(-2, 0, 2)),
    st.integers(1, 9),
)
@example(0, 1, Fraction(0), Fraction("0.29"), 5)  # the free part's velocity, against the response until it turns
@example(0, -1, Fraction(0), Fraction("-0.29"), 5)
def test_a_pair_that_is_said_to_have_stuck_for_ever_never_slips_again(phase, side, place, speed, tenths):
    omega = Fraction(100)
    # the response takes so many tenths of the friction: m2 omega^2 U/Z(M)
    impedance = Fraction(math.hypot(1 - 2 * 100**2, 10 * 100))
    amplitude = side * Fraction(tenths, 10) * impedance / omega**2
    force = Force.sine(amplitude, omega, Fraction(phase, 5))
    scene = Scene(HEAVY, State(), Fraction(1, 10**4), force=force)
    drive = last_drive(scene)
    with Ball(20).context():
        x, v, _, _ = (Fraction(float(one.mid())) for one in stuck_state(drive, Ball.number(0)))
        scene = replace(scene, initial=State(x + place, v + speed, 0, v + speed))
        run = run_scene(scene, Ball(20), 10)
        if len(run.events) or stuck_settled(run, drive) is None:
            raise LeftOut
    assert not len(solve(replace(scene, until=Fraction(2))).events)


@pytest.mark.parametrize(("side", "speed"), [(1, "0.29"), (-1, "-0.29")])
def test_a_free_part_that_lets_the_response_break_the_stick_is_not_said_to_be_settled(side, speed):
    """Their loads take each other's place at the start, and add up half a period later."""
    omega, impedance = Fraction(100), Fraction(math.hypot(1 - 2 * 100**2, 10 * 100))
    for phase in range(-16, 17):
        force = Force.sine(side * impedance / 2 / omega**2, omega, Fraction(phase, 5))
        scene = Scene(HEAVY, State(), Fraction(1, 10**4), force=force)
        drive = last_drive(scene)
        with Ball(20).context():
            x, v, _, _ = (Fraction(float(one.mid())) for one in stuck_state(drive, Ball.number(0)))
            scene = replace(scene, initial=State(x, v + Fraction(speed), 0, v + Fraction(speed)))
            run = run_scene(scene, Ball(20), 10)
            if not len(run.events):
                assert stuck_settled(run, drive) is None
                assert len(solve(replace(scene, until=Fraction(1))).events)
                return
    pytest.fail("no start sticks at first")


# next to a periodic motion


@cache
def fast_orbit() -> tuple[Scene, Orbit]:
    scene = Scene(FAST, State(v1=1), Fraction(1, 10), force=Force.sine(5, 1200))
    return scene, response(scene, digits=20).orbit


@cache
def known(until: str, near: float) -> Settled | None:
    scene, orbit = fast_orbit()
    arithmetic = Ball(24)
    with arithmetic.context():
        return periodic_settled(run_scene(replace(scene, until=Fraction(until)), arithmetic, 2_000), orbit, near)


def test_the_limit_of_a_shorter_run_holds_that_of_a_longer_one():
    early, late = known("0.25", 1e-4), known("0.3", 1e-4)
    assert early.limit.contains(late.limit)
    assert 0 < late.limit.rad() < early.limit.rad()


@pytest.mark.parametrize("near", [1e-3, 1e-5])
def test_after_the_time_that_is_said_place_and_speed_are_near(near):
    scene, orbit = fast_orbit()
    found = known("0.3", near)
    since, period = float(found.since), float(orbit.drive.period)
    t = np.linspace(since, since + 5 * period, 400)
    y, limit = solve(replace(scene, until=Fraction(since + 6 * period))).sol(t), float(found.limit)
    with Ball(20).context():
        for k, at in enumerate(t):
            try:
                x1, v1, x2, v2 = (float(one.mid()) for one in place_at(orbit, Ball.number(Fraction(at))).state)
            except ArithmeticError:  # next to an event of the orbit
                continue
            assert abs(y[0, k] - y[2, k] - x1 + x2 - limit) < near
            assert abs(y[1, k] - y[3, k] - v1 + v2) < near
