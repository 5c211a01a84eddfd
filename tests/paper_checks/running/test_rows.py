"""Rows from the cache and from other processes: the same as from this one, and never one that was not earned."""

import json
import os
import pickle
import re
import subprocess
import sys
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest
from dying_process import dies_of_energy_rate
from imported import imported_modules
from interruption import interrupted

from paper_checks.claims import claim_named
from paper_checks.decide import kernel
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.proofs import library
from paper_checks.report.formats.progress import OnPipe, compiling
from paper_checks.running import kept, plain, workers
from paper_checks.running import rows as running
from paper_checks.running.kept import Kept
from paper_checks.running.runner import Context

QUICK = ("energy-rate", "stiction-bracket", "vector-fields")
ROOT = Path(kept.__file__).parents[2]
SHOWN_WITH = {"matplotlib", "rich", "math-core", "jinja2", "platformdirs"}


@pytest.fixture
def settled(rows):
    return [row for row in rows if row.finding.verdict is not Verdict.UNDECIDED]


@pytest.fixture
def store(tmp_path):
    return Kept(0, tmp_path)


def test_a_row_comes_back_as_it_was_and_never_as_another_or_where_a_solver_was_silent(rows, store, settled):
    silent = Evidence(EvidenceKind.SMT, "z3 and cvc5", "hard", None)
    left_open = Finding(Verdict.UNCHECKED, "r", (silent,), missing="z3")
    for row in rows:
        there, first = plain.plain(row), rows[row is rows[0]]
        assert plain.row(row.claim, there) == row
        with pytest.raises(ValueError, match=row.claim.id):
            plain.row(first.claim, there)
        for wrong in (replace(there, finding=left_open), replace(there, proofs=(((), (), (silent,)),))):
            store.keep(wrong)
            assert store.row(row.claim.id) is None
        store.keep(there)
        assert (store.row(row.claim.id) == there) is (row in settled)
        for proofs in (there.proofs * 2, there.proofs[:-1] or there.proofs * 3):
            with pytest.raises(ValueError, match="zip"):
                plain.row(row.claim, replace(there, proofs=proofs))


@pytest.fixture
def no_theorem_is_known():
    """Theorems are asked for anew, and none that a test makes up is kept."""
    caches = kernel.step, library.theorem
    for one in caches:
        one.cache_clear()
    yield
    for one in caches:
        one.cache_clear()


def test_one_claim_reports_the_proofs_that_it_compiles(monkeypatch, no_theorem_is_known):
    """@example of minutes of compiling that were shown as "at work"."""
    shown, theorems = [], library._not_run("", library.pinned())

    def build(progress):
        progress(3, 81, "Pair")
        return theorems

    monkeypatch.setattr(library, "build", build)
    monkeypatch.setattr(library, "_built", library._built.__wrapped__)
    running.rows([claim_named("energy-rate")], Context(), running.Manner(), OnPipe(shown.append, 1))
    last = "1/1 claims checked, last energy-rate"
    assert list(dict.fromkeys(shown)) == ["checking energy-rate", "compiling Coq proofs 3/81", last]
    assert compiling(0, 0, "waiting") == "waiting"


@pytest.mark.parametrize("fresh", [False, True])
def test_fresh_rows_are_decided_though_others_are_kept(store, fresh):
    claim = claim_named("vector-fields")  # without a theorem of the kernel, which would be built
    (row,) = running.rows([claim], Context(), running.Manner(store=store), running.Progress())
    store.keep(replace(plain.plain(row), seconds=-1.0))
    (again,) = running.rows([claim], Context(), running.Manner(store=store, fresh=fresh), running.Progress())
    assert (again.seconds == -1.0) is not fresh
    assert again.finding == row.finding


class Shell:
    """What a pickle runs when it is read."""

    def __reduce__(self):
        return os.system, ("touch ran",)


def outcome(passed):
    return lambda data: [step.update(passed=passed) for step in data["steps"]]


def test_what_was_planted_runs_nothing_and_a_forged_verdict_is_judged_as_any_other(
    settled, store, tmp_path, monkeypatch
):
    """@example of a found fault: the cache was pickles, and one that was planted ran a shell command.

    Its steps must carry a row: what was found false or left open, or rests on nothing, does not.
    """
    monkeypatch.chdir(tmp_path)
    row = next(one for one in settled if one.finding.verdict is Verdict.HOLDS)
    true = plain.as_json(plain.plain(row))

    def forged(change):
        data = json.loads(true)
        change(data)
        return json.dumps(data).encode()

    changes = [outcome(None), outcome(False), lambda data: data["finding"].update(evidence=[])]
    changes += [lambda data: data["finding"].update(verdict="refuted"), lambda data: data.update(claim="another")]
    changes += [lambda data: data.update(proofs=[[[], [], []] for _ in data["proofs"]])]
    changes += [lambda data: data["steps"][0].update(rests_on=[0])]
    planted = [pickle.dumps(Shell()), b"{}", b"[]", b"null", b"\xff", true.encode()[:-2], *map(forged, changes)]
    for body in planted:
        store._store.put(f"{row.claim.id}.json", body)
        assert running.kept([row.claim], store) == {}
    assert not (tmp_path / "ran").exists()
    store._store.put(f"{row.claim.id}.json", true.encode())
    assert running.kept([row.claim], store) == {row.claim.id: row}


