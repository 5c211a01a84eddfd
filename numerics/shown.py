"""Output of the commands: tables, figures and progress."""

from __future__ import annotations

import logging
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numerics.files import whole_file

if TYPE_CHECKING:
    from rich.console import Console

_EVERY = 5.0
"""Seconds between two progress lines, where stderr is no terminal."""


def console(width: int | None) -> Console:
    """Return what prints to stdout, without a width as wide as the terminal; a reader that leaves ends the command."""
    from rich.console import Console

    class Piped(Console):
        def on_broken_pipe(self) -> None:
            raise  # noqa: PLE0704 - called where the pipe broke; the library would exit with 1, as a failure does

    return Piped(width=width, highlight=False)


def print_table(head: Sequence[str], lines: Iterable[Sequence[str]]) -> None:
    """Print a table: as wide as the terminal, or 200 characters."""
    from rich.markup import escape
    from rich.table import Table

    table = Table(*head, box=None, pad_edge=False)
    for line in lines:
        table.add_row(*map(escape, line))
    console(None if sys.stdout.isatty() else 200).print(table)


def write_figure(figure: Any, path: Path) -> None:
    """Write a matplotlib figure to a .svg, .pdf or .png file."""
    with whole_file(path) as file:
        figure.savefig(file, format=path.suffix[1:], dpi=200)


class _Latest(logging.StreamHandler[Any]):
    """The last message logged; on a terminal it is shown at once."""

    terminator, said = "", "computing"

    def format(self, record: logging.LogRecord) -> str:
        """Keep a message, and return it so that it replaces the line on a terminal."""
        self.said = record.getMessage()
        return f"\r\033[K{self.said}" if sys.stderr.isatty() else ""


@contextmanager
def shown_steps() -> Iterator[Callable[[str], None]]:
    """Show progress on stderr: on a terminal one line that disappears at the end, else a line every few seconds.

    Yields the function that logs a message.
    """
    log, latest, began, ended = logging.getLogger("numerics"), _Latest(), time.monotonic(), threading.Event()

    def tell() -> None:
        while not (ended.wait(_EVERY) or sys.stderr.isatty()):
            sys.stderr.write(f"{latest.said} ({time.monotonic() - began:.0f} s)\n")
            sys.stderr.flush()

    log.addHandler(latest)
    log.setLevel(logging.INFO)
    teller = threading.Thread(target=tell, daemon=True)
    teller.start()
    try:
        yield log.info
    finally:
        ended.set()
        teller.join(1.0)
        log.info("")
        log.removeHandler(latest)
