"""What theory states under a force and what numerics does: thresholds, two stops, references, transfers."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given
from strategies import MODERATE, decimals, pairs

from numerics import Pair, Scene, State, solve
from numerics.control.thresholds import thresholds
from numerics.control.tracking import track
from numerics.linear.modes import Mode
from numerics.scene import Force, Piece
from theory import forced
from theory import forced_control as control
from theory import forced_response as response
from theory.symbols import a1, a2, b, m1, m2

HEAVY = Pair(m1="3/2", m2="2/3", a1="2/5", a2=7, b="1/3")
LIGHT = Pair(m1="0.4", m2=3, a2=50, b="0.7")


def letters(pair, omega=None):
    """Return what theory's letters are for a pair, exactly."""
    values = {m1: pair.m1, m2: pair.m2, a1: pair.a1, a2: pair.a2, b: pair.b}
    values |= {response.omega: omega} if omega is not None else {}
    return {one: sp.Rational(value.numerator, value.denominator) for one, value in values.items()}


def close(found, expected, digits=12):
    """Say whether a ball is next to theory's number, to many digits; an exact 0 is 0."""
    value = sp.N(expected, 30)
    return abs(sp.Float(found.str(25, radius=False), 30) - value) <= abs(value) * 10**-digits


@given(pairs(damped=None), decimals(*MODERATE))
def test_the_stuck_response_breaks_at_the_same_amplitude(pair, omega):
    expected = response.entrained_amplitude().subs(letters(pair, omega))
    assert close(thresholds(pair, omega).entrainment, expected)


def test_the_force_of_a_reference_is_that_of_the_stuck_pair():
    found = track(Scene(HEAVY, State(v1=1, v2=1), until=2), (Piece(0, (0, 1, "1/10")),))
    assert found.scene is not None
    at = {control.r_place: 1 + sp.Rational(1, 10), control.r_speed: 1 + sp.Rational(2, 10)}
    at |= {control.r_acceleration: sp.Rational(2, 10)}
    expected = control.stuck_force().subs(at).subs(letters(HEAVY))
    assert found.scene.force(Fraction(1)) == Fraction(int(expected.p), int(expected.q))


TIES = [(1, 1), (1, -1), (2, 1), (2, -1), (3, 1), (3, -1), (4, 1), (4, -1)]


@pytest.mark.parametrize("pair", [HEAVY, LIGHT])
@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("order", "side"), TIES)
def test_a_tie_is_decided_by_the_derivative_that_theory_names(pair, sign, order, side):
    """The force is made so that p and its derivatives below an order vanish at the start, and that one has a side."""
    velocity, values = sp.Rational(3, 7), letters(pair) | {forced.x1: 0, forced.v1: sp.Rational(3, 7)}
    needed = sp.solve((forced.load() - sign * b).subs(values), forced.u)[0]
    coefficients = [needed]
    for k in range(1, 5):
        excess = forced.tie_derivative(sign, k).subs(values)
        wanted = sp.Rational(side, 5) if k == order else 0
        rate = sp.solve(excess - wanted, forced.U_RATES[k - 1])[0]
        coefficients.append(rate / sp.factorial(k))
    force = Force((Piece(0, tuple(Fraction(int(one.p), int(one.q)) for one in coefficients)),))
    at = Fraction(int(velocity.p), int(velocity.q))
    run = solve(Scene(pair, State(v1=at, v2=at), until="0.01", force=force), digits=20, arithmetic="ball")
    slipping = {1: Mode.SLIP_PLUS, -1: Mode.SLIP_MINUS}[sign]
    assert run.modes[0] is (slipping if sign * side > 0 else Mode.STICK)
