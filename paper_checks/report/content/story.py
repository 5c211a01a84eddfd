"""What stands behind a row: the statement, the decisive step, why, then all steps, folded."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from itertools import chain

from paper_checks.decide import kernel
from paper_checks.decide.exhibit import ENGINE as EXHIBITED
from paper_checks.decide.kernel import PROVED
from paper_checks.drawing.captions import caption
from paper_checks.evidence.claim import Kind
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject
from paper_checks.report.content import derivation, notation, shared, under_a_force
from paper_checks.report.content.blocks import Block, Code, Folded, Paragraph, Points, Table
from paper_checks.report.content.opening import hypotheses
from paper_checks.report.content.phrases import picture, place
from paper_checks.running.graph import Proof
from paper_checks.running.runner import Row

SHORT = 80
"""Characters up to which the value of an enclosure is shown with the decisive step."""
LONG = 60
"""Characters of LaTeX from which on a formula of a theorem stands in a line of its own."""
_SLOT = re.compile("«([a-z0-9_]+)»([.,;:]?)")


def story(row: Row, common: Mapping[Evidence, str], elsewhere: Collection[str] = ()) -> tuple[Block, ...]:
    """Return what a row tells, as blocks; `common` names steps that stand elsewhere, `elsewhere` are anchors of chapters."""
    return tuple(_story(row, common, elsewhere))


def _story(row: Row, common: Mapping[Evidence, str], elsewhere: Collection[str]) -> Iterator[Block]:
    finding = row.finding
    yield from _statement(row)
    if not row.as_recorded:
        yield Paragraph(f"This differs from the verdict on record, {row.claim.recorded.value}.", "Attention", True)
    if text := _decisive(row):
        yield Paragraph(text, "Decisive step", True)
    texts: dict[str, list[str | None]] = {
        "Why": [finding.reason],
        "Counterexample": [finding.counterexample],
        "What is true": _corrected(row),
        "Missing for a proof": [finding.missing],
    }
    for label, parts in texts.items():
        yield from (Paragraph(text, label if text is parts[0] else "") for text in parts if text)
    yield from (Paragraph(text, "Open") for text in row.open)
    yield from _picture(row, elsewhere)
    if symbols := notation.used([row.claim.statement, *filter(None, chain(*texts.values()))], row.claim.id):
        yield Folded("Symbols", (notation.table(symbols, "", anchored=False),))
    yield from derivation.story(row)
    yield from _folded(row, common)
    yield Code(f"python -m paper_checks run {row.claim.id}")


def _statement(row: Row) -> Iterator[Block]:
    """Yield what is claimed; a theorem as a textbook has it, its hypotheses first and each part by itself."""
    if row.claim.kind is Kind.CLAIM:
        yield Paragraph(row.claim.statement, f"The paper says {place(row.claim)}")
        return
    yield Paragraph(hypotheses(row.claim.id), "Hypotheses")
    several = len(row.claim.clauses) > 1
    for number, clause in enumerate(row.claim.clauses, start=1):
        yield Paragraph(displayed(clause), f"({number}) {clause.id.replace('-', ' ')}" if several else "Theorem")


def _corrected(row: Row) -> list[str | None]:
    """Return the nearest true statement, a paragraph for each clause that ends a sentence; none where nothing is corrected."""
    if row.finding.corrected != row.claim.corrected:
        return [row.finding.corrected]
    paragraphs = [""]
    for clause in row.claim.correction:
        paragraphs[-1] += " " * bool(paragraphs[-1]) + displayed(clause)
        paragraphs += [""] * clause.text.endswith(".")
    return [*paragraphs]


def displayed(clause: Clause) -> str:
    """Return the text of a clause, its long formulas in lines of their own, with the sign after them."""

    def shown(match: re.Match[str]) -> str:
        formula, sign = clause.formulas[match[1]].latex, match[2]
        return f"$${formula}{sign}$$" if len(formula) > LONG else f"${formula}${sign}"

    return _SLOT.sub(shown, clause.text)


def _picture(row: Row, elsewhere: Collection[str]) -> Iterator[Block]:
    """Yield the row's figure, or where a chapter shows it."""
    figure, anchor = under_a_force.PICTURED.get(row.claim.id, (row.finding.figure, ""))
    if figure and anchor in elsewhere:
        yield Paragraph(f"{caption(figure)[0]}, drawn under `{anchor}`.", "Picture")
    elif figure:
        yield picture(figure)


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


def _decisive(row: Row) -> str | None:
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


def _folded(row: Row, common: Mapping[Evidence, str]) -> Iterator[Block]:
    """Yield the clauses, the steps and the derivation, as far as there are any."""
    steps = list(shared.of_row(row))
    own = [step for step in steps if shared.plain(step) not in common]
    numbers = {step: str(number) for number, step in enumerate(own, start=1)}
    names = {step: common.get(shared.plain(step)) or numbers[step] for step in steps}
    inside: list[Block] = []
    if shown := [proof for proof in row.proofs if proof.steps or proof.kernel or proof.bindings]:
        head = ("clause", "what it says", "established by", "steps")
        inside.append(Table(head, tuple(_clause(proof, names) for proof in shown), "Clauses that the verdict rests on"))
    if own:
        lines = (
            (names[one], *shared.cells(one, (names[below] for below in one.rests_on if below in names))) for one in own
        )
        inside.append(Table(shared.HEAD[:-1], tuple(lines), "Steps, each after those it rests on"))
    if elsewhere := [f"`{names[step]}`" for step in steps if step not in numbers]:
        inside.append(
            Paragraph(
                f"{', '.join(dict.fromkeys(elsewhere))}.", "Steps that several claims use, and theorems of the kernel"
            )
        )
    if row.finding.derivation:
        inside += [Paragraph("Derivation:"), Points(row.finding.derivation, numbered=True)]
    if inside:
        what = "1 step" if len(steps) == 1 else f"{len(steps)} steps"
        derivation = ", with the derivation" if row.finding.derivation else ""
        yield Folded(f"All {what}{derivation}" if steps else "Derivation", tuple(inside))


def _clause(proof: Proof, names: Mapping[Evidence, str]) -> tuple[str, ...]:
    by = proof.established_by.value if proof.established_by else "open"
    status = "" if proof.kernel_status in (None, PROVED) else f", kernel {proof.kernel_status}"
    direct = [names[step] for step in (*proof.kernel, *proof.steps, *proof.bindings) if step in names]
    below = [names[step] for step in _reasoned(proof, names) if step in names]
    steps = ", ".join(f"`{name}`" for name in dict.fromkeys([*direct, *below]))
    return proof.clause.id, proof.clause.shown, f"{by}{status}", steps or "–"


def _reasoned(proof: Proof, names: Mapping[Evidence, str]) -> Iterator[Evidence]:
    """Yield what an inference that is not listed rests on: it is the row's own reason."""
    for step in proof.steps:
        if step not in names:
            yield from step.rests_on
