"""The chapter on speed says what the record says: planted records in which a peer wins, fails, or did not take part."""

from __future__ import annotations

import re

import pytest
from planted_trades import run, trade_of

from numerics.scene.file import load_scene
from numerics.trade.euler import EulerFigure, EulerOutcome
from numerics.trade.recorded import recorded
from paper_checks.report.content.blocks import Points, Section, Table
from paper_checks.report.formats.html_blocks import HtmlWriter
from paper_checks.report.formats.latex_blocks import LatexWriter
from paper_checks.report.formats.markdown import markdown
from paper_checks.speed import section

EULER = EulerFigure(7, (EulerOutcome(1e-2, False, -1.0, 0), EulerOutcome(1e-3, True, 2.5, 1040)))


@pytest.fixture(autouse=True)
def planted_euler(monkeypatch):
    monkeypatch.setattr(section, "euler_figures", lambda: {"9": EULER})
    monkeypatch.setattr(section, "stick_energy", lambda step: (2.0, 2.1))


def lines(*runs, **more):
    """The list at the start of the chapter."""
    return next(one for one in section.section(trade_of(*runs, **more)).blocks if isinstance(one, Points)).items


class TestWhoIsFaster:
    def test_free_forced_and_with_more_digits_come_first(self):
        forced = [run("solve", "forced-touch", 1e-2, 14.0), run("heyoka", "forced-touch", 1e-4, 12.0)]
        free, under, more, *_ = lines(
            *forced, run("heyoka", "velocities", 1e-2, 12.0), run("Fine", "velocities", 5e-3, 20.0)
        )
        assert free == (
            "Without a force, ours is the fastest on all 1 scenes where a peer has the events right: "
            "at least 10 times as fast as heyoka, on velocities."
        )
        assert under.startswith("Under a force, ours is beaten on 1 of 1 scenes")
        assert under.endswith("by heyoka, by a factor of up to 100.")
        assert more.endswith(
            "is beaten on 1 of 1 scenes where a peer has the events right, by Fine, by a factor of up to 2."
        )

    def test_the_least_lead_of_all_scenes_is_told(self):
        peers = [
            run("A", "velocities", 4e-3, 9.0),
            run("B", "relative-motion-b05", 2e-3, 9.0),
            run("C", "velocities", 1e-6, 9.0, False),
        ]
        assert "at least 2 times as fast as B, on relative-motion-b05." in lines(*peers)[0]

    def test_a_peer_that_is_more_accurate_than_all_of_ours_wins(self):
        assert lines(run("Fine", "velocities", 1.0, 99.0))[2].endswith(
            "by Fine; on velocities nobody of ours is as accurate."
        )

    def test_nobody_to_compare_with_is_said(self):
        assert all("no peer was measured" in line for line in lines()[:3])


def test_wrong_events_are_counted_and_ours_are_named():
    wrong = run("solve", "velocities", 1e-3, 2.0, False), run("Peer", "velocities", None, None, None)
    text = " ".join(lines(*wrong))
    assert "Of 7 runs that ended 1 have the events wrong; never one of ball." in text
    assert "Ours is wrong: solve with 0 digits on velocities (1 events, not 24)." in text


def test_a_cell_says_what_is_right_and_the_time_beside_ours():
    trade = trade_of(
        run("Peer", "velocities", 2e-3, 12.0),
        run("Peer", "velocities", 1e-3, 3.0, False),
        run("Hung", "velocities", None, None, None),
        run("Wrong", "velocities", 1e-3, 3.0, False),
    )
    cells = {who: section.cell(trade, "velocities", who) for who in ("solve", "Peer", "Hung", "Wrong", "Nobody")}
    assert cells == {"solve": "1/1: 14, 1 ms", "Peer": "1/2: 12, 2×", "Hung": "stopped", "Wrong": "0/1", "Nobody": "–"}


def test_costs_and_horizons_are_those_of_the_record():
    far = [run("solve", "long-100", 1e-4, 9.0), run("solve", "long-10000", 2e-2, 9.0)]
    text = " ".join(lines(*far))
    assert "`solve(scene)` takes 1 ms and has 14 digits right; balls take 10 ms with 15 digits asked for" in text
    assert "An excursion costs 1 us where there are 100, and 2 us where there are 10,000." in text


def test_the_machine_what_was_left_out_and_forward_euler_are_told():
    text = markdown(section.section(trade_of(left_out={"heyoka": "heyoka (extra)"})))
    assert (
        "Measured once: Abacus, 2 cores, load 0.1, Python 3.11, numpy 2. Left out: heyoka (needs heyoka (extra))."
        in text
    )
    assert "2 (by theory 2.1) with 0.01 s" in text
    assert "| Fig. 9 | 7 | 0.001 | 0.001 | finer than tried | 0 | 1,040 |" in text


def test_the_shipped_record_is_told_in_every_form():
    whole = section.section(recorded())
    tables = [one for one in whole.blocks if isinstance(one, Table)]
    assert {len(row) for one in tables[:1] for row in one.rows} == {len(tables[0].head)}
    assert HtmlWriter({}).section(whole).count("<table") == len(tables) == 3
    assert LatexWriter({}).section(whole).count(r"\begin{longtable}") == 3
    assert not re.search(r"\bnan\b|\bNone\b|\binf\b", markdown(whole))
    assert set(whole.pictures) == set(section.figures(recorded()))


def test_every_figure_has_its_scene():
    assert all(load_scene(name).until > 0 for name in section.EULER_SCENES.values())


def test_hostile_texts_are_escaped():
    hostile = trade_of(left_out={"<b>&": "%_<"})
    page = HtmlWriter({}).section(Section("x", "x", tuple(section.provenance(hostile))))
    assert "<b>" not in page
    assert r"\%\_\textless{}" in LatexWriter({}).section(Section("x", "x", tuple(section.provenance(hostile))))
