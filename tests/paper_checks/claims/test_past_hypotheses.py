"""What a theorem leaves out fails: a counterexample for each hypothesis that a sentence once lacked."""

import math

import numpy as np
import pytest

from numerics import Force, Pair, Scene, State, solve
from numerics.linear.modes import Mode
from paper_checks.claims import claim_named


def sentence(row, clause):
    claim = claim_named(row)
    return next(one.text for one in (*claim.clauses, *claim.correction) if one.id == clause)


def half_turn(inertia, stiffness, omega, friction, place, start, end):
    """Carry (x, v), linear in (x0, v0, U_sin, U_cos, 1), from start to end: no damper, friction against body 1."""
    pace, gain = math.sqrt(stiffness / inertia), 1 / (stiffness - inertia * omega**2)

    def forced(t):
        s, c = gain * math.sin(omega * t), gain * math.cos(omega * t)
        return np.array([[0, 0, s, c, -friction / stiffness], [0, 0, omega * c, -omega * s, 0]])

    c, s = math.cos(pace * (end - start)), math.sin(pace * (end - start))
    return np.array([[c, s / pace], [-pace * s, c]]) @ (place - forced(start)) + forced(end)


def two_stop_amplitude(stiffness, omega, slip):
    """Return U of the conditions of two stops over U_*: unit masses, b = 1 N, no damper, a slip of the time slip."""
    begin = np.eye(5)[:2]
    end = half_turn(1, stiffness, omega, 1, begin, 0, slip)
    back = half_turn(2, stiffness, omega, 0, end, slip, math.pi / omega) + begin
    at_end = end[1] - begin[1] - np.array([0, 0, 0, 0, slip])
    rows = np.array([[-stiffness, 0, 0, 1, -2], at_end, *back])
    _, _, in_sine, in_cosine = np.linalg.solve(rows[:, :4], -rows[:, 4])
    return math.hypot(in_sine, in_cosine) * omega**2 / abs(stiffness - 2 * omega**2)


def test_short_slips_lead_to_the_first_threshold_but_at_odd_multiples():
    assert two_stop_amplitude(2, 0.8, 0.02) == pytest.approx(1, rel=1e-3)
    assert two_stop_amplitude(18, 1, 0.02) == pytest.approx(9 / 8, rel=1e-3)  # Omega = 3 omega
    assert two_stop_amplitude(50, 1, 0.02) == pytest.approx(25 / 24, rel=1e-3)  # Omega = 5 omega
    assert "neither $\\Omega$ nor $\\omega_1$ be an odd multiple" in sentence("entrainment-threshold", "two-ends")


def test_a_slip_that_follows_a_slip_may_be_short_and_cheap():
    """Unit masses and spring, b_k = 1 N, b_s = 2 N: a slip of sign 1 goes over into the other at |Lambda| = 1.01 N."""
    place, speed, before = 2.02, -1.0, 0.5
    past = (-1 + (place + 1) * math.cos(before) - speed * math.sin(before),)
    past += ((place + 1) * math.sin(before) + speed * math.cos(before), speed - before)
    energy = sum(one**2 for one in past) / 2
    assert past[1] > past[2]  # it comes from a slip of sign 1
    run = solve(Scene(Pair(m1=1, m2=1, a2=1, b=1), State(x1="2.02", v1=-1, v2=-1), until=1))  # by kinetic friction
    assert run.modes[:2] == (Mode.SLIP_MINUS, Mode.STICK)
    lasts = float(run.events[0].t)
    least = 1 / (math.sqrt(2 * energy) + 1)
    assert lasts < least / 5
    end = run.sol(lasts)
    lost = (place**2 + 2 * speed**2) / 2 - (end[0] ** 2 + end[1] ** 2 + end[3] ** 2) / 2
    assert 0 < lost < 2 * least**2 / 16 / 500
    assert "also where a slip ends" in sentence("static-friction-stops-creeping", "costs")


def test_body_1_tracks_but_for_the_offset_of_the_force():
    """x_ref = 0: under its force with gamma = 1/2 the pair rests with body 1 at 1/2, and others come to rest there."""
    pair, force = Pair(m1=1, m2=1, a1=1, a2=1, b=1), Force.step(0, "1/2")
    for start in (State(x1="1/2"), State(x1=-1, v1=2)):
        end = solve(Scene(pair, start, until=60, force=force)).sol(60)
        assert end[[0, 1, 3]] == pytest.approx([0.5, 0, 0], abs=1e-6)
    assert "$x_1$ does but for the $\\gamma$" in sentence("damping-for-tracking", "velocity")
