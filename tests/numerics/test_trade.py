"""Speed against accuracy: judging, the front, children that hang or die, and the command; no time is asserted."""

from __future__ import annotations

import io
import json
import math
import os
import subprocess
import sys
import time
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from numerics.__main__ import main
from numerics.scene import Pair, Scene, State
from numerics.scene.file import load_scene
from numerics.trade import front, reference, scenes
from numerics.trade.child import Child
from numerics.trade.clock import median_time
from numerics.trade.comparisons.heyoka_tuned import TunedHeyokaPeer
from numerics.trade.comparisons.peer import PeerRun, Unsupported
from numerics.trade.contender import all_contenders, labelled, peer_outcome
from numerics.trade.front import Point
from numerics.trade.interface import Wait, in_turns
from numerics.trade.judge import judge
from numerics.trade.measure import SOURCE, Limits, References, Status, measure, run
from numerics.trade.ours import BALL, COMPILED, MANY, MPMATH, READ, Ours, our_contenders, solved
from numerics.trade.outcome import Outcome, float_text
from numerics.trade.plan import SIZES, NoSuchContender, selected, settings, trade
from numerics.trade.table import as_record, print_trade
from numerics.trade.worker import Worker

ROOT = Path(__file__).resolve().parent.parent.parent
QUICK = Limits(prepare=60, run=20, budget=0.01)
SCENE = scenes.Benchmark("headline", "", load_scene(scenes.HEADLINE))

PLANTED = """
import os, time
from numerics.trade.ours import BALL, our_contenders

class Planted:
    ours, use, knob, settings = False, "", "bits", (1.0, 2.0)
    good = next(one for one in our_contenders() if one.label == BALL)
    def __init__(self, label, call):
        self.label = self.name = label
        self.call = call
    def missing(self):
        return None
    def takes(self, scene):
        return not scene.is_forced
    def prepare(self, scene, setting):
        good = self.good.prepare(scene, 20.0)
        return lambda: self.call(good)
    def outcome(self, run):
        return self.good.outcome(run)

def hang(good):
    time.sleep(600)

def die(good):
    os.write(2, b"a last word\\n")
    os.abort()

def refuse(good):
    raise ArithmeticError("no step is small enough")

def eat(good):
    raise MemoryError

def chatter(good):
    print("this must not reach the channel")
    os.write(1, b"nor this")
    return good()

def unloved():
    return [Planted(call.__name__, call) for call in (hang, die, refuse, eat, chatter)]
"""


def ours(label: str) -> Ours:
    return next(one for one in our_contenders() if one.label == label)


def floats_of(scene: Scene) -> Outcome:
    return ours(READ).outcome(solved(None)(scene, 53.0)())


def balls_of(scene: Scene, digits: int) -> Outcome:
    return ours(BALL).outcome(solved("ball")(scene, float(digits))())


@pytest.fixture
def planted(tmp_path, monkeypatch):
    (tmp_path / "planted_contenders.py").write_text(PLANTED, "utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    paths = [str(tmp_path), str(ROOT), os.environ.get("PYTHONPATH", "")]
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(path for path in paths if path))
    import planted_contenders

    yield {one.label: one for one in planted_contenders.unloved()}
    del sys.modules["planted_contenders"]


@pytest.fixture(scope="module")
def proved() -> Outcome:
    return reference.proved(SCENE.scene)


@pytest.fixture(scope="module")
def floats() -> Outcome:
    return floats_of(SCENE.scene)


