"""The interactive page as a file: whole in itself; axe.py holds its controls against what they need."""

import re

import pytest
from elements import Elements

from numerics import Force, load_scene
from paper_checks.__main__ import main
from paper_checks.claims import CLAIMS
from paper_checks.explore.page import source
from paper_checks.explore.scenes import reduced


def test_it_is_one_light_file_that_needs_no_network(whole):
    assert len(whole.encode()) < 100_000
    assert not [one for one in Elements(whole).found if {"src", "href", "srcset"} & set(one[1])]
    assert not re.search(r"https?:|//cdn|import\s|fetch\(|XMLHttp|@import|url\(|eval\(", whole)


@pytest.mark.parametrize(
    "force", [Force.step(1, 1), Force.ramp(0, 1, 1), Force.sine(1, 1, 1), Force.sine(1, 1) + Force.sine(1, 2)]
)
def test_a_force_that_the_page_does_not_know_is_refused(force):
    with pytest.raises(ValueError, match="one sine of phase 0"):
        reduced(load_scene("velocities").replace(force=force))


def test_the_rows_that_it_names_are_in_the_ledger():
    named = set(re.findall(r'row: "([a-z-]+)"', source()))
    assert len(named) == 3
    assert named <= {claim.id for claim in CLAIMS}


def test_the_command_writes_the_page_or_says_in_one_line_why_it_cannot(tmp_path, whole, ended):
    target = tmp_path / "new" / "explore.html"
    assert ended(main, ["explore", "--out", str(target)]) == (0, f"{target}\n", "")
    assert target.read_text("utf-8") == whole
    code, _, error = ended(main, ["explore", "--out", str(target / "explore.html")])
    assert (code, error[:35]) == (2, "error: the page cannot be written: ")
