"""Caps that name themselves, phases that are lost and said to be, files that appear whole or not."""

import subprocess
import sys

import pytest
from interruption import interrupted
from three_scenes import PAPER

from numerics import OutOfRange, Pair, Scene, State, solve


def test_a_phase_lost_before_the_horizon_is_said():
    """Fig. 3's pair below E_cr: stuck for ever, but where on its orbit after 1e23 rad?"""
    scene, how = PAPER.replace(x1="0.003", v1="0.02", v2="-0.01", until="1e22"), {"arithmetic": "mpmath", "digits": 5}
    with pytest.raises(OutOfRange, match="ball"):
        solve(scene, arithmetic="float64")
    run, truth = solve(scene, **how), solve(scene, digits=15, arithmetic="ball")
    assert (run.phase_lost, "keep no phase" in run.message, truth.phase_lost) == (True, True, False)
    assert float(run.reduced.final.w) == pytest.approx(truth.floats(truth.reduced.final.w), rel=1e-12)
    assert not solve(scene.replace(until=5), **how).phase_lost


def test_the_orbit_of_a_damped_pair_needs_no_phase():
    run = solve(Scene(Pair(1, 1, 200, "0.5", a1="0.001"), State(x1="0.003"), until="1e22"))
    assert not run.phase_lost
    assert abs(run.y[0, -1]) < 1e-300


@pytest.mark.parametrize("a1", ["1e-24", "1e-18"])
def test_a_damped_slip_of_1e22_radians_is_solved_in_balls(a1):
    """Also where it has died away. In one a float of the wait and its bound agree long before the wait is over."""
    scene = Scene(Pair(1, 1, 200, "0.05", a1=a1), State(x1="0.01", v2="1e20"), until="1e25")
    balls, found = solve(scene, digits=30, arithmetic="ball", max_events=3), solve(scene, max_events=3)
    assert (found.modes, found.arithmetic.name) == (balls.modes, "ball")
    assert found.y[0, 0].overlaps(balls.y[0, 0])


@pytest.mark.parametrize(
    ("program", "words", "module", "said"),
    [
        ("numerics", "solve velocities --npz run.npz", "flint", "error: interrupted"),
        # not at its first module: mpmath, which it imports next, takes whatever happens then for a gmpy not there
        ("paper_checks", "report --out out", "sympy.core", "paper_checks: interrupted"),
    ],
)
def test_ctrl_c_leaves_nothing(tmp_path, program, words, module, said):
    code, _, errors = interrupted(program, words.split(), module, tmp_path)
    assert (code, len(errors.splitlines()), list(tmp_path.iterdir())) == (130, 1, [])
    assert errors.startswith(said)


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