class TestJudge:
    def test_our_floats_are_right_to_float_accuracy(self, floats, proved):
        found = judge(floats, proved, 40, SCENE.scene)
        assert found.right
        assert found.difference is None
        assert found.error < -13

    def test_a_missing_event_is_seen(self, floats, proved):
        short = replace(floats, kinds=floats.kinds[:-1], times=floats.times[:-1])
        found = judge(short, proved, 40, SCENE.scene)
        assert not found.right
        assert found.difference == f"{len(floats.kinds) - 1} events, not {len(floats.kinds)}"

    def test_exchanged_kinds_are_seen(self, floats, proved):
        at = floats.kinds.index("nx")
        exchanged = floats.kinds[:at] + "xn" + floats.kinds[at + 2 :]
        found = judge(replace(floats, kinds=exchanged), proved, 40, SCENE.scene)
        assert found.difference == f"event {at + 1} is exit, not entry"

    def test_a_time_beyond_half_the_gap_is_seen(self, floats, proved):
        gap = min(floats.times[4] - floats.times[3], floats.times[5] - floats.times[4])
        for share, right in ((0.49, True), (0.51, False), (math.nan, False)):
            moved = [*floats.times[:4], floats.times[4] + share * gap, *floats.times[5:]]
            assert judge(replace(floats, times=moved), proved, 40, SCENE.scene).right is right

    def test_errors_are_those_that_were_planted(self, proved):
        pair = SCENE.scene.pair
        L, Omega = pair.half_width, 10
        exact = balls_of(SCENE.scene, 40)
        assert judge(exact, proved, 40, SCENE.scene).error < -40
        x1, v1, x2, v2 = (Fraction(text) for text in exact.final)
        moved = [x1 + L / 1000, v1, x2, v2 - 2 * L * Omega / 100]
        found = judge(replace(exact, final=[_decimal(value) for value in moved]), proved, 40, SCENE.scene)
        assert found.state == pytest.approx(math.log10(0.02))
        lost = Fraction(exact.dissipated) * (1 + Fraction(1, 10**30))
        found = judge(replace(exact, dissipated=_decimal(lost)), proved, 40, SCENE.scene)
        assert found.energy == pytest.approx(-30)
        late = Fraction(exact.last_event) * (1 - Fraction(1, 10**7))
        assert judge(replace(exact, last_event=_decimal(late)), proved, 40, SCENE.scene).error == pytest.approx(-7)

    def test_errors_far_below_the_range_of_a_float_are_numbers(self):
        found = judge(balls_of(SCENE.scene, 500), reference.proved(SCENE.scene, 530), 530, SCENE.scene)
        assert -530 < found.error < -500

    def test_no_number_is_an_infinite_error_and_nothing_to_compare_is_none(self, floats, proved):
        broken = replace(floats, final=[float_text(math.nan), *floats.final[1:]], last_event=None)
        found = judge(broken, proved, 40, SCENE.scene)
        assert (found.state, found.last_event, found.error) == (math.inf, math.inf, math.inf)
        assert json.dumps(found.as_record(), allow_nan=False)
        rest = Scene(Pair(1, 1, 200, "0.5"), State(x1="0.001"), until=1)
        still = judge(floats_of(rest), reference.proved(rest), 40, rest)
        assert still.right
        assert still.last_event is None
        assert still.energy is None
        assert still.error < -13


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


def _decimal(value: Fraction) -> str:
    """Return a rational with 60 digits after the point."""
    return f"{round(value * 10**60)}e-60"


class TestFront:
    POINTS = (
        Point("ours", True, 1, 1.0, -10.0, True),
        Point("ours", True, 2, 2.0, -20.0, True),
        Point("fast but wrong", False, 1, 0.1, -10.0, False),
        Point("beaten", False, 1, 3.0, -15.0, True),
        Point("equal", False, 1, 2.0, -20.0, True),
        Point("coarse and fast", False, 1, 0.5, -3.0, True),
        Point("finest", False, 1, 9.0, -30.0, True),
    )

    def test_front_keeps_what_no_right_run_beats(self):
        names = [(one.contender, one.setting) for one in front.best_front(self.POINTS)]
        assert names == [("coarse and fast", 1), ("ours", 1), ("ours", 2), ("equal", 1), ("finest", 1)]

    def test_lead_is_over_runs_that_are_no_less_accurate(self):
        ratios = {one.peer.contender: one.ratio for one in front.leads(self.POINTS)}
        expected = {"fast but wrong": 0.1, "beaten": 1.5, "equal": 1.0, "coarse and fast": 0.5, "finest": None}
        assert ratios == expected


