"""Blocks as LaTeX source."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from paper_checks.report import blocks, mathematics, notation
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

SIZE = r"width=\textwidth,height=0.42\textheight,keepaspectratio"


class LatexWriter:
    """Writes blocks as LaTeX. `figures` maps names to files beside the source, `anchors` are the labels of the document."""

    def __init__(self, figures: Mapping[str, str], anchors: Iterable[str] = ()) -> None:
        """Take the figures and the labels."""
        self._figures = figures
        self._anchors = frozenset(anchors)

    def section(self, section: Section) -> str:
        """Return a section with its heading."""
        heading = rf"\phantomsection\label{{{section.id}}}\subsection*{{{self.text(section.title)}}}"
        return f"{heading}\n\n{self.blocks(section.blocks)}"

    def blocks(self, some: Sequence[Block]) -> str:
        """Return blocks one below the other."""
        return "\n\n".join(filter(None, map(self._block, some)))

    def text(self, text: str) -> str:
        """Return a text as LaTeX source."""
        return blocks.with_code(blocks.with_links(text, self._anchors), mathematics.latex, self._code)

    def _code(self, code: str) -> str:
        """Return code in typewriter, that may be broken at its hyphens; two of them must not join to a dash."""
        shown = mathematics.latex(code).replace("--", "-{-}")
        shown = rf"\texttt{{{shown if ' ' in code else shown.replace('-', '-' + chr(92) + 'allowbreak{}')}}}"
        target = next((one for one in (code, f"theorem-{code}") if one in self._anchors), None)
        return rf"\hyperref[{target}]{{{shown}}}" if target else shown

    def _block(self, block: Block) -> str:  # noqa: PLR0911  one return for each kind of block
        match block:
            case Heading(text, anchor):
                label = rf"\phantomsection\label{{{anchor}}}" if anchor else ""
                return rf"{label}\subsubsection*{{{self.text(text)}}}"
            case Paragraph(text):
                return self.text(text)
            case Labelled(label, text):
                return rf"\textbf{{{mathematics.latex(label)}.}} {self.text(text)}"
            case Points(items):
                return self._list("itemize", items)
            case Numbered(items):
                return self._list("enumerate", items)
            case Command(text):
                return rf"\textbf{{Run it again.}} {self._code(text)}"
            case Symbols(ids):
                links = (rf"\hyperref[{notation.anchor(one)}]{{${notation.SYMBOLS[one].latex}$}}" for one in ids)
                return rf"\textbf{{Symbols.}} {', '.join(links)}"
            case Folded(title, inside):
                return rf"\textbf{{{self.text(title)}.}}" + "\n\n" + self.blocks(inside)
            case Table():
                return self._table(block)
            case Picture():
                return self._picture(block)
            case Result():
                return self._result(block)
            case Graph():
                return ""

    def _list(self, environment: str, items: Iterable[str]) -> str:
        lines = "\n".join(rf"\item {self.text(item)}" for item in items)
        return f"\\begin{{{environment}}}\n{lines}\n\\end{{{environment}}}"

    def _picture(self, picture: Picture) -> str:
        if picture.name not in self._figures:
            return f"The figure {mathematics.latex(picture.name)} was not drawn."
        title = rf"\textbf{{{self.text(picture.title)}.}} " if picture.title else ""
        return (
            rf"\begin{{center}}\includegraphics[{SIZE}]{{{self._figures[picture.name]}}}"
            rf"\\ \small {title}{self.text(picture.caption)}\end{{center}}"
        )

    def _result(self, result: Result) -> str:
        return "\n\n".join(
            [
                rf"\subsubsection*{{{self.text(result.title)}}}",
                rf"\textbf{{The paper says}} ({self.text(result.where)}): {self.text(result.says)}",
                rf"\textbf{{What is true:}} {self.text(result.truth)}",
                rf"\textbf{{{self.text(result.number)}}} {self.text(result.what)} {self.text(f'(row `{result.row}`)')}",
                self._picture(result.picture),
            ]
        )

    def _table(self, table: Table) -> str:
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


def shares(table: Table) -> list[float]:
    """Return the share of each column of the width (dimensionless, their sum 1): the root of its longest text's length."""
    columns = [
        [len(line) for cell in column for line in cell.split("\n")]
        for column in zip(table.head, *table.rows, strict=True)
    ]
    wishes = [max(*lengths, 6) ** 0.5 for lengths in columns]
    return [wish / sum(wishes) for wish in wishes]
