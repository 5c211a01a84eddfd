"""Faults of one token that the other tests let pass when they were planted: each test here sees one of them."""

from fractions import Fraction
from types import FunctionType

import pytest

from numerics.arithmetic.float64 import FLOAT64, Float64
from numerics.contact import damped
from numerics.errors import OutOfRange
from numerics.run.one import run_scene
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve

UNEVEN = {"m1": 3, "m2": Fraction(1, 2), "a2": 40, "b": Fraction(1, 5)}  # q and r far from each other


@pytest.mark.parametrize("a1", ["0", "0.3", "21.9", "60"])
def test_the_energy_ledger_closes_for_uneven_masses(a1):
    scene = Scene(Pair(a1=a1, **UNEVEN), State(x1="0.3", v1="-0.2", v2="0.4"), until=8)
    floats, balls = solve(scene).ledger, solve(scene, digits=20, arithmetic="ball").ledger
    assert abs(floats.residual) < 1e-12 * floats.initial
    assert balls.residual.contains(0)
    assert balls.residual.rad() < 1e-15
    assert floats.friction > 0
    assert (floats.viscous > 0) == (a1 != "0")
    for one, two in ((floats.friction, balls.friction), (floats.viscous, balls.viscous)):
        assert abs(one - float(two.mid())) <= 1e-12 * floats.initial


def test_a_slip_of_too_many_pieces_is_refused():
    """m1 = m2, Omega = L = 1: body 2 starts at 20 L Omega, a handful of half oscillations before the contact."""
    scene = Scene(Pair(m1=1, m2=1, a1="0.01", a2=2, b=1), State(x1="0.5", v2=-20), until=30)
    assert solve(scene).events
    text = damped.first_fall
    fewer = FunctionType(text.__code__, {**text.__globals__, "MAX_PIECES": 3}, "first_fall")
    impatient = Float64()
    impatient.telling = FLOAT64.but("impatient", {text: fewer})
    with pytest.raises(OutOfRange, match="half oscillations"):
        run_scene(scene, impatient)


def test_a_slip_of_more_oscillations_than_may_be_inspected_is_solved():
    """Ten million half periods: all but the last few are certain to have no contact, and are skipped."""
    scene = Scene(Pair(m1=1, m2=1, a1="0.01", a2=2, b=1), State(x1="0.5", v2=-(10**7)), until=2 * 10**7)
    floats, balls = solve(scene, max_events=1), solve(scene, digits=20, arithmetic="ball", max_events=1)
    assert len(floats.events) == 1
    assert abs(floats.events[0].t - float(balls.events[0].t.mid())) < 1e-9 * floats.events[0].t


@pytest.mark.parametrize("digits", [50, 300])
def test_numbers_that_are_exact_have_as_many_digits_as_are_asked_for(digits):
    at_rest = Scene(Pair(**UNEVEN), State(), until=1)
    assert solve(at_rest, digits=digits, arithmetic="ball").digits >= digits
