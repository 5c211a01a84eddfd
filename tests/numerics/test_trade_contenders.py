"""Ours and the peers as the trade calls them, and what a user waits for beside the run inside."""

from __future__ import annotations

import io
import json
import time
from dataclasses import replace

import numpy as np
import pytest
from trade_outcomes import SCENE, floats_of, ours

from numerics.__main__ import main
from numerics.trade import front, reference, scenes
from numerics.trade.comparisons.heyoka_tuned import TunedHeyokaPeer
from numerics.trade.comparisons.peer import PeerRun, Unsupported
from numerics.trade.contender import all_contenders, labelled, peer_outcome
from numerics.trade.front import Point
from numerics.trade.interface import Wait, in_turns
from numerics.trade.judge import judge
from numerics.trade.measure import SOURCE
from numerics.trade.ours import BALL, COMPILED, MANY, MPMATH, READ, our_contenders
from numerics.trade.worker import Worker


class TestPeers:
    @pytest.mark.parametrize(
        ("precision", "setting", "error"), [("long double", 1e-21, -16), ("quadruple", 1e-34, -31), ("real", 50.0, -47)]
    )
    def test_a_peer_finer_than_floats_is_judged_by_all_its_digits(self, precision, setting, error):
        peer = TunedHeyokaPeer(precision)
        if peer.missing():
            pytest.skip(peer.missing())
        digits = max(60, reference.digits_for(peer.knob, setting))
        proved = reference.proved(SCENE.scene, digits)
        run = peer.prepare(SCENE.scene, setting)()
        assert judge(peer_outcome(run), proved, digits, SCENE.scene).error < error
        floored = judge(peer_outcome(replace(run, texts=None)), proved, digits, SCENE.scene)
        assert -18 < floored.error < -15

    def test_a_run_that_measured_itself_is_timed_by_its_own_clock(self, monkeypatch):
        answer = PeerRun((), np.zeros(0), np.zeros(4), 0.0, 1, elapsed=1.5)

        class SelfTimed:
            name, use, knob, settings, forced = "self-timed", "", "step (s)", (1.0,), False

            def missing(self):
                return None

            def prepare(self, scene, setting):
                return lambda: (time.sleep(0.005), answer)[1]

        monkeypatch.setattr("numerics.trade.contender.all_contenders", lambda: labelled([SelfTimed()]))
        channel = io.StringIO()
        asked = {"source": SOURCE, "contender": "self-timed", "scene": scenes.scene_as_record(SCENE.scene)}
        Worker(channel).answer(asked | {"setting": 1.0, "budget": 0.01})
        told = {row["stage"]: row for row in map(json.loads, channel.getvalue().splitlines())}
        assert told["ran"]["seconds"] == told["timed"]["seconds"] == 1.5
        assert told["timed"]["batches"] >= 1


class TestOurs:
    @pytest.mark.parametrize("label", [one.label for one in our_contenders() if one.knob == "bits"])
    @pytest.mark.parametrize("scene", [SCENE, scenes.near_critical("0.00158", "1e-3")], ids=["headline", "on its ray"])
    def test_every_call_gives_the_same_answer(self, label, scene):
        one = ours(label)
        if one.missing():
            pytest.skip(one.missing())
        run = one.prepare(scene.scene, 53.0)()
        found = judge(one.outcome(run), reference.proved(scene.scene), 40, scene.scene)
        assert found.right
        assert found.error < -12

    def test_a_batch_of_binary_numbers_is_no_near_critical_scene(self):
        with pytest.raises(Unsupported, match="no binary numbers"):
            ours(MANY).make(scenes.near_critical("5e-8", "1e-12").scene, 53.0)

    def test_what_runs_inside_leads_nobody(self):
        slow, quick = Point(READ, True, 53, 1.0, -10, True), Point(COMPILED, True, 53, 0.1, -10, True)
        (lead,) = front.leads([slow, quick, Point("peer", False, 1, 2.0, -9, True)])
        assert (lead.ratio, lead.ratio_inside) == (2.0, 20.0)


class TestInterface:
    def test_calls_are_timed_in_turn_and_held_against_what_is_asked(self):
        order = []
        took = in_turns({"a": lambda: order.append("a"), "b": lambda: (order.append("b"), time.sleep(0.003))}, 0.01)
        assert took["b"] > 0.002 > took["a"] > 0
        assert "".join(order).count("ab") > 2
        assert [Wait("x", 1.0, most=most).kept for most in (None, 0.5, 2.0)] == [None, False, True]
        assert Wait("x", 1.0, "y", 3.0, 2.0).kept is False

    def test_the_command_prints_what_the_issue_names(self, monkeypatch, capsys):
        monkeypatch.setattr("numerics.trade.interface._PEERS", {})
        monkeypatch.setattr("numerics.trade.interface.first_compilation", lambda: 1.0)
        assert main(["trade", "--interface", "--json"]) == 0
        calls = {one["call"]: one for one in json.loads(capsys.readouterr().out)}
        for name in ("the run inside", "solve(scene)", "solver(state, until)", "solve_many, one scene"):
            assert calls[name]["seconds"] > 0
        assert calls["solve(scene)"]["most"] == 6


class TestForced:
    def test_nobody_is_asked_for_what_it_is_not_made_for(self):
        free, forced = SCENE, scenes.forced_scenes()[0]
        for one in all_contenders():
            assert one.takes(free.scene) or one.takes(forced.scene)
        both = {one.label for one in all_contenders() if one.takes(free.scene) and one.takes(forced.scene)}
        assert {READ, BALL, MPMATH} <= both
        assert all(one.ours for one in all_contenders() if one.label in both)

    def test_under_a_force_our_floats_are_right_by_the_proved_reference(self):
        scene = scenes.forced_scenes()[0].scene
        found = judge(floats_of(scene), reference.proved(scene), 40, scene)
        assert found.right
        assert found.error < -12

    def test_lost_work_is_seen_under_a_force(self):
        scene = scenes.forced_scenes()[0].scene
        truth = reference.proved(scene)
        short = replace(floats_of(scene), dissipated="0.0028")
        assert judge(short, truth, 40, scene).energy > -2
