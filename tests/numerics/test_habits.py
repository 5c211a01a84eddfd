"""Words that people bring are answered by the right ones; what lasts says so on a terminal; tables of a sweep."""

import io
import sys
import time

import numpy as np
import pytest
from scene_files import scenes_in

from numerics import (
    Force,
    PlanePair,
    PlaneScene,
    bifurcation,
    load_scene,
    solve,
    solve_many,
    solve_scenes,
)
from numerics.meter import meter
from numerics.scene.file import parse_scene
from numerics.trajectory.columns import STATE
from numerics.trajectory.units import unit

PAPER = load_scene("velocities")


def test_a_scene_with_another_belt_has_its_velocity():
    assert float(load_scene("belt").replace(belt=Force.step(0, "0.2")).initial.v2) == 0.2


def test_without_a_belt_replacing_it_by_none_keeps_v2():
    """It became 0."""
    scene = PAPER.replace(v2="0.42")
    assert scene.replace(belt=Force()) == scene


def test_balls_have_their_radii_as_accuracy():
    run = solve(PAPER, digits=20)
    assert "ledger" not in vars(run)  # of 20,000 events it takes seconds: it is formed for `dissipated` alone
    assert (run.accuracy.certain, run.accuracy.digits) == (True, run.right_digits)
    assert (run.accuracy.t.shape, run.accuracy.y.shape) == ((24,), (24, 4))
    assert all(off >= float(one.rad()) > 0 for off, one in zip(run.accuracy.final, run.final, strict=True))


def test_few_digits_are_said():
    few = solve(scenes_in("far-out")["few-digits"], arithmetic="float64")
    assert few.right_digits <= 3
    assert f"only {few.right_digits}; request digits" in few.message
    assert "only" not in solve(PAPER).message
    swept = solve_scenes([PAPER, few.scene, PAPER.replace(m2="inf", x1="0.0001", v1=0)])
    said = f"only {few.right_digits}; use solve(scene, digits=N)"
    assert [said in one for one in swept.message] == [False, True, False]
    assert "scene [1]: reached the horizon" in repr(swept)


def test_b_beside_sines_is_their_middle():
    head = "[pair]\nm1=1\nm2=1\na2=200\nb=3\n[run]\nuntil=1\n[[friction]]\nfrom=0\nsines=[{amplitude=1,omega=7}]\n"
    assert parse_scene(head + "b=3\n") == parse_scene(head + "polynomial=[3]\n")


SPEEDS, AMPLITUDE = np.linspace(0.01, 0.3, 12), "force[0].sines[0].amplitude"
SHAKEN = [load_scene("belt").replace(force=Force.sine(one, 9)) for one in (1, 2)]
JOINED = [SHAKEN[0].replace(force=Force.sine(one, 9) + Force.step(1, "0.2")) for one in (1, 2)]
STARTS = [PlaneScene(PlanePair(1, 1, [200, 120], ["0.5", "0.4"], 1), "0.1", x1=[x, 0]) for x in ("0.012", "0.002")]
PUSHED = [STARTS[0].replace(force=[Force(), Force.constant(one)]) for one in (1, "1.5")]
BATCHES = {
    "some are cut off": (lambda: solve_many(1, 1, 200, 0.05, v1=SPEEDS, until=5, max_events=20), "dissipated", "v1"),
    "a grid": (lambda: solve_many(1, 1, 200, [[0.05], [0.1]], v1=SPEEDS, until=1), "events", "b"),
    "a force": (lambda: solve_many(1, 1, 200, 1, sines=[([0.1, 1], 5, 0)], until=2), "v1", "sines[0].amplitude"),
    "scenes": (lambda: solve_scenes(SHAKEN), "events", AMPLITUDE),
    "points": (lambda: bifurcation(SHAKEN, keep=2), "v1 - v2", AMPLITUDE),
    "a sine in two pieces": (lambda: solve_scenes(JOINED), "events", AMPLITUDE),
    "a push on a surface": (lambda: solve_scenes(PUSHED, jobs=1), "v2_y", "force_y[0].polynomial[0]"),
    "a surface": (lambda: solve_scenes(STARTS, jobs=1), "energy", "x1_x"),
}


