"""Trajectories are equal if every number is, and come back from a pickle or a file to the last bit."""

import copy
import json
import pickle
from decimal import Decimal

import numpy as np
import pytest
from archives import header_of, write_header
from three_scenes import DAMPED, HOW, PAPER, STUCK

from numerics import PlaneTrajectory, Trajectory, load_scene, sensitivities, solve
from numerics.errors import InvalidFile
from numerics.trajectory.run import free_scene


def runs(scene=PAPER):
    return [solve(scene, **how) for how in HOW if free_scene(scene) or how.get("arithmetic") != "mpmath"]


@pytest.mark.parametrize("scene", [PAPER, DAMPED, STUCK, load_scene("forced-friction-by-pieces")])
def test_what_was_pickled_or_saved_comes_back_to_the_last_bit_and_is_equal(scene, tmp_path):
    times = [0, Decimal("0.25"), "1/3", 0.5, 2]
    answers = [*runs(scene), solve(scene, t_eval=times), solve(scene, digits=20, t_eval=times)]
    for one in answers:
        one.save(tmp_path / "run.npz")
        for back in (Trajectory.load(tmp_path / "run.npz"), pickle.loads(pickle.dumps(one)), copy.deepcopy(one)):
            assert back == one
            assert (repr(back), back.scene, back.modes) == (repr(one), one.scene, one.modes)
            with one.arithmetic.context():
                texts = ([one.arithmetic.text(a, 60) for a in run.y.flat] for run in (back, one))
                assert next(texts) == next(texts)
            assert [str(a) for a in back.sol("0.1")] == [str(a) for a in one.sol("0.1")]
    balls = solve(DAMPED, digits=40)
    assert str(sensitivities(copy.copy(balls)).final) == str(sensitivities(balls).final)
    assert solve(scene) == solve(scene)
    assert [path.name for path in tmp_path.iterdir()] == ["run.npz"]


def spoilt(path, **changes):
    """Change entries of the header of a saved trajectory, some by functions."""
    header = json.loads(header_of(path))
    for name, change in changes.items():
        header[name] = change(header[name]) if callable(change) else change
    write_header(path, json.dumps(header))


@pytest.mark.parametrize(
    "changes",
    [
        {"format": "another"},
        {"arithmetic": ["ball", 20]},
        {"how": 17},
        {"rest": [10**9, True, 0, 0, 0]},
        {"scene": "[pair]"},
        {"t_eval": [99]},
        {"rows": {"floats": ["", 0, 3]}},
        {"rows": lambda rows: [[np.nan] * rows["floats"][2]]},
    ],
)
def test_a_file_that_holds_no_trajectory_is_refused_in_a_sentence(tmp_path, changes):
    path = tmp_path / "run.npz"
    solve(PAPER).save(path)
    spoilt(path)
    assert Trajectory.load(path).success
    spoilt(path, **changes)
    with pytest.raises(InvalidFile, match="holds no saved trajectory") as refused:
        Trajectory.load(path)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "text",
    [
        b"[" * 200_000,
        b"{}",
        b"7",
        b"\xff\xfe",
        b'{"format": "inertial-pair trajectory 4"}',
        b'{"ball": ["0x1", ' + b"9" * 300 + b', "0x0", 0]}',
        b'{"ratio": ["0x1", "0x0"]}',
        b'{"floats": ["AAAA", 1000000000000]}',
    ],
)
def test_what_somebody_wrote_is_refused_in_a_sentence(tmp_path, text):
    write_header(tmp_path / "run.npz", text)
    with pytest.raises(InvalidFile, match=r"holds no saved trajectory: .*; give a file that `save`"):
        Trajectory.load(tmp_path / "run.npz")


@pytest.mark.parametrize(("scene", "kind"), [(PAPER, Trajectory), (load_scene("plane-box"), PlaneTrajectory)])
def test_a_file_in_which_a_byte_was_changed_or_is_missing_is_refused_or_holds_the_same_run(tmp_path, scene, kind):
    path, other = tmp_path / "run.npz", tmp_path / "other.npz"
    run = solve(scene, max_events=2)
    run.save(path)
    whole = path.read_bytes()
    assert kind.load(path) == run
    changed = [whole[:k] + bytes([whole[k] ^ 8]) + whole[k + 1 :] for k in range(0, len(whole), 1 + len(whole) // 200)]
    refused = 0
    for wrong in [*changed, *(whole[:k] for k in range(0, len(whole), 1 + len(whole) // 60))]:
        other.write_bytes(wrong)
        try:
            assert kind.load(other) == run  # of what the archive says twice, once may be changed
        except InvalidFile:
            refused += 1
    assert refused > len(changed) // 2


def test_a_run_is_saved_under_no_name_of_another_kind_of_file(tmp_path):
    with pytest.raises(ValueError, match=r"end it in .npz, or write to_csv\(\) to it"):
        solve(PAPER).save(tmp_path / "run.csv")


def test_a_file_of_another_kind_is_no_trajectory(tmp_path):
    (tmp_path / "text").write_text("hello")
    with pytest.raises(InvalidFile, match="holds no saved trajectory"):
        Trajectory.load(tmp_path / "text")
    with pytest.raises(FileNotFoundError, match="give a file that `save`"):
        Trajectory.load(tmp_path / "absent")
    np.savez(tmp_path / "other.npz", header=np.array([{}], dtype=object))  # a pickle
    with pytest.raises(InvalidFile):
        Trajectory.load(tmp_path / "other.npz")
