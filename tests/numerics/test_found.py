"""Faults that were found once, by search or by a hostile reader; and at the extremes nothing comes but typed errors.

Ties through square roots, nearly critical damping, motions that have died away, events on the horizon.
"""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from every_number import compared
from hypothesis import given
from hypothesis import strategies as st
from scene_files import scenes_in
from strategies import EXTREME, scenes

from numerics import (
    Force,
    NumericsError,
    Pair,
    Piece,
    PlanePair,
    PlaneScene,
    PrecisionExhausted,
    Scene,
    State,
    solve,
    solve_many,
    solve_scenes,
)
from numerics.control.response import response
from numerics.linear.modes import EventKind
from numerics.trajectory.comparison import require_same_sequence
from numerics.trajectory.run import free_scene
from numerics.trajectory.status import Status


@given(scenes(EXTREME, None, (-12, 12)), st.sampled_from(["float64", "ball"]))
def test_nothing_but_typed_errors(scene, arithmetic):
    try:
        trajectory = solve(scene, arithmetic=arithmetic, max_events=20, max_digits=400)
    except NumericsError:
        return
    assert len(trajectory.events) <= 20


@pytest.mark.parametrize("scene", scenes_in("lost").values(), ids=scenes_in("lost"))
def test_no_event_is_lost_in_any_arithmetic(scene):
    balls = solve(scene, digits=20, arithmetic="ball")
    for arithmetic in ("float64", *["mpmath"] * free_scene(scene)):
        points = solve(scene, arithmetic=arithmetic)
        assert points.certain
        require_same_sequence(points, balls)


def test_a_damped_motion_that_has_died_away_decides_nothing_by_its_signs():
    # after a long overdamped slip body 1 rests in its equilibrium to 20 000 digits; the load on a stuck pair likewise
    pair = Pair(m1="6.05", m2="5.889", a2=57867, b="6.896", a1=1662)
    run = solve(
        Scene(pair, State(x1="-0.000947", v1="0.0037", v2=-1282), until=3000),
        digits=15,
        arithmetic="ball",
        max_events=4,
    )
    assert run.status is Status.STUCK_FOR_EVER
    assert run.event_kinds[-1] is EventKind.ENTRY


@pytest.mark.parametrize("scene", scenes_in("no-ties").values())
def test_a_zero_through_square_roots_is_no_tie(scene):
    balls, at = solve(scene, digits=30, arithmetic="ball"), scene.initial
    require_same_sequence(solve(scene), balls)
    nudged = State(at.x1, at.v1, at.x2, at.v2 + scene.pair.half_width / 10**30) if at.v1 != at.v2 else at
    require_same_sequence(solve(replace(scene, initial=nudged)), balls)


def test_friction_work_near_the_critical_orbit_counts_every_slip():
    """Slips of 1e-17 s next to t = 1 s must not round away: the work of ten is ten times that of the first, nearly."""
    scene = Scene(Pair(1, 1, 200, "0.5"), State(x1="0.005", v1="1e-18", v2="1e-18"), until=10)
    balls = solve(scene, digits=30, arithmetic="ball")
    other = solve(scene, digits=60, arithmetic="ball").ledger
    assert float(other.friction.mid()) == pytest.approx(float(balls.ledger.friction.mid()), rel=1e-10)


def test_an_event_in_the_same_place_as_the_horizon():
    until = 2.10700551516822
    scene = Scene(Pair("1e-4", 10, 1, 5, 2), State(x1=-150, v1=-288, v2=29), Fraction(until))
    assert {solve(scene, digits=digits).arithmetic.name for digits in (None, 5)} == {"ball"}
    found = solve_many(1e-4, 10, 1, 5, a1=2, x1=-150, v1=-288, v2=29, until=until)
    assert np.isfinite(found.dissipated_error) or not found.certain


def test_energies_below_the_normal_numbers_have_no_digits_to_claim():
    scene = Scene(Pair(1, 1, 1, "1e-160"), State(v1="3e-160"), until=4)
    run, numbers = compared(scene, "float64")
    assert [one for one in numbers if not one.ratio <= 1.0] == []
    assert min(run.accuracy.energy, run.accuracy.dissipated) > 0
    assert solve(scene, digits=8).arithmetic.name != "float64"
    assert solve_many(1, 1, 1, 1e-158, v1=3e-158, until=4).dissipated_error > 0


def test_a_slip_of_many_turns_costs_no_digits():
    """Balls found its end to few digits, and needed 1152."""
    found = solve(Scene(Pair(1, 1, 1, 1), State(v2=10**9), 10**9), digits=300)
    assert found.arithmetic.digits < 400


def test_nothing_at_rest_is_known_exactly():
    assert solve(Scene(Pair(1, 1, 1, 1), State(), until=3), digits=14).arithmetic.name == "float64"


def test_a_force_beyond_all_digits_is_refused_at_once():
    """It was tried over hundreds of periods at every precision: v2 is nothing beside v1 until these are as many."""
    scene = Scene(Pair(1, 1, 200, "0.5"), State(), 1)
    with pytest.raises(PrecisionExhausted, match="max_digits"):
        response(scene, amplitude="1e999", omega=5)


def test_exponents_that_differ_by_many_magnitudes_are_told_apart():
    """A rotating force of 1e9 rad/s: the roots were sought at one precision, and flint's words came through."""
    found = response(PlaneScene(PlanePair(1, 1, 200, "0.5", 1), 1), amplitude=1, omega="1e9")
    assert [float(one.real) < 0 for one in found.exponents] == [True] * 6


@pytest.mark.parametrize("a1", [0, "1.95"])
def test_a_force_of_nothing_from_some_time_on_is_no_force(a1):
    """With a damper the times of events after it were counted from it in float64, and said to be certain."""
    start = State("-0.00846", "-0.318", 0, "-0.172")
    plain = Scene(Pair("6.5", "2.4", 338, "3.24", a1), start, "2.43")
    cut = replace(plain, force=Force([Piece("1.31", [])]))
    found = solve_scenes([plain, cut], keep_events=20).event_t
    assert np.nanmax(found) > 1.31
    assert np.allclose(*found, rtol=1e-13, atol=0, equal_nan=True)
