"""The report as a paper: what is printed, and in which order. The steps of each claim stay with the pages and the program."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from paper_checks.evidence.claim import Kind
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content import blocks, kernel, opening, story
from paper_checks.report.content.blocks import Block, Cards, Paragraph, Section
from paper_checks.report.content.document import Document
from paper_checks.report.content.phrases import COUNTED, in_short
from paper_checks.running.runner import Row

FIRST, LAST = "model", ("open", "trust", "notation", "provenance")
"""The section that stands before the contents, and those after the theorems."""
READ = (
    "Below, a claim stands with its place in the paper and with the kind of the weakest check that its verdict needs; `trust` says "
    "what each kind guarantees. `python -m paper_checks run ID` prints all checks behind a claim, by its name."
)
ASSUMED = "Each theorem says what it assumes; where it says nothing:"


@dataclass(frozen=True)
class Part:
    """A section in print: its blocks, the entries of claims or theorems, and what stands below them."""

    section: Section
    rows: tuple[Row, ...] = ()
    below: tuple[Block, ...] = ()


def abstract(report: Document) -> tuple[Block, ...]:
    """Return what stands before the contents."""
    known = next((one.blocks for one in report.front if one.id == FIRST), ())
    return (*known, Paragraph(READ))


def parts(report: Document) -> tuple[Part, ...]:
    """Return the numbered sections in their order, those that have something to say."""
    return tuple(one for one in _parts(report) if one.rows or one.section.blocks)


def _parts(report: Document) -> Iterator[Part]:
    known = {one.id: one for one in (*report.front, *report.chapters)}
    empty = Section("", "", ())
    shown = tuple(block for block in known.get("refuted", empty).blocks if isinstance(block, Cards))
    yield _claims(report.rows, Verdict.REFUTED, shown)
    yield Part(_in_words(known.get("results", empty)))
    yield Part(known.get("derivation", empty))
    yield from (_claims(report.rows, verdict) for verdict in Verdict if verdict is not Verdict.REFUTED)
    if theorems := tuple(row for row in report.rows if _is_theorem(row)):
        yield Part(Section("new", "Theorems past the paper", (Paragraph(f"{ASSUMED} {opening.FREE}"),)), theorems)
    yield Part(Section(kernel.ID, kernel.TITLE, kernel.notion(report.rows)))
    yield from (Part(known.get(name, empty)) for name in LAST)


def _in_words(section: Section) -> Section:
    """Return a section with the texts of its cards, without their pictures."""
    cards = (
        Paragraph(text, title) for block in section.blocks if isinstance(block, Cards) for title, text, _ in block.items
    )
    return replace(section, blocks=(*cards, *(block for block in section.blocks if not isinstance(block, Cards))))


def pictures(report: Document) -> tuple[str, ...]:
    """Return the names of the figures that are printed, each once."""
    shown = (*abstract(report), *(block for part in parts(report) for block in (*part.section.blocks, *part.below)))
    return tuple(dict.fromkeys(picture.name for picture in blocks.pictures(shown)))


def entry(row: Row) -> Iterator[Block]:
    """Yield what is printed of a claim or theorem: the statement, and why it holds or what is true instead."""
    finding = row.finding
    hypotheses = opening.hypotheses(row.claim.id) if _is_theorem(row) else opening.FREE
    assumed = "" if hypotheses == opening.FREE else f"{hypotheses} "
    yield Paragraph(assumed + " ".join(map(story.displayed, row.claim.clauses)))
    texts = {"Counterexample": finding.counterexample, "What is true": finding.corrected}
    if not _is_theorem(row) and not any(texts.values()):
        texts["Why"] = in_short(row)
    texts["Missing for a proof"] = finding.missing
    yield from (Paragraph(text, label) for label, text in texts.items() if text)


def _claims(rows: Sequence[Row], verdict: Verdict, below: tuple[Block, ...] = ()) -> Part:
    """Return the paper's claims with this verdict."""
    some = tuple(row for row in rows if not _is_theorem(row) and row.finding.verdict is verdict)
    return Part(Section(verdict.value, f"Claims that {COUNTED[verdict][1]}", ()), some, below)


def _is_theorem(row: Row) -> bool:
    return row.claim.kind is Kind.THEOREM
