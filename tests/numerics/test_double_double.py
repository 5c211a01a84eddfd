"""Double-double: functions to a few 2^-105 of themselves, bounds that hold, the same bits compiled."""

import json
import math

import mpmath
import numpy as np
import pytest
from flint import arb
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from strategies import long_slips, near_critical, scenes

from numerics.__main__ import main
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.double_double import DoubleDouble, exactly
from numerics.audit.bounds import Honesty
from numerics.errors import OutOfRange
from numerics.kernel import compilation, double_packed
from numerics.kernel import double_elementary as elementary
from numerics.kernel.double_contact import double_contact
from numerics.kernel.double_double import Double, add, divide, product, square_root, subtract, two_sum
from numerics.kernel.double_state import COLUMNS, UNIT
from numerics.kernel.state import ROWS_FULL
from numerics.old.double_double import double_start, solve_double_double
from numerics.scene import Law, Scene
from numerics.scene.file import load_scene
from numerics.solver.solve import integrate, solve
from numerics.trade.double_kernels import DoubleKernels
from numerics.trade.outcome import letters
from numerics.trajectory.deferred import Deferred

PAPER = load_scene("relative-motion-b05")
COMPARED = [PAPER, load_scene("velocities"), load_scene("itinerary-that-creeps")]
any_scene = st.one_of(
    scenes(size=(-2, 2)),
    scenes(exponents=(-9, 9)),
    near_critical(exponents=(3, 80)),
    long_slips(),
    scenes(law=Law.THREE_VALUED_SGN),
)
more = settings(max_examples=4 * settings().max_examples)


def doubles(low: int, high: int) -> st.SearchStrategy[Double]:
    """Positive numbers from 2^low to 2^high, with all of their 106 bits."""
    parts = st.tuples(st.floats(1, 2), st.floats(-1, 1), st.integers(low, high - 1))
    return parts.map(lambda at: two_sum(at[0] * 2.0 ** at[2], at[1] * 2.0 ** (at[2] - 53)))


def ball(x: Double) -> arb:
    return arb(x.high) + arb(x.low)


