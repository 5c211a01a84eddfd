"""solve_many and solve_scenes: arrays in, arrays out, the results of `solve`.

Answers, bounds and digits of sweeps of every kind are frozen (oracle/bounds.py), and those of scenes one by one are
held against balls (test_every_number.py).
"""

import os
import pickle
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
from every_number import batch_held
from hypothesis import given
from hypothesis import strategies as st
from scene_files import scenes_in

from numerics import (
    EventUndecided,
    Force,
    Law,
    OutOfRange,
    Pair,
    Scene,
    State,
    load_scene,
    solve,
    solve_many,
    solve_scenes,
)
from numerics.arithmetic.compiled import can_compile
from numerics.solver import rows as batch
from numerics.solver.inputs import SI
from numerics.trajectory.status import Status

PAPER = {"m1": 1, "m2": 1, "a2": 200, "b": 0.5, "until": 5}
OPEN = Scene(Pair(1, 1, 200, "0.5"), State(v1=Fraction(0.15)), 3)
exact = np.vectorize(Fraction, otypes=[object])


def require_rows(found, given):
    """Rows are those of the same binary numbers as scenes, solved one by one; what arrays leave open goes on there."""
    terms = {"polynomial": [*map(exact, given.get("polynomial", ()))]}
    terms |= {"sines": [[*map(exact, one)] for one in given.get("sines", ())]}
    numbers = {name: exact(one) for name, one in given.items() if name in SI}
    scenes = solve_many(**given | numbers | terms, exact=True)
    ended = (found.status != Status.SEQUENCE_OPEN) & (found.status != Status.OUT_OF_RANGE)
    for name in ("status", "mode", "events"):
        assert np.array_equal(getattr(found, name)[ended], getattr(scenes, name)[ended])
    rows = {"y": (slice(None), ended), "event_y": (slice(None), ended)}
    for name in ("y", "event_t", "event_y", "dissipated", "energy_excess"):
        both = [[getattr(of, name + end)[rows.get(name, ended)] for end in ("", "_error")] for of in (found, scenes)]
        (one, off), (two, more) = both
        assert np.array_equal(np.isnan(one), np.isnan(two)), name
        assert not (abs(one - two) > off + more).any(), name


IN_DOUBT = scenes_in("cycles") | scenes_in("in-doubt")
SHIPPED = ("velocities", "start-at-6mm-literal", "forced-sweep", "ground", "moving-wall")
SCENES = IN_DOUBT | scenes_in("left-open") | {name: load_scene(name) for name in SHIPPED}


@pytest.mark.parametrize("name", SCENES)
def test_a_list_of_scenes_goes_on_in_balls_where_floats_leave_one_open(name):
    scene = SCENES[name]
    found, truth = solve_scenes([scene] * 2, keep_events=2, jobs=1), solve(scene, digits=30)
    assert found.status.tolist() == [solve(scene).status] * 2
    assert found.digits.min() > 8
    assert np.isnan([found.energy_excess, found.energy_excess_error]).all() == bool(
        scene.wall.pieces or not scene.pair.a2
    )
    with truth.context():
        assert all(one.ratio <= 1.0 for one in batch_held(found, 1, truth))
    if name in IN_DOUBT:
        with pytest.raises(EventUndecided):
            solve(scene, arithmetic="float64")


def test_a_list_of_scenes_goes_on_in_balls_where_one_takes_too_many_steps_in_floats():
    """A slip in which body 1 swings some 2e6 times; an energy that no float holds stays without an answer."""
    long = scenes_in("far-out")["a-slip-of-2e6-turns"]
    found, truth = solve_scenes([long, long.replace(v2="1e200")], keep_events=2, jobs=1), solve(long, digits=30)
    with pytest.raises(OutOfRange):
        solve(long, arithmetic="float64")
    assert found.status.tolist() == [Status.REACHED_HORIZON, Status.OUT_OF_RANGE]
    with truth.context():
        assert all(one.ratio <= 1.0 for one in batch_held(found, 0, truth))


def test_what_arrays_leave_open_is_said_in_a_sentence():
    third = float(solve(OPEN).events[2].t)
    found = solve_many(**PAPER | {"v1": 0.15, "until": [3.0, third, third]})
    assert "scene [1], [2]: the error bounds do not decide" in repr(found)
    assert found.message[1].endswith("solve(scene) goes on in balls")
    assert "scene [0, 1]: " in repr(solve_many(**PAPER | {"v1": [[0.15], [0.1]], "until": [3.0, third]}))


def test_arrays_are_binary_numbers_also_where_scenes_are_made_of_them_unless_they_are_exact():
    """The float next to 1/200 lies beyond the edge of the sliding region, on which the exact one sticks."""
    given = PAPER | {"x1": 0.005, "force": Force.constant(0)}
    assert [solve_many(**given, exact=one).events.item() for one in (True, False)] == [0, 31]


def test_a_run_that_is_cut_within_its_exact_start_has_lost_what_solve_says():
    """@example of a found fault: nothing, to all digits."""
    scene = scenes_in("drawn")["cut-within-its-exact-start"]
    assert solve_scenes([scene], max_events=1).dissipated == solve(scene, max_events=1).dissipated


