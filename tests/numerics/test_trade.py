"""Speed against accuracy: judging, timing by a planted clock, leads, what is recorded, and the command."""

import math
import re
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, fmpq
from planted_trades import MACHINE, run, trade_of

from numerics import OutOfRange
from numerics.arithmetic.ball import Ball
from numerics.trade import contenders, measure, scenes
from numerics.trade.comparisons.peer import PeerFailed, PeerRun
from numerics.trade.contenders import CONTENDERS, answer_of, contender, looked_at
from numerics.trade.figure import draw_trade
from numerics.trade.judge import as_arb, judge, proved
from numerics.trade.recorded import SHIPPED, Sweep, UnreadableTrade, recorded

SCENE = scenes.benchmark(scenes.HEADLINE)


@pytest.fixture(scope="module")
def truth() -> PeerRun:
    return proved(SCENE)


@pytest.fixture
def clock(monkeypatch):
    """A clock that goes on only when it is told to."""

    class Clock:
        now = 0.0

        def process_time(self):
            return self.now

        def call(self, *durations):
            left = iter(durations)

            def one():
                self.now += next(left, durations[-1])

            return one

    planted_clock = Clock()
    monkeypatch.setattr(measure, "time", planted_clock)
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
    def test_two_calls_are_timed_in_turn_and_compared_by_their_medians(self, clock):
        order, slow = [], clock.call(3e-3)
        quick = clock.call(*[1e-3] * 3, *[1e-4] * 2, *[9e-2] * 2, 1e-3)  # two at once make a batch; two are outliers
        ratio = measure.in_turns(lambda: order.append("a") or quick(), lambda: order.append("b") or slow(), 0.25)
        assert ratio == pytest.approx(3)
        assert "".join(order[2:]).count("aab") > 4

    def test_a_slow_call_is_timed_once(self, clock):
        assert measure.in_turns(clock.call(1e-3), clock.call(50.0, 7.0), 0.1) == pytest.approx(7e3)

    def test_what_is_found_is_judged_and_timed_beside_solve(self, monkeypatch, truth):
        monkeypatch.setattr(measure, "in_turns", lambda base, call, _: 2.0 if call() is truth else 0.0)
        one = contender("heyoka")._replace(prepare=lambda *_: lambda: truth)
        found = measure.judged_and_timed(one, 1e-9, SCENE, truth, lambda: None, 0.1)
        assert (found[0], found[2]) == (2.0, "")
        wrong = replace(truth, modes=truth.modes[:-1], times=truth.times[:-1])
        one = one._replace(prepare=lambda *_: lambda: wrong)
        assert "events, not" in measure.judged_and_timed(one, 1e-9, SCENE, truth, lambda: None, 0.1)[2]

    @pytest.mark.parametrize("error", [PeerFailed, OutOfRange])
    def test_a_contender_that_fails_leaves_a_note(self, error, truth):
        def prepare(*_):
            raise error("no step is small enough")

        one = contender("heyoka")._replace(prepare=prepare)
        found = measure.judged_and_timed(one, 1.0, SCENE, truth, lambda: None, 0.1)
        assert found == (None, None, "no answer: no step is small enough")

    def test_what_a_contender_cannot_run_is_noted(self):
        for found in measure.runs_on("state-weakening", [contender("SciPy DOP853, events")], 0.0):
            assert found.right is None
            assert "for a surface only" in found.note

    @pytest.mark.slow
    def test_a_sweep_has_the_digits_of_both(self):
        if missing := contender("heyoka").missing():
            pytest.skip(missing)
        found = measure.swept("forced-stick-slip", 3, 0.0)
        assert found.ratio > 0
        assert min(found.digits, found.peer_digits) > 7


