"""The page is valid, self-contained, anchored, escaped, and the same on every run."""

import re
from html.parser import HTMLParser

import pytest

from paper_checks.report import html, vector
from paper_checks.report.files import write

VOID = {"meta", "br", "wbr", "link", "img", "input", "hr"}


class Page(HTMLParser):
    """Collects ids and links, and insists that elements close in order."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.links, self.attributes = [], [], [], []
        self.elements = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.elements.append(tag)
        self.attributes += attrs
        self.ids += [value for name, value in attrs if name == "id"]
        self.links += [value for name, value in attrs if name in ("href", "src", "xlink:href", "action", "data")]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


@pytest.fixture
def text(rows, figures):
    return html.render(rows, {name: vector.svg(draw()) for name, draw in figures.items()})


@pytest.fixture
def page(text):
    return Page(text)


def test_ids_are_unique_and_every_claim_has_its_anchor(page, rows):
    assert len(page.ids) == len(set(page.ids))
    assert {row.claim.id for row in rows} <= set(page.ids)


def test_nothing_is_loaded_and_every_link_has_its_target(page, text):
    assert all(link.startswith("#") for link in page.links)
    assert {link[1:] for link in page.links} <= set(page.ids)
    assert "@import" not in text
    assert not re.search(r"url\((?!#)", text)
    assert page.elements.count("script") == 1


def test_every_reference_inside_a_figure_has_its_target(page, text):
    assert set(re.findall(r"url\(#([^)]+)\)", text)) <= set(page.ids)


def test_each_row_has_everything_behind_it(text):
    row = text[text.index('<tbody id="example-stiction-never-violated"') :]
    row = row[: row.index("</details>")]
    headings = "Reason", "Counterexample", "Corrected statement", "Evidence", "Derivation", "Run it again"
    positions = [row.index(f"<h4>{title}</h4>") for title in headings]
    assert positions == sorted(positions)
    assert "python -m paper_checks run example-stiction-never-violated" in row
    assert "<svg" in row
    assert "<math" in row


def test_findings_come_first_and_name_every_verdict_that_is_news(text):
    findings = text[text.index('<section class="findings"') : text.index("</section>")]
    assert text.index('<section class="findings"') < text.index('<table class="claims"')
    order = [findings.index(title) for title in ("Refuted", "Holds after a correction", "Undecided", "Unchecked")]
    assert order == sorted(order)
    assert "#energy-rate" not in findings


def test_hostile_texts_are_escaped(text):
    assert "<script>alert" not in text
    assert "<b>100%" not in text
    assert "&lt;script&gt;alert" in text


def test_what_differs_and_what_was_not_drawn_is_said(text):
    assert "differs from the verdict on record, holds" in text
    assert "The figure lost was not drawn." in text


def test_the_page_has_a_language_and_filters_for_what_occurs(page, text):
    assert ("lang", "en") in page.attributes
    for value in ("II", "III", "IV", "V", "refuted", "undecided"):
        assert f'<option value="{value}">' in text


def test_two_runs_give_the_same_bytes_and_no_date(rows, figures, tmp_path):
    for folder in ("one", "two"):
        for form in ("html", "latex"):
            write(tmp_path / folder, form, rows, figures, lambda complaint: None)
    names = sorted(path.name for path in (tmp_path / "one").iterdir())
    assert names == ["report.html", "report.tex", "sine.pdf"]
    for name in names:
        content = (tmp_path / "one" / name).read_bytes()
        assert content == (tmp_path / "two" / name).read_bytes()
        assert not re.search(rb"CreationDate|dc:date|\b20\d\d-\d\d-\d\d", content)


def test_a_figure_that_fails_costs_only_itself(rows, tmp_path):
    def broken():
        raise RuntimeError("no trajectory")

    complaints = []
    path = write(tmp_path, "html", rows, {"sine": broken}, complaints.append)
    assert path.exists()
    assert complaints == [
        "the figure sine was not drawn: RuntimeError: no trajectory",
        "the figure lost is not known",
    ]


def test_an_interruption_leaves_no_partial_file(rows, figures, tmp_path, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(html, "render", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write(tmp_path, "html", rows, figures, print)
    assert list(tmp_path.iterdir()) == []
