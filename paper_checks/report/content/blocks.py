"""What a report is made of: headings, paragraphs, tables, figures. Each kind of reader has a writer of these blocks.

Texts are prose with LaTeX between dollars and commands, or ids of rows, between backticks. A line break in a cell of a
table starts a remark in small print.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass


@dataclass(frozen=True)
class Heading:
    """A heading within the section; with an id, it can be pointed to."""

    text: str
    id: str = ""


@dataclass(frozen=True)
class Paragraph:
    """A paragraph; the marked one is what a reader should see first."""

    text: str
    label: str = ""
    marked: bool = False


@dataclass(frozen=True)
class Points:
    """A list of sentences, or of steps in their order."""

    items: tuple[str, ...]
    numbered: bool = False


@dataclass(frozen=True)
class Table:
    """A table; the first column names its rows. `ids`, where there are any, make each row an anchor."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    caption: str
    ids: tuple[str, ...] = ()


@dataclass(frozen=True)
class Picture:
    """A figure, by its name: its title, and a caption that says what to see in it."""

    name: str
    caption: str
    title: str = ""


@dataclass(frozen=True)
class Cards:
    """Findings side by side, each a title, a text and a picture."""

    items: tuple[tuple[str, str, Picture], ...]


@dataclass(frozen=True)
class Code:
    """Lines of fixed width: a command, or a statement of the kernel; a name in it that is an anchor is a link."""

    text: str


@dataclass(frozen=True)
class Line:
    """A numbered line of a derivation: what was done, with the formula; who believed it; and whether the check passed."""

    number: int
    text: str
    remark: str
    passed: bool
    id: str = ""


@dataclass(frozen=True)
class Folded:
    """What is shown when a reader asks for it, and on paper is in small print; with an id, it can be pointed to there."""

    title: str
    blocks: tuple[Block, ...]
    id: str = ""


Block = Heading | Paragraph | Points | Table | Picture | Cards | Code | Line | Folded


@dataclass(frozen=True)
class Section:
    """A section of the report: its anchor, its title, its blocks."""

    id: str
    title: str
    blocks: tuple[Block, ...]

    @property
    def pictures(self) -> list[str]:
        """Return the names of its figures."""
        return [picture.name for picture in pictures(self.blocks)]


def every(blocks: tuple[Block, ...]) -> Iterator[Block]:
    """Yield the blocks and those folded in them."""
    for block in blocks:
        yield block
        if isinstance(block, Folded):
            yield from every(block.blocks)


def pictures(blocks: tuple[Block, ...]) -> Iterator[Picture]:
    """Yield all figures among the blocks."""
    for block in every(blocks):
        if isinstance(block, Picture):
            yield block
        elif isinstance(block, Cards):
            yield from (picture for _, _, picture in block.items)


def anchors(section: Section) -> Iterator[str]:
    """Yield all that a link can point to in a section."""
    yield section.id
    for block in every(section.blocks):
        if isinstance(block, Heading | Folded | Line) and block.id:
            yield block.id
        elif isinstance(block, Table):
            yield from filter(None, block.ids)
