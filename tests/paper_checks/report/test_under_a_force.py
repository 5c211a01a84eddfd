"""The chapter on forces: its rows exist, its formulas can be set, its pictures are drawn, its numbers are computed."""

import re
from functools import cache
from pathlib import Path

from paper_checks.claims import CLAIMS
from paper_checks.report.content import under_a_force
from paper_checks.report.content.blocks import Paragraph, Points, Table
from paper_checks.report.mathematics import prose

chapter = cache(under_a_force.section)


def blocks(kind):
    return [block for block in chapter().blocks if isinstance(block, kind)]


def texts():
    return [*(one.text for one in blocks(Paragraph)), *(item for one in blocks(Points) for item in one.items)]


def test_it_names_rows_that_exist_and_its_mathematics_can_be_set():
    named = {name for text in texts() for name in re.findall(r"`([^`]+)`", text)}
    known = {claim.id for claim in CLAIMS}
    assert {one for one in known if one.startswith("forced-")} <= named <= known
    for text in texts():
        assert "<code>" not in prose.html(re.sub("`[^`]+`", "", text))
        assert text.count("$") % 2 == 0


def test_the_table_has_both_thresholds_without_and_with_a_damper():
    (table,) = blocks(Table)
    assert [len(row) for row in table.rows] == [5] * len(under_a_force.FREQUENCIES)
    assert {row[0]: row[1:3] for row in table.rows}["12"] == ("0.3056", "0.4720")
    assert all(float(row[1]) <= float(row[2]) and float(row[3]) <= float(row[4]) for row in table.rows)


def test_numbers_are_computed_not_typed():
    said, source = " ".join(texts()), Path(under_a_force.__file__).read_text("utf-8")
    for number in ("0.63662", "1.1547", "89.44", "33.333"):
        assert number in said
        assert number[:4] not in source
