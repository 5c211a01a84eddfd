"""Blocks as LaTeX source."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from paper_checks.report.content import blocks, notation
from paper_checks.report.formats.writer import Writer, shares
from paper_checks.report.mathematics import prose

SIZE = r"width=\textwidth,height=0.42\textheight,keepaspectratio"


class LatexWriter(Writer):
    """Writes blocks as LaTeX. `figures` maps names to files beside the source, `anchors` are the labels of the document."""

    def section(self, section: blocks.Section) -> str:
        """Return a section with its heading."""
        heading = rf"\phantomsection\label{{{section.id}}}\subsection*{{{self.text(section.title)}}}"
        return f"{heading}\n\n{self.body(section.blocks)}"

    def body(self, some: Sequence[blocks.Block]) -> str:
        """Return blocks one below the other."""
        return "\n\n".join(filter(None, map(self._block, some)))

    def _prose(self, text: str) -> str:
        return prose.latex(text)

    def _code(self, code: str) -> str:
        """Return code in typewriter, that may be broken at its hyphens; two of them must not join to a dash."""
        shown = prose.latex(code).replace("--", "-{-}")
        shown = rf"\texttt{{{shown if ' ' in code else shown.replace('-', '-' + chr(92) + 'allowbreak{}')}}}"
        target = self._target(code)
        return rf"\hyperref[{target}]{{{shown}}}" if target else shown

    def _block(self, block: blocks.Block) -> str:  # noqa: PLR0911  one return for each kind of block
        match block:
            case blocks.Heading(text, anchor):
                label = rf"\phantomsection\label{{{anchor}}}" if anchor else ""
                return rf"{label}\subsubsection*{{{self.text(text)}}}"
            case blocks.Paragraph(text):
                return self.text(text)
            case blocks.Labelled(label, text):
                return rf"\textbf{{{prose.latex(label)}.}} {self.text(text)}"
            case blocks.Points(items):
                return self._list("itemize", items)
            case blocks.Numbered(items):
                return self._list("enumerate", items)
            case blocks.Command(text):
                return rf"\textbf{{Run it again.}} {self._code(text)}"
            case blocks.Symbols(ids):
                links = (rf"\hyperref[{notation.anchor(one)}]{{${notation.SYMBOLS[one].latex}$}}" for one in ids)
                return rf"\textbf{{Symbols.}} {', '.join(links)}"
            case blocks.Folded(title, inside):
                return rf"\textbf{{{self.text(title)}.}}" + "\n\n" + self.body(inside)
            case blocks.Table():
                return self._table(block)
            case blocks.Picture():
                return self._picture(block)
            case blocks.Result():
                return self._result(block)
            case blocks.Graph():
                return ""

    def _list(self, environment: str, items: Iterable[str]) -> str:
        lines = "\n".join(rf"\item {self.text(item)}" for item in items)
        return f"\\begin{{{environment}}}\n{lines}\n\\end{{{environment}}}"

    def _picture(self, picture: blocks.Picture) -> str:
        if picture.name not in self._figures:
            return f"The figure {prose.latex(picture.name)} was not drawn."
        title = rf"\textbf{{{self.text(picture.title)}.}} " if picture.title else ""
        return (
            rf"\begin{{center}}\includegraphics[{SIZE}]{{{self._figures[picture.name]}}}"
            rf"\\ \small {title}{self.text(picture.caption)}\end{{center}}"
        )

    def _result(self, result: blocks.Result) -> str:
        return "\n\n".join(
            [
                rf"\subsubsection*{{{self.text(result.title)}}}",
                rf"\textbf{{The paper says}} ({self.text(result.where)}): {self.text(result.says)}",
                rf"\textbf{{What is true:}} {self.text(result.truth)}",
                rf"\textbf{{{self.text(result.number)}}} {self.text(result.what)} {self.text(f'(row `{result.row}`)')}",
                self._picture(result.picture),
            ]
        )

    def _table(self, table: blocks.Table) -> str:
        """Return a table as wide as the page, its columns as wide as their texts ask for, within limits."""
        columns = "".join(
            rf">{{\raggedright\arraybackslash}}p{{\dimexpr{share:.3f}\textwidth-2\tabcolsep}}"
            for share in shares(table)
        )
        ids = table.ids or ("",) * len(table.rows)
        lines = "\n".join(self._line(row, anchor) for row, anchor in zip(table.rows, ids, strict=True))
        titles = " & ".join(map(self.text, table.head))
        return (
            rf"{{\small\setlength{{\tabcolsep}}{{3pt}}\begin{{longtable}}{{{columns}}}"
            f"\n\\multicolumn{{{len(table.head)}}}{{@{{}}p{{\\textwidth}}@{{}}}}{{\\emph{{{self.text(table.caption)}}}}} \\\\[2pt]\n"
            f"{titles} \\\\ \\hline\\noalign{{\\vskip 2pt}} \\endhead\n{lines}\n\\end{{longtable}}}}"
        )

    def _line(self, row: Sequence[str], anchor: str) -> str:
        label = rf"\phantomsection\label{{{anchor}}}" if anchor else ""
        return label + " & ".join(map(self._cell, row)) + r" \\"

    def _cell(self, text: str) -> str:
        first, *remarks = text.split("\n")
        return self.text(first) + "".join(rf"\newline{{\footnotesize {self.text(one)}}}" for one in remarks if one)
