"""solve_many and solve_scenes: arrays in, arrays out, the results of `solve`."""

import os
import pickle
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from itertools import chain

import numpy as np
import pytest
from batch_numbers import row_numbers
from hypothesis import example, given
from hypothesis import strategies as st
from kernel_runs import a_scene

from numerics import (
    Batch,
    EventUndecided,
    Force,
    Friction,
    Law,
    OutOfRange,
    Pair,
    Piece,
    Scene,
    Sine,
    State,
    Weakening,
    load_scene,
    solve,
    solve_many,
    solve_scenes,
)
from numerics.linear.record import AT
from numerics.solver import rows as batch
from numerics.trajectory.comparison import distance
from numerics.trajectory.run import MAX_EVENTS
from numerics.trajectory.status import Status

PAPER = {"m1": 1, "m2": 1, "a2": 200, "b": 0.5}
OPEN = Scene(Pair(1, 1, 200, "0.5"), State(v1=Fraction(0.15)), 3)


def same(found: Batch, other: Batch) -> bool:
    names = ["status", "events", "mode", "t", "y", "y_error", "event_t", "event_y", "energy_excess"]
    names += ["dissipated", "dissipated_error", "digits"]
    return all(np.array_equal(getattr(found, name), getattr(other, name), equal_nan=True) for name in names)


def require_alone(found: Batch, k, scene, most=MAX_EVENTS, within=1e-13, bounds=None):
    """A row is what its scene is by itself: how it ended, events and end; its bounds are `bounds` times as large."""
    try:
        one = solve(replace(scene), arithmetic="float64", max_events=most)  # of nothing that the batch has made
    except (EventUndecided, OutOfRange) as error:
        if isinstance(error, OutOfRange) or found.status[k] == Status.SEQUENCE_OPEN:
            refused = Status.OUT_OF_RANGE if isinstance(error, OutOfRange) else Status.SEQUENCE_OPEN
            assert found.status[k] == refused
            return
        one = solve(replace(scene), max_events=most)  # scene by scene a batch goes on in balls
        assert (found.events[k], found.status[k]) == (len(one.events), one.status)
        assert (abs(found.y[:, k] - one.floats(one.final)) <= found.y_error[:, k]).all()
        return
    assert bool(found.certain[k]) == one.accuracy.certain
    if not one.certain:
        return
    count = min(found.event_t.shape[-1], len(one.events))
    assert (found.status[k], found.mode[k], found.success[k]) == (one.status, one.final_mode.sign, one.success)
    sizes = {"energy_excess": 1e-13 / within, "y": abs(one.y).max(), "event_y": abs(one.y).max()}
    for name, x, _, alone in row_numbers(found, k, one):
        assert x == pytest.approx(float(alone), rel=within, abs=within * sizes.get(name, 0) + 1e-300)
    # of a batch those count that are kept
    right = min(one.accuracy.digits, 16)  # of a pair at rest a single solve knows all
    assert count < len(one.events) or right - 1 <= found.digits[k]
    # a single run counts what it is at jumps that are no events, too
    assert found.digits[k] <= right + 1 or len(one.record.rows) > len(one.events) + 1
    if bounds is not None:
        for own, other in (
            (found.event_y_error[:, k, :count].T, one.accuracy.y[:count]),
            (found.y_error[:, k], one.accuracy.final),
            (found.dissipated_error[k], one.accuracy.dissipated),
        ):
            assert (np.asarray(own) <= bounds * np.asarray(other)).all()
            assert (np.asarray(other) <= bounds * np.asarray(own)).all()


def require_in_bounds(found: Batch, scene):
    """Each number of a batch of one scene is off by at most its bound."""
    truth = solve(scene, digits=40, arithmetic="ball")
    assert found.status[0] == truth.status
    for _, x, bound, true in row_numbers(found, 0, truth):
        assert distance(x, true) <= bound <= 1e-8 * max(1, abs(x))


SPRING_ON_BELT = Pair(m1=2, m2="inf", a2=50, b=4)
IN_DOUBT = {
    "a cycle that only touches the belt's speed": Scene(SPRING_ON_BELT, State(), 10, belt=Force.constant("0.3")),
    "rest exactly at the edge": Scene(SPRING_ON_BELT, State(x1="0.4"), 20),
    "a horizon next to an event": Scene(Pair(1, 1, 200, "0.5"), State(v1="0.15"), float(solve(OPEN).events[2].t)),
}


@pytest.mark.parametrize("scene", IN_DOUBT.values(), ids=IN_DOUBT)
def test_a_list_of_scenes_goes_on_in_balls_where_floats_leave_one_open(scene):
    with pytest.raises(EventUndecided):
        solve(scene, arithmetic="float64")
    found = solve_scenes([scene], keep_events=2)
    assert found.success.all()
    require_in_bounds(found, scene)


