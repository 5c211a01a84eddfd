"""The float64 kernels: one algorithm with the general loop, bit for bit, compiled or not; honest error bounds."""

import dataclasses
import math
from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from hypothesis import example, given, settings
from hypothesis import strategies as st
from strategies import decimals, long_slips, near_critical, scenes, signed

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.audit.bounds import Honesty
from numerics.errors import NumericsError, OutOfRange
from numerics.kernel import compilation, packed
from numerics.kernel.bounds import passing
from numerics.kernel.contact import contact
from numerics.kernel.prepare import prepare
from numerics.kernel.state import COLUMNS
from numerics.old.binary64 import kernel_start, solve_binary64
from numerics.scene import Law, Pair, Scene, State
from numerics.scene.file import load_scene
from numerics.solver.solve import integrate, solve

PAPER = load_scene("relative-motion-b05")
any_scene = st.one_of(
    scenes(size=(-2, 2)),
    scenes(exponents=(-9, 9)),
    near_critical(exponents=(3, 80)),
    long_slips(),
    scenes(law=Law.THREE_VALUED_SGN),
)
more = settings(max_examples=6 * settings().max_examples)


@more
@given(any_scene)
@example(PAPER)
@example(load_scene("itinerary-that-creeps"))
@example(Scene(Pair(Fraction(1, 10**7), 10**9, 1, 1), State(v2=-Fraction(1, 10**4)), 198))
def test_the_kernels_give_the_bits_of_the_general_loop(scene):
    try:
        general = integrate(scene, Float64(), 40)
    except OutOfRange:
        with pytest.raises(OutOfRange):
            solve(scene, max_events=40)
        return
    fast = solve_binary64(scene, 40)
    assert fast is not None
    assert fast.status is general.status
    assert [event.reduced for event in fast.events] == [event.reduced for event in general.events]
    assert [event.t for event in fast.events] == [event.t for event in general.events]
    assert fast.modes == general.modes
    assert [s.length for s in fast.segments] == [s.length for s in general.segments]
    assert fast.final == general.final


def rows_of(state, most, run):
    """All rows of a run that is interrupted whenever `most` rows are full, and the state that it ends in."""
    kept, rows = [], np.zeros((most, len(COLUMNS)))
    while True:
        count = run(state, 60, rows)
        kept.append(rows[:count].copy())
        if state[packed.HOW] != packed.ROWS_FULL:
            return np.concatenate(kept), np.array(state)


@more
@given(any_scene, st.integers(1, 7))
@example(PAPER, 5)
def test_a_run_may_be_interrupted_and_compiled_code_has_the_same_bits(scene, most):
    try:
        state = kernel_start(scene)[2]
        whole, end = rows_of(state.tolist(), 64, packed.advance)
    except (NumericsError, ArithmeticError, ValueError):
        return
    parts, same = rows_of(state.tolist(), most, packed.advance)
    assert np.array_equal(whole, parts, equal_nan=True)
    assert np.array_equal(end, same, equal_nan=True)
    if compilation.can_compile():
        fast, fast_end = rows_of(state.copy(), most, compilation.compiled(packed.advance))
        assert np.array_equal(whole, fast, equal_nan=True)
        assert np.array_equal(end, fast_end, equal_nan=True)


@more
@given(any_scene)
@example(PAPER)
def test_no_error_exceeds_its_bound(scene):
    honesty = Honesty("drawn")
    honesty.compare(scene, lambda one: solve(one, max_events=30))
    assert honesty.beyond == []
    assert honesty.worst <= 1


def test_a_run_cut_off_ends_in_the_state_of_its_last_event():
    cut = solve(PAPER, max_events=7)
    assert cut.final == cut.events[-1].reduced
    assert cut.y[:, -1].tolist() == list(cut.events[-1].y)


def test_bounds_a_thousandth_as_wide_are_found_out():
    honesty = Honesty("planted")

    def overconfident(scene):
        found = solve(scene, max_events=30)
        accuracy = found.accuracy
        found.__dict__["accuracy"] = dataclasses.replace(
            accuracy, t=accuracy.t / 1000, y=accuracy.y / 1000, final=accuracy.final / 1000
        )
        return found

    honesty.compare(PAPER, overconfident)
    assert len(honesty.beyond) == 1
    assert not honesty.row().passed


