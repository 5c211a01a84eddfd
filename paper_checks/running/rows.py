"""The rows of claims: the kernel is asked about their theorems, their checks are run here or in several processes."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence

from paper_checks.claims import claim_named
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.finding import Finding
from paper_checks.proofs import library
from paper_checks.proofs.library import Proved
from paper_checks.running import processes
from paper_checks.running.runner import Context, Row, decide, failed, row


class Progress:
    """Shows nothing; base class of those that do."""

    def compiled(self, done: int, total: int) -> None:
        """Show how many proof files are compiled."""

    def begun(self, claim: Claim) -> None:
        """Show which claim is being checked."""

    def found(self, row: Row) -> None:
        """Show the verdict of a claim."""


def rows(claims: Sequence[Claim], context: Context, jobs: int = 1, progress: Progress | None = None) -> list[Row]:
    """Return a row for each claim, in the claims' order; what it says does not depend on the number of processes.

    With one, it is this process, and what a test has planted in it reaches the checks.
    """
    shown = progress or Progress()
    found: dict[str, Row] = {}
    with library.reported(shown.compiled):
        known = library.prepare(theorems(claims), jobs)
        several = min(jobs, len(claims)) > 1
        for claim, finding, seconds in (
            _in_processes(claims, context, jobs, known) if several else _here(claims, context, shown)
        ):
            found[claim.id] = row(claim, finding, seconds)
            shown.found(found[claim.id])
    return [found[claim.id] for claim in claims]


def theorems(claims: Sequence[Claim]) -> tuple[str, ...]:
    """Return the ids of the kernel's theorems that the clauses name."""
    clauses = (clause for claim in claims for clause in (*claim.clauses, *claim.correction))
    return tuple(dict.fromkeys(name for clause in clauses for name in clause.kernel))


def _here(claims: Sequence[Claim], context: Context, shown: Progress) -> Iterator[tuple[Claim, Finding, float]]:
    for claim in claims:
        shown.begun(claim)
        yield claim, *_decided(claim, context)


def _in_processes(
    claims: Sequence[Claim], context: Context, jobs: int, known: Mapping[str, Proved]
) -> Iterator[tuple[Claim, Finding, float]]:
    named = {claim.id: claim for claim in claims}
    for name, answer in processes.answers(list(named), jobs, found, (context, known)):
        lost = failed(RuntimeError("its process ended without an answer")), 0.0
        yield named[name], *(lost if isinstance(answer, processes.Ended) else answer)


def found(name: str, given: tuple[Context, Mapping[str, Proved]]) -> tuple[Finding, float]:
    """Decide a claim, in a process of its own, and say how many seconds that took."""
    context, known = given
    library.know(known)
    return _decided(claim_named(name), context)


def _decided(claim: Claim, context: Context) -> tuple[Finding, float]:
    begin = time.perf_counter()
    return decide(claim, context), time.perf_counter() - begin