def test_what_arrays_leave_open_is_said_in_a_sentence():
    third = float(solve(OPEN).events[2].t)
    found = solve_many(**PAPER, v1=0.15, until=[3.0, third, third])
    assert "scene [1], [2]: the error bounds do not decide" in repr(found)
    assert repr(found).endswith("solve(scene) goes on in balls")
    assert found.message[1].endswith("goes on in balls")
    grid = solve_many(**PAPER, v1=[[0.15], [0.1]], until=[3.0, third])
    assert "scene [0, 1]: " in repr(grid)


def test_a_stick_that_starts_exactly_on_its_edge_is_for_ever_in_a_batch_too():
    scene = Scene(Pair(m1=1, m2=1, a2=200, b="0.5"), State(x1="0.005", x2="0.005"), until=2)
    assert solve(scene).status == Status.STUCK_FOR_EVER
    assert solve_scenes([scene]).status.tolist() == [Status.STUCK_FOR_EVER]


GRID = {"v1": [0.1, 0.2], "b": [[0.05], [0.1], [0.2]]}
SHAPES = {
    "one": ({"v1": 0.1, "keep_events": 2}, ()),
    "none": ({"v1": []}, (0,)),
    "a grid": ({"v1": np.array([0.1, 0.15])[:, None], "x1": np.zeros((1, 3)), "keep_events": 4}, (2, 3)),
    "exact numbers": (GRID | {"exact": True}, (3, 2)),
    "a force": (GRID | {"force": Force.sine(1, 2)}, (3, 2)),
    "no scenes": ({"scenes": []}, (0,)),
    "scenes": ({"scenes": [load_scene("velocities")], "keep_events": 6, "max_events": 6}, (1,)),
}


@pytest.mark.parametrize("name", SHAPES)
def test_all_arrays_and_tables_have_the_shape_of_what_is_given(name):
    given, shape = SHAPES[name]
    found = solve_scenes(**given) if "scenes" in given else solve_many(**PAPER | {"until": 1} | given)
    assert {one.shape for one in (found.t, found.energy_excess, *found.inputs.values())} == {shape}
    assert (found.y.shape, found.event_y.shape) == ((4, *shape), (4, *shape, given.get("keep_events", 0)))
    assert len(found.to_dataframe()) == len(found) == np.prod(shape)
    assert len(found.to_xarray().sizes) == len(shape)


PARTS = {Pair: ("m1", "m2", "a2", "b", "a1"), State: ("x1", "v1", "x2", "v2")}


def scenes_of(given):
    """The scenes of the rows of a sweep: the same binary numbers, exactly."""
    more = {name: one for name, one in given.items() if name in {"law", "friction"}}
    powers, sines = given.get("polynomial", []), given.get("sines", [])
    numbers = {name: one for name, one in given.items() if name in {*PARTS[Pair], *PARTS[State], "until"}}
    for row in np.broadcast(*numbers.values(), *powers, *chain(*sines)):
        exact = iter([Fraction(float(one)) for one in row])
        named = {name: next(exact) for name in numbers}
        pair, at = (kind(**{name: named[name] for name in of if name in named}) for kind, of in PARTS.items())
        push = Piece(0, [next(exact) for _ in powers], [Sine(next(exact), next(exact), next(exact)) for _ in sines])
        yield Scene(pair, at, named["until"], force=Force([push] if powers or sines else ()), **more)


SOME = np.random.default_rng(11)
BESIDE = {"b": 0.0625, "a1": 1, "x1": SOME.choice([0, 0.02], 24), "until": SOME.choice([0.5, 0.9, 1.5, 4], 24)}
PHASES = np.where(np.arange(24) % 3, SOME.uniform(-3, 3, 24), -4.5)  # -4.5: sin(5 t - 4.5) is 0 at t = 0.9
BESIDE |= {"sines": [(SOME.uniform(0, 1, 24), 5, PHASES)], "keep_events": 9}
JUMPS = [("0.9", "0.02"), ("1.7", "1/3")]
SWEEPS = {
    "speeds": {"v1": np.linspace(0.02, 0.3, 29), "keep_events": 80},
    "body 2 slides for ten minutes": {"m2": 100, "v1": [0.125], "x2": 3, "v2": 3.125, "until": 700, "keep_events": 3},
    "a damper": {"a1": [4], "v1": 0.4375, "until": 3, "keep_events": 3},
    "a sine": {"b": 0.0625, "a1": [0.5], "v1": 0.125, "until": 3, "sines": [(0.375, 5, 0)], "keep_events": 3},
    "amplitudes from 0 on": {"x1": 0.02, "until": 3, "sines": [([0, 1], 5, 0)]},
    "horizons before and after jumps of friction": BESIDE | {"friction": Friction(JUMPS)},
    "the same from its own friction on": BESIDE | {"friction": Friction([(0, "0.3"), *JUMPS])},
    **{
        f"friction jumps at {t}": {"v1": 0.125, "a1": 3, "until": [5], "friction": Friction([(t, "0.5")])}
        for t in (2, 5, 7)
    },
}