class TestRecorded:
    def test_the_public_interface_is_held_against_what_is_as_accurate(self):
        peers = [("heyoka", 2e-3, 9.0), ("heyoka", 5e-3, 15.0), ("heyoka", 9e-3, 16.0), ("heyoka", 1e-9, 30.0, False)]
        found = trade_of(*(run(who, "velocities", *rest) for who, *rest in peers))
        assert found.beside("velocities", 0).ratio == pytest.approx(5)
        assert found.beside("velocities", 12) is None
        less = trade_of(*(run(who, "velocities", *rest) for who, *rest in peers[:1]))
        assert less.beside("velocities", 0).peer.digits == 9.0
        assert less.beside("relative-motion-b05", 0) is None
        assert less.ratios() == {"`solve(scene)`, without a force": {"velocities": pytest.approx(2)}}

    def test_of_two_arithmetics_the_faster_counts_that_has_the_digits_asked_for(self):
        ours = run("solve", "velocities", 1e-3, 20.5)._replace(setting=20.0)
        double, longer = run("heyoka", "velocities", 1e-4, 14.0), run("heyoka long double", "velocities", 4e-3, 17.0)
        found = trade_of(ours, double, longer)
        assert found.beside("velocities", 0).ratio == pytest.approx(0.1)
        assert found.beside("velocities", 20).ratio == pytest.approx(4)

    def test_what_is_written_is_read_again(self, tmp_path):
        sweep = Sweep("velocities", 30.0, 100, 11.0, 13.5)
        peers = [run("heyoka", "velocities", 2e-3, 9.0), run("SciPy", "velocities", None, None, None)]
        given = trade_of(*peers, run("heyoka", "velocities", 3e-3, 1.0, False), sweeps=(sweep,))
        (tmp_path / "trade.json").write_text(given.text(), "utf-8")
        found = recorded(tmp_path / "trade.json")
        assert found.sweeps == (sweep,)
        assert set(found.runs) == set(given.runs)
        assert replace(found, runs=given.runs) == given

    @pytest.mark.parametrize(
        ("content", "said"),
        [
            (b"", "is no output of"),
            (b"{}", "'runs' is missing"),
            (trade_of(machine={}).text().encode(), "no runs or no machine"),
            (trade_of().text().replace("14.5", '"soon"').encode(), "could not convert"),
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
        assert len(text) < 20_000
        assert not re.search(
            r"(?<![\w.])/(home|root|tmp|opt|usr|work|var|nix|Users)/|[A-Z]:\\\\|\b20\d\d-\d\d-\d\d\b", text
        )
        found = recorded()
        assert set(found.machine) == {*MACHINE, "busy"}
        panels = draw_trade(found).axes
        assert len(panels) == len(found.scenes)
        for one in panels:  # no mark is cut by the frame
            marks = [one.transData.transform((1, y))[1] for line in one.lines for y in line.get_ydata()]
            assert one.bbox.y0 + 4 < min(marks) < max(marks) < one.bbox.y1 - 4
        assert {one.who for one in found.runs} == {one.label for one in CONTENDERS}
        assert all(one.digits and one.peer_digits for one in found.sweeps)

    def test_the_shipped_one_has_no_wrong_events_of_ours(self):
        assert [one for one in recorded().runs if one.ours and one.right is not True] == []


class TestCommand:
    @pytest.fixture
    def planted(self, monkeypatch):
        monkeypatch.setattr(measure, "judged_and_timed", lambda *_: (2.0, 9.0, ""))
        monkeypatch.setattr(measure, "total_time", lambda call, loops: 1e-3 * loops)
        monkeypatch.setattr(measure, "swept", lambda name, size, _: Sweep(name, 30.0, size, 11.0, 13.5))
        monkeypatch.setattr(measure, "proved", lambda _: None)
        absent = CONTENDERS[0]._replace(label="absent tool", package="a-package-that-nobody-has")
        some = (contender("solve"), contender("heyoka")._replace(package=""), contender("forward Euler"), absent)
        monkeypatch.setattr(contenders, "CONTENDERS", some)
        monkeypatch.setattr(measure, "contender", {one.label: one for one in some}.get)

    @pytest.mark.usefixtures("planted")
    def test_the_whole_command_with_planted_answers(self, output, record, tmp_path):
        found = record("trade", "--size", "small", "--only", "free", "--out", tmp_path / "trade.png")
        assert found["left_out"]["absent tool"] == "a-package-that-nobody-has (extra `comparisons`)"
        assert list(found["scenes"]) == ["relative-motion-b05", "near-critical-1e-6"]
        assert list(dict.fromkeys(row[1] for row in found["runs"])) == ["solve", "heyoka", "forward Euler"]
        assert [path.name for path in tmp_path.iterdir()] == ["trade.png"]
        printed = output("trade", "--size", "small", "--only", "Euler", "absent", "b05")
        assert "left out: absent tool: needs a-package-that-nobody-has" in printed
        assert "2 ms" in printed

    @pytest.mark.usefixtures("planted")
    def test_the_public_interface_alone(self, output):
        printed = output("trade", "--size", "small", "--interface")
        assert "solve(scene), without a force: relative-motion-b05 1, near-critical-1e-6 1" in printed
        assert "forced-stick-slip, 20 at once: 30, 11 and 13.5 digits, 0 wrong" in printed
        assert "forward Euler" not in printed

    @pytest.mark.parametrize(
        ("arguments", "message"),
        [
            (["--only", "nobody at all"], "fits no contender"),
            (["--out", "no-such-folder/figure.png"], "does not exist"),
        ],
    )
    def test_wrong_use_is_answered_in_one_line(self, arguments, message, run):
        code, _, error = run("trade", *arguments)
        assert (code, message in error, error.count("\n")) == (2, True, 1)
