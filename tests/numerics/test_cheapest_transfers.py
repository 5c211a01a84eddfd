"""Transfers of the least int u^2 dt or max |u|: against the independent reference, and programs over sampled forces."""

from fractions import Fraction

import numpy as np
import pytest
from control_scenes import DAMPED, FREE, arrived
from flint import arb
from scipy.optimize import linprog, lsq_linear

from numerics import NotSettled, Pair, Scene, State, cheapest_transfer
from numerics.arithmetic.ball import Ball
from numerics.control.least_energy import Search

STIFF, HEAVY = Pair(1, 1, 200, "0.5", 40), Pair("0.7", 3, 90, "1.2", "0.2")
OVERDAMPED = Pair(1, 1, 200, "0.5", 60)


def planned(pair, distance, time, **asked):
    """The cheapest transfer from rest."""
    return cheapest_transfer(Scene(pair, State(x2="0.25"), 1), distance, time, **asked)


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


def least_energy(pair, far, until, cells=160):
    """By bounded least squares."""
    h, (u, arrives) = until / cells, by_cells(pair, until, cells)
    weight = 1e4 * np.array([[1 / h], [1 / h / until]])
    most = float(pair.b / pair.m2)
    rows, goal = np.vstack([u, weight * arrives]), np.r_[np.zeros(cells), weight[:, 0] * (0, far)]
    found = lsq_linear(rows, goal, (-most, most), method="bvls", tol=1e-14, max_iter=4000)
    assert abs(arrives @ found.x - (0, far)).max() < 1e-4 * far
    return h * np.sum((u @ found.x) ** 2)


def least_peak(pair, far, until, cells=400):
    """By a linear program."""
    u, arrives = by_cells(pair, until, cells)
    within = np.vstack([np.c_[u, -np.ones(cells)], np.c_[-u, -np.ones(cells)]])
    bounds = [(-float(pair.b / pair.m2), float(pair.b / pair.m2))] * cells + [(0, None)]
    unknown, ends = np.r_[np.zeros(cells), 1], np.c_[arrives, np.zeros(2)]
    return linprog(unknown, within, np.zeros(2 * cells), ends, (0, far), bounds).fun


WITHIN = {"energy": (least_energy, 5e-3, 0.0, 1e-17), "peak": (least_peak, 2e-2, -1e-30, 1e-30)}
"""Of each cost the program, how good it is, and by what part of the cost the bound that is proved may be below it."""


PAIRS = {"free": FREE, "damped": DAMPED, "stiff": STIFF, "heavy": HEAVY, "overdamped": OVERDAMPED}
ASKED = """
energy free        0.01    0.3     at the limit in the end
energy free        0.01    0.283   at both ends
energy damped     -0.01    0.57    in the middle and in the end
energy free        0.001   0.2     nowhere
energy heavy       0.03    0.6
energy free        0.05    0.76    body 2 goes backwards first
energy stiff       0.05    1.2
peak   free        0.001   0.2
peak   free       -0.0005  1.7     seven arcs
peak   damped      0.0005  1.3
peak   overdamped  0.001   0.3
"""


@pytest.mark.parametrize("row", ASKED.strip().splitlines())
def test_the_bodies_stick_and_arrive_by_the_reference_and_no_program_finds_less(row):
    least, name, distance, time, *_ = row.split()
    pair, (program, close, low, high) = PAIRS[name], WITHIN[least]
    found = planned(pair, distance, time, least=least)
    run = arrived(found, distance)
    assert (list(run.events), run.mode) == ([], 0)
    assert low <= float((found.cost - found.least_cost) / found.cost) < high
    assert float(found.cost) == pytest.approx(program(pair, abs(float(distance)), float(time)), rel=close)


def test_a_margin_costs_more_and_takes_longer_at_least():
    free, kept = (planned(FREE, "0.01", "0.4", margin=one) for one in (0, "0.2"))
    assert kept.cost > free.cost
    assert kept.bound > free.bound


@pytest.mark.parametrize("far", [Fraction("0.001"), Fraction("1e-100")])
def test_the_bound_holds_for_wrong_forces_too_and_shows_them(far):
    """What is proved does not rest on the search: another force, nu or mu has a bound that is true, and a gap."""
    with Ball(60).context():
        search, most = Search(FREE, far, Fraction("0.2")), FREE.b
        found = search.force(most)
        cost, bound = search.bound(found, most)
        assert 0 <= cost - bound < cost * 1e-30
        wrong = [search.arrive(found.q, found.r, found.largest * 0.9), Search(FREE, far, Fraction("0.201")).force(most)]
        for k in (2, 3):
            end = [one * (1 + arb("0.001") * (j == k)) for j, one in enumerate(found.ends[0])]
            wrong.append(found._replace(ends=[end, *found.ends[1:]]))
        for more, less in (search.bound(one, most) for one in wrong):
            assert less < bound
            assert more - less > cost * 1e-8


def test_a_bound_that_is_not_close_is_not_given(monkeypatch):
    monkeypatch.setattr(Search, "bound", lambda *_: (Ball.number(1), Ball.number(1 - Fraction(1, 10**9))))
    with pytest.raises(NotSettled, match="no force of least energy was found"):
        planned(FREE, "0.001", "0.2")
