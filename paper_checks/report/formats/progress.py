"""Progress on stderr: on a terminal a bar, with verdicts above it; otherwise one line every few seconds."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from numerics.meter import shown_steps
from paper_checks.evidence.claim import Claim
from paper_checks.report.formats.terminal import STYLES
from paper_checks.running.rows import Progress
from paper_checks.running.runner import Row

Step = Callable[[str, int, str], None]
"""Says what is at work, that so many steps have ended, and a line that stays on a terminal."""


class Claims(Progress):
    """Progress of claims."""

    def __init__(self, step: Step, total: int) -> None:
        """Take what shows a step, and the number of claims."""
        self._step, self._total, self._done = step, total, 0

    def compiled(self, done: int, total: int) -> None:
        """Say how many proof files are compiled."""
        self._step(f"compiling Coq proofs {done}/{total}", 0, "")

    def begun(self, claim: Claim) -> None:
        """Say which claim is being checked."""
        self._step(f"checking {claim.id}", 0, "")

    def found(self, row: Row) -> None:
        """Say how many claims are checked, and the last verdict."""
        self._done += 1
        verdict, name = row.finding.verdict, row.claim.id
        line = f"[{STYLES[verdict]}]{verdict.value:<15}[/] {name}"
        self._step(f"{self._done}/{self._total} claims checked, last {name}", 1, line)


@contextmanager
def progress(total: int) -> Iterator[Claims]:
    """Show how many of `total` claims are checked."""
    with steps(total) as step:
        yield Claims(step, total)


@contextmanager
def steps(total: int) -> Iterator[Step]:
    """Show how many of `total` steps have ended."""
    if not sys.stderr.isatty():
        with shown_steps() as say:
            yield lambda text, *_: say(text)
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bar

    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    with Bar(*columns, console=Console(stderr=True), transient=True) as shown:
        bar = shown.add_task("", total=total)

        def step(text: str, done: int, line: str) -> None:
            if line:
                shown.console.print(line, highlight=False)
            shown.update(bar, advance=done, description=text)

        yield step
