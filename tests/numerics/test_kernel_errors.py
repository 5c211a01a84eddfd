"""What a step does to the errors: a rest never grows in N, and every rounding is counted."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from kernel_runs import a_scene, room_for

from numerics.arithmetic.pair import Pair
from numerics.linear.columns import Now, Problem, expand, force_columns
from numerics.linear.evolve import evolve
from numerics.linear.first_root import CLEAR
from numerics.linear.ledger import slid_and_damped
from numerics.linear.next_event import Step, no_event
from numerics.linear.prepare import prepare
from numerics.linear.table import UNIT

seeds = st.integers(0, 2**32 - 1)


def evolved(prepared, mode, s, start, R=0.0, wide=True):
    """The state after s steps of the first piece, from a start in units of the errors; and the room."""
    pair, tables = prepared.pair, prepared.tables
    room, now = room_for(tables), Now(0, mode, 0, 1, 1e300, 0.0)
    problem = Problem(pair, prepared.drive, tables, wide, False)
    room.scale[:] = np.sqrt([pair.a2, pair.m1, pair.a2, pair.m2])
    room.y[:, 0], room.R[:] = start / room.scale, R
    force_columns(room, prepared.drive, 0, 0.0, wide)
    expand(problem, room, now)
    evolve(problem, room, now, no_event(CLEAR, s, Step(Pair(1.0, 0.0), False, 0.0)))
    return room.y.sum(1) * room.scale, room


def sticking(prepared, members):
    """Members (4, n) as they are where v1 = v2, no longer in N."""
    pair, members = prepared.pair, np.array(members)
    members[3] = members[1] * math.sqrt(pair.m2 / pair.m1)
    return members / math.sqrt(pair.mass / pair.m1)


def test_a_rest_never_grows_in_N_but_drives_body_2():
    """And by no more than it must: some rests reach the bound."""
    random, reached = np.random.default_rng(5), np.zeros((2, 2))
    for n in range(120):
        mode, s, prepared = n % 2, random.choice([1.0, 0.5]), prepare(a_scene(random), wide=True)
        rest = random.choice([-1, 1], 4) * np.eye(4)[n // 2 % 4] if n % 5 else random.normal(size=4)
        rest /= np.maximum(np.hypot(np.linalg.norm(rest[[0, 1]]), rest[3]), 2 * abs(rest[2]))
        rest = rest if mode else sticking(prepared, rest)
        one, room = evolved(prepared, mode, s, np.zeros(4), [np.linalg.norm(rest[[0, 1, 3]]), abs(rest[2])])
        apart = evolved(prepared, mode, s, rest)[0] - one
        found = np.array([np.linalg.norm(apart[[0, 1, 3]]), abs(apart[2])]) / (room.R + 1e-30)
        assert (found <= 1 + 1e-9).all()
        if abs(rest[2]) < 0.4 * room.R[1]:
            reached[mode] = np.maximum(reached[mode], found)
    assert (reached > [[0.9, 0.3], [0.9, 0.9]]).all()


@given(seeds, st.sampled_from([-1, 0, 1]), st.sampled_from([1.0, 0.5]))
def test_a_step_counts_a_rounding_of_every_product_and_sum(seed, mode, s):
    random = np.random.default_rng(seed)
    prepared, start = prepare(a_scene(random), wide=False), random.normal(size=4)
    start = start if mode else sticking(prepared, start)
    _, room = evolved(prepared, mode, s, start, wide=False)
    tables, side, kind = prepared.tables, int(mode == 0), int(prepared.drive.places[0, 4])
    n, h = int(tables.count[kind]), tables.h[kind, side]
    places = np.array([np.polynomial.polynomial.polyval(s, tables.rows[kind, side, 0, i, :n].T) for i in range(2)])
    slopes = np.array(
        [np.polynomial.Polynomial(tables.rows[kind, side, 0, i, j]).deriv()(s) / h for i in range(2) for j in range(n)]
    )
    flow = np.stack([places[0], slopes[:n], places[1], slopes[n:]])
    friction = [prepared.drive.b[0, 0] * abs(mode)]
    least = n * UNIT * room.scale * (abs(flow) @ np.concatenate([abs(start) / room.scale, friction, room.size[5:n]]))
    least[3] = least[3] if mode else least[1] * room.scale[3] / room.scale[1]  # v2 is v1
    assert room.R[0] >= least[[0, 1, 3]].sum()
    assert room.R[1] >= least[2]
    assert (1e-9 * (1 + abs(room.z).max()) * room.scale.max() > room.R).all()


@given(seeds, st.sampled_from([0.0, 1e-3, 0.3]))
def test_a_force_changes_no_faster_than_is_said_within_a_time(seed, late):
    """And what bodies slide is a sum of so many roundings: k + 8 of its k-th term."""
    random = np.random.default_rng(seed)
    prepared = prepare(a_scene(random), wide=False)
    room, drive, t = room_for(prepared.tables), prepared.drive, random.uniform(0, 3)
    for piece, (first, terms, first_sine, sines, *_) in enumerate(drive.places):
        room.clock[0] = t, 0.0
        _, rate, _ = force_columns(room, drive, piece, late, False)
        polynomial = np.polynomial.Polynomial([*drive.coefficients[first : first + terms, 0], 0.0])
        amplitude, omega, phase = drive.sines[first_sine : first_sine + sines, :, 0].T
        at = t + np.linspace(-late, late, 9)[:, None]
        rates = polynomial.deriv()(at[:, 0]) + (amplitude * omega * np.cos(omega * at + phase)).sum(1)
        assert rate >= abs(rates).max() * (1 - 1e-12)
    room.g[0], s, k = random.normal(size=room.g.shape[1]), random.uniform(0, 1), np.arange(room.g.shape[1])
    problem = Problem(prepared.pair._replace(a1=0.0), drive, prepared.tables, False, True)
    slid, size, *_ = slid_and_damped(problem, room, Now(0, 1, 0, 1, 1e300, 0.0), s)
    assert slid == pytest.approx((room.g[0] / (k + 1)) @ s ** (k + 1))
    assert size == pytest.approx(abs(room.g[0]) * (k + 8) / (k + 1) @ s ** (k + 1))
