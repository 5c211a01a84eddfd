"""Writes the report and its figures, each file whole or not at all."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from paper_checks.drawing.style import Figures
from paper_checks.report.content.document import Document
from paper_checks.report.formats import html, latex, pdf
from paper_checks.report.output.finished import Files, placed
from paper_checks.report.output.pictures import Pictures

FIGURES_OF = {"html": "svg", "latex": "pdf", "pdf": "svg"}
"""In which form a form of the report takes its figures."""


def write(
    folder: Path,
    forms: Sequence[str],
    report: Document,
    figures: Figures,
    complain: Callable[[str], None],
    name: str = "report",
    steps: bool = False,
) -> list[Path]:
    """Write the report in each of the forms `html`, `latex`, `pdf` into the folder; return the main files.

    On paper what the page folds is left out, unless all `steps` are asked for. A figure that cannot be drawn is told to
    `complain`, and the report goes without it. Raises OSError, and ToolMissingError for a PDF without typst.
    """
    pictures = Pictures(report.pictures, figures, complain)
    return [placed(folder, made(form, report, pictures, name, steps)) for form in forms]


def made(form: str, report: Document, pictures: Pictures, name: str = "report", steps: bool = False) -> Files:
    """Return the files of one form. Raises ToolMissingError for a PDF without typst."""
    paper = report if steps else report.on_paper()
    if form == "latex":
        drawn = {f"{one}.pdf": content for one, content in pictures.saved(FIGURES_OF[form]).items()}
        text = latex.render(paper, {one.removesuffix(".pdf"): one for one in drawn})
        return {**drawn, f"{name}.tex": text.encode()}
    texts = {one: content.decode() for one, content in pictures.saved(FIGURES_OF[form]).items()}
    if form == "pdf":
        return {f"{name}.pdf": pdf.render(paper, texts)}
    return {f"{name}.html": html.render(report, texts).encode()}
