"""What fails first: of the steps that did not pass, those that rest on no other one that did not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from paper_checks.evidence.evidence import Evidence, EvidenceKind, closure
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Row


@dataclass(frozen=True)
class Failure:
    """A step that fails and rests on none that does, or what was raised in its place, and the claims that it turns."""

    statement: str
    value: str
    claims: tuple[str, ...]


def lowest(rows: Iterable[Row]) -> list[Failure]:
    """Return the lowest failing steps of the claims whose verdict is not the recorded one.

    A step of the kernel comes after all others, as it is tied to the expressions that they check; then the one with the
    fewest steps below it comes first, and of these the one that turns most claims.
    """
    claims: dict[tuple[str, str], list[str]] = {}
    ranks: dict[tuple[str, str], tuple[bool, int]] = {}
    for row in rows:
        if row.as_recorded or row.finding.verdict is Verdict.UNCHECKED:
            continue
        steps = list(_lowest(row))
        for step in steps:
            name = step.statement, step.value
            claims.setdefault(name, []).append(row.claim.id)
            ranks[name] = step.kind is EvidenceKind.KERNEL, len(closure(step.rests_on))
        if not steps:
            name = row.finding.missing or row.finding.reason, ""
            claims.setdefault(name, []).append(row.claim.id)
            ranks[name] = False, 0
    order = sorted(claims, key=lambda name: (ranks[name], -len(claims[name])))
    return [Failure(*name, tuple(dict.fromkeys(claims[name]))) for name in order]


def _lowest(row: Row) -> Iterator[Evidence]:
    """Yield the steps of a row that did not pass, and rest on none that did not."""
    of_proofs: Sequence[Evidence] = [
        step for proof in row.proofs for step in (*proof.kernel, *proof.steps, *proof.bindings)
    ]
    for step in closure((*row.finding.evidence, *of_proofs)):
        if step.passed is not True and all(below.passed is True for below in closure(step.rests_on)):
            yield step
