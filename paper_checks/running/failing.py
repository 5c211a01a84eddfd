"""What fails first: of the steps that did not pass, those that rest on no other one that did not."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from paper_checks.evidence.evidence import Evidence, EvidenceKind, closure
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Row

BEFORE_THE_MODEL = ("Abstract", "I")
"""Sections of the paper that speak of what later ones derive."""


@dataclass(frozen=True)
class Failure:
    """A step that fails and rests on none that does, or what was raised in its place, and the claims that it turns."""

    statement: str
    value: str
    claims: tuple[str, ...]


def lowest(rows: Iterable[Row]) -> list[Failure]:
    """Return the lowest failing steps of the claims whose verdict is not the recorded one.

    First, in the order of the paper from its model on, the formulas that are not what is derived: it is the order of the
    derivation. Then those with the fewest steps below them, and of these the ones that turn most claims. A theorem of the kernel comes
    last, as it is tied to the expressions that the others check.
    """
    found: defaultdict[tuple[str, str], list[tuple[tuple[bool, bool, int], str]]] = defaultdict(list)
    for row in sorted(rows, key=lambda row: row.claim.section in BEFORE_THE_MODEL):
        if row.as_recorded or row.finding.verdict is Verdict.UNCHECKED:
            continue
        steps = list(_lowest(row))
        formulas = {step for proof in row.proofs for step in proof.bindings}
        for step in steps:
            rank = step.kind is EvidenceKind.KERNEL, step not in formulas, len(closure(step.rests_on))
            found[step.statement, step.value].append((rank, row.claim.id))
        if not steps:
            found[row.finding.missing or row.finding.reason, ""].append(((False, True, 0), row.claim.id))
    order = sorted(found, key=lambda name: (min(found[name])[0], -len(found[name]) * min(found[name])[0][1]))
    return [Failure(*name, tuple(dict.fromkeys(claim for _, claim in found[name]))) for name in order]


def _lowest(row: Row) -> Iterator[Evidence]:
    """Yield the steps of a row that did not pass, and rest on none that did not."""
    of_proofs = (step for proof in row.proofs for step in (*proof.kernel, *proof.steps, *proof.bindings))
    for step in closure((*row.finding.evidence, *of_proofs)):
        if step.passed is not True and all(below.passed is True for below in closure(step.rests_on)):
            yield step
