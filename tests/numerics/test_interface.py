"""What a user meets: one place to import from, short texts, equality, pickles, tables, kinds of numbers."""

import copy
import pickle
import sys
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from three_scenes import ARITHMETICS, DAMPED, PAPER, STUCK

import numerics
from numerics import Pair, Scene, Solver, State, solve, solve_many
from numerics.errors import InvalidScene, MissingTool
from numerics.scene.file import parse_scene

HOW = [*ARITHMETICS, {"digits": 12}, {"max_events": 3}]


def runs(scene=PAPER):
    return [solve(scene, **how) for how in HOW if scene.pair.a1 == 0 or how.get("arithmetic") != "double-double"]


# one place


def test_everything_a_user_needs_is_in_one_place():
    assert all(callable(getattr(numerics, name)) for name in numerics.__all__)
    with pytest.raises(AttributeError, match="solv"):
        numerics.solv  # noqa: B018


@pytest.mark.parametrize("given", [PAPER.pair, None, "velocities"])
def test_what_is_no_scene_is_told_how_to_build_one(given):
    with pytest.raises(TypeError, match=r"build Scene\(Pair\(\.\.\.\)"):
        solve(given)


# texts


@pytest.mark.parametrize("how", HOW)
def test_a_trajectory_shows_itself_in_a_few_short_lines(how):
    run = solve(PAPER, **how)
    lines = repr(run).splitlines()
    names = [line.split(":")[0].strip() for line in lines]
    assert names == ["message", "success", "status", "arithmetic", "events", "t", "final mode"]
    assert all(len(line) < 120 for line in lines)
    assert f"events: {len(run.events)}" in repr(run)
    assert run._repr_html_().count("<tr>") == len(lines)


def test_only_digits_that_something_bounds_are_called_right():
    assert "right digits" in repr(solve(PAPER))
    assert "right digits" in repr(solve(PAPER, digits=20))
    assert "right digits" not in repr(solve(PAPER, arithmetic="mpmath"))


# equality and pickles


@pytest.mark.parametrize("scene", [PAPER, DAMPED, STUCK])
def test_two_equal_solves_are_equal_and_come_back_from_a_pickle(scene):
    for one, two in zip(runs(scene), runs(scene), strict=True):
        assert one == two
        for back in (pickle.loads(pickle.dumps(one)), copy.deepcopy(one)):
            assert back == one
            assert repr(back) == repr(one)
            assert back.modes == one.modes
            with one.arithmetic.context():
                assert [one.arithmetic.text(a, 60) for a in back.y.flat] == [
                    one.arithmetic.text(a, 60) for a in one.y.flat
                ]
            assert [str(a) for a in back.sol("0.1")] == [str(a) for a in one.sol("0.1")]


# times asked for


@pytest.mark.parametrize("how", HOW[:4])
def test_t_eval_gives_state_and_energy_at_those_times(how):
    times = [0, "1/3", 0.5, 2]
    run = solve(PAPER, **how, t_eval=times)
    assert run.t.shape == run.energy.shape == (4,)
    with run.arithmetic.context():
        number = run.arithmetic.to_float
        assert [number(one) for one in run.t] == pytest.approx([0, 1 / 3, 0.5, 2])
        assert [str(one) for one in run.y.flat] == [str(one) for one in run.sol(times).flat]
    assert len(run.events) == len(solve(PAPER).events)


@pytest.mark.parametrize("how", HOW[:4])
@pytest.mark.parametrize(
    ("times", "said"),
    [([1, 4], "outside the solved time"), ([0.5, "nan"], "nan"), ([1, float("nan")], "nan"), ([1, 0.5], "in order")],
)
def test_times_that_cannot_be_answered_are_refused_when_they_are_given(how, times, said):
    with pytest.raises(ValueError, match=said):
        solve(PAPER, **how, t_eval=times)


@pytest.mark.parametrize("times", [1, "abc", [[1, 2]]])
def test_times_that_are_no_sequence_are_refused_at_once(times):
    with pytest.raises(ValueError, match="sequence of times"):
        solve(PAPER, t_eval=times)


@pytest.mark.parametrize("how", HOW[:4])
def test_mode_at_takes_arrays(how):
    run = solve(PAPER, **how)
    times = np.linspace(0, 3, 40)
    modes = run.mode_at(times)
    assert list(modes) == [run.mode_at(one) for one in times]
    assert run.mode_at([]).shape == (0,)
    assert list(run.mode_at(run.event_times, "left")) == [event.before for event in run.events]
    assert list(run.mode_at(run.event_times)) == [event.after for event in run.events]


# tables


@pytest.mark.parametrize("how", HOW)
def test_a_data_frame_has_start_events_and_end(how):
    pd = pytest.importorskip("pandas")
    run = solve(PAPER, **how)
    frame = run.to_dataframe()
    assert list(frame.columns) == ["t", "mode", "x1", "v1", "x2", "v2", "energy", "energy_excess"]
    assert len(frame) == len(run.t)
    assert list(frame["mode"][:-1]) == [mode.value for mode in run.modes][: len(frame) - 1]
    assert frame["mode"].iloc[-1] == run.final_mode.value
    assert pd.api.types.is_float_dtype(frame["x1"])
    assert len(solve(PAPER, **how, t_eval=[0, "1/20"]).to_dataframe()) == 2


def test_without_pandas_the_missing_tool_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingTool, match="pandas"):
        solve(PAPER).to_dataframe()


# numbers of any kind

ONE_HALF = [0.5, "0.5", "1/2", " 1 / 2 ", Decimal("0.5"), Fraction(1, 2), np.float64(0.5), np.float32(0.5)]


@pytest.mark.parametrize("half", ONE_HALF)
def test_every_kind_of_number_is_read(half):
    assert Pair(1, 1, 200, half) == PAPER.pair
    assert State(x1=half).x1 == Fraction(1, 2)
    assert Solver(PAPER.pair)(State(v1="0.15"), half) == solve(Scene(PAPER.pair, PAPER.initial, half))


def test_a_ratio_is_a_number_in_a_scene_file_and_in_a_batch():
    text = '[pair]\nm1 = "1/3"\nm2 = 1\na2 = 200\nb = "1/2"\n[initial]\nv1 = "3/20"\n[run]\nuntil = "7/3"\n'
    scene = parse_scene(text)
    assert (scene.pair.m1, scene.initial.v1, scene.until) == (Fraction(1, 3), Fraction(3, 20), Fraction(7, 3))
    batch = solve_many("1/3", 1, 200, "1/2", v1=["3/20", "1/7"], until="7/3", exact=True)
    assert batch.y[:, 0].tolist() == [float(one) for one in solve(scene).final_state]


@pytest.mark.parametrize("bad", ["1/0", "1//2", "/2", "1/", "1/2/3", "1/x", "1e400/1e-4000"])
def test_what_is_no_ratio_is_refused(bad):
    with pytest.raises(InvalidScene):
        Pair(1, 1, 200, bad)
