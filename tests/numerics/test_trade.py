"""Time against accuracy: judging by planted faults, timing by a planted clock, leads, what is recorded, the command."""

import math
import re
from types import SimpleNamespace

import pytest
from flint import arb
from planted_trades import MACHINE, row, trade_of

from numerics import OutOfRange, load_scene
from numerics.arithmetic.ball import Ball
from numerics.trade import contenders, measure
from numerics.trade import judge as judging
from numerics.trade.contenders import CONTENDERS, contender
from numerics.trade.figure import draw_trade
from numerics.trade.judge import judge, proved
from numerics.trade.recorded import SHIPPED, UnreadableTrade, recorded

SCENE = load_scene("relative-motion-b05")
TRUTH = proved(SCENE)
COUNT, MODES, TIMES = len(TRUTH.times), list(TRUTH.modes), list(TRUTH.times)
GAP = min(TIMES[4] - TIMES[3], TIMES[5] - TIMES[4])

# judging


@pytest.mark.parametrize(("name", "setting", "least"), [("float64", 0, 13), ("balls", 20, 20), ("balls", 500, 500)])
def test_our_floats_and_balls_have_the_digits_of_their_arithmetic(name, setting, least):
    verdict = judge(contender(name).prepare(SCENE, setting)(), proved(SCENE, setting), setting)
    assert verdict[:3] == (COUNT, 0, 0)
    assert verdict.note == ""
    assert all(least < digits < least + 40 for digits in (verdict.time_digits, verdict.state_digits))


def moved(by):
    """The true times but for the fifth."""
    return TRUTH._replace(times=[*TIMES[:4], TIMES[4] + by, *TIMES[5:]])


def without(start, stop):
    """The true run without some of its events."""
    kept = [k for k in range(COUNT) if not start <= k < stop]
    modes, states = (
        [MODES[0], *(MODES[k + 1] for k in kept)],
        [TRUTH.states[k] for k in (0, *(k + 1 for k in kept), -1)],
    )
    return TRUTH._replace(modes=modes, times=[TIMES[k] for k in kept], states=states)


OTHER = {"slip+": "slip-", "slip-": "slip+", "stick": "slip+"}
PLANTED = {
    "none": (TRUTH, (COUNT, 0, 0), ""),
    "a late event that is still its own": (moved(GAP * 0.49), (COUNT, 0, 0), ""),
    "an event nearer to another's place": (moved(GAP * 0.51), (COUNT - 1, 1, 1), "event 5: .* in truth"),
    "an event without a time": (moved(math.nan), (COUNT - 1, 1, 1), "event 5: .* at nan s; in truth"),
    "the last event is lost": (without(COUNT - 1, COUNT), (COUNT - 1, 1, 0), f"event {COUNT}: .* to the end; in truth"),
    "a short slip is lost": (without(10, 12), (COUNT - 2, 2, 0), "event 11: "),
    "the wrong side": (
        TRUTH._replace(modes=[*MODES[:3], OTHER[MODES[3]], *MODES[4:]]),
        (COUNT - 2, 2, 2),
        f"event 3: {MODES[2]} to {OTHER[MODES[3]]} ",
    ),
    "an event too many": (  # planted shortly after the last one
        TRUTH._replace(
            modes=[*MODES, OTHER[MODES[-1]]],
            times=[*TIMES, TIMES[-1] + GAP / 9],
            states=TRUTH.states[[*range(COUNT + 2), -1]],
        ),
        (COUNT, 0, 1),
        f"event {COUNT + 1}: .* in truth {MODES[-1]} to the end",
    ),
}


@pytest.mark.parametrize("fault", PLANTED)
def test_events_are_found_missed_or_extra_and_the_first_wrong_one_is_named(fault):
    run, counts, said = PLANTED[fault]
    verdict = judge(run, TRUTH)
    assert verdict[:3] == counts
    assert re.match(said, verdict.note) if said else verdict.note == ""


def test_a_run_that_sticks_where_it_slips_is_wrong_without_any_event():
    calm = TRUTH._replace(modes=["stick"], times=[], states=TRUTH.states[[0, -1]])
    assert judge(calm._replace(modes=["slip+"]), calm).note == "event 1: slip+ to the end; in truth stick to the end"


def test_errors_are_those_that_were_planted():
    with Ball(60).context():
        far, fast = (max(abs(x.mid()) for x in TRUTH.states[:, k::2].flat) for k in (0, 1))
        for place, size, digits in ((0, far, 3), (1, fast, 2), (2, far, 5), (3, fast, 4)):
            for event in (7, -1):
                states = TRUTH.states.copy()
                states[event, place] += size * arb(f"1e-{digits}")
                assert judge(TRUTH._replace(states=states), TRUTH).state_digits == pytest.approx(digits, abs=1e-3)
        late = judge(TRUTH._replace(times=[*TIMES[:-1], TIMES[-1] * (1 - arb(1e-7))]), TRUTH)
        assert late.time_digits == pytest.approx(7, abs=1e-3)
        wide = TRUTH._replace(states=TRUTH.states + arb(0, far * arb("1e-3")))
    assert judge(TRUTH, wide).state_digits == pytest.approx(3, abs=0.01)  # what is not known is an error


