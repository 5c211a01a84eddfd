"""The report in headless Chromium, from disk: claims open, are searched for, pointed to, can be read."""

from pathlib import Path

import pytest
from chromium import asked

from paper_checks.report.content.document import document
from paper_checks.report.formats import html, vector

OPENED = "example-stiction-never-violated"


@pytest.fixture(scope="module")
def found(rows, figures, tmp_path_factory) -> dict:
    folder = tmp_path_factory.mktemp("pages")
    pages = html.render(document(rows), {name: vector.svg(draw()).decode() for name, draw in figures.items()})
    for name, text in pages.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    question = Path(__file__).with_name("in_browser.js")
    answer = asked(pages[html.FRONT], question, folder, "--window-size=500,900", OPENED=OPENED)
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
