"""What a terminal shows, and errors, which name the argument that helps."""

import re
import sys

import pytest

from numerics.__main__ import main
from numerics.errors import OutOfRange
from numerics.scene.file import load_scene
from numerics.solver.solve import solve

SCENE = "[pair]\nm1 = 1\nm2 = 1\na2 = 200\nb = 0.5\n[initial]\nv1 = 0.15\n[run]\nuntil = 2\n"


@pytest.fixture
def scene_file(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(SCENE)
    return path


def run(capsys, *arguments) -> tuple[int, str, str]:
    code = main([str(one) for one in arguments])
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def on_a_terminal(capsys, monkeypatch, *arguments) -> str:
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    return run(capsys, *arguments)[1]


def test_a_terminal_sees_the_first_and_the_last_events_and_how_to_get_all(capsys, monkeypatch, scene_file):
    scene_file.write_text(SCENE.replace("until = 2", "until = 50"))
    how = ("solve", scene_file, "--arithmetic", "float64")
    short = on_a_terminal(capsys, monkeypatch, *how)
    whole = on_a_terminal(capsys, monkeypatch, *how, "--all")
    events = [line.split() for line in whole.splitlines() if " to " in line]
    shown = [line.split() for line in short.splitlines() if " to " in line]
    assert shown == events[:20] + events[-20:]
    assert f"... {len(events) - 40} events more; --all prints them too" in short.splitlines()
    assert "--all" not in whole


@pytest.mark.parametrize(
    ("argument", "arguments"),
    [
        ("max_digits", ("solve", "velocities", "--digits", 500, "--max-digits", 100)),
        ("max_events", ("solve", "velocities", "--max-events", 2)),
        ("max_digits", ("energy", "start-with-speed", "--at", "1e50", "--digits", 200, "--max-digits", 100)),
        ("max_steps", ("energy", "start-with-speed", "--at", "1e50", "--max-steps", 3)),
    ],
)
def test_a_refusal_names_the_argument_that_helps(capsys, argument, arguments):
    code, _, err = run(capsys, *arguments)
    assert code == 1
    assert argument in err
    assert not re.search(r"\w=|solve\(", err)


def test_a_scene_beyond_float64_is_sent_to_balls(capsys, tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(SCENE.replace("m1 = 1", "m1 = 1e400"))
    code, _, err = run(capsys, "solve", path, "--arithmetic", "float64")
    assert (code, "use ball arithmetic" in err) == (1, True)
    with pytest.raises(OutOfRange, match="ball arithmetic"):
        solve(load_scene(str(path)))
