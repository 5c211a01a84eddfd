"""solve_many and solve_scenes: arrays in, arrays out, the results of `solve`."""

import os
import pickle
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from functools import partial

import numpy as np
import pytest
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


def same(found: Batch, other: Batch) -> bool:
    names = ["status", "events", "mode", "t", "y", "y_error", "event_t", "event_y", "energy_excess"]
    names += ["dissipated", "dissipated_error", "digits"]
    return all(np.array_equal(getattr(found, name), getattr(other, name), equal_nan=True) for name in names)


def require_alone(found: Batch, k, scene, most=MAX_EVENTS, within=1e-13, bounds=None):
    """A row is what its scene is by itself: how it ended, events and end; its bounds are `bounds` times as large."""
    try:
        one = solve(replace(scene), arithmetic="float64", max_events=most)  # of nothing that the batch has made
    except (EventUndecided, OutOfRange) as error:
        refused = Status.OUT_OF_RANGE if isinstance(error, OutOfRange) else Status.SEQUENCE_OPEN
        assert found.status[k] == refused
        return
    assert bool(found.certain[k]) == one.accuracy.certain
    if not one.certain:
        return
    count = min(found.event_t.shape[-1], len(one.events))
    assert (found.events[k], found.status[k], found.mode[k]) == (len(one.events), one.status, one.final_mode.sign)
    assert found.success[k] == one.success
    assert found.event_mode[k, :count].tolist() == [event.after.sign for event in one.events[:count]]
    assert np.isnan(found.event_t[k, count:]).all()
    near = partial(np.testing.assert_allclose, rtol=within)
    near(found.event_t[k, :count], one.event_times[:count])
    near(found.y[:, k], one.final_state, atol=within * abs(one.y).max())
    excess = one.reduced.final.w
    np.testing.assert_allclose(found.energy_excess[k], excess, atol=max(within, 1e-13) * (1 + abs(excess)))
    near(found.dissipated[k], one.dissipated, atol=1e-300)
    # of a batch those count that are kept
    right = min(one.accuracy.digits, 16)  # of a pair at rest a single solve knows all
    assert count < len(one.events) or right - 1 <= found.digits[k] <= right + 1
    if bounds is not None:
        for own, other in (
            (found.event_y_error[:, k, :count].T, one.accuracy.y[:count]),
            (found.y_error[:, k], one.accuracy.final),
            (found.dissipated_error[k], one.accuracy.dissipated),
        ):
            assert (np.asarray(own) <= bounds * np.asarray(other)).all()
            assert (np.asarray(other) <= bounds * np.asarray(own)).all()


def against_balls(found: Batch, scene):
    """Each number of a batch of one scene, with its first three events, how far it is off, and its bound."""
    truth = solve(scene, digits=40, arithmetic="ball")
    assert (found.events[0], found.status[0]) == (len(truth.events), truth.status)
    with truth.arithmetic.context():
        numbers = [
            (found.y, truth.final_state, found.y_error),
            (found.event_t[0], truth.event_times[:3], found.event_t_error[0]),
            (found.dissipated, [truth.ledger.friction + truth.ledger.viscous], found.dissipated_error),
            (found.event_y[:, 0], truth.event_states[:, :3], found.event_y_error[:, 0]),
        ]
        for three in numbers:
            for x, y, bound in zip(*map(np.ravel, three), strict=True):
                yield float(x), distance(float(x), y), float(bound)


def test_the_batch_has_the_results_of_solve():
    speeds = np.linspace(0.02, 0.3, 29)
    found = solve_many(**PAPER, v1=speeds, until=5, keep_events=80)
    for k, v1 in enumerate(speeds):
        require_alone(found, k, Scene(Pair(1, 1, 200, "0.5"), State(v1=Fraction(v1)), 5), bounds=3)


