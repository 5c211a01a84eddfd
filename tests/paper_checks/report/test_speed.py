"""The chapter on speed says what the record says: planted records in which a peer wins, fails, or did not take part."""

import re
from html import unescape

import pytest
from planted_trades import row, trade_of

from numerics.trade.recorded import recorded
from paper_checks.report.content import euler_lessons, speed
from paper_checks.report.content.blocks import Points, Table
from paper_checks.report.formats.html import fragment


@pytest.fixture(autouse=True)
def planted_euler(monkeypatch):
    monkeypatch.setattr(euler_lessons, "blocks", tuple)


def told(*rows):
    """The list at the start of the chapter."""
    return next(one for one in speed.section(trade_of(*rows)).blocks if isinstance(one, Points)).items


LINES = {
    "nobody took part": ([], "No other program was measured."),
    "ours wins": (
        [row("heyoka", "velocities", 10.0, 12.0), row("heyoka", "velocities", 20.0, 15.0)],
        "On all 1 scenes float64 is faster than heyoka, by at least 20 times (on velocities); in the median float64 is "
        "20 times as fast.",
    ),
    "where both win some the loss is said": (
        [row("heyoka", "velocities", 4.0), row("heyoka", "relative-motion-b05", 0.5)],
        "On 1 of 2 scenes heyoka is faster than float64, by up to 2 times (on relative-motion-b05); in the median "
        "float64 is 2.25 times as fast.",
    ),
    "a wrong run does not count": (
        [row("heyoka", "velocities", 0.1, 16.0, "event 3")],
        "No other program was measured.",
    ),
}


@pytest.mark.parametrize("case", LINES)
def test_who_is_faster_comes_first(case):
    rows, line = LINES[case]
    assert told(*rows)[0] == line


def test_a_scene_on_which_float64_has_no_answer_is_named():
    refused = row("float64", "velocities", 1.0)._replace(seconds=None, ratio=None)
    assert not any("no answer" in one for one in told())
    assert told(refused)[1].startswith("On velocities float64 has no answer")


def test_what_proved_digits_cost_is_said():
    assert told()[1].endswith("15 cost 100 times.")


def test_wrong_events_are_counted_and_ours_are_named():
    wrong = row("float64", "velocities", 1.0, 2.0, "event 4", 0), row("Peer", "velocities", 1.0)._replace(seconds=None)
    text = " ".join(told(*wrong))
    assert "Of 7 runs that ended 1 have an event wrong; never one of balls." in text
    assert "Ours is wrong: float64 with 0 digits on velocities (event 4)." in text


def test_the_shipped_record_is_told():
    whole = speed.section(recorded())
    tables = [one for one in whole.blocks if isinstance(one, Table)]
    assert all({len(row) for row in one.rows} == {len(one.head)} for one in tables)
    text = unescape(fragment(whole.blocks))
    assert text.count("<table") == len(tables) == 1
    assert not re.search(r"\bnan\b|\bNone\b|\binf\b", text)
    assert set(whole.pictures) == set(speed.figures(recorded()))
