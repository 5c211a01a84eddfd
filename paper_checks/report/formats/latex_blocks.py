"""Blocks as LaTeX source."""

from __future__ import annotations

from collections.abc import Sequence

from paper_checks.report.content import blocks
from paper_checks.report.formats.writer import Writer, shares
from paper_checks.report.mathematics import prose

SIZE = r"width=\textwidth,height=0.42\textheight,keepaspectratio"


class LatexWriter(Writer):
    """Writes blocks as LaTeX. `figures` maps names to files beside the source, `anchors` are the labels of the document."""

    def section(self, section: blocks.Section) -> str:
        """Return a section with its heading."""
        return rf"{label(section.id)}\subsection*{{{self.text(section.title)}}}" + "\n\n" + self.body(section.blocks)

    def _prose(self, text: str) -> str:
        return prose.latex(text)

    def _code(self, code: str) -> str:
        """Return code in typewriter, that may be broken at its hyphens; two of them must not join to a dash."""
        shown = prose.latex(code).replace("--", "-{-}")
        shown = rf"\texttt{{{shown if ' ' in code else shown.replace('-', '-' + chr(92) + 'allowbreak{}')}}}"
        target = self._target(code)
        return rf"\hyperref[{target}]{{{shown}}}" if target else shown

    def _heading(self, text: str, anchor: str) -> str:
        return rf"{label(anchor) if anchor else ''}\subsubsection*{{{self.text(text)}}}"

    def _paragraph(self, block: blocks.Paragraph) -> str:
        return (rf"\textbf{{{prose.latex(block.label)}.}} " if block.label else "") + self.text(block.text)

    def _points(self, items: Sequence[str], numbered: bool) -> str:
        name = "enumerate" if numbered else "itemize"
        lines = "\n".join(rf"\item {item}" for item in items)
        return f"\\begin{{{name}}}\n{lines}\n\\end{{{name}}}"

    def _lines(self, text: str) -> str:
        return f"{{\\scriptsize\n\\begin{{verbatim}}\n{text}\n\\end{{verbatim}}}}"

    def _markup(self, html: str) -> str:
        del html
        return ""

    def _folded(self, title: str, inside: str) -> str:
        return rf"\textbf{{{self.text(title)}.}}" + "\n\n" + inside

    def _picture(self, picture: blocks.Picture) -> str:
        if picture.name not in self._figures:
            return f"The figure {prose.latex(picture.name)} was not drawn."
        title = rf"\textbf{{{self.text(picture.title)}.}} " if picture.title else ""
        return (
            rf"\begin{{center}}\includegraphics[{SIZE}]{{{self._figures[picture.name]}}}"
            rf"\\ \small {title}{self.text(picture.caption)}\end{{center}}"
        )

    def _cards(self, cards: Sequence[tuple[str, str, blocks.Picture]]) -> str:
        return "\n\n".join(f"{title}\n\n{text}\n\n{self._picture(picture)}" for title, text, picture in cards)

    def _table(self, table: blocks.Table) -> str:
        """Return a table as wide as the page, its columns as wide as their texts ask for, within limits."""
        columns = "".join(
            rf">{{\raggedright\arraybackslash}}p{{\dimexpr{share:.3f}\textwidth-2\tabcolsep}}"
            for share in shares(table)
        )
        ids = table.ids or ("",) * len(table.rows)
        lines = "\n".join(
            (label(anchor) if anchor else "") + " & ".join(map(self._cell, row)) + r" \\"
            for row, anchor in zip(table.rows, ids, strict=True)
        )
        titles = " & ".join(map(self.text, table.head))
        return (
            rf"{{\small\setlength{{\tabcolsep}}{{3pt}}\begin{{longtable}}{{{columns}}}"
            f"\n\\multicolumn{{{len(table.head)}}}{{@{{}}p{{\\textwidth}}@{{}}}}{{\\emph{{{self.text(table.caption)}}}}} \\\\[2pt]\n"
            f"{titles} \\\\ \\hline\\noalign{{\\vskip 2pt}} \\endhead\n{lines}\n\\end{{longtable}}}}"
        )

    def _cell(self, text: str) -> str:
        first, *remarks = text.split("\n")
        return self.text(first) + "".join(rf"\newline{{\footnotesize {self.text(one)}}}" for one in remarks if one)


def label(anchor: str) -> str:
    """Return a place that links can lead to."""
    return rf"\phantomsection\label{{{anchor}}}"
