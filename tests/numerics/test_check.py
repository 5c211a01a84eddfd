"""`run.check()`: a true run passes; a number, an event or a mode that is falsified is found and named."""

import json

import pytest
from scene_files import scenes_in

from numerics import Trajectory, load_scene, solve
from numerics.linear.record import AT
from numerics.trajectory.columns import STATE
from numerics.trajectory.export import bounds_at


@pytest.fixture(scope="module")
def own():
    """24 events in float64."""
    return solve(load_scene("velocities"))


def falsified(own, event, **changed):
    """The run with other numbers in the row of an event."""
    rows = own.record.rows.copy()
    for name, value in changed.items():
        rows[own.event_rows[event], AT[name]] = value
    return Trajectory(own.scene, own.arithmetic, own.record._replace(rows=rows))


SCENES = {
    name: load_scene(name)
    for name in ("velocities", "start-at-6mm-literal", "forced-sweep", "forced-friction-by-pieces", "newmark-block")
} | {"v2 of a belt": scenes_in("belts")["off-by-the-rounding-of-t"]}


@pytest.mark.parametrize("how", [{}, {"arithmetic": "ball", "digits": 20}, {"max_events": 10}])
@pytest.mark.parametrize("name", SCENES)
def test_a_true_run_passes(name, how):
    run = solve(SCENES[name], **how)
    found, quantities = run.check(), {"x1", "v1", "x2", "v2", "energy", "dissipated"}
    assert (found.right, found.difference, found.events) == (True, None, len(run.events))
    assert all(one.error <= one.bound for one in found.off if one.bound is not None)
    quantities |= {"t"} if found.events else set()
    assert quantities | ({"energy_excess"} if run.scene.pair.a2 else set()) <= {one.quantity for one in found.off}
    assert run.arithmetic.digits < 100


def test_without_bounds_it_says_what_numbers_are_off_by():
    found = solve(load_scene("velocities"), arithmetic="mpmath", digits=20).check()
    assert found.right
    assert {one.bound for one in found.off} == {None}
    assert 0 < max(one.error for one in found.off) < 1e-18


@pytest.mark.parametrize("place", range(5))
def test_a_falsified_number_is_named_with_its_event(own, place):
    """A row's state is that of its event; 1.5 times its bound is beyond it."""
    by, column = 1.5 * bounds_at(own, 6)[place], ("local", *STATE)[place]
    name = column.replace("local", "t")
    found = falsified(own, 6, **{column: own.record.rows[own.event_rows[6], AT[column]] + by}).check()
    worst = next(one for one in found.off if one.quantity == name)
    assert not found.right
    assert (worst.event, worst.within) == (7, False)
    assert worst.error == pytest.approx(by, rel=0.3)
    assert f"off by more than the bound: {name}" in str(found)
    assert [one.quantity for one in found.off if not one.within and one.event == 7] == [name]


@pytest.mark.parametrize("event", [1, 5])
def test_a_falsified_mode_is_the_first_event_that_differs_and_only_what_is_before_it_is_compared(own, event):
    found = falsified(own, event - 1, mode=1 - abs(own.signs[event])).check()
    assert (found.right, found.difference.event, found.difference.t) == (False, event, own.event_times[event - 1])
    assert found.difference.mode != found.difference.true_mode == own.modes[event].value
    assert str(found.difference) in str(found)
    assert {(one.quantity, one.within) for one in found.off} == {
        (one, True) for one in ("t", *STATE)[: 9 * (event > 1)]
    }
    assert ("no number could be compared" in str(found)) is (event == 1)
    assert json.loads(json.dumps(found.to_dict()))["difference"]["event"] == event


def test_a_lost_event_and_an_invented_one_are_named(own):
    """The rows of a run over 3 s said to be those of 5 s, and the other way round."""
    early = own.scene.replace(until=3)
    lost = Trajectory(own.scene, own.arithmetic, solve(early).record).check().difference
    invented = Trajectory(early, own.arithmetic, own.record).check().difference
    assert lost.event == invented.event == len(solve(early).events) + 1
    assert (lost.t, lost.mode) == (invented.true_t, invented.true_mode) == (None, None)
    assert lost.true_t == pytest.approx(invented.t) == pytest.approx(own.event_times[lost.event - 1])
    assert "no such event; in truth" in str(lost)


def test_the_command_prints_it(own, run, record, monkeypatch):
    assert record("solve", "velocities", "--check")["right"] is True
    wrong = falsified(own, 6, x1=9.0).check()
    monkeypatch.setattr(Trajectory, "check", lambda _: wrong)
    assert run("solve", "velocities", "--check")[:2] == (1, f"{wrong}\n")
