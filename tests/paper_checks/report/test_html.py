"""The page is valid, whole without a network, anchored, escaped, and the same on every run."""

import posixpath
import re
from html import unescape

import pytest
from elements import Elements

from paper_checks.report.content.document import document
from paper_checks.report.content.phrases import headline
from paper_checks.report.formats import html, vector


@pytest.fixture(scope="module")
def drawn(figures):
    return {name: vector.svg(draw()).decode() for name, draw in figures.items()}


@pytest.fixture(scope="module")
def files(rows, drawn):
    return html.render(document(rows), drawn)


@pytest.fixture(scope="module")
def pages(files):
    return {name: Elements(text).found for name, text in files.items() if name.endswith(".html")}


def test_the_same_rows_give_the_same_bytes(files, rows, drawn):
    assert html.render(document(rows), drawn) == files


@pytest.fixture(scope="module")
def front(files):
    return files[html.FRONT]


def test_the_page_is_the_last_file_and_has_every_claim(files, rows):
    assert list(files)[-1] == html.FRONT
    for row in rows:
        told = files[html.FRONT].partition(f'<details class="claim" id="{row.claim.id}"')[2]
        assert f'<article class="row {row.finding.verdict.value}">' in told.partition("</summary>")[2][:100]


def links(page):
    return [given["href"] for tag, given in page if tag == "a"]


def test_ids_are_unique_and_every_link_and_file_has_its_target(files, pages):
    ids = {name: [given["id"] for _, given in page if "id" in given] for name, page in pages.items()}
    for name, page in pages.items():
        assert len(ids[name]) == len(set(ids[name])), name
        folder = posixpath.dirname(name)
        for link in links(page):
            file, _, anchor = link.partition("#")
            target = posixpath.normpath(posixpath.join(folder, file)) if file else name
            assert target in files, (name, link)
            assert not anchor or anchor in ids[target], (name, link)
        loaded = [
            given[key]
            for tag, given in page
            for key in given
            if key in ("src", "data") or (tag, key) == ("link", "href")
        ]
        assert all(posixpath.normpath(posixpath.join(folder, one)) in files for one in loaded)


def test_nothing_comes_from_a_network(files):
    for name, text in files.items():
        assert not re.search(r'(?:src|href)="(?:https?:)?//|@import|fetch\(|XMLHttp', text), name
        assert all(one.startswith("#") for one in re.findall(r"url\(([^)]*)", text)), name


def test_a_reader_without_a_mouse_or_without_eyes_finds_the_way(pages):
    images = {
        name: [given.get("alt") or given.get("aria-label") for tag, given in page if "img" in (tag, given.get("role"))]
        for name, page in pages.items()
    }
    for name, page in pages.items():
        assert all(images[name]), name
        regions = [given for tag, given in page if (tag, given.get("class")) == ("div", "wide")]
        assert all(given["role"] == "group" and given["aria-label"] for given in regions), name
    tags = [tag for tag, _ in pages[html.FRONT]]
    assert tags.index("a") < tags.index("nav") < tags.index("main")
    assert images[html.FRONT]
    assert {"#main", html.EXPLORE} <= {*links(pages[html.FRONT])}


def test_the_first_page_counts_and_names_what_fails(front, rows):
    failed = front[front.index('<h2 id="refuted">') : front.index('<h2 id="rows">')]
    assert 'href="#example-stiction-never-violated"' in failed
    assert 'href="#stiction-bracket"' not in failed  # corrected, not refuted
    found = unescape(front[: front.index('<h2 id="refuted">')])
    assert headline(rows) in found


def test_hostile_texts_are_escaped(files):
    for text in files.values():
        assert "<script>alert" not in text
        assert "<b>100%" not in text
    assert "&lt;script&gt;alert" in files[html.FRONT]
    assert "&amp;lt;" not in files[html.FRONT]  # nor escaped twice
