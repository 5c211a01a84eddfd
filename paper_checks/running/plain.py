"""A row without its claim: what goes from one process to another and into the cache, where formulas cannot go."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from paper_checks.evidence.claim import Claim
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Steps, Subject, closure
from paper_checks.evidence.finding import Carried, Finding, Verdict
from paper_checks.running.graph import Proof, clauses, judged
from paper_checks.running.runner import Row


@dataclass(frozen=True)
class Plain:
    """A claim's id, what was found, and the steps, theorems and bindings of each of its clauses, in their order."""

    claim: str
    finding: Finding
    seconds: float
    proofs: tuple[tuple[Steps, Steps, Steps], ...]

    @property
    def lasting(self) -> bool:
        """Whether running it again, with the tools that there are, would find the same: every solver that was asked answered."""
        silent = any(step.kind is EvidenceKind.SMT and step.passed is None for step in self.steps)
        return self.finding.verdict is not Verdict.UNDECIDED and not silent

    @property
    def steps(self) -> Steps:
        """Every step, each once, those that others rest on first."""
        of_clauses = (*(one.steps for one in self.finding.carried), *(part for proof in self.proofs for part in proof))
        return closure((*self.finding.evidence, *(step for part in of_clauses for step in part)))


def plain(row: Row) -> Plain:
    """Return a row without its claim."""
    proofs = tuple((proof.steps, proof.kernel, proof.bindings) for proof in row.proofs)
    return Plain(row.claim.id, row.finding, row.seconds, proofs)


def row(claim: Claim, found: Plain) -> Row:
    """Return the row again, its verdict judged again.

    Raises ValueError where it is another claim's, the clauses are not those it had, or its steps do not carry its verdict.
    """
    if found.claim != claim.id:
        raise ValueError(f"the row of {found.claim} is not one of {claim.id}")
    of_clauses = clauses(claim, found.finding) if found.proofs else ()
    fails = found.finding.counterexample is not None
    proofs = tuple(
        Proof(clause, about, *parts, quoted=fails and about is Subject.CLAIM)
        for (clause, about), parts in zip(of_clauses, found.proofs, strict=True)
    )
    if judged(found.finding, proofs).verdict is not found.finding.verdict:
        raise ValueError(f"the steps of {found.claim} do not carry its verdict")
    return Row(claim, found.finding, found.seconds, proofs)


def as_json(one: Plain) -> str:
    """Return a row as JSON: its steps by number, those below first, then what refers to them."""
    steps = one.steps
    number = {step: place for place, step in enumerate(steps)}

    def numbers(some: Iterable[Evidence]) -> list[int]:
        return [number[step] for step in some]

    finding = one.finding.__dict__ | {
        "verdict": one.finding.verdict.value,
        "evidence": numbers(one.finding.evidence),
        "carried": [(part.clause, numbers(part.steps)) for part in one.finding.carried],
    }
    shown = [
        step.__dict__ | {"kind": step.kind.value, "about": step.about.value, "rests_on": numbers(step.rests_on)}
        for step in steps
    ]
    proofs = [[numbers(part) for part in proof] for proof in one.proofs]
    return json.dumps(
        {"claim": one.claim, "steps": shown, "finding": finding, "seconds": one.seconds, "proofs": proofs}
    )


def from_json(text: str) -> Plain:
    """Return the row; its finding is judged as any other. Raises ValueError for what is not one."""
    try:
        data = json.loads(text)
        steps: list[Evidence] = []
        for one in data["steps"]:
            steps.append(_step(one, steps))
        named = _named(steps)
        finding = data["finding"] | {
            "verdict": Verdict(data["finding"]["verdict"]),
            "evidence": named(data["finding"]["evidence"]),
            "derivation": tuple(data["finding"]["derivation"]),
            "carried": tuple(Carried(clause, named(some)) for clause, some in data["finding"]["carried"]),
        }
        proofs = tuple((named(a), named(b), named(c)) for a, b, c in data["proofs"])
        return Plain(str(data["claim"]), Finding(**finding), float(data["seconds"]), proofs)
    except (KeyError, IndexError, TypeError, AttributeError) as error:
        raise ValueError(f"no row: {error}") from None


def _named(steps: Sequence[Evidence]) -> Callable[[Iterable[int]], Steps]:
    return lambda numbers: tuple(steps[number] for number in numbers)


def _step(data: dict[str, Any], below: Sequence[Evidence]) -> Evidence:
    words = {name: tuple(data[name]) for name in ("assumptions", "cites")}
    kind, about = EvidenceKind(data["kind"]), Subject(data["about"])
    return Evidence(**data | words | {"kind": kind, "about": about, "rests_on": _named(below)(data["rests_on"])})
