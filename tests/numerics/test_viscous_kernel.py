"""Viscous scenes in the binary64 kernels: the bits of the generic path, bounds that hold, runs that go on."""

import math
from fractions import Fraction
from itertools import pairwise
from random import Random

import numpy as np
import pytest
from hypothesis import event, example, given, settings
from hypothesis import strategies as st
from strategies import viscous_scenes

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.audit.draws import KINDS
from numerics.errors import NumericsError
from numerics.kernel import packed, viscous_packed, viscous_prepare
from numerics.kernel.compilation import compiled
from numerics.kernel.state import EVENT_LIMIT, OUT_OF_RANGE, REACHED, ROWS_FULL, STUCK
from numerics.kernel.viscous_motion import COLUMNS
from numerics.old.binary64_viscous import solve_viscous, viscous_start
from numerics.scene import Law, Pair, Scene, State
from numerics.solver.solve import integrate
from numerics.trajectory.trajectory import Status

EVENTS = 20
STATUS = {REACHED: Status.REACHED_HORIZON, STUCK: Status.STUCK_FOR_EVER, EVENT_LIMIT: Status.EVENT_LIMIT}
FAILURES = (NumericsError, ArithmeticError, ValueError)
EXACTLY_CRITICAL = [
    Scene(Pair(1, 1, 1, 1, a1=2), State(x1=1, v1=5), until=20),  # slip
    Scene(Pair(1, 1, 2, 1, a1=4), State("0.3", 2, 0, -3), until=20),  # stick
]


def start(scene: Scene):
    try:
        return viscous_start(scene)
    except NumericsError:
        return None


def run(state, *, use=lambda kernel: kernel, rows: int = EVENTS + 1):
    """Events, state and answer of a run; the state says OUT_OF_RANGE where plain Python raised."""
    kept, state, answer = np.zeros((rows, len(COLUMNS))), state.copy(), np.zeros(viscous_packed.DAMPED_ANSWER)
    found = []
    while True:
        try:
            count = use(viscous_packed.advance)(state, EVENTS, kept)
        except FAILURES:
            state[packed.HOW] = OUT_OF_RANGE
            return np.zeros((0, len(COLUMNS))), state, answer
        found.append(kept[:count].copy())
        if state[packed.HOW] != ROWS_FULL:
            break
    if state[packed.HOW] != OUT_OF_RANGE:
        use(viscous_packed.answer)(state, answer)
    return np.concatenate(found), state, answer


@given(viscous_scenes())
@example(EXACTLY_CRITICAL[0])
@example(EXACTLY_CRITICAL[1])
@example(Scene(Pair(1, 1, 1, 1, a1="1e-6"), State(v2="2e7"), until=10))  # more pieces than are inspected
def test_the_kernels_give_the_bits_of_the_generic_path(scene):
    try:
        trajectory = integrate(scene, Float64(), EVENTS)
    except FAILURES:
        trajectory = None
    begun = start(scene)
    if begun is None:
        assert trajectory is None
        return
    rows, state, answer = run(begun[2])
    if trajectory is None:
        assert state[packed.HOW] == OUT_OF_RANGE
        return
    assert STATUS[int(state[packed.HOW])] is trajectory.status
    assert len(rows) == len(trajectory.events) == state[packed.EVENTS]
    event(f"regime of stick {int(state[4])}, of slip {int(state[6])}, {min(len(rows), 3)} events")
    for row, one, segment in zip(rows, trajectory.events, trajectory.segments, strict=False):
        at = one.reduced
        assert (at.X, at.V2, at.Z, at.w) == tuple(row[4:8])
        assert (segment.end, segment.length, one.after.sign) == (row[2], row[3], row[0])
    if trajectory.success:
        assert tuple(trajectory.final) == tuple(answer[1:6])
        assert trajectory.final_mode.sign == answer[0]


@given(viscous_scenes())
@example(EXACTLY_CRITICAL[0])
def test_the_trajectory_is_the_generic_one(scene):
    try:
        expected = integrate(scene, Float64(), EVENTS)
    except FAILURES:
        expected = None
    if start(scene) is None:
        assert expected is None
        return
    found = solve_viscous(scene, EVENTS)
    event("refused" if found is None else "solved")
    if expected is None:
        assert found is None
        return
    assert found is not None
    assert found.bounds is not None
    assert (found.status, found.events, found.modes) == (expected.status, expected.events, expected.modes)
    np.testing.assert_array_equal(found.t, expected.t)
    np.testing.assert_array_equal(found.y, expected.y)


