"""Rings under a force: from when on body 2 stays within a radius, against runs in float64; what may not settle."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from control_scenes import DAMPED, outside

from numerics.arithmetic.ball import Ball
from numerics.control import ring as rings
from numerics.control.attraction import passage_at
from numerics.control.pictures import draw_ring
from numerics.control.ring import ring_entry
from numerics.errors import NotSettled
from numerics.scene import Force, Pair, Piece, Scene, Sine, State
from numerics.scene.file import load_scene
from numerics.solver.solve import solve

STUCK_AT_LAST = [Force.sine("0.2", 12), Force((Piece(0, ["0.4"]),)), Force.trapezoid(1, 0, 1, 0, 3)]


@pytest.mark.parametrize("force", STUCK_AT_LAST)
def test_the_ring_of_a_pair_that_sticks_at_last(force):
    found = ring_entry(Scene(DAMPED, State(v1=1), 5, force=force), "0.005")
    assert 0 < float(found.entry) - outside(found, 5, 5_001)[-1] < 0.0011
    assert draw_ring(found).axes


@pytest.mark.long
@pytest.mark.parametrize(("amplitude", "radius"), [("2", "0.02")])
def test_the_ring_around_a_periodic_motion(amplitude, radius):
    found = ring_entry(Scene(DAMPED, State(v1=1), 5, force=Force.sine(amplitude, 12)), radius, digits=12)
    entry = float(found.entry)
    t = np.linspace(entry - 0.1, entry + 0.4, 101)
    y, distances = solve(replace(found.scene, until=Fraction(8))).sol(t), []
    for k, at in enumerate(t):
        time = Ball.number(Fraction(at))
        x1, v1, x2, v2 = (float(one.mid()) for one in passage_at(found.orbit, time).state(time))
        distances.append(np.hypot(y[0, k] - y[2, k] - x1 + x2 - float(found.centre), y[1, k] - y[3, k] - v1 + v2))
    outside = np.array(distances) > float(radius)
    assert ring_entry(found.scene, radius, digits=5).centre.contains(found.centre)
    assert outside[:19].any()
    assert not outside[21:].any()


def test_the_ring_of_a_motion_that_slowly_closes_in_is_where_it_is_so_near_to_itself_many_periods_later():
    scene, per, periods = load_scene("forced-sine-stick-slip"), 2 * np.pi / 5, 79
    y = solve(replace(scene, until=Fraction(120))).sol
    entry = float(ring_entry(scene, "0.001", digits=12).entry)
    t = np.array([entry - 1e-6, entry + 1e-6, *np.linspace(entry + 0.01, entry + 15, 400)])
    apart = y(t) - y(t + periods * per)
    outside = np.hypot(apart[0] - apart[2], apart[1] - apart[3]) > 0.001
    assert outside[0]
    assert not outside[1:].any()


@pytest.mark.parametrize("force", [Force.step(0, "0.3"), Force((Piece(0, (), [Sine("0.3", 9)]), Piece(1, ["0.3"])))])
def test_a_pair_creeps_under_a_constant_force_as_without_one(force):
    found = ring_entry(Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), 5, force=force), "0.001")
    entry = float(found.entry)
    assert 0 < entry - outside(found, 1.2 * entry)[-1] < 1.3 * entry / 4000


def test_a_motion_that_may_never_settle_is_refused():
    scene = Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), 5, force=Force.sine("0.02", 7))
    with pytest.raises(NotSettled, match=r"not known to settle.*a larger radius does not help: the pair is not proved"):
        ring_entry(scene, "0.001")


def test_a_motion_that_is_not_proved_to_close_in_on_the_periodic_one_is_refused(monkeypatch):
    monkeypatch.setattr(rings, "periodic_settled", lambda *_: None)
    monkeypatch.setattr(rings, "_FORCED", (1, 2_000))
    with pytest.raises(NotSettled, match="closes in on the periodic motion; a larger radius may not help either"):
        ring_entry(Scene(DAMPED, State(v1=1), 1, force=Force.sine("0.5", 12)), "0.001")


def test_a_force_that_grows_has_no_ring():
    with pytest.raises(ValueError, match="grows"):
        ring_entry(Scene(DAMPED, State(), 1, force=Force((Piece(0, [0, 1]),))), 1)
