"""Transfers from rest to rest: planned forces against the independent reference, bounds by what no control can do."""

import math
from fractions import Fraction
from itertools import pairwise

import pytest
from control_scenes import DAMPED, FREE, referred
from hypothesis import example, given, settings
from hypothesis import strategies as st
from strategies import decimals, pairs

from numerics import Force, InvalidScene, Pair, Scene, State, fastest_transfer
from numerics.arithmetic.ball import Ball
from numerics.control.answers import rounded
from numerics.control.transfer import Road


def planned(distance, pair=FREE, **asked):
    """The fastest transfer from rest."""
    return fastest_transfer(Scene(pair, State(x2="0.25"), 1), distance, **asked)


def arrived(found):
    """x2 less its goal, v1 and v2 at the end, whether it stuck, by the independent reference."""
    # the slip transfer stays 10^-20 inside its limits: that must not look like a tie
    run = referred(found.scene, digits=80)
    with Ball(36).context():
        start = Ball.number(found.scene.initial.x2 + found.distance)
        return run.x2 - start, run.v1, run.v2, not run.events and run.mode == 0


PLANS = [
    (FREE, {"distance": "0.01"}, Road.STUCK),
    (DAMPED, {"distance": "-0.01"}, Road.STUCK),
    (DAMPED, {"distance": "0.01", "margin": "0.25"}, Road.STUCK),
    (FREE, {"distance": "0.001", "amplitude": "1.08"}, Road.SLIP),
    (DAMPED, {"distance": "0.001", "amplitude": "1.12"}, Road.SLIP),
    (FREE, {"distance": "-0.001", "amplitude": "0.5"}, Road.BANG_BANG),
    (FREE, {"distance": "0.0005", "amplitude": "0.3", "margin": "0.2"}, Road.BANG_BANG),
]


@pytest.mark.parametrize(("pair", "plan", "road"), PLANS)
def test_a_transfer_arrives_at_rest_by_the_reference(pair, plan, road):
    found = planned(pair=pair, **plan)
    assert found.road is road
    off, v1, v2, stuck = arrived(found)
    assert abs(off) < 1e-19
    assert abs(v1) + abs(v2) < 1e-18
    assert stuck == (road is not Road.SLIP)
    if "amplitude" in plan:
        limit = Fraction(plan["amplitude"])
        until = float(found.scene.until)
        assert all(abs(found.scene.force(until * k / 500)) <= float(limit) * (1 + 1e-12) for k in range(500))


@given(decimals(-4, -3, 2), st.integers(1, 9))
@settings(max_examples=8)
def test_more_force_is_never_slower(distance, part):
    """Of the amplitudes for which a transfer is known, none takes longer than a smaller one, none beats the bound."""
    known = planned(distance)
    times = []
    for k in range(1, 10):
        amplitude = Fraction(float(known.stuck_amplitude)) * k / 5 * Fraction(part + 20, 21)
        found = planned(distance, amplitude=amplitude)
        if found.time is not None:
            assert not found.time < found.bound
            times.append(found.time)
    assert all(not two > one for one, two in pairwise(times))


def test_between_the_amplitudes_it_says_that_the_least_time_is_open():
    found = planned("0.01", amplitude="1.5")
    assert found.road is Road.OPEN
    assert found.scene is None
    assert "whether slipping meets the bound with less is open" in found.fastest  # g' < 0 before half time
    weaker = planned("0.001", amplitude=1)
    assert weaker.road is Road.OPEN
    assert "no control meets the bound with less than 1.03496 N" in weaker.fastest


@pytest.mark.parametrize(
    ("amplitude", "said"),
    [
        ("0.8", "no control within the amplitude is faster: none can break the contact before"),
        ("0.85", "no control that sticks is faster; whether slipping helps is open"),
    ],
)
def test_full_force_is_the_fastest_of_all_only_where_nothing_can_break_the_contact(amplitude, said):
    """The contact holds for every control up to the time T of the transfer if U (2 - cos(Omega T)) <= b M/m2 = 1 N."""
    found = planned("0.0005", amplitude=amplitude)
    assert (found.road, found.fastest) == (Road.BANG_BANG, said)
    needed = float(amplitude) * (2 - math.cos(10 * float(found.time)))
    assert (needed <= 1) == said.startswith("no control within")


