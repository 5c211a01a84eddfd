"""Compiling: the cache, broken files by name, interrupts. On two small files, a second each."""

import os
import signal
import subprocess
import sys
import time

import pytest

from paper_checks.proofs import kernel
from paper_checks.proofs.sources import Source

LOW = "Lemma one : True.\nProof. exact I. Qed.\n"
HIGH = "From InertialPair Require Import Low.\nTheorem two : True.\nProof. exact one. Qed.\n"

pytestmark = pytest.mark.usefixtures("needs_kernel")


def compiled(store, low=LOW, high=HIGH):
    seen = []
    sources = {"High": Source("High", high), "Low": Source("Low", low)}
    found = kernel.compile_all(sources, lambda done, total, name: seen.append((done, total, name)), store=store)
    assert seen[-1][:2] == (2, 2)
    return found


def test_what_is_compiled_is_compiled_once(tmp_path):
    assert compiled(tmp_path).anew == 2
    again = compiled(tmp_path)
    assert (again.anew, again.broken) == (0, {})
    assert compiled(tmp_path, high=HIGH + "(* changed *)").anew == 1


def test_a_broken_proof_is_named_and_so_is_what_rests_on_it(tmp_path):
    found = compiled(tmp_path, low=LOW.replace("exact I", "exact 0"))
    assert found.broken["Low"].startswith("Low.one is not proved (line 2 of Low.v): ")
    assert found.broken["High"] == "High.v rests on Low.v, which does not compile"
    assert not list(tmp_path.glob(".compiling-*"))
    (above,) = compiled(tmp_path, high=HIGH.replace("True", "False")).broken.items()
    assert above[1].startswith("High.two is not proved")


def test_an_interrupt_leaves_nothing_that_could_be_taken_for_a_proof(tmp_path):
    endless = "Goal True. Proof. do 1000000000 (idtac; idtac). exact I. Qed."
    code = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # whatever the shell does
        "from pathlib import Path; from paper_checks.proofs import kernel, sources\n"
        f"kernel.compile_all({{'Low': sources.Source('Low', {endless!r})}}, store=Path({str(tmp_path)!r}))"
    )
    run = subprocess.Popen([sys.executable, "-c", code], stderr=subprocess.PIPE, text=True)
    until = time.monotonic() + 60
    while not list(tmp_path.glob(".compiling-*/errors")) and time.monotonic() < until:
        time.sleep(0.05)
    run.send_signal(signal.SIGINT)
    _, errors = run.communicate(timeout=60)
    assert "KeyboardInterrupt" in errors
    assert not list(tmp_path.iterdir())


def test_without_the_compiler_the_reason_is_one_line_that_says_what_to_install(tmp_path):
    assert kernel.why_not(os.environ["PATH"]) == ""
    reason = kernel.why_not(str(tmp_path))
    assert reason.startswith("kernel not run: coqc is not installed")
    assert "libcoq-coquelicot" in reason
    assert "\n" not in reason
