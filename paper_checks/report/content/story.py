"""What is told of a claim: its place, its decisive step, what is true instead, its figure, and all its steps."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from itertools import count

from paper_checks.decide import kernel
from paper_checks.decide.exhibit import ENGINE as EXHIBITED
from paper_checks.derivation.line import number_in
from paper_checks.evidence.claim import Claim, Kind
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject, closure
from paper_checks.report.content.phrases import coded, kind
from paper_checks.running.graph import Proof
from paper_checks.running.runner import Row

SHORT = 80
"""Characters up to which the value of an enclosure is shown with the decisive step."""
LONG = 60
"""Characters of LaTeX from which on a formula of a theorem stands in a line of its own."""
OUTCOMES = {True: "passed", False: "failed", None: "no answer"}
PICTURED = {
    "entrainment-threshold": "thresholds-over-frequency",
    "forced-resonance-bound": "resonance",
    "minimum-transfer-time": "fastest-transfer",
    "tolerance-ring": "tolerance-ring-of-a-scene",
    "ring-of-tolerance": "tolerance-ring-of-a-scene",
}
"""Figures of the chapter on forces that claims show too."""
_SLOT = re.compile("«([a-z0-9_]+)»([.,;:]?)")


def theorems(claim: Claim) -> tuple[str, ...]:
    """Return the theorems of the kernel that a claim names."""
    return tuple(dict.fromkeys(name for clause in (*claim.clauses, *claim.correction) for name in clause.kernel))


def bracketed(claim: Claim) -> str:
    """Return the place of a claim in brackets; an equation's number has them already."""
    return claim.where if re.fullmatch(r"\([^()]*\)", claim.where) else f"({claim.where})"


def by(row: Row) -> str:
    """Return the kind of the weakest step that the verdict needs; empty where nothing is established."""
    return row.established_by.value if row.established_by else ""


def place(row: Row) -> str:
    """Return where a claim stands in the paper, with its section, and the kind of its weakest check: of the kernel, its theorems."""
    claim = row.claim
    where = f"{'eq. ' * claim.where.startswith('(')}{claim.where}"
    if not re.search(rf"\b{claim.section}\b", where, re.IGNORECASE):
        where = f"{claim.section}, {where}"
    checked = f"{kind(row)}: {coded(theorems(claim))}" if by(row) == "kernel" else kind(row)
    found = [where] * (claim.kind is Kind.CLAIM) + [checked] * bool(by(row))
    return "; ".join(found) or "not established"


def figure(row: Row) -> str | None:
    """Return the name of a claim's figure."""
    return PICTURED.get(row.claim.id, row.finding.figure)


def corrected(row: Row) -> str | None:
    """Return the nearest true statement, where the claim is corrected."""
    given = row.finding.corrected
    return displayed(row.claim.correction) if given and given == row.claim.corrected else given


def displayed(clauses: Iterable[Clause]) -> str:
    """Return the text of clauses, their long formulas in lines of their own, with the sign after them."""

    def text(clause: Clause) -> str:
        def shown(match: re.Match[str]) -> str:
            formula, sign = clause.formulas[match[1]].latex, match[2]
            return f"$${formula}{sign}$$" if len(formula) > LONG else f"${formula}${sign}"

        return _SLOT.sub(shown, clause.text)

    return " ".join(map(text, clauses))


def decisive(row: Row) -> Evidence | None:
    """Return the step that decides a row; None where that is the row's own reason, or where nothing is established.

    Where the claim fails, it is what shows the counterexample: at a point, by a number, or the strongest. Where it holds,
    it is a theorem of the kernel, or the inference that a clause ends with, or what stands first.
    """
    if row.established_by is None:
        return None
    fails = row.finding.counterexample is not None
    about = Subject.COUNTEREXAMPLE if fails else Subject.CLAIM
    needed = [step for proof in row.proofs if proof.about is about for step in proof.needed]
    good = [step for step in needed if step.decides and step.statement != row.finding.reason]
    first = EvidenceKind.ENCLOSURE if fails else EvidenceKind.KERNEL
    second = None if fails else EvidenceKind.ARGUMENT
    return max(
        good,
        key=lambda step: (
            fails and step.engine == EXHIBITED,
            step.kind is first,
            step.kind is second,
            fails and step.kind.strength,
        ),
        default=None,
    )


def shown_value(step: Evidence) -> str:
    """Return the value of a decisive step that is a number at a point, or a short enclosure; empty for others."""
    shown = step.engine == EXHIBITED or (step.kind is EvidenceKind.ENCLOSURE and len(step.value) < SHORT)
    return step.value if shown and any(map(str.isdigit, step.value)) else ""


def cases(step: Evidence) -> str:
    """Return how many cases a step covers, where it is not one."""
    return f"{step.cases:,} {step.counted}" if step.cases != 1 else ""


def steps(row: Row) -> dict[Evidence, str]:
    """Return the steps of a row, those first that others rest on, with their names: a theorem's, else a number. Its reason is none."""
    of_proofs = (step for proof in row.proofs for step in (*proof.kernel, *proof.steps, *proof.bindings))
    numbers, found = count(1), closure((*of_proofs, *row.finding.evidence))
    of_kernel = EvidenceKind.KERNEL
    return {
        step: kernel.name_of(step) if step.kind is of_kernel else str(next(numbers))
        for step in found
        if step.statement != row.finding.reason
    }


def in_chapter(step: Evidence) -> bool:
    """Return whether a step stands in a chapter of the page: a theorem of the kernel, or a line of the derivation."""
    return step.kind is EvidenceKind.KERNEL or number_in(step) is not None


def named(some: Iterable[Evidence], names: Mapping[Evidence, str]) -> str:
    """Return the names of steps, each once."""
    return coded(dict.fromkeys(names[step] for step in some if step in names)) or "–"


def steps_of(proof: Proof, names: Mapping[Evidence, str]) -> str:
    """Return the names of a clause's steps; for an inference that is not listed, the claim's own reason, of what it rests on."""
    below = (step for one in proof.steps if one not in names for step in one.rests_on)
    return named((*proof.kernel, *proof.steps, *proof.bindings, *below), names)


def kind_of(proof: Proof) -> str:
    """Return what establishes a clause, and what the kernel says where it did not prove its theorems."""
    found = proof.established_by.value if proof.established_by else "open"
    return found if proof.kernel_status in (None, kernel.PROVED) else f"{found}, kernel {proof.kernel_status}"
