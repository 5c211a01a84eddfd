"""The whole report as data: what the page shows, and of which paper is a selection."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from paper_checks.claims import source
from paper_checks.report.content import blocks, derivation, kernel, notation, opening, shared, trust
from paper_checks.report.content.blocks import Block, Section
from paper_checks.report.content.story import story
from paper_checks.running.runner import Row

TITLE = f"{source.TITLE}: its claims, checked"
ROWS = "rows"
"""The anchor of the list of claims."""


@dataclass(frozen=True)
class Document:
    """A report: what a reader meets first, the rows with their stories, and chapters, which a page shows folded."""

    title: str
    front: tuple[Section, ...]
    rows: tuple[Row, ...]
    chapters: tuple[Section, ...]
    stories: Mapping[str, tuple[Block, ...]] = field(default_factory=dict)

    @property
    def anchors(self) -> tuple[str, ...]:
        """Return all that a link can point to."""
        chapters = (anchor for one in self.chapters for anchor in blocks.anchors(one))
        return (*(one.id for one in self.front), ROWS, *(row.claim.id for row in self.rows), *chapters)

    @property
    def pictures(self) -> tuple[str, ...]:
        """Return the names of its figures, each once, in their order."""
        everything = [
            *(one.blocks for one in self.front),
            *self.stories.values(),
            *(one.blocks for one in self.chapters),
        ]
        return tuple(dict.fromkeys(picture.name for some in everything for picture in blocks.pictures(some)))


def document(rows: Sequence[Row], chapters: Sequence[Section] = (), answers: Sequence[str] = ()) -> Document:
    """Return the report on these rows, with `chapters` among its own, and `answers` for who asks how fast it is."""
    elsewhere = frozenset(anchor for chapter in chapters for anchor in blocks.anchors(chapter))
    common = shared.names(rows)
    asked = opening.questions(rows, answers)
    after = (
        derivation.section(rows),
        opening.new(rows),
        opening.not_judged(rows),
        opening.still_open(rows),
        asked,
        *chapters,
        kernel.section(rows),
        shared.section(rows, common),
    )
    return Document(
        TITLE,
        opening.front(rows),
        tuple(rows),
        (*(one for one in after if one.blocks), trust.section(rows), notation.section(), trust.provenance()),
        {row.claim.id: story(row, common, elsewhere) for row in rows},
    )
