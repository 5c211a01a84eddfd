"""SMT solvers in processes of their own that stay for the next question: starting one takes longer than most answers.

Each question gets a solver with nothing in it, so an answer does not depend on what was asked before. A process that
does not answer in time is ended, whatever the solver inside does; the next question starts another one.
"""

from __future__ import annotations

import atexit
import json
import os
import subprocess
import sys
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import Any

_STAYING: dict[tuple[int, str], _SolverProcess] = {}
"""By this process and the solver: a process that is forked off has none of its parent's."""


class _SolverProcess:
    """One solver that answers lines of JSON on its stdin with lines of JSON."""

    def __init__(self, solver: str) -> None:
        """Start it."""
        self._process = subprocess.Popen(
            [
                sys.executable,
                "-P",
                Path(__file__).with_name("worker.py"),
                solver,
            ],  # by its file: the package loads sympy
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            encoding="utf-8",
        )

    def ask(self, question: str, patience: float) -> str | None:
        """Return the answer; None where there is none within the patience (s). Raises RuntimeError where it fails."""
        assert self._process.stdin
        assert self._process.stdout
        assert self._process.stderr
        timer = threading.Timer(patience, self._process.kill)
        timer.start()
        try:
            self._process.stdin.write(question + "\n")
            self._process.stdin.flush()
            answer = self._process.stdout.readline()
        except BrokenPipeError:
            answer = ""
        finally:
            in_time = timer.is_alive()
            timer.cancel()
        if answer:
            return answer
        if in_time:
            raise RuntimeError(" ".join(self._process.stderr.read().strip().splitlines()[-1:]))
        return None

    def end(self) -> None:
        """End it, at once."""
        self._process.kill()
        self._process.communicate()


def answer(solver: str, texts: Sequence[str], seconds: float) -> dict[str, Any] | None:
    """Put texts to a solver, with a limit (s) for each; None where it does not keep to it.

    Raises RuntimeError, with the solver's last words, where it fails.
    """
    key = os.getpid(), solver
    if key not in _STAYING:
        _STAYING[key] = _SolverProcess(solver)
    reply = None
    try:
        # starting, and what a solver needs to notice its own limit, take up to two seconds
        reply = _STAYING[key].ask(json.dumps({"texts": texts, "seconds": seconds}), len(texts) * seconds + 2)
    finally:
        if reply is None:  # out of time, failed, or interrupted in the middle of an answer
            _STAYING.pop(key).end()
    found: dict[str, Any] | None = json.loads(reply) if reply else None
    return found


@atexit.register
def _end_all() -> None:
    for key in [one for one in _STAYING if one[0] == os.getpid()]:
        _STAYING.pop(key).end()