FUNCTIONS = {
    "sine": (lambda x: x.sin(), lambda x: elementary.sine_cosine(x)[0], 49, 3),
    "cosine": (lambda x: x.cos(), lambda x: elementary.sine_cosine(x)[1], 49, 3),
    "versine": (lambda x: 2 * (x / 2).sin() ** 2, elementary.versine, 40, 4),
    "sine deficit": (lambda x: x - x.sin(), elementary.sine_deficit, 40, 4),
    "cosine deficit": (lambda x: x * x / 2 - 1 + x.cos(), elementary.cosine_deficit, 40, 16),
    "lag": (lambda x: x.sin() - x * x.cos(), elementary.lag, 1, 4),
    "rise": (lambda x: (x - x.sin()) / (1 - x.cos()), elementary.rise, 2, 6),
    "depth": (lambda x: 2 - x * (x / 2).cot(), elementary.depth, 2, 8),
    "arcus tangent": (lambda x: x.atan(), lambda x: elementary.arctangent(x, Double(1.0, 0.0)), 40, 3),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_are_accurate_relative_to_themselves(name):
    reference, function, highest, units = FUNCTIONS[name]

    @more
    @given(st.one_of(doubles(-160, highest), doubles(-6, min(highest, 3)), doubles(highest - 1, highest)))
    def check(x):
        with Ball(300).context():
            truth = reference(ball(x))
            reduction = 2.0**-160 * x.high if name in {"sine", "cosine"} else 0.0
            assert abs(ball(function(x)) - truth) <= units * UNIT * abs(truth) + reduction

    check()


@more
@given(doubles(-300, 300), doubles(-300, 300), st.booleans())
def test_operations_are_accurate_relative_to_their_results(a, b, close):
    if close:
        b = two_sum(a.high * (1 + 2.0**-50), -a.low)
    with Ball(300).context():
        one, two = ball(a), ball(b)
        cases = [(add(a, b), one + two, 1.5), (subtract(a, b), one - two, 1.5), (divide(a, b), one / two, 5)]
        cases += [(product(a, b), one * two, 2.5), (square_root(a), one.sqrt(), 2)]
        for found, truth, units in cases:
            # a difference below the normal numbers is beyond the 300 digits of its terms
            assert truth.contains(0) or abs(ball(found) - truth) <= units * UNIT * abs(truth)


@more
@given(doubles(-100, 20), doubles(-100, 20), st.sampled_from(["ray", "outwards", "inwards"]))
def test_the_contact_is_that_of_balls(gap, push, kind):
    if kind == "ray":
        gap = Double(0.0, 0.0)
    if kind == "inwards":
        push = Double(-push.high, -push.low)
        assume(abs(push.high) < 2.0**30 * gap.high)  # else theta is gap/push next to nothing
    theta, depth, _ = double_contact(gap, push)
    with Ball(200).context():
        truth = Ball(200).contact(ball(gap), ball(push))
        assert abs(ball(theta) - truth.theta) <= 32 * UNIT * abs(truth.theta)
        assert abs(ball(depth) - truth.depth) <= 64 * UNIT * abs(truth.depth)


@more
@given(any_scene)
@example(PAPER)
@example(COMPARED[1])
@example(COMPARED[2])
def test_no_error_exceeds_its_bound(scene):
    honesty = Honesty("drawn")
    honesty.compare(scene, lambda one: solve(one, arithmetic="double-double", max_events=30))
    assert honesty.beyond == []
    assert honesty.worst <= 1
    assert honesty.tried == 1 or scene not in COMPARED


def test_bounds_much_too_narrow_are_found_out():
    def overconfident(scene):
        found = solve(scene, arithmetic="double-double", max_events=30)
        found.accuracy.y[:] /= 10_000
        return found

    honesty = Honesty("planted")
    honesty.compare(PAPER, overconfident)
    assert len(honesty.beyond) == 1


def rows_of(state, most, run):
    """All rows of a run that is interrupted whenever `most` rows are full, and the state that it ends in."""
    kept, rows = [], np.zeros((most, len(COLUMNS)))
    while True:
        count = run(state, 60, rows)
        kept.append(rows[:count].copy())
        if state[double_packed.HOW] != ROWS_FULL:
            return np.concatenate(kept), np.array(state)


@given(any_scene, st.integers(1, 7))
@example(PAPER, 5)
def test_a_run_may_be_interrupted(scene, most):
    try:
        state = double_start(scene)[2]
        whole, end = rows_of(state.tolist(), 64, double_packed.advance)
    except (OutOfRange, ArithmeticError, ValueError):
        return
    parts, same = rows_of(state.tolist(), most, double_packed.advance)
    assert np.array_equal(whole, parts, equal_nan=True)
    assert np.array_equal(end, same, equal_nan=True)


@pytest.mark.slow
def test_compiled_code_has_the_same_bits():
    pytest.importorskip("numba")
    fast = compilation.compiled(double_packed.advance)
    fast_answer = compilation.compiled(double_packed.answer)

    @more
    @given(any_scene)
    @example(PAPER)
    def check(scene):
        try:
            state = double_start(scene)[2]
            whole, end = rows_of(state.tolist(), 64, double_packed.advance)
        except (OutOfRange, ArithmeticError, ValueError):
            return
        same, same_end = rows_of(state.copy(), 64, fast)
        assert np.array_equal(whole, same, equal_nan=True)
        assert np.array_equal(end, same_end, equal_nan=True)
        answers = [0.0] * double_packed.ANSWER, np.zeros(double_packed.ANSWER)
        double_packed.answer(end.tolist(), answers[0])
        fast_answer(end, answers[1])
        assert np.array_equal(answers[0], answers[1], equal_nan=True)

    check()


def test_the_trajectory_is_that_of_balls_with_its_digits():
    found, truth = solve(PAPER, arithmetic="double-double"), integrate(PAPER, Ball(60))
    assert (found.arithmetic.name, found.arithmetic.digits) == ("double-double", 31)
    assert found.modes == truth.modes
    assert found.accuracy.digits >= 25
    assert found.status is truth.status
    with mpmath.workdps(60):
        for one, two in zip(found.events, truth.events, strict=True):
            assert abs(one.t / mpmath.mpf(two.t.mid().str(50, radius=False)) - 1) < 1e-30
    assert found.events[-1] is found.events[31]
    assert found.events[1:3] == (found.events[1], found.events[2])
    with pytest.raises(IndexError):
        found.events[32]
    cut = solve(PAPER, arithmetic="double-double", max_events=7)
    assert [len(cut.events), len(cut.segments)] == [7, 7]
    assert mpmath.almosteq(cut.final.X, cut.events[-1].reduced.X, rel_eps=1e-29)


def test_numbers_are_exact_sums():
    arithmetic = DoubleDouble()
    for high, low in ((1.0, 2.0**-60), (-3.5, 1e-40), (0.0, 0.0), (2.0**-300, 0.0)):
        with mpmath.workprec(2000):
            assert exactly(high, low) == mpmath.mpf(high) + mpmath.mpf(low)
    with arithmetic.context():
        third = arithmetic.number(1) / 3
        assert exactly(*arithmetic.halves(third)) == third
        with pytest.raises(OutOfRange):
            arithmetic.halves(mpmath.mpf(10) ** 200)


def test_items_are_made_once_and_on_demand():
    made = []
    items = Deferred(lambda index: made.append(index) or index * index, 5)
    assert len(items) == 5
    assert (items[-1], items[4], items[1:3], made) == (16, 16, (1, 4), [4, 1, 2])


def test_beyond_the_kernels_the_general_loop_has_the_same_digits():
    damped, far = load_scene("itinerary-that-merges"), Scene(PAPER.pair, PAPER.initial, 10**120)
    assert solve_double_double(far, 10) is None
    for scene in (damped, far):
        found = solve(scene, arithmetic="double-double", max_events=5)
        assert found.arithmetic.name == "double-double"
        assert len(found.events) <= 5


def test_what_was_asked_for_decides(monkeypatch, capsys):
    with pytest.raises(ValueError, match="31 digits"):
        solve(PAPER, arithmetic="double-double", digits=20)
    monkeypatch.setattr("numerics.solver.solve.can_compile", lambda: False)
    assert solve(PAPER, digits=20).arithmetic.name == "ball"
    monkeypatch.setattr("numerics.solver.solve.can_compile", lambda: True)
    monkeypatch.setitem(__import__("sys").modules, "numba", math)
    monkeypatch.setattr("numerics.old.kernel_run.can_compile", lambda: False)
    found = solve(PAPER, digits=20)
    assert (found.arithmetic.name, found.digits) == ("double-double", 20)
    assert "right digits by its error bounds" in found.tried
    assert solve(PAPER, digits=30).arithmetic.name == "ball"
    assert main(["solve", "relative-motion-b05", "--arithmetic", "double-double", "--json", "--explain"]) == 0
    told = capsys.readouterr()
    assert json.loads(told.out)["digits"] >= 25
    assert "double-double with 31 working digits" in told.err


def test_the_kernels_compete_in_the_trade():
    pytest.importorskip("numba")
    contender = DoubleKernels()
    found, truth = contender.outcome(contender.prepare(PAPER, 106.0)()), integrate(PAPER, Ball(60))
    assert found.kinds == letters(truth.event_kinds)
    with truth.arithmetic.context():
        ledger, final = truth.ledger, truth.frame.si_state(truth.final)
        pairs = [(found.last_event, truth.events[-1].t), (found.dissipated, ledger.friction)]
        for text, value in [*pairs, *zip(found.final, final, strict=True)]:
            assert abs(arb(text) - value) <= 1e-28 * abs(value)
