"""What a report is made of, and how its chapters, which are Markdown, are read into it; each format writes these blocks.

    # Title {#id}              the title of a section; ## of a heading in it
    **Label.** Text. {.mark}   a paragraph; its label, anchor and mark may be left out
    - Item                     a list
    ¦ cell ¦ cell              a table, its head first; `: caption` below it; `<br>` begins a remark in small print
    ![name]                    a figure
    ::: kind Title {#id}       a container, `folded`, `card` or `entry`, until the line `:::`
    ```                        lines of fixed width, until the next such line

Texts are prose with LaTeX between dollars and commands, or ids of claims, between backticks.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

_PARTS = re.compile(
    r"^```\n(?P<code>.*?)\n```$|^::: (?P<kind>\w+) (?P<title>[^\n]*)\n(?P<inside>.*?)\n:::$"
    r"|^(?P<table>(?:¦[^\n]*\s*)+(?:: [^\n]*)?)|^(?P<lines>(?:[^\n]*\S[^\n]*\n?)+)",
    re.DOTALL | re.MULTILINE,
)
_MARKS = re.compile(r"\s*\{(?:#([\w.-]+))? ?(?:\.([\w-]+))?\}$")
_HEADING, _LABEL = re.compile(r"(#+) (.*)"), re.compile(r"\*\*(.*?)\.\*\* ?(.*)")
CELL = "¦"
CHAPTERS = Environment(
    loader=FileSystemLoader(Path(__file__).with_name("chapters")),
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
    comment_start_string="<!--",
    comment_end_string="-->",
)
CHAPTERS.filters["line"] = lambda text: " ".join(str(text).split())


@dataclass(frozen=True)
class Block:
    """A block of this kind, with its anchor; a table has rows in it, and a row or a list has items."""

    kind: str
    text: str = ""
    label: str = ""
    id: str = ""
    mark: str = ""
    items: tuple[str, ...] = ()
    inside: tuple[Block, ...] = ()


@dataclass(frozen=True)
class Section:
    """A section of the report: its anchor, its title, its blocks."""

    id: str
    title: str
    blocks: tuple[Block, ...]

    @property
    def pictures(self) -> tuple[str, ...]:
        """The names of its figures."""
        return tuple(block.text for block in every(self.blocks) if block.kind == "picture")

    @property
    def anchors(self) -> tuple[str, ...]:
        """All that a link can point to in it."""
        return (self.id, *(block.id for block in every(self.blocks) if block.id))


def every(blocks: Sequence[Block]) -> Iterator[Block]:
    """Yield the blocks and those in them."""
    for block in blocks:
        yield block
        yield from every(block.inside)


def section(text: str) -> Section | None:
    """Return the section that a text is; None where it says nothing."""
    title, *blocks = read(text) or [Block("")]
    return Section(title.id, title.text, tuple(blocks)) if blocks else None


def chapter(name: str, **given: Any) -> str:
    """Return the text of a chapter, a template of this name, with what is given to it."""
    return CHAPTERS.get_template(f"{name}.md").render(given)


def read(text: str) -> list[Block]:
    """Return the blocks of a text."""
    return [_block(found.groupdict("")) for found in _PARTS.finditer(text)]


def _block(found: dict[str, str]) -> Block:
    if found["code"]:
        return Block("code", found["code"])
    if found["kind"]:
        title, id, mark = _marked(found["title"])
        return Block(found["kind"], title, id=id, mark=mark, inside=tuple(read(found["inside"])))
    if found["table"]:
        rows, _, caption = found["table"].partition("\n: ")
        return Block("table", caption, inside=tuple(map(_row, filter(None, rows.splitlines()))))
    if found["lines"].startswith("- "):
        items = found["lines"].removeprefix("- ").split("\n- ")
        return Block("points", items=tuple(" ".join(one.split()) for one in items))
    return _one_text(" ".join(found["lines"].split()))


def _one_text(line: str) -> Block:
    text, id, mark = _marked(line)
    if picture := re.fullmatch(r"!\[(.+)\]", text):
        return Block("picture", picture[1])
    if title := _HEADING.fullmatch(text):
        return Block("heading", title[2], id=id)
    label = _LABEL.fullmatch(text)
    return Block("paragraph", label[2] if label else text, label[1] if label else "", id, mark)


def _row(line: str) -> Block:
    text, id, _ = _marked(line)
    return Block("row", id=id, items=tuple(cell.strip() for cell in text.removeprefix(CELL).split(f" {CELL} ")))


def _marked(text: str) -> tuple[str, str, str]:
    """Return a text without the anchor and the mark behind it, and these."""
    found = _MARKS.search(text)
    return (text[: found.start()], found[1] or "", found[2] or "") if found else (text, "", "")
