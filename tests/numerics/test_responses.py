"""Periodic motions: by independent references; their regime, their multipliers, and what is said of all others."""

from contextlib import suppress
from fractions import Fraction

import numpy as np
import pytest
from control_scenes import DAMPED, FREE, answer, referred, under
from flint import acb, arb
from hypothesis import example, given
from hypothesis import strategies as st
from scene_files import scenes_in
from strategies import decimals, fewer, signed, sine_scenes

from numerics import EventUndecided, Pair, response, solve
from numerics.arithmetic.ball import Ball, exact_middle
from numerics.control.drive import entrained
from numerics.control.response import Regime, Response, attraction_of, last_drive
from numerics.scene import largest

SCENES = scenes_in("periodic")


def comes_back(found: Response, digits: int) -> None:
    """It has these events in a period, and its first state again, by the reference."""
    period, legs = found.one_period(), [] if found.orbit is None else found.orbit.legs
    run = referred(period)
    assert [event.after for event in run.events] == [leg.side for leg in (*legs[1:], *legs[:1])]
    with Ball(40).context():
        at = [Ball.number(one) for one in (period.initial.x1, period.initial.v1)]
        for end, begun in zip(run.state()[:2], at, strict=True):
            assert abs(end - begun) < sum(map(abs, at), arb(0)) * arb(10) ** -digits


@given(sine_scenes())
@fewer(2)
@example((under(Pair(1, 1, 200, "0.5", "0.5"), "5.7754", 4), Regime.STICK_SLIP))  # else a stick would break at -b
def test_a_periodic_motion_comes_back_by_the_reference(case):
    scene, regime = case
    found = response(scene, digits=20)
    assert found.regime is regime
    assert all(abs(one) < 1 for one in found.multipliers)
    comes_back(found, 18)


@given(
    decimals(-2, 1), decimals(-2, 1), decimals(-1, 2), signed(decimals(-6, -2)), st.sampled_from([0, "1e-5", "-0.5"])
)
@fewer(4)
@example(Fraction(1), Fraction(1), Fraction(10), Fraction(-1, 20_000_000), 0)
def test_a_weak_force_at_resonance_keeps_the_pair_next_to_its_critical_orbit(m1, m2, omega, share, apart):
    """U = share b; the sine is at the resonance of the stuck pair, or so far from it that friction holds no more."""
    off = 1 + Fraction(apart) * abs(share) * m2 / (2 * (m1 + m2))
    found = response(under(Pair(m1, m2, (m1 + m2) * (omega / off) ** 2, 1), share, omega), digits=12)
    assert found.regime is Regime.STICK_SLIP
    comes_back(found, 11)


# which regime, and what is said of it


def test_a_load_above_the_limit_for_a_ten_thousandth_of_a_period_is_seen():
    """It is above b by 10^-7 of it, and less than b at each of 4096 times: the pair is not entrained."""
    with suppress(EventUndecided):
        assert response(SCENES["above-the-limit-for-a-moment"]).regime is not Regime.ENTRAINED


def test_that_friction_does_not_hold_under_nearly_incommensurable_sines_is_seen_at_once(monkeypatch):
    """At all halves of halves of so long a period 12 rad/s has one phase: that took minutes."""
    monkeypatch.setattr(largest, "_MOST_PARTS", 512)
    drive = last_drive(SCENES["nearly-incommensurable-sines"])
    with Ball(30).context():
        assert not entrained(drive)


REGIMES = """
1 1 200 0.5    | 0.5    20 | ENTRAINED  | yes | but each tends to one in which the bodies stick permanently
1 1 200 0.5    | 0.75   20 | ENTRAINED  | no  | permanently; the load of the stuck response touches the limit
1 1 200 0.5    | 8    10/3 | ENTRAINED  | no  | is odd; the load of the stuck response touches the limit
1 1  68 0.5  5 | 0.5     4 | ENTRAINED  | yes | every motion tends to it, and sticks
1 2  84 0.5 12 | 0.9375  4 | ENTRAINED  | no  | every motion
1 2  84 0.5 12 | 0.9375000000001 4 | STICK_SLIP | yes | every motion
1 1 100 0.5    | 0.6    10 | STICK_SLIP | yes |
0.968 0.4166 66.11 0.2797 | 0.36 8.26 | NON_STOP | yes | every motion tends to it: all multipliers are below 1
1 1 100 0.5    | 0.8    10 | GROWS      | no  | every motion grows
"""
"""m1, m2, a2, b and a1; the force; the regime; whether there are multipliers. U* is 0.75 N in the first rows: at it no
other motion sticks for ever beside the entrained one. In the fourth |Z| = |36 + 48 i| = 60."""


@pytest.mark.parametrize("row", REGIMES.strip().splitlines())
def test_regime_and_attraction_on_both_sides_of_a_threshold(row):
    pair, force, regime, has_multipliers, said = (one.strip() for one in row.split("|"))
    amplitude, omega = force.split()
    found = answer(Pair(*pair.split()), amplitude, omega)
    assert (found.regime.name, found.multipliers is not None) == (regime, has_multipliers == "yes")
    assert said in found.attraction
    if regime == "GROWS":
        assert abs(found.growth - (arb(amplitude) - 2 / arb.pi()) / 2) < 1e-10


def test_so_little_above_the_threshold_of_growth_that_digits_must_rise_twice_it_grows():
    over = Fraction(1, 10**60)
    with Ball(80).context():
        U = exact_middle(2 / arb.pi()) + over
    assert answer(Pair(1, 1, 100, "0.5"), U, 10).regime is Regime.GROWS


def test_two_sines_at_resonance_grow_by_their_sum():
    growth = response(SCENES["two-sines-at-resonance"]).growth
    assert abs(growth - (arb("1.6") * arb("0.5").cos() - 2 / arb.pi()) / 2) < 1e-8


def test_a_motion_that_attracts_is_the_only_one_and_drifts_only_under_a_force_that_is_not_odd():
    """Without a damper and without a stop its multipliers, all below 1, prove it; another start gets there."""
    damped, free = (answer(pair, "2") for pair in (DAMPED, FREE))
    assert damped.regime is free.regime is Regime.NON_STOP
    assert damped.drift.is_zero()
    assert free.drift.is_zero()
    assert "all multipliers are below 1" in free.attraction
    for one in (acb(0, 1), acb(arb("0.99", "0.02"))):  # on the unit circle, and not known to be inside
        assert "not proved" in attraction_of(free.orbit, (one, acb(0)))
    scene = under(FREE, 2).replace(x1="0.02", until=60)
    ends = [solve(scene.replace(v2=v2)).final for v2 in ("-0.1", "0.3")]
    assert np.allclose(*([one.x1, one.v1, one.v2] for one in ends), atol=1e-6)
    assert not response(SCENES["a-force-that-is-not-odd"], digits=8).drift.contains(0)


def test_the_last_piece_and_the_last_friction_decide():
    assert response(SCENES["the-last-piece-decides"]).drive == answer(DAMPED, "0.5").drive


def test_a_stick_before_the_first_slip_of_a_period_counts():
    orbit = response(SCENES["a-force-that-is-not-odd"].replace(a1=0), digits=8).orbit
    assert [leg.side for leg in orbit.legs] == [1, -1, 0]
    assert "a slip after a stick phase does not last" in attraction_of(orbit, (acb(0, 1), acb(0)))