def test_a_transfer_under_a_margin_is_the_fastest_of_those_that_keep_it():
    found, kept = (planned("0.01", margin=one) for one in (0, "0.1"))
    assert found.time < kept.time
    assert found.fastest.startswith("no control is faster")
    assert kept.fastest.startswith("no control that keeps the margin is faster")
    within, below = (planned("0.001", amplitude="0.999", margin=one).fastest for one in (0, "0.1"))
    assert "at the limit needs 1.10000 N" in within
    assert "at the margin needs 1.00000 N" in below


@given(pairs(damped=None), decimals(-3, -1, 2), st.integers(1, 19))
@example(Pair("4.2", "1.1", 87, "0.9"), Fraction("0.079"), 2)
def test_no_force_of_a_transfer_exceeds_its_amplitude(pair, part, twentieths):
    """Running ahead, braking and holding; the distance is a part of that over which g turns, or friction holds."""
    far = part * min(pair.half_width, pair.b * pair.m1 / (pair.m2 * pair.a2) * 10)
    known = planned(far, pair)
    least = known.stuck_amplitude / 2 if known.least_amplitude is None else known.least_amplitude
    amplitude = rounded(least + (known.stuck_amplitude - least) * twentieths / 20, 6)
    found = planned(far, pair, amplitude=amplitude)
    if found.scene is not None:
        times = [piece.start for piece in found.scene.force.pieces] + [found.scene.until]
        for start, end in pairwise(times):
            sizes = [abs(found.scene.force(start + (end - start) * k / 40)) for k in range(40)]
            assert max(sizes) <= amplitude


def test_where_holding_needs_more_no_slip_is_given():
    """It takes more than a2 D = 6.873 N, as body 1 is ahead of body 2."""
    found = planned("0.079", Pair("4.2", "1.1", 87, "0.9"), amplitude="6.015")
    assert found.least_amplitude < 6.015 < found.stuck_amplitude
    assert found.road is Road.OPEN
    assert "whether both bodies can rest then is open" in found.fastest


@pytest.mark.parametrize(
    ("pair", "distance", "most"),
    [
        (Pair(1, 1, 1, "0.5", 40), 1200, 1599),  # at a late time; the start needs 1581 N, holding 1200 N
        (FREE, "0.05", 10),  # for holding; the start needs 6 N
        (DAMPED, "0.01", None),
    ],
)
def test_the_amplitude_of_a_stuck_transfer_is_the_largest_value_of_its_force(pair, distance, most):
    found = planned(distance, pair)
    until = found.scene.until
    largest = max(abs(float(found.scene.force(until * k / 5000))) for k in range(5000))
    assert float(found.stuck_amplitude) == pytest.approx(largest, rel=1e-3)
    assert most is None or float(found.stuck_amplitude) == pytest.approx(most)


@pytest.mark.parametrize(
    ("wrong", "named"),
    [
        ({"distance": 0}, "distance"),
        ({"distance": "x"}, "distance"),
        ({"distance": 1, "margin": 1}, "margin"),
        ({"distance": 1, "amplitude": 0}, "amplitude"),
    ],
)
def test_bad_transfers_are_refused(wrong, named):
    with pytest.raises(InvalidScene, match=named):
        planned(**wrong)
    with pytest.raises(InvalidScene, match="rest"):
        fastest_transfer(Scene(FREE, State(v1=1), 1), 1)
    with pytest.raises(InvalidScene, match="force"):
        fastest_transfer(Scene(FREE, State(), 1, force=Force.step(0, 1)), 1)


def test_a_margin_leaves_no_room_for_a_slip():
    """1.08 N are enough to meet the bound by slipping, which takes friction to its limit, and too little to stick."""
    assert planned("0.001", amplitude="1.08").road is Road.SLIP
    assert planned("0.001", amplitude="1.08", margin="0.01").road is Road.OPEN
