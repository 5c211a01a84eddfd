"""README and the pages in docs/: their code runs, commands are understood, scenes are scenes, no link is dead."""

import re
import shlex
import subprocess
import sys
from pathlib import Path

import matplotlib as mpl
import pytest

import numerics
from numerics import solve
from numerics.cli.arguments import parser
from numerics.scene.file import parse_scene
from paper_checks.__main__ import COMMANDS, _parser

ROOT = Path(__file__).resolve().parent.parent
PAGES = {path.name: path.read_text("utf-8") for path in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))}


def blocks(page: str, language: str) -> list[str]:
    """Return the code blocks of a page in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```", PAGES[page], flags=re.DOTALL | re.MULTILINE)


def having(language: str) -> list[str]:
    return [page for page in PAGES if blocks(page, language)]


COARSE = {"range(100)": "range(3)", ", 60)": ", 5)"}
"""The sweeps of the gallery have as many points as a picture needs; a default run takes few."""


@pytest.mark.parametrize(
    ("page", "changes"),
    [*((page, COARSE) for page in having("python")), pytest.param("gallery.md", {}, marks=pytest.mark.long)],
)
def test_the_examples_of_a_page_run_one_after_the_other(page, changes, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(mpl.rcParams, "backend", "agg")
    code = "\n".join(blocks(page, "python"))
    for many, few in changes.items():
        code = code.replace(many, few)
    exec(compile(code, page, "exec"), names := {"__name__": "__main__"})
    assert len(capsys.readouterr().out.splitlines()) >= 3
    assert not list(tmp_path.iterdir())
    if page == "fit.md":
        require_the_truth(**names)


def require_the_truth(*, found, error, sigma, **others):
    """The fit of the page finds it within its uncertainty."""
    assert abs((found.x - [1.5, 1.2]) / error).max() < 3
    assert error.max() < 0.02
    assert sigma == pytest.approx(0.01, rel=0.2)


@pytest.mark.parametrize("page", having("toml"))
def test_the_scene_files_of_a_page_are_scenes(page):
    for text in blocks(page, "toml"):
        assert solve(parse_scene(text)).success


def commands(page: str) -> list[list[str]]:
    """Return the commands of a page, without their comments."""
    lines = "".join(blocks(page, "sh")).replace(".venv/bin/", "").splitlines()
    return [shlex.split(line, comments=True) for line in lines if line.startswith("inertial-pair")]


@pytest.mark.parametrize("page", [page for page in having("sh") if commands(page)])
def test_the_commands_of_a_page_are_understood(page):
    for program, *words in commands(page):
        if program == "inertial-pair":
            assert parser().parse_args(words).run
        else:
            known = words and words[0] in COMMANDS
            assert _parser().parse_args(words if known else ["run", *words]).command


@pytest.mark.parametrize("page", PAGES)
def test_no_link_is_dead(page):
    folder = ROOT if page == "README.md" else ROOT / "docs"
    links = re.findall(r"\]\(([^)#]+)\)", re.sub(r"^```.*?^```", "", PAGES[page], flags=re.DOTALL | re.MULTILINE))
    assert not [one for one in links if "://" not in one and not (folder / one).exists()]


def test_every_public_name_is_in_the_reference():
    named = set(re.findall(r"numerics\.(\w+)$", PAGES["api.md"], flags=re.MULTILINE))
    errors = {name for name in dir(numerics) if name in dir(numerics.errors)}  # a page of its own lists them all
    assert set(dir(numerics)) - errors <= named


USER = """
from fractions import Fraction

import numpy as np

from numerics import Batch, Mode, Pair, Scene, State, Trajectory, load_scene, response, sensitivities, solve, solve_many

scene: Scene = Scene(Pair(m1=1, m2=Fraction(1, 3), a2=200, b="0.05"), State(v1=0.15), until=5)
run: Trajectory = solve(scene, digits=8, t_eval=[0, 0.5])
modes: tuple[Mode, ...] = run.modes
found: Batch = solve_many(1, 1, 200, 0.05, v1=np.linspace(0, 1, 5), until=5)
total: float = float(found.dissipated.sum()) + run.accuracy.digits if run.accuracy else 0.0
print(response(load_scene("forced-step")).regime.value, sensitivities(run).wrt, sensitivities(run, [0.1]).shape)
run.save("run.npz")
print(Trajectory.load("run.npz").events[0].t, total)
"""


@pytest.mark.long
def test_a_user_s_program_is_typed_and_the_one_fault_in_it_is_seen(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "program.py").write_text(f"{USER}\nwrong: int = run.message\n", "utf-8")
    (tmp_path / "mypy.ini").write_text("[mypy]\nstrict = True\n[mypy-numerics.*]\nfollow_imports = silent\n", "utf-8")
    command = [sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path / "cache"), "program.py"]
    environment = {"MYPYPATH": str(ROOT), "PATH": ""}
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, encoding="utf-8", check=False
    )
    told, count = done.stdout.strip().splitlines()
    assert 'expression has type "str"' in told
    assert count.startswith("Found 1 error")
