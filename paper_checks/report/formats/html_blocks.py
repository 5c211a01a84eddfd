"""Blocks as HTML, on one page of several."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Mapping, Sequence
from html import escape

from paper_checks.report.content import blocks
from paper_checks.report.formats.writer import Writer
from paper_checks.report.mathematics import prose

FRONT = "report.html"
BROAD = 500
"""Pixels from which on a figure takes two places of a row of cards."""
_WORD = re.compile(r"[A-Z]\w*\.[\w']+")


class HtmlWriter(Writer):
    """Writes blocks as HTML. `figures` maps names to SVG texts, `homes` each anchor to the file of its page; `page` is this one's."""

    def __init__(self, figures: Mapping[str, str], homes: Mapping[str, str], page: str = FRONT) -> None:
        """Take the figures, where each anchor is, and the page that is written."""
        super().__init__(figures, homes)
        self._homes, self._page = homes, page

    def path(self, file: str) -> str:
        """Return the path to a file of the report from this page."""
        return posixpath.relpath(file, posixpath.dirname(self._page) or ".")

    def link(self, anchor: str) -> str:
        """Return what a link to an anchor says."""
        home = self._homes[anchor]
        if home == self._page:
            return f"#{anchor}"
        return self.path(home) + ("" if posixpath.splitext(posixpath.basename(home))[0] == anchor else f"#{anchor}")

    def section(self, section: blocks.Section) -> str:
        """Return a section with its heading."""
        return (
            f'<section aria-labelledby="{section.id}">\n<h2 id="{section.id}">{self.text(section.title)}</h2>\n'
            f"{self.body(section.blocks)}\n</section>"
        )

    def _prose(self, text: str) -> str:
        return prose.html(text)

    def _code(self, code: str) -> str:
        shown = f"<code>{_breakable(code)}</code>"
        target = self._target(code)
        own = f"pages/{target}.html" == self._page  # a page does not link to itself
        return f'<a href="{self.link(target)}">{shown}</a>' if target and not own else shown

    def _heading(self, text: str, anchor: str) -> str:
        mark = f' id="{anchor}"' if anchor else ""
        level = 3 if self._page == FRONT else 2  # below the heading of its section, or of its page
        return f"<h{level}{mark}>{self.text(text)}</h{level}>"

    def _paragraph(self, block: blocks.Paragraph) -> str:
        label = f"<strong>{escape(block.label)}.</strong> " if block.label else ""
        mark = ' class="decisive"' if block.marked else ""
        return f"<p{mark}>{label}{self.text(block.text)}</p>"

    def _points(self, items: Sequence[str], numbered: bool) -> str:
        tag = "ol" if numbered else "ul"
        lines = "".join(f"<li>{item}</li>\n" for item in items)
        return f"<{tag}>\n{lines}</{tag}>"

    def _lines(self, text: str) -> str:
        linked = _WORD.sub(lambda match: self._named(match[0]), escape(text, quote=False))
        return f'<pre class="wide"><code>{linked}</code></pre>'

    def _numbered(self, line: blocks.Line) -> str:
        mark = f' id="{line.id}"' if line.id else ""
        state = "" if line.passed else " refuted"
        return (
            f'<div class="line{state}"{mark}><p><strong>D{line.number}.</strong> {self.text(line.text)}</p>'
            f"<p><small>{self.text(line.remark)}</small></p></div>"
        )

    def _named(self, word: str) -> str:
        target = self._target(word)
        return f'<a href="{self.link(target)}">{word}</a>' if target else word

    def _markup(self, html: str) -> str:
        return html

    def _folded(self, title: str, inside: str, anchor: str) -> str:
        del anchor  # what is folded is pointed to by the page that it is on
        return f'<details class="folded"><summary>{self.text(title)}</summary>\n{inside}\n</details>'

    def _table(self, table: blocks.Table) -> str:
        titles = "".join(f'<th scope="col">{self.text(text)}</th>' for text in table.head)
        ids = table.ids or ("",) * len(table.rows)
        lines = "\n".join(self._line(table.head, row, anchor) for row, anchor in zip(table.rows, ids, strict=True))
        name = escape(prose.plain(table.caption or table.head[0]).replace("`", ""))
        caption = f"<caption>{self.text(table.caption)}</caption>\n" if table.caption else ""
        return (
            f'<div class="wide" role="group" aria-label="{name}"><table>\n{caption}'
            f"<thead><tr>{titles}</tr></thead>\n<tbody>\n{lines}\n</tbody>\n</table></div>"
        )

    def _line(self, head: Sequence[str], row: Sequence[str], anchor: str) -> str:
        names = [escape(prose.plain(text).replace("`", "")) for text in head]
        cells = "".join(
            f'<td data-name="{name}">{self._cell(cell)}</td>' for name, cell in zip(names[1:], row[1:], strict=True)
        )
        mark = f' id="{anchor}"' if anchor else ""
        return f'<tr{mark}><th scope="row">{self._cell(row[0])}</th>{cells}</tr>'

    def _cell(self, text: str) -> str:
        first, *remarks = text.split("\n")
        return self.text(first) + "".join(f"<br><small>{self.text(remark)}</small>" for remark in remarks if remark)

    def _picture(self, picture: blocks.Picture) -> str:
        if picture.name not in self._figures:
            return f"<p>The figure {escape(picture.name)} was not drawn.</p>"
        wide, high = self._size(picture)
        name = escape(prose.plain(picture.title or picture.name))
        title = f"<strong>{self.text(picture.title)}.</strong> " if picture.title else ""
        # with a point as a pixel letters can be read: never smaller on a screen
        return (
            f'<figure><div class="wide" role="group" aria-label="{name}"><img src="{self.path(figure_file(picture.name))}" alt="{name}" '
            f'width="{wide}" height="{high}" style="--least: {wide}px" loading="lazy"></div>\n'
            f"<figcaption>{title}{self.text(picture.caption)}</figcaption></figure>"
        )

    def _size(self, picture: blocks.Picture) -> tuple[int, int]:
        """Return width and height of a figure, a point as a pixel; nothing of one that was not drawn."""
        found = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)', self._figures.get(picture.name, ""))
        return (round(float(found[1])), round(float(found[2]))) if found else (0, 0)

    def _breadth(self, picture: blocks.Picture) -> str:
        return ' class="broad"' if self._size(picture)[0] > BROAD else ""

    def _cards(self, cards: Sequence[tuple[str, str, blocks.Picture]]) -> str:
        each = (
            f"<article{self._breadth(one)}><h3>{title}</h3><p>{text}</p>\n{self._picture(one)}</article>\n"
            for title, text, one in cards
        )
        return f'<div class="cards">\n{"".join(each)}</div>'


def figure_file(name: str) -> str:
    """Return the file of a figure in the folder of the report."""
    return f"pages/{name}.svg"


def _breakable(code: str) -> str:
    """Return code that may be broken at its hyphens, where it is one word."""
    return escape(code) if " " in code else escape(code).replace("-", "-<wbr>")
