"""Single steps of the kernel: what is clear, what is a root, what is rounded, how late an event is, what follows."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_runs import a_scene, begun, exact
from strategies import polynomials_of_roots, reaches

from numerics import Force, Pair, Piece, Scene, Sine, State
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.precision import precision
from numerics.linear.evolve import evolve
from numerics.linear.first_root import CLEAR, ROOT, UNDECIDED, first_root
from numerics.linear.next_event import Next, Step, next_event
from numerics.linear.resolve import EXIT, SLIP_END, arrived, lateness, mode_after
from numerics.linear.resolve import UNDECIDED as NO_MODE
from numerics.linear.room import form_z
from numerics.linear.table import GUARDS, STATE, SUMS, UNIT

TERMS = 24
seeds = st.integers(0, 2**32 - 1)
WHOLE = Step(1.0, False, 0.0)


def value(q, s):
    return np.polynomial.polynomial.polyval(s, q)


def padded(*q):
    return np.pad(np.array(q, float), (0, TERMS - len(q)))


def rooted(q, margins, theta):
    return first_root(q, margins, theta, np.zeros(8))


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


@given(st.floats(0.1, 0.9), st.sampled_from(range(3)), reaches)
def test_a_margin_is_the_sum_of_its_parts(value_at_end, part, theta):
    q, root = padded(1, (value_at_end - 1) / theta), value_at_end * theta
    for factor in (0.999, 1.001):
        margins = np.where(np.arange(3) == part, factor * value_at_end / np.array([1, theta, 1 / theta]), 0)
        how, s, _ = rooted(q, margins, theta)
        assert (how == CLEAR and s == theta) == (factor < 1)
        # a root is looked for from half of its time on
        margins = np.where(np.arange(3) == part, factor / 2 / np.array([1, root / 2, 2 / root]), 0)
        assert (rooted(padded(1, -1 / root), margins, theta)[0] == ROOT) == (factor < 1)


@pytest.mark.parametrize("power", [7, 8, 9, 14])
def test_no_power_is_left_out_of_what_is_clear(power):
    how, s, _ = rooted(padded(1, *[0] * (power - 1), -1.5), (0.0, 0.0, 0.0), 1.0)
    assert s < 1.5 ** (-1 / power) or (how == ROOT and s == pytest.approx(1.5 ** (-1 / power)))


def matrix_of(run, mode):
    return run.tables.A[0, int(mode == 0)], float(run.tables.steps[0, int(mode == 0)]), len(run.z)


@given(seeds, st.sampled_from([-1, 0, 1]), st.sampled_from([1.0, 0.5]))
@settings(max_examples=60)
def test_a_step_is_that_of_its_matrix_and_counts_a_rounding_of_every_product(seed, mode, s):
    random = np.random.default_rng(seed)
    scene = a_scene(random)
    run, now = begun(scene, mode)
    if mode == 0:
        run.y[3] = run.y[1]
        form_z(run, 0, 0, False)
    A, h, count = matrix_of(run, mode)
    z, size, norm = run.z[:count].copy(), run.size[:count].copy(), run.norm
    assert (size >= abs(z)).all()
    after = evolve(run, now, s)
    flow, term = np.eye(count), np.eye(count)
    for k in range(1, 60):
        term = term @ (A * h * s) / k
        flow = flow + term
    own = UNIT * abs(flow[:STATE]) @ size
    scale = np.array([norm.root_a2, norm.root_m1, 0, norm.root_m2])
    if mode == 0:
        assert run.y[1] == run.y[3]
    assert (abs(run.y - flow[:STATE] @ z) <= 100 * own + 1e-300).all()
    assert count * (own @ scale) <= after.N - now.N <= 1e-9 * (1 + abs(z).max()) * scale.max()
    assert after.far - now.far >= count * own[0] + after.N / norm.root_m1 * s * h
    parted = count * (own[0] + own[2]) if mode else 2 * UNIT * (abs(z[0]) + abs(z[2]) + abs(run.y[0]) + abs(run.y[2]))
    assert after.apart - now.apart >= parted * (1 - 1e-12)
    assert after.apart - now.apart >= (norm.kappa * after.N * s * h if mode else 0)


def test_a_clock_keeps_what_its_roundings_leave_out_over_many_steps():
    random, total = np.random.default_rng(2), Fraction(0)
    run, now = begun(Scene(Pair("0.4", "0.6", "1.3", "0.6"), State("0.3"), 9))
    for s in random.uniform(0.1, 1, 300).tolist():
        form_z(run, 0, 0, False)
        now = evolve(run, now, s)
        total += Fraction(s) * Fraction(float(run.tables.steps[0, 1]))
    for clock in run.clock:
        assert abs(sum(map(Fraction, clock.tolist())) - total) < total / 2**95


@given(seeds)
def test_a_sine_is_off_by_what_is_counted_after_many_radians_and_next_to_its_zeros(seed):
    random = np.random.default_rng(seed)
    omega, phase, power = exact(random.uniform(0.1, 10)), exact(random.uniform(0, 6)), random.uniform(1, 17)
    angle = random.integers(1, 10 ** random.integers(1, 13)) * math.pi / 2 * (1 + random.choice([-1, 1]) * 10**-power)
    force = Force([Piece(0, (), [Sine("0.7", omega, phase)])])
    run, _ = begun(Scene(Pair("0.4", "0.6", "1.3", "0.6"), State(), 10**13, force=force))
    first = int(run.tables.blocks[0, 0, 2])
    amplitude, rate, start = run.drive.sines[0]
    run.clock[0] = (angle - float(phase)) / rate[0], random.uniform(-1, 1) * 10.0 ** random.integers(-16, -9)
    form_z(run, 0, 1, False)
    with precision(400):
        turned = sum(map(Fraction, rate.tolist())) * sum(map(Fraction, run.clock[0].tolist()))
        truth = Ball.number(turned + sum(map(Fraction, start.tolist())))
        for k, true in enumerate((truth.sin(), truth.cos())):
            off = abs(Ball.number(Fraction(run.z[first + k])) - true * Ball.number(Fraction(amplitude[0])))
            assert off <= 5 * UNIT * run.size[first + k]


@pytest.mark.parametrize("mode", [1, -1, 0])
@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("since", [0.0, 0.1, 1e300])
def test_a_guard_is_clear_where_it_exceeds_what_N_lateness_or_rounding_may_take_of_it(mode, order, since):
    """N takes kappa N of v1 - v2, bend N a second since both were there, load N of the load; of a slip twice that."""
    scene = Scene(Pair("0.9", "0.1", 1, "0.1", "0.3"), State(1, 1, 0, 1 - mode), 9)
    run, now = begun(scene, mode)
    h, norm = matrix_of(run, mode)[1], run.norm
    if mode == 0 and (order or since):
        return
    slip = norm.kappa if since > 9 else norm.bend * (since + 1) * h
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
            at = now._replace(order=order, since=since * h, N=N, late=late)
            found = next_event(run, at, WHOLE)
            assert (found.how == CLEAR and found.s == 1.0) == is_clear, (N, size, late, factor)


@pytest.mark.parametrize("mode", [1, -1, 0])
def test_an_event_is_as_late_as_N_and_rounding_over_the_slope_and_its_errors_are_in_N(mode):
    scene = Scene(Pair("0.4", "0.6", 1, "0.6", "0.3", b_static="0.75"), State(2, 1, 0, 1), 9)
    run, now = begun(scene, mode)
    norm, ahead = run.norm, Next(ROOT, 0.5, int(mode == 0), 0.1, slope=2.0, own=1e-6)
    b = abs(run.z[int(run.tables.blocks[0, 4, 0])])
    form_z(run, 0, mode, True)
    for since in (1e-3, 1e300):
        now = now._replace(N=1e-4, since=since)
        reach = norm.load if mode == 0 else min(norm.kappa, norm.bend * since)
        late, window = lateness(run, now, ahead)
        assert (late, window) == pytest.approx((0.625 * (reach * 1e-4 + 1e-6), 0.625e-6))
        run.y[1] = run.y[3] + 1e-5 * abs(mode)
        after, event = arrived(run, now, ahead)
        assert event == (EXIT if mode == 0 else SLIP_END, late)
        wrong = 4 * (1e-6 + 2 * window) if mode == 0 else 2 * b
        added = norm.kappa * (0.25 * b * late + wrong * window) + norm.root_m1 * 1e-5 * abs(mode)
        assert pytest.approx(added, rel=1e-6) == after.N - now.N
        assert after.apart - now.apart == pytest.approx(2 * norm.kappa * 1e-4 * late)
        assert run.y[1] == run.y[3]
        assert mode or (after.mode, after.order, after.since) == (-1, 1, 1e300)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("off", "after"), [(-1e-4, 0), (1e-4, 1)])
def test_what_follows_is_judged_by_the_load_that_there_is_when_a_late_event_comes(side, off, after):
    """In stick b is 0.6 and the load 0.6 (u - 2.3); it changes by 0.6 (1 + 0.3 v1') a second at most."""
    u = 2.3 + side * (1 + off)
    force = Force([Piece(0, [exact(u, 15)])])
    run, now = begun(Scene(Pair("0.4", "0.6", 1, "0.6", "0.3"), State(2, 1, 0, 1), 9, force=force))
    form_z(run, 0, 0, True)
    edge = tuple(float(run.tables.lines[0, 1, GUARDS + g] @ run.z) for g in range(2))
    gap = min(map(abs, edge))
    fastest = 0.6 * max(abs(1 + 0.3 * (side * (1 + off) + one * 0.6) / 0.4) for one in (1, -1))
    for N, late, mode in (
        (0.0, 0.0, side * after),
        (0.9 * gap / run.norm.load, 0.0, side * after),
        (1.1 * gap / run.norm.load, 0.0, NO_MODE),
        (0.0, 0.3 * gap / fastest, side * after),
        (0.0, 1.01 * gap / fastest, NO_MODE),
    ):
        assert mode_after(run, now._replace(N=N), edge, late) == mode, (N, late)
    near = tuple(one if abs(one) > gap else UNIT * 4 * math.copysign(1, one) for one in edge)
    assert mode_after(run, now._replace(N=0.0), near, 0.0) == NO_MODE


def test_the_load_is_bent_by_what_bends_it_where_it_stands_still():
    """At v1 = 0 the load of an undamped pair has no rate, but soon: by a2 share v1' late^2/2."""
    force = Force([Piece(0, ["1.0001"])])
    run, now = begun(Scene(Pair("0.4", "0.6", 1, "0.6"), State(), 9, force=force))
    form_z(run, 0, 0, True)
    edge = tuple(float(run.tables.lines[0, 1, GUARDS + g] @ run.z) for g in range(2))
    far = math.sqrt(2 * min(map(abs, edge)) / (0.6 * 1.6 / 0.4))
    assert [mode_after(run, now._replace(N=0.0), edge, x * far) for x in (0.1, 1.01)] == [1, NO_MODE]
