"""Chapters with numbers say what is computed: who is faster on planted records, what holds under a force."""

import re
from functools import cache
from pathlib import Path

import pytest
from planted_trades import row, trade_of

from numerics.trade.recorded import recorded
from paper_checks.claims import CLAIMS
from paper_checks.report.content import blocks, force, phrases, speed
from paper_checks.report.formats.html import fragment

LINES = {
    "nobody took part": ([], "No other program was measured."),
    "ours wins": (
        [row("heyoka", "velocities", 10.0, 12.0), row("heyoka", "velocities", 20.0, 15.0)],
        "float64 is faster than heyoka on 1 of 1 scenes: heyoka takes 20 times as long in the median",
    ),
    "where both win some the loss is said": (
        [row("heyoka", "velocities", 4.0), row("heyoka", "relative-motion-b05", 0.5)],
        "on 1 of 2 scenes: heyoka takes 2.25 times as long in the median, and 0.5 times where it is best (on "
        "relative-motion-b05).",
    ),
    "a wrong run does not count": (
        [row("heyoka", "velocities", 0.1, 16.0, "event 3")],
        "No other program was measured.",
    ),
    "a scene on which float64 has no answer": (
        [row("float64", "velocities", 1.0)._replace(seconds=None, ratio=None)],
        "- On velocities float64 has no answer",
    ),
    "what proved digits cost": ([], "15 cost 100 times."),
    "wrong events are counted": (
        [
            row("float64", "velocities", 1.0, 2.0, "event 4", 0),
            row("Peer", "velocities", 1.0)._replace(seconds=None),
        ],
        "Of 7 runs that ended 1 have an event wrong; never one of balls.",
    ),
    "ours among them": (
        [row("float64", "velocities", 1.0, 2.0, "event 4", 0)],
        "Ours is wrong: float64 with 0 digits on velocities (event 4).",
    ),
    "forward Euler's steps": (
        [row("forward Euler", "velocities", 1.0, 2.0, *one) for one in (("event 4: no", 1e3), ("", 1e4))],
        "¦ velocities ¦ 1000: event 4; 10000: 1.0e-02",
    ),
}


@pytest.mark.parametrize("case", LINES)
def test_the_chapter_on_speed_says_what_the_record_says(case):
    rows, line = LINES[case]
    assert line in speed.text(trade_of(*rows))


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
