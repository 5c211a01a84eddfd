"""Every form but paper tells every row whole, theorems beyond the paper as ours; the terminal is readable in a pipe."""

import io
import json
import re
from dataclasses import replace
from html import unescape

import pytest
from rich.console import Console

from paper_checks.evidence.claim import Claim, Kind
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.report.content import opening, paper
from paper_checks.report.content.document import document
from paper_checks.report.content.phrases import headline
from paper_checks.report.formats import html, latex
from paper_checks.report.formats import json as json_report
from paper_checks.report.formats.terminal import print_claims, print_rows
from paper_checks.running.graph import proofs
from paper_checks.running.runner import Row

PROVED = Evidence(EvidenceKind.EXACT, "sympy", "$1=1$", True, value="y = x**2")


@pytest.fixture
def theorem():
    claim = Claim("sharp", "Theorems", "beyond the paper", "$x=1$ for all $q$.", Verdict.HOLDS, Kind.THEOREM)
    row = Row(claim, Finding(Verdict.HOLDS, "The limit is one. It is.", (PROVED,)))
    return replace(row, proofs=proofs(row.claim, row.finding))


def console(stream, width=80):
    return Console(file=stream, width=width, highlight=False)


def printed(rows, width=80, **options):
    stream = io.StringIO()
    print_rows(console(stream, width), rows, **options)
    return stream.getvalue()


FORMS = {
    "terminal": lambda row: printed([row]),
    "html": lambda row: unescape(html.render(document([row]), {})[html.FRONT]),
    "json": lambda row: json_report.render([row]),
}


def words(text):
    """The longest run of words outside mathematics: every form shows it as it stands."""
    return max(re.findall(r"[A-Za-z ]+", re.sub(r"\$.*?\$", "|", text)), key=len, default="").strip()


@pytest.mark.parametrize("form", FORMS)
def test_every_form_tells_all_of_a_row(rows, theorem, form):
    for row in (*rows, theorem):
        told, found = " ".join(FORMS[form](row).split()), row.finding
        texts = row.claim.id, found.verdict.value, row.claim.statement, row.claim.where, found.reason
        for text in (*texts, found.corrected or "", found.counterexample or "", found.missing or ""):
            assert words(text) in told, text


def test_the_table_fits_80_columns_and_keeps_the_ids(rows):
    text = printed(rows)
    assert max(map(len, text.splitlines())) <= 80
    lines = text.splitlines()
    head = next(number for number, line in enumerate(lines) if line.startswith("claim "))
    table = [line.split() for line in lines[head + 1 : head + 1 + len(rows)]]
    assert [line[0] for line in table] == [row.claim.id for row in rows]
    assert ["example-stiction-never-violated", "refuted", "argument"] in [line[:3] for line in table]
    assert "\x1b" not in text
    assert ("seconds" in text, "1.2" in printed(rows, times=True)) == (False, True)
    row, listed = rows[1], io.StringIO()
    both = (*row.finding.evidence, row.finding.evidence[-1].as_counterexample())
    shared = printed([replace(row, finding=replace(row.finding, evidence=both))])
    assert shared.count("- smt (z3 and cvc5)") == 1  # a step that two parts share
    print_claims(console(listed, 100), [row.claim for row in rows])
    lines = {line.split()[0]: line for line in listed.getvalue().splitlines() if line.strip()}
    assert all(f" {one.claim.recorded.value} " in lines[one.claim.id] for one in rows)


def test_rows_are_counted_and_those_that_differ_from_the_record_are_named(rows):
    text = " ".join(printed(rows).split())
    assert text.startswith(
        "1 claim differs from the record. Fails first: a proof of w→0 turns 1 claim: rate-one-over-t"
    )
    assert "differs from the record: undecided, recorded holds: rate-one-over-t" in text
    assert "unchecked, because a tool is missing: hostile" in text
    counted = "1 holds, 1 holds after a correction, 1 is refuted, 1 is undecided and 1 is unchecked for lack of a tool."
    assert f"Of the paper's 5 claims {counted}" in text


def test_json_has_the_shape_of_the_design(rows, theorem):
    data = json.loads(json_report.render([*rows, theorem]))
    assert [item["id"] for item in data] == [*(row.claim.id for row in rows), "sharp"]
    for item in data:
        assert {"id", "where", "statement", "verdict", "reason", "evidence"} <= set(item)
        assert all({"kind", "engine", "statement", "cases", "value"} <= set(step) for step in item["evidence"])
    assert "seconds" not in data[0]
    assert data[1]["verdict"] == data[1]["recorded"] == "refuted"
    assert [one["kind"] for one in data] == ["claim"] * len(rows) + ["theorem"]
    assert data[-1]["evidence"][0]["value"] == "y = x**2"


# theorems beyond the paper, and what is not judged


def test_statements_that_are_not_judged_are_no_claims(rows, theorem):
    claim = Claim("opinion", "I", "first paragraph", "It matters.", Verdict.NOT_JUDGED)
    left = Row(claim, Finding(Verdict.NOT_JUDGED, "An opinion.", ()))
    assert headline([left]) == "1 statement is not judged."
    judged = headline([*rows, theorem]).partition(". ")
    assert headline([*rows, left, left, theorem]) == f"{judged[0]}; 2 further statements are not judged. {judged[2]}"
    titles = {one.id: one.title for one in paper.sections(document([*rows, left]))}
    assert titles["not-judged"] == "Statements that are not judged"
    assert titles["refuted"] == "Claims that are refuted"


def test_theorems_are_counted_apart_filtered_listed_and_told_as_ours(rows, theorem):
    page = html.render(document([*rows, theorem]), {})[html.FRONT]
    assert ". Of 1 theorem beyond it 1 is proved." in page
    assert {"Section III", "Theorems"} <= {*re.findall(r'data-section="([^"]*)"', page)}
    assert "The limit is one." in page.partition('class="chapter" id="new"')[2]
    assert "Theorem, beyond the paper: x=1 for all q." in printed([theorem])


def test_the_count_says_how_strong_they_are(rows, theorem):
    counted = [int(number) for _, *numbers in opening.strengths([theorem, *rows]) for number in numbers]
    assert sum(counted) == sum(one.established_by is not None for one in (theorem, *rows))


def test_a_part_that_is_open_is_counted_and_told(rows, theorem):
    part = replace(theorem, claim=replace(theorem.claim, open=("Whether $x=2$.",)))
    assert headline([part, theorem]) == "Of 2 theorems beyond the paper 2 are proved. 1 leaves a part open."
    assert "open" not in headline([theorem])
    assert opening.still_open([part]).blocks[1].items == ("Whether $x=2$. (`sharp`)",)
    assert "· part open" in html.render(document([part]), {})[html.FRONT]
    assert "part open: sharp" in printed([part, rows[0]])
    assert json.loads(json_report.render([part]))[0]["open"] == ["Whether $x=2$."]
    assert "Open: Whether x=2." in printed([part])
    assert r"\item Whether $x=2$. (" in latex.render(document([part]), {})
