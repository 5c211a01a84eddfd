"""Transfers of the least int u^2 dt: forces against the independent reference, energies against a quadratic program."""

from fractions import Fraction

import numpy as np
import pytest
from control_scenes import DAMPED, FREE, arrived
from scipy.optimize import linprog, lsq_linear

from numerics import (
    Force,
    InvalidScene,
    Mode,
    NotSettled,
    Pair,
    Piece,
    Scene,
    State,
    cheapest_transfer,
    fastest_transfer,
    solve,
)
from numerics.arithmetic.ball import Ball
from numerics.control.least_peak import LeastPeak
from numerics.control.optimal import LeastEnergy

STIFF, HEAVY = Pair(1, 1, 200, "0.5", 40), Pair("0.7", 3, 90, "1.2", "0.2")
ASKED = [
    (FREE, "0.01", "0.3"),  # at the limit in the end
    (FREE, "0.01", "0.283"),  # at both ends
    (DAMPED, "-0.01", "0.57"),  # in the middle and in the end
    (FREE, "0.001", "0.2"),  # nowhere
    (HEAVY, "0.03", "0.6"),
    (FREE, "0.05", "0.76"),  # body 2 goes backwards first
    (STIFF, "0.05", "1.2"),
]


def planned(pair, distance, time, **asked):
    """The transfer of the least energy from rest."""
    return cheapest_transfer(Scene(pair, State(x2="0.25"), 1), distance, time, **asked)


@pytest.mark.parametrize(("pair", "distance", "time"), ASKED[:5])
def test_the_bodies_stick_and_arrive_at_rest_by_the_reference(pair, distance, time):
    run = arrived(planned(pair, distance, time), distance)
    assert (list(run.events), run.mode) == ([], 0)


def by_cells(pair, until, cells):
    """The force in the middle of equal cells, and v1 and x1 at the end, by the acceleration, constant on each cell."""
    h = until / cells
    middle = (np.arange(cells) + 0.5) * h
    since = middle[:, None] - np.arange(cells) * h
    began = np.clip(since, 0, h)
    v, x = began, began * since - began**2 / 2
    u = float(pair.mass) * np.eye(cells) + float(pair.a1) * v + float(pair.a2) * x
    left = until - np.arange(cells) * h
    return u, np.array([np.full(cells, h), h * left - h * h / 2])


def least_of_steps(pair, far, until, cells=160):
    """The least int u^2 of accelerations that are constant on each of equal cells, by bounded least squares."""
    h, (u, arrives) = until / cells, by_cells(pair, until, cells)
    weight = 1e4 * np.array([[1 / h], [1 / h / until]])
    most = float(pair.b / pair.m2)
    rows, goal = np.vstack([u, weight * arrives]), np.r_[np.zeros(cells), weight[:, 0] * (0, far)]
    found = lsq_linear(rows, goal, (-most, most), method="bvls", tol=1e-14, max_iter=4000)
    assert abs(arrives @ found.x - (0, far)).max() < 1e-4 * far
    return h * np.sum((u @ found.x) ** 2)


@pytest.mark.parametrize(("pair", "distance", "time"), ASKED)
def test_a_quadratic_program_finds_the_same_energy(pair, distance, time):
    found = planned(pair, distance, time)
    assert float(found.cost) == pytest.approx(least_of_steps(pair, abs(float(distance)), float(time)), rel=5e-3)
    assert 0 <= float((found.cost - found.least_cost) / found.cost) < 1e-17


def test_a_margin_costs_more_and_the_least_time_of_every_transfer_is_what_it_was():
    free, kept = (planned(FREE, "0.01", "0.4", margin=one) for one in (0, "0.2"))
    assert kept.cost > free.cost
    assert kept.bound.overlaps(free.bound)
    with pytest.raises(InvalidScene, match="no transfer that keeps the margin is faster"):
        planned(FREE, "0.01", "0.3", margin="0.2")


@pytest.mark.parametrize(("distance", "peak"), [("0.01", "1 N"), ("0.05", "9 N")])
def test_where_more_time_brings_nothing_the_peak_that_the_end_needs_is_named(distance, peak):
    """At the end u = a2 D - M b/m2 at least: a linear program finds no less, and no more, for long times."""
    with pytest.raises(NotSettled, match=f"with any time the end needs a peak of {peak}"):
        planned(FREE, distance, "0.76", least="peak")


@pytest.mark.parametrize(("share", "is_cheaper"), [("0.02", True), ("-0.02", False)])
def test_a_slip_at_the_limit_of_friction_can_be_cheaper(share, is_cheaper):
    """In the end friction brakes body 2 at its limit: body 1 may brake more, and x2(t) stays as it is."""
    found = planned(FREE, "0.01", "0.3")
    *_, start, end = found.scene.force.starts
    length = end - start
    # z' = -c s^2 (length - s)^2, z and z'' are exact
    c = Fraction(share) / length**4
    slope = [0, 0, *(-c * one for one in (length**2, -2 * length, 1))]
    place = [0, *(one / (k + 1) for k, one in enumerate(slope))]
    bend = [k * one for k, one in enumerate(slope)][1:]
    extra = [FREE.a2 * one for one in place]
    extra = [one + (FREE.m1 * bend[k] if k < len(bend) else 0) for k, one in enumerate(extra)]
    gone = sum(one * length**k for k, one in enumerate(place))
    scene = found.scene.replace(force=found.scene.force + Force((Piece(start, extra), Piece(end, (FREE.a2 * gone,)))))
    solved = solve(scene, digits=15, arithmetic="ball")
    times = [Fraction(2 * k + 1, 4000) * end for k in range(2000)]
    energy = sum(float(scene.force(one)) ** 2 for one in times) * float(end) / 2000
    if is_cheaper:
        assert Mode.SLIP_MINUS in solved.modes
        assert energy < 0.999 * float(found.least_cost)
        assert np.allclose([float(one) for one in solved.final_state], [0.01 + float(gone), 0, 0.26, 0], atol=1e-15)
    else:
        assert energy > 1.001 * float(found.cost)


