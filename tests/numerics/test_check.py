"""`run.check()`: a true run passes; a number, an event or a mode that is falsified is found and named."""

import json
from dataclasses import replace

import numpy as np
import pytest

from numerics import Pair, Scene, Signal, State, Trajectory, load_scene, solve, solve_scenes
from numerics.linear.record import AT

RUN = solve(load_scene("velocities"))
"""24 events in float64."""


def falsified(row, **changed):
    """The run with other numbers in a row of its record."""
    rows = RUN.record.rows.copy()
    for name, value in changed.items():
        rows[row, AT[name]] = value
    return Trajectory(RUN.scene, RUN.arithmetic, RUN.record._replace(rows=rows))


BELT = Signal.sine("0.4", "6.28")
SCENES = {
    name: load_scene(name)
    for name in ("velocities", "start-at-6mm-literal", "forced-sweep", "forced-friction-by-pieces")
} | {
    "a block pushed on the ground": Scene(Pair(1, "inf", 0, 2), State(), 3, force=Signal.samples([0, 1, 2], [0, 5, 0])),
    "a belt that shakes": Scene(Pair(5, "inf", 20, 5), State(), 5, belt=BELT),  # v2 is off by the rounding of t
}


@pytest.mark.parametrize("how", [{}, {"arithmetic": "ball", "digits": 20}])
@pytest.mark.parametrize("name", SCENES)
def test_a_true_run_passes(name, how):
    run = solve(SCENES[name], **how)
    found, quantities = run.check(), {"x1", "v1", "x2", "v2", "energy", "dissipated"}
    assert (found.right, found.difference, found.events) == (True, None, len(run.events))
    assert all(one.error <= one.bound for one in found.off if one.bound is not None)
    quantities |= {"t"} if found.events else set()
    assert quantities | ({"energy_excess"} if run.scene.pair.a2 else set()) <= {one.quantity for one in found.off}
    assert run.arithmetic.digits < 100


@pytest.mark.parametrize("name", SCENES)
def test_many_scenes_have_the_right_digits_of_one(name):
    found, run = solve_scenes([SCENES[name]] * 2, jobs=1), solve(SCENES[name])
    assert found.success.all()
    assert found.digits.min() > 8
    assert found.energy_excess == pytest.approx([run.energy_excess[-1]] * 2, rel=1e-9, nan_ok=True)


def test_many_scenes_have_no_excess_where_a_wall_moves():
    scene = Scene(Pair(1, 1, 200, "0.5"), State(), 1, wall=Signal.sine("0.01", 5))
    found = solve_scenes([scene, RUN.scene], jobs=1)
    assert np.isnan([found.energy_excess, found.energy_excess_error]).tolist() == [[True, False]] * 2


def test_without_bounds_it_says_what_numbers_are_off_by():
    found = solve(RUN.scene, arithmetic="mpmath", digits=20).check()
    assert found.right
    assert {one.bound for one in found.off} == {None}
    assert 0 < max(one.error for one in found.off) < 1e-18


@pytest.mark.parametrize("name", ["x1", "v1", "x2", "v2"])
def test_a_falsified_number_is_named_with_its_event(name):
    """A row's state is that of its event; what is a little off is beyond the bound, and less is not."""
    row = int(RUN.event_rows[6])
    number = RUN.record.rows[row, AT[name]]
    found = falsified(row, **{name: number + 1e-9}).check()
    worst = next(one for one in found.off if one.quantity == name)
    assert not found.right
    assert (worst.event, worst.within) == (7, False)
    assert worst.error == pytest.approx(1e-9, rel=1e-3)
    assert f"off by more than the bound: {name}" in str(found)
    assert [one.quantity for one in found.off if not one.within and one.event == 7] == [name]


def test_a_falsified_time_and_a_bound_that_is_too_small_are_named():
    late = falsified(int(RUN.event_rows[2]), local=RUN.event_times[2] + 1e-9).check()
    assert [(one.quantity, one.event) for one in late.off if not one.within][:1] == [("t", 3)]
    said = replace(RUN.accuracy, y=RUN.accuracy.y * 1e-9)
    proud = RUN.but()
    proud.__dict__["accuracy"] = said
    assert [one.quantity for one in proud.check().off if not one.within] == ["x1", "v1", "x2", "v2"]


def test_a_falsified_mode_is_the_first_event_that_differs():
    found = falsified(int(RUN.event_rows[4]), mode=1 - abs(RUN.signs[5])).check()
    assert (found.difference.event, found.difference.t) == (5, RUN.event_times[4])
    assert found.difference.mode != found.difference.true_mode == RUN.modes[5].value
    assert str(found.difference) in str(found)
    assert not found.right
    assert {one.quantity for one in found.off} == {"t", "x1", "v1", "x2", "v2"}
    assert all(one.within for one in found.off)
    assert json.loads(json.dumps(found.to_dict()))["difference"]["event"] == 5


def test_where_the_first_event_is_wrong_nothing_is_compared():
    found = falsified(int(RUN.event_rows[0]), mode=1 - abs(RUN.signs[1])).check()
    assert found.off == ()
    assert "the sequence of events is wrong: event 1 differs" in str(found)
    assert "no number could be compared" in str(found)


def test_a_lost_event_and_an_invented_one_are_named():
    """The rows of a run over 3 s said to be those of 5 s, and the other way round."""
    early = Scene(RUN.scene.pair, RUN.scene.initial, 3)
    lost = Trajectory(RUN.scene, RUN.arithmetic, solve(early).record).check().difference
    invented = Trajectory(early, RUN.arithmetic, RUN.record).check().difference
    assert lost.event == invented.event == len(solve(early).events) + 1
    assert (lost.t, lost.mode) == (invented.true_t, invented.true_mode) == (None, None)
    assert lost.true_t == pytest.approx(invented.t) == pytest.approx(RUN.event_times[lost.event - 1])
    assert "no such event; in truth" in str(lost)


def test_a_run_that_was_cut_off_is_held_against_as_many_events():
    found = solve(RUN.scene, max_events=10).check()
    assert found.right
    assert found.events == 10


def test_the_command_prints_it(run, record):
    assert record("solve", "velocities", "--check")["right"] is True
    code, out, _ = run("solve", "velocities", "--check")
    assert code == 0
    assert "really off by" in out
    assert run("solve", "velocities", "--check", "--csv")[0] == 2
