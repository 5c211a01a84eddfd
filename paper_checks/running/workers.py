"""Rows in parallel: processes that load the checks once and are given one claim at a time.

A process that ends without an answer costs its own row only, which is undecided.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator, Sequence
from functools import cache

from paper_checks.checks.registry import Context, Registry, load_checks
from paper_checks.ledger import Claim, claim_named
from paper_checks.running import early, processes
from paper_checks.running.plain import Plain, plain
from paper_checks.running.runner import Row, failed, run

SHARING = (
    "section3_near_critical",
    "section3_convergence",
    "section3_itineraries",
    "theorems_return_map",
    "theorems_rate",
    "theorems_uniform",
    "theorems_excursion",
    "theorems_merging",
)
"""Checks that derive the same long series, which a process then has: they stand together, at the front."""
ALONE = ("section4_euler", "theorems_share")
"""Checks that take long and share little: they stand at the back, the longest at the end, where the other processes begin."""


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
    modules = [check.__module__.rpartition(".")[2] for check in load_checks().of(claim.id)]
    order = (*SHARING, "", *ALONE)
    return next((order.index(module) for module in modules if module in order), order.index(""))


def decided(name: str, context: Context) -> Plain:
    """Decide a claim, in a process that has loaded the checks."""
    return plain(run([claim_named(name)], _loaded(), context)[0])


@cache
def _loaded() -> Registry:
    registry = load_checks()
    # what is loaded stays; of the expressions that are made most go by themselves, and looking for the others takes 3 %
    gc.freeze()
    gc.set_threshold(100_000, 20, 20)
    return registry
