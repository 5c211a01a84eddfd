"""What rounding and truncation do to series, guards and their roots is within what the kernel's tables count."""

from fractions import Fraction

import numpy as np
import pytest
from kernel_runs import STATE, a_scene, room_for

from numerics import Force, Pair, Piece, Scene, State
from numerics.arithmetic.pair import Pair as Wide
from numerics.arithmetic.pair import nearest
from numerics.linear.columns import counted, force_columns, narrow_product, state_columns
from numerics.linear.engine import run_pairs
from numerics.linear.evolve import evaluate
from numerics.linear.next_event import form_guard, refined
from numerics.linear.prepare import prepare
from numerics.linear.table import ORDERS, PRECISE, UNIT, WIDE_UNIT, count_roundings, form, make_tables

TERMS, H = 36, 0.125


@pytest.mark.parametrize("wide", [False, True])
@pytest.mark.parametrize("power", [2, 20, 28, 60])
def test_what_viscosity_takes_under_a_power_of_time_is_within_its_bound(power, wide):
    """In stick, from rest, over one step: x is a series of rational numbers, and so is int v^2 dt."""
    pair = Pair(1, 1, 1, 100, a1="0.5")
    series = [Fraction(0)] * (power + 32)
    for k in range(power, len(series) - 2):
        pull = (k == power) - pair.a1 * (k + 1) * series[k + 1] - pair.a2 * series[k]
        series[k + 2] = pull / (pair.mass * (k + 1) * (k + 2))
    speed = [(k - 1, k * c) for k, c in enumerate(series) if c]
    truth = pair.a1 * sum(c * d / (k + n + 1) for k, c in speed for n, d in speed)
    force = Force([Piece(0, [0] * power + [1])])
    record = run_pairs(Scene(pair, State(), 1, force=force), wide=wide, max_events=1)
    assert abs(Fraction(record.viscous) - truth) <= record.dissipated_error < 1e-8 * truth


@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("mode", [-1, 0, 1])
def test_what_is_rounded_moves_a_guard_by_no_more_than_its_sums(mode, order):
    """Planted roundings of z, all in the worst direction, and those of the products; the sums are not far above."""
    random, largest = np.random.default_rng(3), 0.0
    for _ in range(10):
        prepared = prepare(a_scene(random), wide=False)
        tables, at = prepared.tables, (0, int(mode == 0))
        room, rows, count, sums = room_for(tables), tables.rows[at], tables.count[0], tables.sums[at][order]
        room.y[:, 0] = prepared.start[STATE]
        force_columns(room, prepared.drive, 0, 0.0, False)
        state_columns(room, mode, prepared.drive.b[0])
        z, size, k = room.z[0].copy(), room.size[:count], np.arange(order + 1, rows.shape[3] - 1)
        first, second = abs(rows[0, :, :count])
        terms = k * (first + second)[:, k] if mode else k * (k + 1) * second[:, k + 1]
        assert (sums[:count] >= (count + 8) * terms.sum(1)).all()  # each has as many roundings at least
        guards = []
        for sign in [0, *(random.choice([-1, 1], count) for _ in range(20))]:
            room.z[0, :count] = z[:count] + 2.0**-20 * sign * size
            narrow_product(rows, tables.degrees[at], room.z, count, 2, room.X)
            form_guard(room, mode, order, 1, 0.0)
            guards.append(room.q.copy())
        moved = abs(guards[1:] - guards[0]).sum(1).max()
        largest = max(largest, moved / (2.0**-20 * (size @ sums[:count])))
    assert 0.02 < largest < 0.2


@pytest.mark.parametrize("terms", [4, 6, 9])
def test_what_is_cut_off_is_within_the_sums(terms):
    """Tables of a few terms, where truncation is all there is, beside those of many: a slip, and stick."""
    many, few = make_tables(1, 5, 24), make_tables(1, 5, terms)
    for tables in (many, few):
        form(tables, 0, np.array([[1, 0], [3, 0], [2, 0], [0.4, 0], [3, 0]]), 0, np.zeros((0, 2)), 0.5, 2.0, False)
    rows, k = many.rows[0, :, 0], np.arange(1, 23)
    of_slip = (k * (rows[0, 0] - rows[0, 1])[:, 1:23])[:, terms - 1 :]
    of_load = ((k + 1) * k * rows[1, 1, :, 2:])[:, terms - 2 :]
    for cut, sums in zip((of_slip, of_load), few.sums[0, :, ORDERS - 1], strict=True):
        assert (abs(cut).sum(1) <= sums * UNIT * (1 + 1e-9) + 1e-16).all()


def exact(terms, s):
    """Value and slope of sum_k terms[k] s^k."""
    value, slope = Fraction(0), Fraction(0)
    for one in reversed(terms):
        value, slope = value * s + one, slope * s + value
    return value, slope


