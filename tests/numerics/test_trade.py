"""Time against accuracy: judging by planted faults, a planted clock, leads, records, the command; peers are right."""

import math
import re
from functools import cache

import pytest
from flint import arb
from planted_trades import MACHINE, row, trade_of
from scene_files import scenes_in
from sixty_digits import forced_scene

from numerics import Law, OutOfRange, Pair, Scene, State, load_scene
from numerics.trade import measure, peers
from numerics.trade.command import MEANING
from numerics.trade.contenders import CONTENDERS
from numerics.trade.figure import draw_trade
from numerics.trade.forward_euler import forward_euler
from numerics.trade.judge import judge, proved
from numerics.trade.measure import FOLDER
from numerics.trade.peers import PeerFailed, SwitchedPair
from numerics.trade.recorded import SHIPPED, UnreadableTrade, recorded

SCENE = load_scene("relative-motion-b05")
TRUTH = proved(SCENE)
COUNT, MODES, TIMES = len(TRUTH.times), list(TRUTH.modes), list(TRUTH.times)

# judging


@pytest.mark.parametrize(("place", "setting", "least"), [(0, 0, 13), (1, 20, 20), (1, 500, 500)])
def test_our_floats_and_balls_have_the_digits_of_their_arithmetic(place, setting, least):
    verdict = judge(CONTENDERS[place].prepare(SCENE, setting)(), proved(SCENE, setting), setting)
    assert (verdict.events, verdict.note) == (COUNT, "")
    assert least < verdict.digits < least + 40


@pytest.mark.parametrize(
    ("modes", "events", "said"),
    [
        (MODES[:-1], COUNT - 1, f"event {COUNT}: {MODES[-2]} to the end; in truth"),
        ([*MODES, "slip+"], COUNT, f"event {COUNT + 1}: .* to slip+ at .*; in truth {MODES[-1]} to the end"),
        (
            [*MODES[:3], "other", *MODES[4:]],
            2,
            f"event 3: {MODES[2]} to other at .* {MODES[2]} to {MODES[3]}",
        ),
        (["other", *MODES[1:]], 0, f"event 1: other to {MODES[1]}"),
    ],
)
def test_the_first_wrong_event_is_named_and_leaves_no_digits(modes, events, said):
    times = [*TIMES, TIMES[-1]][: len(modes) - 1]
    verdict = judge(TRUTH._replace(modes=modes, times=times), TRUTH)
    assert (verdict.events, verdict.digits) == (events, None)
    assert re.match(said.replace("+", "[+]"), verdict.note)


def test_errors_are_those_that_were_planted():
    far, fast = (max(abs(x.mid()) for x in TRUTH.states[:, k::2].flat) for k in (0, 1))
    late = TRUTH._replace(times=[*TIMES[:-1], TIMES[-1] * (1 - arb(1e-7))])
    wide = TRUTH._replace(states=TRUTH.states + arb(0, far * arb("1e-3")))
    planted = [(late, TRUTH, 7), (TRUTH, wide, 3)]  # what is not known is an error
    for place, size, event in ((0, far, 7), (3, fast, -1)):
        states = TRUTH.states.copy()
        states[event, place] += size * arb("1e-3")
        planted.append((TRUTH._replace(states=states), TRUTH, 3))
    for run, truth, digits in planted:
        assert judge(run, truth).digits == pytest.approx(digits, abs=0.011)
    assert judge(TRUTH._replace(times=[math.nan, *TIMES[1:]]), TRUTH) == (COUNT, None, "not every number is finite")


@pytest.mark.parametrize("stage", [0, 1])
def test_a_contender_that_fails_leaves_a_note(stage):
    def fail():
        raise OutOfRange("no step is small enough")

    call, verdict = measure.judged((lambda: fail, fail)[stage], TRUTH, 0)
    assert (call, verdict) == (None, (0, None, "no step is small enough"))


