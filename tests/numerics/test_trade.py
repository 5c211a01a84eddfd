"""Speed against accuracy: judging, timing by a planted clock, leads, processes that hang or die, and the command."""

from __future__ import annotations

import json
import math
import re
import sys
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, fmpq
from planted_trades import MACHINE, run, trade_of

from numerics.__main__ import main
from numerics.arithmetic.ball import Ball
from numerics.trade import contenders, fresh, interface, measure, scenes
from numerics.trade.comparisons.peer import PeerFailed, PeerRun
from numerics.trade.contenders import CONTENDERS, answer_of, contender, looked_at
from numerics.trade.figure import draw_trade
from numerics.trade.judge import as_arb, judge, proved
from numerics.trade.recorded import SHIPPED, UnreadableTrade, recorded

SCENE = scenes.benchmark(scenes.HEADLINE)


@pytest.fixture(scope="module")
def truth() -> PeerRun:
    return proved(SCENE)


@pytest.fixture
def clock(monkeypatch):
    """A clock that goes on only when it is told to."""

    class Clock:
        now = 0.0

        def perf_counter(self):
            return self.now

        def call(self, *durations):
            left = iter(durations)

            def one():
                self.now += next(left, durations[-1])

            return one

    planted_clock = Clock()
    monkeypatch.setattr(fresh, "time", planted_clock)
    monkeypatch.setattr(interface, "time", planted_clock)
    return planted_clock


class TestJudge:
    def test_our_floats_and_balls_have_the_digits_of_their_arithmetic(self, truth):
        for label, setting, least in (("solve", 0, 13), ("ball", 500, 500)):
            found = answer_of(contender(label).prepare(SCENE, setting)())
            verdict = judge(found, proved(SCENE, setting), SCENE, setting)
            assert verdict.difference is None
            assert least < verdict.digits < least + 40

    def test_a_wrong_itinerary_is_named(self, truth):
        count, modes, times = len(truth.times), truth.modes, truth.times
        gap = min(times[4] - times[3], times[5] - times[4])
        wrong = {
            f"{count - 1} events, not {count}": replace(truth, modes=modes[:-1], times=times[:-1]),
            f"segment 1 is slip-, not {'slip+' if modes[0] > 0 else 'stick'}": replace(truth, modes=(-1, *modes[1:])),
            "its neighbour": replace(truth, times=(*times[:4], times[4] + gap * 0.51, *times[5:])),
            " nan s off": replace(truth, times=(*times[:4], math.nan, *times[5:])),
        }
        for said, found in wrong.items():
            assert said in judge(found, truth, SCENE).difference
        late = replace(truth, times=(*times[:4], times[4] + gap * 0.49, *times[5:]))
        assert judge(late, truth, SCENE).difference is None

    def test_errors_are_those_that_were_planted(self, truth):
        length, last = SCENE.pair.half_width, truth.times[-1]
        x1, v1, x2, v2 = truth.final
        with Ball(60).context():
            rows = (
                (replace(truth, final=(x1 + arb(0.001 * float(length)), v1, x2, v2)), 3),
                (replace(truth, final=(x1, v1, x2, v2 - arb(0.01 * float(length * 10)))), 2),
                (replace(truth, times=(*truth.times[:-1], last * (1 - arb(1e-7)))), 7),
                (replace(truth, lost=truth.lost * (1 + arb("1e-30"))), 30),
            )
        for found, digits in rows:
            assert judge(found, truth, SCENE).digits == pytest.approx(digits, abs=1e-3)

    def test_the_radius_of_the_reference_is_part_of_the_error(self, truth):
        wide = replace(truth, final=(truth.final[0] + arb("[0 +/- 5e-6]"), *truth.final[1:]))
        assert judge(truth, wide, SCENE).digits == pytest.approx(3, abs=0.01)

    def test_a_number_of_any_arithmetic_is_taken_exactly(self):
        third = np.longdouble(1) / 3
        for value in (0.1, third, (0.1, 1e-20)):
            exact = sum(map(Fraction, value)) if isinstance(value, tuple) else Fraction(*value.as_integer_ratio())
            with Ball(80).context():
                assert as_arb(value) == arb(fmpq(exact.numerator, exact.denominator))


