"""Speed against accuracy: judging, the front, children that hang or die, and the command; no time is asserted."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from fractions import Fraction

import pytest
from trade_outcomes import SCENE, balls_of, floats_of, ours

from numerics.__main__ import main
from numerics.scene import Pair, Scene, State
from numerics.trade import front, reference, scenes
from numerics.trade.clock import median_time
from numerics.trade.contender import all_contenders, labelled
from numerics.trade.front import Point
from numerics.trade.judge import judge
from numerics.trade.ours import BALL, MPMATH, READ, Ours, solved
from numerics.trade.outcome import Outcome, float_text
from numerics.trade.plan import SIZES, NoSuchContender, selected, settings


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
        free = scenes.paper_scenes()[0]
        most = [settings(ours(BALL), SIZES[name], free)[-1] for name in ("small", "default", "large")]
        assert most == [100, 10_000, 10_000]
        assert settings(ours(BALL), SIZES["default"], scenes.forced_scenes()[0])[-1] == 1000

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
        assert set(record["machine"]) == {"processor", "cores", "load", "system", "python", "packages"}
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
