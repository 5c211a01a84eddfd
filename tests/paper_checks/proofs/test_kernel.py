"""Compiling: what is kept, broken files by name, interrupts. On two small files, a second each."""

import signal
import subprocess
import sys
import time

import pytest

from paper_checks.proofs import kernel
from paper_checks.proofs.sources import Source

LOW = "Lemma one : True.\nProof. exact I. Qed.\n"
HIGH = "From InertialPair Require Import Low.\nTheorem two : True.\nProof. exact one. Qed.\n"
ASIDE = Source("Aside", "Lemma three : False.\nProof. exact 0. Qed.\n")

needs_kernel = pytest.mark.usefixtures("needs_kernel")


def compiled(store, low=LOW, high=HIGH):
    """What compiling has come to, and how many files were compiled; what nobody needs is not."""
    seen = []
    sources = {"High": Source("High", high), "Low": Source("Low", low), "Aside": ASIDE}
    outcome = kernel.compile_files(["High"], sources, lambda *counts: seen.append(counts), store=store)
    assert not seen or seen[-1][0] == seen[-1][1]
    return outcome, seen[-1][1] if seen else 0


@needs_kernel
def test_what_is_compiled_is_compiled_once(tmp_path):
    first, count = compiled(tmp_path)
    assert (set(first.folders), first.broken, count) == ({"Low", "High"}, {}, 2)
    assert compiled(tmp_path)[1] == 0
    assert compiled(tmp_path, high=HIGH + "(* changed *)")[1] == 1
    assert compiled(tmp_path, low=LOW + "(* changed *)")[1] == 2


@needs_kernel
def test_a_broken_proof_is_named_and_so_is_what_rests_on_it(tmp_path):
    outcome, _ = compiled(tmp_path, low=LOW.replace("exact I", "exact 0"))
    assert outcome.broken["Low"].startswith("Low.one is not proved (line 2 of Low.v): ")
    assert outcome.broken["High"] == "High.v rests on Low.v, which does not compile"
    assert not list(tmp_path.glob(".compiling-*"))
    (above,) = compiled(tmp_path, high=HIGH.replace("True", "False"))[0].broken.items()
    assert above[1].startswith("High.two is not proved")


@needs_kernel
def test_an_interrupt_leaves_nothing_that_could_be_taken_for_a_proof(tmp_path):
    endless = "Goal True. Proof. do 1000000000 (idtac; idtac). exact I. Qed."
    code = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # whatever the shell does
        "from pathlib import Path; from paper_checks.proofs import kernel, sources\n"
        f"sources = {{'Low': sources.Source('Low', {endless!r})}}\n"
        f"kernel.compile_files(sources, sources, store=Path({str(tmp_path)!r}))"
    )
    run = subprocess.Popen([sys.executable, "-c", code], stderr=subprocess.PIPE, text=True)
    until = time.monotonic() + 60
    while not list(tmp_path.glob(".compiling-*/Low.v")) and time.monotonic() < until:
        time.sleep(0.05)
    time.sleep(0.5)  # the compiler has begun
    run.send_signal(signal.SIGINT)
    _, errors = run.communicate(timeout=60)
    assert "KeyboardInterrupt" in errors
    assert not list(tmp_path.iterdir())


def test_without_the_compiler_the_reason_is_one_line_that_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    reason = kernel.why_not()
    assert reason.startswith("kernel not run: coqc is not installed")
    assert "libcoq-coquelicot" in reason
    assert "\n" not in reason


def test_where_nothing_can_be_kept_the_kernel_is_not_run(monkeypatch, tmp_path):
    (tmp_path / "no folder").touch()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "no folder"))
    monkeypatch.setattr(kernel, "_missing", lambda _: "")
    reason = kernel.why_not()
    assert reason.startswith("kernel not run: the user's cache cannot be written (")
    assert str(tmp_path) not in reason  # the report says it, and is the same everywhere


def test_another_library_beside_the_kernel_is_another_kernel(tmp_path):
    coqc, beside = tmp_path / "coqc", tmp_path / "user-contrib" / "Interval" / "One.vo"
    beside.parent.mkdir(parents=True)
    coqc.write_text(f"#!/bin/sh\necho {tmp_path}\n")
    coqc.chmod(0o700)
    identities = []
    for text in ("1", "12"):
        beside.write_text(text)
        identities.append(kernel.identity.__wrapped__(str(tmp_path)))
    assert identities[0] != identities[1]
