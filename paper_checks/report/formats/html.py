"""The report as one self-contained HTML page: a pure function of the document and its figures, opened from disk."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from pathlib import Path

from paper_checks.evidence.claim import Kind
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.evidence.finding import Verdict
from paper_checks.explore import page
from paper_checks.report.content.document import ROWS, ROWS_TITLE, Document
from paper_checks.report.content.phrases import first_sentence, kind, place, section_title, sections
from paper_checks.report.formats import colours
from paper_checks.report.formats.html_blocks import HtmlWriter
from paper_checks.report.mathematics import font
from paper_checks.running.runner import Row


def render(report: Document, figures: Mapping[str, str]) -> str:
    """Return the page. `figures` maps a figure's name to its SVG text; one that is absent is said to be.

    Everything but the SVG is escaped; the SVG is taken as given, its ids and colours made the page's own.
    """
    writer = HtmlWriter(figures, report.anchors)
    parts = [_head(report, figures), _navigation(report), f'<main id="main">\n<h1>{escape(report.title)}</h1>']
    parts.append(f'<div class="model">\n{writer.body(report.model, "model")}\n</div>')
    parts += [writer.section(one) for one in report.before]
    parts += [_rows(report.rows, report, writer)] if report.rows else []
    parts += [writer.section(one) for one in report.after]
    parts += [page.section()] if report.is_whole else []
    scripts = [_beside("scroll.js"), *([_beside("page.js")] if report.rows else [])]
    parts.append(f"</main>\n<script>\n{''.join(scripts)}</script>\n</body>\n</html>\n")
    return "\n".join(parts)


def _beside(name: str) -> str:
    return Path(__file__).with_name(name).read_text(encoding="utf-8")


def _head(report: Document, figures: Mapping[str, str]) -> str:
    body = "<body>" if report.rows else '<body class="short">'
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n'
        f"<title>{escape(report.title)}</title>\n"
        f"<style>\n{font.face()}{colours.rules(figures.values())}{_beside('page.css')}</style>\n</head>\n{body}\n"
        '<a class="skip" href="#main">Skip to the report</a>'
    )


def _navigation(report: Document) -> str:
    targets = [(one.id, one.title) for one in report.before]
    targets += [(ROWS, "Claims")] if report.rows else []
    targets += [(one.id, one.title) for one in report.after]
    targets += [("explore", "Explore")] if report.is_whole else []
    items = "".join(f'<li><a href="#{name}">{escape(title)}</a></li>' for name, title in targets)
    return f'<header><nav aria-label="Sections"><ul>{items}</ul></nav></header>'


def badge(verdict: Verdict) -> str:
    """Return a verdict as a badge."""
    return f'<span class="badge {verdict.value}">{verdict.value}</span>'


def _rows(rows: Sequence[Row], report: Document, writer: HtmlWriter) -> str:
    titles = "".join(f'<th scope="col">{title}</th>' for title in ("The paper says", "Verdict", "In short"))
    parts = [f'<section aria-labelledby="{ROWS}">\n<h2 id="{ROWS}">{ROWS_TITLE}</h2>', _filters(rows)]
    for name in sections(rows):
        chosen = [row for row in rows if row.claim.section == name]
        theorems = all(row.claim.kind is Kind.THEOREM for row in chosen)
        head = titles.replace("The paper says", "The theorem says") if theorems else titles
        bodies = "\n".join(_row(row, report, writer) for row in chosen)
        anchor = f"section-{name.lower().replace(' ', '-')}"
        parts.append(
            f'<table class="claims{" theorems" if theorems else ""}" aria-labelledby="{anchor}">\n<caption><h3 id="{anchor}">{escape(section_title(name))}</h3>'
            f"</caption>\n<thead><tr>{head}</tr></thead>\n{bodies}\n</table>"
        )
    return "\n".join([*parts, "</section>"])


def _filters(rows: Sequence[Row]) -> str:
    """Return the filters, which stay hidden where there is no JavaScript."""
    verdicts = [verdict.value for verdict in Verdict if any(row.finding.verdict is verdict for row in rows)]
    steps = dict.fromkeys(map(_weakest, sorted(rows, key=_strength)))
    return (
        '<form id="filters" hidden>\n'
        + _select("section", "Section", [(name, section_title(name)) for name in sections(rows)])
        + _select("verdict", "Verdict", [(name, name) for name in verdicts])
        + _select("step", "Weakest step", [(name, name) for name in steps])
        + _select("open", "Open part", [("some", "some"), ("none", "none")])
        + '<button type="button" id="open-all">Open all</button>\n'
        + '<output id="shown" for="filter-section filter-verdict filter-step filter-open"></output>\n</form>'
    )


CHIP = '<br><span class="badge open">part open</span>'
"""What a row that leaves a part open is marked with."""


def _openness(row: Row) -> str:
    """Return whether a row leaves a part open, as the filter calls it."""
    return "some" if row.open else "none"


def _weakest(row: Row) -> str:
    """Return the kind of the weakest step that a row needs."""
    return row.established_by.value if row.established_by else "none"


def _strength(row: Row) -> int:
    """Return a place that is lower for a stronger kind of step, and highest where there is none."""
    order = list(EvidenceKind)
    return order.index(row.established_by) if row.established_by else len(order)


def _select(name: str, title: str, options: Iterable[tuple[str, str]]) -> str:
    choices = "".join(f'<option value="{escape(value)}">{escape(text)}</option>' for value, text in options)
    return f'<label>{title} <select id="filter-{name}"><option value="">all</option>{choices}</select></label>\n'


def _row(row: Row, report: Document, writer: HtmlWriter) -> str:
    claim, finding = row.claim, row.finding
    return (
        f'<tbody id="{claim.id}" data-section="{escape(claim.section)}" data-verdict="{finding.verdict.value}" '
        f'data-step="{_weakest(row)}" data-open="{_openness(row)}">\n'
        f'<tr><th scope="row">{writer.text(claim.statement)} <small>{writer.text(place(claim))}</small></th>'
        f"<td>{badge(finding.verdict)}<br><small>{kind(row)}</small>{CHIP if row.open else ''}</td>"
        f"<td>{writer.text(first_sentence(finding.reason))}</td></tr>\n"
        f'<tr><td colspan="3"><details><summary><code>{claim.id}</code>: why, and how it was checked</summary>\n'
        f"{writer.body(report.stories[claim.id], claim.id)}</details></td></tr>\n</tbody>"
    )
