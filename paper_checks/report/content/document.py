"""The whole report as data: what every form of it writes, in the same order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from paper_checks.claims import source
from paper_checks.report.content import blocks, kernel, notation, opening, shared, trust
from paper_checks.report.content.blocks import Block, Paragraph, Picture, Section
from paper_checks.report.content.story import story
from paper_checks.running.runner import Row

TITLE = f"{source.TITLE}: its claims, checked"
STEPS = (
    "Every row rests on checked steps, which are not printed here: the HTML form of this report unfolds them; `--steps` "
    "prints them."
)
ROWS, ROWS_TITLE = "rows", "All claims and theorems"


@dataclass(frozen=True)
class Document:
    """A report: what a reader meets first, the rows with their stories, and chapters, each a page of its own in HTML."""

    title: str
    front: tuple[Section, ...]
    rows: tuple[Row, ...]
    chapters: tuple[Section, ...]
    stories: Mapping[str, tuple[Block, ...]] = field(default_factory=dict)

    def on_paper(self) -> Document:
        """Return it without what a page folds, with a sentence on where that is, and each row's picture once."""
        chapters = (*self.chapters, Section("steps", "The steps", (Paragraph(STEPS),)))
        return replace(
            self,
            front=tuple(replace(one, blocks=blocks.unfolded(one.blocks)) for one in self.front),
            chapters=tuple(replace(one, blocks=blocks.unfolded(one.blocks)) for one in chapters),
            stories=_each_picture_once({name: blocks.unfolded(story) for name, story in self.stories.items()}),
        )

    @property
    def anchors(self) -> Iterator[str]:
        """Yield all that a link can point to."""
        yield from (row.claim.id for row in self.rows)
        for section in (*self.front, *self.chapters):
            yield from blocks.anchors(section)

    @property
    def pictures(self) -> tuple[str, ...]:
        """Return the names of its figures, each once, in their order."""
        everything = [
            *(one.blocks for one in self.front),
            *self.stories.values(),
            *(one.blocks for one in self.chapters),
        ]
        return tuple(dict.fromkeys(picture.name for some in everything for picture in blocks.pictures(some)))


def _each_picture_once(stories: Mapping[str, tuple[Block, ...]]) -> Mapping[str, tuple[Block, ...]]:
    """Return stories in which a picture of an earlier one is a link to that."""
    shown: dict[str, str] = {}

    def once(row: str, block: Block) -> Block:
        if not isinstance(block, Picture) or shown.setdefault(block.name, row) == row:
            return block
        return Paragraph(f"{block.title}, drawn under `{shown[block.name]}`.", "Picture")

    return {row: tuple(once(row, block) for block in story) for row, story in stories.items()}


def document(rows: Sequence[Row], chapters: Sequence[Section] = (), answers: Sequence[str] = ()) -> Document:
    """Return the report on these rows, with `chapters` among its own, and `answers` for who asks how fast it is."""
    elsewhere = frozenset(anchor for chapter in chapters for anchor in blocks.anchors(chapter))
    common = shared.names(rows)
    asked = opening.questions(rows, answers)
    after = (
        opening.new(rows),
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
