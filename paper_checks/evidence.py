"""Verdicts, evidence and findings: the data that the report is a pure function of.

A `Finding` is judged when it is built: one that claims more than its evidence carries cannot exist.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from enum import Enum

_NON_FINITE = re.compile(r"(?<![\w\\])[+-]?(?:nan|inf|infinity)(?!\w)", re.IGNORECASE)


class Verdict(Enum):
    """What was found about a claim; the value is the word that the reader sees."""

    HOLDS = "holds"
    HOLDS_CORRECTED = "holds-corrected"
    """False as written in some detail; the corrected statement is given and checked."""
    REFUTED = "refuted"
    """False, with a checked counterexample and the nearest true statement."""
    UNDECIDED = "undecided"
    """The evidence does not settle it."""
    UNCHECKED = "unchecked"
    """A needed tool is missing, or no check exists."""


class EvidenceKind(Enum):
    """How strong a piece of evidence is, strongest first."""

    KERNEL = "kernel"
    """A proof assistant's kernel accepted the proof."""
    SMT = "smt"
    """Two solvers, and a satisfiable control."""
    EXACT = "exact"
    """A symbolic identity."""
    ENCLOSURE = "enclosure"
    """Ball arithmetic: holds for every point of a stated set."""
    PROPERTY = "property"
    """Random cases in a stated number."""
    SIMULATION = "simulation"
    """One computed trajectory, without a proven error."""

    @property
    def strength(self) -> int:
        """Rank, dimensionless; larger is stronger."""
        return -list(EvidenceKind).index(self)

    @property
    def decisive(self) -> bool:
        """Whether this kind can settle a claim; samples cannot."""
        return self.strength >= EvidenceKind.ENCLOSURE.strength


class Subject(Enum):
    """What a piece of evidence speaks about."""

    CLAIM = "claim"
    """The paper's statement itself, or a step of its proof."""
    COUNTEREXAMPLE = "counterexample"
    """That the counterexample is real and violates the paper's statement."""
    CORRECTION = "correction"
    """The corrected statement, or a step of its proof."""


class InvalidFindingError(ValueError):
    """A finding that claims more than its evidence carries."""


@dataclass(frozen=True)
class Evidence:
    """One checked statement.

    `passed` is True (the statement was found true), False (found false) or None (no answer). With no cases,
    or with a `value` that is not finite, nothing was checked: `passed` becomes None, never a pass.
    """

    kind: EvidenceKind
    engine: str
    statement: str
    passed: bool | None
    cases: int = 1
    value: str = ""
    assumptions: tuple[str, ...] = ()
    about: Subject = Subject.CLAIM

    def __post_init__(self) -> None:
        """Take the pass from evidence that is vacuous or not finite."""
        if not isinstance(self.passed, bool | None):
            raise TypeError(f"passed is {self.passed!r}; it must be True, False or None: decide it before")
        if self.passed and (self.cases < 1 or _NON_FINITE.search(self.value)):
            object.__setattr__(self, "passed", None)

    @property
    def decides(self) -> bool:
        """Whether it passed and is of a kind that can settle a claim."""
        return self.passed is True and self.kind.decisive

    def as_counterexample(self) -> Evidence:
        """Return the same evidence, as evidence that the counterexample is real."""
        return replace(self, about=Subject.COUNTEREXAMPLE)

    def as_correction(self) -> Evidence:
        """Return the same evidence, as evidence for the corrected statement."""
        return replace(self, about=Subject.CORRECTION)


@dataclass(frozen=True)
class Finding:
    """What a check returns; its texts are prose with LaTeX between ``$`` (inline) and ``$$`` (displayed).

    A dollar itself is written with a backslash before it. Raises InvalidFindingError where the evidence does
    not carry the verdict.
    """

    verdict: Verdict
    reason: str
    evidence: tuple[Evidence, ...] = ()
    corrected: str | None = None
    counterexample: str | None = None
    derivation: tuple[str, ...] = ()
    figure: str | None = None
    missing: str | None = None
    """What is missing for a proof; required where the verdict is undecided or unchecked."""

    def __post_init__(self) -> None:
        """Judge the finding."""
        if objection := objection_to(self):
            raise InvalidFindingError(f"{self.verdict.value}: {objection}")

    @property
    def strongest(self) -> EvidenceKind | None:
        """The strongest kind that carries the verdict.

        A refuted or corrected claim stands on two legs, counterexample and correction: the weaker one counts.
        """
        legs = [_strongest(self.evidence, about) for about in (Subject.COUNTEREXAMPLE, Subject.CORRECTION)]
        standing = [kind for kind in legs if kind]
        return min(standing, key=lambda kind: kind.strength, default=_strongest(self.evidence, Subject.CLAIM))


def _strongest(evidence: tuple[Evidence, ...], about: Subject) -> EvidenceKind | None:
    kinds = [item.kind for item in evidence if item.passed and item.about is about]
    return max(kinds, key=lambda kind: kind.strength, default=None)


def _decided(evidence: tuple[Evidence, ...], about: Subject) -> bool:
    return any(item.decides for item in evidence if item.about is about)


def objection_to(finding: Finding) -> str | None:
    """Say why the evidence does not carry the verdict; None where it does."""
    if not finding.reason.strip():
        return "no reason is given"
    if finding.verdict in (Verdict.UNDECIDED, Verdict.UNCHECKED):
        return None if finding.missing else "it must say what is missing"
    if finding.verdict is Verdict.HOLDS:
        return _objection_to_holds(finding)
    return _objection_to_correction(finding)


def _objection_to_holds(finding: Finding) -> str | None:
    for item in finding.evidence:
        if not item.passed:
            return f"its evidence did not pass: {item.statement}"
    if finding.corrected or finding.counterexample:
        return "a claim that holds has no counterexample and needs no correction"
    if not _decided(finding.evidence, Subject.CLAIM):
        return "no decisive evidence (enclosure or stronger) passed for the claim"
    return None


def _objection_to_correction(finding: Finding) -> str | None:
    if not finding.counterexample:
        return "a counterexample is missing"
    if not finding.corrected:
        return "the corrected statement is missing"
    for item in finding.evidence:
        if item.about is not Subject.CLAIM and not item.passed:
            return f"its evidence did not pass: {item.statement}"
    for about in (Subject.COUNTEREXAMPLE, Subject.CORRECTION):
        if not _decided(finding.evidence, about):
            return f"no decisive evidence (enclosure or stronger) passed for the {about.value}"
    return None


def conclude(
    verdict: Verdict,
    reason: str,
    *evidence: Evidence,
    corrected: str | None = None,
    counterexample: str | None = None,
    derivation: tuple[str, ...] = (),
    figure: str | None = None,
    missing: str | None = None,
) -> Finding:
    """Return the finding with this verdict where the evidence carries it, and an undecided one elsewhere.

    This is how a check ends: the verdict is what the check set out to show, and failed evidence turns it.
    """
    extras = (corrected, counterexample, derivation, figure)
    try:
        return Finding(verdict, reason, evidence, *extras, missing)
    except InvalidFindingError as objection:
        return Finding(
            Verdict.UNDECIDED, f"Not carried by its evidence: {objection}", evidence, *extras, str(objection)
        )
