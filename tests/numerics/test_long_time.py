"""The energy at times that nobody could step to: which way it is found, as a command, and the rim behind it.

What it is at late times, against stepping and the 1/t law: properties/."""

from fractions import Fraction
from itertools import pairwise

from flint import acb, arb, fmpq

from numerics import Pair, Scene, State, load_scene, solve
from numerics.arithmetic.ball import Ball, digits_within
from numerics.free.abel import arcs
from numerics.free.energy import EnergyMethod, energy_at
from numerics.linear.modes import EventKind


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
