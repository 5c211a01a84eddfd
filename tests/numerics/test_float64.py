"""The text in float64: the same bits compiled or not, from arrays or from exact rationals; honest error bounds."""

import dataclasses
import math
from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from hypothesis import example, given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import decimals, long_slips, near_critical, scenes, signed, viscous_scenes

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import FLOAT64, Float64
from numerics.audit.bounds import Honesty
from numerics.batch.batch import solve_many
from numerics.bounds.undamped_steps import passing
from numerics.contact.enclosed import enclosed_contact
from numerics.contact.seed import binary64_contact
from numerics.errors import OutOfRange
from numerics.motion.begin import begin, si_numbers
from numerics.motion.codes import OUT_OF_RANGE
from numerics.run.families import run_telling
from numerics.run.one import halved, run_scene
from numerics.run.row import solve_row, solve_start
from numerics.run.rows import Growing
from numerics.scene import Law, Pair, Scene, State
from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from numerics.trajectory.record import end_length, row_length

PAPER = load_scene("relative-motion-b05")
# its last energy is below 1e-324
FADED = Scene(Pair(1, 1, 1, 1, Fraction(1, 2)), State(x1=-2, v1=-1, v2=-8485), until=16971)
any_scene = st.one_of(
    scenes(size=(-2, 2)),
    scenes(exponents=(-9, 9)),
    near_critical(exponents=(3, 80)),
    long_slips(),
    scenes(law=Law.THREE_VALUED_SGN),
    viscous_scenes(),
)
EVENTS = 40
EXACTLY_CRITICAL = [
    Scene(Pair(1, 1, 1, 1, a1=2), State(x1=1, v1=5), until=20),  # slip
    Scene(Pair(1, 1, 2, 1, a1=4), State("0.3", 2, 0, -3), until=20),  # stick
]
more = settings(max_examples=6 * settings().max_examples)


def ran(scene, *, compiled):
    """Rows and end of a run, or None where it left the range; in plain Python, which raises there, too."""
    telling, begun = run_telling(FLOAT64, is_damped=scene.pair.a1 > 0), begin(scene, Float64())
    rows, end = np.zeros((EVENTS, row_length(1))), np.zeros(end_length(1))
    try:
        if compiled:
            count = telling.compiled(solve_start)(*begun, EVENTS, rows, end)
        else:
            plain = end.tolist()
            count = telling(solve_start)(*begun, EVENTS, rows, plain)
            end[:] = plain
    except (ArithmeticError, ValueError):
        return None
    return None if end[0] == OUT_OF_RANGE else (rows[:count], end)


@reaching
@more
@given(any_scene)
@example(PAPER)
@example(load_scene("itinerary-that-creeps"))
@example(Scene(Pair(Fraction(1, 10**7), 10**9, 1, 1), State(v2=-Fraction(1, 10**4)), 198))
@example(EXACTLY_CRITICAL[0])
@example(EXACTLY_CRITICAL[1])
def test_compiled_and_plain_python_have_the_same_bits(scene):
    pytest.importorskip("numba")
    try:
        plain, fast = (ran(scene, compiled=compiled) for compiled in (False, True))
    except OutOfRange:
        raise LeftOut from None
    if plain is None or fast is None:
        assert plain is fast is None or plain is None  # plain Python raises a little earlier
        raise LeftOut
    for one, two in zip(plain, fast, strict=True):
        np.testing.assert_array_equal(one, two)


@reaching
@more
@given(any_scene)
@example(PAPER)
def test_a_record_that_is_too_short_keeps_the_first_events(scene):
    try:
        begun = begin(scene, Float64())
    except OutOfRange:
        raise LeftOut from None
    telling = run_telling(FLOAT64, is_damped=scene.pair.a1 > 0)
    kept = []
    for room in (EVENTS, 3):
        rows, end = Growing(row_length(1), room), [0.0] * end_length(1)
        try:
            telling(solve_start)(*begun, EVENTS, rows, end)
        except (ArithmeticError, ValueError):
            raise LeftOut from None
        kept.append((rows.rows[:3], end))
    assert str(kept[0]) == str(kept[1])  # nan is like nan


@more
@given(any_scene)
@example(PAPER)
@example(FADED)
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