GRID = {"v1": [0.1, 0.2], "b": [[0.05], [0.1], [0.2]]}
SHAPES = {
    "one": ({"v1": 0.1, "keep_events": 2}, ()),
    "none": ({"v1": []}, (0,)),
    "a grid": ({"v1": np.array([0.1, 0.15])[:, None], "x1": np.zeros((1, 3)), "keep_events": 4}, (2, 3)),
    "exact numbers": (GRID | {"exact": True}, (3, 2)),
    "a force": (GRID | {"force": Force.sine(1, 2)}, (3, 2)),
}


@pytest.mark.parametrize("name", SHAPES)
def test_all_arrays_and_tables_have_the_shape_of_what_is_given(name):
    given, shape = SHAPES[name]
    found = solve_many(**PAPER | given)
    assert {one.shape for one in (found.t, found.energy_excess, *found.inputs.values())} == {shape}
    assert (found.y.shape, found.event_y.shape) == ((4, *shape), (4, *shape, given.get("keep_events", 0)))
    assert len(found.to_dataframe()) == len(found) == np.prod(shape)
    assert len(found.to_xarray().sizes) == len(shape)


@given(st.integers(0, 2**32 - 1), st.sampled_from(Law))
def test_rows_under_a_force_are_what_their_scenes_give_by_themselves_in_any_order(seed, law):
    """Numbers are binary fractions; some rows differ from one before by one number alone."""
    random = np.random.default_rng(seed)
    rows = [random.integers(1, 64, 14) / 16]
    for _ in range(4):
        row = rows[random.integers(len(rows))].copy() if random.random() < 0.5 else random.integers(1, 64, 14) / 16
        row[random.integers(14)] = random.integers(1, 64) / 16
        rows.append(row)
    for table in (rows, rows[::-1]):
        *numbers, u, amplitude, omega, phase = np.array(table).T
        swept = dict(zip(SI, numbers, strict=True)) | {"polynomial": [u], "sines": [(amplitude, omega, phase)]}
        swept |= {"law": law, "keep_events": 2, "max_events": 2 + seed % 9}
        require_rows(solve_many(**swept), swept)


def test_many_chunks_threads_and_progress(monkeypatch):
    monkeypatch.setattr(batch, "_CHUNK", 7)
    given, told = PAPER | {"v1": np.linspace(0.02, 0.3, 50), "keep_events": 3}, []
    one = solve_many(**given, jobs=1)
    two = solve_many(**given, jobs=2, progress=lambda done, whole: told.append((done, whole)))
    for name in ("status", "y", "y_error", "event_t", "event_y", "dissipated"):
        assert np.array_equal(getattr(one, name), getattr(two, name), equal_nan=True)
    assert told == [(done, 50) for done in (*range(7, 50, 7), 50)]


def test_a_long_batch_can_be_interrupted_between_short_chunks():
    """An interruption waited for 4096 rows, of long scenes for more than a minute."""
    told = []
    solve_many(**PAPER | {"v1": np.linspace(0.02, 0.3, 500)}, progress=lambda done, whole: told.append(done))
    assert told == [128, 256, 384, 500]


ROWS = PAPER | {"m2": [1] * 9 + [1e-300, 1], "b": [0.5] * 10 + [1e-300], "a1": 0.01, "keep_events": 5, "until": 100}
ROWS |= {"v1": [0.1 + k / 40 for k in range(10)] + [1e100]}
"""The last two leave the range of floats; the first stick so long that steps do not take the segment's ledger."""
SINES = [([0] * 5 + [0.375] * 6, 5, 0.25)]
"""Some are of the free pair: their ledgers are formed when they are looked at."""
WAYS = {
    "two threads, the first to compile": (
        "import numba; before = numba.config.CACHE_DIR; rows._CHUNK = 2",
        "assert numba.config.CACHE_DIR == before",  # it is left as it was
        {},
    ),
    "without numba": ("", "assert 'numba' not in sys.modules", {"NUMBA_DISABLE_JIT": "1"}),
}


@pytest.mark.parametrize("way", WAYS if can_compile() else [*WAYS][1:])
def test_a_new_process_has_the_same_numbers(way):
    before, after, environment = WAYS[way]
    code = f"import pickle, sys; from numerics import solve_many; from numerics.solver import rows\n{before}\n"
    code += f"found = [solve_many(**{ROWS}, jobs=4), solve_many(**{ROWS}, sines={SINES})]\n{after}\n"
    code += "sys.stdout.buffer.write(pickle.dumps(found))"
    call = [sys.executable, "-c", code]
    done = subprocess.run(call, capture_output=True, check=True, env=os.environ | environment)
    for found, sines in zip(pickle.loads(done.stdout), [(), SINES], strict=True):
        assert found.success.tolist() == [True] * 9 + [False] * 2
        assert np.array_equal(np.isnan(found.dissipated), ~found.success)
        require_rows(found, ROWS | {"sines": sines})


def test_arrays_may_hold_pairs_without_spring_or_contact_and_the_ground():
    found = solve_many(1, [1, np.inf, 2], [0, 0, 200], [1, 1, 0], v1=1, until="1.5", keep_events=1)
    alone = solve_scenes([Scene(Pair(1, *one), State(v1=1), "1.5") for one in ((1, 0, 1), ("inf", 0, 1), (2, 200, 0))])
    assert (found.y == alone.y).all()
    assert found.success.all()


def test_the_bound_of_what_was_taken_is_that_of_a_run():
    scene = load_scene("velocities")
    said = float(solve_scenes([scene]).dissipated_error[0])
    assert solve(scene).accuracy.dissipated == pytest.approx(said, rel=1e-6, abs=0)
