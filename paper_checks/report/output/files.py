"""Writes the report and its figures, each file whole or not at all."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from matplotlib.figure import Figure

from paper_checks.drawing.style import Figures
from paper_checks.report.content.document import Document
from paper_checks.report.formats import html, latex, pdf, vector
from paper_checks.report.output.finished import Files, Finished, placed

_SAVED: Mapping[str, Callable[[Figure], bytes]] = {"svg": lambda one: vector.svg(one).encode(), "pdf": vector.pdf}


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


class Pictures:
    """The figures of a report, each drawn when it is asked for, or taken from those kept."""

    def __init__(
        self,
        names: Sequence[str],
        figures: Figures,
        complain: Callable[[str], None],
        kept: Finished | None = None,
        fresh: bool = False,
    ) -> None:
        """Take the names of those that are shown, and how all are drawn; `fresh`: none is taken from those kept."""
        self._names, self._figures, self._complain = names, figures, complain
        self._kept, self._fresh = kept, fresh
        self._saved: dict[str, dict[str, bytes]] = {}
        self._complaints: set[str] = set()

    def saved(self, form: str) -> dict[str, bytes]:
        """Return all figures as `svg` or `pdf`, without those that cannot be drawn."""
        if form not in self._saved:
            found = {name: self._one(name, form) for name in self._names}
            self._saved[form] = {name: content for name, content in found.items() if content is not None}
        return self._saved[form]

    def _one(self, name: str, form: str) -> bytes | None:
        """Return one figure; it is drawn anew for each form, as saving it leaves a trace in its layout."""
        content = self._kept.figure(f"{name}.{form}") if self._kept and not self._fresh else None
        if content is None and (figure := self._drawn(name)) is not None:
            content = _SAVED[form](figure)
            if self._kept:
                self._kept.keep_figure(f"{name}.{form}", content)
        return content

    def _drawn(self, name: str) -> Figure | None:
        if name not in self._figures:
            why = f"the figure {name} is not known"
        else:
            try:
                return self._figures[name]()
            except Exception as error:  # noqa: BLE001  one figure's failure must not cost the reader the report
                why = f"the figure {name} was not drawn: {type(error).__name__}: {error}"
        if why not in self._complaints:
            self._complaints.add(why)
            self._complain(why)
        return None


def made(form: str, report: Document, pictures: Pictures, name: str = "report", steps: bool = False) -> Files:
    """Return the files of one form. Raises ToolMissingError for a PDF without typst."""
    paper = report if steps else report.on_paper()
    if form == "latex":
        drawn = {f"{one}.pdf": content for one, content in pictures.saved("pdf").items()}
        text = latex.render(paper, {one.removesuffix(".pdf"): one for one in drawn})
        return {**drawn, f"{name}.tex": text.encode()}
    texts = {one: content.decode() for one, content in pictures.saved("svg").items()}
    if form == "pdf":
        return {f"{name}.pdf": pdf.render(paper, texts)}
    return {f"{name}.html": html.render(report, texts).encode()}
