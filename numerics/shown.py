"""Output of the commands: tables and figures."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numerics.files import whole_file

if TYPE_CHECKING:
    from rich.console import Console


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
