"""Each kind of block, and what is told of a claim, as the templates write it."""

import re
import tomllib
from dataclasses import replace
from html import unescape
from pathlib import Path

import pytest

from paper_checks.evidence.claim import Kind
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content import phrases
from paper_checks.report.content.blocks import (
    Cards,
    Code,
    Folded,
    Heading,
    Line,
    Paragraph,
    Picture,
    Points,
    Section,
    Table,
)
from paper_checks.report.content.document import document
from paper_checks.report.formats import html, latex

TABLE = Table(
    ("a", "b", "c"), (("`one`", "x\nin small", "z"), ("two", "y", "w")), "What it is", ("anchor-1", "anchor-2")
)
BLOCKS = {
    "heading": Heading("A & B", "place"),
    "paragraph": Paragraph("It is <b>.", "Why", marked=True),
    "points": Points(("`one`", "two")),
    "numbered": Points(("one",), numbered=True),
    "table": TABLE,
    "picture": Picture("sine", "A wave.", "Sine"),
    "absent": Picture("lost", "", ""),
    "cards": Cards((("One", "first", Picture("lost", "")), ("Two", "second", Picture("lost", "")))),
    "code": Code("a < b"),
    "line": Line(7, "Add $a$.", "Checked.", True, "line-7"),
    "two-formulas": Line(9, "Solve.$$a$$$$b$$", "Checked.", True),
    "failed-line": Line(8, "Add.", "Failed: no.", False),
    "folded": Folded("More", (Paragraph("Inside."),), "more"),
}
WRITTEN = tomllib.loads(Path(__file__).with_name("blocks.toml").read_text("utf-8"))


def normal(text):
    return " ".join(text.split())


@pytest.fixture(scope="module")
def written(rows):
    """All these blocks in a document of each form."""
    shown = Section("model", "Model", tuple(BLOCKS.values()))
    report = replace(document(rows), front=(shown,), rows=())
    svg = '<svg viewBox="0 0 30 20"></svg>'
    return normal(html.render(report, {"sine": svg})[html.FRONT]), normal(latex.render(report, {"sine": "sine.pdf"}))


@pytest.mark.parametrize("kind", BLOCKS)
def test_a_block_is_written_whole_in_both_forms(written, kind):
    assert WRITTEN[kind]["html"] in written[0]
    assert WRITTEN[kind]["latex"] in written[1]


@pytest.fixture(scope="module")
def page(rows):
    claim = replace(rows[0].claim, id="sharp", kind=Kind.THEOREM, open=("Whether it is so.",))
    opinion = replace(rows[0].claim, id="opinion", recorded=Verdict.NOT_JUDGED)
    left = replace(rows[0].finding, verdict=Verdict.NOT_JUDGED, reason="Taste. No more.", evidence=())
    others = [replace(rows[0], claim=one) for one in (claim, replace(rows[0].claim, id="critical-energy"))]
    others += [replace(rows[0], claim=opinion, finding=left, proofs=())]
    return html.render(document([*rows, *others], answers=["It is fast."]), {})[html.FRONT]


def lines_of(text):
    """The lines of the tables in a piece of a page, their cells as text."""
    lines = (
        re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", one, re.DOTALL) for one in re.findall("<tr.*?</tr>", text, re.DOTALL)
    )
    return [[normal(unescape(re.sub("<[^>]+>", "", cell))) for cell in line] for line in lines]


def chapter(page, name):
    """The lines of the table of a chapter."""
    return lines_of(page.partition(f'<details class="chapter" id="{name}">')[2].partition("</details>")[0])


def told(page, name):
    """What is told of a claim before its lines of the derivation and its steps: pairs of label and text."""
    article = page.partition(f'<details class="claim" id="{name}"')[2].partition("<article")[2]
    article = re.split('<details class="folded">|<p><strong>Derivation', article)[0]
    return {
        label: normal(unescape(re.sub("<[^>]+>", "", text)))
        for label, text in re.findall(r"<p[^>]*><strong>(.*?)\.</strong>(.*?)</p>", article, re.DOTALL)
    }


