"""Words that people bring are answered by the right ones; what lasts says so on a terminal; tables of a sweep."""

import io
import sys
import time

import numpy as np
import pytest
import xarray

from numerics import (
    Force,
    InvalidScene,
    Pair,
    PlanePair,
    PlaneScene,
    Scene,
    State,
    bifurcation,
    load_scene,
    solve,
    solve_many,
    solve_scenes,
)
from numerics.meter import meter
from numerics.scene.file import parse_scene, scene_text

PAPER = load_scene("velocities")
RUN = solve(PAPER)


def test_a_scene_is_replaced_in_parts_and_numbers():
    changed = PAPER.replace(b="0.06", x1="0.001", until=3, force=Force.sine(1, 2))
    assert (changed.pair, changed.initial) == (Pair(1, 1, 200, "0.06"), State("0.001", "0.15"))
    assert changed.until == 3
    assert PAPER.replace() == PAPER
    belt = load_scene("belt").replace(belt=Force.step(0, "0.2"))
    assert float(belt.initial.v2) == 0.2
    assert PlaneScene(PlanePair(1, 1, 200, 1), 5).replace(b=2, x1=1).pair.b == (2, 2)


def test_a_run_answers_by_name_in_si_and_as_a_table():
    assert (RUN["t"] == RUN.t).all()
    assert (RUN["v1"] == RUN.y[1]).all()
    assert RUN.final == tuple(RUN.y[:, -1])
    assert pytest.approx(RUN.final.x1 / float(PAPER.pair.half_width)) == RUN.reduced.final.X
    table = RUN.to_dataframe(np.linspace(0, 5, 11))
    assert (table["x1"].to_numpy() == RUN.sol(np.linspace(0, 5, 11))[0]).all()
    for one in (PAPER, RUN, solve_many(1, 1, 200, 1, v1=[1, 2], until=1), PAPER.pair):
        assert one._repr_html_().startswith("<table><caption>")


def test_balls_have_their_radii_as_accuracy():
    run = solve(PAPER, digits=20)
    bounds = run.accuracy
    assert "ledger" not in vars(run)  # of 20,000 events it takes seconds: it is formed for `dissipated` alone
    assert bounds.certain
    assert bounds.digits == run.right_digits >= 20
    assert (bounds.t.shape, bounds.y.shape, bounds.final.shape) == ((24,), (24, 4), (4,))
    assert 0 < bounds.dissipated < 1e-20
    assert all(off >= float(one.rad()) > 0 for off, one in zip(bounds.final, run.final, strict=True))


def test_few_digits_are_said():
    few = solve(Scene(Pair("1e30", 1, "1e-10", "2.94"), State(v2=10), 10), arithmetic="float64")
    assert few.right_digits <= 3
    assert f"only {few.right_digits}; request digits" in few.message
    assert "only" not in RUN.message
    swept = solve_scenes([PAPER, few.scene])
    assert ["only 1; use solve(scene, digits=N)" in one for one in swept.message] == [False, True]
    assert "scene [1]: reached the horizon" in repr(swept)


def test_a_list_on_a_line_and_a_table_for_a_scene_are_refused(tmp_path):
    text = scene_text(PAPER).replace("b = 0.05", "b = [1, 2]")
    with pytest.raises(InvalidScene, match="solve_many"):
        parse_scene(text)
    assert parse_scene(text.replace("[initial]", 'shape = "box"\n[initial]').replace("law", "#")).pair.axes == 2
    (tmp_path / "u.csv").write_text("0,1\n")
    with pytest.raises(InvalidScene, match="file ="):
        load_scene(tmp_path / "u.csv")


def test_b_beside_sines_is_their_middle():
    head = "[pair]\nm1=1\nm2=1\na2=200\nb=3\n[run]\nuntil=1\n[[friction]]\nfrom=0\nsines=[{amplitude=1,omega=7}]\n"
    assert parse_scene(head + "b=3\n") == parse_scene(head + "polynomial=[3]\n")


