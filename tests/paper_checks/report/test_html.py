"""The page is valid, self-contained, anchored, escaped, and the same on every run."""

import re
from dataclasses import replace
from html import unescape
from html.parser import HTMLParser

import pytest

from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.report.content import notation
from paper_checks.report.content.document import document, summary
from paper_checks.report.content.phrases import place
from paper_checks.report.formats import html, vector
from paper_checks.report.output.files import write

VOID = {"meta", "br", "wbr", "link", "img", "input", "hr"}


class Page(HTMLParser):
    """Collects ids, links and references, and insists that elements close in order."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.links, self.attributes = [], [], [], []
        self.elements, self.images, self.regions = [], [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.elements.append(tag)
        self.attributes += attrs
        found = dict(attrs)
        self.ids += [found["id"]] if "id" in found else []
        self.links += [value for name, value in attrs if name in ("href", "src", "xlink:href", "action", "data")]
        if found.get("role") == "img":
            self.images.append(found.get("aria-label"))
        if found.get("class") == "wide":
            self.regions.append((found.get("role"), found.get("aria-label")))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


@pytest.fixture(scope="module")
def text(rows, figures):
    return html.render(document(rows), {name: vector.svg(draw()) for name, draw in figures.items()})


@pytest.fixture(scope="module")
def page(text):
    return Page(text)


def behind(text, name):
    """What stands behind a row."""
    row = text[text.index(f'<tbody id="{name}"') :]
    return row[: row.index("</tbody>")]


def test_ids_are_unique_and_every_claim_has_its_anchor(page, rows):
    assert len(page.ids) == len(set(page.ids))
    assert {row.claim.id for row in rows} <= set(page.ids)


def test_nothing_is_loaded_and_every_link_has_its_target(page, text):
    assert all(link.startswith("#") for link in page.links)
    assert {link[1:] for link in page.links} <= set(page.ids)
    assert "@import" not in text
    assert all(target.startswith(("#", "data:font/woff;base64,")) for target in re.findall(r"url\(([^)]*)", text))
    assert page.elements.count("script") == 2  # of the rows, and of what a reader plays with


def test_every_reference_inside_a_figure_has_its_target(page, text):
    assert set(re.findall(r"url\(#([^)]+)\)", text)) <= set(page.ids)


def test_a_reader_without_a_mouse_or_without_eyes_finds_the_way(page, text):
    assert page.elements.index("a") < page.elements.index("nav") < page.elements.index("main")
    assert '<a class="skip" href="#main">' in text
    assert page.images
    assert all(page.images)
    assert page.regions
    assert all(role == "group" and label for role, label in page.regions)
    assert "#explore" in page.links


def test_each_row_tells_the_decisive_step_first_and_the_rest_folded(text):
    row = behind(text, "example-stiction-never-violated")
    labels = "Decisive step", "Why", "Counterexample", "What is true"
    positions = [row.index(f"<strong>{label}.</strong>") for label in labels]
    assert positions == sorted(positions)
    decisive = row[row.index('<p class="decisive">') : row.index("</p>")]
    assert "the slip ends at" in decisive.lower()  # what shows the counterexample, not what failed
    assert row.index('<details class="folded">') > positions[-1]
    assert "python -m paper_checks run example-stiction-never-violated" in row
    assert "<svg" in row
    assert "<math" in row


def test_what_is_not_settled_has_no_decisive_step(text):
    assert "Decisive step" not in behind(text, "rate-one-over-t")
    assert "Missing for a proof" in behind(text, "rate-one-over-t")


def test_symbols_of_a_row_link_to_their_meaning(text):
    row = behind(text, "stiction-bracket")
    for name in ("masses", "b", "S0"):
        assert f'href="#{notation.anchor(name)}"' in row
    assert f'href="#{notation.anchor("theta")}"' not in row


def test_ids_that_are_mentioned_are_links(rows):
    found = document(rows)
    writer = html.HtmlWriter({}, found.anchors)
    assert writer.text("see `energy-rate`") == 'see <a href="#energy-rate"><code>energy-<wbr>rate</code></a>'
    assert writer.text("(see energy-rate)") == f"({writer.text('see `energy-rate`')})"
    assert writer.text("an energy-rate-like, no-such-row") == "an energy-rate-like, no-such-row"
    assert "<a" not in writer.text("see `no-such-row`")


def test_the_first_screen_comes_first_and_counts(text):
    refuted = text[text.index('<h2 id="refuted">') : text.index('<h2 id="rows">')]
    assert 'href="#example-stiction-never-violated"' in refuted
    assert 'href="#stiction-bracket"' not in refuted  # corrected, not refuted
    found = unescape(text[text.index('<h2 id="found">') : text.index('<h2 id="rows">')])
    assert "Of the paper's 5 claims 1 holds as written, 1 holds after a correction, 1 is refuted" in found
    assert "1 is undecided and 1 is unchecked" in found
    assert text.index('<div class="model">') < text.index('<h2 id="found">') < text.index('<table class="claims"')


def test_the_summary_has_no_rows_and_names_what_fails(rows):
    text = html.render(summary(rows), {})
    assert 'class="claims"' not in text
    assert all(name in text.replace("<wbr>", "") for name in ("stiction-bracket", "example-stiction-never-violated"))
    assert "energy-rate" not in text.replace("<wbr>", "")
    Page(text)


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


def test_the_filter_by_the_weakest_step_has_the_kinds_that_occur_from_the_strongest_on(text, rows):
    chosen = re.search(r'<select id="filter-step">(.*?)</select>', text).group(1)
    kinds = [kind.value for kind in EvidenceKind if any(row.established_by is kind for row in rows)]
    open_ones = ["none"] if any(row.established_by is None for row in rows) else []
    assert re.findall(r'value="(\w[^"]*)"', chosen) == [*kinds, *open_ones]
    found = sorted(re.findall(r'data-step="(\w+)"', text))
    assert found == sorted(row.established_by.value if row.established_by else "none" for row in rows)


def test_two_runs_give_the_same_bytes_and_no_date(rows, figures, tmp_path):
    pytest.importorskip("typst")
    for folder in ("one", "two"):
        write(tmp_path / folder, ("html", "latex", "pdf"), document(rows), figures, lambda complaint: None)
    names = sorted(path.name for path in (tmp_path / "one").iterdir())
    assert names == ["report.html", "report.pdf", "report.tex", "sine.pdf", "two-bodies.pdf"]
    for name in names:
        content = (tmp_path / "one" / name).read_bytes()
        assert content == (tmp_path / "two" / name).read_bytes()
        assert not re.search(rb"CreationDate|dc:date|\b20\d\d-\d\d-\d\d", content)


def test_a_figure_that_fails_costs_only_itself(rows, figures, tmp_path):
    def broken():
        raise RuntimeError("no trajectory")

    complaints = []
    (path,) = write(tmp_path, ("html",), document(rows), figures | {"sine": broken}, complaints.append)
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
        write(tmp_path, ("html",), document(rows), figures, print)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("where", "shown"),
    [
        ("(8)", "(8)"),
        ("after (8)", "(after (8))"),
        ("Fig. 3 (a)", "(Fig. 3 (a))"),
        ("eqs. (3), (4)", "(eqs. (3), (4))"),
    ],
)
def test_the_number_of_an_equation_has_its_own_brackets(rows, where, shown):
    assert place(replace(rows[0].claim, where=where)) == shown