@pytest.mark.parametrize("name", SWEEPS)
def test_rows_are_what_their_scenes_are_by_themselves(name):
    given = PAPER | {"until": 5} | SWEEPS[name]
    found, scenes = solve_many(**given), list(scenes_of(given))
    for k, scene in enumerate(scenes):
        require_alone(found, k, scene, within=1e-9, bounds=None if "friction" in given else 3)
    if given.get("keep_events") == 3:
        require_in_bounds(found, scenes[0])


def test_no_stick_is_for_ever_where_friction_changes_at_the_horizon_or_after_it():
    for t, ended in ((2, Status.STUCK_FOR_EVER), (5, Status.REACHED_HORIZON), (7, Status.REACHED_HORIZON)):
        given = PAPER | SWEEPS[f"friction jumps at {t}"]
        assert solve_many(**given).status[0] == solve_scenes([*scenes_of(given)]).status[0] == ended


def test_x2_has_a_bound_of_its_own_and_a_sine_of_amplitude_0_is_no_force():
    errors = solve_many(**PAPER | SWEEPS["body 2 slides for ten minutes"]).event_y_error
    assert errors[2, 0, 0] > 10 * errors[0, 0, 0]
    given = PAPER | SWEEPS["amplitudes from 0 on"]
    rows, scenes = solve_many(**given).y.T, scenes_of(given)
    assert rows.tolist() == [list(solve(one, arithmetic="float64").final_state) for one in scenes]


@given(st.integers(0, 2**32 - 1), st.sampled_from(Law))
@example(303, Law.FILIPPOV)  # ends with little energy: its digits are those of the largest
def test_rows_under_a_force_are_what_their_scenes_give_by_themselves_in_any_order(seed, law):
    """Numbers are binary fractions; some rows differ from one before by one number alone."""
    random = np.random.default_rng(seed)
    rows = [random.integers(1, 64, 14) / 16]
    for _ in range(4):
        row = rows[random.integers(len(rows))].copy() if random.random() < 0.5 else random.integers(1, 64, 14) / 16
        row[random.integers(14)] = random.integers(1, 64) / 16
        rows.append(row)

    def swept(table):
        u, *sine = (columns := np.array(table).T)[10:]
        named = dict(zip((*PARTS[Pair], *PARTS[State], "until"), columns, strict=False))
        return named | {"polynomial": [u], "sines": [sine], "law": law, "keep_events": 6, "max_events": 40}

    found, backwards = (solve_many(**swept(table)) for table in (rows, rows[::-1]))
    np.testing.assert_allclose(backwards.y[:, ::-1], found.y, rtol=1e-9, atol=1e-200)
    for k, scene in enumerate(scenes_of(swept(rows))):
        require_alone(found, k, scene, 40, 1e-9)


def test_scenes_of_any_pieces_are_what_they_are_by_themselves():
    """Forces and frictions by pieces: the same bits."""
    scenes = [a_scene(np.random.default_rng((7, k))) for k in range(60)]
    scenes = [one for one in scenes if one.law is Law.FILIPPOV]
    found = solve_scenes(scenes, keep_events=5, max_events=40)
    for k, one in enumerate(scenes):
        require_alone(found, k, one, 40, within=1e-15, bounds=3)


def test_the_bounds_of_a_batch_hold_where_friction_depends_on_the_state():
    friction = Friction([("0.3", "0.7")], Weakening([("0.1", "0.4")], 0))
    scene = Scene(Pair(1, 1, 200, "0.5", 1), State(v1="0.3"), 2, force=Force.sine("0.4", 5), friction=friction)
    require_in_bounds(solve_scenes([scene], keep_events=3), scene)


@pytest.mark.parametrize("piece", [("1e-400", "0.02"), (1, "1e-400"), (1, "1e400")])
def test_a_friction_that_floats_do_not_hold_is_what_its_scene_says(piece):
    friction = Friction([piece, (2, "0.3")])
    found = solve_many(1, 1, 200, 0.0625, v1=0.125, until=3, friction=friction)
    assert same(found, solve_many(1, 1, 200, 0.0625, v1=0.125, until=3, friction=friction, exact=True))


