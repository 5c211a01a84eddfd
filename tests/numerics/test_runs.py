"""Runs on a line, in every arithmetic, and on a surface answer in the same words: SciPy's; tables and pictures."""

import csv
import io
import json

import numpy as np
import pytest
from flint import arb
from matplotlib import pyplot as plt
from PIL import Image
from scene_files import scenes_in
from three_scenes import HOW, PAPER

from numerics import (
    PlanePair,
    PlaneScene,
    load_scene,
    scene_text,
    sensitivities,
    solve,
)
from numerics.linear.modes import EventKind
from numerics.scene.file import parse_scene, shipped_scenes
from numerics.trajectory.columns import STATE

FAR_OUT, SURFACE = scenes_in("far-out"), load_scene("plane-slip-turns")
"""Three axes, one of them an angle."""
RUNS = {f"line {how}": (PAPER, how) for how in HOW}
RUNS |= {f"surface {how}": (SURFACE, how) for how in ({}, {"max_events": 1})}
SIZES = {
    PAPER: ([""], "positions", "x1 (m), v2 (m/s), energy_excess"),
    SURFACE: (["_x", "_y", "_phi"], "above", "x1_x (m), x1_phi (rad), v2_phi (rad/s), direction_y, load_y (N)"),
}
"""What an axis adds to a name; a picture; columns of a table."""


@pytest.fixture(scope="module", params=RUNS)
def solved(request):
    scene, how = RUNS[request.param]
    return solve(scene, **how)


