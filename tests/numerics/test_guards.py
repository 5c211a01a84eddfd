"""Caps that name themselves, phases that are lost and said to be, files that appear whole or not."""

import subprocess
import sys

import pytest
from interruption import interrupted
from three_scenes import PAPER

from numerics import OutOfRange, Pair, Scene, State, solve
from numerics.free.energy import energy_at

VALID = """[pair]
m1 = 1
m2 = 1
a1 = 0
a2 = 200
b = 0.5
[initial]
x1 = 0.005
v1 = 0.15
[run]
law = "filippov"
until = 1e22
"""


# caps


def test_digits_that_need_countless_steps_are_refused_at_once():
    with pytest.raises(OutOfRange, match=r"about .*e\+?\d+ events .*max_steps"):
        energy_at(PAPER, "1e1000", digits=1000)


# phases


def test_a_phase_lost_before_the_horizon_is_said():
    """Fig. 3's pair below E_cr: stuck for ever, but where on its orbit after 1e23 rad?"""
    scene = Scene(PAPER.pair, State(x1="0.003", v1="0.02", v2="-0.01"), until="1e22")
    how = {"arithmetic": "mpmath", "digits": 5}
    with pytest.raises(OutOfRange, match="ball"):
        solve(scene, arithmetic="float64")
    run = solve(scene, **how)
    assert run.phase_lost
    assert "keep no phase" in run.message
    truth = solve(scene, digits=15, arithmetic="ball")
    assert not truth.phase_lost
    with truth.arithmetic.context():
        assert float(run.reduced.final.w) == pytest.approx(float(truth.reduced.final.w.mid()), rel=1e-12)
    assert not solve(Scene(scene.pair, scene.initial, 5), **how).phase_lost


def test_the_orbit_of_a_damped_pair_needs_no_phase():
    run = solve(Scene(Pair(1, 1, 200, "0.5", a1="0.001"), State(x1="0.003"), until="1e22"))
    assert not run.phase_lost
    assert abs(run.y[0, -1]) < 1e-300


def test_a_damped_slip_of_1e22_radians_is_solved_in_balls_and_refused_by_floats():
    scene = Scene(Pair(1, 1, 200, "0.05", a1="1e-24"), State(x1="0.01", v2="1e20"), until="1e25")
    with pytest.raises(OutOfRange, match="steps"):
        solve(scene, max_events=3, arithmetic="float64")
    # a float of the wait and of its bound agree long before the wait is over: balls used to give up here
    balls = solve(scene, digits=30, arithmetic="ball", max_events=3)
    climbed = solve(scene, max_events=3)
    assert balls.modes == climbed.modes
    assert climbed.arithmetic.name == "ball"


def test_a_damped_slip_that_has_died_away_needs_no_phase():
    scene = Scene(Pair(1, 1, 200, "0.05", a1="1e-18"), State(x1="0.01", v2="1e20"), until="1e25")
    found, balls = solve(scene, max_events=3), solve(scene, digits=30, arithmetic="ball", max_events=3)
    assert found.modes == balls.modes
    assert found.y[0, 0].overlaps(balls.y[0, 0])


# files


def test_ctrl_c_while_solving_leaves_nothing(tmp_path):
    (tmp_path / "scene.toml").write_text(VALID)
    arguments = ["solve", "scene.toml", "--npz", "run.npz"]
    code, _, errors = interrupted("numerics", arguments, "flint", tmp_path)
    files = sorted(path.name for path in tmp_path.iterdir())
    assert (code, len(errors.splitlines()), files) == (130, 1, ["scene.toml"])
    assert errors.startswith("error: interrupted")


def test_ctrl_c_while_reporting_leaves_nothing(tmp_path):
    arguments = ["report", "--out", "out"]
    # not at its first module: mpmath, which it imports next, takes whatever happens then for a gmpy that is not there
    code, _, errors = interrupted("paper_checks", arguments, "sympy.core", tmp_path)
    assert (code, errors.splitlines(), list(tmp_path.iterdir())) == (130, ["error: interrupted"], [])


HALF_WRITTEN = {
    "npz": "from numerics.files import whole_file\n"
    "with whole_file(Path('result')) as file:\n    file.write(b'x' * 10**6); file.flush(); wait()",
    "renamed": "Path.replace = lambda *_: wait()\nfrom numerics.files import whole_file\n"
    "with whole_file(Path('result')) as file:\n    file.write(b'x' * 10**6)",
    "report": "Path.replace = lambda *_: wait()\nfrom paper_checks import atomic\n"
    "atomic.write(Path('result'), 'x' * 10**6)",
}


@pytest.mark.parametrize("where", HALF_WRITTEN)
def test_kill_in_mid_export_leaves_what_was_there(tmp_path, where):
    (tmp_path / "result").write_bytes(b"before")
    code = "import os, sys, time\nfrom pathlib import Path\ndef wait(): print('half', flush=True); time.sleep(60)\n"
    process = subprocess.Popen([sys.executable, "-c", code + HALF_WRITTEN[where]], cwd=tmp_path, stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"half\n"
    process.kill()
    process.communicate(timeout=20)
    assert (tmp_path / "result").read_bytes() == b"before"