def test_a_graze_has_no_bound():
    assert passing(1e-3, 1.0, 1.0) == pytest.approx(1e-3, rel=1e-3)
    assert passing(1e-3, 0.01, 1.0) == math.inf


def test_an_event_next_to_the_horizon_leaves_the_sequence_open():
    for event in solve(PAPER, digits=40, arithmetic="ball").events[:6]:
        for shift in (-1, 1):
            until = Fraction(str(event.t.mid().str(30, radius=False))) + Fraction(shift, 10**18)
            accuracy = solve(Scene(PAPER.pair, PAPER.initial, until)).accuracy
            assert not accuracy.certain
            assert accuracy.digits == 0


@given(scenes(size=(-1, 1), damped=None), st.integers(0, 5), st.integers(-3000, 3000))
def test_next_to_the_horizon_certain_means_right(scene, index, shift):
    proved = solve(scene, digits=40, arithmetic="ball", max_events=8).events
    if not proved:
        return
    t = Fraction(str(proved[index % len(proved)].t.mid().str(35, radius=False)))
    moved = Scene(scene.pair, scene.initial, t * (1 + Fraction(shift, 10**18)), scene.law)
    floats = solve(moved, max_events=9)
    if floats.accuracy is not None and floats.accuracy.certain:
        assert len(floats.events) == len(solve(moved, digits=40, arithmetic="ball", max_events=9).events)


def test_digits_are_what_was_asked_for_by_the_cheapest_arithmetic():
    few, many = solve(PAPER, digits=8), solve(PAPER, digits=14)
    assert (few.arithmetic.name, few.digits) == ("float64", 8)
    assert few.accuracy.digits >= 8
    assert many.arithmetic.name != "float64"
    assert many.tried.startswith("float64 has ")
    with Ball(40).context():
        truth = integrate(PAPER, Ball(40))
        for one, two in zip(few.events, truth.events, strict=True):
            assert abs(arb(one.t) - two.t) < two.t * arb(10) ** -8


@given(st.floats(0, 1), st.integers(-300, 12), st.floats(-1, 1), st.integers(-300, 8))
def test_the_contact_is_a_root(gap, of_gap, push, of_push):
    gap, push = gap * 2.0**of_gap, push * 2.0**of_push
    if gap == 0.0:
        push = abs(push)
    if max(gap, abs(push)) < 1e-60:
        return
    theta, depth, versine = contact(gap, push)
    if theta < 1e-97:  # its powers are no normal numbers; a run refuses it
        return
    ball = Ball(200)
    with ball.context():
        truth = ball.contact(arb(gap), arb(push))
        for ours, exact in zip((theta, depth, versine), truth, strict=True):
            assert abs(ours - exact) <= 8 * 2.0**-53 * abs(exact)


@st.composite
def rows(draw):
    """A row of binary64 numbers as solve_many takes them, on the surface or near the edge now and then."""
    m1, m2, a2, b, until = (float(draw(decimals(-3, 3))) for _ in range(5))
    x1, v1, x2, v2 = (float(draw(st.one_of(st.just(Fraction(0)), signed(decimals(-3, 2))))) for _ in range(4))
    width = b * (m1 + m2) / (a2 * m2)
    x1 = draw(st.sampled_from([x1, x1, width, -width, width * (1 + 2.0**-40)]))
    return [m1, m2, a2, b, x1, v1, x2, draw(st.sampled_from([v2, v1])), until]


@more
@given(rows(), st.booleans())
def test_arrays_are_prepared_to_the_bits_of_exact_rationals(row, literal):
    state = [0.0] * packed.STATE
    if not prepare(row, literal, state):
        return
    exact = [Fraction(number) for number in row]
    law = Law.THREE_VALUED_SGN if literal else Law.FILIPPOV
    scene = Scene(Pair(*exact[:4]), State(*exact[4:8]), exact[8], law)
    assert state == kernel_start(scene)[2].tolist()


def test_a_start_that_106_bits_do_not_decide_is_left_to_exact_numbers():
    state = [0.0] * packed.STATE
    on_the_edge = [1.0, 1.0, 200.0, 0.5, 0.005, 0.0, 0.0, 0.0, 5.0]
    assert not prepare(on_the_edge, False, state)
    beyond_the_range = [1.0, 1.0, 1e300, 0.5, 0.0, 0.1, 0.0, 0.0, 5.0]
    assert not prepare(beyond_the_range, False, state)
