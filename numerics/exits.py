"""Exit codes of the commands, and the one way to refuse; what is wrong with the name of a file to be written."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import NoReturn

OK, FAILED, USAGE, INTERRUPTED = 0, 1, 2, 130
"""Done; undecided, out of reach or a tool that is missing; bad usage or an invalid scene; stopped by the user."""
FIGURES = (".svg", ".pdf", ".png")
"""How the name of a figure may end."""


def refuse(message: str, code: int) -> int:
    """Print one error line on stderr and return the exit code."""
    print(f"error: {' '.join(message.split())}", file=sys.stderr)
    return code


def drop_output() -> None:
    """Send what is still buffered for stdout nowhere, so that the interpreter's last flush does not fail again."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def wrong_path(path: Path | None, figure_flag: str = "") -> str | None:
    """Return what is wrong with a path to write to, or None; a figure is named by the flag that asked for it."""
    if path is None:
        return None
    if path.is_dir():
        return f"{str(path)!r} is a folder; name a file in it"
    if not path.parent.is_dir():
        return f"folder {str(path.parent)!r} does not exist; make it, or write elsewhere"
    if figure_flag and path.suffix not in FIGURES:
        return f"{figure_flag} {path.name}: the name must end in one of {', '.join(FIGURES)}"
    return None


class OneLineParser(argparse.ArgumentParser):
    """A parser, with its subparsers, that tells bad usage in one line on stderr; --help shows the usage."""

    def error(self, message: str) -> NoReturn:
        """Print the one error line and exit with USAGE."""
        self.exit(refuse(message, USAGE))
