"""A trajectory speaks SciPy, is evaluated anywhere from either side, and restores the precision it used."""

from dataclasses import replace

import numpy as np
import pytest
from flint import arb

from numerics import (
    Force,
    Friction,
    Pair,
    Scene,
    State,
    Weakening,
    load_scene,
    solve,
)


@pytest.mark.parametrize("name", ["forced-friction-by-pieces", "velocities"])
def test_what_is_said_of_a_ball_of_times_holds_what_is_said_of_each(name):
    run = solve(load_scene(name), digits=20, arithmetic="ball")
    with run.arithmetic.context():
        for t in run.event_times:
            for middle in (-0.003, 0, 0.003):
                wide = run.sol(t + middle + arb(0, 0.01))
                for by in (-0.006, 0.006):
                    assert all(one.contains(two) for one, two in zip(wide, run.sol(t.mid() + by), strict=True))


DRIVEN = Scene(Pair(1, 1, 200, "0.05", "0.5"), State(v1="0.15"), 1, force=Force.sine("0.35", 5))


@pytest.mark.parametrize("scene", [DRIVEN, replace(DRIVEN, friction=Friction(weakening=Weakening([(1, "0.04")])))])
def test_what_is_lost_over_a_ball_of_times_holds_what_is_lost_up_to_each(scene):
    run = solve(scene, digits=20, arithmetic="ball")
    with run.context():
        for row, length in enumerate(run.row_lengths[:3]):
            wide, *inside = run.row_taken(
                [row] * 4, [length / 2 + arb(0, 1) * length / 4, *(length * k / 10 for k in (3, 5, 7))]
            ).T
            assert all(one.contains(two) for taken in inside for one, two in zip(wide, taken, strict=True))


def test_a_stick_of_thousands_of_turns_keeps_its_ledger():
    run = solve(Scene(Pair(1, 1, 200, "0.5", "1"), State(x1="0.004"), "2999.9"), digits=20, arithmetic="ball")
    with run.context():
        residual, lost = run.ledger.residual, run.dissipated
        assert residual.contains(0)
        assert residual.rad() < lost * 1e-18
        assert all(one.rad() < 1e-35 for one in run.sol(2999))


def test_progress_is_told():
    told, scene = [], Scene(Pair(1, 1, 200, "0.0005"), State(v1="0.15"), until=500)
    solve(scene, progress=lambda n, part: told.append((n, part)))
    assert told
    assert np.all(np.diff(told, axis=0) > 0)
