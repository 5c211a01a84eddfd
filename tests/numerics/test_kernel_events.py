"""Sets of errors, and what an event does to them: held against neighbours that are followed through their events."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_runs import a_scene, begun
from scipy.linalg import expm
from scipy.optimize import brentq

from numerics.arithmetic.pair import Pair
from numerics.linear.error_set import box, carry, norm_of, take_in, width
from numerics.linear.first_root import ROOT
from numerics.linear.modes import UNDECIDED
from numerics.linear.next_event import Next
from numerics.linear.resolve import errors_after_slip, errors_after_stick, lateness, mode_after

seeds = st.integers(0, 2**32 - 1)


def directions(random, E, R):
    """Members of the set E c + r: at its corners, and as far as the rest reaches."""
    for _ in range(20):
        rest = random.normal(size=4)
        rest[2] = 0.0
        rest *= R[0] / np.linalg.norm(rest)
        rest[2] = random.choice([-1, 1]) * R[1]
        yield E @ random.choice([-1.0, 1.0], E.shape[1]) + rest


@given(seeds, st.sampled_from([1, 2, 4]), st.sampled_from([0.0, 1.0]))
def test_bounds_hold_for_the_members_of_a_set_and_are_reached(seed, columns, part):
    random = np.random.default_rng(seed)
    E, R, w = np.zeros((4, 4)), random.uniform(0, 1, 2) * (1.5 - part), random.normal(size=4) * [1, 1, 0, 1]
    E[:, :columns] = random.normal(size=(4, columns)) * 10 ** random.uniform(-3, 0, columns) * part
    for one in directions(random, E, R):
        assert all(abs(one[i]) <= box(E, R, i) for i in range(4))
        assert abs(w @ one) <= width(E, R, w[0], w[1], w[3])
        assert np.linalg.norm(one[[0, 1, 3]]) <= norm_of(E, R)
    nearest = E @ np.sign(w @ E) + w / np.linalg.norm(w) * R[0]
    assert w @ nearest > (1 - 1e-6) * width(E, R, w[0], w[1], w[3])
    whole, members = norm_of(E, R), [*directions(random, E, R)]
    assert norm_of(1e-170 * E, 1e-170 * R) >= 1e-170 * whole  # its squares are no numbers
    take_in(E, R, np.zeros((4, 4)), np.zeros(4))
    assert not R.any()
    assert all((abs(np.linalg.solve(E, one)) <= 1 + 1e-9).all() for one in members)
    assert norm_of(E, R) < 8 * whole
    thin = np.outer(members[0], [0.0, 1.0, 0.0, 0.0])
    take_in(thin, R, np.zeros((4, 4)), np.zeros(4))
    np.testing.assert_allclose(thin @ thin.T, np.outer(members[0], members[0]), atol=1e-9)


@given(seeds, st.sampled_from([-1, 0, 1]))
def test_errors_are_carried_by_the_flow_of_a_mode(seed, mode):
    random = np.random.default_rng(seed)
    problem, room, _ = begun(a_scene(random))
    pair, scale = problem.pair, room.scale
    E, R, time = random.normal(size=(4, 4)), random.uniform(0, 1, 2), random.uniform(0, 2)
    if mode == 0:  # both bodies have one velocity
        E[3] = E[1] * scale[3] / scale[1]
    flow = np.array([moving(pair, mode, 0.0, (0.0, 0.0), time, one) for one in np.eye(4)]).T
    far = abs(flow[2, 3]) * scale[2] / scale[3] if mode else 2.0
    expected = (flow * scale[:, None] / scale) @ E, [R[0] + 0.1, R[1] + far * R[0] + 0.2]
    carry(E, R, pair, mode, time, (flow[0, 1], flow[1, 1]), 0.1, 0.2)
    np.testing.assert_allclose(E, expected[0], rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(R, expected[1], rtol=1e-6)


@given(seeds, st.tuples(*[st.sampled_from([0.0, 1.0])] * 3))
def test_in_stick_an_error_of_one_velocity_may_be_a_column_and_a_rest_of_two(seed, part):
    random = np.random.default_rng(seed)
    problem, room, _ = begun(a_scene(random))
    pair, scale, (x, v, apart) = problem.pair, room.scale, random.normal(size=3)
    error = scale * [x, v, apart, v]
    rest, time, E = error * [*part[:2], 0.0, part[2]], random.choice([0.0, 0.1, 1.0]), np.zeros((4, 4))
    E[:, 0], R = error - rest, np.array([np.linalg.norm(rest), 0.0])
    flow = np.array([moving(pair, 0, 0.0, (0.0, 0.0), time, one) for one in np.eye(4)]).T
    carry(E, R, pair, 0, time, (flow[0, 1], flow[1, 1]), 0.0, 0.0)
    moved = scale * (flow @ (error / scale))
    assert np.sum(moved[[0, 1, 3]] ** 2) <= width(E, R, moved[0], moved[1], moved[3])
    assert all(abs(moved[i]) <= box(E, R, i) for i in range(4))


def moving(pair, mode, b, u, t, y):
    """The state (x1, v1, x2, v2) after a time in a mode under u + u' t; before it for t < 0."""
    A, mass = np.zeros((6, 6)), pair.m1 if mode else pair.mass
    A[0, 1] = A[2, 3] = 1.0
    A[1] = np.array([-pair.a2, -pair.a1, 0, 0, 1, -mode * b]) / mass
    A[3] = [0, 0, 0, 0, 0, mode * b / pair.m2] if mode else A[1]
    A[4, 5] = u[1]
    return (expm(A * t) @ [*y, u[0], 1])[:4]