@reaching
@given(scenes(size=(-1, 1), damped=None), st.integers(0, 5), st.integers(-3000, 3000))
def test_next_to_the_horizon_certain_means_right(scene, index, shift):
    proved = solve(scene, digits=40, arithmetic="ball", max_events=8).events
    if not proved:
        raise LeftOut
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
        truth = run_scene(PAPER, Ball(40))
        for one, two in zip(few.events, truth.events, strict=True):
            assert abs(arb(one.t) - two.t) < two.t * arb(10) ** -8


@reaching
@given(st.floats(0, 1), st.integers(-300, 12), st.floats(-1, 1), st.integers(-300, 8))
def test_the_contact_is_a_root(gap, of_gap, push, of_push):
    gap, push = gap * 2.0**of_gap, push * 2.0**of_push
    if gap == 0.0:
        push = abs(push)
    if max(gap, abs(push)) < 1e-60:
        raise LeftOut
    theta, depth, versine = binary64_contact(gap, push)
    if theta < 1e-97:  # its powers are no normal numbers; a run refuses it
        raise LeftOut
    ball = Ball(200)
    with ball.context():
        truth = enclosed_contact(arb(gap), arb(push))
        for ours, exact in zip((theta, depth, versine), truth, strict=True):
            assert abs(ours - exact) <= 8 * 2.0**-53 * abs(exact)


@st.composite
def rows(draw):
    """A row of binary64 numbers as solve_many takes them, on the surface or near the edge now and then."""
    m1, m2, a2, b, until = (float(draw(decimals(-3, 3))) for _ in range(5))
    x1, v1, x2, v2 = (float(draw(st.one_of(st.just(Fraction(0)), signed(decimals(-3, 2))))) for _ in range(4))
    width = b * (m1 + m2) / (a2 * m2)
    x1 = draw(st.sampled_from([x1, x1, width, -width, width * (1 + 2.0**-40)]))
    a1 = draw(st.sampled_from([0.0, 0.0, float(draw(decimals(-3, 2)))]))
    return [m1, m2, a2, b, x1, v1, x2, draw(st.sampled_from([v2, v1])), until, a1]


@reaching
@more
@given(rows(), st.booleans())
def test_arrays_are_prepared_to_the_bits_of_exact_rationals(row, literal):
    exact = [Fraction(number) for number in row]
    law = Law.THREE_VALUED_SGN if literal else Law.FILIPPOV
    scene = Scene(Pair(*exact[:4], a1=exact[9]), State(*exact[4:8]), exact[8], law)
    telling, halves = run_telling(FLOAT64, is_damped=row[9] > 0), halved(si_numbers(scene)).tolist()
    records = []
    for start in ((solve_row, (halves, literal)), (solve_start, begin(scene, Float64()))):
        rows, end = Growing(row_length(1), 3), [0.0] * end_length(1)
        try:
            if telling(start[0])(*start[1], 3, rows, end) < 0:
                raise LeftOut  # left to exact rationals
        except (ArithmeticError, ValueError):
            raise LeftOut from None
        records.append((rows.rows, end))
    assert str(records[0]) == str(records[1])


@pytest.mark.parametrize("row", [[1, 1, 200, 0.5, 0.005, 0, 0, 0, 5, 0], [1, 1, 1e300, 0.5, 0, 0.1, 0, 0, 5, 0]])
def test_a_start_that_106_bits_do_not_decide_is_left_to_exact_numbers(row):
    halves = [half for number in row for half in (float(number), 0.0)]
    rows, end = Growing(row_length(1), 3), [0.0] * end_length(1)
    assert solve_row(halves, False, 3, rows, end) == -1


def test_a_batch_knows_that_what_has_faded_is_not_zero():
    """The truth, by balls: x1 = -2e-461 m; nothing of it is left in float64. A pair without viscosity stays exact."""
    found = solve_many(1, 1, 1, 1, a1=[0.5, 0], x1=[-2, 0], v1=[-1, 0], v2=[-8485, 0], until=16971, jobs=1)
    assert found.y[[0, 1, 3]].tolist() == [[0, 0]] * 3
    assert (found.y_error[[0, 1, 3], 0] > 0).all()
    assert (found.y_error[:, 1] == 0).all()
