"""The rows of claims, from where they come quickest: the cache, or a run of their checks in several processes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from paper_checks.evidence.claim import Claim
from paper_checks.proofs.library import build, reported
from paper_checks.running import early, plain, runner
from paper_checks.running.kept import Kept
from paper_checks.running.runner import Context


class Progress:
    """Shows nothing; base class of those that do."""

    def compiled(self, done: int, total: int, name: str) -> None:
        """Show how many proof files are compiled; (0, 0, why) while waiting."""

    def begun(self, claim: Claim) -> None:
        """Show which claim is being checked."""

    def found(self, row: runner.Row) -> None:
        """Show the verdict of a claim."""


@dataclass(frozen=True)
class Manner:
    """How rows are come by; what they say does not depend on it."""

    jobs: int = 1
    """Processes that decide rows; with one, it is this process, and what a test has planted in it reaches the checks."""
    store: Kept | None = None
    """Where rows are kept, if they are."""
    fresh: bool = False
    """Whether no row is taken from there."""


def rows(claims: Sequence[Claim], context: Context, manner: Manner, progress: Progress) -> list[runner.Row]:
    """Return a row for each claim, in the claims' order."""
    found: dict[str, runner.Row] = {}
    for row in _rows(claims, context, manner, progress):
        found[row.claim.id] = row
        progress.found(row)
    return [found[claim.id] for claim in claims]


def kept(claims: Sequence[Claim], store: Kept) -> dict[str, runner.Row]:
    """Return by id the rows that are kept, deciding none."""
    return {claim.id: one for claim in claims if (one := _kept(claim, store))}


def _kept(claim: Claim, store: Kept) -> runner.Row | None:
    one = store.row(claim.id)
    try:
        return plain.row(claim, one) if one else None
    except ValueError:  # of other clauses, or of steps that do not carry it: nothing of ours wrote that
        return None


def _rows(claims: Sequence[Claim], context: Context, manner: Manner, progress: Progress) -> Iterator[runner.Row]:
    store = manner.store
    missing = []
    for claim in claims:
        kept = _kept(claim, store) if store and not manner.fresh else None
        if kept:
            yield kept
        else:
            missing.append(claim)
    for row in _decided(missing, context, manner.jobs, progress):
        if store:
            store.keep(plain.plain(row))
        yield row
    if store:
        store.forget_old()


def _decided(claims: Sequence[Claim], context: Context, jobs: int, progress: Progress) -> Iterator[runner.Row]:
    """Decide claims: one after the other here, or in processes."""
    if min(jobs, len(claims)) < 2:
        for claim in claims:
            progress.begun(claim)
            with reported(progress.compiled):
                row = runner.run([claim], context)[0]
            yield row
        return
    from paper_checks.running import workers

    early.begin()
    build(progress.compiled, jobs)  # once, before the processes ask for it
    named = {claim.id: claim for claim in claims}
    for one in workers.found(claims, context, jobs):
        yield plain.row(named[one.claim], one) if isinstance(one, plain.Plain) else one
