"""The chapter on speed says what the record says: planted records in which a peer wins, fails, or did not take part."""

import re
from html import unescape

import pytest
from planted_trades import run, trade_of

from numerics.trade.euler import EulerFigure, EulerOutcome
from numerics.trade.recorded import recorded
from paper_checks.report.content import speed
from paper_checks.report.content.blocks import Points, Section, Table
from paper_checks.report.formats.html_blocks import HtmlWriter
from paper_checks.report.formats.latex_blocks import LatexWriter

EULER = EulerFigure(7, (EulerOutcome(1e-2, False, -1.0, 0), EulerOutcome(1e-3, True, 2.5, 1040)))


@pytest.fixture(autouse=True)
def planted_euler(monkeypatch):
    monkeypatch.setattr(speed, "euler_figures", lambda: {"9": EULER})
    monkeypatch.setattr(speed, "stick_energy", lambda step: (2.0, 2.1))


def told(*runs, **more):
    """The list at the start of the chapter."""
    return next(one for one in speed.section(trade_of(*runs, **more)).blocks if isinstance(one, Points)).items


def text_of(some: Section) -> str:
    return unescape(HtmlWriter({}, {}).section(some))


OURS = run("solve", "velocities", 2e-3, 14.0, asked=12)
"""Asked for 12 digits."""
LINES = {
    "the one that is as accurate as ours": (
        0,
        [run("heyoka", "velocities", 1e-2, 12.0), run("heyoka", "velocities", 2e-2, 15.0)],
        "Without a force, ours is 20 times as fast on the one scene, velocities.",
    ),
    "under a force": (
        1,
        [run("solve", "forced-touch", 1e-2, 14.0), run("heyoka", "forced-touch", 1e-4, 14.0)],
        "Under a force, heyoka is 100 times as fast on the one scene, forced-touch.",
    ),
    "where both win some both are said": (
        0,
        [run("heyoka", "velocities", 4e-3, 15.0), run("heyoka", "relative-motion-b05", 5e-4, 15.0)],
        "Without a force, heyoka wins on 1 of 2 scenes, by up to 2 times (on relative-motion-b05); "
        "ours wins on 1, by up to 4 times; in the median ours is 2.25 times as fast.",
    ),
    "who is slower where digits are asked for says so at once": (
        0,
        [OURS, run("heyoka long double", "velocities", 1e-3, 18.0)],
        "Without a force, ours is 1 times as fast on the one scene, velocities."
        " Asked for 12 digits, heyoka wins on 1 of 1 scenes; in the median heyoka is 2 times as fast.",
    ),
}


@pytest.mark.parametrize("case", LINES)
def test_who_is_faster_comes_first(case):
    place, runs, line = LINES[case]
    assert told(*runs)[place] == line


def test_wrong_events_are_counted_and_ours_are_named():
    wrong = run("solve", "velocities", 1e-3, 2.0, False), run("Peer", "velocities", None, None, None)
    text = " ".join(told(*wrong))
    assert "Of 7 runs that ended 1 have the events wrong; never one of ball." in text
    assert "Ours is wrong: solve with 0 digits on velocities (1 events, not 24)." in text


def test_the_shipped_record_is_told_in_every_form():
    whole = speed.section(recorded())
    tables = [one for one in whole.blocks if isinstance(one, Table)]
    assert all({len(row) for row in one.rows} == {len(one.head)} for one in tables)
    assert HtmlWriter({}, {}).section(whole).count("<table") == len(tables) == 2
    assert LatexWriter({}, (), ()).body(whole.blocks).count(r"\begin{longtable}") == 2
    assert not re.search(r"\bnan\b|\bNone\b|\binf\b", text_of(whole))
    assert set(whole.pictures) == set(speed.figures(recorded()))
    assert all("heyoka" in one or "ours wins on all" in one or "ours is" in one for one in speed.answers(recorded()))
