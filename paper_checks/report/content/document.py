"""The whole report as data: what every form of it writes, in the same order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from paper_checks.claims import source
from paper_checks.report.content import blocks, notation, opening, trust
from paper_checks.report.content.blocks import Block, Labelled, Paragraph, Picture, Section
from paper_checks.report.content.story import story
from paper_checks.running.runner import Row

TITLE = f"{source.TITLE}: its claims, checked"
STEPS = (
    "Every row rests on checked steps, which are not printed here: the HTML form of this report unfolds them, and draws which "
    "rows rest on which; `--steps` prints them."
)
ROWS, ROWS_TITLE = "rows", "The paper's claims, one by one"


@dataclass(frozen=True)
class Document:
    """A report: what the paper models, sections before the rows, the rows with their stories, sections after them."""

    title: str
    model: tuple[Block, ...]
    before: tuple[Section, ...]
    rows: tuple[Row, ...]
    after: tuple[Section, ...]
    stories: Mapping[str, tuple[Block, ...]] = field(default_factory=dict)

    @property
    def is_whole(self) -> bool:
        """Return whether it has rows, so that a page of it ends with what a reader can play with."""
        return bool(self.rows)

    def on_paper(self) -> Document:
        """Return it without what a page folds, with a sentence on where that is, and each row's picture once."""
        note = (Section("steps", "The steps", (Paragraph(STEPS),)),) if self.rows else ()
        return replace(
            self,
            before=tuple(replace(one, blocks=blocks.unfolded(one.blocks)) for one in (*self.before, *note)),
            after=tuple(replace(one, blocks=blocks.unfolded(one.blocks)) for one in self.after),
            stories=_each_picture_once({name: blocks.unfolded(story) for name, story in self.stories.items()}),
        )

    @property
    def sections(self) -> tuple[Section, ...]:
        """Return all sections but the rows."""
        return (*self.before, *self.after)

    @property
    def anchors(self) -> Iterator[str]:
        """Yield all that a link can point to."""
        yield from (row.claim.id for row in self.rows)
        for section in self.sections:
            yield from blocks.anchors(section)

    @property
    def pictures(self) -> tuple[str, ...]:
        """Return the names of its figures, each once, in their order."""
        everything = [self.model, *(section.blocks for section in self.before), *self.stories.values()]
        everything += [section.blocks for section in self.after]
        return tuple(dict.fromkeys(picture.name for some in everything for picture in blocks.pictures(some)))


def _each_picture_once(stories: Mapping[str, tuple[Block, ...]]) -> Mapping[str, tuple[Block, ...]]:
    """Return stories in which a picture of an earlier one is a link to that."""
    shown: dict[str, str] = {}

    def once(row: str, block: Block) -> Block:
        if not isinstance(block, Picture) or shown.setdefault(block.name, row) == row:
            return block
        return Labelled("Picture", f"{block.title}, drawn under `{shown[block.name]}`.")

    return {row: tuple(once(row, block) for block in story) for row, story in stories.items()}


def document(rows: Sequence[Row], chapters: Sequence[Section] = ()) -> Document:
    """Return the report on these rows, with `chapters` after them."""
    elsewhere = frozenset(anchor for chapter in chapters for anchor in blocks.anchors(chapter))
    return Document(
        TITLE,
        opening.model(),
        (opening.section(rows), *opening.refuted(rows)),
        tuple(rows),
        (trust.section(rows), notation.section(), trust.graph(rows), *chapters, trust.provenance()),
        {row.claim.id: story(row, elsewhere) for row in rows},
    )


def summary(rows: Sequence[Row]) -> Document:
    """Return the report on two pages: the first screen, the rows that do not simply hold, how to trust them."""
    return Document(
        f"{TITLE}, in short",
        opening.model(),
        (opening.section(rows), opening.exceptions(rows)),
        (),
        (trust.section(rows, short=True),),
    )
