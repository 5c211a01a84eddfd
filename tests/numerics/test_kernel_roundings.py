"""What a step rounds and cuts off, and what that does to series, guards, roots and errors, is counted in full."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from kernel_runs import a_scene, begun, exact

from numerics import Force, Pair, Piece, Scene, Sine, State
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.precision import precision
from numerics.linear.columns import counted, expand, force_columns
from numerics.linear.engine import run_floats
from numerics.linear.evolve import evolve
from numerics.linear.first_root import CLEAR
from numerics.linear.ledger import slid_and_damped
from numerics.linear.next_event import Next
from numerics.linear.prepare import prepare
from numerics.linear.record import AT
from numerics.linear.table import ORDERS, UNIT, count_roundings, form, make_tables

TERMS = 28
seeds = st.integers(0, 2**32 - 1)


@pytest.mark.parametrize("power", [2, 20, 28, 60])
def test_what_viscosity_takes_under_a_power_of_time_is_within_its_bound(power):
    """In stick, from rest, over one step: x is a series of rational numbers, and so is int v^2 dt."""
    pair = Pair(1, 1, 1, 100, a1="0.5")
    series = [Fraction(0)] * (power + 32)
    for k in range(power, len(series) - 2):
        pull = (k == power) - pair.a1 * (k + 1) * series[k + 1] - pair.a2 * series[k]
        series[k + 2] = pull / (pair.mass * (k + 1) * (k + 2))
    speed = [(k - 1, k * c) for k, c in enumerate(series) if c]
    truth = pair.a1 * sum(c * d / (k + n + 1) for k, c in speed for n, d in speed)
    force = Force([Piece(0, [0] * power + [1])])
    end = run_floats(Scene(pair, State(), 1, force=force), 1).end
    assert abs(Fraction(end[AT["viscous"]]) - truth) <= end[AT["dissipated_error"]] < 1e-6 * truth


@pytest.mark.parametrize("terms", [4, 6, 9])
def test_what_is_cut_off_is_within_the_sums(terms):
    """Tables of a few terms, where truncation is all there is, beside those of many: a slip, and stick."""
    many, few = make_tables(1, 5, 24), make_tables(1, 5, terms)
    for tables in (many, few):
        form(tables, 0, np.array([[1, 0], [3, 0], [2, 0], [0.4, 0], [3, 0]]), 0, np.zeros((0, 2)), 0.5)
    rows, k = many.rows[0], np.arange(1, 23)
    of_slip = (k * (rows[0, 0] - rows[0, 1])[:, 1:23])[:, terms - 1 :]
    of_load = ((k + 1) * k * rows[1, 1, :, 2:])[:, terms - 2 :]
    for cut, sums in zip((of_slip, of_load), few.sums[0, :, ORDERS - 1], strict=True):
        assert (abs(cut).sum(1) <= sums * UNIT * (1 + 1e-9) + 1e-16).all()


def counting(rows, side):
    """Tables whose coefficients are given rows (2, n, TERMS), with their roundings counted."""
    tables = make_tables(1, rows.shape[1], TERMS)
    tables.rows[0, side], tables.count[0] = rows, rows.shape[1]
    count_roundings(tables, 0, side, np.zeros(rows.shape[1]))
    return tables


@pytest.mark.parametrize("side", [0, 1])
def test_the_roundings_of_a_guard_are_all_counted_at_the_ends_of_a_step_and_enough_between(side):
    """Slip: s = v1 - v2, of both bodies; stick: the load, of the slope of v2. c_k s^k takes 2 k + n + 4 roundings."""
    random, n, k = np.random.default_rng(5), 3, np.arange(TERMS)
    rows, sizes = random.normal(size=(2, n, TERMS)) * 4.0**-k, random.uniform(0.5, 2, n)
    terms = sizes @ ((2 * k + n + 4) * (k * np.abs(rows).sum(axis=0) if side == 0 else k * (k - 1) * np.abs(rows[1])))
    tables = counting(rows, side)
    whole, sums = tables.own[0, side], tables.sums[0, side] @ sizes
    for order in range(ORDERS):
        left = terms[1 + side + order :]  # where coefficients vanish at the start, s^order is taken out
        assert left.sum() * (1 - 1e-12) <= sums[order] < 1.3 * left.sum()
        for s in (0.0, 1e-3, 0.1, 0.5, 0.9, 1.0):
            found, true = counted(whole[order], sizes, n, s), float(left @ s ** np.arange(len(left)))
            assert found == pytest.approx(true, rel=1e-12) if s in {0.0, 1.0} else found > true
        # two terms are their chord: nothing is added between the ends
        two = counting(np.where(k < 3 + side + order, rows, 0.0), side).own[0, side, order]
        assert counted(two, sizes, n, 0.25) == pytest.approx(float(left[0] + left[1] / 4), rel=1e-12)


def evolved(scene, mode, s, start, R=0.0):
    """The state after s steps of the first piece, from a start in units of the errors; the room, and the problem."""
    problem, room, now = begun(scene, mode)
    room.y[:], room.R[:] = start / room.scale, R
    force_columns(room, problem.drive, 0, 0.0)
    expand(problem, room, now)
    evolve(problem, room, now, Next(CLEAR, s, 0, 0.0, 0.0, 0.0, 0.0))
    return room.y * room.scale, room, problem


def sticking(scene, one):
    """A start as it is where v1 = v2, no longer in N."""
    share = float(scene.pair.m2 / scene.pair.m1)
    return np.array([one[0], one[1], one[2], one[1] * math.sqrt(share)]) / math.sqrt(1 + share)


def test_a_rest_never_grows_in_N_but_drives_body_2():
    """And by no more than it must: some rests reach the bound."""
    random, reached = np.random.default_rng(5), np.zeros((2, 2))
    for n in range(120):
        mode, s, scene = n % 2, random.choice([1.0, 0.5]), a_scene(random)
        rest = random.choice([-1, 1], 4) * np.eye(4)[n // 2 % 4] if n % 5 else random.normal(size=4)
        rest /= np.maximum(np.hypot(np.linalg.norm(rest[[0, 1]]), rest[3]), 2 * abs(rest[2]))
        rest = rest if mode else sticking(scene, rest)
        one, room, _ = evolved(scene, mode, s, np.zeros(4), [np.linalg.norm(rest[[0, 1, 3]]), abs(rest[2])])
        apart = evolved(scene, mode, s, rest)[0] - one
        found = np.array([np.linalg.norm(apart[[0, 1, 3]]), abs(apart[2])]) / (room.R + 1e-30)
        assert (found <= 1 + 1e-9).all()
        if abs(rest[2]) < 0.4 * room.R[1]:
            reached[mode] = np.maximum(reached[mode], found)
    assert (reached > [[0.9, 0.3], [0.9, 0.9]]).all()


@given(seeds, st.sampled_from([-1, 0, 1]), st.sampled_from([1.0, 0.5]))
def test_a_step_counts_a_rounding_of_every_product_and_sum(seed, mode, s):
    random = np.random.default_rng(seed)
    scene, start = a_scene(random), random.normal(size=4)
    start = start if mode else sticking(scene, start)
    _, room, (_, drive, tables, *_) = evolved(scene, mode, s, start)
    kind, side, k = int(drive.places[0, 4]), int(mode == 0), np.arange(tables.rows.shape[4])
    n, h = int(tables.count[kind]), tables.h[kind, side]
    one, two = tables.rows[kind, side, :, :n] @ np.stack([s**k, k * s ** np.maximum(k - 1, 0) / h], axis=1)
    flow = np.stack([*one.T, *two.T])
    assert (room.size[5:n] >= abs(room.z[5:n])).all()
    sizes = np.concatenate([abs(start) / room.scale, [drive.b[0] * abs(mode)], room.size[5:n]])
    least = n * UNIT * room.scale * (abs(flow) @ sizes)
    least[3] = least[3] if mode else least[1] * room.scale[3] / room.scale[1]  # v2 is v1
    assert room.R[0] >= least[[0, 1, 3]].sum()
    assert room.R[1] >= least[2]
    assert (1e-9 * (1 + abs(room.z).max()) * room.scale.max() > room.R).all()


@given(seeds, st.sampled_from([0.0, 1e-3, 0.3]))
def test_a_force_changes_no_faster_than_is_said_within_a_time(seed, late):
    """And what bodies slide is the integral of the guard."""
    random = np.random.default_rng(seed)
    problem, room, now = begun(a_scene(random), 1)
    drive, t = problem.drive, random.uniform(0, 3)
    for piece, (first, terms, first_sine, sines, *_) in enumerate(drive.places):
        room.clock[0] = t, 0.0
        _, rate, _ = force_columns(room, drive, piece, late)
        polynomial = np.polynomial.Polynomial([*drive.coefficients[first : first + terms], 0.0])
        amplitude, omega, phase = drive.sines[first_sine : first_sine + sines, :, 0].T
        at = t + np.linspace(-late, late, 9)[:, None]
        rates = polynomial.deriv()(at[:, 0]) + (amplitude * omega * np.cos(omega * at + phase)).sum(1)
        assert rate >= abs(rates).max() * (1 - 1e-12)
    room.g[:], s, k = random.normal(size=room.g.size), random.uniform(0, 1), np.arange(room.g.size)
    undamped = problem._replace(pair=problem.pair._replace(a1=0.0))
    slid, *_ = slid_and_damped(undamped, room, now, s)
    assert slid == pytest.approx((room.g / (k + 1)) @ s ** (k + 1))


@given(seeds)
def test_a_sine_is_off_by_what_is_counted_after_a_million_radians_and_next_to_its_zeros(seed):
    """A series counts `size` at least n + 4 = 11 times, and its own products and sums are half of that."""
    random = np.random.default_rng(seed)
    omega, phase, power = exact(random.uniform(0.1, 10)), exact(random.uniform(0, 6)), random.uniform(1, 17)
    angle = random.integers(1, 10**6) * math.pi / 2 * (1 + random.choice([-1, 1]) * 10**-power)
    force = Force([Piece(0, (), [Sine("0.7", omega, phase)])])
    scene = Scene(Pair("0.4", "0.6", "1.3", "0.6"), State(), 10**8, force=force)
    units, (problem, room, _) = prepare(scene).units, begun(scene)
    t = math.ldexp((angle - float(phase)) / float(omega), -units.time)
    room.clock[0] = t, random.uniform(-1, 1) * t * 2.0**-54
    force_columns(room, problem.drive, 0, 0.0)
    with precision(400):
        time = sum(map(Fraction, room.clock[0].tolist())) * Fraction(2) ** units.time
        largest = Ball.number(Fraction("0.7") / Fraction(2) ** units.of(mass=1, length=1, time=-2))
        truth = Ball.number(omega * time + phase)
        for found, true, size in zip(room.z[5:7], (truth.sin(), truth.cos()), room.size[5:7], strict=True):
            assert abs(Ball.number(Fraction(found)) - largest * true) <= 5 * UNIT * size


def test_a_clock_keeps_what_its_roundings_leave_out_over_many_steps():
    random, total = np.random.default_rng(2), Fraction(0)
    problem, room, now = begun(Scene(Pair("0.4", "0.6", "1.3", "0.6"), State("0.3"), 9))
    for s in random.uniform(0.1, 1, 300).tolist():
        expand(problem, room, now)
        evolve(problem, room, now, Next(CLEAR, s, 0, 0.0, 0.0, 0.0, 0.0))
        total += Fraction(s) * Fraction(float(problem.tables.h[0, 1]))
    assert abs(sum(map(Fraction, room.clock[0].tolist())) - total) < total / 2**95
