"""How far a run is, on stderr: each verdict as it is found and a bar beneath; a line now and then where it is no terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from numerics.shown import shown_steps
from paper_checks.evidence.claim import Claim
from paper_checks.report.formats.terminal import STYLES
from paper_checks.running.rows import Progress
from paper_checks.running.runner import Row


class OnTerminal(Progress):
    """Tells a terminal."""

    def __init__(self, shown: Any, total: int) -> None:
        """Add one bar to what rich shows."""
        self._shown, self._bar = shown, shown.add_task("", total=total)

    def compiled(self, done: int, total: int, name: str) -> None:
        """Show the proof file beside the bar."""
        self._shown.update(self._bar, description=f"proofs {done}/{total} {name}")

    def begun(self, claim: Claim) -> None:
        """Show the claim beside the bar."""
        self._shown.update(self._bar, description=claim.id)

    def found(self, row: Row) -> None:
        """Print the verdict above the bar."""
        verdict = row.finding.verdict
        self._shown.console.print(f"[{STYLES[verdict]}]{verdict.value:<15}[/] {row.claim.id}", highlight=False)
        self._shown.update(self._bar, advance=1, description="")


class OnPipe(Progress):
    """Tells a pipe, now and then."""

    def __init__(self, say: Callable[[str], None]) -> None:
        """Take what shows its last line every few seconds."""
        self._say = say

    def compiled(self, done: int, total: int, name: str) -> None:
        """Tell the proof file."""
        self._say(f"proofs {done}/{total} {name}")

    def found(self, row: Row) -> None:
        """Tell the claim."""
        self._say(row.claim.id)


@contextmanager
def progress(total: int) -> Iterator[Progress]:
    """Show how many of `total` rows are found; off a terminal, which one was last."""
    if not sys.stderr.isatty():
        with shown_steps() as say:
            yield OnPipe(say)
        return
    with _bar() as shown:
        yield OnTerminal(shown, total)


@contextmanager
def parts(total: int) -> Iterator[Callable[[str], None]]:
    """Show a bar for `total` chapters and figures; what is yielded tells that one is made."""
    if not sys.stderr.isatty():
        with shown_steps() as say:
            yield say
        return
    with _bar() as shown:
        bar = shown.add_task("drawing", total=total)
        yield lambda name: shown.update(bar, advance=1, description=name)


def _bar() -> Any:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bar

    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    return Bar(*columns, console=Console(stderr=True), transient=True)
