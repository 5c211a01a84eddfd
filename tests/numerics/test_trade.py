"""Speed against accuracy: judging, timing by a planted clock, leads, what is recorded, and the command."""

import math
import re
from dataclasses import replace
from types import SimpleNamespace

import pytest
from flint import arb
from planted_trades import MACHINE, run, trade_of

from numerics import OutOfRange
from numerics.arithmetic.ball import Ball
from numerics.trade import contenders, measure, scenes
from numerics.trade.comparisons.switched import PeerFailed
from numerics.trade.contenders import CONTENDERS, answer_of, contender, looked_at
from numerics.trade.figure import draw_trade
from numerics.trade.judge import judge, proved
from numerics.trade.recorded import SHIPPED, Sweep, UnreadableTrade, recorded

SCENE = scenes.benchmark(scenes.HEADLINE)
TRUTH = proved(SCENE)
COUNT, MODES, TIMES, FINAL = len(TRUTH.times), list(TRUTH.modes), list(TRUTH.times), list(TRUTH.final)
GAP = min(TIMES[4] - TIMES[3], TIMES[5] - TIMES[4])

# judging


@pytest.mark.parametrize(("label", "setting", "least"), [("solve", 0, 13), ("solve", 20, 20), ("ball", 500, 500)])
def test_our_floats_and_balls_have_the_digits_of_their_arithmetic(label, setting, least):
    found = answer_of(contender(label).prepare(SCENE, setting)())
    verdict = judge(found, proved(SCENE, setting), SCENE, setting)
    assert verdict.difference is None
    assert least < verdict.digits < least + 40


def moved(by):
    """The true times but for the fifth."""
    return [*TIMES[:4], TIMES[4] + by, *TIMES[5:]]


@pytest.mark.parametrize(
    ("said", "changed"),
    [
        (f"{COUNT - 1} events, not {COUNT}", {"modes": MODES[:-1], "times": TIMES[:-1]}),
        (f"segment 1 is slip-, not {'slip+' if MODES[0] > 0 else 'stick'}", {"modes": [-1, *MODES[1:]]}),
        ("its neighbour", {"times": moved(GAP * 0.51)}),
        ("off by nan s", {"times": moved(math.nan)}),
        (None, {"times": moved(GAP * 0.49)}),
    ],
)
def test_a_wrong_itinerary_is_named(said, changed):
    difference = judge(replace(TRUTH, **changed), TRUTH, SCENE).difference
    assert said in difference if said else difference is None


def test_errors_are_those_that_were_planted():
    length = float(SCENE.pair.half_width)
    x1, v1, x2, v2 = FINAL
    with Ball(60).context():
        rows = (
            ({"final": (x1 + arb(0.001 * length), v1, x2, v2)}, 3),
            ({"final": (x1, v1, x2, v2 - arb(0.01 * length * 10))}, 2),
            ({"times": (*TIMES[:-1], TIMES[-1] * (1 - arb(1e-7)))}, 7),
            ({"lost": TRUTH.lost * (1 + arb("1e-30"))}, 30),
        )
    for changed, digits in rows:
        assert judge(replace(TRUTH, **changed), TRUTH, SCENE).digits == pytest.approx(digits, abs=1e-3)
    wide = replace(TRUTH, final=(x1 + arb("[0 +/- 5e-6]"), v1, x2, v2))
    assert judge(TRUTH, wide, SCENE).digits == pytest.approx(3, abs=0.01)


# what is timed, and how


def test_the_call_that_is_timed_solves_again_and_makes_what_a_user_looks_at(monkeypatch):
    calls, read, solve = [], [], contenders.solve
    monkeypatch.setattr(contenders, "solve", lambda *a, **k: calls.append(1) or solve(*a, **k))
    call = contender("solve").prepare(SCENE, 0)
    assert call() is not call()
    assert len(calls) == 2

    class Lazy:
        def __getattr__(self, name):
            read.append(name)

    looked_at(Lazy())
    assert {"t", "y", "modes"} <= set(read)


@pytest.fixture
def call(monkeypatch):
    """What makes a call that takes so long at a time; the clock goes on only then."""
    clock = SimpleNamespace(now=0.0, process_time=lambda: clock.now)
    monkeypatch.setattr(measure, "time", clock)

    def taking(*durations):
        left = iter(durations)

        def one():
            clock.now += next(left, durations[-1])

        return one

    return taking


def test_two_calls_are_timed_in_turn_and_compared_by_their_medians(call):
    order, slow = [], call(3e-3)
    quick = call(*[1e-3] * 3, *[1e-4] * 2, *[9e-2] * 2, 1e-3)  # the first sets ten at once; some are outliers
    ratio = measure.in_turns(lambda: order.append("a") or quick(), lambda: order.append("b") or slow(), 0.25)
    assert ratio == pytest.approx(3)
    assert "".join(order[2:]) == "aaaaaaaaaabbb" * 14


def measured(prepare):
    one = contender("heyoka")._replace(prepare=lambda *_: prepare())
    return measure.judged_and_timed(one, 1e-9, SCENE, TRUTH, lambda: None, 0.1)


def test_what_is_found_is_judged_and_timed_beside_solve(monkeypatch):
    monkeypatch.setattr(measure, "in_turns", lambda base, call, _: 2.0 if call() is TRUTH else 0.0)
    ratio, digits, note = measured(lambda: lambda: TRUTH)
    assert (ratio, digits > 30, note) == (2.0, True, "")
    assert "events, not" in measured(lambda: lambda: replace(TRUTH, modes=MODES[:-1], times=TIMES[:-1]))[2]


