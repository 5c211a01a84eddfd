"""python -m numerics: exit codes, one line of error, the JSON of the interface, files that appear whole, terminals."""

import csv
import io
import re
import subprocess
import sys
from itertools import chain

import numpy as np
import pytest
from flint import arb
from three_scenes import SCENE

from numerics import load_scene, solve
from numerics.cli import solving
from numerics.cli.arguments import parser
from numerics.scene.file import shipped_scenes
from numerics.trajectory.export import as_record


@pytest.mark.parametrize(
    ("name", "how"),
    [
        *(("", one) for one in ({"digits": 30}, {"arithmetic": "float64"}, {"arithmetic": "mpmath"})),
        ("plane-circle-merges", {"digits": 12}),
    ],
)
def test_json_and_csv_are_the_record_and_the_table_of_the_run(run, record, scene_file, name, how):
    words = "solve", name or scene_file, *chain(*((f"--{name}", one) for name, one in how.items()))
    found, told = solve(load_scene(name or scene_file), **how), record(*words)
    assert told == as_record(found)
    assert (told["status"], told["arithmetic"]) == ("reached-horizon", how.get("arithmetic", "ball"))
    assert list(told) == ["status", "message", "arithmetic", "digits", "events", "final"]
    code, out, explained = run(*words, "--csv", "--explain")
    head = next(csv.reader(io.StringIO(out)))
    assert (code, out, "working digits" in explained) == (0, found.to_csv(), True)
    assert any("_radius" in one for one in head) == ("digits" in how)


def test_times_are_rows_of_right_digits(run, record):
    code, out, err = run("solve", "velocities", "--times", "0:5:0.5")
    head, *rows = csv.reader(io.StringIO(out))
    assert (code, err) == (0, "")
    assert head == ["t (s)", "mode", "x1 (m)", "v1 (m/s)", "x2 (m)", "v2 (m/s)", "energy (J)"]
    assert [one[0] for one in rows] == [f"{k / 2:g}" for k in range(11)]
    balls = solve(load_scene("velocities"), digits=30).sol([one[0] for one in rows])
    for row, column in zip(rows, balls.T, strict=True):
        assert all(abs(arb(mine) - true) <= abs(true) * 1e-15 for mine, true in zip(row[2:6], column, strict=True))
    found = record("solve", "velocities", "--times", "0:5:0.5")
    assert [list(one.values()) for one in found["times"]] == rows
    assert run("solve", "plane-box", "--times", "0:1:0.5")[1].startswith("t (s),mode,x1_x (m),x1_y (m)")


@pytest.mark.parametrize(("name", "pictures"), [("", ("a.pdf", "b.png")), ("plane-circle-merges", ("a.svg",))])
def test_a_run_is_written_as_plain_arrays_and_drawn(run, scene_file, tmp_path, name, pictures):
    for flag, file in (("--npz", "run.npz"), *(("--plot", one) for one in pictures)):
        assert run("solve", name or scene_file, flag, tmp_path / file) == (0, "", "")
        assert (tmp_path / file).stat().st_size > 1000
    found = solve(load_scene(name or scene_file), arithmetic="ball")
    with np.load(tmp_path / "run.npz", allow_pickle=False) as archive:
        assert all(np.array_equal(archive[one], found.floats(found[one])) for one in ("t", "y", "energy"))
        assert [*archive["modes"]] == [*map(str, found.modes)]
        assert [*archive["event_kinds"]] == [one.value for one in found.event_kinds]
    assert len([*tmp_path.iterdir()]) == 2 + len(pictures)


def test_the_table_and_the_list(run):
    code, out, err = run("solve", "velocities")
    assert (code, "entry" in out or "stick" in out, err) == (0, True, "")
    assert [line.split()[0] for line in run("scenes")[1].splitlines()] == list(shipped_scenes())
    assert run("--version")[1].split()[0] == "inertial-pair"


