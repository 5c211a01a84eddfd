"""The page is valid, whole without a network, anchored, escaped, the same on every run; a browser opens its claims."""

import re
from html import unescape
from pathlib import Path

import pytest
from chromium import asked
from elements import Elements

from paper_checks.report.content.document import document
from paper_checks.report.content.phrases import headline, kind
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


def test_the_page_is_the_last_file_and_has_every_claim(files, rows):
    assert list(files)[-1] == html.FRONT
    for row in rows:
        verdict = row.finding.verdict.value
        given = rf'<details class="claim" id="{row.claim.id}"[^>]* data-verdict="{verdict}" data-step="([^"]*)"[^>]*>'
        assert re.search(given, files[html.FRONT])[1] == (row.established_by.value if row.established_by else "none")
        summary = files[html.FRONT].partition(f'id="{row.claim.id}" ')[2].partition("</summary>")[0]
        assert f'<span class="badge {verdict}">{verdict}</span> <small>{kind(row)}' in summary


def test_ids_are_unique_and_every_link_and_file_has_its_target(files, pages):
    for name, page in pages.items():
        ids = [given["id"] for _, given in page if "id" in given]
        assert len(ids) == len(set(ids)), name
        for link in (given["href"] for tag, given in page if tag == "a"):
            file, _, anchor = link.partition("#")
            assert not file or file in files, (name, link)
            assert not anchor or (not file and anchor in ids), (name, link)
        loaded = [given.get("src") or given.get("data") for _, given in page if {"src", "data"} & given.keys()]
        assert {*loaded} <= files.keys()
        assert not [tag for tag, _ in page if tag == "link"]


def test_nothing_comes_from_a_network(files):
    for name, text in files.items():
        assert not re.search(r'(?:src|href)="(?:https?:)?//|@import|fetch\(|XMLHttp', text), name
        assert all(one.startswith("#") for one in re.findall(r"url\(([^)]*)", text)), name


def test_the_first_page_counts_and_names_what_fails(files, rows):
    first, _, failed = files[html.FRONT].partition('<h2 id="rows">')[0].partition('<h2 id="refuted">')
    assert 'href="#example-stiction-never-violated"' in failed
    assert 'href="#stiction-bracket"' not in failed  # corrected, not refuted
    assert headline(rows) in unescape(first)


def test_hostile_texts_are_escaped(files):
    for text in files.values():
        assert "<script>alert" not in text
        assert "<b>100%" not in text
    assert "&lt;script&gt;alert" in files[html.FRONT]
    assert "&amp;lt;" not in files[html.FRONT]  # nor escaped twice


# in headless Chromium, from disk

OPENED = "example-stiction-never-violated"


@pytest.fixture(scope="module")
def found(files, tmp_path_factory) -> dict:
    folder = tmp_path_factory.mktemp("pages")
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    question = Path(__file__).with_name("in_browser.js")
    answer = asked(files[html.FRONT], question, folder, "--window-size=500,900", OPENED=OPENED)
    assert "error" not in answer, answer
    return answer


def test_a_claim_is_folded_until_it_is_opened(found):
    assert found["closed"] == 0
    assert found["opened"] == [True, True]
    assert found["images"]
    assert all(found["images"])


def test_the_search_and_the_filters_find_claims(found, rows):
    some, none, every = found["searched"]
    assert some == ["example-stiction-never-violated", "stiction-bracket"]
    assert none == []
    assert every == [row.claim.id for row in rows]
    assert found["chosen"] == [[OPENED], every]
    assert found["shown"] == f"{len(rows)} of {len(rows)} claims"


def test_a_link_opens_what_its_target_is_folded_in_whatever_was_searched_for(found):
    assert found["targeted"] == [False, True]
    assert found["again"]
    assert found["folded"]


def test_nothing_is_wider_than_a_phone(found):
    assert found["wide"] <= 0