@pytest.mark.parametrize("wrong", ["force", "nu", "mu", "later"])
@pytest.mark.parametrize(
    ("kind", "far"), [(LeastEnergy, "0.001"), (LeastEnergy, "1e-100"), (LeastPeak, "0.004"), (LeastPeak, "1e-100")]
)
def test_the_bound_holds_for_a_wrong_force_too_and_shows_it(kind, far, wrong):
    """What is proved does not rest on the search: another force has a bound that is true, and a gap."""
    with Ball(60).context():
        search = kind(FREE, Fraction(far), Fraction("0.2"))
        found = search.force()
        cost, bound = search.bound(found)
        assert 0 <= cost - bound < cost * 1e-17
        if wrong == "force":
            found = search.follow(found.q * Ball.number(Fraction(101, 100)), found.r, search.limit)
        elif wrong == "later":
            found = kind(FREE, Fraction(far), Fraction("0.201")).force()
        else:
            found.end[2 if wrong == "nu" else 3] *= 1 + Ball.number(Fraction(1, 1000))
        try:
            _, less = search.bound(found)
        except NotSettled:  # its multipliers have no sign
            return
        assert less < bound


@pytest.mark.parametrize("pair", [FREE, DAMPED])
def test_the_energy_of_a_tiny_distance_goes_with_its_square(pair):
    rest = Scene(pair, State(), 1)
    near = cheapest_transfer(rest, "0.0001", "0.3")
    for power in (100, 300):
        tiny = cheapest_transfer(rest, f"1e-{power}", "0.3")
        with Ball(40).context():
            for one in (tiny.cost, tiny.least_cost):
                assert abs(one * Ball.number(10) ** (2 * power - 8) / near.cost - 1) < 1e-17


def test_a_bound_that_is_not_close_is_not_given(monkeypatch):
    monkeypatch.setattr(LeastEnergy, "bound", lambda *_: (Ball.number(1), Ball.number(1 - Fraction(1, 10**9))))
    with pytest.raises(NotSettled, match="no force of least energy was found"):
        planned(FREE, "0.001", "0.2")


@pytest.mark.parametrize(
    ("pair", "distance", "time"),
    [
        (FREE, "0.001", "0.2"),
        (FREE, "-0.0005", "1.7"),  # seven arcs
        (DAMPED, "0.0005", "1.3"),
        (Pair(1, 1, 200, "0.5", 60), "0.001", "0.3"),  # beyond critical damping
        (FREE, "0.004", "0.2"),  # at the limit of friction in the end
        (FREE, "0.01", "0.2829"),  # in the beginning, too, and nearly in the least time
        (DAMPED, "-0.01", "0.33"),  # it starts backwards
        (HEAVY, "0.03", "0.6"),
    ],
)
def test_the_least_peak_arrives_and_no_program_finds_a_lower_one(pair, distance, time):
    found, far, until, cells = planned(pair, distance, time, least="peak"), abs(float(distance)), float(time), 400
    run = arrived(found, distance)
    assert (list(run.events), run.mode) == ([], 0)
    assert 0 <= float((found.cost - found.least_cost) / found.cost) < 1e-16
    forces = [found.scene.force(Fraction(k, 999) * Fraction(time)) for k in range(999)]
    assert max(map(abs, forces)) <= Fraction(found.cost.upper().str(40, radius=False)) * (1 + Fraction(1, 10**30))
    u, arrives = by_cells(pair, until, cells)
    unknown = np.r_[np.zeros(cells), 1]
    within = np.vstack([np.c_[u, -np.ones(cells)], np.c_[-u, -np.ones(cells)]])
    bounds = [(-float(pair.b / pair.m2), float(pair.b / pair.m2))] * cells + [(0, None)]
    least = linprog(unknown, within, np.zeros(2 * cells), np.c_[arrives, np.zeros(2)], (0, far), bounds)
    assert float(found.cost) == pytest.approx(least.fun, rel=2e-2)


def test_a_motion_at_the_limit_that_begins_between_two_looks_is_not_missed():
    """A search once followed this one a step too far, to a force under which the bodies slip."""
    pair = Pair("0.8995", "0.1586", "90.4", "0.01315")
    found = planned(pair, "0.002374", "0.40610685")
    assert float(found.cost) == pytest.approx(least_of_steps(pair, 0.002374, 0.40610685), rel=5e-4)
    assert arrived(found, "0.002374").mode == 0


def test_the_least_peak_is_that_of_the_fastest_transfer_under_it():
    fastest = fastest_transfer(Scene(FREE, State(), 1), "0.0005", amplitude="0.5")
    found = planned(FREE, "0.0005", fastest.time.str(35, radius=False), least="peak")
    assert float(found.cost) == pytest.approx(0.5, rel=1e-14)
