"""The commands for control engineers: each answer solved again, printed, written, drawn; bad input in one line."""

import sys
from dataclasses import replace
from fractions import Fraction

import pytest
from control_scenes import DAMPED, FREE, under

from numerics import Force, Mode, fastest_transfer, scene_text, solve, track
from numerics.control.answers import SecondSolveDiffers, solved_again
from numerics.scene.file import load_reference, load_scene, parse_scene

RESPONSES = """
damped 12     0.2 | entrained  | 0 | 0.8330872604435
damped 12     0.5 | stick-slip | 4 | 0.8330872604435
free   4.624 -15  | stick-slip | 6 | 11.7618566
free   4.624  30  | non-stop   | 2 | 11.7618566
"""
"""U** is not enough for the last but one: the relative velocity of the motion without stops keeps its sign from 28.5 N
on only."""


@pytest.mark.parametrize("row", RESPONSES.strip().splitlines())
def test_response_tells_regime_thresholds_and_periodic_motion(tmp_path, output, record, row):
    asked, regime, events, edge = (one.strip() for one in row.split("|"))
    pair, omega, amplitude = asked.split()
    (file := tmp_path / "scene.toml").write_text(scene_text(under({"free": FREE, "damped": DAMPED}[pair], 1, omega)))
    found, lines = (how("response", file, "--amplitude", amplitude) for how in (record, output))
    assert (found["regime"], len(found["events"])) == (regime, int(events))
    assert found["non_stop"].startswith(edge)
    assert f"U**, required for permanent slip with two reversals per period = {edge}" in lines
    assert (len(found["multipliers"]), lines.count("multiplier ")) == (3, 3)
    assert all(f"t = {one['t']} s: {one['to']}" in lines for one in found["events"])


def test_numbers_are_told_where_they_mean_something(output, record):
    assert record("response", "at-rest", "--amplitude", 2, "--omega", "10/3")["exception"].startswith("9.23760")
    for scene, is_told in (("velocities", True), ("forced-step", False), ("forced-friction-by-pieces", False)):
        assert ("E_cr" in output("solve", scene)) is is_told
    assert "energy_excess" in record("solve", "forced-step")["final"]


@pytest.mark.parametrize("on_terminal", [True, False])
def test_who_waits_sees_what_is_being_done(run, monkeypatch, on_terminal):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: on_terminal)
    for name in ("_COMMAND", "_AFTER"):
        monkeypatch.setattr(f"numerics.meter.{name}", 1e-3)
    code, _, err = run("ring", "start-with-speed", "--radius", 1)
    assert (code, "following the motion to t = " in err, err[-4:] == "\r\033[K") == (0, True, on_terminal)


PRINTED = """
response forced-sine-stick-slip | bodies slip and stick in every period | mean velocity of body 2 = 0 m/s, within 0
track at-rest --reference s-curve | within b = 0.5 N
track at-rest --reference too-fast | TOO MUCH by 0.0773502691896258 N (+/- 5.74E-17) for b = 0.5 N
move at-rest --distance 0.001 --amplitude 1.08 | slips of about 10^-20 m
move at-rest --distance 0.01 | at its limit: to within 10^-18
move at-rest --distance 0.01 --margin 0.2 | no force that keeps the margin is faster
move at-rest --distance 0.01 --least energy --time 0.3 | has less int u^2 dt than = 0.295046099130115215 N^2 s, within
move at-rest --distance 0.001 --least energy --time 0.2 | # friction is below its limit
ring velocities --radius 0.001 | stays inside the ring from t = 4.755641299
"""


@pytest.mark.parametrize("line", PRINTED.strip().splitlines())
def test_an_answer_is_printed_and_drawn(tmp_path, run, line):
    words, *said = line.split(" | ")
    code, out, err = run(*words.split(), "--plot", tmp_path / "drawn.svg")
    assert all(one in out for one in said)
    assert ("--margin avoids" in out) is ("10^-" in line)
    assert (code, err[:15]) == ((1, "error: no force") if "TOO MUCH" in line else (0, ""))
    assert code or (tmp_path / "drawn.svg").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("distance", "asked", "said", "holding"),
    [
        ("0.001", "--amplitude 1.08", {"road": "slip", "time": "0.089442719099991"}, None),
        ("-0.01", "--least energy --time 0.3", {"energy": "0.2950460991", "least_energy": "0.2950460991"}, "-2"),
        ("-1/1000", "--least peak --time 0.3", {"peak": ""}, "-0.2"),
    ],
)
def test_move_writes_a_scene_that_arrives_and_says_what_holds_the_pair_then(
    tmp_path, output, record, distance, asked, said, holding
):
    """The cost is that until the arrival."""
    words, file = ("move", "at-rest", "--distance", distance, *asked.split()), tmp_path / "moved.toml"
    found = record(*words, "--out", file)
    assert all(found[name].startswith(text) for name, text in said.items())
    solved = solve(load_scene(file), digits=12)
    assert (set(solved.modes) == {Mode.STICK}) is (holding is not None)
    assert float(solved.final_state[2]) == pytest.approx(float(Fraction(distance)), abs=1e-14)
    if holding is not None:
        assert (found["holding_force"], "on the way" in found["sentence"]) == (holding, True)
        assert f"the force a2 D = {holding} N holds the pair there" in output(*words)
        last = solved.scene.force.pieces[-1]
        assert (last.start, last.polynomial) == (Fraction("0.3"), (Fraction(holding),))


def test_track_prints_the_scene_and_what_rounded_phases_change(run, record, tmp_path):
    found = record("track", "at-rest", "--reference", "s-curve")
    assert found["possible"]
    assert set(solve(parse_scene(found["scene"])).modes) == {Mode.STICK}
    (scene := tmp_path / "scene.toml").write_text(scene_text(load_scene("at-rest").replace(a1=3)))
    (sine := tmp_path / "sine.toml").write_text(
        '[[reference]]\npolynomial = [0, "-0.5"]\nsines = [{ amplitude = 0.5, omega = 1 }]\n'
    )
    words = ("track", scene, "--reference", sine)
    assert [record(*words)["force_error"], found["force_error"]] == ["6.0e-59", "0.0e+00"]
    assert "rounded phases change u by 6e-59 N s in total" in run(*words)[1]


def test_an_answer_whose_scene_does_something_else_is_refused_by_the_second_solve():
    scene = load_scene("at-rest")
    transfer, followed = fastest_transfer(scene, "0.01"), track(scene, load_reference("s-curve"))
    for named, one, force in (
        ("x2 is", transfer, Fraction(99, 100) * transfer.scene.force),
        ("the bodies slip", followed, Force.step(0, 5)),
        ("x2 is", followed, Force()),
    ):
        with pytest.raises(SecondSolveDiffers, match=named):
            solved_again(replace(one, scene=replace(one.scene, force=force)))