@pytest.mark.parametrize("error", [PeerFailed, OutOfRange])
def test_a_contender_that_fails_leaves_a_note(error):
    def prepare():
        raise error("no step is small enough")

    assert measured(prepare) == (None, None, "no answer: no step is small enough")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["forced-stick-slip", "forced-friction", "velocities"])
def test_a_sweep_has_the_digits_of_both(name):
    if missing := contender("heyoka").missing():
        pytest.skip(missing)
    found = measure.swept(name, 3, 0.0)
    assert found.ratio > 0
    assert found.peer_wrong == (name == "forced-friction")
    assert min(found.digits, found.peer_digits) > 7


# what is recorded

PEERS = [("heyoka", 2e-3, 9.0), ("heyoka", 5e-3, 15.0), ("heyoka", 9e-3, 16.0), ("heyoka", 1e-9, 30.0, False)]


def test_the_public_interface_is_held_against_what_is_as_accurate():
    some = [run(who, "velocities", *rest) for who, *rest in PEERS]
    assert trade_of(*some).beside("velocities", 0).ratio == pytest.approx(5)
    assert trade_of(*some).beside("velocities", 12) is None
    less = trade_of(some[0])
    assert less.beside("velocities", 0).peer.digits == 9.0
    assert less.beside("relative-motion-b05", 0) is None
    assert less.ratios() == {"`solve(scene)`, without a force": {"velocities": pytest.approx(2)}}


def test_of_two_arithmetics_the_faster_counts_that_has_the_digits_asked_for():
    ours = run("solve", "velocities", 1e-3, 20.5, asked=20)
    double, longer = run("heyoka", "velocities", 1e-4, 14.0), run("heyoka long double", "velocities", 4e-3, 17.0)
    found = trade_of(ours, double, longer)
    assert found.beside("velocities", 0).ratio == pytest.approx(0.1)
    assert found.beside("velocities", 20).ratio == pytest.approx(4)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("", "is no output of"),
        (trade_of(machine={}).text(), "no runs or no machine"),
        (trade_of().text().replace("14.5", '"soon"'), "could not convert"),
    ],
)
def test_a_wrong_file_is_named_with_what_is_wrong(tmp_path, content, said):
    (tmp_path / "wrong.json").write_text(content)
    with pytest.raises(UnreadableTrade, match=rf"^wrong\.json .*{said}"):
        recorded(tmp_path / "wrong.json")
    with pytest.raises(UnreadableTrade, match=r"nowhere\.json cannot be read: No such file"):
        recorded(tmp_path / "nowhere.json")


def test_the_shipped_one_is_small_names_no_place_and_no_day_and_is_drawn():
    text, found = SHIPPED.read_text("utf-8"), recorded()
    assert len(text) < 20_000
    assert not re.search(
        r"(?<![\w.])/(home|root|tmp|opt|usr|work|var|nix|Users)/|[A-Z]:\\\\|\b20\d\d-\d\d-\d\d\b", text
    )
    assert found.text() == text
    assert set(found.machine) == {*MACHINE, "busy"} == set(measure.machine())
    assert len(draw_trade(found).axes) == len(found.scenes)
    assert {one.who for one in found.runs} == {one.label for one in CONTENDERS}
    assert all(one.digits and one.peer_digits for one in found.sweeps)
    assert [one for one in found.runs if one.ours and one.right is not True] == []


# the command


@pytest.fixture
def planted_answers(monkeypatch):
    monkeypatch.setattr(measure, "judged_and_timed", lambda *_: (2.0, 9.0, ""))
    monkeypatch.setattr(measure, "total_time", lambda call, loops: 1e-3 * loops)
    monkeypatch.setattr(measure, "swept", lambda name, size, _: Sweep(name, 30.0, size, 11.0, 13.5))
    monkeypatch.setattr(measure, "proved", lambda _: None)
    absent = CONTENDERS[0]._replace(label="absent tool", package="a-package-that-nobody-has")
    some = (contender("solve"), contender("heyoka")._replace(package=""), contender("forward Euler"), absent)
    monkeypatch.setattr(contenders, "CONTENDERS", some)
    monkeypatch.setattr(measure, "contender", {one.label: one for one in some}.get)


@pytest.mark.usefixtures("planted_answers")
def test_the_whole_command_with_planted_answers(output, record, tmp_path):
    found = record("trade", "--size", "small", "--only", "free", "--out", tmp_path / "trade.png")
    assert found["left_out"]["absent tool"] == "a-package-that-nobody-has (extra `comparisons`)"
    assert list(found["scenes"]) == ["relative-motion-b05", "near-critical-1e-6"]
    assert list(dict.fromkeys(row[1] for row in found["runs"])) == ["solve", "heyoka", "forward Euler"]
    assert [row[2] for row in found["runs"][:3]] == [0, 12, 20]
    assert list(found) == ["command", "machine", "left_out", "scenes", "sweeps", "runs"]
    assert [path.name for path in tmp_path.iterdir()] == ["trade.png"]
    printed = output("trade", "--size", "small", "--only", "Euler", "absent", "b05")
    assert "left out: absent tool: needs a-package-that-nobody-has" in printed
    assert "2 ms" in printed
    assert "near-critical" not in printed
    printed = output("trade", "--size", "small", "--interface")
    assert "solve(scene), without a force: relative-motion-b05 1, near-critical-1e-6 1" in printed
    assert "forced-stick-slip, 20 scenes in one call: 30, 11 digits; heyoka 13.5 digits, 0 scenes wrong" in printed
    assert "forward Euler" not in printed
