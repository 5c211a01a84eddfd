"""The whole report as data: what the page shows, and of which paper is a selection."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from paper_checks.claims import source
from paper_checks.evidence.claim import Kind
from paper_checks.evidence.evidence import Evidence
from paper_checks.report.content import blocks, derivation, kernel, notation, opening, shared, story, trust
from paper_checks.report.content.blocks import Section
from paper_checks.running.runner import Row

TITLE = f"{source.TITLE}: its claims, checked"
ROWS = "rows"
"""The anchor of the list of claims."""
OF_THE_PAGE = {
    "new": "New beyond the paper",
    "not-judged": "Statements not judged",
    "questions": "Frequent questions",
}
"""Chapters that paper has not; each is a template of its own."""


@dataclass(frozen=True)
class Document:
    """A report: what a reader meets first, the claims, and chapters; `common` names the steps that stand in a chapter."""

    title: str
    front: tuple[Section, ...]
    rows: tuple[Row, ...]
    chapters: tuple[Section, ...]
    common: Mapping[Evidence, str]
    answers: tuple[str, ...] = ()

    @property
    def anchors(self) -> tuple[str, ...]:
        """Return all that a link can point to."""
        chapters = (anchor for one in self.chapters for anchor in blocks.anchors(one))
        return (*(one.id for one in self.front), ROWS, *(row.claim.id for row in self.rows), *chapters)

    @property
    def pictures(self) -> tuple[str, ...]:
        """Return the names of its figures, each once."""
        sections = (name for one in (*self.front, *self.chapters) for name in one.pictures)
        return tuple(dict.fromkeys([*sections, *filter(None, map(story.figure, self.rows))]))


def document(rows: Sequence[Row], chapters: Sequence[Section] = (), answers: Sequence[str] = ()) -> Document:
    """Return the report on these rows, with `chapters` among its own, and `answers` for who asks how fast it is."""
    common = shared.names(rows)
    told = {"questions", *(row.finding.verdict.value for row in rows)}
    told |= {"new"} if any(row.claim.kind is Kind.THEOREM for row in rows) else set()
    after = (
        derivation.section(rows),
        *(Section(name, title, ()) for name, title in OF_THE_PAGE.items() if name in told),
        opening.still_open(rows),
        *chapters,
        kernel.section(rows),
        shared.section(rows, common),
        trust.section(rows),
        notation.section(),
        trust.provenance(),
    )
    shown = tuple(one for one in after if one.blocks or one.id in OF_THE_PAGE)
    return Document(TITLE, opening.front(rows), tuple(rows), shown, common, tuple(answers))
