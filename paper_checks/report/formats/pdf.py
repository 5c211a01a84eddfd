"""The report as a PDF, set by typst: a wheel, no TeX. The same bytes for the same report."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path

from paper_checks.errors import ToolMissingError
from paper_checks.evidence.claim import Kind
from paper_checks.report.content.document import ROWS, ROWS_TITLE, Document
from paper_checks.report.content.phrases import kind, place
from paper_checks.report.formats.typst_blocks import TypstWriter, escaped
from paper_checks.running.runner import Row

REMEDY = "a PDF needs typst; install it with: pip install 'inertial-pair[pdf]'"
PREAMBLE = """#set document(title: "{title}", date: none)
#set page(paper: "a4", margin: (x: 15mm, y: 14mm), numbering: "1")
#set text(font: "Libertinus Serif", size: {size}, lang: "en")
#set par(justify: true, leading: 0.52em, spacing: 0.75em)
#set table(stroke: none, inset: (x: 2pt, y: 2.5pt))
#set table.hline(stroke: 0.4pt)
#show table: set par(justify: false)
#show table: set text(size: 0.93em)
#show raw: set text(size: 0.92em)
#show heading.where(level: 2): set block(above: 1.4em, below: 0.7em)
#show heading.where(level: 3): set block(above: 1.1em, below: 0.6em)
#let decisive(body) = block(width: 100%, inset: (left: 6pt, y: 2pt), stroke: (left: 1.5pt + gray), body)
#let aside(left, right) = block(breakable: false, grid(columns: (1fr, 1fr), gutter: 12pt, align: top, left, right))
#let picture(file, words, body) = align(center, block(breakable: false)[
  #layout(size => {
    let whole = image(file, alt: words, width: size.width)
    let legible = {scale} * measure(image(file)).height  // letters of 9 pt stay above 5 pt
    let height = calc.min(measure(whole).height, calc.max({height}, legible))
    image(file, alt: words, height: height, fit: "contain")
  })
  #text(size: 0.9em, body)
])
"""


def source(report: Document, figures: Mapping[str, str]) -> str:
    """Return the typst source. `figures` maps a figure's name to its file beside the source."""
    writer = TypstWriter(figures, report.anchors)
    size, height, scale = ("9pt", "52mm", "0.6") if report.rows else ("7.8pt", "40mm", "0")  # in short: two pages
    title = report.title.replace('"', "'")
    preamble = (
        PREAMBLE.replace("{title}", title).replace("{size}", size).replace("{height}", height).replace("{scale}", scale)
    )
    parts = [preamble, f"= {escaped(report.title)}", writer.model(report.model)]
    parts += map(writer.section, report.before)
    parts += (
        [f"== {escaped(ROWS_TITLE)} <{ROWS}>", *(_row(row, report, writer) for row in report.rows)]
        if report.rows
        else []
    )
    parts += map(writer.section, report.after)
    return "\n\n".join(parts) + "\n"


def _row(row: Row, report: Document, writer: TypstWriter) -> str:
    claim = row.claim
    who = "The paper" if claim.kind is Kind.CLAIM else "Theorem"
    heading = f'=== #raw("{claim.id}"): {row.finding.verdict.value} ({escaped(kind(row))}) <{claim.id}>'
    said = f"#strong[{who}] {writer.text(place(claim))}: {writer.text(claim.statement)}"
    return "\n\n".join([heading, said, writer.body(report.stories[claim.id])])


def render(report: Document, figures: Mapping[str, str]) -> bytes:
    """Return the PDF. `figures` maps a figure's name to its SVG text. Raises ToolMissingError without typst."""
    try:
        import typst
    except ModuleNotFoundError as error:
        raise ToolMissingError(REMEDY) from error
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = _placed(folder, figures)
        main = folder / "report.typ"
        main.write_text(source(report, files), encoding="utf-8")
        return bytes(typst.compile(str(main), root=str(folder), ignore_system_fonts=True, timestamp=0))


def _placed(folder: Path, figures: Mapping[str, str]) -> dict[str, str]:
    for name, svg in figures.items():
        (folder / f"{name}.svg").write_text(svg, encoding="utf-8")
    return {name: f"{name}.svg" for name in figures}


def missing() -> str | None:
    """Return what to install for a PDF; None where it can be made."""
    try:
        import typst  # noqa: F401
    except ModuleNotFoundError:
        return REMEDY
    return None
