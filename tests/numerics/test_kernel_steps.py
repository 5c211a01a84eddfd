"""Single steps of the kernel: what is clear, which root is the first, what follows a late event; exact crossings."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_runs import begun, exact
from strategies import polynomials_of_roots

from numerics import Force, Friction, Pair, Scene, Signal, State, Weakening
from numerics.linear.first_root import CLEAR, ROOT, UNDECIDED, first_root
from numerics.linear.next_event import Next, Step, next_event
from numerics.linear.polynomial_root import first_crossing, touches
from numerics.linear.resolve import CONTACT, NO_MODE, StepEnd, arrived, mode_after, resolve
from numerics.linear.room import form_z
from numerics.linear.table import GUARDS, STATE, SUMS, UNIT

STICK = Scene(Pair("0.4", "0.6", 1, "0.6"), State(2, 1, 0, 1), 9)
TERMS, WHOLE = 24, Step(1.0, False, 0.0)


def value(q, s):
    return np.polynomial.polynomial.polyval(s, q)


def rooted(q, margins, theta):
    return first_root(q, margins, theta, np.zeros(8))[:3]


@given(polynomials_of_roots(TERMS), st.data())
@settings(max_examples=150)
def test_what_is_clear_exceeds_its_margin_and_a_root_is_the_first_and_alone(one, data):
    theta, q, scale = one
    m0, m1, m2 = (scale * data.draw(st.sampled_from([0.0, 0.0, 1e-12, 1e-7, 1e-3])) for _ in range(3))
    how, s, alone = rooted(q, (m0, m1, m2), theta)
    assert 0 < s <= theta
    end = s - alone
    if how != UNDECIDED:
        assert value(q, np.linspace(0, end, 801)).min() > m0 + m1 * end + m2 / end - 1e-15
    if how == ROOT:
        slopes = value(np.polynomial.polynomial.polyder(q), np.linspace(end, s + alone / 16, 801))
        assert abs(value(q, s)) <= 1e-9 * abs(q).max()
        assert slopes.max() < 0.55 * slopes.min() < 0


@pytest.mark.parametrize("power", [7, 8, 9, 14])
def test_no_power_is_left_out_of_what_is_clear(power):
    q = np.eye(TERMS)[0] - 1.5 * np.eye(TERMS)[power]
    how, s, _ = rooted(q, (0.0, 0.0, 0.0), 1.0)
    assert s < 1.5 ** (-1 / power) or (how == ROOT and s == pytest.approx(1.5 ** (-1 / power)))


@pytest.mark.parametrize("mode", [1, -1, 0])
@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("steps", [0.0, 0.1, None])
def test_a_guard_is_clear_where_it_exceeds_what_N_lateness_or_rounding_may_take_of_it(mode, order, steps):
    """N takes kappa N of v1 - v2, bend N a second since both were there, load N of the load; of a slip twice that."""
    scene = Scene(Pair("0.9", "0.1", 1, "0.1", "0.3"), State(1, 1, 0, 1 - mode), 9)
    run, now = begun(scene, mode)
    h, norm = float(run.tables.steps[0, int(mode == 0)]), run.norm
    if mode == 0 and (order or steps != 0.0):
        return
    parted = norm.kappa if steps is None else norm.bend * steps * h  # since both were there so many steps ago
    slip = min(norm.kappa, parted + norm.bend * h)
    by_N = norm.load if mode == 0 else [2 * slip, 2 * norm.bend * h, 16 * norm.bend * h][order]
    rows, degrees = run.tables.rows[0, int(mode == 0)], run.tables.degrees[0, int(mode == 0)]
    sums = run.tables.lines[0, int(mode == 0), SUMS + 2 * order + 1].sum() * UNIT
    rows[STATE:], degrees[STATE:] = 0.0, 0
    rows[STATE:, 0, order : order + 2], degrees[STATE:, 0] = [[1.0, 0.0]], order + 2
    for N, size, late in ((1e-3, 0.0, 0.0), (0.0, 1e6, 0.0), (0.0, 0.0, 1e-3 * h)):
        if late and not order:
            continue
        run.size[:], run.z[:] = size, 0.0
        unit = N * by_N + size * sums + (0.0 if not late else (1 + order) * late / h * 1e-3)
        for factor, is_clear in ((0.99, False), (1.01, True)):
            # of the late one the guard is 1e-3 (s - s_0)
            rows[STATE:, 0, order + 1] = 1e-3 / (factor * unit) if late else 0.0
            run.z[0] = factor * unit * (-1 if mode < 0 else 1)
            at = now._replace(order=order, speed_apart=parted * N, N=N, late=late)
            found = next_event(run, at, WHOLE)
            assert (found.how == CLEAR and found.s == 1.0) == is_clear, (N, size, late, factor)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("off", "after"), [(-1e-4, 0), (1e-4, 1)])
def test_what_follows_is_judged_by_the_load_that_there_is_when_a_late_event_comes(side, off, after):
    """In stick b is 0.6 and the load 0.6 (u - 2.3); it changes by 0.6 (1 + 0.3 v1') a second at most."""
    run, now = begun(STICK.replace(a1="0.3", force=Force.constant(exact(2.3 + side * (1 + off), 15))))
    form_z(run, 0)
    edge = tuple(float(run.tables.lines[0, 1, GUARDS + g] @ run.z) for g in range(2))
    gap = min(map(abs, edge))
    fastest = 0.6 * max(abs(1 + 0.75 * (side * (1 + off) + one * 0.6)) for one in (1, -1))
    for N, late, is_known in ((0, 0, True), (0.9, 0, True), (1.1, 0, False), (0, 0.3, True), (0, 1.01, False)):
        at = now._replace(N=N * gap / run.norm.load)
        assert mode_after(run, at, edge, late * gap / fastest) == (side * after if is_known else NO_MODE), (N, late)
    near = tuple(one if abs(one) > gap else UNIT * 4 * math.copysign(1, one) for one in edge)
    assert mode_after(run, now._replace(N=0.0), near, 0.0) == NO_MODE


@pytest.mark.parametrize("side", [1, -1])
def test_which_way_a_slip_goes_when_the_belt_has_jumped_is_known_beyond_N_and_rounding(side):
    scene = Scene(Pair(1, "inf", 1, 1), State(v1=2), 9, belt=Signal.constant(2))
    run, now = begun(scene.replace(friction=Friction((), Weakening([("0.5", 1)]))))
    run.y[1] += side  # into a cell that is not looked for
    assert resolve(run, now, StepEnd(CONTACT, 0.0)).mode == NO_MODE
    run, now = begun(scene)
    for N, gap, is_known in ((0, 4 * UNIT, False), (0, 1e-12, True), (1e-9, 0.99e-9, False), (1e-9, 1.01e-9, True)):
        run.y[1] = run.y[3] + side * gap
        after = resolve(run, now._replace(N=N / run.norm.kappa), StepEnd(CONTACT, 0.0))
        assert after.mode == (side if is_known else NO_MODE), (N, gap)


@pytest.mark.parametrize("own", [1e-6, 1e-4])
def test_an_exit_that_rounding_misplaces_adds_what_the_bodies_part_until_then(own):
    """The load grows beyond b by `slope` a second: each body's momentum is off by slope t^2/2."""
    run, now = begun(STICK)
    slope = 1e-3
    after, _ = arrived(run, now, Next(ROOT, 1.0, 0, 0.5, slope, own))
    assert run.norm.kappa * slope * (own / slope) ** 2 / 2 <= after.N - now.N


# the first sign change of polynomials is exact: roots of any multiplicity, touches passed over


def test_a_crossing_is_the_first_root_of_odd_multiplicity_after_a_time():
    t = [Fraction(one) for one in (0, -4, 8, -5, 1)]  # t (t - 1) (t - 2)^2
    for after, found in ((0, (1, True)), (Fraction(1, 2), (1, True)), (1, (3, False)), (2, (3, False))):
        assert first_crossing([t], Fraction(after), Fraction(3)) == found
    assert [touches([t], Fraction(after), Fraction(3)) for after in (0, 1, 2)] == [True, True, False]
    for square, touched in (([-2, 0, 1], 0), ([-2, 4, -1, -2, 1], 1)):  # t^2 - 2, and that (t - 1)^2
        before, is_root = first_crossing([list(map(Fraction, square))], Fraction(0), Fraction(3))
        assert (touched < before and before**2 < 2, is_root) == (True, False)
    assert first_crossing([[Fraction(2), Fraction(-2), Fraction(1)]], Fraction(0), Fraction(3)) == (3, False)
