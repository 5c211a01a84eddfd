"""Every form tells every claim whole, theorems beyond the paper as ours; the terminal is readable in a pipe."""

import io
import json
import re
from dataclasses import replace
from html import unescape
from types import SimpleNamespace

import pytest
from rich.console import Console

from paper_checks.claims import CLAIMS, claim_named
from paper_checks.evidence.claim import FREE, UNDER_A_FORCE, Claim, Kind
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.proofs.audit import recorded
from paper_checks.report.content import kernel, trust
from paper_checks.report.content.document import document, paper
from paper_checks.report.content.phrases import headline, kind
from paper_checks.report.formats import html, latex
from paper_checks.report.formats import json as json_report
from paper_checks.report.formats.html import fragment
from paper_checks.report.formats.terminal import print_claims, print_rows
from paper_checks.running.graph import proofs
from paper_checks.running.runner import Row

PROVED = Evidence(EvidenceKind.EXACT, "sympy", "$1=1$", True, value="y = x**2")
NOT_JUDGED = Claim("opinion", "I", "first paragraph", "It matters.", Verdict.NOT_JUDGED)
LEFT = Row(NOT_JUDGED, Finding(Verdict.NOT_JUDGED, "An opinion. No more.", ()))


@pytest.fixture
def theorem():
    claim = Claim("sharp", "Theorems", "beyond the paper", "$x=1$ for all $q$.", Verdict.HOLDS, Kind.THEOREM)
    row = Row(claim, Finding(Verdict.HOLDS, "The limit is one. It is.", (PROVED,)))
    return replace(row, proofs=proofs(row.claim, row.finding))


def printed(rows, width=80, show=print_rows, **options):
    stream = io.StringIO()
    show(Console(file=stream, width=width, highlight=False), rows, **options)
    return stream.getvalue()


def page(rows):
    return unescape(html.render(document(rows), {})[html.FRONT])


FORMS = {
    "terminal": lambda row: printed([row], 1000),
    "html": lambda row: page([row]),
    "json": lambda row: json_report.render([row]),
    "latex": lambda row: latex.render(paper([row]), {}),
}


def words(text):
    """The longest run of words outside mathematics: every form shows it as it stands."""
    return max(re.findall(r"[A-Za-z ]+", re.sub(r"\$.*?\$", "|", text)), key=len, default="").strip()


@pytest.mark.parametrize("form", FORMS)
def test_every_form_tells_all_of_a_row(rows, theorem, form):
    for row in (*rows, theorem):
        told, claim, found = " ".join(FORMS[form](row).split()), row.claim, row.finding
        texts = [claim.id, claim.statement, found.corrected, found.counterexample, found.missing]
        if form == "latex":  # print has the reason where nothing is corrected, and theorems by their statement
            texts += [found.reason] if claim.kind is Kind.CLAIM and not found.corrected else []
        else:
            texts += [found.verdict.value, found.reason, *(step.statement for step in found.evidence)]
        for text in filter(None, texts):
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
    listed = printed([row.claim for row in rows], 100, print_claims).splitlines()
    shown = {line.split()[0]: line for line in listed if line.strip()}
    assert all(f" {one.claim.recorded.value} " in shown[one.claim.id] for one in rows)


def test_rows_are_counted_and_those_that_differ_from_the_record_are_named(rows):
    text = " ".join(printed(rows).split())
    first = "1 claim differs from the record. Fails first: a proof of w→0 turns 1 claim: rate-one-over-t"
    assert text.startswith(first)
    assert "differs from the record: undecided, recorded holds: rate-one-over-t" in text
    assert "unchecked, because a tool is missing: hostile" in text
    counted = "1 holds, 1 holds after a correction, 1 is refuted, 1 is undecided and 1 is unchecked for lack of a tool."
    assert f"Of the paper's 5 claims {counted}" in text
    assert "a proof of" in page(rows).partition('class="chapter" id="open"')[2].partition('class="chapter"')[0]


def test_what_a_step_assumes_what_stands_beside_and_how_sure_it_is_are_told(rows, theorem):
    *_, corrected, sampled = (printed([row]) for row in rows[:4])
    assert "Given" in corrected
    assert "Beside the proof" in sampled
    (sure,) = (fragment(one) for one in document([*rows, theorem]).front if one.id == "trust")
    assert re.search(r"argument</th>.*?>3</td><td[^>]*>1</td>", sure)
    assert "; 0 of them name no theorem" not in sure
    for state, said in ((None, "exact"), ("proved", "exact"), ("not run", "exact (kernel not run)")):
        assert kind(SimpleNamespace(established_by=EvidenceKind.EXACT, kernel=state)) == said


