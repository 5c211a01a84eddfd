"""A task that kills the process that works on it, once; importable by that process."""

import os
import signal
from pathlib import Path


def squared(task: tuple[int, str]) -> tuple[int, int]:
    """A number and its square; whoever is the first to take number 7 dies of it, and leaves a file behind."""
    number, mark = task
    if number == 7 and not Path(mark).exists():
        Path(mark).write_text("killed", "utf-8")
        os.kill(os.getpid(), signal.SIGKILL)
    return number, number * number
