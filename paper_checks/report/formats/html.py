"""The report as a folder of HTML: a first page, a page for each row and each chapter, opened from disk without a network.

A row's page is shown in place, too: the first page loads it when a reader opens the row.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path
from string import Template

from paper_checks.explore import page
from paper_checks.report.content import blocks
from paper_checks.report.content.document import ROWS, ROWS_TITLE, Document
from paper_checks.report.content.phrases import in_short, kind, section_title
from paper_checks.report.formats import colours
from paper_checks.report.formats.html_blocks import FRONT, HtmlWriter, figure_file
from paper_checks.report.mathematics import font
from paper_checks.report.mathematics.prose import plain
from paper_checks.running.runner import Row

STYLE, SCRIPT, EXPLORE = "pages/report.css", "pages/report.js", "explore.html"


def render(report: Document, figures: Mapping[str, str]) -> dict[str, str]:
    """Return every file of the report by its name, the first page last. `figures` maps a figure's name to its SVG text.

    Everything but the SVG is escaped; a figure that is absent is said to be.
    """
    homes = dict.fromkeys((*(one.id for one in report.front), ROWS), FRONT)
    homes |= {row.claim.id: f"pages/{row.claim.id}.html" for row in report.rows}
    homes |= {anchor: f"pages/{one.id}.html" for one in report.chapters for anchor in blocks.anchors(one)}
    found = {
        STYLE: font.face() + _beside("page.css"),
        SCRIPT: _beside("page.js"),
        EXPLORE: page.page(row.claim.id for row in report.rows),
    }
    found |= {figure_file(name): colours.themed(figures[name]) for name in report.pictures if name in figures}
    for row in report.rows:
        writer = HtmlWriter(figures, homes, homes[row.claim.id])
        body = f'<article class="row {row.finding.verdict.value}">\n{_verdict(row)}\n{writer.body(report.stories[row.claim.id])}\n</article>'
        found[homes[row.claim.id]] = _page(writer, report, row.claim.id, body)
    for chapter in report.chapters:
        writer = HtmlWriter(figures, homes, homes[chapter.id])
        found[homes[chapter.id]] = _page(writer, report, chapter.title, writer.body(chapter.blocks), chapter.id)
    writer = HtmlWriter(figures, homes, FRONT)
    parts = [*map(writer.section, report.front), _rows(report.rows, writer)]
    return {**found, FRONT: _page(writer, report, report.title, "\n".join(parts))}


def _page(writer: HtmlWriter, report: Document, heading: str, body: str, anchor: str = "") -> str:
    title = heading if heading == report.title else f"{heading} – {report.title}"
    return Template(_beside("page.html")).substitute(
        title=escape(title),
        heading=f'<span id="{anchor}">{escape(heading)}</span>' if anchor else escape(heading),
        style=writer.path(STYLE),
        script=writer.path(SCRIPT),
        navigation=_navigation(writer, report),
        body=body,
    )


def _navigation(writer: HtmlWriter, report: Document) -> str:
    targets = [(writer.link(one.id), one.title) for one in report.front[1:]]
    targets += [(writer.path(EXPLORE), "Explore"), (writer.link(ROWS), "All claims")]
    targets += [(writer.link(one.id), one.title) for one in report.chapters]
    return "".join(f'<li><a href="{target}">{escape(title)}</a></li>' for target, title in targets)


def _beside(name: str) -> str:
    return Path(__file__).with_name(name).read_text(encoding="utf-8")


def _verdict(row: Row) -> str:
    """Return the verdict, the weakest step that it needs, and whether a part is open."""
    chip = ' <span class="badge open">part open</span>' if row.open else ""
    return f'<p><span class="badge {row.finding.verdict.value}">{row.finding.verdict.value}</span> <small>weakest step: {kind(row)}</small>{chip}</p>'


def _rows(rows: Sequence[Row], writer: HtmlWriter) -> str:
    head = ("claim", "verdict, weakest step", "where", "in short")
    titles = "".join(f'<th scope="col">{title}</th>' for title in head)
    lines = "\n".join(_row(row, writer) for row in rows)
    return (
        f'<section aria-labelledby="{ROWS}">\n<h2 id="{ROWS}">{ROWS_TITLE}</h2>\n<form id="filters" hidden></form>\n'
        f'<table class="claims" aria-labelledby="{ROWS}">\n<thead><tr>{titles}</tr></thead>\n<tbody>\n{lines}\n</tbody>\n</table>\n</section>'
    )


def _row(row: Row, writer: HtmlWriter) -> str:
    claim, verdict = row.claim, row.finding.verdict.value
    kernel = "kernel" if row.kernel else ""
    words = plain(f"{claim.id.replace('-', ' ')} {claim.where} {kernel} {claim.statement} {row.finding.reason}").lower()
    chip = (
        f'<span class="badge {verdict}">{verdict}</span> <small>{kind(row)}{" · part open" if row.open else ""}</small>'
    )
    return (
        f'<tr data-row="{claim.id}" data-section="{escape(section_title(claim.section))}" data-verdict="{verdict}" data-step="{_weakest(row)}" '
        f'data-open="{"some" if row.open else "none"}" data-words="{escape(words)}">'
        f'<th scope="row">{writer.text(f"`{claim.id}`")}</th><td>{chip}</td><td><small>{writer.text(claim.where)}</small></td>'
        f'<td class="short">{writer.text(in_short(row))}</td></tr>'
    )


def _weakest(row: Row) -> str:
    """Return the kind of the weakest step that a row needs."""
    return row.established_by.value if row.established_by else "none"
