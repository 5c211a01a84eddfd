"""A row without its claim: what goes from one process to another and into the cache, where formulas cannot go."""

from __future__ import annotations

from dataclasses import dataclass

from paper_checks.evidence.claim import Claim
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject, closure
from paper_checks.evidence.finding import Finding
from paper_checks.running.graph import SETTLED, Proof, clauses
from paper_checks.running.runner import Row


@dataclass(frozen=True)
class Plain:
    """A claim's id, what was found, and the steps, theorems and bindings of each of its clauses, in their order."""

    claim: str
    finding: Finding
    seconds: float
    proofs: tuple[tuple[tuple[Evidence, ...], tuple[Evidence, ...], tuple[Evidence, ...]], ...]

    @property
    def lasting(self) -> bool:
        """Whether running it again would find the same: it is settled, and every solver that was asked answered."""
        steps = closure((*self.finding.evidence, *(one for proof in self.proofs for part in proof for one in part)))
        silent = any(step.kind is EvidenceKind.SMT and step.passed is None for step in steps)
        return self.finding.verdict in SETTLED and not silent


def plain(row: Row) -> Plain:
    """Return a row without its claim."""
    proofs = tuple((proof.steps, proof.kernel, proof.bindings) for proof in row.proofs)
    return Plain(row.claim.id, row.finding, row.seconds, proofs)


def row(claim: Claim, found: Plain) -> Row:
    """Return the row again. Raises ValueError where it is another claim's, or the clauses are not those it had."""
    if found.claim != claim.id:
        raise ValueError(f"the row of {found.claim} is not one of {claim.id}")
    of_clauses = clauses(claim, found.finding) if found.proofs else ()
    fails = found.finding.counterexample is not None
    proofs = tuple(
        Proof(clause, about, *parts, quoted=fails and about is Subject.CLAIM)
        for (clause, about), parts in zip(of_clauses, found.proofs, strict=True)
    )
    return Row(claim, found.finding, found.seconds, proofs)
