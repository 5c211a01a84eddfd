"""Writes the report and its figures, each file whole or not at all."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from matplotlib.figure import Figure

from paper_checks import atomic
from paper_checks.drawing.style import Figures
from paper_checks.report import html, latex, pdf, vector
from paper_checks.report.document import Document


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

    On paper what the page folds is left out, unless all `steps` are asked for. A figure that cannot be drawn is told to `complain`, and the report goes without it. Raises OSError, and
    ToolMissingError for a PDF without typst.
    """
    drawn = dict(_drawn(report.pictures, figures, complain))
    pictures = {one: vector.svg(figure) for one, figure in drawn.items()} if {"html", "pdf"} & set(forms) else {}
    paper = report if steps else report.on_paper()
    written = []
    for form in forms:
        if form == "html":
            path = folder / f"{name}.html"
            content: str | bytes = html.render(report, pictures)
        elif form == "pdf":
            path, content = folder / f"{name}.pdf", pdf.render(paper, pictures)
        else:
            path, content = folder / f"{name}.tex", latex.render(paper, {one: f"{one}.pdf" for one in drawn})
            for one, figure in drawn.items():
                atomic.write(folder / f"{one}.pdf", vector.pdf(figure))
        atomic.write(path, content)
        written.append(path)
    return written


def _drawn(names: Sequence[str], figures: Figures, complain: Callable[[str], None]) -> Iterator[tuple[str, Figure]]:
    """Yield the figures of these names, in their order."""
    for name in names:
        if name not in figures:
            complain(f"the figure {name} is not known")
            continue
        try:
            yield name, figures[name]()
        except Exception as error:  # noqa: BLE001  one figure's failure must not cost the reader the report
            complain(f"the figure {name} was not drawn: {type(error).__name__}: {error}")
