"""What a run answers where belt, wall, force on body 2, varying friction, no spring, or more friction at rest act."""

import numpy as np
import pytest
from scene_files import scenes_in

from numerics import (
    Force,
    Pair,
    Scene,
    State,
    solve,
)
from numerics.linear.model import TAKEN

SCENES = scenes_in("signals")


@pytest.mark.parametrize("name", SCENES)
def test_floats_are_balls_and_the_books_close(name):
    scene = SCENES[name]
    run, truth = (solve(scene, max_events=40, arithmetic=one) for one in ("float64", "ball"))
    assert run.check().right
    times = np.linspace(0, float(run.end_time), 40)
    assert truth.floats(truth.sol(times)) == pytest.approx(run.sol(times), abs=1e-12)
    books, true = run.ledger, truth.ledger
    with truth.context():
        assert true.residual.contains(0)
        for part in ("initial", "final", "work", *TAKEN):
            off = abs(getattr(books, part) - truth.arithmetic.to_float(getattr(true, part)))
            assert off <= books.error + 1e-14 * (1 + books.friction)
    assert abs(books.residual) <= 6 * books.error + 1e-14
    assert len(run.to_dataframe()) == len(truth.to_csv().splitlines())
    run.plot("energy")


@pytest.mark.parametrize("start", [1, "1/3", "0.1"])
def test_a_wall_that_jumps_gives_its_work_at_once(start):
    """@example of a found fault: at 1/3 s, no binary number, the float64 work was 0, and the energy that before."""
    scene = Scene(Pair(1, 1, 200, "0.5"), State(), 2, wall=Force.step(start, "0.02"))
    for arithmetic in ("float64", "ball"):
        run = solve(scene, arithmetic=arithmetic)
        assert run.floats([run.ledger.wall, run.energy[1]]) == pytest.approx(100 * 0.02**2, rel=1e-9)
        assert abs(run.floats(run.ledger.residual)) < 1e-14
        assert solve(scene.replace(until=start), arithmetic=arithmetic).final_energy == 0  # at its end it is not there


@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
def test_at_a_jump_of_the_belt_a_side_answers(arithmetic):
    belt = Force.constant("0.3") + Force.step("2.3", "-0.6")
    run = solve(Scene(Pair(2, "inf", 80, 3), State(), "2.4", belt=belt), arithmetic=arithmetic)
    for t in (run.events[-1].t, "2.3"):
        assert [float(run.floats(run.sol(t, side)[3])) for side in ("left", "right")] == [0.3, -0.3]


def test_a_pair_without_a_spring_has_no_excess_and_says_so():
    run = solve(SCENES["no-spring"])
    assert np.isnan(run.energy_excess).all()
    assert "excess" not in run.to_csv()
    assert run.final.v1 == run.y[1, -1]
