"""CITATION.cff says what pyproject.toml, the package and the BibTeX entries say."""

import re
import tomllib
from pathlib import Path

import pytest
import yaml

from paper_checks.claims import source
from paper_checks.report.content import citation
from paper_checks.report.content.blocks import chapter

ROOT = Path(__file__).parents[3]


@pytest.fixture
def cited():
    return yaml.safe_load((ROOT / "CITATION.cff").read_text("utf-8"))


@pytest.fixture
def project():
    return tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]


def test_it_says_what_the_project_and_the_package_say(cited, project):
    (paper,) = cited["references"]
    assert cited["title"] == f"{project['name']}: {project['description']}"
    assert all(cited[name] == project[name] for name in ("version", "license", "authors", "keywords"))
    assert str(cited["date-released"]) == citation.DATE
    names = [f"{one['given-names']} {one['family-names']}" for one in paper["authors"]]
    assert (paper["title"], names, str(paper["year"])) == (source.TITLE, [*source.AUTHORS], source.YEAR)
    assert paper["identifiers"][0]["value"] == f"arXiv:{source.ARXIV}"
    assert paper["url"] == project["urls"]["Paper"] == f"https://arxiv.org/abs/{source.ARXIV}"
    assert source.SHA256 in paper["notes"]


def test_the_entries_say_the_same(cited):
    entries = [dict(re.findall(r"(\w+) = \{+(.*?)\}+,\n", one, re.DOTALL)) for one in citation.bibtex().split("@")[1:]]
    software, paper = [{name: " ".join(text.split()) for name, text in one.items()} for one in entries]
    author, year = cited["authors"][0]["name"], str(cited["date-released"].year)
    said = {"author": author, "title": cited["title"], "year": year, "note": f"Version {cited['version']}"}
    assert software == said
    authors = " and ".join(source.AUTHORS)
    said = {"author": authors, "title": source.TITLE, "year": source.YEAR, "eprint": source.ARXIV}
    assert paper == {**said, "archivePrefix": "arXiv"}
    assert f"```bibtex\n{citation.bibtex()}\n```" in (ROOT / "README.md").read_text("utf-8")


def test_the_report_says_how_to_install_as_the_readme_does():
    command = (ROOT / "README.md").read_text("utf-8").partition("```sh\n")[2].partition("\n```")[0]
    assert f"```\n{command}\n```" in chapter("provenance", source=source, citation=citation)