SLIDING = Scene(Pair(1, 100, 200, "0.5"), State(v1="0.125", x2=3, v2="3.125"), until=700)
"""Body 2 slides for ten minutes before the first event."""
DAMPED = Scene(Pair(1, 1, 200, "0.5", a1=4), State(v1="0.4375"), until=3)
FORCED = Scene(Pair(1, 1, 200, "0.0625", "0.5"), State(v1="0.125"), until=3, force=Force.sine("0.375", 5))


@pytest.mark.parametrize("scene", [SLIDING, DAMPED, FORCED])
def test_the_bounds_of_a_batch_are_those_of_a_single_solve_and_hold(scene):
    numbers = {name: float(getattr(scene.pair, name)) for name in ("m1", "m2", "a2", "b", "a1")}
    numbers |= {name: float(getattr(scene.initial, name)) for name in ("x1", "v1", "x2", "v2")}
    sines = [(float(s.amplitude), float(s.omega), 0.0) for piece in scene.force.pieces for s in piece.sines]
    found = solve_many(**numbers, until=[float(scene.until)], sines=sines, keep_events=3)
    require_alone(found, 0, scene, within=1e-11, bounds=3)
    for _, off, bound in against_balls(found, scene):
        assert off <= bound
    if scene is SLIDING:
        assert found.event_y_error[2, 0, 0] > 10 * found.event_y_error[0, 0, 0]  # x2 has a bound of its own


@given(st.integers(0, 2**32 - 1), st.sampled_from(Law))
@example(303, Law.FILIPPOV)  # ends with little energy: its digits are those of the largest
def test_rows_under_a_force_are_what_their_scenes_give_by_themselves_in_any_order(seed, law):
    """Numbers are binary fractions; some rows differ from one before by one number alone."""
    random = np.random.default_rng(seed)
    names = ["m1", "m2", "a2", "b", "a1", "x1", "v1", "x2", "v2", "until", "u", "amplitude", "omega", "phase"]
    rows = [random.integers(1, 64, len(names)) / 16]
    for _ in range(4):
        row = rows[random.integers(len(rows))].copy() if random.random() < 0.5 else random.integers(1, 64, 14) / 16
        row[random.integers(len(names))] = random.integers(1, 64) / 16
        rows.append(row)

    def solved(table):
        column = dict(zip(names, np.array(table).T, strict=True))
        u, *sine = (column.pop(name) for name in names[10:])
        return solve_many(**column, polynomial=[u], sines=[tuple(sine)], law=law, keep_events=6, max_events=40)

    found, backwards = solved(rows), solved(rows[::-1])
    np.testing.assert_allclose(backwards.y[:, ::-1], found.y, rtol=1e-9, atol=1e-200)
    for k, row in enumerate(rows):
        m1, m2, a2, b, a1, x1, v1, x2, v2, until, u, *sine = map(Fraction, row.tolist())
        force = Force([Piece(0, [u], [Sine(*sine)])])
        require_alone(found, k, Scene(Pair(m1, m2, a2, b, a1), State(x1, v1, x2, v2), until, law, force), 40, 1e-9)


def test_a_sweep_of_amplitudes_may_begin_at_0():
    """There the row is one of the free pair, and so is the scene: a sine of amplitude 0 is no force."""
    found = solve_many(1, 1, 200, "0.5", x1=0.02, until=3, sines=iter([([0, 1], 5, 0)]))
    for k in range(2):
        scene = Scene(Pair(1, 1, 200, "0.5"), State(x1=Fraction(0.02)), until=3, force=Force.sine(k, 5))
        require_alone(found, k, scene)
        assert found.y[:, k].tolist() == list(solve(scene, arithmetic="float64").final_state)


def test_scenes_of_any_pieces_are_what_they_are_by_themselves():
    """Forces and frictions by pieces: the same bits."""
    scenes = [a_scene(np.random.default_rng((7, k))) for k in range(60)]
    scenes = [one for one in scenes if one.law is Law.FILIPPOV]
    found = solve_scenes(scenes, keep_events=5, max_events=40)
    for k, one in enumerate(scenes):
        require_alone(found, k, one, 40, within=1e-15, bounds=3)


