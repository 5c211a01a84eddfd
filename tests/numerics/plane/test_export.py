"""A motion on a surface in files: saved and read again, CSV with units, arrays, data frame, film, and the commands."""

import csv
import io
import json

import numpy as np
import pytest

from numerics import load_scene, solve
from numerics.plane.trajectory import PlaneTrajectory
from numerics.scene.file import parse_scene, scene_text, shipped_scenes
from numerics.scene.plane import PlanePair, PlaneScene


@pytest.fixture(scope="module")
def turning() -> PlaneTrajectory:
    """Three axes, one of them an angle."""
    return solve(load_scene("plane-slip-turns"))


@pytest.mark.parametrize("name", [name for name in shipped_scenes() if name.startswith("plane-")])
def test_a_scene_is_written_as_the_text_of_the_same_scene_and_solved(name):
    scene = load_scene(name)
    assert parse_scene(scene_text(scene)) == scene
    assert (solve(scene).success, solve(scene).digits) == (True, 15)


def test_arrays_and_tuples_are_read_as_lists():
    pair = PlanePair(m1=np.array([1.0, 0.1]), m2=(1, 1), a2=np.diag([200, 120]), b="0.5")
    assert pair == PlanePair(m1=[1, "0.1"], m2=1, a2=[200, 120], b=["0.5", "0.5"])
    assert PlaneScene(pair, 1, x1=np.zeros(2)) == PlaneScene(pair, 1)


def test_a_table_has_a_column_for_each_axis_with_its_unit(turning):
    head, *rows = csv.reader(io.StringIO(turning.to_csv()))
    numbers = [name for name in head if "_radius" not in name]
    assert numbers[2:7] == ["t (s)", "cause", "x1_x (m)", "x1_y (m)", "x1_phi (rad)"]
    assert {"v2_phi (rad/s)", "direction_y", "load_x (N)", "load_phi (N m)", "energy (J)"} <= {*head}
    record = turning.record()
    assert len(rows) == len(record["events"]) + 1
    assert rows[-1][head.index("x2_y (m)")] == record["final"]["x2"][1]
    assert rows[0][head.index("load_x (N)")] == record["events"][0]["load"][0]


def test_arrays_and_data_frame_have_the_numbers_of_the_run(turning, tmp_path, run):
    frame = turning.to_dataframe()
    assert [*frame["mode"]] == [*turning.modes, turning.final_mode]
    assert [*frame["x1_phi"]] == [*turning.floats(turning.y[2])]
    assert turning.mode_at([0, 1]) == [turning.modes[0], turning.final_mode]
    assert run("solve", "plane-slip-turns", "--npz", tmp_path / "run.npz")[0] == 0
    with np.load(tmp_path / "run.npz") as found:
        assert np.array_equal(found["y"], turning.floats(turning.y))
        assert [*found["modes"]] == [*turning.modes]
    code, out, told = run("solve", "plane-slip-turns", "--csv", "--explain")
    assert (code, out, "working digits" in told) == (0, turning.to_csv(), True)


def test_a_run_that_was_cut_off_is_drawn_to_its_end():
    run = solve(load_scene("plane-slip-turns"), max_events=1)
    assert run.plot().lines[-1].get_xydata()[0] == pytest.approx(run.floats(run.y[6:8, -1]))
    end = float(run.end_time.mid())
    assert abs(run.floats(run.sol(end) - run.y[:, -1])).max() < 1e-6
    with pytest.raises(ValueError, match="is outside the solved time"):
        run.sol(end + 1e-5)


def test_it_is_drawn_and_filmed(turning, tmp_path):
    assert turning.plot("relative").lines
    turning.animate(tmp_path / "run.gif", duration=0.2, frames_per_second=10)
    assert (tmp_path / "run.gif").read_bytes()[:3] == b"GIF"
    assert json.loads(json.dumps(turning.record())) == turning.record()
