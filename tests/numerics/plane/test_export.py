"""A motion on a surface in files: saved and read again, CSV with units, arrays, data frame, film, and the commands."""

import csv
import io
import json
import pickle
from fractions import Fraction

import numpy as np
import pytest
from archives import header_of, write_header

from numerics import load_scene, solve
from numerics.__main__ import main
from numerics.errors import InvalidFile, InvalidScene
from numerics.plane.trajectory import PlaneTrajectory
from numerics.scene.file import parse_scene, scene_text
from numerics.scene.plane import PlanePair, PlaneScene
from numerics.trajectory.trajectory import Trajectory

PAIR = PlanePair(1, 1, [200, 120], ["0.5", "0.3"], shape="box")
APART = PlaneScene(PAIR, 2, x1=["0.012", 0], v1=["0.1", "-0.2"], x2=[0, "1/3"])
"""A box without couplings: two motions of the line, which their own archives keep."""
PARTLY = PlaneScene(
    PlanePair(1, 1, [[200, 0, 60], [0, 90, 0], [60, 0, 120]], "0.5", shape="box"), 2, x1="0.01", v1="0.1", x2=[1, 2, 3]
)
"""A box in two parts: a motion of the line, and one along a path."""
ROUND = PlaneScene(PlanePair(1, 1, 200, "0.5"), 2, v1=["0.06", "0.01"])
SCENES = [load_scene("plane-box"), APART, ROUND]


@pytest.fixture(scope="module")
def turning() -> PlaneTrajectory:
    """Three axes, one of them an angle."""
    return solve(load_scene("plane-slip-turns"))


@pytest.mark.parametrize("scene", [*SCENES, load_scene("plane-slip-turns"), load_scene("plane-rotating-force")])
def test_a_scene_is_written_as_the_text_of_the_same_scene(scene):
    assert parse_scene(scene_text(scene)) == scene


@pytest.mark.parametrize(
    ("scene", "asked"), [(SCENES[0], {}), (APART, {"digits": 12}), (PARTLY, {}), (SCENES[2], {"t_eval": [0, "1/3"]})]
)
def test_what_was_saved_comes_back_to_the_last_bit(scene, asked, tmp_path):
    run = solve(scene, **asked)
    run.save(tmp_path / "run.npz")
    again = PlaneTrajectory.load(tmp_path / "run.npz")
    assert again == run == pickle.loads(pickle.dumps(run))
    assert (again.record(), repr(again), again.tried) == (run.record(), repr(run), run.tried)
    for t in (0, "1/3", 1.25, scene.until):
        with run.context():
            assert all(x.mid() == y.mid() and x.rad() == y.rad() for x, y in zip(run.sol(t), again.sol(t), strict=True))
    assert again != solve(scene, digits=13)


def test_what_is_no_such_file_is_refused(tmp_path):
    run, path = solve(SCENES[0]), tmp_path / "run.npz"
    solve(load_scene("velocities")).save(path)
    with pytest.raises(InvalidFile, match="its format is 'inertial-pair trajectory 4'"):
        PlaneTrajectory.load(path)
    run.save(path)
    with pytest.raises(InvalidFile, match="surface trajectory 4'"):
        Trajectory.load(path)
    text = header_of(path)
    for right, wrong in (
        ('"legs": [[', '"legs": [7, ['),
        ('"ball", ', '"mpmath", '),
        ('shape = \\"box\\"', 'shape = \\"star\\"'),
        ('"mode": ', '"start": '),
    ):
        assert right in text
        write_header(path, text.replace(right, wrong, 1))
        with pytest.raises(InvalidFile, match="holds no saved trajectory"):
            PlaneTrajectory.load(path)


def test_a_table_has_a_column_for_each_axis_with_its_unit(turning):
    head, *rows = csv.reader(io.StringIO(turning.to_csv()))
    numbers = [name for name in head if "_radius" not in name]
    assert numbers[2:7] == ["t (s)", "cause", "x1_x (m)", "x1_y (m)", "x1_phi (rad)"]
    assert {"v2_phi (rad/s)", "direction_y", "load_x (N)", "load_phi (N m)", "energy (J)"} <= set(head)
    record = turning.record()
    assert len(rows) == len(record["events"]) + 1
    assert rows[-1][head.index("x2_y (m)")] == record["final"]["x2"][1]
    assert rows[0][head.index("load_x (N)")] == record["events"][0]["load"][0]


def test_arrays_and_data_frame_have_the_numbers_of_the_run(turning, tmp_path, capsys):
    frame = turning.to_dataframe()
    assert [*frame["mode"]] == [*turning.modes, turning.final_mode]
    assert [*frame["x1_phi"]] == [*turning.floats(turning.y[2])]
    assert turning.mode_at([0, 1]) == [turning.modes[0], turning.final_mode]
    assert main(["solve", "plane-slip-turns", "--npz", str(tmp_path / "run.npz")]) == 0
    with np.load(tmp_path / "run.npz") as found:
        assert np.array_equal(found["y"], turning.floats(turning.y))
        assert [*found["modes"]] == [*turning.modes]
    assert main(["solve", "plane-slip-turns", "--csv", "--explain"]) == 0
    told = capsys.readouterr()
    assert told.out == turning.to_csv()
    assert "working digits" in told.err


@pytest.mark.parametrize(
    "flags", ["--proof F.v", "--sensitivity --json", "--arithmetic mpmath", "--arithmetic float64"]
)
def test_what_only_a_line_has_is_refused_in_a_sentence(flags, capsys):
    assert main(["solve", "plane-circle-merges", *flags.split()]) == 2
    assert "is available on a line only" in capsys.readouterr().err


def test_a_run_that_was_cut_off_is_drawn_to_its_end():
    run = solve(load_scene("plane-slip-turns"), max_events=1)
    assert run.plot().lines[-1].get_xydata()[0] == pytest.approx(run.floats(run.y[6:8, -1]))
    end = float(run.end_time.mid())
    assert abs(run.floats(run.sol(end) - run.y[:, -1])).max() < 1e-6
    with pytest.raises(ValueError, match="is outside the solved time"):
        run.sol(end + 1e-5)


def test_a_scene_that_no_file_holds_is_compared_and_pickled_all_the_same():
    run = solve(PlaneScene(ROUND.pair, 2, v1=[Fraction(6, 100) + Fraction(1, 7**1500), "0.01"]))
    assert pickle.loads(pickle.dumps(run)) == run
    with pytest.raises(InvalidScene, match="at most 1000 are read"):
        run.save("run.npz")


def test_it_is_drawn_and_filmed(turning, tmp_path):
    assert turning.plot("relative").lines
    turning.animate(tmp_path / "run.gif", duration=0.2, frames_per_second=10)
    assert (tmp_path / "run.gif").read_bytes()[:3] == b"GIF"
    with pytest.raises(ValueError, match="is not one of above, relative"):
        turning.plot("velocities")
    assert json.loads(json.dumps(turning.record())) == turning.record()