def test_one_friction_by_pieces_beside_sines_is_what_the_scenes_are_by_themselves():
    """Horizons before and after its jumps, phases that cancel there, its own b from the start on or the row's."""
    random, count = np.random.default_rng(11), 24
    phase = np.where(np.arange(count) % 3, random.uniform(-3, 3, count), -4.5)  # -4.5: sin(5 t - 4.5) at t = 0.9
    until, x1 = random.choice([0.5, 0.9, 1.5, 4], count), random.choice([0, 0.02], count)
    amplitude = random.uniform(0, 1, count)
    for first in ([], [(0, "0.3")]):
        friction, pair = Friction([*first, ("0.9", "0.02"), ("1.7", "1/3")]), Pair(1, 1, 200, "0.0625", 1)
        sines = [(amplitude, 5, phase)]
        found = solve_many(1, 1, 200, 0.0625, a1=1, x1=x1, until=until, sines=sines, friction=friction, keep_events=9)
        for k in range(count):
            force = Force.sine(*(Fraction(float(one)) for one in (amplitude[k], 5, phase[k])))
            start, end = State(x1=Fraction(float(x1[k]))), Fraction(float(until[k]))
            require_alone(found, k, Scene(pair, start, end, force=force, friction=friction), within=1e-9)


def test_no_stick_is_for_ever_where_friction_changes_at_the_horizon_or_after_it():
    for jump, ended in ((2, Status.STUCK_FOR_EVER), (5, Status.REACHED_HORIZON), (7, Status.REACHED_HORIZON)):
        friction = Friction([(jump, "0.5")])
        found = solve_many(**PAPER, v1=0.125, a1=3, until=[5], friction=friction)
        scene = Scene(Pair(1, 1, 200, "0.5", 3), State(v1="0.125"), 5, friction=friction)
        assert found.status[0] == solve_scenes([scene]).status[0] == ended
        require_alone(found, 0, scene)


def test_the_bounds_of_a_batch_hold_where_friction_depends_on_the_state():
    friction = Friction([("0.3", "0.7")], Weakening([("0.1", "0.4")], 0))
    scene = Scene(Pair(1, 1, 200, "0.5", 1), State(v1="0.3"), 2, force=Force.sine("0.4", 5), friction=friction)
    found = solve_scenes([scene], keep_events=3)
    for x, off, bound in against_balls(found, scene):
        assert off <= bound <= 1e-11 * max(1, abs(x))


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


def test_shapes_broadcast():
    found = solve_many(**PAPER, v1=np.array([0.1, 0.15])[:, None], x1=np.zeros((1, 3)), until=2, keep_events=4)
    assert found.t.shape == (2, 3)
    assert found.y.shape == (4, 2, 3)
    assert found.event_y.shape == (4, 2, 3, 4)
    assert solve_many(**PAPER, v1=0.1, until=2).t.shape == ()
    assert solve_many(**PAPER, v1=[], until=2).t.shape == (0,)
    with pytest.raises(ValueError, match=r"x1 \(3,\), v1 \(2,\)"):
        solve_many(**PAPER, v1=[1.0, 2.0], x1=[1.0, 2.0, 3.0], until=2)


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
        "sys.stdout.buffer.write(pickle.dumps((found.ends, found.kept, out.status.tolist())))"
    )
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=False, env=environment)
    assert done.returncode == 0, done.stderr
    ends, kept, status = pickle.loads(done.stdout)
    fast = solve_many(1, 1, 200, 0.5, v1=np.linspace(0.02, 0.3, 9), until=3, keep_events=5)
    bounds = slice(
        AT["late"], AT["speed_error"] + 1
    )  # each by its own bounds: matrices are rounded once, or formed in floats
    for ours, theirs in ((ends, fast.ends), (kept, fast.kept)):
        numbers = np.delete(np.arange(AT["late"]), AT["local_rest"])
        np.testing.assert_allclose(ours[..., numbers], theirs[..., numbers], rtol=1e-12, atol=1e-13)
        assert (np.nan_to_num(ours[..., bounds]) <= 3 * np.nan_to_num(theirs[..., bounds])).all()
    assert status == [Status.REACHED_HORIZON, Status.OUT_OF_RANGE, Status.OUT_OF_RANGE]