@pytest.mark.parametrize("name", BATCHES)
def test_batches_are_drawn_over_what_varies_and_become_tables_with_units(name):
    """Results have the names and units of a run's table, a state beside inputs is x1_at_t."""
    make, answer, along = BATCHES[name]
    found, known = make(), {"b": "N", "v1": "m/s", "x1_x": "m"}
    table, grid, ax = found.to_dataframe(), found.to_xarray(), found.plot(answer)
    units = {"t": "s", answer: unit(answer), along: known.get(along, "N")}
    assert ax.get_xlabel() == f"{along} ({units[along]})"
    assert ax.get_ylabel().startswith("v1 (m/s)" if name == "a grid" else answer)
    assert (ax.get_legend() is None) == bool(found.success.all())
    if answer[:2] in STATE and " " not in answer:
        units[f"{answer}_at_t"], answer = "m/s", f"{answer}_at_t"
    assert {**units, **table.attrs["units"]} == table.attrs["units"]
    values = found.values(answer.removesuffix("_at_t"))
    assert table[answer].to_numpy() == pytest.approx(values.ravel(), nan_ok=True)
    assert grid[answer].dims[0] == along
    if name == "a push on a surface":
        assert (values.tolist(), found.inputs[along].tolist()) == (found.y[3, :, 1].tolist(), [1, 1.5])
    assert (grid[answer].to_numpy().shape, grid[along].attrs["units"]) == (values.shape, units[along])


def test_stroboscopic_points_of_a_periodic_motion_are_one_and_a_time_is_a_multiple():
    base = load_scene("forced-sine-stick-slip").replace(a1=3, until=40)
    found = bifurcation([base, base.replace(b="0.06")], keep=5)
    period = 2 * np.pi / float(base.force.pieces[0].sines[0].omega)
    assert np.ptp(found.values("v1 - v2"), axis=1).max() < 1e-9
    assert found.t / period == pytest.approx(np.round(found.t / period))


def test_an_end_after_a_whole_number_of_periods_is_a_point_of_a_diagram():
    short = load_scene("belt").replace(until="0.6")  # 0.6/0.2 is 2.9999999999999996 in floats
    assert bifurcation([short], keep=2, period="0.2").t[0] == pytest.approx([0.4, 0.6])


def test_an_axis_is_named_by_an_input_only_if_its_values_tell_scenes_apart():
    belt, damped = load_scene("belt"), load_scene("belt").replace(a1="0.5")
    for scenes, axis in (([belt, damped], "a1"), ([belt, damped, load_scene("friction-damper")], "scene")):
        found = solve_scenes(scenes).to_xarray()
        assert found["events"].dims == (axis,)
        assert found["m1"].to_numpy().tolist() == [float(one.pair.m1) for one in scenes]
    assert solve_scenes([belt, damped, belt]).to_xarray()["events"].dims == ("scene",)
    grid = solve_many(1, 1, 200, 0.5, v1=[[0.1], [0.2]], x1=[0, 0.01, 0], until=1).to_xarray()
    assert (grid["events"].dims, grid["x1"].shape) == (("v1", "axis_1"), (2, 3))


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.mark.parametrize("kind", [Terminal, io.StringIO])
def test_what_lasts_shows_one_line_on_a_terminal_and_after_a_minute_lines_elsewhere(kind, monkeypatch):
    monkeypatch.setattr(sys, "stderr", kind())
    for name, seconds in (("_AFTER", 0.05), ("_EVERY", 0.01), ("_SILENT", 0.05)):
        monkeypatch.setattr(f"numerics.meter.{name}", seconds)
    with meter("solving") as told, meter("drawing") as inner:
        time.sleep(0.1)
        told(5, 10)
        time.sleep(0.2)
        assert inner is None
    with meter("derivatives"):
        time.sleep(0.2)
    shown, is_terminal = sys.stderr.getvalue(), kind is Terminal
    assert "solving  50 %|##########          |" in shown
    assert "derivatives" in shown
    assert ("\r" in shown, shown.count("\n") in range(2, 8)) == (is_terminal, not is_terminal)
    assert shown.endswith("\r\033[K" if is_terminal else " s\n")


@pytest.mark.parametrize("kind", [Terminal, io.StringIO])
def test_quick_work_shows_nothing(kind, monkeypatch):
    monkeypatch.setattr(sys, "stderr", kind())
    solve(PAPER, digits=30)
    assert sys.stderr.getvalue() == ""
