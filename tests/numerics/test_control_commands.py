"""The commands for control engineers: each answer solved again, printed, written, drawn; bad input in one line."""

from dataclasses import replace
from fractions import Fraction

import pytest
from control_scenes import DAMPED

from numerics import (
    Force,
    Friction,
    Mode,
    Pair,
    Scene,
    State,
    Weakening,
    fastest_transfer,
    response,
    scene_text,
    solve,
    track,
)
from numerics.arithmetic.ball import Ball
from numerics.control.answers import SecondSolveDiffers, solved_again
from numerics.scene.file import load_reference, load_scene, parse_scene


@pytest.fixture
def shaken(tmp_path):
    """A scene file: the pair under one sine."""
    file = tmp_path / "shaken.toml"
    file.write_text(scene_text(Scene(DAMPED, State(v1=1), 5, force=Force.sine("0.5", 12))), "utf-8")
    return file


@pytest.mark.parametrize(
    ("amplitude", "regime", "events"), [("0.2", "entrained", 0), ("0.5", "stick-slip", 4), ("2", "non-stop", 2)]
)
def test_response_tells_regime_thresholds_and_periodic_motion(
    shaken, tmp_path, output, record, amplitude, regime, events
):
    found = record("response", shaken, "--amplitude", amplitude, "--plot", tmp_path / "r.svg")
    assert (found["regime"], len(found["events"])) == (regime, events)
    assert found["non_stop"].startswith("0.833087260443534")
    assert len(found["multipliers"]) == 3
    assert (tmp_path / "r.svg").stat().st_size > 10_000
    assert "U**, needed to slip for ever with two reversals a period = 0.8330872604435" in output(
        "response", shaken, "--amplitude", amplitude
    )


@pytest.mark.parametrize(
    ("amplitude", "regime", "said"),
    [
        ("5", "stick-slip", "below U**"),
        ("15", "stick-slip", "turns back"),
        ("-15", "stick-slip", "turns back"),
        ("30", "non-stop", "yes"),
    ],
)
def test_response_says_where_the_necessary_threshold_is_not_enough(tmp_path, output, record, amplitude, regime, said):
    """U** = 11.76 N, but the relative velocity of the motion without stops keeps its sign from 28.5 N on only."""
    file = tmp_path / "slow.toml"
    file.write_text(scene_text(Scene(Pair(1, 1, 200, "0.5"), State(), 5, force=Force.sine("1", "4.624"))), "utf-8")
    found = record("response", file, "--amplitude", amplitude)
    assert found["non_stop"].startswith("11.7618566")
    assert (found["regime"], found["slips_for_ever"]) == (regime, said)
    assert ("U** is not enough here" in output("response", file, "--amplitude", amplitude)) is (said == "turns back")


def test_the_energy_excess_is_told_where_its_unit_means_something(output, record):
    for scene, is_told in (("velocities", True), ("forced-step", False), ("forced-friction-by-pieces", False)):
        assert ("E_cr" in output("solve", scene)) is is_told
    assert "energy_excess" in record("solve", "forced-step")["final"]


def test_response_tells_every_motion_of_a_falling_friction(tmp_path, record):
    file, drawn = tmp_path / "falling.toml", tmp_path / "motions.svg"
    law = Friction((), Weakening([("0.3", "0.15")]))
    pair = Pair(1, 1, 200, "0.5", "0.2")
    file.write_text(scene_text(Scene(pair, State(), 1, force=Force.sine("0.45", 14), friction=law)), "utf-8")
    found = record("response", file, "--digits", 6, "--plot", drawn)
    assert [one["regime"] for one in found["motions"]] == ["entrained", "non-stop", "non-stop"]
    assert [len(one["events"]) for one in found["motions"]] == [0, 2, 2]
    assert "may be more" in found["sentence"]
    assert not found["is_all"]
    assert all("slips_for_ever" not in one for one in found["motions"])
    assert drawn.stat().st_size > 10_000


def test_a_wrong_orbit_is_refused_by_the_second_solve():
    found = response(Scene(DAMPED, State(), 1, force=Force.sine("0.5", 12)))
    legs = [replace(leg, x=leg.x + Ball.number(Fraction(1, 10**9))) for leg in found.orbit.legs]
    with pytest.raises(SecondSolveDiffers, match="after a period"):
        solved_again(replace(found, orbit=replace(found.orbit, legs=tuple(legs))))


def test_move_writes_a_scene_that_arrives(tmp_path, record):
    file = tmp_path / "moved.toml"
    plan = ["move", "at-rest", "--distance", "0.001", "--amplitude", "1.08"]
    found = record(*plan, "--out", file, "--plot", tmp_path / "m.svg")
    assert found["road"] == "slip"
    assert found["time"].startswith("0.089442719099991")
    end = solve(parse_scene(file.read_text("utf-8")), digits=12).final_state
    assert float(end[2]) == pytest.approx(0.001, abs=1e-12)
    assert (tmp_path / "m.svg").stat().st_size > 10_000


def test_move_says_how_near_to_its_limit_friction_is(output):
    """Stuck at the limit the load is within 10^-18 of b; where body 1 runs ahead, what slips of itself is tiny."""
    move = ("move", "at-rest", "--distance")
    assert "friction is within 10^-18 of its limit" in output(*move, "0.01")
    stuck = fastest_transfer(load_scene("at-rest"), "0.01").scene
    load = 2 * stuck.force.pieces[0].polynomial[2] / stuck.pair.a2 * stuck.pair.m2
    assert 0 < 1 - load / stuck.pair.b < Fraction(1, 10**18)
    assert "--margin" not in output(*move, "0.01", "--margin", "0.1")
    assert "slips of about 10^-20 m" in output(*move, "0.001", "--amplitude", "1.08")
    solved = solve(fastest_transfer(load_scene("at-rest"), "0.001", amplitude="1.08").scene, digits=40)
    met, *later = (state[0] - state[2] for state in solved.event_states.T)
    assert max(abs(float(one - met)) for one in later) < 1e-19


def test_a_transfer_whose_scene_stops_short_is_refused_by_the_second_solve():
    found = fastest_transfer(load_scene("at-rest"), "0.01")
    weaker = replace(found.scene, force=Fraction(99, 100) * found.scene.force)
    with pytest.raises(SecondSolveDiffers, match="x2 at the end"):
        solved_again(replace(found, scene=weaker))


def test_track_prints_the_scene_and_names_what_is_too_much(tmp_path, run, record):
    found = record("track", "at-rest", "--reference", "s-curve", "--plot", tmp_path / "t.svg")
    assert found["possible"]
    assert set(solve(parse_scene(found["scene"])).modes) == {Mode.STICK}
    code, out, err = run("track", "at-rest", "--reference", "too-fast")
    assert (code, "TOO MUCH" in out, err[:15]) == (1, True, "error: no force")


def test_a_tracking_scene_that_does_something_else_is_refused():
    scene = load_scene("at-rest")
    found = track(scene, load_reference("s-curve"))
    for force, named in ((Force.step(0, 5), "signs of v1 - v2"), (Force(), "x2 at the horizon")):
        with pytest.raises(SecondSolveDiffers, match=named):
            solved_again(replace(found, scene=replace(found.scene, force=force)))


def test_the_map_of_regimes_is_printed_and_drawn(tmp_path, output):
    window = ["--amplitude", "0.1", 10, "--omega", 4, 40, "--depth", 3]
    assert "entrained" in output("response-map", "at-rest", *window, "--out", tmp_path / "map.svg")
    assert (tmp_path / "map.svg").stat().st_size > 1000
