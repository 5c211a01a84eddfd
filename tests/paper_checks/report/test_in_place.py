"""The first page in headless Chromium, from disk: rows open in place, are searched for, pointed to, can be read."""

from pathlib import Path

import pytest
from chromium import asked
from paper_checks.report.output.finished import placed

from paper_checks.report.content.document import document
from paper_checks.report.formats import html, vector

OPENED = "example-stiction-never-violated"


@pytest.fixture(scope="module")
def found(rows, figures, tmp_path_factory) -> dict:
    folder = tmp_path_factory.mktemp("pages")
    pages = html.render(document(rows), {name: vector.svg(draw()) for name, draw in figures.items()})
    placed(folder, {name: text.encode() for name, text in pages.items()})
    question = Path(__file__).with_name("in_place.js")
    answer = asked(pages[html.FRONT], question, folder, "--window-size=500,900", OPENED=OPENED)
    assert "error" not in answer, answer
    return answer


def test_a_row_is_loaded_when_it_is_opened_and_not_before(found):
    assert found["before"] == [0, "false"]
    assert found["after"] == [0, "true", ""]
    assert "Decisive step." in found["text"]
    assert "Counterexample." in found["text"]
    assert found["closed"] == [True, "false"]


def test_its_links_and_pictures_work_from_where_it_is_shown(found):
    assert found["links"]
    assert all(link.startswith("file:///") and "/pages/" in link for link in found["links"])
    assert found["images"]
    assert all(found["images"])


def test_the_search_and_the_filters_find_rows(found, rows):
    some, none, every = found["searched"]
    assert some == ["example-stiction-never-violated", "stiction-bracket"]
    assert none == []
    assert every == [row.claim.id for row in rows]
    assert found["chosen"] == [[OPENED], every]
    assert found["shown"] == f"{len(rows)} of {len(rows)} claims"


def test_a_link_to_a_row_opens_it_whatever_was_searched_for(found):
    assert found["targeted"] == [False, False]
