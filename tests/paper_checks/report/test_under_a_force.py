"""The chapter on forces: its rows exist, its formulas are theirs, its pictures are drawn and captioned."""

import re
from functools import cache

import pytest

from paper_checks.claims import CLAIMS
from paper_checks.drawing.captions import CAPTIONS
from paper_checks.report.content import under_a_force
from paper_checks.report.content.blocks import Paragraph, Picture, Points, Table
from paper_checks.report.mathematics import prose

chapter = cache(under_a_force.section)


def texts():
    for block in chapter().blocks:
        yield from [block.text] if isinstance(block, Paragraph) else []
        yield from block.items if isinstance(block, Points) else []


def test_it_names_rows_that_exist():
    named = {name for text in texts() for name in re.findall(r"`([^`]+)`", text)}
    assert named <= {claim.id for claim in CLAIMS}
    theorems = {claim.id for claim in CLAIMS if claim.id.startswith("forced-")}
    assert theorems <= named


def test_its_mathematics_can_be_set():
    for text in texts():
        assert "<code>" not in prose.html(re.sub("`[^`]+`", "", text))
        assert text.count("$") % 2 == 0


def test_each_picture_is_drawn_and_says_what_to_see():
    shown = [block.name for block in chapter().blocks if isinstance(block, Picture)]
    assert sorted(shown) == sorted(under_a_force.figures())
    assert set(shown) <= set(CAPTIONS)


def test_the_table_has_both_thresholds_without_and_with_a_damper():
    (table,) = (block for block in chapter().blocks if isinstance(block, Table))
    assert [len(row) for row in table.rows] == [5] * len(under_a_force.FREQUENCIES)
    assert {row[0]: row[1:3] for row in table.rows}["12"] == ("0.3056", "0.4720")
    assert all(float(row[1]) <= float(row[2]) and float(row[3]) <= float(row[4]) for row in table.rows)


@pytest.mark.parametrize("name", ["thresholds-over-frequency", "drift-against-asymmetry"])
def test_a_picture_is_a_figure_with_axes(name):
    figure = under_a_force.figures()[name]()
    assert all(ax.get_xlabel() and ax.get_ylabel() for ax in figure.axes)


def test_numbers_are_computed_not_typed():
    """Another pair has other numbers."""
    said = " ".join(texts())
    for number in ("0.63662", "1.1547", "89.44", "33.333"):
        assert number in said
    source = under_a_force.__loader__.get_source(under_a_force.__name__)
    for number in ("0.6366", "1.154", "89.4", "33.3"):
        assert number not in source
