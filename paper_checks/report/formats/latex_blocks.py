"""Blocks as LaTeX source."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from paper_checks.report.content import blocks
from paper_checks.report.formats.writer import Writer, shares
from paper_checks.report.mathematics import prose

_BREAK = re.compile(r"(?<=[-.])|(?<=\\_)")
"""Where code may be broken at the end of a line."""
_COMMANDS = re.compile(r"\\[A-Za-z]+|[\s{}_^\\]")
ROW = 70
"""Letters, digits and signs of displayed formulas that fit beside each other."""
SHORT = 8
"""Rows from which on a table may be broken between two pages."""


class LatexWriter(Writer):
    """Writes blocks as LaTeX. `figures` maps names to files beside the source, `anchors` are the labels of the document.

    In a text the anchor of one of its `sections` is that section's number. What only a page can show is left out.
    """

    def __init__(self, figures: Mapping[str, str], anchors: Iterable[str], sections: Iterable[str]) -> None:
        """Take the figures, the anchors, and those of them that are numbered sections."""
        super().__init__(figures, anchors)
        self._sections = frozenset(sections)

    def section(self, section: blocks.Section) -> str:
        """Return a section with its heading."""
        return (
            rf"\room{{12}}\section{{{self.text(section.title)}}}\label{{{section.id}}}"
            + "\n\n"
            + self.body(section.blocks)
        )

    def _prose(self, text: str) -> str:
        return prose.latex(text)

    def _code(self, code: str) -> str:
        """Return code in typewriter, that may be broken at its hyphens and dots; two of them must not join to a dash."""
        if code in self._sections:
            return rf"Section~\ref{{{code}}}"
        shown = prose.latex(code).replace("--", "-{-}")
        breakable = shown if " " in code else _BREAK.sub(r"\\allowbreak{}", shown)
        shown = rf"\texttt{{{breakable}}}"
        target = self._target(code)
        return rf"\hyperref[{target}]{{{shown}}}" if target else shown

    def _heading(self, text: str, anchor: str) -> str:
        return rf"\room{{6}}\subsection{{{self.text(text)}}}" + (rf"\label{{{anchor}}}" if anchor else "")

    def _paragraph(self, block: blocks.Paragraph) -> str:
        return (rf"\textbf{{{prose.latex(block.label)}.}} " if block.label else "") + self.text(block.text)

    def _points(self, items: Sequence[str], numbered: bool) -> str:
        name = "enumerate" if numbered else "itemize"
        lines = "\n".join(rf"\item {item}" for item in items)
        return f"\\begin{{{name}}}\n{lines}\n\\end{{{name}}}"

    def _lines(self, text: str) -> str:
        return f"{{\\scriptsize\n\\begin{{verbatim}}\n{text}\n\\end{{verbatim}}}}"

    def _numbered(self, line: blocks.Line) -> str:
        """Return a line with its remark below it, on one page with the formula."""
        mark = label(line.id) if line.id else ""
        remark = self.text(line.remark) if line.passed else rf"\textbf{{{self.text(line.remark)}}}"
        text = rf"\par\addvspace{{4pt}}{mark}\textbf{{D{line.number}.}} {self.text(_side_by_side(line.text))}"
        return f"{{\\postdisplaypenalty=10000 {text}\\par\\nopagebreak\n{{\\footnotesize {remark}\\par}}}}"

    def _markup(self, html: str) -> str:
        del html
        return ""

    def _folded(self, title: str, inside: str, anchor: str) -> str:
        return rf"{{\entry{label(anchor)}\textbf{{{self.text(title)}}} {inside}\par}}"

    def _picture(self, picture: blocks.Picture, wide: str = r"0.7\textwidth") -> str:
        if picture.name not in self._figures:
            return f"The figure {prose.latex(picture.name)} was not drawn."
        title = rf"\textbf{{{self.text(picture.title)}.}} " if picture.title else ""
        return (
            rf"\begin{{center}}\includegraphics[width={wide},height=0.27\textheight,keepaspectratio]{{{self._figures[picture.name]}}}"
            rf"\\* \small {title}{self.text(picture.caption)}\end{{center}}"
        )

    def _cards(self, cards: Sequence[tuple[str, str, blocks.Picture]]) -> str:
        """Return pictures side by side, two in a line, each below what it shows."""
        boxes = [rf"\begin{{minipage}}[t]{{0.485\textwidth}}{self._card(*one)}\end{{minipage}}" for one in cards]
        return "\n\n".join("\\hfill\n".join(boxes[first : first + 2]) for first in range(0, len(boxes), 2))

    def _card(self, title: str, text: str, picture: blocks.Picture) -> str:
        return rf"\small\textbf{{{title}.}} {text}" + "\n\n" + self._picture(picture, r"\linewidth")

    def _table(self, table: blocks.Table) -> str:
        """Return a table as wide as the page, its columns as wide as their texts ask for, within limits."""
        columns = "".join(
            rf">{{\raggedright\arraybackslash}}p{{\dimexpr{share:.3f}\textwidth-2\tabcolsep}}"
            for share in shares(table)
        )
        end = r" \\*" if len(table.rows) < SHORT else r" \\"
        lines = "\n".join(" & ".join(map(self.text, row)) + end for row in table.rows)
        titles = " & ".join(map(self.text, table.head))
        return (
            rf"{{\small\setlength{{\tabcolsep}}{{3pt}}\begin{{longtable}}{{{columns}}}"
            f"\n\\multicolumn{{{len(table.head)}}}{{@{{}}p{{\\textwidth}}@{{}}}}{{\\emph{{{self.text(table.caption)}}}}} \\\\[2pt]\n"
            f"{titles} \\\\ \\hline\\noalign{{\\vskip 2pt}} \\endhead\n{lines}\n\\end{{longtable}}}}"
        )


def _side_by_side(text: str) -> str:
    """Return a text with its displayed formulas in one row, where they fit beside each other."""
    joined = text.replace("$$$$", r",\qquad ")
    return joined if len(_COMMANDS.sub("", joined.partition("$$")[2])) <= ROW else text


def label(anchor: str) -> str:
    """Return a place that links can lead to."""
    return rf"\phantomsection\label{{{anchor}}}"
