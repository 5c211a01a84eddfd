"""Blocks as HTML."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from html import escape

from paper_checks.report.content import blocks, notation
from paper_checks.report.formats.colours import themed
from paper_checks.report.formats.html_graph import graph
from paper_checks.report.formats.writer import Writer
from paper_checks.report.mathematics import prose


class HtmlWriter(Writer):
    """Writes blocks as HTML. `figures` maps names to SVG texts; `anchors` are the ids that code in a text links to."""

    def section(self, section: blocks.Section) -> str:
        """Return a section with its heading."""
        return (
            f'<section aria-labelledby="{section.id}">\n<h2 id="{section.id}">{self.text(section.title)}</h2>\n'
            f"{self.body(section.blocks, section.id)}\n</section>"
        )

    def body(self, some: Sequence[blocks.Block], prefix: str) -> str:
        """Return blocks one below the other; `prefix` makes the ids of their figures the page's own."""
        return "\n".join(self._block(block, prefix) for block in some)

    def _prose(self, text: str) -> str:
        return prose.html(text)

    def _code(self, code: str) -> str:
        shown = f"<code>{_breakable(code)}</code>"
        target = self._target(code)
        return f'<a href="#{target}">{shown}</a>' if target else shown

    def _block(self, block: blocks.Block, prefix: str) -> str:  # noqa: PLR0911  one return for each kind of block
        match block:
            case blocks.Heading(text, anchor):
                return f"<h3{f' id={chr(34)}{anchor}{chr(34)}' if anchor else ''}>{self.text(text)}</h3>"
            case blocks.Paragraph(text):
                return f"<p>{self.text(text)}</p>"
            case blocks.Labelled(label, text, marked):
                mark = ' class="decisive"' if marked else ""
                return f"<p{mark}><strong>{escape(label)}.</strong> {self.text(text)}</p>"
            case blocks.Points(items):
                return f"<ul>\n{self._items(items)}\n</ul>"
            case blocks.Numbered(items):
                return f"<ol>\n{self._items(items)}\n</ol>"
            case blocks.Command(text):
                return f"<pre><code>{escape(text)}</code></pre>"
            case blocks.Symbols(ids):
                return f'<p class="symbols"><strong>Symbols.</strong> {", ".join(map(_symbol, ids))}</p>'
            case blocks.Folded(title, inside):
                return (
                    f'<details class="folded"><summary>{self.text(title)}</summary>\n'
                    f"{self.body(inside, prefix)}\n</details>"
                )
            case blocks.Table():
                return self._table(block)
            case blocks.Picture():
                return self._picture(block, prefix)
            case blocks.Result():
                return self._result(block, prefix)
            case blocks.Graph():
                return graph(block, self._anchors, self.text)

    def _items(self, items: Iterable[str]) -> str:
        return "\n".join(f"<li>{self.text(item)}</li>" for item in items)

    def _table(self, table: blocks.Table) -> str:
        titles = "".join(f'<th scope="col">{self.text(text)}</th>' for text in table.head)
        ids = table.ids or ("",) * len(table.rows)
        lines = "\n".join(self._line(table.head, row, anchor) for row, anchor in zip(table.rows, ids, strict=True))
        name = escape(prose.plain(table.caption).replace("`", ""))
        return (
            f'<div class="wide" role="group" aria-label="{name}"><table>\n'
            f"<caption>{self.text(table.caption)}</caption>\n<thead><tr>{titles}</tr></thead>\n<tbody>\n{lines}\n</tbody>\n"
            "</table></div>"
        )

    def _line(self, head: Sequence[str], row: Sequence[str], anchor: str) -> str:
        names = [escape(prose.plain(text).replace("`", "")) for text in head]
        cells = "".join(
            f'<td data-name="{name}">{self._cell(cell)}</td>' for name, cell in zip(names[1:], row[1:], strict=True)
        )
        mark = f' id="{anchor}"' if anchor else ""
        name = f' data-name="{names[0]}"' if names[0] else ""
        return f'<tr{mark}><th scope="row"{name}>{self._cell(row[0])}</th>{cells}</tr>'

    def _cell(self, text: str) -> str:
        first, *remarks = text.split("\n")
        return self.text(first) + "".join(f"<br><small>{self.text(remark)}</small>" for remark in remarks if remark)

    def _picture(self, picture: blocks.Picture, prefix: str) -> str:
        if picture.name not in self._figures:
            return f"<p>The figure {escape(picture.name)} was not drawn.</p>"
        title = f"<strong>{self.text(picture.title)}.</strong> " if picture.title else ""
        said = prose.plain(f"{picture.title}. {picture.caption}" if picture.title else picture.caption)
        name = escape(said.replace("`", ""))
        drawing = element(self._figures[picture.name], f"{prefix}--{picture.name}", name)
        return (
            f'<figure><div class="wide" role="group" aria-label="{name}">{drawing}</div>\n'
            f"<figcaption>{title}{self.text(picture.caption)}</figcaption></figure>"
        )

    def _result(self, result: blocks.Result, prefix: str) -> str:
        return (
            f'<article class="result"><h3>{self.text(result.title)}</h3>\n<div class="told">'
            f"<p><strong>The paper says</strong> ({self.text(result.where)}): {self.text(result.says)}</p>\n"
            f"<p><strong>What is true:</strong> {self.text(result.truth)}</p>\n"
            f'<p class="number"><b>{self.text(result.number)}</b> {self.text(result.what)} '
            f"{self.text(f'(row `{result.row}`)')}</p></div>\n{self._picture(result.picture, prefix)}</article>"
        )


def _symbol(name: str) -> str:
    symbol = notation.SYMBOLS[name]
    meaning = escape(prose.plain(symbol.meaning))
    return f'<a href="#{notation.anchor(name)}" title="{meaning}">{prose.html(f"${symbol.latex}$")}</a>'


def _breakable(code: str) -> str:
    """Return code that may be broken at its hyphens, where it is one word."""
    return escape(code) if " " in code else escape(code).replace("-", "-<wbr>")


def element(svg: str, prefix: str, name: str) -> str:
    """Return the svg element alone, told to screen readers, in the page's colours, `prefix` before each of its ids.

    `--least` and `--high` are its size with a point as a pixel: smaller, its letters cannot be read on a screen.
    """
    found = svg[svg.index("<svg") :].strip()
    found = re.sub(r'\bid="', f'id="{prefix}--', found)
    found = re.sub(r'href="#', f'href="#{prefix}--', found)
    found = re.sub(r"url\(#", f"url(#{prefix}--", found)
    size = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)', found)
    wide, high = (math.ceil(float(one)) for one in size.groups()) if size else (0, 0)
    least = f' style="--least: {wide}px; --high: {high}px"' if size else ""
    return themed(found).replace("<svg", f'<svg role="img" aria-label="{name}"{least}', 1)
