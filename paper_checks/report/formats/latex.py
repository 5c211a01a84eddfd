"""The report as LaTeX source that compiles by itself, and as the PDF that pdfTeX makes of it: a paper, not the pages in print."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from paper_checks.drawing.captions import caption
from paper_checks.errors import ToolMissingError
from paper_checks.report.content import citation
from paper_checks.report.content.document import TITLE, Document
from paper_checks.report.formats.texts import target, templates
from paper_checks.report.mathematics.prose import latex, plain

REMEDY = "a PDF needs pdflatex on the PATH (TeX Live, or any other TeX); --format latex writes its source without it"
SECONDS = 300
"""How long one pass of pdflatex may take; some take ten."""
PASSES = 3
"""The contents take room in the second pass, so that their page numbers are right from the third on."""
_BREAK = re.compile(r"(?<=[-.])|(?<=\\_)")
"""Where code may be broken at the end of a line."""
_COMMANDS = re.compile(r"\\[A-Za-z]+|[\s{}_^\\]")
_WORDS = re.compile(r"[^\s-]+-?|$")
ROW, WIDE = 70, 90
"""Letters of displayed formulas that fit beside each other; letters of a table in one line of paper."""


def render(report: Document, figures: Mapping[str, str]) -> str:
    """Return the source. `figures` maps a figure's name to the file, beside the source, that holds it."""
    numbered = {one.id for one in report.chapters}

    def code(word: str) -> str:
        """Return code that may be broken at its hyphens and dots; the anchor of a section is that section's number."""
        if word in numbered:
            return rf"Section~\ref{{{word}}}"
        shown = latex(word).replace("--", "-{-}")  # two hyphens must not join to a dash
        breakable = shown if " " in word else _BREAK.sub(r"\\allowbreak{}", shown)
        place = target(word, report.anchors)
        return rf"\hyperref[{place}]{{\texttt{{{breakable}}}}}" if place else rf"\texttt{{{breakable}}}"

    paper = templates(
        lambda text: latex(text.replace("<br>", " ")),
        code,
        block_start_string="<%",
        block_end_string="%>",
        variable_start_string="<<",
        variable_end_string=">>",
        comment_start_string="<#",
        comment_end_string="#>",
    )
    paper.filters |= {"latex": latex, "shares": shares, "side_by_side": _side_by_side}
    paper.globals |= {"files": figures, "caption": caption, "of_package": citation.of_package}
    return paper.get_template("report.tex").render(report=report, title=TITLE)


def shares(rows: Sequence[Sequence[str]]) -> list[float]:
    """Return the share of each column of the width (dimensionless, their sum 1).

    Each has room for its longest word; what is left goes by the length of its longest text.
    """
    columns = [[plain(line) for cell in column for line in cell.split("<br>")] for column in zip(*rows, strict=True)]
    least = [max(len(word) for line in column for word in _WORDS.findall(line)) / WIDE for column in columns]
    wishes = [max(map(len, column)) for column in columns]
    if (left := 1 - sum(least)) <= 0:
        return [one / sum(least) for one in least]
    return [one + left * wish / sum(wishes) for one, wish in zip(least, wishes, strict=True)]


def _side_by_side(text: str) -> str:
    """Return a text with its displayed formulas in one row, where they fit beside each other."""
    joined = text.replace("$$$$", r",\qquad ")
    return joined if len(_COMMANDS.sub("", joined.partition("$$")[2])) <= ROW else text


def typeset(source: str, figures: Mapping[str, bytes]) -> tuple[bytes, str]:
    """Return the PDF of a source with its figures by file, the same bytes every time, and TeX's log.

    Raises ToolMissingError without pdflatex, and RuntimeError with the end of the log where TeX refuses the source.
    """
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
