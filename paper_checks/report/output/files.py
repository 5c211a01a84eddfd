"""The files of a report in each of its forms."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from paper_checks import atomic
from paper_checks.report.content import paper
from paper_checks.report.content.document import Document
from paper_checks.report.formats import html, latex

Files = Mapping[str, bytes]
"""The files of one form by name, the main one last."""
FIGURES_OF = {"html": "svg", "latex": "pdf", "pdf": "pdf"}
"""In which form a form of the report takes its figures."""


def shown_in(form: str, report: Document) -> tuple[str, ...]:
    """Return the names of the figures that a form of the report shows."""
    if form == "html":
        return report.pictures
    return tuple(name for section in paper.sections(report) for name in section.pictures)


def made(form: str, report: Document, figures: Mapping[str, bytes]) -> Files:
    """Return the files of one of the forms `html`, `latex`, `pdf`; `figures` are in the form that it takes, by name.

    Raises ToolMissingError for a PDF without TeX.
    """
    if form == "html":
        pages = html.render(report, {one: content.decode() for one, content in figures.items()})
        return {file: text.encode() for file, text in pages.items()}
    names = {one: f"figures/{one}.pdf" for one in figures}
    drawn = {names[one]: content for one, content in figures.items()}
    text = latex.render(report, names)
    return {"report.pdf": latex.pdf(text, drawn)} if form == "pdf" else {**drawn, "report.tex": text.encode()}


def placed(folder: Path, files: Files) -> Path:
    """Write files into a folder; return the last one, which is the main one. Raises OSError."""
    for name, content in files.items():
        atomic.write(folder / name, content)
    return folder / name
