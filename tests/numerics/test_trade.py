"""Time against accuracy: judging by planted faults, timing by a planted clock, leads, what is recorded, the command."""

import math
import re

import pytest
from flint import arb
from planted_trades import MACHINE, row, trade_of

from numerics import OutOfRange, load_scene
from numerics.trade import measure
from numerics.trade.contenders import CONTENDERS
from numerics.trade.figure import draw_trade
from numerics.trade.judge import judge, proved
from numerics.trade.recorded import SHIPPED, UnreadableTrade, recorded

SCENE = load_scene("relative-motion-b05")
TRUTH = proved(SCENE)
COUNT, MODES, TIMES = len(TRUTH.times), list(TRUTH.modes), list(TRUTH.times)
LEFT, RIGHT = TIMES[4] - TIMES[3], TIMES[5] - TIMES[4]
GAP, AWAY = min(LEFT, RIGHT), 1 if LEFT < RIGHT else -1
"""The fifth event's nearer neighbour; and the direction in which the other one lies."""

# judging


@pytest.mark.parametrize(("place", "setting", "least"), [(0, 0, 13), (1, 20, 20), (1, 500, 500)])
def test_our_floats_and_balls_have_the_digits_of_their_arithmetic(place, setting, least):
    verdict = judge(CONTENDERS[place].prepare(SCENE, setting)(), proved(SCENE, setting), setting)
    assert verdict[:3] == (COUNT, 0, 0)
    assert all(least < digits < least + 40 for digits in (verdict.time_digits, verdict.state_digits))


def run(start, stop, *more):
    """The true run with other events in the place of some: their modes after, and their times."""
    modes, times = [*MODES], [*TIMES]
    modes[start + 1 : stop + 1], times[start:stop] = [mode for mode, _ in more], [time for _, time in more]
    states = TRUTH.states[[*range(start + 1), *[start] * len(more), *range(stop + 1, COUNT + 2)]]
    return TRUTH._replace(modes=modes, times=times, states=states)


PLANTED = {
    "late, and still its own": (run(4, 5, (MODES[5], TIMES[4] + AWAY * GAP * 0.49)), (COUNT, 0, 0), "$"),
    "too late": (run(4, 5, (MODES[5], TIMES[4] + AWAY * GAP * 0.51)), (COUNT - 1, 1, 1), "event 5: .* in truth"),
    "without a time": (run(4, 5, (MODES[5], math.nan)), (COUNT - 1, 1, 1), "event 5: .* at nan s; in truth"),
    "the last one lost": (run(COUNT - 1, COUNT), (COUNT - 1, 1, 0), f"event {COUNT}: .* to the end; in truth"),
    "one too many": (
        run(COUNT, COUNT, ("slip+", TIMES[-1] + GAP / 9)),
        (COUNT, 0, 1),
        f"event {COUNT + 1}: .* to slip",
    ),
    "another mode": (run(2, 3, ("other", TIMES[2])), (COUNT - 2, 2, 2), f"event 3: {MODES[2]} to other "),
}


@pytest.mark.parametrize("fault", PLANTED)
def test_events_are_found_missed_or_extra_and_the_first_wrong_one_is_named(fault):
    found, counts, said = PLANTED[fault]
    verdict = judge(found, TRUTH)
    assert verdict[:3] == counts
    assert re.match(said, verdict.note)


def test_a_run_that_sticks_where_it_slips_is_wrong_without_any_event():
    calm = TRUTH._replace(modes=["stick"], times=[], states=TRUTH.states[[0, -1]])
    assert judge(calm._replace(modes=["slip+"]), calm).note == "event 1: slip+ to the end; in truth stick to the end"


def test_errors_are_those_that_were_planted():
    far, fast = (max(abs(x.mid()) for x in TRUTH.states[:, k::2].flat) for k in (0, 1))
    for place, size, event in ((0, far, 7), (3, fast, -1)):
        states = TRUTH.states.copy()
        states[event, place] += size * arb("1e-3")
        assert judge(TRUTH._replace(states=states), TRUTH).state_digits == pytest.approx(3, abs=0.011)
    late = TRUTH._replace(times=[*TIMES[:-1], TIMES[-1] * (1 - arb(1e-7))])
    assert judge(late, TRUTH).time_digits == pytest.approx(7, abs=0.011)
    wide = TRUTH._replace(states=TRUTH.states + arb(0, far * arb("1e-3")))
    assert judge(TRUTH, wide).state_digits == pytest.approx(3, abs=0.011)  # what is not known is an error


@pytest.mark.parametrize("stage", [0, 1])
def test_a_contender_that_fails_leaves_a_note(stage):
    def fail():
        raise OutOfRange("no step is small enough")

    call, verdict = measure.judged((lambda: fail, fail)[stage], TRUTH, 0)
    assert (call, verdict) == (None, (0, 0, 0, None, None, "no step is small enough"))


# what is recorded


def test_the_lead_is_over_the_fastest_that_is_as_accurate_or_the_most_accurate():
    rows = [row("heyoka", "velocities", *one) for one in ((2.0, 9.0), (5.0, 15.0), (9.0, 16.0), (0.1, 30.0, "event 1"))]
    assert trade_of(*rows).lead("velocities").ratio == 5
    assert trade_of(rows[0], rows[3]).lead("velocities").peer == rows[0]
    assert trade_of(*rows).lead("relative-motion-b05") is None
    assert trade_of(rows[1], row("heyoka long double", "velocities", 3.0, 17.0)).lead("velocities").ratio == 3


@pytest.mark.parametrize(
    ("content", "said"), [("", "is no output"), (trade_of(machine={}).text(), "no machine"), (None, "No such file")]
)
def test_a_wrong_file_is_named_with_what_is_wrong(tmp_path, content, said):
    if content is not None:
        (tmp_path / "wrong.json").write_text(content)
    with pytest.raises(UnreadableTrade, match=rf"wrong\.json .*{said}"):
        recorded(tmp_path / "wrong.json")


def test_the_shipped_one_is_small_names_no_place_and_no_day_and_is_drawn():
    text, found = SHIPPED.read_text("utf-8"), recorded()
    assert len(text) < 25_000
    assert not re.search(r"(?<![\w.])/(home|root|tmp|opt|usr|work|var|nix|Users)/|\b20\d\d-\d\d-\d\d\b", text)
    assert found.text() == text
    assert set(found.machine) == {*MACHINE, "busy"} == set(measure.machine())
    assert [*found.scenes] == [*measure.benchmarks()]
    assert len(draw_trade(found).axes) == 1
    assert {one.method for one in found.rows} == {one.name for one in CONTENDERS}
    unanswered = [one for one in found.rows if one.ours and one.seconds is None]
    assert all(one.right for one in found.rows if one.ours and one.seconds)
    # what has no answer says why: next to the critical energy float64 is sent to balls
    assert [(one.scene, one.method, bool(one.note)) for one in unanswered] == [("near-critical-1e-12", "float64", True)]


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
    asked = [("float64", 0, 1.0), ("balls", 15, 2.0), ("balls", 40, 2.0), ("forward Euler", 1000, 2.0)]
    assert [(*one[1:3], one[4]) for one in found["rows"]] == asked
    assert (tmp_path / "trade.png").stat().st_size > 10_000
    printed = output("trade", scene_file, "--digits", 30)
    assert re.search(r"float64 +2 ms +1 +\d\.\de-1\d +\d\.\de-1\d +\d+ +0 +0 *$", printed, re.MULTILINE)
