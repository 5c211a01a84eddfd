"""Blocks as typst markup."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from paper_checks.report import blocks, mathematics
from paper_checks.report.blocks import (
    Block,
    Command,
    Folded,
    Graph,
    Heading,
    Labelled,
    Numbered,
    Paragraph,
    Picture,
    Points,
    Result,
    Section,
    Symbols,
    Table,
)
from paper_checks.report.latex_blocks import shares
from paper_checks.report.mathematics import Piece, pieces
from paper_checks.report.mathml import UnreadableMathematicsError
from paper_checks.report.typst_mathematics import typst

_SPECIAL = re.compile(r"[\\#$*_`<>@\[\]~=/+\-'\"]")


class TypstWriter:
    """Writes blocks as typst markup. `figures` maps names to files beside the source, `anchors` are its labels."""

    def __init__(self, figures: Mapping[str, str], anchors: Iterable[str] = ()) -> None:
        """Take the figures and the labels."""
        self._figures = figures
        self._anchors = frozenset(anchors)

    def section(self, section: Section) -> str:
        """Return a section with its heading."""
        return f"== {self.text(section.title)} <{section.id}>\n\n{self.blocks(section.blocks)}"

    def blocks(self, some: Sequence[Block]) -> str:
        """Return blocks one below the other."""
        return "\n\n".join(filter(None, map(self._block, some)))

    def text(self, text: str) -> str:
        """Return a text as typst markup."""
        return blocks.with_code(blocks.with_links(text, self._anchors), self._prose, self._code)

    def _prose(self, text: str) -> str:
        return "".join(self._piece(kind, content) for kind, content in pieces(text))

    @staticmethod
    def _piece(kind: Piece, content: str) -> str:
        if kind is Piece.PROSE:
            return escaped(content)
        try:
            return typst(content, display=kind is Piece.DISPLAY)
        except UnreadableMathematicsError:
            return _raw(content)

    def _code(self, code: str) -> str:
        shown = _raw(code)
        target = next((one for one in (code, f"theorem-{code}") if one in self._anchors), None)
        return f"#link(<{target}>)[{shown}]" if target else shown

    def _block(self, block: Block) -> str:  # noqa: PLR0911  one return for each kind of block
        match block:
            case Heading(text, anchor):
                return f"=== {self.text(text)}{f' <{anchor}>' if anchor else ''}"
            case Paragraph(text):
                return self.text(text)
            case Labelled(label, text, marked):
                told = f"#strong[{escaped(label)}.] {self.text(text)}"
                return f"#decisive[{told}]" if marked else told
            case Points(items):
                return "\n".join(f"- {self.text(item)}" for item in items)
            case Numbered(items):
                return "\n".join(f"+ {self.text(item)}" for item in items)
            case Command(text):
                return _raw(text)
            case Table():
                return self._table(block)
            case Picture():
                return self._picture(block)
            case Result():
                return self._result(block)
            case Folded(title, inside):
                return f"#strong[{self.text(title)}.]\n\n{self.blocks(inside)}"
            case Symbols() | Graph():
                return ""

    def _picture(self, picture: Picture) -> str:
        if picture.name not in self._figures:
            return f"The figure {escaped(picture.name)} was not drawn."
        title = f"#strong[{self.text(picture.title)}.] " if picture.title else ""
        alt = mathematics.plain(f"{picture.title}. {picture.caption}").replace("\\", "").replace('"', "'")
        return f'#picture("{self._figures[picture.name]}", "{alt}")[{title}{self.text(picture.caption)}]'

    def _result(self, result: Result) -> str:
        told = "\n\n".join(
            [
                f"#strong[The paper says] ({self.text(result.where)}): {self.text(result.says)}",
                f"#strong[What is true:] {self.text(result.truth)}",
                f"#strong[{self.text(result.number)}] {self.text(result.what)} {self.text(f'(row `{result.row}`)')}",
            ]
        )
        return f"=== {self.text(result.title)}\n\n#aside[{told}][{self._picture(result.picture)}]"

    def model(self, some: Sequence[Block]) -> str:
        """Return what the paper models: its picture beside its symbols."""
        text, picture, symbols = map(self._block, some)
        return f"{text}\n\n#aside[{picture}][{symbols}]"

    def _table(self, table: Table) -> str:
        widths = ", ".join(f"{share:.3f}fr" for share in shares(table))
        ids = table.ids or ("",) * len(table.rows)
        head = ", ".join(f"[#strong[{self.text(text)}]]" for text in table.head)
        lines = ",\n".join(
            ", ".join(self._cell(cell, anchor if n == 0 else "") for n, cell in enumerate(row))
            for row, anchor in zip(table.rows, ids, strict=True)
        )
        return f"#emph[{self.text(table.caption)}]\n#table(columns: ({widths},), table.header({head}),\n{lines})"

    def _cell(self, text: str, anchor: str) -> str:
        first, *remarks = text.split("\n")
        label = f"#metadata(none) <{anchor}> " if anchor else ""
        small = "".join(f" \\ #text(size: 0.88em)[{self.text(one)}]" for one in remarks if one)
        return f"[{label}{self.text(first)}{small}]"


def escaped(text: str) -> str:
    """Return prose with what is special to typst escaped."""
    return _SPECIAL.sub(lambda match: "\\" + match[0], text)


def _raw(code: str) -> str:
    text = code.replace("\\", "\\\\").replace('"', '\\"')
    return f'#raw("{text}")'
