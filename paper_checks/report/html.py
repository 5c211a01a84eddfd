"""The report as one self-contained HTML page: a pure function of rows and figures, opened from disk."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from pathlib import Path

from paper_checks.evidence import Evidence
from paper_checks.finding import Finding, Verdict
from paper_checks.report import blocks, mathematics, proof
from paper_checks.report.summary import OUTCOMES, PAPER, TITLE, findings_first, kind, section_title, sections
from paper_checks.runner import Row


def render(rows: Sequence[Row], figures: Mapping[str, str], after: Sequence[blocks.Section] = ()) -> str:
    """Return the page, with the sections of `after` behind the claims. `figures` maps a figure's name to its SVG text;
    one that is absent is said to be.

    Everything but the SVG is escaped; the SVG is taken as given, its ids made the row's own.
    """
    parts = [_head(), _opening(rows, after), _findings(rows), _filters(rows), _table(rows, figures)]
    parts += [_section(one, figures) for one in after]
    parts.append(f"</main>\n<script>\n{_beside('page.js')}</script>\n</body>\n</html>\n")
    return "\n".join(parts)


def _beside(name: str) -> str:
    return Path(__file__).with_name(name).read_text(encoding="utf-8")


def _head() -> str:
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n'
        f"<title>{escape(TITLE)}</title>\n<style>\n{_beside('page.css')}</style>\n</head>\n<body>\n<main>"
    )


def _section(section: blocks.Section, figures: Mapping[str, str]) -> str:
    own = {name: _own_ids(figures[name], name) for name in section.pictures if name in figures}
    return blocks.html(section, own)


def _opening(rows: Sequence[Row], after: Sequence[blocks.Section]) -> str:
    counts = Counter(row.finding.verdict for row in rows)
    tallies = "".join(
        f"<li>{_badge(verdict)} <strong>{counts[verdict]}</strong></li>" for verdict in Verdict if counts[verdict]
    )
    links = "".join(f'<p>After the claims: <a href="#{one.id}">{escape(one.title)}</a>.</p>\n' for one in after)
    return (
        f"<header>\n<h1>{escape(TITLE)}</h1>\n<p>{escape(PAPER)}</p>\n{links}"
        f'<ul class="tally" aria-label="Number of claims by verdict">{tallies}</ul>\n</header>'
    )


def _badge(verdict: Verdict) -> str:
    return f'<span class="badge {verdict.value}">{verdict.value}</span>'


def _link(row: Row) -> str:
    return f'<a href="#{row.claim.id}">{_breakable(row.claim.id)}</a>'


def _breakable(claim_id: str) -> str:
    return escape(claim_id).replace("-", "-<wbr>")


def _findings(rows: Sequence[Row]) -> str:
    lists = []
    for verdict, title, chosen in findings_first(rows):
        items = "\n".join(
            f"<li>{_link(row)} <span>{mathematics.html(sentence)}</span></li>" for row, sentence in chosen
        )
        lists.append(f'<h3 class="{verdict.value}">{title}</h3>\n<ul>\n{items}\n</ul>')
    body = "\n".join(lists) or "<p>Every claim holds as written.</p>"
    return f'<section class="findings" aria-labelledby="findings">\n<h2 id="findings">Findings</h2>\n{body}\n</section>'


def _filters(rows: Sequence[Row]) -> str:
    """Return the filters, which stay hidden where there is no JavaScript."""
    verdicts = [verdict.value for verdict in Verdict if any(row.finding.verdict is verdict for row in rows)]
    return (
        '<h2 id="claims">Claims</h2>\n<form id="filters" hidden>\n'
        + _select("section", [(name, section_title(name)) for name in sections(rows)])
        + _select("verdict", [(name, name) for name in verdicts])
        + '<button type="button" id="open-all">Open all</button>\n'
        + '<output id="shown" for="filter-section filter-verdict"></output>\n</form>'
    )


def _select(name: str, options: Iterable[tuple[str, str]]) -> str:
    choices = "".join(f'<option value="{escape(value)}">{escape(text)}</option>' for value, text in options)
    return (
        f'<label>{name.capitalize()} <select id="filter-{name}"><option value="">all</option>{choices}'
        "</select></label>\n"
    )


def _table(rows: Sequence[Row], figures: Mapping[str, str]) -> str:
    titles = "".join(f'<th scope="col">{title}</th>' for title in ("Claim", "Where", "Verdict", "Established by"))
    bodies = "\n".join(_claim(row, figures) for row in rows)
    return f'<table class="claims" aria-labelledby="claims">\n<thead><tr>{titles}</tr></thead>\n{bodies}\n</table>'


def _claim(row: Row, figures: Mapping[str, str]) -> str:
    claim, finding = row.claim, row.finding
    return (
        f'<tbody id="{claim.id}" data-section="{escape(claim.section)}" data-verdict="{finding.verdict.value}">\n'
        f'<tr><th scope="row">{_link(row)}</th><td>{escape(claim.section)}: {mathematics.html(claim.where)}</td>'
        f"<td>{_badge(finding.verdict)}</td><td>{kind(row)}</td></tr>\n"
        f'<tr><td colspan="4"><details><summary>{mathematics.html(claim.statement)}</summary>\n'
        f"{_behind(row, figures)}</details></td></tr>\n</tbody>"
    )


def _behind(row: Row, figures: Mapping[str, str]) -> str:
    finding = row.finding
    texts = {
        "Reason": finding.reason,
        "Counterexample": finding.counterexample,
        "Corrected statement": finding.corrected,
        "Missing for a proof": finding.missing,
    }
    parts = [f"<h4>{title}</h4>\n<p>{mathematics.html(text)}</p>" for title, text in texts.items() if text]
    if not row.as_recorded:
        recorded = row.claim.recorded.value
        parts.insert(0, f'<p class="differs">This differs from the verdict on record, {recorded}.</p>')
    parts += [text] if (text := proof.html(row)) else []
    parts += [_evidence(finding.evidence)] if finding.evidence else []
    parts += [_derivation(finding)] if finding.derivation else []
    parts += [_figure(row, finding.figure, figures)] if finding.figure else []
    parts.append(f"<h4>Run it again</h4>\n<pre><code>python -m paper_checks run {row.claim.id}</code></pre>")
    return "\n".join(parts)


def _evidence(evidence: Iterable[Evidence]) -> str:
    titles = "".join(f'<th scope="col">{title}</th>' for title in ("Kind", "Checked statement", "Result"))
    lines = "\n".join(_evidence_line(item) for item in evidence)
    return (
        '<h4>Evidence</h4>\n<div class="wide" tabindex="0"><table class="evidence">\n'
        f"<thead><tr>{titles}</tr></thead>\n<tbody>\n{lines}\n</tbody>\n</table></div>"
    )


def _evidence_line(item: Evidence) -> str:
    about = "" if item.about.value == "claim" else f"<b>{item.about.value.capitalize()}.</b> "
    given = f"<br><small>Given {mathematics.html(', '.join(item.assumptions))}</small>" if item.assumptions else ""
    cases = f"<br><small>{item.cases} cases</small>" if item.cases != 1 else ""
    value = f"<br><small>{mathematics.html(item.value)}</small>" if item.value else ""
    return (
        f"<tr><td>{item.kind.value}<br><small>{escape(item.engine)}</small></td>"
        f"<td>{about}{mathematics.html(item.statement)}{given}</td><td>{OUTCOMES[item.passed]}{cases}{value}</td></tr>"
    )


def _derivation(finding: Finding) -> str:
    steps = "\n".join(f"<li>{mathematics.html(step)}</li>" for step in finding.derivation)
    return f'<h4>Derivation</h4>\n<ol class="derivation">\n{steps}\n</ol>'


def _figure(row: Row, name: str, figures: Mapping[str, str]) -> str:
    if name not in figures:
        return f"<p>The figure {escape(name)} was not drawn.</p>"
    label = f"Figure: {escape(name.replace('-', ' '))}"
    return (
        f'<figure><div class="wide" tabindex="0">{_own_ids(figures[name], row.claim.id)}</div>'
        f"<figcaption>{label}</figcaption></figure>"
    )


def _own_ids(svg: str, prefix: str) -> str:
    """Return the svg element alone, with `prefix` before each of its ids: a page's ids are unique."""
    element = svg[svg.index("<svg") :].strip()
    element = re.sub(r'\bid="', f'id="{prefix}--', element)
    element = re.sub(r'href="#', f'href="#{prefix}--', element)
    return re.sub(r"url\(#", f"url(#{prefix}--", element)