def test_the_state_knows_seed_kernel_versions_and_sources(monkeypatch, tmp_path):
    source = tmp_path / "one.py"
    source.write_text("1")
    monkeypatch.setattr(kept, "sources", lambda: [source])
    monkeypatch.setattr(kept.kernel, "why_not", lambda _: "")
    monkeypatch.setattr(kept.kernel, "identity", lambda _: "a kind")
    states = [kept.state(0), kept.state(1)]
    source.write_text("2")
    states.append(kept.state(0))
    changes = [(kept, "version", "0.0"), (kept.kernel, "identity", "1 of a kind")]
    changes += [(kept.kernel, "identity", "2 of a kind"), (kept.platform, "python_version", "another")]
    changes += [(kept.platform, "machine", "another"), (kept.kernel, "why_not", "kernel not run: gone")]
    for place, name, answer in changes:
        monkeypatch.setattr(place, name, lambda *_, answer=answer: answer)
        states.append(kept.state(0))
    assert len(set(states)) == len(states)
    assert kept.state(0) == states[-1]


def test_what_rows_can_depend_on_is_in_the_state_and_what_only_shows_them_is_reached_from_no_check():
    seen = {path.relative_to(ROOT).as_posix() for path in kept.sources()}
    assert {"theory/excursion.py", "numerics/scene/shipped/velocities.toml", "paper_checks/rocq/free/Paper.v"} <= seen
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    declared = project["dependencies"] + project["optional-dependencies"]["checks"]
    assert {re.split("[>=]", line)[0] for line in declared} - SHOWN_WITH <= set(kept.DEPENDENCIES)
    waiting = [*(ROOT / "paper_checks" / "claims").glob("*.py"), ROOT / "paper_checks" / "running" / "runner.py"]
    assert {*workers.SHARING, *workers.ALONE} <= {path.stem for path in waiting}
    reached = set()
    while waiting:
        path = waiting.pop()
        if path.exists() and path not in reached:
            reached.add(path)
            stems = [
                ROOT / name.replace(".", "/") for name in imported_modules(path) if name.startswith("paper_checks.")
            ]
            waiting += [one for stem in stems for one in (stem.with_suffix(".py"), stem / "__init__.py")]
    assert len(reached) > 60
    assert {path.relative_to(ROOT).as_posix() for path in reached} <= seen


def test_a_process_that_ends_costs_its_own_row_only():
    claims = [claim_named(name) for name in QUICK]
    found = list(workers.found(claims, Context(), 2, dies_of_energy_rate))
    (lost,) = [one for one in found if not isinstance(one, plain.Plain)]
    assert (lost.claim.id, lost.finding.verdict) == ("energy-rate", Verdict.UNDECIDED)
    assert "exit code 7" in lost.finding.reason
    verdicts = {one.claim: one.finding.verdict for one in found if isinstance(one, plain.Plain)}
    assert verdicts == {claim.id: claim.recorded for claim in claims if claim is not lost.claim}


def test_the_bytes_are_the_same_from_one_process_from_two_and_from_the_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("PATH", "")  # no kernel: it would compile its proofs into that folder

    def run(*words):
        return subprocess.run(
            [sys.executable, "-m", "paper_checks", *words, "--json", *QUICK], capture_output=True, check=False
        )

    one, two, again = run("--jobs", "1"), run("--jobs", "2", "--fresh"), run()
    assert (one.returncode, one.stderr) == (0, b"")
    assert one.stdout == two.stdout == again.stdout
    assert {row["id"] for row in json.loads(one.stdout)} == set(QUICK)
    assert len(list(tmp_path.rglob("*.json"))) == len(QUICK)


def test_ctrl_c_ends_all_processes_and_says_one_word(tmp_path):
    code, _, errors = interrupted("paper_checks", ["--fresh", "--jobs", "2"], "paper_checks.running.workers", tmp_path)
    assert (code, errors) == (130, "paper_checks: interrupted\n")
