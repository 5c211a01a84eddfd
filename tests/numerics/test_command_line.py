"""python -m numerics: exit codes, one line of error, the JSON of the interface, and files that appear whole."""

import csv
import io
import json
import subprocess
import sys
from dataclasses import replace
from decimal import Decimal

import numpy as np
import pytest
from three_scenes import PAPER, SCENE

from numerics import solve
from numerics.cli import solving
from numerics.cli.arguments import parser
from numerics.scene.file import shipped_scenes
from numerics.trajectory.export import as_record

TWO_SECONDS = replace(PAPER, until=2)
STATE = ("x1", "v1", "x2", "v2")


def test_json_has_the_shape_of_the_interface(run, scene_file):
    code, out, err = run("solve", scene_file, "--json", "--digits", 30)
    found = json.loads(out)
    assert (code, err) == (0, "")
    assert list(found) == ["status", "message", "arithmetic", "digits", "events", "final"]
    assert (found["status"], found["arithmetic"], found["digits"]) == ("reached-horizon", "ball", 30)
    for event in found["events"]:
        assert {event["from"], event["to"]} <= {"slip+", "slip-", "stick"}
        assert {"t", *STATE} <= set(event)
    assert found["final"]["mode"] in ("slip+", "slip-", "stick")
    assert {"t", *STATE, "energy", "energy_excess"} <= set(found["final"])
    texts = [row[key] for row in (*found["events"], found["final"]) for key in row if key not in ("from", "to", "mode")]
    assert all(isinstance(text, str) and Decimal(text).is_finite() for text in texts)


@pytest.mark.parametrize("arithmetic", ["float64", "double-double", "mpmath"])
def test_point_arithmetics_print_only_right_digits(run, scene_file, arithmetic):
    found = json.loads(run("solve", scene_file, "--json", "--arithmetic", arithmetic)[1])
    truth = as_record(solve(TWO_SECONDS, digits=60, arithmetic="ball"))
    for row, exact in zip([*found["events"], found["final"]], [*truth["events"], truth["final"]], strict=True):
        for name in [key for key in row if key not in ("from", "to", "mode")]:
            printed = Decimal(row[name])
            assert "radius" not in name
            # rounded where the error begins: the last digit may be off by one, and the rounding adds a half
            unit = Decimal((0, (1,), printed.as_tuple().exponent))
            assert abs(printed - Decimal(exact[name])) <= unit * Decimal("1.5")


def test_csv_has_a_row_for_each_event_and_the_end(run, scene_file):
    code, out, _ = run("solve", scene_file, "--csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    found = as_record(solve(TWO_SECONDS, digits=15, arithmetic="ball"))
    assert code == 0
    assert len(rows) == len(found["events"]) + 1
    assert [row["t (s)"] for row in rows] == [row["t"] for row in [*found["events"], found["final"]]]
    assert {"from", "to", "x1 (m)", "x1_radius (m)", "v2 (m/s)", "energy (J)", "energy_excess"} <= set(rows[0])


@pytest.mark.parametrize("how", [{"arithmetic": "ball"}, {"arithmetic": "float64"}, {"arithmetic": "mpmath"}])
def test_a_trajectory_has_the_text_that_the_command_prints(run, scene_file, how):
    scene = TWO_SECONDS
    truth = solve(scene, digits=40) if how["arithmetic"] == "mpmath" else None
    _, out, _ = run("solve", scene_file, "--csv", "--arithmetic", how["arithmetic"])
    assert solve(scene, **how).to_csv(truth) == out
    if truth is not None:
        with pytest.raises(ValueError, match="give `truth`"):
            solve(scene, **how).to_csv()


def test_npz_holds_plain_arrays(run, scene_file, tmp_path):
    target = tmp_path / "run.npz"
    assert run("solve", scene_file, "--npz", target) == (0, "", "")
    with np.load(target, allow_pickle=False) as archive:
        m = len(archive["t"])
        assert archive["y"].shape == (4, m)
        assert archive["energy"].shape == (m,)
        assert len(archive["modes"]) == len(archive["event_kinds"]) + 1 == m - 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["run.npz", "scene.toml"]


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".png"])
def test_plots(run, scene_file, tmp_path, suffix):
    target = tmp_path / f"run{suffix}"
    assert run("solve", scene_file, "--plot", target)[0] == 0
    assert target.stat().st_size > 1000


def test_the_table_and_the_list(run):
    code, out, err = run("solve", "velocities")
    assert (code, err) == (0, "")
    assert "entry" in out or "stick" in out
    code, out, _ = run("scenes")
    assert code == 0
    names = [line.split()[0] for line in out.splitlines()]
    assert names == list(shipped_scenes())
    assert all(len(line.split()) > 4 and "#" not in line for line in out.splitlines())  # each is told in a sentence


@pytest.mark.parametrize("command", [["solve", "-", "--json"], ["energy", "-", "--at", "2", "--json"]])
def test_a_scene_is_read_from_standard_input(run, monkeypatch, scene_file, command):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(SCENE.encode())))
    piped = run(*command)
    assert piped == run(command[0], scene_file, *command[2:])
    assert piped[0] == 0
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"m1 = ")))
    code, out, err = run(*command)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert "standard input is not a TOML scene" in err


