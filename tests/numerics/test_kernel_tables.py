"""What rounding and truncation do to a guard is within the sums that the kernel's tables keep."""

from fractions import Fraction

import numpy as np
import pytest
from kernel_runs import STATE, a_scene, room_for

from numerics import Force, Pair, Piece, Scene, State
from numerics.linear.columns import force_columns, product, state_columns
from numerics.linear.engine import run_pairs
from numerics.linear.next_event import slip_guard, stick_guard
from numerics.linear.prepare import prepare
from numerics.linear.table import ORDERS, UNIT, fill


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


def wholly(prepared, mode, order, wide):
    """A room at the start of a run, the guard of a mode formed in it, and its columns."""
    tables, side = prepared.tables, int(mode == 0)
    room, count = room_for(tables), int(tables.count[0])
    force_columns(room, prepared.drive, 0, 0.0, wide)
    room.y[:, 0] = prepared.start[STATE]
    state_columns(room, mode, prepared.drive.b[0])
    return room, tables.rows[0, side], tables.degrees[0, side], count


def guard_of(room, rows, degrees, count, mode, order):
    product(rows, degrees, room.z, count, 2, room.X)
    if mode:
        slip_guard(room, mode, order)
    else:
        stick_guard(room, 0.0, order, 1)
    return room.q.copy()


@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("mode", [-1, 0, 1])
def test_what_is_rounded_moves_a_guard_by_no_more_than_its_sums(mode, order):
    """Planted roundings of z, all in the worst direction, and those of the products; the sums are not far above."""
    random, largest = np.random.default_rng(3), 0.0
    for _ in range(10):
        prepared = prepare(a_scene(random), wide=False)
        room, rows, degrees, count = wholly(prepared, mode, order, False)
        sums = prepared.tables.sums[0, int(mode == 0), order]
        before, z = guard_of(room, rows, degrees, count, mode, order), room.z[0].copy()
        size, k = room.size[:count].copy(), np.arange(order + 1, rows.shape[3] - 1)
        first, second = abs(rows[0, :, :count])
        terms = k * (first + second)[:, k] if mode else k * (k + 1) * second[:, k + 1]
        assert (sums[:count] >= (count + 8) * terms.sum(1)).all()  # each has as many roundings at least
        for sign in (random.choice([-1, 1], count) for _ in range(20)):
            room.z[0, :count] = z[:count] + 2.0**-20 * sign * size
            moved = abs(guard_of(room, rows, degrees, count, mode, order) - before).sum()
            largest = max(largest, moved / (2.0**-20 * (size @ sums[:count])))
    assert 0.02 < largest < 0.2


@pytest.mark.parametrize("terms", [4, 6, 9])
def test_what_is_cut_off_is_within_the_sums(terms):
    """Tables of a few terms, where truncation is all there is, beside those of many: a slip, and stick."""
    slip = {(0, 1): 1, (2, 3): 1, (1, 0): -3, (1, 1): -0.4, (1, 4): -1, (3, 4): 0.5}
    stick = {(0, 1): 1, (2, 3): 1, (1, 0): -1, (1, 1): -0.1, (3, 0): -1, (3, 1): -0.1}
    for is_stick, A in enumerate((slip, stick)):
        entries, many, few = np.array([[one, 0.0] for one in A.values()]), *map(empty, (24, terms))
        for table in (many, few):
            fill(entries, np.array(list(A)), 0.5, 5, is_stick == 1, *table)
        weights, (rows, *_) = np.arange(1, 23), many
        of_slip = (weights * (rows[0, 0] - rows[0, 1])[:, 1:23])[:, terms - 1 :]
        of_load = ((weights + 1) * weights * rows[0, 1, :, 2:])[:, terms - 2 :]
        cut, sums = of_load if is_stick else of_slip, few[3]
        assert (abs(cut).sum(1) <= sums[ORDERS - 1] * UNIT * (1 + 1e-9) + 1e-16).all()


def empty(terms):
    """What `fill` writes into: coefficients, their number, the whole step, the sums of the guard."""
    return np.zeros((2, 2, 5, terms)), np.zeros((2, 5), dtype=np.int64), np.zeros((2, 5, 5)), np.zeros((ORDERS, 5))
