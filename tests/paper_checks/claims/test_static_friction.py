"""A finite slope of friction: what an excursion gains, against the engine."""

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
