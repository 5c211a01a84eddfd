"""Verdicts and findings: the data that the report is a pure function of.

A `Finding` is judged when it is built: one that claims more than its evidence carries cannot exist.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from paper_checks.evidence.evidence import Evidence, EvidenceKind, Named, Steps, Subject, closure, steps


class Verdict(Enum):
    """What was found about a claim; the value is the word that the reader sees."""

    HOLDS = "holds"
    HOLDS_CORRECTED = "holds-corrected"
    """False as written in some detail; the corrected statement is given and checked."""
    REFUTED = "refuted"
    """False, with a checked counterexample and the nearest true statement."""
    NOT_JUDGED = "not-judged"
    """An opinion, a plan, or a statement about the literature, which no check here can settle; the reason says which."""
    UNDECIDED = "undecided"
    """The evidence does not settle it."""
    UNCHECKED = "unchecked"
    """A needed tool is missing, or no check exists."""


class InvalidFindingError(ValueError):
    """A finding that claims more than its evidence carries."""


@dataclass(frozen=True)
class Carried:
    """Which steps carry a clause of a claim, by the clause's id, and about what they speak."""

    clause: str
    steps: Steps


def carried(clause: str, *named: Named) -> Carried:
    """Return that these steps carry the clause: each states it, or a part of it, as it stands; without steps its formulas do."""
    return Carried(clause, steps(*named))


@dataclass(frozen=True)
class Finding:
    """What a check returns; its texts are prose with LaTeX between ``$`` (inline) and ``$$`` (displayed).

    A dollar itself is written with a backslash before it. Raises InvalidFindingError where the evidence does
    not carry the verdict.
    """

    verdict: Verdict
    reason: str
    evidence: Steps = ()
    corrected: str | None = None
    counterexample: str | None = None
    figure: str | None = None
    missing: str | None = None
    """What is missing for a proof; required where the verdict is undecided or unchecked."""
    carried: tuple[Carried, ...] = ()
    """Which steps carry which clause; a clause that is not named here is carried by the reason, as an argument."""

    def __post_init__(self) -> None:
        """Judge the finding."""
        if objection := objection_to(self):
            raise InvalidFindingError(f"{self.verdict.value}: {objection}")


def _decided(evidence: Steps, about: Subject) -> bool:
    return any(item.decides for item in evidence if item.about is about)


def objection_to(finding: Finding) -> str | None:
    """Say why the evidence does not carry the verdict; None where it does."""
    if not finding.reason.strip():
        return "no reason is given"
    if finding.verdict in (Verdict.UNDECIDED, Verdict.UNCHECKED):
        return None if finding.missing else "it must say what is missing"
    if failed := next((item for item in finding.evidence if not item.passed), None):
        return f"its evidence did not pass: {failed.statement}"
    if finding.verdict in (Verdict.HOLDS, Verdict.NOT_JUDGED):
        return _objection_to_uncorrected(finding)
    return _objection_to_correction(finding)


def _objection_to_uncorrected(finding: Finding) -> str | None:
    if finding.corrected or finding.counterexample:
        return "a claim that holds or is not judged has no counterexample and needs no correction"
    if finding.verdict is Verdict.NOT_JUDGED:
        return "no step carries what is not judged" if finding.carried else None
    if not _decided(finding.evidence, Subject.CLAIM):
        return "no decisive evidence (enclosure or stronger) passed for the claim"
    return None


def _objection_to_correction(finding: Finding) -> str | None:
    if not finding.counterexample:
        return "a counterexample is missing"
    if not finding.corrected:
        return "the corrected statement is missing"
    for about in (Subject.COUNTEREXAMPLE, Subject.CORRECTION):
        if not _decided(finding.evidence, about):
            return f"no decisive evidence (enclosure or stronger) passed for the {about.value}"
    return None


def conclude(
    verdict: Verdict,
    reason: str,
    *parts: Evidence | Carried,
    corrected: str | None = None,
    counterexample: str | None = None,
    figure: str | None = None,
    missing: str | None = None,
) -> Finding:
    """Return the finding with this verdict where the evidence carries it, and an undecided one elsewhere.

    This is how a check ends: the verdict is what the check set out to show, and failed evidence turns it.
    """
    of_clauses = tuple(part for part in parts if isinstance(part, Carried))
    steps = (step for part in parts for step in (part.steps if isinstance(part, Carried) else (part,)))
    evidence, extras = closure(steps), (corrected, counterexample, figure)
    try:
        return Finding(verdict, reason, evidence, *extras, missing, of_clauses)
    except InvalidFindingError as objection:
        if _waits_for_the_kernel(evidence):
            missing, why = (
                "the proof kernel",
                f"Not settled: it rests on theorems of the kernel, which was not run. {reason}",
            )
            return Finding(Verdict.UNCHECKED, why, evidence, *extras, missing, of_clauses)
        reason, missing = f"Not carried by its evidence: {objection}", str(objection)
        return Finding(Verdict.UNDECIDED, reason, evidence, *extras, missing, of_clauses)


def _waits_for_the_kernel(evidence: Steps) -> bool:
    """Say whether all that did not pass is theorems of the kernel that were not run, and what rests on them."""
    left = [step for step in evidence if not (step.passed or step.rests_on or step.supports)]
    return bool(left) and all(step.kind is EvidenceKind.KERNEL and step.passed is None for step in left)
