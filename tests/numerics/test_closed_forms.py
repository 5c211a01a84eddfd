"""The Abel functions and the contact of the free pair, and the energy at late times: error bounds against the truth."""

from fractions import Fraction
from functools import cache
from itertools import islice, pairwise

import mpmath
import pytest
from flint import acb, arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st
from strategies import decimals
from three_scenes import PAPER

from numerics import EventUndecided, Pair, load_scene, solve
from numerics.arithmetic.ball import Ball, digits_within
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.free.abel import AbelFunctions, arcs
from numerics.free.contact import contact
from numerics.free.energy import EnergyMethod, energy_at
from numerics.free.frame import Frame
from numerics.free.motion import excursions
from numerics.linear.modes import EventKind

FAR = 400
"""Excursions after which a function of any order is known to many more digits than at the start."""
in_200_digits = cache(AbelFunctions)
"""The functions of a share and an order, made in the precision of the one test that uses them."""


@pytest.mark.parametrize("share", [Fraction(1, 5), Fraction(1, 2), Fraction(9, 10)])
@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize("part", [Fraction(999, 1000), Fraction(1, 100), Fraction(1, 10**12)])
def test_low_orders_enclose_the_truth(share, order, part):
    """From the rim of what is certified far inwards, where a bound with a zero of too high an order is too small.

    The truth is that of order 24 after many excursions: alpha(y) = alpha(y_n) - n, beta(y) = beta(y_n) - time, and
    slide(y) = (y - y_1) - (y_1 - y_2) + ... + slide(y_n), n being even.
    """
    arithmetic = Ball(200)
    with arithmetic.context():
        functions, exact = in_200_digits(share, order), in_200_digits(share, 24)
        y = arithmetic.number(functions.largest_argument * part)
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        time, after, slid, side = arb(0), frame.q * y, arb(0), 1
        for one in islice(excursions(frame, after), FAR):
            time, after, slid = time + one.slip + one.stick, one.w_after, slid + side * (one.w - one.w_after) / frame.q
            side = -side
        last = after / frame.q
        alpha, beta = exact.alpha(last) - FAR, exact.beta(last) - time
        found = functions.alpha(y), functions.beta(y)
        assert found[0].contains(alpha.mid())
        assert found[1].contains(beta.mid())
        assert functions.slide(y).contains((slid + exact.slide(last)).mid())
        # beta's part beyond pi alpha has a bound of its own
        epsilon, half = (frame.q * y).sqrt(), arb(0)
        for coefficient in reversed(functions.beta_coefficients):
            half = (half + arb(coefficient)) * epsilon
        missed = abs(half - (beta - arb.pi() * alpha)).mid()
        assert missed <= found[1].rad() - arb.pi() * found[0].rad() * (1 - arb(10) ** -8) + found[0].rad() * 1e-6


hundredths = st.integers(1, 300).map(lambda n: n / 100)
widths = st.sampled_from([0, 1e-3, 0.02, 0.1, 0.3])


@given(hundredths, hundredths, widths, widths, st.floats(0, 1), st.floats(0, 1))
@example(1.0, 1.0, 1e-3, 1e-3, 0.0, 1.0)
@example(0.0, 1.35, 0.02, 0.3, 1.0, 0.0)  # next to a full turn all that a slip is made of changes much
def test_every_slip_of_a_ball_is_enclosed_or_none_is(gap, push, wider, faster, part, share):
    inside = arb(gap) + part * wider, arb(push) + share * faster
    with Ball(16).context():
        try:
            found = contact(*(arb(low).union(arb(low + by)) for low, by in ((gap, wider), (push, faster))))
        except EventUndecided:
            assert max(wider, faster) > 1e-3
            return
    with Ball(40).context():
        assert all(one.overlaps(two) for one, two in zip(found, contact(*inside), strict=True))


@given(decimals(-40, 40), decimals(-40, 40) | decimals(-3, 1), st.booleans(), st.booleans())
@example(Fraction(1), Fraction(6), True, False)  # beyond half a turn, where 1 - cos falls
def test_a_contact_in_mpmath_is_that_of_balls(gap, push, on_ray, back):
    d, u = (0 if on_ray else gap), (-push if back and not on_ray else push)
    balls, points = Ball(300), Multiprecision(60)
    with balls.context():
        theta, deep, _ = contact(balls.number(d), balls.number(u))
        assert min(theta.rel_accuracy_bits(), deep.rel_accuracy_bits()) > 980
    with points.context():
        ours = contact(points.number(d), points.number(u))
    with Ball(90).context():
        for one, two in zip((theta, deep), ours, strict=False):
            assert abs(one / arb(mpmath.nstr(two, 70)) - 1) < 1e-58


# the energy at times that nobody could step to; what it is there, against stepping and the 1/t law: properties/


def test_viscous_scenes_take_the_short_road():
    found = energy_at(PAPER.replace(a1=5, b="0.05"), 100, digits=20)
    assert found.road is EnergyMethod.NO_MORE_SLIP
    with found.frame.arithmetic.context():
        assert digits_within(found.energy_excess.rad(), found.energy_excess, arb(1)) >= 20
    damped = PAPER.replace(a1="0.01")
    exits = sum(one.kind is EventKind.EXIT for one in solve(damped).events)
    assert energy_at(damped, 3).excursions == exits > 0


@pytest.mark.parametrize("name", ["forced-step", "forced-friction-by-pieces"])
def test_under_a_force_or_friction_by_steps_it_is_that_of_the_run(name):
    scene = load_scene(name).replace(until=3)
    found, run = energy_at(scene.replace(until=1), 3), solve(scene, digits=15)
    assert found.energy.overlaps(run.final_energy)
    assert found.energy_excess.overlaps(run.energy_excess[-1])
    assert (found.stepped, found.mode) == (len(run.events), run.final_mode)


def test_the_energy_at_a_late_time_as_a_command(output, record):
    asked = ("energy", "start-with-speed", "--at")
    found = record(*asked, "1e100", "--digits", 20)
    assert found["energy_excess"].startswith("1.396263401595463661")
    assert len(found["excursions"]) == 101
    assert float(found["x1_radius"]) < 1e-20
    assert found["v1"] == found["v2"]  # it sticks then
    assert "Abel functions" in output(*asked, "1e4", "--explain")


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