def test_tables_of_runs_sweeps_and_diagrams_are_alike():
    """Results have the names and units of a run's table, a state beside inputs is x1_at_t; inputs have theirs."""
    scenes = [load_scene("belt").replace(force=Force.sine(one, 9)) for one in (1, 2)]
    diagram, batch = bifurcation(scenes, keep=2), solve_scenes(scenes)
    assert {*diagram.inputs} == {*batch.inputs} - {"m2", "v2"}
    tables = [solve(scenes[0]).to_dataframe(), diagram.to_dataframe(), batch.to_dataframe()]
    assert [len(one) for one in tables[1:]] == [4, 2]
    units = [one.attrs["units"] for one in tables]
    for name, unit in {"x1": "m", "v1": "m/s", "x2": "m", "v2": "m/s"}.items():
        assert [one[name if k == 0 else f"{name}_at_t"] for k, one in enumerate(units)] == [unit] * 3
    assert {one["t"] for one in units} == {"s"}
    assert units[1]["force[0].sines[0].amplitude"] == units[2]["force[0].sines[0].amplitude"] == "N"
    assert tables[1]["x1_at_t"].to_numpy() == pytest.approx(diagram.values("x1").ravel())
    grid = diagram.to_xarray()
    assert grid["v1_at_t"].dims == ("force[0].sines[0].amplitude", "point")
    assert (grid["v1_at_t"].attrs["units"], grid["t"].attrs["units"]) == ("m/s", "s")


def test_a_sweep_has_names_and_tables():
    found = solve_many(1, 1, 200, 0.05, a1=0.5, sines=[([0.1, 0.5, 1], 5, 0)], until=2)
    assert found.inputs["sines[0].amplitude"].tolist() == [0.1, 0.5, 1]
    assert found.plot().get_xlabel() == "sines[0].amplitude (N)"
    assert found.to_dataframe()["sines[0].amplitude"].tolist() == [0.1, 0.5, 1]
    scenes = [load_scene("moving-wall").replace(wall=Force.sine(one, 11)) for one in ("0.01", "0.02")]
    assert solve_scenes(scenes).plot("events").get_xlabel() == "wall[0].sines[0].amplitude (m)"
    assert isinstance(found.to_xarray(), xarray.Dataset)
    assert found.to_xarray()["dissipated"].dims == ("sines[0].amplitude",)


def test_stroboscopic_points_of_a_periodic_motion_are_one_and_a_time_is_a_multiple():
    base = load_scene("forced-sine-stick-slip").replace(a1=3, until=40)
    found = bifurcation([base, base.replace(b="0.06")], keep=5)
    period = 2 * np.pi / float(base.force.pieces[0].sines[0].omega)
    assert np.ptp(found.values("v1 - v2"), axis=1).max() < 1e-9
    assert found.t / period == pytest.approx(np.round(found.t / period))
    assert found.plot("v1 - v2").get_ylabel() == "v1 - v2, once a period (m/s)"
    assert (found.values("x1") == bifurcation(found.scenes, keep=5, jobs=1, period=period).values("x1")).all()


@pytest.mark.parametrize(("keep", "period"), [(1, 3), (2, 2), (3, 1), (2, "1.5")])
def test_the_start_is_no_point_of_a_diagram(keep, period):
    short = load_scene("belt").replace(until=2)
    with pytest.raises(InvalidScene, match="until = 2 s is shorter than"):
        bifurcation([short], keep=keep, period=period)
    assert bifurcation([short], keep=keep, period="0.5").t.min() >= 0.5


def test_an_end_after_a_whole_number_of_periods_is_a_point_of_a_diagram():
    short = load_scene("belt").replace(until="0.6")  # 0.6/0.2 is 2.9999999999999996 in floats
    assert bifurcation([short], keep=2, period="0.2").t[0] == pytest.approx([0.4, 0.6])


def test_an_axis_is_named_by_an_input_only_if_its_values_tell_scenes_apart():
    belt = load_scene("belt")
    unlike = [belt, belt.replace(a1="0.5"), load_scene("friction-damper")]
    for scenes in (unlike, [belt, belt], [belt, belt.replace(a1=1), belt]):
        found = solve_scenes(scenes).to_xarray()
        assert found["events"].dims == ("scene",)
        assert found["m1"].to_numpy().tolist() == [float(one.pair.m1) for one in scenes]
    found = solve_scenes([belt, belt.replace(a1="0.5")]).to_xarray()
    assert found["a1"].dims == found["events"].dims == ("a1",)
    grid = solve_many(1, 1, 200, 0.5, v1=[[0.1], [0.2]], x1=[0, 0.01, 0], until=1).to_xarray()
    assert grid["events"].dims == ("v1", "axis_1")
    assert grid["x1"].shape == (2, 3)


def test_a_batch_has_no_table_of_times():
    with pytest.raises(TypeError, match=r"only a run's table takes times: run\.to_dataframe\(times\)"):
        solve_scenes([PAPER]).to_dataframe([1, 2])


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
    meter("derivatives")(time.sleep)(0.2)
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
