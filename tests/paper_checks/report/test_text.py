"""Terminal and JSON: readable at 80 columns and in a pipe, complete for programs."""

import io
import json
from dataclasses import replace

import pytest
from rich.console import Console

from paper_checks.evidence.finding import Verdict
from paper_checks.report.content.phrases import first_sentence, kind
from paper_checks.report.formats import json as json_report
from paper_checks.report.formats.terminal import print_claims, print_rows


def printed(rows, width=80, **options):
    stream = io.StringIO()
    print_rows(Console(file=stream, width=width, highlight=False), rows, **options)
    return stream.getvalue()


def test_the_table_fits_80_columns_and_keeps_the_ids(rows):
    text = printed(rows)
    assert max(map(len, text.splitlines())) <= 80
    table = [line.split()[0] for line in text.splitlines()[1 : len(rows) + 1]]
    assert table == [row.claim.id for row in rows]
    line = next(line for line in text.splitlines() if line.startswith("example-stiction-never-violated"))
    assert line.split()[:3] == ["example-stiction-never-violated", "refuted", "argument"]


def test_a_pipe_gets_no_control_codes(rows):
    assert "\x1b" not in printed(rows)


def test_each_finding_has_its_sentence_and_differences_are_named(rows):
    text = " ".join(printed(rows).split())
    assert "As printed the bound |ẍ₁|<b m₂⁻¹ fails" in text
    assert "differs from the record: rate-one-over-t is undecided, recorded holds" in text
    (waiting,) = [row.claim.id for row in rows if row.finding.verdict is Verdict.UNCHECKED]
    assert f"unchecked, not what the record says, as a tool is missing: {waiting}" in text
    assert f"record: {waiting}" not in text
    assert "1 holds, 1 holds-corrected, 1 refuted, 1 undecided, 1 unchecked" in text


def test_times_are_shown_on_request_only(rows):
    assert "seconds" not in printed(rows)
    assert "1.2" in printed(rows, times=True)


def test_one_row_tells_its_whole_story(rows):
    text = printed(rows[1:2])
    for title in ("The paper", "Reason", "Corrected", "Counterexample", "- smt (z3 and cvc5), correction, passed"):
        assert title in text


def test_a_step_that_two_parts_share_is_told_once(rows):
    row = rows[1]
    shared = row.finding.evidence[-1]
    both = (*row.finding.evidence, shared.as_counterexample())
    text = " ".join(printed([replace(row, finding=replace(row.finding, evidence=both))]).split())
    assert "- smt (z3 and cvc5), correction and counterexample, passed" in text
    assert text.count("- smt (z3 and cvc5)") == printed([row]).count("- smt (z3 and cvc5)")


def test_the_list(rows):
    stream = io.StringIO()
    print_claims(Console(file=stream, width=100), [row.claim for row in rows], {rows[0].claim.id: rows[0]})
    lines = {line.split()[0]: line for line in stream.getvalue().splitlines() if line.strip()}
    assert all(row.claim.id in lines for row in rows)
    assert f" {kind(rows[0])} " in lines[rows[0].claim.id]
    assert " – " in lines[rows[1].claim.id]
    assert "not decided here yet" in stream.getvalue()


def test_json_has_the_shape_of_the_design(rows):
    data = json.loads(json_report.render(rows))
    assert [item["id"] for item in data] == [row.claim.id for row in rows]
    for item in data:
        assert {"id", "where", "statement", "verdict", "reason", "evidence"} <= set(item)
        for evidence in item["evidence"]:
            assert {"kind", "engine", "statement", "cases", "value"} <= set(evidence)
    assert "seconds" not in data[0]
    assert data[1]["verdict"] == data[1]["recorded"] == "refuted"


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("One.", "One."),
        ("No stop", "No stop."),
        ("See eq. (4). Then.", "See eq. (4)."),
        ("It costs $a. B$ here. Then.", "It costs $a. B$ here."),
    ],
)
def test_first_sentence(text, sentence):
    assert first_sentence(text) == sentence
