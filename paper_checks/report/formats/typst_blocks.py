"""Blocks as typst markup."""

from __future__ import annotations

import re
from collections.abc import Sequence

from paper_checks.report.content import blocks
from paper_checks.report.formats.writer import Writer, shares
from paper_checks.report.mathematics import prose
from paper_checks.report.mathematics.mathml import UnreadableMathematicsError
from paper_checks.report.mathematics.prose import Piece, pieces
from paper_checks.report.mathematics.typst import typst

_SPECIAL = re.compile(r"[\\#$*_`<>@\[\]~=/+\-'\"]")


class TypstWriter(Writer):
    """Writes blocks as typst markup. `figures` maps names to files beside the source, `anchors` are its labels."""

    def section(self, section: blocks.Section) -> str:
        """Return a section with its heading."""
        return f"== {self.text(section.title)} <{section.id}>\n\n{self.body(section.blocks)}"

    def body(self, some: Sequence[blocks.Block]) -> str:
        """Return blocks one below the other."""
        return "\n\n".join(filter(None, map(self._block, some)))

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
        target = self._target(code)
        return f"#link(<{target}>)[{shown}]" if target else shown

    def _block(self, block: blocks.Block) -> str:  # noqa: PLR0911  one return for each kind of block
        match block:
            case blocks.Heading(text, anchor):
                return f"=== {self.text(text)}{f' <{anchor}>' if anchor else ''}"
            case blocks.Paragraph(text):
                return self.text(text)
            case blocks.Labelled(label, text, marked):
                told = f"#strong[{escaped(label)}.] {self.text(text)}"
                return f"#decisive[{told}]" if marked else told
            case blocks.Points(items):
                return "\n".join(f"- {self.text(item)}" for item in items)
            case blocks.Numbered(items):
                return "\n".join(f"+ {self.text(item)}" for item in items)
            case blocks.Command(text):
                return _raw(text)
            case blocks.Table():
                return self._table(block)
            case blocks.Picture():
                return self._picture(block)
            case blocks.Result():
                return self._result(block)
            case blocks.Folded(title, inside):
                return f"#strong[{self.text(title)}.]\n\n{self.body(inside)}"
            case blocks.Symbols() | blocks.Graph():
                return ""

    def _picture(self, picture: blocks.Picture) -> str:
        if picture.name not in self._figures:
            return f"The figure {escaped(picture.name)} was not drawn."
        title = f"#strong[{self.text(picture.title)}.] " if picture.title else ""
        alt = prose.plain(f"{picture.title}. {picture.caption}").replace("\\", "").replace('"', "'")
        return f'#picture("{self._figures[picture.name]}", "{alt}")[{title}{self.text(picture.caption)}]'

    def _result(self, result: blocks.Result) -> str:
        told = "\n\n".join(
            [
                f"#strong[The paper says] ({self.text(result.where)}): {self.text(result.says)}",
                f"#strong[What is true:] {self.text(result.truth)}",
                f"#strong[{self.text(result.number)}] {self.text(result.what)} {self.text(f'(row `{result.row}`)')}",
            ]
        )
        return f"=== {self.text(result.title)}\n\n#aside[{told}][{self._picture(result.picture)}]"

    def model(self, some: Sequence[blocks.Block]) -> str:
        """Return what the paper models: its picture beside its symbols."""
        text, picture, symbols = map(self._block, some)
        return f"{text}\n\n#aside[{picture}][{symbols}]"

    def _table(self, table: blocks.Table) -> str:
        widths = ", ".join(f"{share:.3f}fr" for share in shares(table))
        ids = table.ids or ("",) * len(table.rows)
        head = ", ".join(f"[#strong[{self.text(text)}]]" for text in table.head)
        lines = ",\n".join(
            ", ".join(self._cell(cell, anchor if n == 0 else "") for n, cell in enumerate(row))
            for row, anchor in zip(table.rows, ids, strict=True)
        )
        return f"#block(sticky: true)[#emph[{self.text(table.caption)}]]\n#table(columns: ({widths},), table.header({head}),\n{lines})"

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