def test_columns_under_a_force_form_the_ledger_when_it_is_looked_at(monkeypatch):
    """A copy does, too; rows of the free pair among them have theirs, and one out of range has none."""
    monkeypatch.setattr(batch, "_TOO_FEW", 3)
    amplitude, b = np.array([0.375, 0.0, 0.5, 1.0, 0.75]), np.array([0.5, 0.5, 0.0625, 1e-300, 0.25])
    sines, start = [(amplitude, 5.0, 0.25)], {"v1": 0.125, "until": 3}
    found = solve_many(1, 1, 200, b, a1=[1, 0, 0, 0, 2], sines=sines, **start, keep_events=4)
    copy = pickle.loads(pickle.dumps(found))
    exact = solve_many(1, 1, 200, b, a1=[1, 0, 0, 0, 2], sines=sines, **start, exact=True)
    assert np.isnan(found.dissipated).tolist() == (~exact.success).tolist() == [False, False, False, True, False]
    assert np.isnan(found.event_t[3]).all()  # what a run wrote before it left the range is in no unit of the caller
    np.testing.assert_allclose(found.dissipated, exact.dissipated, rtol=1e-11)
    np.testing.assert_allclose(np.log(found.dissipated_error), np.log(exact.dissipated_error), atol=np.log(3))
    assert (found.dissipated[found.success] > 0).all()
    assert same(found, copy)


def test_many_chunks_threads_and_progress(monkeypatch):
    monkeypatch.setattr(batch, "_CHUNK", 7)
    monkeypatch.setattr(batch, "_TOO_FEW", 1)
    speeds, told = np.linspace(0.02, 0.3, 50), []
    one = solve_many(**PAPER, v1=speeds, until=3, jobs=1)
    two = solve_many(**PAPER, v1=speeds, until=3, jobs=2, progress=lambda done, whole: told.append((done, whole)))
    assert same(one, two)
    assert told[-1] == (50, 50)
    assert len(told) >= 8
    assert [done for done, _ in told] == sorted({done for done, _ in told})


def test_two_threads_may_be_the_first_to_compile():
    """In a process of its own, as kernels are compiled once: numba's own cache folder is left as it was."""
    pytest.importorskip("numba")
    code = (
        "import numba, numpy as np; from numerics import solve_many; from numerics.solver import rows as batch;"
        "before = numba.config.CACHE_DIR;"
        "batch._CHUNK, batch._TOO_FEW = 2, 1;"
        "found = solve_many(1, 1, 200, 0.5, v1=np.linspace(0.1, 0.3, 12), until=2, jobs=4);"
        "assert numba.config.CACHE_DIR == before; print(int(found.events.sum()))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) == solve_many(**PAPER, v1=np.linspace(0.1, 0.3, 12), until=2).events.sum()


def test_without_numba_the_same_numbers_come_out():
    """In a process of its own: what is compiled once stays so."""
    code = (
        "import sys, pickle, numpy as np; from numerics import solve_many;"
        "found = solve_many(1, 1, 200, 0.5, v1=np.linspace(0.02, 0.3, 9), until=3, keep_events=5, jobs=2);"
        "out = solve_many(1, [1, 1e-300, 1], 200, [0.5, 0.5, 1e-300], v1=[0.15, 0.15, 1e100], until=2);"
        "assert 'numba' not in sys.modules;"
        "sys.stdout.buffer.write(pickle.dumps((found, out.status.tolist())))"
    )
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=False, env=environment)
    assert done.returncode == 0, done.stderr
    slow, status = pickle.loads(done.stdout)
    fast = solve_many(1, 1, 200, 0.5, v1=np.linspace(0.02, 0.3, 9), until=3, keep_events=5)
    for name in (
        "status",
        "events",
        "mode",
        "t",
        "y",
        "dissipated",
        "energy_excess",
        "event_t",
        "event_y",
        "event_mode",
    ):
        ours, theirs = getattr(slow, name), getattr(fast, name)
        np.testing.assert_allclose(ours, theirs, rtol=1e-12, atol=1e-13)
        if f"{name}_error" in vars(fast):  # each by its own bounds: matrices are rounded once, or formed in floats
            bounds = (np.nan_to_num(getattr(one, f"{name}_error")) for one in (slow, fast))
            assert np.less_equal(next(bounds), 3 * next(bounds)).all()
    assert status == [Status.REACHED_HORIZON, Status.OUT_OF_RANGE, Status.OUT_OF_RANGE]


def test_a_pair_at_rest_has_the_digits_that_its_bounds_leave():
    found = solve_many(1, 1, 200, 0.5, a1=1, x2=0.3, until=1e4)
    assert 10.0 ** -(found.digits + 1) < found.y_error[2] / 0.3 < 10.0**-found.digits


def test_an_excess_is_off_by_what_its_state_is():
    found = solve_many(1, 1, 200, 0.5, a1=1, v1=0.15, until=1)
    found._runs.ends[0, AT["x1_error"] : AT["v2_error"] + 1] = off = 1e-4
    by = np.array([200, 1, 0, 1]) / 2
    true = (by @ (abs(found.y) + off) ** 2 - by @ found.y**2) / 0.0025
    assert true < found.energy_excess_error < 1.1 * true
