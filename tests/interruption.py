"""Interrupting a command in a known state, however loaded the machine is."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

_WATCHED = """
import runpy, signal, sys, threading, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # whatever the shell that started the tests does

def watch():
    while {module!r} not in sys.modules:
        time.sleep(0.005)
    sys.stdout.write("begun\\n")
    sys.stdout.flush()

threading.Thread(target=watch, daemon=True).start()
sys.argv = [{package!r}, *{arguments!r}]
runpy.run_module({package!r}, run_name="__main__", alter_sys=True)
"""


def interrupted(package: str, arguments: list[str], module: str, folder: Path) -> tuple[int, str, str]:
    """Run `python -m package arguments`, interrupt it once it has imported the module; return code, output and errors.

    Commands import what is heavy when they need it: a module that is there says how far the command is.
    """
    code = _WATCHED.format(module=module, package=package, arguments=arguments)
    process = subprocess.Popen(
        [sys.executable, "-c", code], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n", "it ended before it could be interrupted"
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=300)
    return process.returncode, output, errors
