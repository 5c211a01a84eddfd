"""Caps that name themselves, phases that are lost and said to be, files that appear whole or not."""

import json
import random
import re
import subprocess
import sys
import time
from fractions import Fraction

import pytest
from interruption import interrupted

from numerics.__main__ import main
from numerics.errors import EventUndecided, InvalidScene, OutOfRange, PrecisionExhausted
from numerics.free.energy import energy_at
from numerics.scene import Pair, Scene, State
from numerics.scene.file import parse_scene
from numerics.solver.solve import solve
from numerics.trajectory.status import Status

PAPER = Scene(Pair(1, 1, 200, "0.5"), State(v1="0.15"), until=3)
REPORT = [sys.executable, "-m", "paper_checks", "report"]
SOLVE = [sys.executable, "-m", "numerics", "solve"]
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


@pytest.mark.parametrize("arithmetic", ["ball", "mpmath"])
def test_the_cap_on_digits_names_its_argument_at_once(arithmetic):
    began = time.thread_time()
    with pytest.raises(PrecisionExhausted, match="raise the cap max_digits"):
        solve(PAPER, arithmetic=arithmetic, digits=10**8)
    with pytest.raises(PrecisionExhausted, match="raise the cap max_digits"):
        solve(PAPER, arithmetic=arithmetic, digits=100, max_digits=50)
    assert time.thread_time() - began < 1


def test_the_caps_on_late_energies_name_their_arguments():
    with pytest.raises(PrecisionExhausted, match="raise max_digits"):
        energy_at(PAPER, "1e50", digits=200, max_digits=100)
    with pytest.raises(OutOfRange, match="raise max_steps"):
        energy_at(PAPER, "1e50", max_steps=3)


def test_digits_that_need_countless_steps_are_refused_at_once():
    began = time.thread_time()
    with pytest.raises(OutOfRange, match=r"about .*e\+?\d+ events .*max_steps"):
        energy_at(PAPER, "1e1000", digits=1000)
    assert time.thread_time() - began < 5


def test_an_undecided_event_names_the_argument():
    first = solve(PAPER, digits=80, arithmetic="ball").events[0].t.mid().str(60, radius=False)
    touched = Scene(PAPER.pair, PAPER.initial, first)
    with pytest.raises(EventUndecided, match="raise max_digits"):
        solve(touched, digits=10, arithmetic="ball", max_digits=40)


def test_the_cap_on_events_names_its_argument():
    run = solve(Scene(PAPER.pair, PAPER.initial, "1e22"), max_events=5)
    assert run.status is Status.EVENT_LIMIT
    assert "raise the cap max_events" in run.message


# phases


@pytest.mark.parametrize("how", [{}, {"arithmetic": "mpmath", "digits": 5}])
def test_a_phase_lost_before_the_horizon_is_said(how):
    """Fig. 3's pair below E_cr: stuck for ever, but where on its orbit after 1e23 rad?"""
    scene = Scene(PAPER.pair, State(x1="0.003", v1="0.02", v2="-0.01"), until="1e22")
    run = solve(scene, **how)
    assert run.phase_lost
    assert "keep no phase" in run.message
    truth = solve(scene, digits=15, arithmetic="ball")
    assert not truth.phase_lost
    with truth.arithmetic.context():
        assert float(run.final.w) == pytest.approx(float(truth.final.w.mid()), rel=1e-12)
    assert not solve(Scene(scene.pair, scene.initial, 5), **how).phase_lost


def test_the_orbit_of_a_damped_pair_needs_no_phase():
    run = solve(Scene(Pair(1, 1, 200, "0.5", a1="0.001"), State(x1="0.003"), until="1e22"))
    assert not run.phase_lost
    assert abs(run.y[0, -1]) < 1e-300


@pytest.mark.parametrize("a1", ["1e-30", "1e-24"])
def test_a_damped_slip_of_1e22_radians_is_solved_in_balls_and_refused_by_floats(a1):
    scene = Scene(Pair(1, 1, 200, "0.05", a1=a1), State(x1="0.01", v2="1e20"), until="1e25")
    for arithmetic in ("float64", "double-double"):
        with pytest.raises(OutOfRange, match="steps"):
            solve(scene, max_events=3, arithmetic=arithmetic)
    # a float of the wait and of its bound agree long before the wait is over: balls used to give up here
    balls = solve(scene, digits=30, arithmetic="ball", max_events=3)
    points = solve(scene, arithmetic="mpmath", digits=80, max_events=3)
    climbed = solve(scene, max_events=3)
    assert balls.modes == points.modes == climbed.modes
    assert climbed.arithmetic.name == "ball"


def test_a_damped_slip_that_has_died_away_needs_no_phase():
    scene = Scene(Pair(1, 1, 200, "0.05", a1="1e-18"), State(x1="0.01", v2="1e20"), until="1e25")
    found, balls = solve(scene, max_events=3), solve(scene, digits=30, arithmetic="ball", max_events=3)
    assert found.modes == balls.modes
    assert found.y[0, 0].overlaps(balls.y[0, 0])


# files


def test_ctrl_c_while_solving_leaves_nothing(tmp_path):
    (tmp_path / "scene.toml").write_text(VALID)
    arguments = [*SOLVE[3:], "scene.toml", "--npz", "run.npz"]
    code, _, errors = interrupted("numerics", arguments, "flint", tmp_path)
    files = sorted(path.name for path in tmp_path.iterdir())
    assert (code, len(errors.splitlines()), files) == (130, 1, ["scene.toml"])
    assert errors.startswith("error: interrupted")


