"""The report as LaTeX source, an appendix that also compiles by itself; and as the PDF that pdfTeX makes of it."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path

from paper_checks.errors import ToolMissingError
from paper_checks.report.content.document import ROWS, ROWS_TITLE, Document
from paper_checks.report.content.phrases import kind
from paper_checks.report.formats.latex_blocks import LatexWriter, label
from paper_checks.report.mathematics.prose import latex

REMEDY = "a PDF needs pdflatex on the PATH (TeX Live, or any other TeX); --format latex writes its source without it"
SECONDS = 300
"""How long one pass of pdflatex may take; some take ten."""
PREAMBLE = r"""\documentclass[10pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage[a4paper,margin=22mm]{geometry}
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
    parts = [PREAMBLE + r"\begin{document}", rf"\section*{{{latex(report.title)}}}", *map(writer.section, report.front)]
    parts += _rows(report, writer)
    parts += map(writer.section, report.chapters)
    return "\n\n".join([*parts, r"\end{document}"]) + "\n"


def _rows(report: Document, writer: LatexWriter) -> Iterator[str]:
    yield rf"{label(ROWS)}\subsection*{{{ROWS_TITLE}}}"
    for row in report.rows:
        verdict = f"{row.finding.verdict.value} ({latex(kind(row))})"
        yield rf"{label(row.claim.id)}\subsubsection*{{{writer.text(f'`{row.claim.id}`')}: {verdict}}}"
        yield writer.body(report.stories[row.claim.id])


def pdf(source: str, figures: Mapping[str, bytes]) -> bytes:
    """Return the PDF of a source with its figures by file, the same bytes every time. Raises ToolMissingError, and RuntimeError
    with the end of the log where TeX refuses it."""
    if problem := missing():
        raise ToolMissingError(problem)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, content in {**figures, "report.tex": source.encode()}.items():
            (folder / file).write_bytes(content)
        command = ["pdflatex", "-interaction=batchmode", "-halt-on-error", "-no-shell-escape", "report.tex"]
        environment = {**os.environ, "SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}
        for _ in range(2):  # links and the columns of tables are right from the second pass on
            done = subprocess.run(
                command, cwd=folder, env=environment, capture_output=True, timeout=SECONDS, check=False
            )
            if done.returncode:
                log = (folder / "report.log").read_text(encoding="utf-8", errors="replace")
                raise RuntimeError(f"pdflatex refused the report: {log[-600:]}")
        return (folder / "report.pdf").read_bytes()


def missing() -> str | None:
    """Return what to install for a PDF; None where it can be made."""
    return None if shutil.which("pdflatex") else REMEDY
