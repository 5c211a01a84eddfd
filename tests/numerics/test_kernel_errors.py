"""The set of errors: its members stay members through steps and new bases, and its size is theirs."""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from kernel_runs import a_scene

from numerics.linear.columns import UNIT, force_columns, make_room, product, state_columns, wide_product
from numerics.linear.error_set import box, carry, norm_of, take_in, width
from numerics.linear.evolve import evolve
from numerics.linear.prepare import prepare

seeds = st.integers(0, 2**32 - 1)


def a_set(random):
    """Columns of any size, some of them alike or 0; rests of any size or 0."""
    E = random.normal(size=(4, 4)) * 10.0 ** random.integers(-3, 1, 4)
    if random.random() < 0.3:
        E[:, 1] = E[:, 0] * random.choice([0, 1, -2])
    return E, np.abs(random.normal(size=2)) * random.choice([0, 0.1, 1, 5], 2)


def outermost(E, R, w):
    """The member of a set that goes farthest in a direction."""
    plain = np.array([w[0], w[1], 0, w[3]])
    length = math.hypot(*plain)
    rest = R[0] * plain / length if length else plain
    return E @ np.sign(w @ E) + rest + np.array([0, 0, R[1] * np.sign(w[2]), 0])


def directions(random):
    axes = np.vstack([np.eye(4), -np.eye(4)])
    return np.vstack([axes, random.normal(size=(4, 4)), random.choice([-1, 1], (4, 4))])


def is_member(E, R, point):
    """Whether every direction of an orthogonal E finds the point within; R is 0."""
    return R.max() == 0 and all(abs(E[:, k] @ point) <= E[:, k] @ E[:, k] * (1 + 1e-7) + 1e-13 for k in range(4))


@given(seeds)
def test_box_width_and_norm_are_those_of_the_outermost_members(seed):
    random = np.random.default_rng(seed)
    E, R = a_set(random)
    farthest = [abs(outermost(E, R, np.eye(4)[i])[i]) for i in range(4)]
    assert [box(E, R, i) for i in range(4)] == pytest.approx(farthest, rel=1e-8)
    w = random.normal(size=4) * [1, 1, 0, 1]
    assert width(E, R, w[0], w[1], w[3]) == pytest.approx(w @ outermost(E, R, w), rel=1e-8)
    for each in directions(random):
        member = outermost(E, R, each)
        assert math.hypot(member[0], member[1], member[3]) <= norm_of(E, R)
    assert norm_of(E, R) == pytest.approx(math.hypot(farthest[0], farthest[1], farthest[3]), rel=1e-8)


@given(seeds)
@example(5965)  # a direction in which the set has no more than its own rounding
def test_members_are_members_in_a_new_basis_which_is_no_larger_than_it_must(seed):
    random = np.random.default_rng(seed)
    E, R = a_set(random)
    before = E.copy(), R.copy()
    take_in(E, R, np.zeros((4, 4)), np.zeros(4))
    lengths = np.sqrt((E * E).sum(0)) + 1e-300
    assert abs((E / lengths).T @ (E / lengths) - np.eye(4)).max() < 1e-8 or lengths.min() < 1e-200
    assert all(is_member(E, R, outermost(*before, each)) for each in directions(random))
    for k in range(4):
        along = E[:, k] / lengths[k]
        reach = abs(along @ before[0]).sum() + before[1][0] + abs(along[2]) * before[1][1]
        assert lengths[k] <= reach + 1e-6 * lengths[k] + 1e-15 * abs(before[0]).sum()


def evolved(prepared, mode, s, start, E=0.0, R=0.0, wide=True):
    """The state after s steps of the first piece, from a start in units of the errors; and the room."""
    pair, tables, side = prepared.pair, prepared.tables, int(mode == 0)
    room = make_room(tables.rows.shape[4], tables.rows.shape[5])
    room.scale[:] = np.sqrt([pair.a2, pair.m1, pair.a2, pair.m2])
    room.y[:, 0], room.E[:], room.R[:] = start / room.scale, E, R
    force_columns(room, prepared.drive, 0, 0.0, wide)
    state_columns(room, mode, prepared.drive.b[0])
    kind = int(prepared.drive.places[0, 4])
    if wide:
        wide_product(tables.rows[kind, side], room.z, tables.count[kind], room.X)
    else:
        product(tables.rows[kind, side], tables.degrees[kind, side], room.z, tables.count[kind], room.X)
    evolve(tables, room, (kind, side), mode, (s, 0.0), False, wide)
    return room.y.sum(1) * room.scale, room


def sticking(prepared, members):
    """Members (4, n) as they are where v1 = v2, no longer in N."""
    pair, members = prepared.pair, np.array(members)
    members[3] = members[1] * math.sqrt(pair.m2 / pair.m1)
    return members / math.sqrt(pair.mass / pair.m1)


PARTS = st.sampled_from([1.0, 0.5, 1e-3])


@given(seeds, st.sampled_from([0, 1]), PARTS)
@settings(max_examples=30)
def test_what_is_known_by_components_goes_with_the_motion(seed, mode, s):
    random = np.random.default_rng(seed)
    prepared = prepare(a_scene(random), wide=True)
    E, c = a_set(random)[0], random.choice([-1, 1], 4)
    E = E if mode else sticking(prepared, E)
    start = random.normal(size=4) if mode else sticking(prepared, random.normal(size=4))
    one, room = evolved(prepared, mode, s, start, E)
    two, _ = evolved(prepared, mode, s, start + E @ c)
    assert two - one == pytest.approx(room.E @ c, abs=1e-12 * (1 + abs(one).max() + abs(two).max()))
    assert room.R.max() < 1e-25 * (1 + abs(start).max()) * 1e6


def test_a_rest_never_grows_in_N_but_drives_body_2():
    """And by no more than it must: some rests reach the bound."""
    random, reached = np.random.default_rng(5), np.zeros((2, 2))
    for n in range(120):
        mode, s, prepared = n % 2, random.choice([1.0, 0.5]), prepare(a_scene(random), wide=True)
        rest = outermost(np.zeros((4, 4)), np.array([1.0, 0.5]), directions(random)[random.integers(16)])
        rest = rest if mode else sticking(prepared, rest)
        one, room = evolved(prepared, mode, s, np.zeros(4), 0.0, [np.linalg.norm(rest[[0, 1, 3]]), abs(rest[2])])
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


def test_carry_adds_what_a_step_adds():
    E, R, scale = np.eye(4), np.array([3.0, 5.0]), np.array([1.0, 2.0, 4.0, 8.0])
    flow = np.zeros((4, 4))
    flow[0, 1] = flow[3, 2] = 1.0
    carry(E, R, flow, scale, 2.0, 7.0, 11.0)
    assert pytest.approx([10, 22]) == R
    assert (E[0, 1], E[3, 2], abs(E).sum()) == (0.5, 2.0, 2.5)