def test_where_a_belt_jumps_the_velocities_differ_and_one_side_answers(run, scene_file):
    scene_file.write_text("""
        pair = { m1 = 2, m2 = "inf", a2 = 80, b = 3 }
        belt = [{ polynomial = ["0.3"] }, { from = "2.3", polynomial = ["-0.3"] }]
        run = { until = "2.4" }""")
    assert "  v1 (m/s)  " in run("solve", scene_file)[1]
    assert "  v1 = v2 (m/s)  " in run("solve", "belt")[1]
    assert float(run("solve", scene_file, "--times", "2.3:2.3:1")[1].splitlines()[1].split(",")[5]) == -0.3


@pytest.mark.parametrize(("text", "code", "said"), [(SCENE, 0, ""), ("m1 = ", 2, "standard input is not a TOML scene")])
def test_a_scene_is_read_from_standard_input(run, monkeypatch, scene_file, text, code, said):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
    found, out, err = run("solve", "-", "--json")
    assert (found, said in err, out) == (code, True, "" if code else run("solve", scene_file, "--json")[1])


BAD_USAGE = """
solve
solve start-at-6mm --digits 0 | from 1 to
solve start-at-6mm --digits ²
solve start-at-6mm --max-events 0
solve start-at-6mm --arithmetic decimal
solve start-at-6mm --json --csv | leave one of them out
solve start-at-6mm --arithmetic float64 --digits 9 | --digits 9 needs ball or mpmath
solve start-at-6mm --dig 9
solve start-at-6mm --digits 1e3
energy belt --at 1
energy start-with-speed --at inf
response velocities
response velocities --omega 0 | omega = 0
response velocities --omega 3 | no force
response velocities --omega 3 --amplitude 0 | amplitude = 0
response forced-step | not periodic
response none-such
move at-rest --distance 0 | distance = 0
move at-rest --distance 1 --margin 1 | margin = 1
move at-rest --distance 1 --margin -1 | margin = -1
move at-rest --distance 1 --amplitude 0 | amplitude = 0
move velocities --distance 1 | v1=0.15
move forced-step --distance 1 | computes its own force
move start-at-6mm-literal --distance 1
move at-rest --distance 1 --out no/where.toml
move at-rest --distance 0.01 --least energy | --least energy or peak and --time go together
move at-rest --distance 0.01 --time 1 | --least energy or peak and --time go together
move at-rest --distance 0.01 --least energy --time 1 --amplitude 1 | --amplitude is for the least time
move at-rest --distance 0.01 --least energy --time 0.1 | as no transfer that keeps the margin is faster; give more time
damping at-rest --tolerance -1e-3 | must be
energy velocities --at -1e2 | must be
track at-rest --reference none-such
track at-rest --reference s-curve --plot x.txt
ring velocities --radius x | radius
ring velocities --radius 1 --rate -1 | rate = -1
solve velocites | did you mean velocities
slove velocities | did you mean solve
solve velocities --arithmetic flaot64 | did you mean float64
track at-rest --reference s-curv | did you mean s-curve
solve velocities --jsn | --jsn is not known: did you mean --json?
solve velocities --max_events 3 | --max_events is not known: did you mean --max-events?
solve velocities --t-eval 0:1:1 | --t-eval is not known: write --times
solve velocities --rtol 1e-9 | --digits N requests N right digits
solve velocities --times 0:9:1 | outside the solved time
solve velocities --times 0:5 | must be A:B:STEP
solve velocities --times -1e-3:5:1 | must have 0 <= A <= B
solve velocities --times 0:5:1e-9 | at most 1000000 times
solve velocities --times 0:5:1 --plot x.svg | leave --plot out
solve velocities --times 0:5:1 --arithmetic float64 | leave --arithmetic out
solve plane-box --times 9:9:1 | outside the solved time
response velocities --omega 3 | --amplitude and --omega
ring velocities --radius -1e-3 | radius = -0.001
move at-rest --distance 1 --amplitude -1e-3 | amplitude = -0.001
solve velocities --npz= | the name is empty
solve velocities --check --csv | leave --csv out
solve velocities --sensitivity --csv | --sensitivity
solve velocities --sensitivity --plot=x.svg | --sensitivity
energy plane-box --at 1 | surface
ring plane-box --radius 1 | surface
solve plane-circle-merges --proof F.v | is available on a line only
solve plane-circle-merges --sensitivity --json | is available on a line only
solve plane-circle-merges --arithmetic mpmath | is available on a line only
solve plane-circle-merges --arithmetic float64 | is available on a line only
solve no-such-scene | one of those that `inertial-pair scenes` lists
solve velocities --plot /proc/x.svg | cannot be written to
solve velocities --npz folder.npz | is a folder
solve velocities --plot folder.svg | is a folder
solve velocities --npz absent/x.npz | does not exist
solve velocities --plot x | must end in one of
solve velocities --npz table.csv | must end in .npz
ring velocities --radius -1 | radius = -1
trade no-such-scene | one of those that `inertial-pair scenes` lists
trade --plot no-such-folder/figure.png | does not exist
"""


