"""A section of the report that is no claim: headings, paragraphs, tables and figures, for each kind of reader.

Texts are prose with LaTeX between dollars, as everywhere in the report, and commands between backticks.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape

from paper_checks.report import mathematics

_CODE = re.compile(r"`([^`]+)`")


@dataclass(frozen=True)
class Heading:
    """A heading within the section."""

    text: str


@dataclass(frozen=True)
class Paragraph:
    """A paragraph."""

    text: str


@dataclass(frozen=True)
class Points:
    """A list of sentences."""

    items: tuple[str, ...]


@dataclass(frozen=True)
class Table:
    """A table; the first column names its rows."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    caption: str


@dataclass(frozen=True)
class Picture:
    """A figure, by its name."""

    name: str
    caption: str


Block = Heading | Paragraph | Points | Table | Picture


@dataclass(frozen=True)
class Section:
    """A section after the claims: its anchor, its title, its blocks."""

    id: str
    title: str
    blocks: tuple[Block, ...]

    @property
    def pictures(self) -> list[str]:
        """Return the names of its figures."""
        return [block.name for block in self.blocks if isinstance(block, Picture)]


def html(section: Section, figures: Mapping[str, str]) -> str:
    """Return the section as HTML; `figures` maps names to SVG elements whose ids are the page's own."""
    body = "\n".join(_html(block, figures) for block in section.blocks)
    return (
        f'<section class="apart" aria-labelledby="{section.id}">\n'
        f'<h2 id="{section.id}">{escape(section.title)}</h2>\n{body}\n</section>'
    )


def _html(block: Block, figures: Mapping[str, str]) -> str:
    match block:
        case Heading(text):
            return f"<h3>{html_text(text)}</h3>"
        case Paragraph(text):
            return f"<p>{html_text(text)}</p>"
        case Points(items):
            return "<ul>\n" + "\n".join(f"<li>{html_text(item)}</li>" for item in items) + "\n</ul>"
        case Table(head, rows, caption):
            titles = "".join(f'<th scope="col">{html_text(text)}</th>' for text in head)
            lines = "\n".join(
                f'<tr><th scope="row">{html_text(row[0])}</th>'
                + "".join(f"<td>{html_text(cell)}</td>" for cell in row[1:])
                + "</tr>"
                for row in rows
            )
            return (
                f'<div class="wide" tabindex="0"><table class="measured">\n<caption>{html_text(caption)}</caption>\n'
                f"<thead><tr>{titles}</tr></thead>\n<tbody>\n{lines}\n</tbody>\n</table></div>"
            )
        case Picture(name, caption):
            if name not in figures:
                return f"<p>The figure {escape(name)} was not drawn.</p>"
            return (
                f'<figure><div class="wide" tabindex="0">{figures[name]}</div>'
                f"<figcaption>{html_text(caption)}</figcaption></figure>"
            )


def html_text(text: str) -> str:
    """Return a text as HTML phrasing content."""
    return _with_code(text, mathematics.html, lambda code: f"<code>{escape(code)}</code>")


def latex(section: Section, figures: Mapping[str, str]) -> str:
    """Return the section as LaTeX; `figures` maps names to files beside the source."""
    heading = rf"\clearpage\phantomsection\label{{{section.id}}}\subsection*{{{latex_text(section.title)}}}"
    return "\n\n".join([heading, *(_latex(block, figures) for block in section.blocks)])


def _latex(block: Block, figures: Mapping[str, str]) -> str:
    match block:
        case Heading(text):
            return rf"\subsubsection*{{{latex_text(text)}}}"
        case Paragraph(text):
            return latex_text(text)
        case Points(items):
            lines = "\n".join(rf"\item {latex_text(item)}" for item in items)
            return f"\\begin{{itemize}}\n{lines}\n\\end{{itemize}}"
        case Table(head, rows, caption):
            return _latex_table(head, rows, caption)
        case Picture(name, caption):
            if name not in figures:
                return f"The figure {latex_text(name)} was not drawn."
            size = r"width=\textwidth,height=0.85\textheight,keepaspectratio"
            return (
                rf"\begin{{center}}\includegraphics[{size}]{{{figures[name]}}}"
                rf"\\ \small {latex_text(caption)}\end{{center}}"
            )


def _latex_table(head: Sequence[str], rows: Sequence[Sequence[str]], caption: str) -> str:
    """Return a table as wide as the page; the first column takes what its longest cell needs, up to a third."""
    first = min(0.34, 0.013 * max(len(text) for text in (head[0], *(row[0] for row in rows))) + 0.05)
    others = (1 - first) / (len(head) - 1)
    columns = rf">{{\raggedright\arraybackslash}}p{{\dimexpr{first:.3f}\textwidth-\tabcolsep}}" + (
        rf">{{\raggedright\arraybackslash}}p{{\dimexpr{others:.3f}\textwidth-2\tabcolsep}}" * (len(head) - 1)
    )
    lines = "\n".join(" & ".join(map(latex_text, row)) + r" \\" for row in rows)
    titles = " & ".join(map(latex_text, head))
    return (
        rf"{{\small\setlength{{\tabcolsep}}{{3pt}}\begin{{longtable}}{{@{{}}{columns}@{{}}}}"
        f"\n\\multicolumn{{{len(head)}}}{{@{{}}p{{\\textwidth}}@{{}}}}{{\\emph{{{latex_text(caption)}}}}} \\\\[2pt]\n"
        f"{titles} \\\\ \\hline\\noalign{{\\vskip 2pt}} \\endhead\n{lines}\n\\end{{longtable}}}}"
    )


def latex_text(text: str) -> str:
    """Return a text as LaTeX source."""
    return _with_code(text, mathematics.latex, _latex_code)


def _latex_code(code: str) -> str:
    """Return code in typewriter; two hyphens must not join to a dash."""
    return rf"\texttt{{{mathematics.latex(code).replace('--', '-{}-')}}}"


def markdown(section: Section) -> str:
    """Return the section as Markdown for a notebook, without its figures."""
    return "\n\n".join([f"## {section.title}", *filter(None, map(_markdown, section.blocks))])


def _markdown(block: Block) -> str:
    match block:
        case Heading(text):
            return f"### {text}"
        case Paragraph(text):
            return text
        case Points(items):
            return "\n".join(f"- {item}" for item in items)
        case Table(head, rows, caption):
            lines = [head, ("---",) * len(head), *rows]
            table = "\n".join("| " + " | ".join(cell.replace("|", r"\|") for cell in line) + " |" for line in lines)
            return f"*{caption}*\n\n{table}"
        case Picture():
            return ""


def _with_code(text: str, write: Callable[[str], str], code: Callable[[str], str]) -> str:
    """Write a text whose code stands between backticks: every second piece."""
    pieces = _CODE.split(text)
    return "".join(code(piece) if index % 2 else write(piece) for index, piece in enumerate(pieces))