def test_shapes_are_those_of_scipy_and_the_columns_of_y_are_sol_at_t(solved):
    k, rows = len(solved.events), 4 * len(SIZES[solved.scene][0])
    m = k + 1 + solved.success
    assert (solved.t.shape, solved.energy.shape, solved.y.shape) == ((m,), (m,), (rows, m))
    assert (len(solved.modes), solved.final_mode) == (m - 1, solved.events[-1].after)
    for kind, times, states in zip(EventKind, solved.t_events, solved.y_events, strict=True):
        assert (len(times), rows) == (solved.event_kinds.count(kind), rows) == states.shape
    assert [*map(str, solved["x2"].flat)] == [*map(str, solved.y[rows // 2 : 3 * rows // 4].flat)]
    with solved.context():
        assert abs(solved.floats(solved.sol(solved.t) - solved.y)).max() < 1e-14
        if solved.arithmetic.name == "ball":
            assert all(one.overlaps(two) for one, two in zip(solved.sol(solved.t).flat, solved.y.flat, strict=True))


def test_times_asked_for_may_be_any_numbers_in_arrays_of_any_shape(solved):
    end, rows = solved.arithmetic.to_float(solved.end_time), len(solved.y)
    asked, times = [0, "1/300", end / 2, end], np.linspace(0, end, 40)[:6].reshape(2, 3)
    run = solved.but(t_eval=asked)
    assert run.floats(run.t) == pytest.approx([0, 1 / 300, end / 2, end])
    assert [*map(str, run.y.flat)] == [*map(str, run.sol(asked).flat)]
    assert (run.energy.shape, run.sol([]).shape, run.sol(times).shape) == ((4,), (rows, 0), (rows, 2, 3))
    assert [*map(str, run.sol(times)[:, 1, 2])] == [*map(str, run.sol(times[1, 2]))]
    assert [*run.mode_at(run.event_times, "left")] == [event.before for event in run.events]
    assert [*run.mode_at(run.event_times)] == [*map(run.mode_at, run.event_times)] == [one.after for one in run.events]
    if rows == 4:
        assert sensitivities(solved, times[:, :2]).shape == (4, 9, 2, 2)


def test_it_shows_itself_in_a_few_short_lines_and_calls_right_only_digits_that_something_bounds(solved):
    lines = repr(solved).splitlines()
    names = [line.split(":")[0].strip() for line in lines]
    assert names == ["message", "success", "status", "arithmetic", "events", "t", "final mode"]
    assert all(len(line) < 120 for line in lines)
    assert ("right digits" in lines[3]) is (solved.arithmetic.name != "mpmath")
    assert solved._repr_html_().startswith("<table><caption>")


def test_tables_have_start_events_and_end_and_a_column_for_each_axis_with_its_unit(solved):
    frame, head = solved.to_dataframe(), next(csv.reader(io.StringIO(solved.to_csv())))
    names = [f"{name}{axis}" for name in STATE for axis in SIZES[solved.scene][0]]
    assert [*frame.columns] == ["t", "mode", *names, *solved.ENERGIES]
    assert [*frame["mode"]] == [*map(str, (*solved.modes[: len(frame) - 1], solved.final_mode))]
    assert np.array_equal(frame[names].to_numpy().T, solved.floats(solved.y))
    assert {*SIZES[solved.scene][2].split(", ")} <= {*head}
    if solved.scene is SURFACE:
        record, rows = solved.record(), [*csv.DictReader(io.StringIO(solved.to_csv()))]
        assert json.loads(json.dumps(record)) == record
        assert rows[-1]["x2_y (m)"] == record["final"]["x2"][1]
        assert rows[0]["load_phi (N m)"] == record["events"][0]["load"][2]


@pytest.mark.parametrize("name", [name for name in RUNS if "max_events" in name])
def test_a_run_that_was_cut_off_is_drawn_and_filmed_to_its_end(name, tmp_path):
    scene, how = RUNS[name]
    run = solve(scene, **how)
    last = run.plot(SIZES[scene][1]).lines[1 if scene is PAPER else -1].get_xdata()[-1]
    assert last == pytest.approx(run.floats(run.end_time if scene is PAPER else run.y[6, -1]).item())
    run.animate(tmp_path / "run.gif", duration=0.3, frames_per_second=10)
    with Image.open(tmp_path / "run.gif") as film:
        assert film.n_frames == 3
    plt.close("all")


def test_a_cap_that_is_not_reached_changes_nothing():
    count = len(solve(PAPER).events)
    assert [solve(PAPER, max_events=count - k).success for k in (0, 1)] == [True, False]


@pytest.mark.parametrize("name", [name for name in shipped_scenes() if name.startswith("plane-")])
def test_a_scene_on_a_surface_is_written_as_the_text_of_the_same_scene_and_solved(name):
    scene = load_scene(name)
    assert (parse_scene(scene_text(scene)), solve(scene).success, solve(scene).digits) == (scene, True, 15)


def test_arrays_and_tuples_are_read_as_lists():
    pair = PlanePair(m1=np.array([1.0, 0.1]), m2=(1, 1), a2=np.diag([200, 120]), b="0.5")
    assert pair == PlanePair(m1=[1, "0.1"], m2=1, a2=[200, 120], b=["0.5", "0.5"])
    assert PlaneScene(pair, 1, x1=np.zeros(2)) == PlaneScene(pair, 1)


# balls of times, long sticks, progress


@pytest.mark.parametrize("name", ["forced-friction-by-pieces", "velocities"])
def test_what_is_said_of_a_ball_of_times_holds_what_is_said_of_each(name):
    run = solve(load_scene(name), digits=20, arithmetic="ball")
    with run.arithmetic.context():
        for t in run.event_times:
            for middle in (-0.003, 0, 0.003):
                wide = run.sol(t + middle + arb(0, 0.01))
                for by in (-0.006, 0.006):
                    assert all(one.contains(two) for one, two in zip(wide, run.sol(t.mid() + by), strict=True))


@pytest.mark.parametrize("scene", [load_scene("forced-sine-stick-slip"), scenes_in("followed-in-balls")["weakened"]])
def test_what_is_lost_over_a_ball_of_times_holds_what_is_lost_up_to_each(scene):
    run = solve(scene, digits=20, arithmetic="ball")
    with run.context():
        for row, length in enumerate(run.row_lengths[:3]):
            wide, *inside = run.row_taken(
                [row] * 4, [length / 2 + arb(0, 1) * length / 4, *(length * k / 10 for k in (3, 5, 7))]
            ).T
            assert all(one.contains(two) for taken in inside for one, two in zip(wide, taken, strict=True))


def test_a_stick_of_thousands_of_turns_keeps_its_ledger():
    run = solve(FAR_OUT["a-stick-of-thousands-of-turns"], digits=20, arithmetic="ball")
    with run.context():
        residual, lost = run.ledger.residual, run.dissipated
        assert residual.contains(0)
        assert residual.rad() < lost * 1e-18
        assert all(one.rad() < 1e-35 for one in run.sol(2999))


def test_progress_is_told():
    told = []
    solve(FAR_OUT["a-sequence-of-thousands"], progress=lambda n, part: told.append((n, part)))
    assert told
    assert np.all(np.diff(told, axis=0) > 0)
