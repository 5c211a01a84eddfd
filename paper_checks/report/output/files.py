"""Writes the report and its figures, each file whole or not at all."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from paper_checks.drawing.style import Figures
from paper_checks.report.content.document import Document
from paper_checks.report.formats import html, latex
from paper_checks.report.output.finished import Files, placed
from paper_checks.report.output.pictures import Pictures

FIGURES_OF = {"html": "svg", "latex": "pdf", "pdf": "pdf"}
"""In which form a form of the report takes its figures."""


def write(
    folder: Path,
    forms: Sequence[str],
    report: Document,
    figures: Figures,
    complain: Callable[[str], None],
    steps: bool = False,
) -> list[Path]:
    """Write the report in each of the forms `html`, `latex`, `pdf` into the folder; return the main files.

    On paper what the page folds is left out, unless all `steps` are asked for. A figure that cannot be drawn is told to
    `complain`, and the report goes without it. Raises OSError, and ToolMissingError for a PDF without TeX.
    """
    pictures = Pictures(report.pictures, figures, complain)
    return [placed(folder, made(form, report, pictures, steps)) for form in forms]


def made(form: str, report: Document, pictures: Pictures, steps: bool = False) -> Files:
    """Return the files of one form. Raises ToolMissingError for a PDF without TeX."""
    saved = pictures.saved(FIGURES_OF[form])
    if form == "html":
        pages = html.render(report, {one: content.decode() for one, content in saved.items()})
        return {file: text.encode() for file, text in pages.items()}
    drawn = {f"{one}.pdf": content for one, content in saved.items()}
    text = latex.render(report if steps else report.on_paper(), {one: f"{one}.pdf" for one in saved})
    return {"report.pdf": latex.pdf(text, drawn)} if form == "pdf" else {**drawn, "report.tex": text.encode()}
