"""Derivatives of the state at any time: against differences of solves, and against those of events and ends."""

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
