"""What a terminal shows, and errors, which name the argument that helps."""

import re
import sys

import pytest

from numerics.errors import OutOfRange
from numerics.scene.file import load_scene
from numerics.solver.solve import solve


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
