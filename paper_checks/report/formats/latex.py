"""The report as LaTeX source that compiles by itself, and as the PDF that pdfTeX makes of it: a paper, not the pages in print."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from itertools import chain
from pathlib import Path

from paper_checks.errors import ToolMissingError
from paper_checks.report.content import blocks, citation, paper
from paper_checks.report.content.document import Document
from paper_checks.report.formats.latex_blocks import LatexWriter
from paper_checks.report.mathematics.prose import latex

REMEDY = "a PDF needs pdflatex on the PATH (TeX Live, or any other TeX); --format latex writes its source without it"
SECONDS = 300
"""How long one pass of pdflatex may take; some take ten."""
PASSES = 3
"""The contents take room in the second pass, so that their page numbers are right from the third on."""
PREAMBLE = r"""\documentclass[10pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\IfFileExists{microtype.sty}{\usepackage{microtype}}{}
\usepackage[a4paper,margin=20mm]{geometry}
\usepackage{amsmath,amssymb,array,graphicx,longtable}
\usepackage[hidelinks,pdfcreator={},pdfproducer={}]{hyperref}
\pdfinfoomitdate=1 \pdftrailerid{} \pdfsuppressptexinfo=-1
\setlength{\emergencystretch}{3em}
\setlength{\parindent}{0pt}
\setlength{\parskip}{2pt plus 1pt}
\widowpenalty=500 \clubpenalty=500
\setcounter{tocdepth}{1}
\newcommand{\room}[1]{\par\ifdim\pagetotal<\pagegoal\ifdim\dimexpr\pagetotal+#1\baselineskip>\pagegoal\newpage\fi\fi}
\newcommand{\entry}{\small\par\addvspace{5pt plus 2pt}}
\newcommand{\closer}{\setlength{\abovedisplayskip}{3pt plus 1pt}\setlength{\belowdisplayskip}{3pt plus 1pt}}
\setlength{\LTpre}{4pt} \setlength{\LTpost}{4pt}
\makeatletter
\renewcommand{\section}{\@startsection{section}{1}{0pt}{-2.4ex plus -0.8ex}{0.9ex}{\normalfont\large\bfseries}}
\renewcommand{\subsection}{\@startsection{subsection}{2}{0pt}{-1.8ex plus -0.6ex}{0.6ex}{\normalfont\normalsize\bfseries}}
\renewcommand{\l@section}{\@dottedtocline{1}{0em}{1.8em}}
\renewcommand{\@listi}{\leftmargin\leftmargini \topsep 2pt \parsep 0pt \itemsep 2pt}
\let\@listI\@listi
\g@addto@macro\normalsize{\closer} \g@addto@macro\small{\closer}
\begingroup\catcode`'=\active \g@addto@macro\@noligs{\let'\textquotesingle}\endgroup
\makeatother
"""


def render(report: Document, figures: Mapping[str, str]) -> str:
    """Return the source. `figures` maps a figure's name to the file, beside the source, that holds it."""
    before, *sections = paper.sections(report)
    anchors = chain.from_iterable(map(blocks.anchors, sections))
    writer = LatexWriter(figures, anchors, [one.id for one in sections])
    body = [
        PREAMBLE + _metadata(report),
        r"\begin{document}",
        rf"\begin{{center}}{{\Large {latex(report.title)}\par}}\medskip {_by()}\end{{center}}",
        writer.body(before.blocks),
        r"\tableofcontents",
        *map(writer.section, sections),
        r"\end{document}",
    ]
    return "\n\n".join(body) + "\n"


def _metadata(report: Document) -> str:
    """Return the properties of the file: what a catalogue of documents shows."""
    named = {
        "pdftitle": report.title,
        "pdfauthor": citation.of_package("Author"),
        "pdfsubject": citation.of_package("Summary"),
        "pdfkeywords": citation.of_package("Keywords").replace(",", ", "),
        "pdflang": "en",
    }
    return rf"\hypersetup{{{','.join(f'{name}={{{latex(text)}}}' for name, text in named.items())}}}"


def _by() -> str:
    return latex(f"{citation.of_package('Author')}, version {citation.of_package('Version')}")


def pdf(source: str, figures: Mapping[str, bytes]) -> bytes:
    """Return the PDF of a source with its figures by file, the same bytes every time.

    Raises ToolMissingError without pdflatex, and RuntimeError with the end of the log where TeX refuses the source.
    """
    return typeset(source, figures)[0]


def typeset(source: str, figures: Mapping[str, bytes]) -> tuple[bytes, str]:
    """Return the PDF and TeX's log; raises as `pdf` does."""
    if problem := missing():
        raise ToolMissingError(problem)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, content in {**figures, "report.tex": source.encode()}.items():
            (folder / file).parent.mkdir(exist_ok=True)
            (folder / file).write_bytes(content)
        command = ["pdflatex", "-interaction=batchmode", "-halt-on-error", "-no-shell-escape", "report.tex"]
        environment = {**os.environ, "SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}
        for _ in range(PASSES):
            done = subprocess.run(
                command, cwd=folder, env=environment, capture_output=True, timeout=SECONDS, check=False
            )
            log = (folder / "report.log").read_text(encoding="utf-8", errors="replace")
            if done.returncode:
                raise RuntimeError(f"pdflatex refused the report: {log[-600:]}")
        return (folder / "report.pdf").read_bytes(), log


def missing() -> str | None:
    """Return what to install for a PDF; None where it can be made."""
    return None if shutil.which("pdflatex") else REMEDY
