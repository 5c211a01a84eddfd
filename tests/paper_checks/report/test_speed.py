"""Chapters with numbers say what is computed: who is faster on planted records, what holds under a force."""

import re
import tomllib
from functools import cache
from pathlib import Path

import pytest
from planted_trades import row, trade_of

from numerics.trade.recorded import recorded
from paper_checks.claims import CLAIMS
from paper_checks.report.content import blocks, force, phrases, speed
from paper_checks.report.formats.html import fragment

PLANTED = tomllib.loads(Path(__file__).with_name("speed.toml").read_text("utf-8"))


@pytest.mark.parametrize("case", PLANTED)
def test_the_chapter_on_speed_says_what_the_record_says(case):
    rows = [row(*one) for one in PLANTED[case]["rows"]]
    assert PLANTED[case]["line"] in speed.text(trade_of(*rows))


def test_the_shipped_record_is_told():
    trade = recorded()
    chapter = blocks.section(speed.text(trade))
    assert ("Other programs ran" in speed.text(trade)) is trade.machine["busy"]
    for table in (one for one in chapter.blocks if one.kind == "table"):
        assert len({len(row.items) for row in table.inside}) == 1
    assert not re.search(r"\bnan\b|\bNone\b|\binf\b", fragment(chapter))
    assert set(chapter.pictures) == set(speed.figures(trade))


@cache
def under_a_force():
    return blocks.chapter("under-a-force", say=phrases, **force.given())


def test_the_chapter_on_forces_names_claims_that_exist():
    named = {*re.findall(r"`([^`]+)`", under_a_force())}
    known = {claim.id for claim in CLAIMS}
    assert {one for one in known if one.startswith("forced-")} <= named <= known | {"s-curve"}
    assert "<code>" not in fragment(blocks.section(under_a_force().replace("`", "")))  # its mathematics can be set


def test_numbers_are_computed_not_typed():
    source = Path(blocks.__file__).with_name("chapters").joinpath("under-a-force.md").read_text("utf-8")
    for number in ("0.63662", "1.1547", "89.44", "33.333"):
        assert number in under_a_force()
        assert number[:4] not in source
