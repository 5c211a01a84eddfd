"""What is told of a claim: its decisive step, what is true instead, its figure, and all its steps in two tables."""

from __future__ import annotations

import re
from collections.abc import Mapping
from itertools import count

from paper_checks.decide import kernel
from paper_checks.decide.exhibit import ENGINE as EXHIBITED
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject
from paper_checks.report.content import shared, under_a_force
from paper_checks.running.graph import Proof
from paper_checks.running.runner import Row

SHORT = 80
"""Characters up to which the value of an enclosure is shown with the decisive step."""
LONG = 60
"""Characters of LaTeX from which on a formula of a theorem stands in a line of its own."""
_SLOT = re.compile("«([a-z0-9_]+)»([.,;:]?)")


def corrected(row: Row) -> list[str]:
    """Return the nearest true statement, a paragraph for each clause that ends a sentence; none where nothing is corrected."""
    if row.finding.corrected != row.claim.corrected:
        return [row.finding.corrected or ""]
    paragraphs = [""]
    for clause in row.claim.correction:
        paragraphs[-1] += " " * bool(paragraphs[-1]) + displayed(clause)
        paragraphs += [""] * clause.text.endswith(".")
    return [*filter(None, paragraphs)]


def displayed(clause: Clause) -> str:
    """Return the text of a clause, its long formulas in lines of their own, with the sign after them."""

    def shown(match: re.Match[str]) -> str:
        formula, sign = clause.formulas[match[1]].latex, match[2]
        return f"$${formula}{sign}$$" if len(formula) > LONG else f"${formula}${sign}"

    return _SLOT.sub(shown, clause.text)


def decisive(row: Row) -> Evidence | None:
    """Return the step that decides a row; None where that is the row's own reason, or where nothing is established.

    Where the claim fails, it is what shows the counterexample: at a point, by a number, or the strongest. Where it holds,
    it is a theorem of the kernel, or the inference that a clause ends with, or what stands first.
    """
    if row.established_by is None:
        return None
    fails = row.finding.counterexample is not None
    about = Subject.COUNTEREXAMPLE if fails else Subject.CLAIM
    steps = [step for proof in row.proofs if proof.about is about for step in proof.needed]
    good = [step for step in steps if step.decides and step.statement != row.finding.reason]
    return max(good, key=_weight_of_counterexample if fails else _weight_of_proof, default=None)


def _weight_of_counterexample(step: Evidence) -> tuple[bool, bool, int]:
    return step.engine == EXHIBITED, step.kind is EvidenceKind.ENCLOSURE, step.kind.strength


def _weight_of_proof(step: Evidence) -> tuple[bool, bool]:
    return step.kind is EvidenceKind.KERNEL, step.kind is EvidenceKind.ARGUMENT


def decided_by(row: Row) -> str | None:
    """Return what is said of the decisive step; None where nothing is established."""
    step = decisive(row)
    if step is not None:
        return _told(step)
    if row.established_by is None:
        return None
    checked = len(list(shared.of_row(row)))
    return f"The inference that follows, over {checked} checked step{'s' if checked != 1 else ''} ({row.established_by.value})."


def _told(step: Evidence) -> str:
    cases = ", ".join(filter(None, [step.engine, shared.cases(step)]))
    statement = (step.statement[:1].upper() + step.statement[1:]).rstrip(".")
    if step.kind is EvidenceKind.KERNEL:
        statement = f"Theorem `{kernel.name_of(step)}`: {step.statement.partition('): ')[2].rstrip('.')}"
    shown = step.engine == EXHIBITED or (step.kind is EvidenceKind.ENCLOSURE and len(step.value) < SHORT)
    value = f": {step.value}" if shown and any(map(str.isdigit, step.value)) else ""
    return f"{statement}{value} ({step.kind.value}: {cases})."


def figure(row: Row) -> str | None:
    """Return the name of a claim's figure."""
    return under_a_force.PICTURED.get(row.claim.id, row.finding.figure)


def names(row: Row, common: Mapping[Evidence, str]) -> dict[Evidence, str]:
    """Return the name of each step of a claim: its own are numbered, `common` names those that stand elsewhere."""
    number, found = count(1), {}
    for step in shared.of_row(row):
        found[step] = common.get(shared.plain(step)) or str(next(number))
    return found


def own(named: Mapping[Evidence, str]) -> list[tuple[str, ...]]:
    """Return the cells of a claim's own steps."""
    return [
        (name, *shared.cells(step, (named[below] for below in step.rests_on if below in named)))
        for step, name in named.items()
        if name.isdigit()
    ]


def clauses(row: Row) -> list[Proof]:
    """Return the clauses that have steps."""
    return [one for one in row.proofs if one.steps or one.kernel or one.bindings]


def steps_of(proof: Proof, named: Mapping[Evidence, str]) -> str:
    """Return the names of a clause's steps; for an inference that is not listed, the claim's own reason, of what it rests on."""
    direct = (*proof.kernel, *proof.steps, *proof.bindings)
    below = (step for one in proof.steps if one not in named for step in one.rests_on)
    return ", ".join(dict.fromkeys(f"`{named[step]}`" for step in (*direct, *below) if step in named)) or "–"
