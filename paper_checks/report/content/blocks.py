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
    """A paragraph."""

    text: str


@dataclass(frozen=True)
class Labelled:
    """A paragraph with a label before it; the marked one is what a reader should see first."""

    label: str
    text: str
    marked: bool = False


@dataclass(frozen=True)
class Points:
    """A list of sentences."""

    items: tuple[str, ...]


@dataclass(frozen=True)
class Numbered:
    """A list of steps in their order."""

    items: tuple[str, ...]


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
class Command:
    """A command that a reader can run."""

    text: str


@dataclass(frozen=True)
class Symbols:
    """Links to the meaning of symbols, by their ids in `paper_checks.report.content.notation`."""

    ids: tuple[str, ...]


@dataclass(frozen=True)
class Result:
    """A finding: what the paper says, what is true, one number and what it is, a picture; and its row."""

    title: str
    row: str
    where: str
    says: str
    truth: str
    number: str
    what: str
    picture: Picture


@dataclass(frozen=True)
class Folded:
    """What is shown when a reader asks for it; paper has it where all steps are asked for."""

    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Node:
    """A node of a graph: the anchor that it points to, its text, its kind, and the anchors that it rests on."""

    anchor: str
    text: str
    kind: str
    below: tuple[str, ...] = ()


@dataclass(frozen=True)
class Graph:
    """Rows on the left, what they rest on on the right; drawn where it can be clicked, else its table says the same."""

    rows: tuple[Node, ...]
    steps: tuple[Node, ...]
    kinds: tuple[str, ...]
    caption: str


Block = (
    Heading | Paragraph | Labelled | Points | Numbered | Table | Picture | Command | Symbols | Result | Folded | Graph
)


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


def unfolded(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    """Return the blocks without those that are folded, as paper has them."""
    return tuple(block for block in blocks if not isinstance(block, Folded))


def pictures(blocks: tuple[Block, ...]) -> Iterator[Picture]:
    """Yield all figures among the blocks."""
    for block in every(blocks):
        if isinstance(block, Picture):
            yield block
        elif isinstance(block, Result):
            yield block.picture


def anchors(section: Section) -> Iterator[str]:
    """Yield all that a link can point to in a section."""
    yield section.id
    for block in every(section.blocks):
        if isinstance(block, Heading) and block.id:
            yield block.id
        elif isinstance(block, Table):
            yield from filter(None, block.ids)
