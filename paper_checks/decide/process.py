"""SMT solvers in processes of their own that stay for the next question: starting one takes longer than most answers.

Each question gets a solver with nothing in it, so an answer does not depend on what was asked before. A process that
does not answer in time is ended, whatever the solver inside does; the next question starts another one.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import Any

_STAYING: dict[tuple[int, str], subprocess.Popen[str]] = {}
"""By this process and the solver: a process that is forked off has none of its parent's. Each ends with its stdin."""


def answer(solver: str, texts: Sequence[str], seconds: float) -> dict[str, Any] | None:
    """Put texts to a solver, with a limit (s) for each; None where it does not keep to it.

    Raises RuntimeError, with the solver's last words, where it fails.
    """
    key, pipe = (os.getpid(), solver), subprocess.PIPE
    # by its file: the package loads sympy
    command = [sys.executable, "-P", str(Path(__file__).with_name("worker.py")), solver]
    process = _STAYING.pop(key, None) or subprocess.Popen(
        command, stdin=pipe, stdout=pipe, stderr=pipe, encoding="utf-8"
    )
    assert process.stdin
    assert process.stdout
    # starting, and what a solver needs to notice its own limit, take up to two seconds
    timer = threading.Timer(len(texts) * seconds + 2, process.kill)
    timer.start()
    try:
        print(json.dumps({"texts": texts, "seconds": seconds}), file=process.stdin, flush=True)
        reply = process.stdout.readline()
    except BrokenPipeError:
        reply = ""
    finally:
        in_time = timer.is_alive()
        timer.cancel()
    if reply:
        _STAYING[key] = process
        found: dict[str, Any] = json.loads(reply)
        return found
    process.kill()
    _, errors = process.communicate()
    if in_time:
        raise RuntimeError(" ".join(errors.strip().splitlines()[-1:]))
    return None
