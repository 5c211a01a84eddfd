"""Contenders in processes of their own: what hangs, dies, refuses or chatters costs its own rows only."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from trade_outcomes import QUICK, SCENE

from numerics.trade import scenes
from numerics.trade.child import Child
from numerics.trade.measure import Limits, References, Status, measure, run
from numerics.trade.plan import SIZES, trade
from numerics.trade.table import as_record, print_trade

ROOT = Path(__file__).resolve().parent.parent.parent
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


@pytest.fixture
def planted(tmp_path, monkeypatch):
    (tmp_path / "planted_contenders.py").write_text(PLANTED, "utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    paths = [str(tmp_path), str(ROOT), os.environ.get("PYTHONPATH", "")]
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(path for path in paths if path))
    import planted_contenders

    yield {one.label: one for one in planted_contenders.unloved()}
    del sys.modules["planted_contenders"]


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

    def test_without_process_groups_a_busy_worker_is_ended_all_the_same(self, planted, monkeypatch):
        monkeypatch.delattr(os, "killpg", raising=False)  # as on Windows
        self.test_the_end_of_the_block_ends_a_busy_worker(planted)

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


class TestTime:
    def test_when_the_time_of_a_size_is_up_nothing_more_is_begun(self, planted, monkeypatch):
        monkeypatch.setitem(SIZES, "small", replace(SIZES["small"], whole=0.0))
        found = trade("small", ["b05"], contenders=[planted["hang"]], source=TestChild.SOURCE)
        assert {one.ran.status for one in found.measurements} == {Status.NOT_TRIED}
        assert "time for this size was up" in found.measurements[0].ran.note
