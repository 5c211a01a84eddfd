"""What a terminal shows, and errors, which name the argument that helps."""

import io
import re
import subprocess
import sys

import pytest

from numerics import OutOfRange, load_scene, solve
from numerics.cli.solving import _progress
from numerics.shown import print_table


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
    assert f"... {len(events) - 40} events more; --all prints them too" in short.splitlines()
    assert "--all" not in whole


def test_a_narrow_terminal_breaks_no_line_and_loses_no_digit(run, monkeypatch, scene_file):
    how = ("solve", scene_file, "--arithmetic", "float64", "--all")
    piped = run(*how)[1]
    monkeypatch.setenv("COLUMNS", "80")
    narrow = on_a_terminal(run, monkeypatch, *how)
    assert max(map(len, narrow.splitlines())) < 80 < max(map(len, piped.splitlines()))
    assert narrow.split() == piped.split()
    monkeypatch.setenv("COLUMNS", "200")
    assert on_a_terminal(run, monkeypatch, *how) == piped


@pytest.mark.parametrize(
    ("argument", "arguments"),
    [
        ("--max-digits", ("solve", "velocities", "--digits", 500, "--max-digits", 100)),
        ("--max-events", ("solve", "velocities", "--max-events", 2)),
        ("--max-digits", ("energy", "start-with-speed", "--at", "1e50", "--digits", 200, "--max-digits", 100)),
        ("--max-steps", ("energy", "start-with-speed", "--at", "1e50", "--max-steps", 3)),
    ],
)
def test_a_refusal_names_the_argument_that_helps(run, argument, arguments):
    code, _, err = run(*arguments)
    assert code == 1
    assert argument in err
    assert not re.search(r"\w=|solve\(", err)


def test_a_scene_beyond_float64_is_sent_to_balls(run, scene_file):
    scene_file.write_text(scene_file.read_text().replace("m1 = 1", "m1 = 1e400"))
    code, _, err = run("solve", scene_file, "--arithmetic", "float64")
    assert (code, "use --arithmetic ball" in err) == (1, True)
    with pytest.raises(OutOfRange, match='use arithmetic="ball"'):
        solve(load_scene(scene_file))


def test_a_cap_that_comes_before_the_horizon_is_told_early_and_once(capsys):
    show = _progress(5000)
    for events, fraction in ((1000, 0.21), (2000, 0.39), (3000, 0.5), (3001, 1.0)):
        show(events, fraction)
    told = capsys.readouterr().err
    assert (told.count("the cap of 5000 events comes before the horizon"), told.count("\n")) == (1, 1)
    _progress(5000)(3001, 1.0)
    assert capsys.readouterr().err == ""


def test_a_reader_that_leaves_a_table_is_left_to_the_program(monkeypatch):
    class Left(io.StringIO):
        def write(self, text):
            raise BrokenPipeError

    monkeypatch.setattr(sys, "stdout", Left())
    with pytest.raises(BrokenPipeError):
        print_table(("a", "b"), [("1", "2")])


@pytest.mark.parametrize("redirected", ["<&-", ">&-", "2>&-"])
def test_a_stream_that_is_closed_is_no_traceback(redirected):
    command = f"{sys.executable} -m numerics solve at-rest --arithmetic float64 {redirected}"
    ended = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert (ended.returncode, ended.stderr) == (0, "")