class TestChild:
    SOURCE = "planted_contenders:unloved"

    def test_a_hanging_one_is_stopped_and_no_finer_setting_tried(self, planted):
        with Child() as child, Child() as prover:
            references = References(prover, 60)
            limits = Limits(prepare=60, run=0.3, budget=0.01)
            found = measure(child, references, planted["hang"], SCENE, (1.0, 2.0), limits, self.SOURCE)
        assert [one.ran.status for one in found] == [Status.STOPPED, Status.NOT_TRIED]
        assert [one.ran.note for one in found] == [
            "stopped after 0.3 s of running",
            "a coarser setting was stopped after 0.3 s of running",
        ]

    def test_failures_are_shown_and_the_next_request_is_answered(self, planted):
        with Child() as child:
            ran = {name: run(child, self.SOURCE, name, SCENE, 1.0, QUICK) for name in ("die", "refuse", "eat")}
            after = run(child, self.SOURCE, "chatter", SCENE, 1.0, QUICK)
        assert {one.status for one in ran.values()} == {Status.FAILED}
        assert "SIGABRT" in ran["die"].note
        assert ran["refuse"].note == "ArithmeticError: no step is small enough"
        assert ran["eat"].note == "out of memory"
        assert after.status is Status.MEASURED
        assert after.batches > 0
        assert len(after.outcome.kinds) == 32

    def test_the_end_of_the_block_ends_a_busy_worker(self, planted):
        with Child() as child:
            child.ask(_request("hang", self.SOURCE))
            assert child.answer(60)["stage"] == "prepared"
            process = child._process
        assert process.poll() is not None

    def test_a_worker_whose_parent_is_gone_ends_itself(self, planted):
        with subprocess.Popen(
            [sys.executable, "-m", "numerics.trade.worker"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,
        ) as worker:
            worker.stdin.write(json.dumps(_request("hang", self.SOURCE)) + "\n")
            worker.stdin.flush()
            assert json.loads(worker.stdout.readline())["stage"] == "prepared"
            worker.stdin.close()
            assert worker.wait(timeout=30) < 0

    def test_a_whole_table_survives_them_all(self, planted, monkeypatch, capsys):
        monkeypatch.setitem(SIZES, "small", replace(SIZES["small"], limits=Limits(prepare=60, run=1, budget=0.01)))
        found = trade("small", ["b05"], contenders=list(planted.values()), source=self.SOURCE)
        print_trade(found, 200)
        printed = capsys.readouterr().out
        for text in ("stopped after 1 s", "SIGABRT", "no step is small enough", "out of memory", "right"):
            assert text in printed
        record = as_record(found)
        assert json.dumps(record, allow_nan=False)
        assert {row["status"] for row in record["runs"]} == {"stopped", "not tried", "failed", "measured"}
        assert record["growth"] == []


def _request(name: str, source: str) -> dict[str, object]:
    scene = scenes.scene_as_record(SCENE.scene)
    return {"source": source, "contender": name, "scene": scene, "setting": 1.0, "budget": 0}


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


class TestTime:
    def test_when_the_time_of_a_size_is_up_nothing_more_is_begun(self, planted, monkeypatch):
        monkeypatch.setitem(SIZES, "small", replace(SIZES["small"], whole=0.0))
        found = trade("small", ["b05"], contenders=[planted["hang"]], source=TestChild.SOURCE)
        assert {one.ran.status for one in found.measurements} == {Status.NOT_TRIED}
        assert "time for this size was up" in found.measurements[0].ran.note


class TestScenes:
    def test_a_scene_crosses_processes_exactly(self):
        for one in [*scenes.benchmarks(10), scenes.of_mass_ratio(Fraction(1, 10**12))]:
            record = json.loads(json.dumps(scenes.scene_as_record(one.scene)))
            assert scenes.scene_from_record(record) == one.scene

    @pytest.mark.parametrize(("speed", "excess"), [("0.00158", "1e-3"), ("5e-5", "1e-6"), ("5e-8", "1e-12")])
    def test_near_critical_scenes_have_the_excess_of_their_name(self, speed, excess):
        scene = scenes.near_critical(speed, excess).scene
        assert float(scene.energy_excess) == pytest.approx(float(excess), rel=2e-3)
        kinds = floats_of(scene).kinds
        assert kinds == "nx" * scenes.EXCURSIONS + "n"

    def test_no_event_falls_on_a_horizon(self):
        for one in scenes.benchmarks(20):
            times = (balls_of(one.scene, 15) if one.scene.is_forced else floats_of(one.scene)).times
            assert float(one.scene.until) - times[-1] > 1e-6


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


class TestPlan:
    def test_only_selects_contenders_and_scenes(self):
        everyone, some = [ours(READ), ours(BALL), ours(MPMATH)], scenes.benchmarks(5)
        kept, all_scenes = selected(everyone, some, ["BALL"])
        assert [one.label for one in kept] == ["ball"]
        assert all_scenes == some
        kept, few = selected(everyone, some, ["long", "solve"])
        assert [one.label for one in kept] == [READ]
        assert [one.name for one in few] == ["long-5"]
        with pytest.raises(NoSuchContender, match="'wrong' fits no contender"):
            selected(everyone, some, ["wrong"])

    def test_sizes_go_further_and_further(self):
        most = [settings(ours(BALL), SIZES[name])[-1] for name in ("small", "default", "large")]
        assert most == [100, 10_000, 10_000]

    def test_two_uses_of_one_tool_are_told_apart(self):
        class Tool:
            name, knob, settings = "tool", "tol", (1.0,)

            def __init__(self, use):
                self.use = use

        labels = [one.label for one in all_contenders()]
        assert len(set(labels)) == len(labels)
        assert [one.label for one in labelled([Tool("plain"), Tool("best, and more")])] == [
            "tool (plain)",
            "tool (best)",
        ]
        assert [one.label for one in labelled([Tool("plain")])] == ["tool"]

    def test_the_clock_takes_the_median_of_warm_calls(self):
        calls = []
        found = median_time(lambda: calls.append(1), 1e-3, 0.01)
        assert found.batches >= 1
        assert 0 < found.seconds < 1e-3
        assert len(calls) > found.batches


class TestCommand:
    def test_small_runs_end_to_end_and_names_what_is_missing(self, monkeypatch, capsys, tmp_path):
        class Absent(Ours):
            ours = False

            def missing(self):
                return "a package that nobody has"

        everyone = [ours(READ), ours(BALL), Absent("absent tool", solved(None))]
        monkeypatch.setattr("numerics.trade.plan.all_contenders", lambda: everyone)
        figure = tmp_path / "trade.png"
        assert (
            main(["trade", "--size", "small", "--only", "solve", "absent", "b05", "--json", "--out", str(figure)]) == 0
        )
        record = json.loads(capsys.readouterr().out)
        assert record["left_out"] == [{"contender": "absent tool", "missing": "a package that nobody has"}]
        (row,) = record["runs"]
        assert row["contender"] == READ
        assert row["right"]
        assert row["log10_error"] < -13
        assert row["seconds"] > 0
        assert {one["axis"] for one in record["growth"]} >= {"events", "m1/m2"}
        assert not any(one["note"] for one in record["growth"] if one["axis"] != "batch")
        assert set(record["machine"]) == {"processor", "cores", "system", "python", "packages"}
        assert sorted(path.name for path in tmp_path.iterdir()) == ["trade-growth.png", "trade.png"]
        assert main(["trade", "--size", "small", "--only", "absent", "b05"]) == 0
        assert "left out: absent tool: needs a package that nobody has" in capsys.readouterr().out

    @pytest.mark.parametrize(
        ("arguments", "message"),
        [
            (["--only", "nobody at all"], "fits no contender"),
            (["--out", "figure.jpeg"], "must end in one of"),
            (["--out", "no-such-folder/figure.png"], "does not exist"),
        ],
    )
    def test_wrong_use_is_answered_in_one_line(self, arguments, message, capsys):
        assert main(["trade", *arguments]) == 2
        error = capsys.readouterr().err
        assert message in error
        assert error.count("\n") == 1
