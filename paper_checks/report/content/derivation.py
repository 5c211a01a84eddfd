"""The derivation as a chapter, and the lines of it that carry one claim: each line with what its checks found."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from paper_checks.decide import kernel
from paper_checks.derivation.chapter import LINES, STAGES, lines_of, number
from paper_checks.derivation.line import Drawn, Line, Stage, number_in
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Steps, closure
from paper_checks.report.content import blocks
from paper_checks.report.content.blocks import Block, Heading, Paragraph, Section
from paper_checks.report.content.phrases import picture
from paper_checks.running.runner import Row

ID, TITLE = "derivation", "The derivation, line by line"
OPENING = """
From the equations of motion to the $1/t$ law, every formula in order. Each line says what was done, which check accepted it,
and which claim it carries. The formulas are printed from the expressions that the checks decide. A line that is an argument in
words says so. Lines are numbered D1, D2, and so on; numbers in parentheses are those of the paper's equations.
"""
Theorems = Mapping[str, Evidence] | None
"""What the kernel found of theorems, by their ids; None where only their names are wanted."""
TOOLS = {
    EvidenceKind.EXACT: "symbolic identity",
    EvidenceKind.SMT: "two SMT solvers",
    EvidenceKind.ENCLOSURE: "enclosure in ball arithmetic",
    EvidenceKind.ARGUMENT: "argument in words",
}
"""What a kind of evidence is called beside a line."""


def section(rows: Sequence[Row]) -> Section:
    """Return the chapter; empty where the report does not have all the claims that it carries."""
    if not is_whole(rows):
        return Section(ID, TITLE, ())
    found = {place: steps for row in rows for place, steps in of_row(row).items()}
    theorems = {name: step for row in rows for name, step in _theorems(row).items()}
    stages = (one for stage in STAGES for one in _stage(stage, found, theorems))
    return Section(ID, TITLE, (Paragraph(OPENING), Paragraph(_contents(), "Stages"), *stages))


def _contents() -> str:
    """Return the titles of the stages with their first and last lines and their anchors."""
    lines = ((stage, number(stage.lines[0]), number(stage.lines[-1])) for stage in STAGES)
    return "; ".join(f"{stage.title} (D{first} to D{last}, `{stage.id}`)" for stage, first, last in lines) + "."


def is_whole(rows: Sequence[Row]) -> bool:
    """Return whether all the claims that the derivation carries are among the rows."""
    return {name for line in LINES for name in line.claims} <= {row.claim.id for row in rows}


def checked_anew(name: str = "") -> Iterator[Block]:
    """Yield the stage of this anchor, or all, with what the checks find now; of the kernel's theorems only the names.

    Raises KeyError where there is no such stage.
    """
    for stage in [{one.id: one for one in STAGES}[name]] if name else STAGES:
        found = {number(line): line.evidence(number(line)) for line in stage.lines}
        yield from _stage(stage, found, None)


def of_row(row: Row) -> dict[int, Steps]:
    """Return what the lines that a row rests on found, by their numbers."""
    found: dict[int, Steps] = {}
    for step in dict.fromkeys(step for proof in row.proofs for step in proof.bindings):
        if (place := number_in(step)) is not None:
            found[place] = (*found.get(place, ()), step)
    return found


def _theorems(row: Row) -> dict[str, Evidence]:
    return {kernel.name_of(step): step for proof in row.proofs for step in proof.kernel}


def _stage(stage: Stage, found: Mapping[int, Steps], theorems: Theorems) -> Iterator[Block]:
    yield Heading(stage.title, stage.id)
    yield Paragraph(stage.assumed, "Assumed")
    for part in stage.parts:
        if isinstance(part, Line):
            yield shown(part, found.get(number(part), ()), theorems, anchor=f"line-{number(part)}")
        else:
            yield picture(part.name) if isinstance(part, Drawn) else Paragraph(part)


def shown(line: Line, found: Steps, theorems: Theorems, *, anchor: str = "", own: str = "") -> blocks.Line:
    """Return a line with what its checks found and what the kernel says of its theorems; on the page of `own`, only of those it needs."""
    try:
        formula = line.latex()
    except Exception as error:  # noqa: BLE001  a theory that is broken must not cost the reader the chapter
        formula = f" (no formula: {type(error).__name__})"
    failed = [step for step in found if step.passed is not True]
    if failed or not found:
        remark = (
            f"Failed: {failed[0].value or failed[0].statement}" if failed else "Unchecked: its claim was not decided"
        )
    else:
        names = [name for name in line.kernel.split() if not own or name in (theorems or {})]
        remark = "Checked by: " + "; ".join([*tools(found), *_kernel(names, theorems)])
    carried = ", ".join(f"`{name}`" for name in line.claims if name != own)
    remark = f"{remark.rstrip('.')}." + f" Carries {'also ' * bool(own)}{carried}." * bool(carried)
    passed = bool(found) and not failed
    return blocks.Line(number(line), line.done + formula, remark, passed, anchor)


def tools(found: Steps) -> Iterable[str]:
    """Return what believed a line: each tool once; under an argument, on how many checked steps it rests and what it cites."""
    return dict.fromkeys(map(_tool, found))


def _tool(step: Evidence) -> str:
    if step.kind is not EvidenceKind.ARGUMENT:
        return f"{TOOLS[step.kind]} ({step.engine})"
    below = len([one for one in closure(step.rests_on) if not one.supports])
    cited = f", citing {', '.join(step.cites)}" if step.cites else ""
    return f"{TOOLS[step.kind]}, over {below} checked step{'s' * (below != 1)}{cited}"


def _kernel(names: Sequence[str], theorems: Theorems) -> Iterator[str]:
    for name in names:
        known = theorems is None or (name in theorems and theorems[name].passed is True)
        status = kernel.STATUS[theorems[name].passed] if theorems and name in theorems else kernel.NOT_RUN
        yield f"kernel theorem `{name}`" + ("" if known else f" ({status})")


def story(row: Row) -> Iterator[Block]:
    """Yield the lines that carry a claim, for its own page."""
    if lines := lines_of(row.claim.id):
        found, theorems = of_row(row), _theorems(row)
        places = ", ".join(f"D{number(line)}" for line in lines)
        yield Paragraph(f"Lines {places} of the chapter `{ID}`.", "Derivation")
        yield from (shown(line, found.get(number(line), ()), theorems, own=row.claim.id) for line in lines)
