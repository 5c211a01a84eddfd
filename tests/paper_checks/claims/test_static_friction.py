"""A finite slope of friction beside what is next to it: another coefficient, and a jump."""

import math
from fractions import Fraction

import pytest
from sympy import Rational

from numerics import Friction, Pair, Scene, State, Weakening, solve
from theory import finite_slope
from theory.symbols import epsilon, q

HALF = Fraction(1, 2)


@pytest.mark.parametrize(
    ("share", "fall"), [(HALF, 0), (HALF, 5), (HALF, -5), (Fraction(1, 5), 1), (Fraction(4, 5), 5)]
)
def test_an_excursion_gains_what_the_slope_adds(share, fall):
    """What 1/w gains in an excursion with w = 1e-8, in balls: another coefficient of the slope would be off by more."""
    speed = Fraction(1, 10**4)
    friction = Friction((), Weakening(last_slope=-fall * (1 - share)))
    scene = Scene(Pair(share, 1 - share, 1, 1 - share), State(1, speed, 0, speed), "0.01", friction=friction)
    run = solve(scene, digits=45, arithmetic="ball")
    with run.arithmetic.context():
        end = run.sol(scene.until)
        gained = float(1 / (end[0] ** 2 + end[1] ** 2 - 1) - 10**8) * float(4 * share / (9 * (1 - share)))
    terms = finite_slope.gain().subs({finite_slope.slope: fall, q: Rational(share), epsilon: Rational(speed)})
    assert gained == pytest.approx(float(terms), abs=1e-5)


def test_a_slope_of_five_goes_on_where_a_jump_of_a_hundredth_ends_it():
    start = State(1, "0.05", 0, "0.05")
    falling = Friction((), Weakening(speed=[("0.1", "0.25")]))
    slope = solve(Scene(Pair(HALF, HALF, 1, HALF), start, 100, friction=falling))
    jump = solve(Scene(Pair(HALF, HALF, 1, "0.495", b_static=HALF), start, 100))
    assert (slope.message, len(slope.events) > 50) == ("reached the horizon", True)
    assert jump.message == "reached the horizon; the pair sticks permanently"


@pytest.mark.parametrize("k", [-2, 1])
def test_the_sum_of_the_gains_has_the_approach(k):
    """Its leading terms alone, iterated a million times."""
    inverse, count, share = 1e6, 10**6, 0.5
    for _ in range(count):
        inverse += 9 / 4 * (1 + 6 * k / (5 * share) / math.sqrt(inverse))
    gone = inverse - 1e6
    limit = 4 * math.pi / 9
    stated = float(finite_slope.approach().subs({finite_slope.slope: k, q: HALF}).evalf())
    # from 1/w = 1e6 on: the sum begins at sqrt(1e6)
    expected = -stated / math.sqrt(limit) * (math.sqrt(inverse) - 1e3)
    assert gone - 9 / 4 * count == pytest.approx(expected, rel=1e-2)
