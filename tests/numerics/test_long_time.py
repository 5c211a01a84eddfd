"""The energy at times that nobody could step to: against stepping, the sharp law, and the rim behind it."""

from fractions import Fraction
from itertools import pairwise

import pytest
from flint import acb, arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from numerics import Pair, Scene, State, load_scene, solve
from numerics.arithmetic.ball import Ball, digits_within
from numerics.free.abel import arcs
from numerics.free.energy import EnergyMethod, energy_at
from numerics.linear.modes import EventKind


@pytest.mark.parametrize(
    "name", ["start-at-6mm", "start-with-speed", "velocities", "itinerary-that-merges", "start-with-speed-literal"]
)
@pytest.mark.parametrize("until", [3, 50, 400])
def test_agrees_with_stepping(name, until):
    scene = load_scene(name)
    jumped = energy_at(scene, until, digits=30)
    stepped = solve(Scene(scene.pair, scene.initial, until=until, law=scene.law), digits=30, arithmetic="ball")
    with jumped.frame.arithmetic.context():
        assert jumped.energy_excess.overlaps(stepped.final.w)
        assert jumped.energy.overlaps(stepped.frame.energy(stepped.final))
    assert jumped.excursions == stepped.event_kinds.count(EventKind.EXIT)
    assert jumped.mode is stepped.modes[-1]


@given(
    share=st.fractions(Fraction(9, 20), Fraction(4, 5), max_denominator=50),
    exponent=st.integers(6, 100),
    speed=st.fractions(Fraction(1, 100), Fraction(1, 5), max_denominator=100),
)
def test_late_energy_follows_the_sharp_law(share, exponent, speed):
    """tau w is within 1 % of 4 pi q/(9 r) at late times, whatever the start on S0; the digits are those of w itself."""
    pair = Pair(m1=share, m2=1 - share, a2=1, b=1)
    start = pair.half_width * (1 + speed)
    scene = Scene(pair, State(v1=start, v2=start), until=1)
    found = energy_at(scene, Fraction(10) ** exponent, digits=15)
    with found.frame.arithmetic.context():
        assert found.road is EnergyMethod.ABEL
        tau = found.frame.rate * found.frame.arithmetic.number(Fraction(10) ** exponent)
        ratio = tau * found.energy_excess * 9 * found.frame.r / (4 * arb.pi() * found.frame.q)
        assert abs(ratio - 1) < arb(fmpq(1, 100))
        assert digits_within(found.energy_excess.rad(), found.energy_excess, arb(1)) >= found.digits


def test_viscous_scenes_and_merged_ones_take_the_short_road():
    pair = Pair(m1=1, m2=1, a1=5, a2=200, b="0.05")
    found = energy_at(Scene(pair, State(v1="0.15"), until=1), 100, digits=20)
    assert found.road is EnergyMethod.NO_MORE_SLIP
    with found.frame.arithmetic.context():
        assert digits_within(found.energy_excess.rad(), found.energy_excess, arb(1)) >= 20
    assert energy_at(load_scene("itinerary-that-merges"), "1e100").road is EnergyMethod.NO_MORE_SLIP
    damped = Scene(Pair(1, 1, 200, "0.5", "0.01"), State(v1="0.15"), until=3)
    exits = sum(one.kind is EventKind.EXIT for one in solve(damped).events)
    assert energy_at(damped, 3).excursions == exits > 0


def test_command_line(run, output, record):
    asked = ("energy", "start-with-speed", "--at")
    found = record(*asked, "1e100", "--digits", 20)
    assert found["energy_excess"].startswith("1.396263401595463661")
    assert len(found["excursions"]) == 101
    assert float(found["x1_radius"]) < 1e-20
    assert found["v1"] == found["v2"]  # it sticks then
    assert "Abel functions" in output(*asked, "1e4", "--explain")
    code, _, err = run(*asked, "inf")
    assert (code, err.count("\n")) == (2, 1)


def test_the_rim_is_covered_without_gaps():
    """Schwarz's lemma needs the whole rim: the boxes overlap in turn, and the first and last meet the real axis."""
    with Ball(20).context():
        boxes = list(arcs(Fraction(6, 5)))
        assert boxes[0].imag.contains(0)
        assert boxes[-1].imag.contains(0)
        assert all(one.overlaps(two) for one, two in pairwise(boxes))
        rim = arb(fmpq(6, 5))
        for k in range(0, 3000, 7):  # points of the rim lie in a box
            angle = arb.pi() * k / 3000
            assert any(box.contains(acb((rim * angle.cos()).mid(), (rim * angle.sin()).mid())) for box in boxes)