class TestOurs:
    def test_the_call_that_is_timed_solves_again(self, monkeypatch):
        calls, solve = [], contenders.solve
        monkeypatch.setattr(contenders, "solve", lambda *a, **k: calls.append(1) or solve(*a, **k))
        call = contender("solve").prepare(SCENE, 0)
        assert call() is not call()
        assert len(calls) == 2

    def test_what_a_user_looks_at_is_made_while_the_clock_runs(self):
        read = []

        class Lazy:
            def __getattr__(self, name):
                read.append(name)

        looked_at(Lazy())
        assert {"t", "y", "modes"} <= set(read)


class TestTime:
    def measured(self, monkeypatch, call, runner=None):
        monkeypatch.setattr(fresh, "answer_of", lambda _: PeerRun((0,), (), (0.0,) * 4, 0.0))
        monkeypatch.setattr(fresh, "proved", lambda *_: PeerRun((0,), (), (0.0,) * 4, 0.0))
        monkeypatch.setattr(fresh, "contender", lambda _: replace(CONTENDERS[0], prepare=lambda *_: call))
        return fresh.measured("solve", scenes.HEADLINE, 0, runner)

    def test_the_time_is_pyperf_s_median_of_all_processes(self, monkeypatch, clock):
        pyperf = pytest.importorskip("pyperf")

        class Runner:
            args = type("Args", (), {"worker": False, "loops": 0})()

            def bench_time_func(self, name, timed):
                values = [timed(1) for _ in range(5)]
                return pyperf.Benchmark([pyperf.Run(values, collect_metadata=False, metadata={"name": name})])

        found = self.measured(monkeypatch, clock.call(9.0, 1e-4, 1e-3, 2e-3, 3e-3, 5e-3, 9e-3), Runner())
        assert found["seconds"] == pytest.approx(3e-3)
        assert found["deviation"] == pytest.approx(2e-3)
        assert Runner.args.loops == 100
        Runner.args.worker = True
        assert self.measured(monkeypatch, clock.call(1e-3), Runner()) == {}

    def test_a_slow_call_is_measured_by_its_second_run(self, monkeypatch, clock):
        found = self.measured(monkeypatch, clock.call(50.0, 7.0))
        assert found == {"difference": None, "digits": pytest.approx(1e6), "seconds": 7.0}

    def test_two_calls_are_timed_in_turn_and_compared_by_their_medians(self, clock):
        order, slow = [], clock.call(3e-3)
        quick = clock.call(*[1e-3] * 4, *[1e-4] * 2, *[9e-2] * 2, 1e-3)  # two at once make a batch; two are outliers
        ratio = interface.in_turns(lambda: order.append("a") or quick(), lambda: order.append("b") or slow(), 0.25)
        assert ratio == pytest.approx(3)
        assert "".join(order[4:]).count("aab") > 4


class TestProcesses:
    def test_what_hangs_or_dies_is_an_answer(self):
        hangs, dies, speaks = (
            f"import os; {one}" for one in ("import time; time.sleep(600)", "os.abort()", "print('{')")
        )
        assert measure.answered([sys.executable, "-c", hangs], 0.3) == {"note": "stopped after 0.3 s"}
        for code in (dies, speaks):
            assert measure.answered([sys.executable, "-c", code], 600)["note"].startswith("ended with code")

    @pytest.mark.long
    def test_a_fresh_process_judges_and_refuses(self):
        size = measure.Size((), 2, 600)
        *_, found = measure.runs_of(contender("forward Euler"), scenes.HEADLINE, size)
        assert found.right
        assert found.digits > 1
        *_, refused = measure.runs_of(contender("forward Euler"), "forced-jumps", size)
        assert refused.right is None
        assert "for free pairs" in refused.note


