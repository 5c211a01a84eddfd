"""The derivation as a chapter: the lines that the claims of a report rest on, each with what its checks found."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from paper_checks.decide import kernel
from paper_checks.derivation.chapter import LINES, STAGES, number
from paper_checks.derivation.line import Line, Stage, number_in
from paper_checks.drawing.captions import caption
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Steps, closure
from paper_checks.report.content.blocks import chapter
from paper_checks.running.runner import Row

Theorems = Mapping[str, Evidence] | None
"""What the kernel found of theorems, by their ids; None where only their names are wanted."""
TOOLS = {
    EvidenceKind.EXACT: "symbolic identity",
    EvidenceKind.SMT: "two SMT solvers",
    EvidenceKind.ENCLOSURE: "enclosure in ball arithmetic",
    EvidenceKind.ARGUMENT: "argument in words",
}
"""What a kind of evidence is called beside a line."""


def given(rows: Sequence[Row]) -> dict[str, Any]:
    """Return what the chapter needs: the stages with the lines that carry some of these claims, and how lines are written."""
    known = {row.claim.id for row in rows}
    proofs = [proof for row in rows for proof in row.proofs]
    theorems = {kernel.name_of(step): step for proof in proofs for step in proof.kernel}
    found: dict[int, dict[Evidence, None]] = {}
    for step in (step for proof in proofs for step in proof.bindings):
        if (place := number_in(step)) is not None:
            found.setdefault(place, {})[step] = None
    return {
        "stages": [one for one in (_cut(stage, known) for stage in STAGES) if one.lines],
        "whole": {name for line in LINES for name in line.claims} <= known,
        "number": number,
        "formulas": _formulas,
        "remark": lambda line: remark(line, (*found.get(number(line), ()),), theorems),
    }


def _cut(stage: Stage, known: set[str]) -> Stage:
    """Return a stage without the lines that carry none of the claims."""
    kept = (part for part in stage.parts if not isinstance(part, Line) or known & set(part.claims))
    return replace(stage, parts=tuple(kept))


def markdown(*names: str, pictures: Collection[str] = ()) -> str:
    """Return the stages of these anchors, or the chapter, as Markdown for documentation and notebooks, the lines checked anew.

    Of the kernel's theorems it has the names only, and of the figures those of `pictures`. Raises KeyError where there is no
    such stage, and ValueError where the check of a line does not pass.
    """
    known = {one.id: one for one in STAGES}
    written = {
        "number": number,
        "formulas": _formulas,
        "remark": lambda line: remark(line, line.evidence(number(line))),
    }
    texts = [chapter("stage", stage=known[name], **written) for name in names]
    text = "".join(texts) if names else chapter("derivation", stages=STAGES, **written)
    if failed := re.search(r"^(.*)\{\.failed\}$", text, re.MULTILINE):
        raise ValueError(f"a line of the derivation is not checked: {failed[1]}")

    def drawn(name: re.Match[str]) -> str:
        title, said = caption(name[1])
        return f"![{title}]({name[1]}.svg)\n\n*{title}.* {said}" if name[1] in pictures else ""

    text = re.sub(
        r"^!\[(.+)\]$", drawn, re.sub(r"\s*\{[#.][^}\n]*\}$", "", text, flags=re.MULTILINE), flags=re.MULTILINE
    )
    text = re.sub(r"\$\$(.+?)\$\$", r"\n\n$$\n\1\n$$\n\n", text)
    return re.sub(r"\n[\n ]*\n", "\n\n", text).strip() + "\n"


def _formulas(line: Line) -> str:
    try:
        return line.latex()
    except Exception as error:  # noqa: BLE001  a theory that is broken must not cost the reader the chapter
        return f" (no formula: {type(error).__name__})"


def remark(line: Line, found: Steps, theorems: Theorems = None) -> str:
    """Return who believed a line, or why it is not believed, and the claims that it carries."""
    carried = f" Carries {', '.join(f'`{name}`' for name in line.claims)}."
    if failed := [step for step in found if step.passed is not True]:
        return f"Failed: {(failed[0].value or failed[0].statement).rstrip('.')}.{carried} {{.failed}}"
    if not found:
        return f"Unchecked: its claim was not decided.{carried} {{.failed}}"
    believed = dict.fromkeys((*map(_tool, found), *map(partial(_theorem, theorems), line.kernel.split())))
    return f"Checked by: {'; '.join(believed)}.{carried} {{.remark}}"


def _tool(step: Evidence) -> str:
    if step.kind is not EvidenceKind.ARGUMENT:
        return f"{TOOLS[step.kind]} ({step.engine})"
    below = len([one for one in closure(step.rests_on) if not one.supports])
    cited = f", citing {', '.join(step.cites)}" if step.cites else ""
    return f"{TOOLS[step.kind]}, over {below} checked step{'s' * (below != 1)}{cited}"


def _theorem(theorems: Theorems, name: str) -> str:
    status = "" if theorems is None else kernel.STATUS[theorems[name].passed] if name in theorems else kernel.NOT_RUN
    return f"kernel theorem `{name}`" + (f" ({status})" if status not in ("", kernel.PROVED) else "")