def test_the_version_is_that_of_the_project(run):
    code, out, _ = run("--version")
    assert (code, out.split()[0]) == (0, "inertial-pair")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["solve", "velocites"], "did you mean velocities"),
        (["slove", "velocities"], "did you mean solve"),
        (["solve", "velocities", "--arithmetic", "flaot64"], "did you mean float64"),
        (["track", "at-rest", "--reference", "s-curv"], "did you mean s-curve"),
        ([], "required: command; --help tells what there is"),
        (["solve", "velocities", "--jsn"], "unrecognized arguments: --jsn; --help tells"),
        (["solve", "velocities", "--npz", ""], "the name is empty"),
        (["solve", "no-such-scene"], "one of those that `inertial-pair scenes` lists"),
        (["solve", ""], "the name of the scene is empty"),
        (["solve", "velocities", "--plot", "/proc/x.svg"], "cannot be written to"),
    ],
)
def test_a_mistake_is_told_with_what_was_meant(run, words, said):
    code, out, err = run(*words)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert said in err


@pytest.mark.parametrize(
    ("module", "command"),
    [
        ("matplotlib", ["solve", "velocities", "--plot", "figure.svg"]),
        ("matplotlib", ["map", "--out", "figure.svg"]),
        ("rich", ["audit"]),
        ("rich", ["trade"]),
    ],
)
def test_a_missing_tool_is_named_before_anything_runs(run, monkeypatch, tmp_path, module, command):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, module, None)
    monkeypatch.setattr(solving, "solve_scene", lambda _: pytest.fail("it was solved"))
    code, out, err = run(*command)
    assert (code, out, err.count("\n")) == (1, "", 1)
    assert f"needs {module}" in err
    assert "pip install" in err
    assert not list(tmp_path.iterdir())


def test_a_shell_completes_commands_flags_and_scenes(monkeypatch):
    finders = pytest.importorskip("argcomplete.finders")
    finder = finders.CompletionFinder(parser())

    def completed(*words):
        return {one.strip() for one in finder._get_completions([*words[:-1]], words[-1], "", None)}

    assert "solve" in completed("inertial-pair", "so")
    assert "velocities" in completed("inertial-pair", "solve", "velo")
    assert "--arithmetic" in completed("inertial-pair", "solve", "velocities", "--ar")


def test_output_to_a_folder_is_refused(run, scene_file, tmp_path):
    for name in ("folder.npz", "folder.svg"):
        (tmp_path / name).mkdir()
    for arguments in (
        ("--npz", tmp_path / "folder.npz"),
        ("--plot", tmp_path / "folder.svg"),
        ("--npz", tmp_path / "absent" / "x.npz"),
        ("--plot", tmp_path / "x.gif"),
        ("--plot", tmp_path / "x"),
    ):
        code, out, err = run("solve", scene_file, *arguments)
        assert (code, out, len(err.splitlines())) == (2, "", 1)
    assert not list(tmp_path.rglob(".*"))


BAD_USAGE = """
solve
dance
solve start-at-6mm --digits 0
solve start-at-6mm --digits -1
solve start-at-6mm --digits 1.5
solve start-at-6mm --digits ²
solve start-at-6mm --max-events 0
solve start-at-6mm --arithmetic decimal
solve start-at-6mm --json --csv
solve start-at-6mm --arithmetic float64 --digits 9
solve start-at-6mm velocities
solve start-at-6mm --dig 9
solve start-at-6mm --digits 1e3
map --depth -1
map --jobs 0
map --energy 0.5 0.7
energy forced-step --at 1
map --depth 40
map --ratio 2 1
map --ratio 0 1
map --energy 1 2
map --energy 3 3
map --energy x 2
map --out map.txt
map --out no/m.png
response velocities
response velocities --omega 0
response none-such
move at-rest --distance 0
move at-rest --distance 1 --margin 2
move velocities --distance 1
move at-rest --distance 1 --out no/where.toml
track at-rest --reference none-such
track at-rest --reference s-curve --plot x.txt
ring velocities --radius x
response-map at-rest --amplitude 1 1 --omega 1 2
response-map at-rest --amplitude 1 2 --omega 0 2
response-map at-rest --amplitude 1 2 --omega 1 2 --depth 40
"""


@pytest.mark.parametrize("words", ["", *BAD_USAGE.strip().splitlines()])
def test_bad_usage(run, words):
    code, out, err = run(*words.split())
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert (err.count("error"), err.count("\n")) == (1, 1)


@pytest.mark.parametrize("content", [b"", SCENE.encode("utf-16"), SCENE.replace("m1 = 1", "m1 = true").encode()])
def test_an_invalid_scene_is_one_line_and_exit_code_2(run, tmp_path, content):
    """Of what is refused, test_scene.py has the whole list."""
    path = tmp_path / "scene.toml"
    path.write_bytes(content)
    code, out, err = run("solve", path)
    assert (code, out, err[:7], err.count("\n")) == (2, "", "error: ", 1)


def test_the_real_process(tmp_path):
    (tmp_path / "bad.toml").write_text("[pair]\nm1 = nan\n")
    process = subprocess.run(
        [sys.executable, "-m", "numerics", "solve", "bad.toml"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (process.returncode, process.stdout, process.stderr.count("\n")) == (2, "", 1)
    with open("/dev/full", "w") as full:
        process = subprocess.run(
            [sys.executable, "-m", "numerics", "solve", "start-at-6mm"],
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
        )
    assert process.returncode == 1
    assert process.stderr.count(b"\n") == 1