class Event:
    """A pair at an event at t = 0 under u + u' t, and one column of errors that move the event by little."""

    def __init__(self, random, mode, load):
        problem, self.room, _ = begun(a_scene(random))
        pair, scale = problem.pair._replace(literal=False), self.room.scale
        v, b = random.normal(), random.uniform(0.3, 2)
        self.mode, self.pair, self.b, self.load = mode, pair, b, load * b
        unit = 1 / (1 + pair.a1 / pair.m1 + pair.m1**-0.5)
        rising = random.normal() if mode else load * random.uniform(0.3, 1) / unit
        speeding = self.load / pair.m2 if mode == 0 else (self.load * pair.mass / pair.m2 - mode * b) / pair.m1
        turning = b * rising * pair.mass / pair.m2 + pair.a2 * v + pair.a1 * speeding
        self.slope = pair.mass / (pair.m1 * pair.m2) * abs(self.load - mode * b) if mode else b * abs(rising)
        self.u = random.normal(), random.choice([0.0, turning, 100 * pair.m1 * self.slope]) if mode else turning
        x = (self.u[0] - pair.a1 * v - self.load * pair.mass / pair.m2) / pair.a2
        self.y, self.scale = np.array([x, v, 0.0, v]), scale
        column = random.normal(size=4)
        column[0] *= random.choice([1, 30]) if mode else 1
        column[3] = column[3] if mode else column[1] * scale[3] / scale[1]
        late = 10 ** random.uniform(-6, -3) * unit
        self.column = column * late * self.slope / abs(self.guard(self.y + column / scale))
        if mode:  # what is found of the event is off
            self.y[1] += random.choice([0.0, 0.0, 0.3]) * self.slope * late
        self.begun, self.is_exact = self.y, self.y[1] == self.y[3]
        self.room.y[:, 0], self.room.E[:, 2] = self.y, self.column
        ahead = Next(ROOT, Pair(0.5, 0.0), 1, 0.1, slope=self.slope, window=0.0, own=0.0)
        self.late, self.off, _ = lateness(pair, self.room, ahead, mode, b, 1e300, 1e300)
        self.y = self.room.y[:, 0].copy()
        self.force = self.u[0], abs(self.u[1]), abs(self.u[0]) + abs(self.u[1])

    def loaded(self, y, t):
        """The force that would keep the bodies together."""
        pull = self.pair.a2 * y[0] + self.pair.a1 * y[1]
        return (self.u[0] + self.u[1] * t - pull) * self.pair.m2 / self.pair.mass

    def guard(self, y, t=0.0):
        """v1 - v2, in stick the load less that of the event, at a time after a state."""
        y = moving(self.pair, self.mode, self.b, self.u, t, y)
        return y[1] - y[3] if self.mode else self.loaded(y, t) - self.load

    def neighbours(self, after):
        """For both ends of the column: the state, the error after both events, and the load at the second one."""
        for sign in (1, -1):
            start = self.begun + sign * self.column / self.scale
            t = brentq(lambda at, y=start: self.guard(y, at), -self.late, self.late, xtol=1e-17, rtol=1e-14)
            there = moving(self.pair, self.mode, self.b, self.u, t, start)
            back = moving(self.pair, after, self.b, (self.u[0] + self.u[1] * t, self.u[1]), -t, there)
            yield start, (back - self.y) * self.scale, self.loaded(there, t)

    def farthest(self, found):
        """How far out errors lie in the set, its edge being 1."""
        take_in(self.room.E, self.room.R, self.room.basis, self.room.column)
        errors = np.array([error for _, error, _ in found]).T
        c = np.linalg.pinv(self.room.E, 1e-14) @ errors
        assert abs(self.room.E @ c - errors).max() <= 1e-7 * abs(errors).max()
        return abs(c).max()


