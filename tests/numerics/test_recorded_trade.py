"""A recorded trade is read as it was measured; a wrong file gets one clear line; the shipped one names no place."""

from __future__ import annotations

import json
import math
import re

import pytest
from planted_trades import COMPILED, READ, SCENES, growth, our_runs, planted, record, run, with_forced

from numerics.trade.figure import draw_growth, draw_trade, families
from numerics.trade.front import best_front
from numerics.trade.interface import Wait
from numerics.trade.plan import trade
from numerics.trade.recorded import SHIPPED, SHIPPED_FORCED, UnreadableTrade, divided, recorded
from numerics.trade.table import as_record


def test_the_shipped_trade_is_read_and_drawn():
    found = recorded()
    assert {"processor", "cores", "python", "packages"} <= set(found.machine)
    assert all(best_front(found.points(scene)) for scene in found.scenes)
    assert len(draw_trade(found).axes) >= len(found.scenes)
    assert draw_growth(found).axes


def test_no_panel_has_more_than_six_marks_each_with_its_name():
    found = recorded()
    assert len(set(families(found).values())) <= 6
    for figure in (draw_trade(found), draw_growth(found)):
        drawn = [panel for panel in figure.axes if panel.lines]
        assert drawn
        for panel in drawn:
            assert panel.get_title()
            names = [text.get_text() for text in panel.texts]
            marks = {(line.get_marker(), line.get_color()) for line in panel.lines if line.get_marker() != "."}
            assert 1 <= len(marks) <= 6
            assert len(names) == len(set(names)) >= len(marks)


@pytest.mark.parametrize("file", [SHIPPED, SHIPPED_FORCED])
def test_the_shipped_trade_names_no_place_and_no_day(file):
    text = file.read_text("utf-8")
    assert not re.search(r"(?<![\w.])/(home|root|tmp|opt|usr|work|var|nix|Users)/|[A-Z]:\\\\", text)
    assert not re.search(r"\b20\d\d-\d\d-\d\d\b", text)
    named = {"processor", "cores", "system", "python", "packages"}
    assert named <= set(json.loads(text)["machine"]) <= {*named, "load"}


def test_free_scenes_and_those_under_a_force_are_told_apart(tmp_path):
    both = planted(tmp_path, run("ball", "forced-touch", 2e-3, -15.0), scenes=with_forced())
    free, forced = divided(both)
    assert [one.name for one in forced.scenes] == ["forced-touch"]
    assert [one.contender for one in forced.runs] == ["ball"]
    assert {one.scene for one in free.runs} == {one.name for one in free.scenes} == set(SCENES)
    assert free.growth == both.growth
    assert not forced.growth
    assert divided(forced) == (recorded(), forced)
    assert divided(free)[1] == recorded(SHIPPED_FORCED)


@pytest.mark.slow
def test_a_fresh_trade_comes_back_as_it_was(tmp_path):
    fresh = trade("small", only=("float64, pure Python", "relative-motion-b05"))
    path = tmp_path / "fresh.json"
    path.write_text(json.dumps(as_record(fresh)), "utf-8")
    back = recorded(path)
    assert back.machine == fresh.machine
    assert [one.name for one in back.scenes] == [one.name for one in fresh.scenes]
    assert back.points(back.scenes[0]) == fresh.points(fresh.scenes[0])
    assert list(back.growth) == fresh.growth


def test_an_error_that_is_no_number_and_a_run_without_end_are_kept_apart(tmp_path):
    lost = run("Peer", "velocities", 1e-3, "inf", right=False, difference="0 events, not 24")
    stopped = run("Peer", "velocities", None)
    found = planted(tmp_path, lost, stopped)
    points = [one for one in found.points(found.scenes[0]) if one.contender == "Peer"]
    assert [(one.error, one.right) for one in points] == [(math.inf, False)]
    assert found.runs[-1].right is None


def test_only_right_peers_can_lead_or_be_led(tmp_path):
    wrong = run("Wrong", "velocities", 1e-9, -30.0, right=False, difference="1 event, not 24")
    right = run("Right", "velocities", 1e-3, -3.0)
    found = planted(tmp_path, wrong, right)
    (lead,) = found.leads(found.scenes[0])
    assert (lead.peer.contender, lead.ours.contender, lead.ratio) == ("Right", READ, 2.0)
    assert (lead.inside.contender, round(lead.ratio_inside)) == (COMPILED, 250)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is no JSON"),
        ("[1, 2]", "is no output of"),
        ("{}", "'machine' is missing"),
        (json.dumps(record(runs=[])), "no scenes or no runs"),
        (json.dumps(record(runs=[{**our_runs()[0], "seconds": "soon"}])), "could not convert"),
        (json.dumps(record(growth=[{"axis": "digits"}])), "is no output of"),
        (json.dumps({key: value for key, value in record().items() if key != "growth"}), "'growth' is missing"),
    ],
)
def test_a_wrong_file_is_named_with_what_is_wrong(tmp_path, text, said):
    path = tmp_path / "wrong.json"
    path.write_text(text, "utf-8")
    with pytest.raises(UnreadableTrade, match=said) as caught:
        recorded(path)
    assert str(caught.value).startswith("wrong.json ")


def test_a_missing_or_binary_file_is_named(tmp_path):
    with pytest.raises(UnreadableTrade, match=r"nowhere\.json cannot be read: No such file"):
        recorded(tmp_path / "nowhere.json")
    (tmp_path / "binary.json").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(UnreadableTrade, match="it is no text"):
        recorded(tmp_path / "binary.json")


def test_what_a_user_waits_for_comes_back_and_an_older_record_has_none(tmp_path):
    waits = [Wait("solve(scene)", 2e-5, "the run inside", 4.0, 6.0), Wait("solve_many, one scene", 2e-4, most=6e-5)]
    back = planted(tmp_path, interface=[one.as_record() for one in waits]).interface
    assert list(back) == waits
    assert [one.kept for one in back] == [True, False]
    assert planted(tmp_path).interface == ()


def test_growth_knows_only_its_own_fields(tmp_path):
    more = [{**one, "sine_cosines_per_event": 3.0, "unknown": 1} for one in growth()]
    assert list(planted(tmp_path, growth=more).growth) == list(planted(tmp_path).growth)