@given(viscous_scenes())
@example(EXACTLY_CRITICAL[0])
@example(EXACTLY_CRITICAL[1])
def test_compiled_and_plain_python_give_the_same_bits(scene):
    pytest.importorskip("numba")
    begun = start(scene)
    if begun is None:
        return
    plain, fast = run(begun[2]), run(begun[2], use=compiled)
    if plain[1][packed.HOW] == OUT_OF_RANGE:
        assert fast[1][packed.HOW] == OUT_OF_RANGE
        return
    for one, two in zip(plain, fast, strict=True):
        np.testing.assert_array_equal(one, two)


def excesses(scene: Scene, state, rows, answer):
    """How many times its bound each error is, against 60 digits; None where nothing is claimed or known."""
    if state[packed.HOW] == OUT_OF_RANGE or answer[14] == 0.0:
        return None
    try:
        truth = integrate(scene, Ball(60), EVENTS)
    except NumericsError:
        return None
    assert [one.after.sign for one in truth.events] == rows[:, 0].tolist()
    ratios = []
    with truth.arithmetic.context():
        pairs = []
        for row, one, segment in zip(rows, truth.events, truth.segments, strict=False):
            at = one.reduced
            pairs += zip(row[[2, 4, 5, 6, 7]], row[11:16], (segment.end, at.X, at.V2, at.Z, at.w), strict=True)
        losses = [segment.motion.losses(segment.length) for segment in truth.segments]
        final = truth.final if truth.success else truth.events[-1].reduced
        friction, viscous = (sum((loss[i] for loss in losses), truth.arithmetic.number(0)) for i in (0, 1))
        pairs += zip(answer[1:7], answer[7:13], (*final, friction), strict=True)
        pairs.append((answer[18], answer[19], viscous))
        for value, bound, true in pairs:
            off = float(abs(true - float(value)).upper())
            ratios.append(off / bound if bound > 0.0 else math.inf * off if off else 0.0)
    return ratios


@given(viscous_scenes())
@example(EXACTLY_CRITICAL[0])
@example(EXACTLY_CRITICAL[1])
def test_the_bounds_hold(scene):
    begun = start(scene)
    if begun is None:
        return
    rows, state, answer = run(begun[2])
    ratios = excesses(scene, state, rows, answer)
    event("nothing claimed" if ratios is None else "claimed")
    assert max(ratios or [0.0]) <= 1.0


