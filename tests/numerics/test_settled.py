"""What is said of all later times, held against what follows: stuck for ever, or near its periodic motion."""

import math
from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import decimals, signed

from numerics import EventUndecided, Force, Pair, Piece, Scene, State, solve
from numerics.arithmetic.ball import Ball
from numerics.control import ring as rings
from numerics.control.attraction import distance, passage_at
from numerics.control.orbit import Orbit
from numerics.control.response import last_drive, response
from numerics.control.ring import Settled, periodic_settled, ring_entry, stretches
from numerics.control.stuck import stuck_state
from numerics.trajectory.run import run_scene
from numerics.trajectory.status import Status

HEAVY = Pair(1, 1, 1, 1, 10)
"""Its velocity loads the interface much more than its place does."""
FAST = Pair(3, "0.5", 2_000_000, "0.5", 300)
"""In a period of it at 1200 rad/s it can slide far less, in metres, than its speed in metres a second."""


def beside_the_response(amplitude: Fraction, omega: int, phase: Fraction, place: Fraction, speed: Fraction) -> Scene:
    """The heavily damped pair under a sine, stuck beside its stuck response by (place, speed)."""
    force = Force.sine(amplitude, omega, phase)
    scene = Scene(HEAVY, State(), Fraction(1, 10**5), force=force)
    with Ball(20).context():
        x, v, _ = (Fraction(float(one.mid())) for one in stuck_state(last_drive(scene), Ball.number(0)))
    return replace(scene, initial=State(x + place, v + speed, 0, v + speed))


def amplitude_for(part: Fraction, omega: int) -> Fraction:
    """The amplitude whose stuck response takes this part of the friction: m2 omega^2 U/Z(M) = part b."""
    return part * Fraction(math.hypot(1 - 2 * omega**2, 10 * omega)) / omega**2


def said(scene: Scene) -> bool | None:
    """Whether it is said to have stuck for ever; None if it slips at once."""
    with Ball(20).context():
        run = run_scene(scene, Ball(20), 10)
        return None if len(run.events) else run.status is Status.STUCK_FOR_EVER


small = signed(decimals(-3, -2, 2))


@reaching
@settings(max_examples=40)
@given(st.integers(-16, 16), st.sampled_from([-1, 1]), small, small, st.integers(1, 7))
def test_a_pair_that_is_said_to_have_stuck_for_ever_never_slips_again(phase, side, place, speed, tenths):
    amplitude = side * amplitude_for(Fraction(tenths, 10), 100)
    scene = beside_the_response(amplitude, 100, Fraction(phase, 5), place, speed)
    if not said(scene):
        raise LeftOut
    assert not len(solve(replace(scene, until=Fraction(2))).events)


@pytest.mark.parametrize(
    ("part", "speed", "omega"),
    [("0.5", "0.29", 100), ("-0.5", "-0.29", 100), ("0.5", "0.11", 1000), ("-0.9", "0.05", 1000)],
)
def test_a_free_part_that_lets_the_response_break_the_stick_is_not_said_to_be_settled(part, speed, omega):
    """Their loads take each other's place at the start, and add up half a period later."""
    amplitude = amplitude_for(Fraction(part), omega)
    scenes = [beside_the_response(amplitude, omega, Fraction(k, 5), Fraction(0), Fraction(speed)) for k in range(32)]
    stuck_at_first = [scene for scene in scenes if said(scene) is not None]
    assert any(len(solve(replace(scene, until=Fraction(1))).events) for scene in stuck_at_first)
    assert not any(said(scene) for scene in stuck_at_first)


# next to a periodic motion


@cache
def fast_orbit() -> tuple[Scene, Orbit]:
    scene = Scene(FAST, State(v1=1), Fraction(1, 10), force=Force.sine(5, 1200))
    return scene, response(scene, digits=30).orbit


def known(until: str, near: float) -> Settled | None:
    scene, orbit = fast_orbit()
    arithmetic = Ball(24)
    with arithmetic.context():
        return periodic_settled(run_scene(replace(scene, until=Fraction(until)), arithmetic, 2_000), orbit, near)


def test_the_speed_counts_even_where_nothing_is_left_to_slide(monkeypatch):
    monkeypatch.setattr(rings, "slide_left", lambda *_: arb(0))
    scene, orbit = fast_orbit()
    since, period = float(known("0.3", 1e-3).since), float(orbit.drive.period)
    assert since < 0.25
    t = np.linspace(since, since + 5 * period, 400)
    y = solve(replace(scene, until=Fraction(since + 6 * period))).sol(t)
    with Ball(20).context():
        for k, at in enumerate(t):
            try:
                time = Ball.number(Fraction(at))
                _, v1, _, v2 = (float(one.mid()) for one in passage_at(orbit, time).state(time))
            except EventUndecided:  # next to an event of the orbit
                continue
            assert abs(y[1, k] - y[3, k] - v1 + v2) < 1e-3


def test_what_can_still_slide_is_in_the_limit(monkeypatch):
    """@example of a fault that survived: it is far less than the last digits of balls."""
    monkeypatch.setattr(rings, "slide_left", lambda *_: arb("1e-6"))
    scene = Scene(Pair(1, 1, 200, "0.5", 3), State(v1=1), 80, force=Force.sine(2, 12))
    orbit, arithmetic = response(scene, digits=15).orbit, Ball(20)
    with arithmetic.context():
        assert periodic_settled(run_scene(scene, arithmetic, 2_000), orbit, 1e-3).limit.rad() >= 1e-6


def test_since_is_the_first_period_that_is_proved_to_stay_as_near_as_asked(monkeypatch):
    """One period earlier the speeds may be further apart; with 20 times the distance that would count as near, too."""
    monkeypatch.setattr(rings, "slide_left", lambda *_: arb(0))
    scene, orbit = fast_orbit()
    pair, arithmetic, near = orbit.drive.pair, Ball(24), 1e-3
    since = known("0.3", near).since
    with arithmetic.context():
        parts = stretches(run_scene(replace(scene, until=Fraction("0.3")), arithmetic, 2_000))
        kappa = Ball.number(pair.mass / (pair.m1 * pair.m2))
        apart = []
        for t in (since, since - orbit.drive.period):
            [state] = [one.state(t) for one in parts if float(one.begin) <= float(t) < float(one.end)]
            apart.append(float(kappa.sqrt() * distance(pair, state, passage_at(orbit, t).state(t))))
    assert apart[0] < near <= apart[1]


def test_a_piece_that_begins_after_the_horizon_counts():
    """The pair is at rest, and so it is under the last piece; one in between tears it apart."""
    force = Force((Piece(2, [2]), Piece(3, [0])))
    scene = Scene(Pair(1, 1, 200, "0.5", 3), State(), Fraction(1, 2), force=force)
    found = ring_entry(scene, "0.0005", digits=8)
    assert found.entry > 3
    y = solve(replace(scene, until=Fraction(10))).sol(float(found.entry.mid()) + np.linspace(1e-6, 5, 400))
    assert np.hypot(y[0] - y[2] - float(found.centre), y[1] - y[3]).max() <= 0.0005
