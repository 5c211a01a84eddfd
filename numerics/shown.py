"""What the commands show: tables, figures, and what is being done."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from numerics.files import whole_file


def print_table(head: Sequence[str], lines: Iterable[Sequence[str]]) -> None:
    """Print a table: as wide as the terminal, or 200 characters."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table(*head, box=None, pad_edge=False)
    for line in lines:
        table.add_row(*map(escape, line))
    Console(width=None if sys.stdout.isatty() else 200, highlight=False).print(table)


def write_figure(figure: Any, path: Path) -> None:
    """Write a matplotlib figure to a .svg, .pdf or .png file."""
    with whole_file(path) as file:
        figure.savefig(file, format=path.suffix[1:], dpi=200)


@contextmanager
def shown_steps() -> Iterator[Callable[[str], None]]:
    """Yield what shows on stderr what is being done, one line that goes away at the end; on a terminal only."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    try:
        yield lambda what: print(f"\r\033[K{what}", end="", file=sys.stderr, flush=True)
    finally:
        print("\r\033[K", end="", file=sys.stderr, flush=True)
