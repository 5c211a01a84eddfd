"""Writes the report and its figures, each file whole or not at all."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from matplotlib.figure import Figure

from paper_checks import atomic
from paper_checks.report import html, latex, vector
from paper_checks.report.blocks import Section
from paper_checks.runner import Row

Figures = Mapping[str, Callable[[], Figure]]
"""How each figure is drawn, by the name that findings and sections give it."""


def write(
    folder: Path,
    form: str,
    rows: Sequence[Row],
    figures: Figures,
    complain: Callable[[str], None],
    sections: Sequence[Section] = (),
) -> Path:
    """Write the report in `form` (`html` or `latex`) into the folder and return its main file.

    `sections` follow the claims. A figure that cannot be drawn is told to `complain`, and the report goes without it.
    Raises OSError.
    """
    wanted = [row.finding.figure for row in rows if row.finding.figure]
    wanted += [name for section in sections for name in section.pictures]
    drawn = dict(_drawn(wanted, figures, complain))
    if form == "html":
        page = folder / "report.html"
        pictures = {name: vector.svg(figure) for name, figure in drawn.items()}
        atomic.write(page, html.render(rows, pictures, sections))
        return page
    for name, figure in drawn.items():
        atomic.write(folder / f"{name}.pdf", vector.pdf(figure))
    source = folder / "report.tex"
    atomic.write(source, latex.render(rows, {name: f"{name}.pdf" for name in drawn}, sections))
    return source


def _drawn(names: Sequence[str], figures: Figures, complain: Callable[[str], None]) -> Iterator[tuple[str, Figure]]:
    """Yield the figures of these names, each once, in their order."""
    for name in dict.fromkeys(names):
        if name not in figures:
            complain(f"the figure {name} is not known")
            continue
        try:
            yield name, figures[name]()
        except Exception as error:  # noqa: BLE001  one figure's failure must not cost the reader the report
            complain(f"the figure {name} was not drawn: {type(error).__name__}: {error}")