def test_json_has_the_shape_of_the_design(rows, theorem):
    data = json.loads(json_report.render([*rows, theorem]))
    assert [item["id"] for item in data] == [*(row.claim.id for row in rows), "sharp"]
    for item in data:
        assert {"id", "where", "statement", "verdict", "reason", "evidence"} <= set(item)
        assert all({"kind", "engine", "statement", "cases", "value"} <= set(step) for step in item["evidence"])
        for part in item["clauses"]:
            assert not [one for one in part["support"] if one in part["steps"]]
    assert "seconds" not in data[0]
    assert data[1]["verdict"] == data[1]["recorded"] == "refuted"
    assert [one["kind"] for one in data] == ["claim"] * len(rows) + ["theorem"]
    assert data[-1]["evidence"][0]["value"] == "y = x**2"


def test_statements_that_are_not_judged_are_no_claims(rows, theorem):
    assert headline([LEFT]) == "1 statement is not judged."
    judged = headline([*rows, theorem]).partition(". ")
    assert headline([*rows, LEFT, LEFT, theorem]) == f"{judged[0]}; 2 further statements are not judged. {judged[2]}"
    titles = {one.id: one.title for one in paper([*rows, LEFT]).chapters}
    assert titles["not-judged"] == "Statements that are not judged"
    assert titles["refuted"] == "Claims that are refuted"
    assert "An opinion. No more." in page([LEFT]).partition('class="chapter" id="not-judged"')[2]


def test_theorems_are_counted_apart_filtered_listed_and_told_as_ours(rows, theorem):
    text = page([*rows, theorem])
    assert ". Of 1 theorem beyond it 1 is proved." in text
    assert {"Section III", "Theorems"} <= {*re.findall(r'data-section="([^"]*)"', text)}
    assert "The limit is one." in text.partition('class="chapter" id="new"')[2]
    assert "Hypotheses: m₁,m₂,a₂,b>0. No damper" in printed([theorem])
    assert "Theorem: x=1 for all q." in printed([theorem])


def test_a_part_that_is_open_is_counted_and_told(rows, theorem):
    part = replace(theorem, claim=replace(theorem.claim, open=("Whether $x=2$.",)))
    assert headline([part, theorem]) == "Of 2 theorems beyond the paper 2 are proved. 1 leaves a part open."
    assert "open" not in headline([theorem])
    text = page([part])
    assert "· part open" in text
    assert "Whether" in text.partition('class="chapter" id="open"')[2]
    assert "part open: sharp" in printed([part, rows[0]])
    assert json.loads(json_report.render([part]))[0]["open"] == ["Whether $x=2$."]
    assert "Open: Whether x=2." in printed([part])
    assert r"\item Whether $x=2$. (" in latex.render(paper([part]), {})


@pytest.mark.parametrize("claim", [one for one in CLAIMS if one.kind is Kind.THEOREM], ids=lambda claim: claim.id)
def test_a_theorem_is_said_to_be_without_a_damper_where_the_kernel_has_none(claim):
    """What a theorem of the free pair assumes is read off from its statements: 0 in the damper's place."""
    statements = [recorded().theorems[name].statement for one in claim.clauses for name in one.kernel]
    if claim.assuming == FREE:
        assert all(kernel.undamped(text) for text in statements if "Pair.solution" in text)
        assert not any("Forced.forced" in text for text in statements)
    else:
        assert any("u" in str(one.shown) for one in claim.clauses)


def test_a_theorem_is_printed_with_what_it_assumes_where_that_is_its_own():
    names = "forced-no-zeno", "sharp-rate-constant"
    rows = [Row(claim_named(name), Finding(Verdict.UNDECIDED, "r", missing="m")) for name in names]
    (new,) = (one for one in paper(rows).chapters if one.id == "new")
    driven, free = (block.inside[0].text for block in new.blocks if block.kind == "entry")
    assert UNDER_A_FORCE in driven
    assert FREE not in free


@pytest.mark.parametrize(
    ("text", "typed"),
    [("If $x>0$, «f».", True), ("For $t\\to\\infty$, «f».", True), ("«f» at $x_1$, and 2 > 1.", False)],
)
def test_a_relation_that_is_typed_beside_the_formulas_is_counted(text, typed):
    assert trust.has_typed_relation(clause("part", text, f=Formula("a", "=", "b", decide=lambda _: None))) == typed
