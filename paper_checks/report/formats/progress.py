"""Progress on stderr: on a terminal each verdict with a bar below, otherwise one line every few seconds."""

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


def compiling(done: int, total: int) -> str:
    """Return the text while Coq proofs are compiled."""
    return f"compiling Coq proofs {done}/{total}"


class OnTerminal(Progress):
    """Progress on a terminal."""

    def __init__(self, shown: Any, total: int) -> None:
        """Add one bar to what rich shows."""
        self._shown, self._bar = shown, shown.add_task("", total=total)

    def compiled(self, done: int, total: int) -> None:
        """Show the number of compiled files beside the bar."""
        self._shown.update(self._bar, description=compiling(done, total))

    def begun(self, claim: Claim) -> None:
        """Show the claim beside the bar."""
        self._shown.update(self._bar, description=claim.id)

    def found(self, row: Row) -> None:
        """Print the verdict above the bar."""
        verdict = row.finding.verdict
        self._shown.console.print(f"[{STYLES[verdict]}]{verdict.value:<15}[/] {row.claim.id}", highlight=False)
        self._shown.update(self._bar, advance=1, description="")


class OnPipe(Progress):
    """Progress off a terminal: the last message, every few seconds."""

    def __init__(self, say: Callable[[str], None], total: int) -> None:
        """Take the function that shows a message, and the number of claims."""
        self._say, self._total, self._done = say, total, 0

    def compiled(self, done: int, total: int) -> None:
        """Say how many proof files are compiled."""
        self._say(compiling(done, total))

    def begun(self, claim: Claim) -> None:
        """Say which claim is being checked."""
        self._say(f"checking {claim.id}")

    def found(self, row: Row) -> None:
        """Say how many claims are checked, and which was the last."""
        self._done += 1
        self._say(f"{self._done}/{self._total} claims checked, last {row.claim.id}")


@contextmanager
def progress(total: int) -> Iterator[Progress]:
    """Show how many of `total` claims are checked."""
    if not sys.stderr.isatty():
        with shown_steps() as say:
            yield OnPipe(say, total)
        return
    with _bar() as shown:
        yield OnTerminal(shown, total)


@contextmanager
def figures(total: int) -> Iterator[Callable[[str], None]]:
    """Show a bar for `total` figures; call what is yielded with the name of each that is finished."""
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
