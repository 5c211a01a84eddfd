"""Derivatives of the state at any time: against differences of solves, and against those of events and ends."""

from fractions import Fraction

import numpy as np
import pytest
from differences import parameters
from scene_files import scenes_in

from numerics import Force, Pair, Scene, State, sensitivities, solve

PAIR = Pair(1, 1, 200, "0.2", "0.5")
SCENES = scenes_in("followed")


@pytest.fixture(params=SCENES)
def scene(request):
    return SCENES[request.param]


def test_start_and_end(scene):
    trajectory = solve(scene)
    first, found = sensitivities(trajectory, 0), sensitivities(trajectory)
    if trajectory.modes[0].sign:
        assert (first[:, :4] == np.eye(4)).all()
    last = sensitivities(trajectory, scene.until)
    for index, name in enumerate(found.wrt):
        assert (last[:, index] == (0 if name == "until" else found.final[:, index])).all()


def test_both_sides_of_an_event(scene):
    """dy + f dtau is the derivative of the event's state, from either side; limits from the sides are the same."""
    trajectory, near = solve(scene), Fraction(1, 10**7)
    found, number = sensitivities(trajectory), float
    for k, event in enumerate(trajectory.events):
        t = Fraction(event.t)
        for side, sign in (("left", -1), ("right", 1)):
            at = sensitivities(trajectory, event.t, side)
            assert np.allclose(at, sensitivities(trajectory, t + sign * near), rtol=1e-4, atol=1e-4 * np.abs(at).max())
            state, later = (trajectory.sol(t + sign * one * near) for one in (1, 2))
            rate = (later - state) / number(sign * near)
            total = at + np.outer(rate, found.t[k])
            scale = np.abs(found.y[k]).max() + np.abs(np.outer(rate, found.t[k])).max()
            assert np.allclose(total, found.y[k], rtol=0, atol=1e-4 * scale)


def test_a_jump_of_the_force_has_two_sides():
    trajectory = solve(Scene(PAIR, State(), 2, force=Force.step(1, "0.2")))
    start = list(parameters(trajectory.scene)).index("force[0].from")
    assert (sensitivities(trajectory, 1, "left")[:, start] == 0).all()
    assert sensitivities(trajectory, 1)[1, start] == pytest.approx(-0.1)  # both bodies go on, and later


def test_a_ball_of_times_that_holds_an_event_gets_both_sides(scene):
    trajectory = solve(scene, arithmetic="ball", digits=20)
    event = next(one for one in trajectory.events if not one.t.is_exact())
    found, (left, right) = (sensitivities(trajectory, event.t), (event.t.lower() - 1e-9, event.t.upper() + 1e-9))
    for near in (left, right):
        gaps = found - sensitivities(trajectory, near)
        assert all(abs(one).lower() < 1e-6 for one in gaps.ravel())
