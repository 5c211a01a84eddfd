"""The report as a paper: what is printed, and in which order. The steps of each claim stay with the pages and the program."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from paper_checks.evidence.claim import FREE, Kind
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content import kernel, story
from paper_checks.report.content.blocks import Block, Cards, Folded, Paragraph, Section
from paper_checks.report.content.document import Document
from paper_checks.report.content.phrases import COUNTED, in_short, kind, theorems
from paper_checks.running.runner import Row

READ = (
    "Below, each claim has its place in the paper and the kind of the weakest check that its verdict needs; `trust` says "
    "what each kind guarantees. `python -m paper_checks run ID` prints all checks behind a claim, by its name."
)
ASSUMED = "Each theorem states its assumptions; where it states none:"
LAST = ("open", "trust", "notation", "provenance")


def sections(report: Document) -> tuple[Section, ...]:
    """Return what is printed: what stands before the contents, then the numbered sections that have something to say."""
    return tuple(one for one in _sections(report) if one.blocks)


def _sections(report: Document) -> Iterator[Section]:
    known = {one.id: one for one in (*report.front, *report.chapters)}
    some = {
        name: known.get(name, Section(name, "", ())) for name in ("model", "refuted", "results", "derivation", *LAST)
    }
    claims = {verdict: _claims(report, verdict) for verdict in Verdict}
    refuted = claims.pop(Verdict.REFUTED)
    pictures = (block for block in some["refuted"].blocks if isinstance(block, Cards))
    yield replace(some["model"], blocks=(*some["model"].blocks, Paragraph(READ)))
    yield replace(refuted, blocks=(*refuted.blocks, *pictures))
    yield replace(some["results"], blocks=tuple(_in_words(some["results"])))
    yield some["derivation"]
    yield from claims.values()
    theorems = tuple(entry(row) for row in report.rows if row.claim.kind is Kind.THEOREM)
    yield Section("new", "Theorems beyond the paper", theorems and (Paragraph(f"{ASSUMED} {FREE}"), *theorems))
    yield Section(kernel.ID, kernel.TITLE, kernel.notion(report.rows))
    yield from (some[name] for name in LAST)


def _claims(report: Document, verdict: Verdict) -> Section:
    """Return the paper's claims with this verdict."""
    of_paper = (row for row in report.rows if row.claim.kind is Kind.CLAIM)
    entries = tuple(entry(row) for row in of_paper if row.finding.verdict is verdict)
    what = "Statements" if verdict is Verdict.NOT_JUDGED else "Claims"
    return Section(verdict.value, f"{what} that {COUNTED[verdict][1]}", entries)


def _in_words(section: Section) -> Iterator[Block]:
    """Yield the blocks of a section, its cards without their pictures."""
    for block in section.blocks:
        if isinstance(block, Cards):
            yield from (Paragraph(text, title) for title, text, _ in block.items)
        else:
            yield block


def entry(row: Row) -> Folded:
    """Return what is printed of a claim or theorem: the statement, and what is true instead or, without the kernel, why it holds."""
    claim, finding = row.claim, row.finding
    said = [f"[{place(row)}]", *map(story.displayed, claim.clauses)]
    if claim.assuming != FREE:
        said.insert(1, claim.assuming)
    if claim.kind is Kind.CLAIM and not finding.corrected and row.established_by is not EvidenceKind.KERNEL:
        said.append(f"Why: {in_short(row)}")
    texts = {
        "": " ".join(said),
        "Counterexample": finding.counterexample,
        "What is true": finding.corrected,
        "Missing for a proof": finding.missing,
    }
    return Folded(f"`{claim.id}`", tuple(Paragraph(text, label) for label, text in texts.items() if text), claim.id)


def place(row: Row) -> str:
    """Return where a claim stands in the paper, with its section, and the kind of its weakest check: of the kernel, its theorems."""
    by = kind(row) + (f": {theorems(row.claim)}" if row.established_by is EvidenceKind.KERNEL else "")
    where = f"{'eq. ' * row.claim.where.startswith('(')}{row.claim.where}"
    if not re.search(rf"\b{row.claim.section}\b", where, re.IGNORECASE):
        where = f"{row.claim.section}, {where}"
    found = [where] * (row.claim.kind is Kind.CLAIM) + [by] * (row.established_by is not None)
    return "; ".join(found) or "not established"