@settings(max_examples=40, derandomize=True)
@given(seeds, st.sampled_from([1, -1]), st.sampled_from([-0.8, -0.3, 0.5, 0.9, -1.2, -3.0]))
def test_after_the_end_of_a_slip_neighbours_are_in_the_new_set(seed, side, load):
    event = Event(np.random.default_rng(seed), side, side * load)
    after = -side if load < -1 else 0
    found = [*event.neighbours(after)]
    apart = errors_after_slip(event.pair, event.room, side, after, event.force, event.b, event.late, event.slope)
    assert 0.5 * event.is_exact < event.farthest(found) <= 1 + 1e-6
    for start, *_ in found:
        assert 0.2 * apart < max(abs(event.guard(start, t)) for t in (-event.late, event.late)) <= apart


@settings(max_examples=40, derandomize=True)
@given(seeds, st.sampled_from([1, -1]))
def test_after_an_exit_neighbours_are_in_the_new_set(seed, side):
    event = Event(np.random.default_rng(seed), 0, side)
    found = [*event.neighbours(side)]
    gained = errors_after_stick(event.pair, event.room, event.force, event.late, event.slope, event.off)
    assert 0.5 < event.farthest(found) <= 1 + 1e-6
    before, after = (
        max(np.linalg.norm(one[[0, 1, 3]]) for one in errors) for errors in ([event.column], [e for _, e, _ in found])
    )
    assert after <= before + gained


@settings(max_examples=40, derandomize=True)
@given(seeds, st.sampled_from([1, -1]), st.floats(-6, -2), st.sampled_from([1, -1]))
def test_what_follows_a_slip_is_in_doubt_where_a_neighbour_has_another_mode(seed, side, exponent, beyond):
    event = Event(np.random.default_rng(seed), side, -side * (1 + beyond * 10**exponent))
    found = mode_after(event.pair, event.room, event.force, event.b, 1e300, event.late)
    loads = [abs(load) for *_, load in event.neighbours(0)]
    if any((load > event.b) != (beyond > 0) for load in loads):
        assert found == UNDECIDED
    pair, y = event.pair, event.y
    at_once = abs(event.loaded(y + event.column / event.scale, 0) - event.load)
    force = abs(event.load) * pair.mass / pair.m2 + event.b
    later = event.late * (event.force[1] + pair.a2 * abs(y[1]) + pair.a1 * force / pair.m1) * pair.m2 / pair.mass
    if event.is_exact and 10**exponent * event.b > 3 * (at_once + later):
        assert found == (-side if beyond > 0 else 0)