@pytest.mark.parametrize("kind", KINDS)
def test_the_bounds_hold_at_the_extremes_of_the_audit(kind):
    random, claimed = Random(f"viscous {kind}"), 0
    for _ in range(max(30, settings().max_examples // 5)):
        scene = KINDS[kind](random)
        if scene.pair.a1 == 0:
            pair, damping = scene.pair, Fraction(10) ** random.randint(-8, 2)
            a1 = damping * Fraction(math.sqrt(pair.a2 * pair.mass))
            scene = Scene(Pair(pair.m1, pair.m2, pair.a2, pair.b, a1), scene.initial, scene.until)
        begun = start(scene)
        if begun is None:
            continue
        rows, state, answer = run(begun[2])
        ratios = excesses(scene, state, rows, answer)
        claimed += ratios is not None
        assert max(ratios or [0.0]) <= 1.0, scene
    assert claimed > 0 or kind == "near critical"


@pytest.mark.parametrize("column", [9, 11])
def test_an_error_that_the_bounds_do_not_know_of_is_noticed(column):
    scene = Scene(Pair(2, 1, 3, 1, a1=1), State("-0.3", "1.1", 0, -3), until=20)
    _, _, state = viscous_start(scene)
    assert max(excesses(scene, *order(run(state)))) <= 1.0
    state[column] *= 1 + 1e-13
    assert max(excesses(scene, *order(run(state)))) > 1.0


def order(found):
    rows, state, answer = found
    return state, rows, answer


@given(viscous_scenes(), st.integers(1, 4))
def test_a_run_in_pieces_is_the_same_run(scene, rows):
    begun = start(scene)
    if begun is None:
        return
    whole, pieces = run(begun[2]), run(begun[2], rows=rows)
    if whole[1][packed.HOW] != OUT_OF_RANGE:
        for one, two in zip(whole, pieces, strict=True):
            np.testing.assert_array_equal(one, two)


@given(viscous_scenes())
def test_what_is_lost_is_what_was_taken(scene):
    begun = start(scene)
    if begun is None:
        return
    _, state, answer = run(begun[2])
    if state[packed.HOW] == OUT_OF_RANGE or answer[14] == 0.0:
        return
    before, after, taken = begun[1].start.w, answer[5], answer[6] + answer[18]
    allowed = answer[[11, 12, 19]].sum() + 1e-15 * (abs(before) + abs(after) + taken)
    assert abs(before - after - taken) <= allowed


def as_floats(scene: Scene) -> list[float]:
    pair, at = scene.pair, scene.initial
    numbers = (pair.m1, pair.m2, pair.a2, pair.b, at.x1, at.v1, at.x2, at.v2, scene.until, pair.a1)
    return [float(number) for number in numbers]


@given(viscous_scenes())
def test_scenes_from_arrays_start_with_the_same_bits(scene):
    si = as_floats(scene)
    m1, m2, a2, b, x1, v1, x2, v2, until, a1 = (Fraction(number) for number in si)
    same = Scene(Pair(m1, m2, a2, b, a1), State(x1, v1, x2, v2), until, scene.law)
    state = np.zeros(packed.STATE)
    prepared = viscous_prepare.prepare(si, scene.law is Law.THREE_VALUED_SGN, state)
    event("prepared" if prepared else "left to exact arithmetic")
    if prepared:
        np.testing.assert_array_equal(state, viscous_start(same)[2])


def test_a_batch_is_its_scenes_one_by_one():
    pair = Pair(1, 2, 3, 1, a1="0.25")
    scenes = [Scene(pair, State("0.2", v, 0, "-0.7"), until=30) for v in ("0.1", "1.5", "-2.25")]
    undamped = [*as_floats(scenes[0])[:-1], 0.0]
    si = np.array([as_floats(scene) for scene in scenes] + [undamped])
    states, answers = np.zeros((4, packed.STATE)), np.zeros((4, viscous_packed.DAMPED_ANSWER))
    viscous_prepare.prepare_all(si, False, states)
    kept, nothing = np.zeros((4, EVENTS + 1, len(COLUMNS))), np.zeros((0, len(COLUMNS)))
    viscous_packed.run_keeping(states, EVENTS, answers, kept, nothing)
    for row, scene in zip(answers, scenes, strict=False):
        np.testing.assert_array_equal(row, run(viscous_start(scene)[2])[2])
    assert states[3, packed.HOW] == -1.0
    np.testing.assert_array_equal(answers[3], 0.0)


def test_undamped_scenes_are_not_for_these_kernels():
    with pytest.raises(ValueError, match="a1 must be > 0"):
        viscous_start(Scene(Pair(1, 1, 1, 1), State(x1=1), until=1))


def test_a_graze_is_called_uncertain():
    """Between two starts the guard of a slip just touches zero: next to it no sequence may be called certain."""
    pair = Pair(1, 1, 1, 1, a1="0.01")

    def first_event(v1):
        rows, _, answer = run(viscous_start(Scene(pair, State(-3, v1, 0, -20), until=100))[2])
        return rows[0, 2], bool(answer[14])

    starts = [Fraction(i, 16) for i in range(-64, 65)]
    low, high = next((a, b) for a, b in pairwise(starts) if abs(first_event(a)[0] - first_event(b)[0]) > 1)
    assert first_event(low)[1]
    assert first_event(high)[1]
    for _ in range(60):
        middle = (low + high) / 2
        time = first_event(middle)[0]
        nearer_low = abs(time - first_event(low)[0]) < abs(time - first_event(high)[0])
        low, high = (middle, high) if nearer_low else (low, middle)
    assert not first_event(low)[1]
    assert not first_event(high)[1]


@pytest.mark.parametrize("event", [0, 1, 2])
def test_an_event_next_to_the_horizon_is_called_uncertain(event):
    pair, initial = Pair(2, 1, 3, 1, a1="0.1"), State("-0.3", "2.1", 0, -3)
    time = Fraction(integrate(Scene(pair, initial, 20), Float64(), EVENTS).events[event].t)

    def certain(off):
        return bool(run(viscous_start(Scene(pair, initial, time * (1 + off)))[2])[2][14])

    assert not any(certain(sign * Fraction(1, 10**17)) for sign in (-1, 0, 1))
    assert all(certain(sign * Fraction(1, 10**9)) for sign in (-1, 1))
