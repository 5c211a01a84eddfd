"""Chapters are read into blocks, each kind of block is written whole in both forms, and a claim is told with labels."""

import re
import tomllib
from dataclasses import replace
from html import unescape
from pathlib import Path

import pytest

from paper_checks.report.content.blocks import Section, read
from paper_checks.report.content.document import document, paper
from paper_checks.report.formats import html, latex

WRITTEN, TOLD = (
    tomllib.loads(Path(__file__).with_name(name).read_text("utf-8")) for name in ("blocks.toml", "told.toml")
)


def normal(text):
    return " ".join(text.split())


@pytest.fixture(scope="module")
def written(rows):
    """All blocks in a document of each form."""
    blocks = [block for one in WRITTEN.values() for block in read(one["text"])]
    chapter = Section("model", "Model", tuple(blocks))
    page = replace(document(rows), front=(chapter,))
    printed = replace(paper(rows), chapters=(chapter,))
    svg = '<svg viewBox="0 0 30 20"></svg>'
    return normal(html.render(page, {"sine": svg})[html.FRONT]), normal(latex.render(printed, {"sine": "sine.pdf"}))


@pytest.mark.parametrize("kind", WRITTEN)
def test_a_block_is_read_and_written_whole_in_both_forms(written, kind):
    assert len(read(WRITTEN[kind]["text"])) == 1
    assert WRITTEN[kind]["html"] in written[0]
    assert WRITTEN[kind]["latex"] in written[1]


@pytest.fixture(scope="module")
def page(rows):
    return html.render(document(rows), {})[html.FRONT]


def article(page, name):
    return page.partition(f'<details class="claim" id="{name}"')[2].partition("</article>")[0]


def plain(text):
    return normal(unescape(re.sub("<[^>]+>", "", text)))


def lines_of(text):
    """The lines of the tables in a piece of a page, their cells as text."""
    lines = (
        re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", one, re.DOTALL) for one in re.findall("<tr.*?</tr>", text, re.DOTALL)
    )
    return [[plain(cell) for cell in line] for line in lines]


@pytest.mark.parametrize("name", TOLD)
def test_a_claim_is_told_under_these_labels(page, name):
    before = article(page, name).partition('<details class="folded">')[0]
    found = re.findall(r"<p[^>]*><strong>(.*?)\.</strong>(.*?)</p>", before, re.DOTALL)
    told = {plain(label): plain(text) for label, text in found}
    assert [*told] == [*TOLD[name]]
    assert all(told[label].startswith(text) for label, text in TOLD[name].items())


def test_all_steps_of_a_claim_and_its_figure_are_there(page):
    text = article(page, "example-stiction-never-violated")
    assert "The figure sine was not drawn." in text
    assert "<code>python -m paper_checks run example-stiction-never-violated</code></pre>" in text
    lines = lines_of(text)
    assert ["clause", "what it says", "established by", "steps"] in lines
    (whole,) = [line for line in lines if line[0] == "counterexample"]
    assert whole[2] == "enclosure"
    assert {*whole[3].split(", ")} <= {line[0] for line in lines}
    assert len(lines) - lines.index(["step", "kind", "checked statement", "result"]) - 1 == int(
        re.search(r"All (\d+) steps", text)[1]
    )
    step = lines_of(article(page, "rate-one-over-t"))[-1]
    assert [step[0], step[1], step[3]] == ["1", "propertyhypothesis", "passed500 cases"]
