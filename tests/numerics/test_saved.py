"""Trajectories are equal if every number is, and come back from a pickle or a file to the last bit."""

import copy
import json
import pickle
from dataclasses import replace
from decimal import Decimal

import numpy as np
import pytest
from three_scenes import DAMPED, HOW, PAPER, STUCK

from numerics import Trajectory, load_scene, sensitivities, solve
from numerics.errors import InvalidFile


def runs(scene=PAPER):
    return [solve(scene, **how) for how in HOW if scene.pair.a1 == 0 or how.get("arithmetic") != "double-double"]


@pytest.mark.parametrize("scene", [PAPER, DAMPED, STUCK, load_scene("forced-friction-by-pieces")])
def test_what_was_pickled_or_saved_comes_back_to_the_last_bit_and_is_equal(scene, tmp_path):
    times = [0, Decimal("0.25"), "1/3", 0.5, 2]
    answers = [*runs(scene), solve(scene, t_eval=times), solve(scene, digits=20, t_eval=times)]
    answers.append(solve(replace(PAPER, until=solve(PAPER).events[2].t), arithmetic="float64"))
    assert not answers[-1].certain
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
    with np.load(path) as archive:
        header = json.loads(archive["header"].tobytes())
    for name, change in changes.items():
        header[name] = change(header[name]) if callable(change) else change
    np.savez(path, header=np.frombuffer(json.dumps(header).encode(), dtype=np.uint8))


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


def test_a_file_of_another_kind_is_no_trajectory(tmp_path):
    (tmp_path / "text").write_text("hello")
    with pytest.raises(InvalidFile, match="no NumPy archive, or not a whole one"):
        Trajectory.load(tmp_path / "text")
    with pytest.raises(FileNotFoundError, match="give a file that `save`"):
        Trajectory.load(tmp_path / "absent")
    np.savez(tmp_path / "other.npz", header=np.array([{}], dtype=object))  # a pickle
    with pytest.raises(InvalidFile):
        Trajectory.load(tmp_path / "other.npz")