@pytest.mark.parametrize("line", [" | required: command; --help lists the options", *BAD_USAGE.strip().splitlines()])
def test_bad_usage_is_told_in_one_line_with_what_was_meant(run, monkeypatch, tmp_path, line):
    monkeypatch.chdir(tmp_path)
    for name in ("folder.npz", "folder.svg"):
        (tmp_path / name).mkdir()
    words, _, said = line.partition(" | ")
    code, out, err = run(*words.split())
    assert (code, out, err[:7], err.count("error"), err.count("\n")) == (2, "", "error: ", 1, 1)
    assert said in err
    assert len(list(tmp_path.rglob("*"))) == 2


@pytest.mark.parametrize(("module", "words"), [("matplotlib", "solve velocities --plot figure.svg"), ("rich", "trade")])
def test_a_missing_tool_is_named_before_anything_runs(run, monkeypatch, tmp_path, module, words):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, module, None)
    monkeypatch.setattr(solving, "solve_scene", lambda _: pytest.fail("it was solved"))
    code, out, err = run(*words.split())
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


@pytest.mark.parametrize("ends", ["<&-", ">&-", "2>&-", ">/dev/full"])
def test_a_stream_that_is_closed_or_full_is_no_traceback(ends):
    command = f"{sys.executable} -m numerics solve at-rest {ends}"
    ended = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    progress = re.sub(r"\w+ \d+ s\n", "", ended.stderr)
    assert (ended.returncode, progress.count("\n")) == ((1, 1) if "full" in ends else (0, 0))


# what a terminal shows, and errors, which name the argument that helps


def on_a_terminal(run, monkeypatch, *arguments) -> str:
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    return run(*arguments)[1]


def test_a_terminal_sees_the_first_and_the_last_events_and_how_to_get_all(run, monkeypatch, scene_file):
    scene_file.write_text(scene_file.read_text().replace("until = 2", "until = 50"))
    how = ("solve", scene_file, "--arithmetic", "float64")
    short = on_a_terminal(run, monkeypatch, *how)
    whole = on_a_terminal(run, monkeypatch, *how, "--all")
    events = [line.split() for line in whole.splitlines() if " to " in line]
    shown = [line.split() for line in short.splitlines() if " to " in line]
    assert shown == events[:20] + events[-20:]
    lines = short.splitlines()
    at = lines.index(f"... {len(events) - 40} more events; --all prints them")
    assert [lines[at - 1].split(), lines[at + 1].split()] == [events[19], events[-20]]
    assert "--all" not in whole


REFUSED = """
solve velocities --digits 500 --max-digits 100 | --max-digits
solve velocities --max-events 2 | --max-events = 2, t = 0.
energy start-with-speed --at 1e50 --max-steps 3 | --max-steps
solve velocities-literal --proof b.v | error: no theorem is written
move at-rest --distance 0.0075 --least peak --time 0.9 | the end needs a peak of 0.5 N
"""


@pytest.mark.parametrize("line", REFUSED.strip().splitlines())
def test_a_refusal_names_the_argument_that_helps(run, monkeypatch, tmp_path, line):
    monkeypatch.chdir(tmp_path)
    words, argument = line.split(" | ")
    code, _, err = run(*words.split())
    assert (code, argument in err) == (1, True)
    assert not list(tmp_path.iterdir())
    assert not re.search(r"\w=|solve\(", err)