def counting(rows, side, wide):
    """Tables whose coefficients are given rows (2, n, TERMS), with their roundings counted."""
    tables = make_tables(1, rows.shape[1], TERMS)
    tables.rows[0, side, 0], tables.count[0] = rows, rows.shape[1]
    count_roundings(tables, 0, side, np.zeros(rows.shape[1]), wide)
    return tables


@pytest.mark.parametrize("late", [0.0, 1.0])
def test_a_value_in_pairs_is_off_by_what_is_counted_also_where_late_terms_are_large(late):
    """These, floats, must count as roundings of float64: roundings of double-double would be too few."""
    random, too_few = np.random.default_rng(3), 0
    for _ in range(60):
        X = np.zeros((2, TERMS))
        X[0] = random.normal(size=TERMS) * np.where(np.arange(TERMS) < PRECISE, 1.0, late)
        X[1, :PRECISE] = X[0, :PRECISE] * random.uniform(-0.5, 0.5, PRECISE) * 2.0**-53
        s = random.uniform(0.1, 1)
        at = Wide(s, s * random.uniform(-1, 1) * 2.0**-54)
        x, v = ([Fraction(half) for half in one] for one in evaluate(X, at, H, True))
        value, slope = exact([Fraction(a) + Fraction(b) for a, b in X.T], Fraction(at.high) + Fraction(at.low))
        off = [abs(sum(x) - value), abs(sum(v) * Fraction(H) - slope)]
        enough, few = (
            [
                WIDE_UNIT * counted(one, np.ones(1), 1, s)
                for one in counting(X[:1, None].repeat(2, 0), 0, wide).state_own[0, 0, :2]
            ]
            for wide in (True, False)
        )
        assert all(a <= b for a, b in zip(off, enough, strict=True))
        too_few += any(a > b for a, b in zip(off, few, strict=True))
    assert (too_few > 30) == (late > 0)


@pytest.mark.parametrize("side", [0, 1])
def test_the_roundings_of_a_guard_are_all_counted_at_the_ends_of_a_step_and_enough_between(side):
    """Slip: s = v1 - v2, of both bodies; stick: the load, of the slope of v2. c_k s^k takes 2 k + n + 4 roundings."""
    random, n, k = np.random.default_rng(5), 3, np.arange(TERMS)
    rows, sizes = random.normal(size=(2, n, TERMS)) * 4.0**-k, random.uniform(0.5, 2, n)
    terms = sizes @ ((2 * k + n + 4) * (k * np.abs(rows).sum(axis=0) if side == 0 else k * (k - 1) * np.abs(rows[1])))
    whole = counting(rows, side, False).own[0, side]
    for order in range(ORDERS):
        left = terms[1 + side + order :]  # where coefficients vanish at the start, s^order is taken out
        for s in (0.0, 1e-3, 0.1, 0.5, 0.9, 1.0):
            found, true = counted(whole[order], sizes, n, s), float(left @ s ** np.arange(len(left)))
            assert found == pytest.approx(true, rel=1e-12) if s in {0.0, 1.0} else found > true
        # two terms are their chord: nothing is added between the ends
        two = counting(np.where(k < 3 + side + order, rows, 0.0), side, False).own[0, side, order]
        assert counted(two, sizes, n, 0.25) == pytest.approx(float(left[0] + left[1] / 4), rel=1e-12)


@pytest.mark.parametrize("order", [0, 2])
def test_what_is_left_of_a_guard_at_its_root_in_pairs_is_said(order):
    """From starts that are off by up to a millionth of the way to another root, near or far."""
    random, largest = np.random.default_rng(4 + order), 0.0
    for _ in range(200):
        root, gap = Fraction(random.uniform(0.2, 0.8)) + Fraction(random.normal()) / 2**60, 10 ** random.uniform(-3, 0)
        other, bend = root + Fraction(gap), Fraction(random.uniform(-0.5, 0.5))
        # (root - s) (other - s) (1 + bend s)
        terms = [root * other, bend * root * other - root - other, 1 - bend * (root + other), bend]
        g = np.zeros((2, TERMS))
        for k, one in enumerate(terms):
            g[:, k + order] = nearest(one)
        start = float(root) * (1 + random.choice([-1, 1]) * gap * 10 ** random.uniform(-17, -6))
        halves, left = refined(g, order, start, gap / 8)
        found = sum(Fraction(half) for half in halves)
        value, steep = exact(terms, found)
        rounding = 8 * WIDE_UNIT * float(sum(abs(one) for one in terms))
        assert abs(value) <= left + rounding
        assert left <= 1e3 * UNIT * UNIT * (1 + abs(float(steep)) / gap)
        largest = max(largest, float(abs(found - root)) * gap)
    assert largest < 2.0**-96
