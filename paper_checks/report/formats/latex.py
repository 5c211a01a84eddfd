"""The report as LaTeX source: an appendix that also compiles by itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from paper_checks.report.content.document import ROWS, ROWS_TITLE, Document
from paper_checks.report.content.phrases import kind, speaker
from paper_checks.report.formats.latex_blocks import LatexWriter
from paper_checks.report.mathematics.prose import latex
from paper_checks.running.runner import Row

PREAMBLE = r"""\documentclass[10pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage[a4paper,margin=25mm]{geometry}
\usepackage{amsmath,amssymb,array,graphicx,longtable}
\usepackage[hidelinks,pdfcreator={},pdfproducer={}]{hyperref}
\pdfinfoomitdate=1 \pdftrailerid{} \pdfsuppressptexinfo=-1
\setlength{\emergencystretch}{3em}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
"""


def render(report: Document, figures: Mapping[str, str]) -> str:
    """Return the source. `figures` maps a figure's name to the file, beside the source, that holds it."""
    writer = LatexWriter(figures, report.anchors)
    parts = [PREAMBLE + r"\begin{document}", rf"\section*{{{latex(report.title)}}}", writer.body(report.model)]
    parts += map(writer.section, report.before)
    parts += _rows(report.rows, report, writer) if report.rows else []
    parts += map(writer.section, report.after)
    return "\n\n".join([*parts, r"\end{document}"]) + "\n"


def _rows(rows: Sequence[Row], report: Document, writer: LatexWriter) -> list[str]:
    heading = rf"\phantomsection\label{{{ROWS}}}\subsection*{{{ROWS_TITLE}}}"
    return [heading, *(_row(row, report, writer) for row in rows)]


def _row(row: Row, report: Document, writer: LatexWriter) -> str:
    claim = row.claim
    heading = (
        rf"\phantomsection\label{{{claim.id}}}\subsubsection*{{{writer.text(f'`{claim.id}`')}: {row.finding.verdict.value} "
        rf"({latex(kind(row))})}}"
    )
    said = rf"\textbf{{{latex(speaker(claim))}.}} {writer.text(claim.statement)}"
    return "\n\n".join([heading, said, writer.body(report.stories[claim.id])])
