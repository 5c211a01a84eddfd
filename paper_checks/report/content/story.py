"""What stands behind a row: the decisive step first, then why, then all steps, folded."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from paper_checks.decide import kernel
from paper_checks.decide.exhibit import ENGINE as EXHIBITED
from paper_checks.decide.kernel import PROVED
from paper_checks.drawing.captions import caption
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject, closure
from paper_checks.report.content import notation, under_a_force
from paper_checks.report.content.blocks import Block, Folded, Labelled, Numbered, Paragraph, Picture, Symbols, Table
from paper_checks.report.content.phrases import OUTCOMES
from paper_checks.report.content.trust import PROVENANCE
from paper_checks.running.graph import Proof, numbered
from paper_checks.running.runner import Row

SHORT = 80
"""Characters up to which the value of an enclosure is shown with the decisive step."""


def story(row: Row, elsewhere: Collection[str] = ()) -> tuple[Block, ...]:
    """Return what a row tells after the statement and the verdict, as blocks; `elsewhere` are anchors of chapters beside it."""
    return tuple(_story(row, elsewhere))


def _story(row: Row, elsewhere: Collection[str]) -> Iterator[Block]:
    finding = row.finding
    if not row.as_recorded:
        yield Labelled("Attention", f"This differs from the verdict on record, {row.claim.recorded.value}", marked=True)
    if text := _decisive(row):
        yield Labelled("Decisive step", text, marked=True)
    texts = {
        "Why": finding.reason,
        "Counterexample": finding.counterexample,
        "What is true": finding.corrected,
        "Missing for a proof": finding.missing,
    }
    yield from (Labelled(label, text) for label, text in texts.items() if text)
    yield from (Labelled("Open", text) for text in row.open)
    yield from _picture(row, elsewhere)
    if symbols := notation.used([row.claim.statement, *filter(None, texts.values())]):
        yield Symbols(symbols)
    yield Labelled("Run it again", f"`python -m paper_checks run {row.claim.id}`, installed as `{PROVENANCE}` says.")
    yield from _folded(row)


def _picture(row: Row, elsewhere: Collection[str]) -> Iterator[Block]:
    """Yield the row's figure, or where a chapter shows it."""
    figure, anchor = under_a_force.PICTURED.get(row.claim.id, (row.finding.figure, ""))
    if figure and anchor in elsewhere:
        yield Labelled("Picture", f"{caption(figure)[0]}, drawn under `{anchor}`.")
    elif figure:
        yield Picture(figure, *reversed(caption(figure)))


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
    checked = len(_names(row))
    return f"The inference that follows, over {checked} checked step{'s' if checked != 1 else ''} ({row.established_by.value})."


def _told(step: Evidence) -> str:
    cases = f", {step.cases} cases" if step.cases != 1 else ""
    statement = (step.statement[:1].upper() + step.statement[1:]).rstrip(".")
    if step.kind is EvidenceKind.KERNEL:
        statement = _theorem(step)
    shown = step.engine == EXHIBITED or (step.kind is EvidenceKind.ENCLOSURE and len(step.value) < SHORT)
    value = f": {step.value}" if shown and any(map(str.isdigit, step.value)) else ""
    return f"{statement}{value} ({step.kind.value}: {step.engine}{cases})."


def _theorem(step: Evidence) -> str:
    """Return what a theorem of the kernel says, its name as a link."""
    return f"Theorem `{kernel.name_of(step)}`: {step.statement.partition('): ')[2].rstrip('.')}"


def _folded(row: Row) -> Iterator[Block]:
    """Yield the clauses, the steps and the derivation, as far as there are any."""
    names = _names(row)
    inside: list[Block] = []
    shown = [proof for proof in row.proofs if proof.steps or proof.kernel or proof.bindings]
    if shown:
        head = ("clause", "what it says", "established by", "steps")
        lines = tuple(_clause(proof, names) for proof in shown)
        inside.append(Table(head, lines, "Clauses: what the verdict stands on"))
    if names:
        lines = tuple(_step(step, names) for step in reversed(names))
        inside.append(
            Table(("step", "kind", "checked statement", "result"), lines, "Steps, each above those it rests on")
        )
    if row.finding.derivation:
        inside += [Paragraph("Derivation:"), Numbered(row.finding.derivation)]
    if inside:
        what = "1 step" if len(names) == 1 else f"{len(names)} steps"
        derivation = ", with the derivation" if row.finding.derivation else ""
        yield Folded(f"All {what}{derivation}" if names else "Derivation", tuple(inside))


def _names(row: Row) -> dict[Evidence, str]:
    """Return the name of each step: its theorem's, or a number; first those that others rest on."""
    found = numbered(row.claim.id, row.proofs)
    own = {step: name for step, name in found.items() if "/" not in name}
    rest = [step for step in closure((*found, *row.finding.evidence)) if step.statement != row.finding.reason]
    unnamed = [step for step in rest if step not in own]
    numbers = {step: str(index) for index, step in enumerate(unnamed, start=1)}
    return {step: own.get(step) or numbers[step] for step in rest}


def _clause(proof: Proof, names: Mapping[Evidence, str]) -> tuple[str, ...]:
    by = proof.established_by.value if proof.established_by else "open"
    status = "" if proof.kernel_status in (None, PROVED) else f", kernel {proof.kernel_status}"
    direct = [names[step] for step in (*proof.kernel, *proof.steps, *proof.bindings) if step in names]
    below = [names[step] for step in _reasoned(proof, names) if step in names]
    return proof.clause.id, proof.clause.shown, f"{by}{status}", ", ".join(dict.fromkeys([*direct, *below])) or "–"


def _reasoned(proof: Proof, names: Mapping[Evidence, str]) -> Iterator[Evidence]:
    """Yield what an inference that is not listed rests on: it is the row's own reason."""
    for step in proof.steps:
        if step not in names:
            yield from step.rests_on


def _step(step: Evidence, names: Mapping[Evidence, str]) -> tuple[str, ...]:
    about = "" if step.about is Subject.CLAIM else f"{step.about.value.capitalize()}: "
    beside = "Beside the proof. " if step.supports else ""
    remarks = [f"Given {', '.join(step.assumptions)}"] if step.assumptions and step.engine != "Coq" else []
    remarks += [f"Rests on {', '.join(_listed(step.rests_on, names))}"] if step.rests_on else []
    remarks += [f"Cites {'; '.join(step.cites)}"] if step.cites else []
    cases = f"{step.cases} cases" if step.cases != 1 else ""
    return (
        names[step],
        f"{step.kind.value}\n{step.engine}",
        "\n".join([f"{beside}{about}{step.statement}", *remarks]),
        "\n".join(filter(None, [OUTCOMES[step.passed], cases, step.value])),
    )


def _listed(steps: Sequence[Evidence], names: Mapping[Evidence, str]) -> Iterator[str]:
    return (names[step] for step in steps if step in names)