# timing


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
    ours, theirs = measure.in_turns(lambda: order.append("a") or quick(), lambda: order.append("b") or slow())
    assert theirs / ours == pytest.approx(3)
    assert "".join(order[2:]) == "aaaaaaaaaabbb" * 6


def test_the_call_that_is_timed_solves_again_and_makes_what_a_user_looks_at(monkeypatch):
    calls, solve = [], contenders.solve
    monkeypatch.setattr(contenders, "solve", lambda *a, **k: calls.append(1) or solve(*a, **k))
    call = contender("float64").prepare(SCENE, 0)
    assert call() is not call()
    assert len(calls) == 2
    assert judging.looked_at(solve(SCENE)).states.shape == (COUNT + 2, 4)


@pytest.mark.parametrize("stage", [0, 1])
def test_a_contender_that_fails_leaves_a_note(stage):
    def fail():
        raise OutOfRange("no step is small enough")

    found = [*measure.measured((lambda: fail, fail)[stage], TRUTH, None, 0)]
    assert found == [None, None, None, None, 0, 0, 0, "no step is small enough"]


# what is recorded


def test_the_lead_is_over_the_fastest_that_is_as_accurate_or_the_most_accurate():
    rows = [row("heyoka", "velocities", *one) for one in ((2.0, 9.0), (5.0, 15.0), (9.0, 16.0), (0.1, 30.0, "event 1"))]
    assert trade_of(*rows).lead("velocities").ratio == 5
    assert trade_of(rows[0], rows[3]).lead("velocities").peer == rows[0]
    assert trade_of(*rows).lead("relative-motion-b05") is None
    assert trade_of(rows[1], row("heyoka long double", "velocities", 3.0, 17.0)).lead("velocities").ratio == 3


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("", "is no output of"),
        (trade_of(machine={}).text(), "no rows or no machine"),
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
    assert len(text) < 25_000
    assert not re.search(
        r"(?<![\w.])/(home|root|tmp|opt|usr|work|var|nix|Users)/|[A-Z]:\\\\|\b20\d\d-\d\d-\d\d\b", text
    )
    assert found.text() == text
    assert set(found.machine) == {*MACHINE, "busy"} == set(measure.machine())
    assert [*found.scenes] == [*measure.benchmarks()]
    assert len(draw_trade(found).axes) == 1
    assert {one.method for one in found.rows} == {one.name for one in CONTENDERS}
    assert [one for one in found.rows if one.ours and not one.right] == []


# the command


@pytest.fixture
def quick(monkeypatch):
    monkeypatch.setattr(measure, "in_turns", lambda ours, theirs: (1e-3, 2e-3))
    absent = CONTENDERS[-1]._replace(name="absent tool", package="a-package-that-nobody-has")
    few = [one._replace(settings=one.settings[:1]) for one in CONTENDERS if not one.package]
    monkeypatch.setattr(measure, "CONTENDERS", (*few, absent))


@pytest.mark.usefixtures("quick")
def test_the_whole_command_on_a_scene_of_the_users(output, record, scene_file, tmp_path):
    found = record("trade", scene_file, "--digits", 40, "--plot", tmp_path / "trade.png")
    assert found["left_out"] == {"absent tool": "needs a-package-that-nobody-has (extra `comparisons`)"}
    assert [tuple(one[1:5]) for one in found["rows"]] == [
        ("float64", 0, 0.002, 2.0),
        ("balls", 15, 0.002, 2.0),
        ("balls", 40, 0.002, 2.0),
        ("forward Euler", 1000, 0.002, 2.0),
    ]
    assert (tmp_path / "trade.png").stat().st_size > 10_000
    assert [*found["scenes"]] == ["scene"]
    printed = output("trade", scene_file, "--digits", 30)
    assert "left out: absent tool: needs a-package-that-nobody-has" in printed
    assert re.search(r"float64 +2 ms +2 +\d\.\de-1\d +\d\.\de-1\d +\d+ +0 +0 *$", printed, re.MULTILINE)
    assert "forward Euler  1000     2 ms" in printed


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize(
    ("scene", "who", "why"),
    [("plane-rotating-force", "float64", "a surface"), ("velocities-literal", "forward Euler", "law = ")],
)
def test_who_does_not_know_a_scene_is_left_out(record, scene, who, why):
    found = record("trade", scene, "--digits", 15)
    assert why in found["left_out"][who]
    assert "balls" in {one[1] for one in found["rows"]}