@pytest.mark.parametrize(
    ("given_", "said"),
    [
        ({"m1": [1, 0]}, r"m1\[1\] = 0 must be > 0"),
        ({"m2": [1, np.inf]}, "m2.1. = inf must be > 0 and finite; solve_scenes takes such scenes"),
        ({"a2": 0}, "a2 = 0 must be > 0 and finite; solve_scenes takes such scenes"),
        ({"a1": [1, -2]}, r"a1\[1\] = -2 must be >= 0"),
        ({"v1": [0, np.nan]}, r"v1\[1\] = nan must be finite"),
        ({"v1": np.array([0.1 + 0.2j])}, "v1 = .* must be real numbers"),
        ({"law": "coulomb"}, "law = 'coulomb' is not one of"),
        ({"v1": np.ma.masked_array([0.1, 0.2], [True, False]), "exact": True}, "masked"),
        ({"b": [1, 2, 3], "friction": [(1, 0.5)]}, r"give a Friction\(\[...\]\), or a list"),
        ({"max_events": 10**20}, "from 1 to 2"),
        ({"exact": "x"}, "exact = 'x' must be True"),
        ({"keep_events": -1}, "keep_events = -1"),
        ({"keep_events": 10**9}, "keep_events = 1000000000 must be at most max_events = 250000; give"),
        ({"keep_events": 7, "max_events": 6}, "keep_events = 7 must be at most max_events = 6; give"),
        (
            {"keep_events": 10**15, "max_events": 10**15},
            r"1 scenes with keep_events = 10* take [\d.e+]* GiB, more .*; ask",
        ),
        (
            {"keep_events": 2**62, "max_events": 2**62},
            r"1 scenes with keep_events = \d* take [\d.e+]* GiB, more .*; ask",
        ),
        (
            {"v1": np.zeros((10**7, 1)), "v2": np.zeros(10**7)},
            r"10{14} scenes take [\d.e+]* GiB, more .*; ask for fewer",
        ),
    ],
)
def test_a_wrong_number_is_named(given_, said):
    with pytest.raises(ValueError, match=said):
        solve_many(**(PAPER | {"until": 5} | given_))


def test_so_is_what_takes_more_memory_than_there_is_on_a_surface_and_of_a_list_of_scenes():
    for scene in (load_scene("velocities"), load_scene("plane-circle-merges")):
        with pytest.raises(
            ValueError, match=r"1 scenes with keep_events = 10* take [\d.e+]* GiB, more .*; ask for fewer"
        ):
            solve_scenes([scene], keep_events=10**15, max_events=10**15)
    assert solve_scenes([load_scene("velocities")], keep_events=6, max_events=6).events == 6


def test_a_pair_at_rest_has_the_digits_that_its_bounds_leave():
    found = solve_many(1, 1, 200, 0.5, a1=1, x2=0.3, until=1e4)
    assert 10.0 ** -(found.digits + 1) < found.y_error[2] / 0.3 < 10.0**-found.digits


def test_an_excess_is_off_by_what_its_state_is():
    found = solve_many(1, 1, 200, 0.5, a1=1, v1=0.15, until=1)
    found.ends[0, AT["x1_error"] : AT["v2_error"] + 1] = off = 1e-4
    by = np.array([200, 1, 0, 1]) / 2
    true = (by @ (abs(found.y) + off) ** 2 - by @ found.y**2) / 0.0025
    assert true < found.energy_excess_error < 1.1 * true
