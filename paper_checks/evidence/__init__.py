"""What is said, what was checked, and what was found: the data that claims are made of and the report shows."""

from paper_checks.evidence.claim import (
    CORRECTED,
    HOLDS,
    NOT_JUDGED,
    POSITIVE,
    REFUTED,
    UNDER_A_FORCE,
    Case,
    Claim,
    because,
    claim,
    correction,
    counterexample,
    theorem,
)
from paper_checks.evidence.clause import Clause, Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Steps, argument, enclosed, reading
from paper_checks.evidence.finding import carried
from paper_checks.evidence.formula import equation, form, latex, stating

__all__ = [
    "CORRECTED",
    "HOLDS",
    "NOT_JUDGED",
    "POSITIVE",
    "REFUTED",
    "UNDER_A_FORCE",
    "Case",
    "Claim",
    "Clause",
    "Evidence",
    "EvidenceKind",
    "Formula",
    "Steps",
    "argument",
    "because",
    "carried",
    "claim",
    "clause",
    "correction",
    "counterexample",
    "enclosed",
    "equation",
    "form",
    "latex",
    "reading",
    "stating",
    "theorem",
]
