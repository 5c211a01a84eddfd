"""Rows in parallel: processes that load the checks once and are given one claim at a time.

A process that ends without an answer costs its own row only, which is undecided.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator, Sequence
from functools import cache

from paper_checks.claims import claim_named
from paper_checks.evidence.claim import Claim
from paper_checks.running import early, processes
from paper_checks.running.plain import Plain, plain
from paper_checks.running.runner import Context, Row, failed, run

SHARING = (
    "near_critical",
    "convergence",
    "itineraries",
    "return_map",
    "rate",
    "long_time",
    "uniform_rate",
    "slips",
    "critical_ratio",
    "merging",
)
"""Subjects that derive the same long series, which a process then has: they stand together, at the front."""
ALONE = ("euler", "merging_share")
"""Subjects that take long and share little: they stand at the back, the longest at the end, where the other processes begin."""


def found(
    claims: Sequence[Claim], context: Context, jobs: int, answer: processes.Answer | None = None
) -> Iterator[Row | Plain]:
    """Decide the claims in `jobs` processes, and yield each as soon as it is found, in any order.

    `answer` is what runs in each of them.
    """
    early.begin()
    named = {claim.id: claim for claim in sorted(claims, key=_place)}
    for name, found in processes.answers(list(named), jobs, answer or decided, context):
        if isinstance(found, processes.Ended):
            yield Row(named[name], failed(RuntimeError(f"its process ended with exit code {found.exit_code}")))
        else:
            yield found


def _place(claim: Claim) -> int:
    """Return where a claim stands among those that wait; claims in the same place keep the ledger's order."""
    subject, order = claim.case.__module__.rpartition(".")[2] if claim.case else "", (*SHARING, "", *ALONE)
    return order.index(subject if subject in order else "")


def decided(name: str, context: Context) -> Plain:
    """Decide a claim, in a process that has loaded them all."""
    _settle()
    return plain(run([claim_named(name)], context)[0])


@cache
def _settle() -> None:
    """Leave what is loaded alone: most expressions go by themselves, and looking for the others takes 3 %."""
    gc.freeze()
    gc.set_threshold(100_000, 20, 20)