def test_a_call_is_timed_in_turns_with_ours_for_as_long_as_is_granted(monkeypatch):
    spent = [0.0]
    monkeypatch.setattr(measure.time, "process_time", lambda: sum(spent))
    ours, theirs = (lambda seconds=seconds: spent.append(seconds) for seconds in (2**-10, 3 / 2**10))
    assert measure.timed(ours, theirs) == (0.00293, 3)
    assert sum(spent) >= measure.BUDGET


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
        ("", "is no output"),
        ("{}", "columns"),
        (trade_of().text().replace("note", "else"), "other columns"),
        (None, "No such file"),
    ],
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
    few = [one._replace(settings=one.settings[:1]) for one in CONTENDERS if one.package == "numpy"]
    monkeypatch.setattr(measure, "CONTENDERS", (*few, absent))


@pytest.mark.usefixtures("quick")
def test_the_whole_command_on_a_scene_of_the_users(output, record, scene_file, tmp_path):
    found = record("trade", scene_file, "--digits", 40, "--plot", tmp_path / "trade.png")
    assert found["left_out"] == {"absent tool": "needs a-package-that-nobody-has (extra `comparisons`)"}
    asked = [("float64", 0, 1.0), ("balls", 15, 2.0), ("balls", 40, 2.0), ("forward Euler", 1000, 2.0)]
    assert [(*one[1:3], one[4]) for one in found["rows"]] == asked
    assert (tmp_path / "trade.png").stat().st_size > 10_000
    printed = output("trade", scene_file, "--digits", 15)
    assert printed.count("\nballs ") == 1
    assert re.search(r"float64 +2 ms +1 +\d\.\de-1\d +\d+ *$", printed, re.MULTILINE)
    assert re.search(rf" cores, load .*; Python .*numpy .*\n{re.escape(MEANING)}\n$", printed)


# the peers: each installed one gets scenes of every kind right, and never runs for ever


SCENES = {"paper": SCENE, "viscous": scenes_in("differentiated")["damped"]}
SCENES |= {name: forced_scene(name) for name in ("sine-stick-slip", "friction-by-pieces", "trapezoid")}
SIGNALS = "belt-and-wall", "wall-of-a-sine", "incline", "friction-by-a-sine", "static-friction-under-a-sine"
SCENES |= {name: scenes_in("signals")[name] for name in SIGNALS}
EULER = "forward Euler"
# a fine setting, and the digits that it must have there
FINE = {
    EULER: (1e6, 1.5),
    "SciPy DOP853": (1e-12, 8),
    "heyoka": (1e-15, 11),
    "heyoka long double": (1e-18, 13),
}
truth_of = cache(proved)


def contender(name):
    return next(one for one in CONTENDERS if one.name == name)


def verdict(one, scene, setting):
    if missing := one.left_out(scene):
        pytest.skip(missing)
    return judge(one.prepare(scene, setting)(), truth_of(scene))


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("name", FINE)
def test_a_fine_setting_has_the_events_and_the_digits(name, scene):
    one, (setting, digits) = contender(name), FINE[name]
    if name == EULER and SCENES[scene].is_forced:  # which has the paper's equations
        assert one.left_out(SCENES[scene]).startswith("not for ")
        return
    found = verdict(one, SCENES[scene], setting)
    assert found.note == ""
    assert found.digits >= digits


@pytest.mark.parametrize(("law", "v"), [(Law.FILIPPOV, (-0.28, -0.25)), (Law.THREE_VALUED_SGN, (-0.26, -0.26))])
def test_forward_euler_slips_from_rest_beyond_the_edge_unless_sgn_0_is_0(law, v):
    """The edge is L = 0.00375 m."""
    assert forward_euler(Scene(Pair(1, 2, 200, "0.5"), State("0.0039"), 2, law), 1).y[[1, 3], 1] == pytest.approx(v)


TOUCH, NEAR = (load_scene(FOLDER / f"{name}.toml") for name in ("forced-touch", "near-critical-1e-12"))


@pytest.mark.parametrize(("name", "scene"), [("SciPy DOP853", TOUCH), ("heyoka", TOUCH), ("heyoka", NEAR)])
def test_a_short_stay_beyond_the_edge_is_not_stepped_over(name, scene):
    assert verdict(contender(name), scene, 1e-12).note == ""


def test_what_does_not_get_on_is_stopped(monkeypatch):
    monkeypatch.setattr(peers, "MAX_ARCS", 5)
    with pytest.raises(PeerFailed, match="in 6 arcs"):
        peers.run(SwitchedPair(SCENE), lambda own, slips, z, left: (True, 0.0, [1.0, 1.0, 0.0, 0.1, 0.5]))
