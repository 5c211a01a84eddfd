"""Rows from one process and from several: the same, with the kernel asked once about what they cite."""

import json
import subprocess
import sys

import pytest
from dying_process import answers_or_dies
from interruption import interrupted

from paper_checks.claims import CLAIMS, claim_named
from paper_checks.decide import kernel
from paper_checks.evidence.finding import Verdict
from paper_checks.proofs import library
from paper_checks.report.formats.progress import Claims as Shown
from paper_checks.running import processes
from paper_checks.running import rows as running
from paper_checks.running.runner import Context

QUICK = ("energy-rate", "stiction-bracket", "vector-fields")


@pytest.fixture
def no_theorem_is_known(monkeypatch):
    """Theorems are asked for anew, and none that a test makes up is kept."""
    monkeypatch.setattr(library, "_known", {})
    kernel.step.cache_clear()
    yield
    kernel.step.cache_clear()


def test_only_the_theorems_of_the_claims_are_asked_for_and_the_files_that_are_compiled_are_counted(
    monkeypatch, no_theorem_is_known
):
    """@example of minutes of compiling that were shown as "at work"."""
    shown, asked, prove = [], [], library.prove

    def proved(ids, progress, jobs):
        asked.extend(ids)
        progress(3, 81)
        return prove(ids)

    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr(library, "prove", proved)
    running.rows([claim_named("energy-rate")], Context(), 1, Shown(lambda text, *_: shown.append(text), 1))
    last = "1/1 claims checked, last energy-rate"
    assert list(dict.fromkeys(shown)) == ["compiling Coq proofs 3/81", "checking energy-rate", last]
    assert asked == list(running.theorems([claim_named("energy-rate")])) == ["energy-rate", "energy-decreases"]
    assert len(running.theorems(CLAIMS)) > 100


def test_a_process_that_ends_costs_its_own_task_only():
    found = dict(processes.answers(["one", "lost", "other"], 2, answers_or_dies, "!"))
    assert isinstance(found.pop("lost"), processes.Ended)
    assert found == {"one": "one!", "other": "other!"}


def test_a_row_whose_process_ended_is_undecided(monkeypatch, no_theorem_is_known):
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr(processes, "answers", lambda names, *_: ((one, processes.Ended()) for one in names))
    for lost in running.rows([claim_named(name) for name in QUICK], Context(), 2):
        assert lost.finding.verdict is Verdict.UNDECIDED
        assert "its process ended" in lost.finding.reason


def test_the_bytes_are_the_same_from_one_process_and_from_two_and_nothing_is_kept(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("PATH", "")  # no kernel: it would compile its proofs into that folder

    def run(*words):
        return subprocess.run(
            [sys.executable, "-m", "paper_checks", *words, "--json", *QUICK], capture_output=True, check=False
        )

    one, two = run("--jobs", "1"), run("--jobs", "2")
    assert (one.returncode, one.stderr) == (0, b"")
    assert one.stdout == two.stdout
    found = json.loads(one.stdout)
    assert {row["id"] for row in found} == set(QUICK)
    assert {one["status"] for row in found for part in row["clauses"] for one in part["kernel"]} == {"not run"}
    assert not list(tmp_path.rglob("*.json"))


def test_ctrl_c_ends_all_processes_and_says_one_word(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", "")
    code, _, errors = interrupted("paper_checks", ["--jobs", "2"], "paper_checks.running.rows", tmp_path)
    assert (code, errors) == (130, "error: interrupted\n")
