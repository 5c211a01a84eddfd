"""Theorems past the paper are shown as ours, and as news, in every form of the report."""

import io
import json
import re
from dataclasses import replace

import pytest
from rich.console import Console

from paper_checks.evidence.claim import Claim, Kind
from paper_checks.evidence.clause import Clause, Formula
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.report.content import opening
from paper_checks.report.content.blocks import Paragraph
from paper_checks.report.content.document import document
from paper_checks.report.content.story import displayed, story
from paper_checks.report.formats import html, latex
from paper_checks.report.formats import json as json_report
from paper_checks.report.formats.terminal import print_rows
from paper_checks.running.graph import proofs
from paper_checks.running.runner import Row

PROVED = Evidence(EvidenceKind.EXACT, "sympy", "$1=1$", True, value="y = x**2")


@pytest.fixture
def theorem():
    claim = Claim("sharp", "Theorems", "past the paper", "$x=1$ for all $q$.", Verdict.HOLDS, Kind.THEOREM)
    return Row(claim, Finding(Verdict.HOLDS, "The limit is one. It is.", (PROVED,)))


def printed(rows, width=80):
    stream = io.StringIO()
    print_rows(Console(file=stream, width=width, highlight=False), rows)
    return stream.getvalue()


def test_the_pages_count_them_apart_filter_them_and_list_them(rows, theorem):
    files = html.render(document([*rows, theorem]), {})
    text = files[html.FRONT]
    assert "Past the paper 1 theorem is proved here." in text
    assert 'data-section="Theorems"' in text
    assert 'data-section="Section III"' in text
    assert "The limit is one." in files["pages/new.html"]
    page = files["pages/sharp.html"]
    assert page.index("<strong>Hypotheses.</strong>") < page.index("<strong>Theorem.</strong>")


def test_a_long_formula_of_a_theorem_has_its_own_line():
    long, short = "x+" * 40 + "y", "x"
    shown = displayed(Clause("one", "Then «far», and «near».", {"far": formula(long), "near": formula(short)}))
    assert shown == f"Then $${long}=1,$$ and $x=1$."


def test_a_correction_has_a_paragraph_for_each_clause_that_ends_a_sentence(theorem):
    parts = Clause("a", "One, «far»;", {"far": formula("x+" * 40)}), Clause("b", "two."), Clause("c", "Three.")
    claim = Claim("wrong", "III", "(1)", "All.", Verdict.HOLDS_CORRECTED, correction=parts)
    steps = theorem.finding.evidence[0].as_counterexample(), theorem.finding.evidence[0].as_correction()
    found = Finding(Verdict.HOLDS_CORRECTED, "No.", steps, claim.corrected, "None.")
    told = [(one.label, one.text) for one in story(Row(claim, found), {}) if isinstance(one, Paragraph)]
    assert told[-2:] == [("What is true", f"One, $${'x+' * 40}=1;$$ two."), ("", "Three.")]
    found = replace(found, corrected="Some.")
    told = [(one.label, one.text) for one in story(Row(claim, found), {}) if isinstance(one, Paragraph)]
    assert told[-1] == ("What is true", "Some.")


def formula(left):
    return Formula(left, "=", 1, lambda _: PROVED)


def test_the_count_says_how_strong_they_are_and_that_a_part_is_open(rows, theorem):
    row = replace(theorem, proofs=proofs(theorem.claim, theorem.finding))
    assert {name: numbers for name, *numbers in opening.strengths([row])}[
        "an argument that a person wrote, over such steps"
    ] == ["0", "1"]
    decided = [row, *rows]
    counted = sum(int(number) for _, *numbers in opening.strengths(decided) for number in numbers)
    assert counted == sum(one.established_by is not None for one in decided)
    part = replace(row, claim=replace(row.claim, open=("The other half.",)))
    assert "proved here. 1 row leaves a part open" in opening.counts([part, row])
    assert "2 rows leave a part open" in opening.counts([part, part, row])
    assert "open" not in opening.counts([row])
    assert opening.still_open([part]).blocks[1].items == ("The other half. (`sharp`)",)
    assert opening.still_open([row]).blocks == ()


def test_every_kind_that_settles_a_row_is_counted_once():
    counted = [one for kinds in opening.STRENGTHS.values() for one in kinds]
    assert counted == [one for one in EvidenceKind if one.decisive]


def test_one_that_does_not_hold_is_not_counted_as_proved(theorem):
    undecided = Row(theorem.claim, Finding(Verdict.UNDECIDED, "Not yet.", missing="a proof"))
    text = html.render(document([undecided]), {})[html.FRONT]
    assert "proved here" not in text
    assert "1 more is not settled." in text


def test_the_source_of_the_appendix_says_whose_they_are(rows, theorem):
    text = latex.render(document([*rows, theorem]), {})
    assert r"\textbf{Theorem.} $x=1$ for all $q$." in text
    assert r"\textbf{The paper says (eq. (4)).}" in text


def test_the_terminal_tells_them_too(rows, theorem):
    assert "The limit is one." in printed([*rows, theorem])
    assert "Theorem, past the paper: x=1 for all q." in printed([theorem])


def test_the_terminal_says_what_is_true_and_leaves_out_places_where_dots_would_stand(theorem):
    read = replace(theorem, finding=replace(theorem.finding, reason="Read as: for ever. It is. So."))
    assert "\n  It is." in printed([read, theorem])
    assert ("where" in printed([read, theorem]), "where" in printed([read, theorem], 39)) == (True, False)


def test_the_terminal_says_why_the_kernel_was_not_run_and_what_to_do(theorem):
    reason = "kernel not run: it is not here (Debian: coq)"
    wanted = Evidence(EvidenceKind.KERNEL, "Coq", "the theorem one", None, value=f"kernel not run: one: {reason}")
    (proof,) = proofs(theorem.claim, theorem.finding)
    asked = replace(theorem, proofs=(replace(proof, kernel=(wanted,)),))
    assert printed([asked, theorem]).count(reason) == printed([asked]).splitlines().count(reason) == 1
    assert "Debian" not in printed([theorem])


def test_programs_see_the_kind_and_the_value(rows, theorem):
    *claims, last = json.loads(json_report.render([*rows, theorem]))
    assert {one["kind"] for one in claims} == {"claim"}
    assert (last["kind"], last["section"]) == ("theorem", "Theorems")
    assert last["evidence"][0]["value"] == "y = x**2"


def test_a_part_that_is_open_is_told_marked_and_filtered(rows, theorem):
    part = replace(theorem, claim=replace(theorem.claim, open=("Whether $x=2$.",)))
    files = html.render(document([*rows, part]), {})
    text = files[html.FRONT]
    assert 'class="badge open"' in files["pages/sharp.html"]
    assert 'class="badge open"' not in files["pages/energy-rate.html"]
    assert re.search(r'<tr data-row="sharp"[^>]*data-open="some"', text)
    assert 'data-open="none"' in text
    assert "Open: Whether x=2." in printed([part])
    assert "a part is open in 1: sharp" in printed([part, rows[0]])
    (found,) = json.loads(json_report.render([part]))
    assert found["open"] == ["Whether $x=2$."]
    assert r"\textbf{Open.} Whether $x=2$." in latex.render(document([part]), {})