LABELS = {
    "energy-rate": ["The paper says (after (8))", "Decisive step", "Why"],
    "stiction-bracket": ["The paper says (eq. (4))", "Decisive step", "Why", "Counterexample", "What is true"],
    "rate-one-over-t": ["The paper says (after (8))", "Attention", "Why", "Missing for a proof"],
    "sharp": ["Hypotheses", "Theorem", "Decisive step", "Why", "Open"],
}


@pytest.mark.parametrize("name", LABELS)
def test_a_claim_is_told_under_these_labels(page, name):
    assert [*told(page, name)] == LABELS[name]


def test_each_label_has_its_own_text(page):
    bracket, rate = told(page, "stiction-bracket"), told(page, "rate-one-over-t")
    assert bracket["Counterexample"].startswith("x1(0)=0.006")
    assert "on S0 with" in bracket["What is true"]
    assert rate["Attention"] == "This differs from the verdict on record, holds."
    assert rate["Missing for a proof"].startswith("a proof of")
    assert rate["Why"] == "Samples only."
    assert "No damper and no force" in told(page, "sharp")["Hypotheses"]
    assert told(page, "sharp")["Open"] == "Whether it is so."
    article = page.partition('<details class="claim" id="stiction-bracket"')[2].partition("</article>")[0]
    assert article.rstrip().endswith("<code>python -m paper_checks run stiction-bracket</code></pre>")
    assert "<summary>All 3 steps</summary>" in article


def test_all_steps_of_a_claim_and_its_figure_are_there(page):
    article = page.partition('<details class="claim" id="example-stiction-never-violated"')[2].partition("</article>")[
        0
    ]
    assert "The figure sine was not drawn." in article
    lines = lines_of(article)
    assert ["clause", "what it says", "established by", "steps"] in lines
    (whole,) = [line for line in lines if line[0] == "counterexample"]
    assert whole[2] == "enclosure"
    assert re.fullmatch(r"S?\d+(, S?\d+)*", whole[3])
    elsewhere = re.search("theorems of the kernel.</strong>(.*?)</p>", article)[1]
    assert elsewhere.count("<code>") == int(re.search(r"All (\d+) steps", article)[1])
    own = page.partition('<details class="claim" id="rate-one-over-t"')[2].partition("</article>")[0]
    head, step = lines_of(own)[-2:]
    assert head == ["step", "kind", "checked statement", "result"]
    assert [step[0], step[1], step[3]] == ["1", "propertyhypothesis", "passed500 cases"]


def test_the_list_of_claims_is_what_the_filters_ask_for(page, rows):
    for row in rows:
        given = re.search(rf'id="{row.claim.id}" ([^>]*)>', page)[1]
        kind = row.established_by.value if row.established_by else "none"
        assert f'data-verdict="{row.finding.verdict.value}" data-step="{kind}"' in given
        summary = page.partition(f'id="{row.claim.id}" ')[2].partition("</summary>")[0]
        assert f'<span class="badge {row.finding.verdict.value}">{row.finding.verdict.value}</span>' in summary
        assert f"<small>{phrases.kind(row)}" in summary


def test_the_chapters_of_the_page(page):
    assert [line[0] for line in chapter(page, "new")] == ["theorem", "sharp"]
    assert [line[1:2] + line[3:] for line in chapter(page, "new")[1:]] == [["An identity.", "argument"]]
    assert [line[0].split()[0] for line in chapter(page, "not-judged")] == ["statement", "opinionafter"]
    assert chapter(page, "not-judged")[1][2] == "Taste. No more."
    answers = dict(chapter(page, "questions"))
    assert answers["Which claims fail, and what are the counterexamples?"].startswith(
        "example-stiction-never-violated: x1(0)"
    )
    assert answers["How fast is it compared with heyoka?"] == "It is fast."
    assert " It holds. An identity. Proof: critical-energy;" in answers["What is Ecr, and who proved it?"]
    assert answers["What is not known?"] == "One list: open."
    assert answers["Which law of friction is used?"].startswith("All verdicts are under Coulomb's law")