@pytest.mark.parametrize("module", ["sympy", "paper_checks.running.runner"])
def test_ctrl_c_while_reporting_leaves_nothing(tmp_path, module):
    code, _, errors = interrupted("paper_checks", [*REPORT[3:], "--out", "out"], module, tmp_path)
    assert (code, errors.splitlines(), list(tmp_path.iterdir())) == (130, ["paper_checks: interrupted"], [])


HALF_WRITTEN = {
    "npz": "from numerics.files import whole_file\n"
    "with whole_file(Path('result')) as file:\n    file.write(b'x' * 10**6); file.flush(); wait()",
    "renamed": "Path.replace = lambda *_: wait()\nfrom numerics.files import whole_file\n"
    "with whole_file(Path('result')) as file:\n    file.write(b'x' * 10**6)",
    "report": "Path.replace = lambda *_: wait()\nfrom paper_checks import atomic\n"
    "atomic.write(Path('result'), 'x' * 10**6)",
}


@pytest.mark.parametrize("before", [None, b"before"])
@pytest.mark.parametrize("where", HALF_WRITTEN)
def test_kill_in_mid_export_leaves_no_partial_file(tmp_path, where, before):
    if before:
        (tmp_path / "result").write_bytes(before)
    code = "import os, sys, time\nfrom pathlib import Path\ndef wait(): print('half', flush=True); time.sleep(60)\n"
    process = subprocess.Popen([sys.executable, "-c", code + HALF_WRITTEN[where]], cwd=tmp_path, stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"half\n"
    process.kill()
    process.communicate(timeout=20)
    assert (tmp_path / "result").exists() == bool(before)
    assert not before or (tmp_path / "result").read_bytes() == before


# invalid scenes


def spoiled(chance: random.Random) -> str:
    """A scene file with one fault at random; every one of them makes it invalid."""
    lines = VALID.splitlines()
    required = [i for i, line in enumerate(lines) if line.split(" =")[0] in ("m1", "m2", "a2", "b", "until")]
    numbers = [i for i, line in enumerate(lines) if re.search(r"= [0-9]", line)]
    i, j = chance.choice(required), chance.choice(numbers)
    name = lines[j].split(" =")[0]
    digits = "".join(chance.choices("0123456789", k=chance.choice([2500, 5000])))
    junk = "".join(chance.choices("abcxyz=[]{}\"'\\#,;:\t\0é１", k=chance.randint(1, 40)))
    values = [
        *("true", "nan", "-inf", "[1, 2]", "{}", '"1/0"', '"１"', '"0x1F"', "1979-05-27", '""'),
        *("'''", "1e", "--1", "1_", "0b2"),
        *(f"1e{chance.randint(1001, 10**9)}", f"-1e-{chance.randint(1001, 10**9)}"),
        *(f"1{digits}", f"0.{digits}1", f'"{digits}"', "0x" + "f" * chance.randint(2000, 9000)),
        *("[" * chance.randint(50, 5000), "nan" if junk.isdigit() else f'"{junk}"'),
    ]
    kind = chance.randrange(9)
    if kind == 0:
        del lines[i]
    elif kind == 1:
        lines[i] = f"{lines[i].split(' =')[0]} = {chance.choice(['0', '-0.0', '-1', '-1e300', '-1e-300'])}"
    elif kind in (2, 3, 4):
        lines[j] = f"{name} = {chance.choice(values)}"
    elif kind == 5:
        lines.insert(chance.randrange(1, len(lines)), f"{chance.choice(['m3', 'speed', 'M1', 'x' * 3000])} = 1")
    elif kind == 6:
        lines.append(chance.choice(["[extra]", "[pair]", "[[run]]", "x = 1", 'law = "filippov"', "[", "]", "="]))
    elif kind == 7:
        lines = [chance.choice(['law = "coulomb"', "law = 1", "law = []"]) if "law" in line else line for line in lines]
    else:
        cut = chance.randrange(VALID.index("until"))
        return VALID[:cut] + ("" if chance.random() < 0.5 else junk)
    return "\n".join(lines) + "\n"


def test_a_thousand_invalid_scenes_are_refused_in_one_line():
    for seed in range(1000):
        text, began = spoiled(random.Random(seed)), time.thread_time()
        with pytest.raises(InvalidScene) as caught:
            parse_scene(text)
        assert time.thread_time() - began < 1, seed
        assert str(caught.value).isprintable(), seed
        assert len(str(caught.value)) < 400, seed


def spoiled_file(folder, seed):
    path = folder / f"{seed}.toml"
    path.write_text(spoiled(random.Random(seed)), "utf-8")
    return str(path)


def test_invalid_scenes_on_the_command_line(tmp_path, capsys):
    for seed in range(1000, 1030):
        assert main(["solve", spoiled_file(tmp_path, seed)]) == 2
        said = capsys.readouterr()
        assert (said.out, len(said.err.splitlines())) == ("", 1), said.err
        assert said.err.startswith("error: ")


@pytest.mark.parametrize("seed", [1000, 1015])
def test_invalid_scenes_through_the_real_command_line(tmp_path, seed):
    command = [*SOLVE, spoiled_file(tmp_path, seed)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=30)
    assert (done.returncode, done.stdout, len(done.stderr.splitlines())) == (2, "", 1), done.stderr
    assert done.stderr.startswith("error: ")


def test_the_message_of_a_lost_phase_reaches_json(capsys, tmp_path):
    text = VALID.replace("0.15", "0.02").replace("0.005", "0.003")
    (tmp_path / "scene.toml").write_text(text)
    assert main(["solve", str(tmp_path / "scene.toml"), "--arithmetic", "float64", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert "keep no phase" in record["message"]
    assert Fraction(record["final"]["energy_excess"]) < 0