class TestRecorded:
    def test_a_lead_is_over_right_runs_and_by_ours_that_are_no_less_accurate(self):
        peers = [("wrong", 1e-9, 30.0, False), ("coarse", 1e-4, 3.0), ("fine", 1e-1, 20.0), ("finest", 1.0, 90.0)]
        found = trade_of(*(run(who, "velocities", *rest) for who, *rest in peers)).leads("velocities")
        ratios = {one.peer.who: (one.ours and one.ours.who, one.ratio) for one in found}
        assert ratios == {"finest": (None, 0.0), "coarse": ("solve", 0.1), "fine": ("ball", 10.0)}

    @pytest.mark.parametrize(
        ("content", "said"),
        [
            (b"", "is no output of"),
            (b"{}", "'columns' is missing"),
            (trade_of(machine={}).text().encode(), "no runs or no machine"),
            (trade_of().text().replace("0.001", '"soon"').encode(), "could not convert"),
        ],
    )
    def test_a_wrong_file_is_named_with_what_is_wrong(self, tmp_path, content, said):
        (tmp_path / "wrong.json").write_bytes(content)
        with pytest.raises(UnreadableTrade, match=said) as caught:
            recorded(tmp_path / "wrong.json")
        assert str(caught.value).startswith("wrong.json ")
        with pytest.raises(UnreadableTrade, match=r"nowhere\.json cannot be read: No such file"):
            recorded(tmp_path / "nowhere.json")

    def test_the_shipped_one_is_small_names_no_place_and_no_day_and_is_drawn(self):
        text = SHIPPED.read_text("utf-8")
        assert len(text) < 40_000
        assert not re.search(
            r"(?<![\w.])/(home|root|tmp|opt|usr|work|var|nix|Users)/|[A-Z]:\\\\|\b20\d\d-\d\d-\d\d\b", text
        )
        assert set(recorded().machine) <= {*MACHINE, "system"}
        assert len(draw_trade(recorded()).axes) == len(recorded().scenes) + 1


class TestCommand:
    def test_the_whole_command_with_planted_answers(self, monkeypatch, capsys, tmp_path):
        monkeypatch.setattr(measure, "answered", lambda *_: {"difference": None, "digits": 9.0, "seconds": 2e-3})
        absent = replace(CONTENDERS[0], label="absent tool", package="a-package-that-nobody-has")
        monkeypatch.setattr(measure, "CONTENDERS", (contender("solve"), contender("forward Euler"), absent))
        arguments = ["trade", "--size", "small", "--only", "free", "--json", "--out", str(tmp_path / "trade.png")]
        assert main(arguments) == 0
        record = json.loads(capsys.readouterr().out)
        assert record["left_out"]["absent tool"] == "a-package-that-nobody-has (extra `comparisons`)"
        assert list(record["scenes"]) == ["relative-motion-b05", "near-critical-1e-6"]
        assert {one[1] for one in record["runs"]} == {"solve", "forward Euler"}
        assert [path.name for path in tmp_path.iterdir()] == ["trade.png"]
        assert main(["trade", "--size", "small", "--only", "Euler", "absent", "b05"]) == 0
        printed = capsys.readouterr().out
        assert "left out: absent tool: needs a-package-that-nobody-has" in printed
        assert "2 ms" in printed

    @pytest.mark.parametrize(
        ("arguments", "message"),
        [
            (["--only", "nobody at all"], "fits no contender"),
            (["--out", "no-such-folder/figure.png"], "does not exist"),
        ],
    )
    def test_wrong_use_is_answered_in_one_line(self, arguments, message, capsys):
        assert main(["trade", *arguments]) == 2
        error = capsys.readouterr().err
        assert message in error
        assert error.count("\n") == 1

    def test_a_peer_that_fails_leaves_a_note(self, monkeypatch, capsys, tmp_path):
        monkeypatch.setattr(fresh, "measured", lambda *_: (_ for _ in ()).throw(PeerFailed("no step is small enough")))
        monkeypatch.setattr(fresh, "find_spec", lambda _: None)
        monkeypatch.setattr(sys, "argv", ["fresh", "heyoka", "velocities", "1"])
        fresh.main()
        assert json.loads(capsys.readouterr().out)["note"] == "PeerFailed: no step is small enough"
