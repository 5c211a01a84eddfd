"""Double-double: functions to a few 2^-105 of themselves, bounds that hold, the same bits compiled."""

import json

import mpmath
import numpy as np
import pytest
from flint import arb
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from strategies import long_slips, near_critical, scenes

from numerics.__main__ import main
from numerics.arithmetic import double_elementary as elementary
from numerics.arithmetic import double_exponential as exponential
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.double_double import Double, add, divide, negative, product, square_root, subtract, two_sum
from numerics.arithmetic.double_numbers import DoubleDouble, exact_sum
from numerics.arithmetic.double_words import DOUBLE_DOUBLE, UNIT
from numerics.audit.bounds import Honesty
from numerics.contact.enclosed import enclosed_contact
from numerics.contact.surface import contact
from numerics.errors import OutOfRange
from numerics.motion.begin import begin, in_halves
from numerics.run.families import run_telling
from numerics.run.one import run_scene
from numerics.run.row import solve_start
from numerics.run.rows import Growing
from numerics.scene import Law, Pair, Scene
from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from numerics.trajectory.deferred import Deferred
from numerics.trajectory.record import end_length, row_length

PAPER = load_scene("relative-motion-b05")
COMPARED = [PAPER, load_scene("velocities"), load_scene("itinerary-that-creeps")]
CONTACT = run_telling(DOUBLE_DOUBLE, is_damped=False)(contact)
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
    "depth": (lambda x: 2 - x * (x / 2).cot(), lambda x: elementary.depth_and_cotangent(x)[0], 2, 8),
    "exponential": (lambda x: x.exp(), exponential.exp, 9, 8),
    "exponential of -x": (lambda x: (-x).exp(), lambda x: exponential.exp(negative(x)), 9, 8),
    "exponential less 1": (lambda x: x.expm1(), exponential.expm1, 9, 8),
    "logarithm": (lambda x: x.log(), exponential.log, 200, 8),
    "logarithm of 1 + x": (lambda x: x.log1p(), exponential.log1p, 200, 8),
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
    theta, depth, _ = CONTACT(gap, push)
    with Ball(200).context():
        truth = enclosed_contact(ball(gap), ball(push))
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


@pytest.mark.slow
def test_compiled_code_has_the_same_bits():
    pytest.importorskip("numba")
    doubles_, telling = DoubleDouble(), run_telling(DOUBLE_DOUBLE, is_damped=False)

    @more
    @given(any_scene)
    @example(PAPER)
    def check(scene):
        try:
            with doubles_.context():
                begun = in_halves(begin(scene, doubles_), doubles_.halves)
            rows, end = Growing(row_length(2), 60), [0.0] * end_length(2)
            count = telling(solve_start)(*begun, 60, rows, end)
        except (OutOfRange, ArithmeticError, ValueError):
            return
        fast, fast_end = np.zeros((60, row_length(2))), np.zeros(end_length(2))
        assert telling.compiled(solve_start)(*begun, 60, fast, fast_end) == count
        assert np.array_equal(np.array(rows.rows).reshape(-1, row_length(2)), fast[:count], equal_nan=True)
        assert np.array_equal(end, fast_end, equal_nan=True)

    check()


def test_the_trajectory_is_that_of_balls_with_its_digits():
    found, truth = solve(PAPER, arithmetic="double-double"), run_scene(PAPER, Ball(60))
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
            assert exact_sum(high, low) == mpmath.mpf(high) + mpmath.mpf(low)
    with arithmetic.context():
        third = arithmetic.number(1) / 3
        assert exact_sum(*arithmetic.halves(third)) == third
        with pytest.raises(OutOfRange):
            arithmetic.halves(mpmath.mpf(10) ** 200)


def test_items_are_made_once_and_on_demand():
    made = []
    items = Deferred(lambda index: made.append(index) or index * index, 5)
    assert len(items) == 5
    assert (items[-1], items[4], items[1:3], made) == (16, 16, (1, 4), [4, 1, 2])


def test_beyond_its_range_it_says_so():
    far = Scene(PAPER.pair, PAPER.initial, 10**120)
    with pytest.raises(OutOfRange, match="double-double"):
        solve(far, arithmetic="double-double", max_events=10)


def test_damped_scenes_have_the_digits_of_balls():
    damped = Scene(Pair(1, 1, 200, "0.5", 3), PAPER.initial, 2)
    found, truth = solve(damped, arithmetic="double-double"), run_scene(damped, Ball(60))
    assert (found.modes, found.accuracy) == (truth.modes, None)
    with mpmath.workdps(60):
        for one, two in zip(found.event_times, truth.event_times, strict=True):
            assert abs(one / mpmath.mpf(two.mid().str(50, radius=False)) - 1) < 1e-29


def test_what_was_asked_for_decides(capsys):
    with pytest.raises(ValueError, match="31 digits"):
        solve(PAPER, arithmetic="double-double", digits=20)
    found = solve(PAPER, digits=20)
    assert (found.arithmetic.name, found.digits) == ("double-double", 20)
    assert "right digits by its error bounds" in found.tried
    assert solve(PAPER, digits=30).arithmetic.name == "ball"
    assert main(["solve", "relative-motion-b05", "--arithmetic", "double-double", "--json", "--explain"]) == 0
    told = capsys.readouterr()
    assert json.loads(told.out)["digits"] >= 25
    assert "double-double with 31 working digits" in told.err
