"""Steps that several claims use: they stand once, under a name to which each of these rows links."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from paper_checks.decide import kernel
from paper_checks.derivation.line import number_in
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject, closure
from paper_checks.report.content.blocks import Section, Table
from paper_checks.report.content.phrases import OUTCOMES
from paper_checks.running.runner import Row

ID, TITLE = "shared-steps", "Steps that several claims use"


def plain(step: Evidence) -> Evidence:
    """Return a step as it is by itself: whatever part of a row it is for, and whatever it rests on."""
    return replace(step, about=Subject.CLAIM, supports=False, rests_on=())


def of_row(row: Row) -> Iterator[Evidence]:
    """Yield the steps of a row, first those that others rest on; its reason and the derivation's lines are none of them."""
    of_proofs = (step for proof in row.proofs for step in (*proof.kernel, *proof.steps, *proof.bindings))
    steps = closure((*of_proofs, *row.finding.evidence))
    yield from (one for one in steps if one.statement != row.finding.reason and number_in(one) is None)


def names(rows: Sequence[Row]) -> dict[Evidence, str]:
    """Return the name of each step that stands elsewhere than in its row: a theorem's, or S and a number."""
    used = Counter(step for row in rows for step in dict.fromkeys(map(plain, of_row(row))))
    found = {step: kernel.name_of(step) for step in used if step.kind is EvidenceKind.KERNEL}
    several = [step for step, rows_of in used.items() if rows_of > 1 and step not in found]
    return found | {step: f"S{number}" for number, step in enumerate(several, start=1)}


def section(rows: Sequence[Row], common: Mapping[Evidence, str]) -> Section:
    """Return the table of these steps; without any where none is shared."""
    users: dict[Evidence, list[str]] = {}
    below: dict[Evidence, dict[str, None]] = {}
    for row in rows:
        for step in of_row(row):
            if common.get(plain(step), "theorem")[0] == "S":
                users.setdefault(plain(step), []).append(row.claim.id)
                known = (common.get(plain(one)) for one in step.rests_on)
                below.setdefault(plain(step), {}).update(dict.fromkeys(filter(None, known)))
    lines = tuple((common[step], *cells(step, below[step]), _listed(users[step])) for step in users)
    table = Table(HEAD, lines, "Each is listed once", tuple(f"step-{line[0]}" for line in lines))
    return Section(ID, TITLE, (table,) if lines else ())


HEAD = ("step", "kind", "checked statement", "result", "claims")


def cells(step: Evidence, below: Iterable[str]) -> tuple[str, str, str]:
    """Return kind, statement with its remarks, and result of a step that rests on steps of these names."""
    about = "" if step.about is Subject.CLAIM else f"{step.about.value.capitalize()}: "
    beside = "Beside the proof. " if step.supports and step.kind is not EvidenceKind.READING else ""
    rests = ", ".join(f"`{name}`" for name in below)
    remarks = [f"Given {', '.join(step.assumptions)}"] if step.assumptions and step.engine != "Coq" else []
    remarks += [f"Rests on {rests}"] if rests else []
    remarks += [f"Cites {'; '.join(step.cites)}"] if step.cites else []
    return (
        f"{step.kind.value}\n{step.engine}",
        "\n".join([f"{beside}{about}{step.statement}", *remarks]),
        "\n".join(filter(None, [OUTCOMES[step.passed], cases(step), step.value])),
    )


def cases(step: Evidence) -> str:
    """Return how many cases a step covers, where it is not one."""
    return f"{step.cases:,} {step.counted}" if step.cases != 1 else ""


def _listed(rows: Iterable[str]) -> str:
    return ", ".join(f"`{one}`" for one in dict.fromkeys(rows))
