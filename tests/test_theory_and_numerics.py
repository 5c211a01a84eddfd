"""What theory states and what numerics does, where both speak: contact, landing, return map, damping, first mode."""

from fractions import Fraction

import pytest
import sympy as sp
from flint import arb

from numerics import Mode, Pair, Scene, State, solve
from theory.filippov import transversality
from theory.return_map import contact_condition, gap, landing, push
from theory.symbols import a2, b, m1, m2, q, theta, x1

# L = Omega = M = 1 and a root that is rational: sqrt(q) = 1/2.
QUARTER = Pair(m1="0.25", m2="0.75", a2=1, b="0.75")
BALLS = [{"sin": arb.sin, "cos": arb.cos, "cot": arb.cot, "sqrt": arb.sqrt}]


def in_balls(expression, *symbols):
    """Return theory's expression for q = 1/4 as a function of balls."""
    return sp.lambdify(symbols, expression.subs(q, sp.Rational(1, 4)), BALLS)


@pytest.mark.parametrize("start", [(0, 1), (0, 4), ("1/2", "1/3"), (3, -1), ("1/100", 2), (8, 0)])
def test_a_slip_from_the_surface_ends_where_the_contact_equation_says(start):
    d, u = (Fraction(one) for one in start)
    scene = Scene(QUARTER, State(x1=1 + d / 4, v1=u / 2, v2=u / 2), until=50)
    run = solve(scene, digits=25, arithmetic="ball", max_events=3)
    assert run.modes[0] is Mode.SLIP_MINUS
    event = run.events[0]
    with run.arithmetic.context():
        angle, at = 2 * event.t, (arb(d.numerator) / d.denominator, arb(u.numerator) / u.denominator)
        assert in_balls(contact_condition(), theta, gap, push)(angle, *at).contains(0)
        ends = landing()
        place, speed = (in_balls(one, theta, gap, push)(angle, *at) for one in (ends.gap, ends.push))
        assert (1 + place / 4).overlaps(event.reduced.X)
        assert (speed / 2).overlaps(event.reduced.V1)
        before = 2 * d / 4 + d * d / 16 + u * u / 4
        lost = in_balls(ends.excess_change, theta, gap, push)(angle, *at)
        assert (arb(before.numerator) / before.denominator + lost).overlaps(event.reduced.w)


@pytest.mark.parametrize("place", ["-2", "-1.0001", "-0.9999", "0", "0.9999", "1.0001", "3"])
def test_the_first_mode_is_that_of_the_signs_of_both_products(place):
    values = {m1: sp.Rational(1, 4), m2: sp.Rational(3, 4), a2: 1, b: sp.Rational(3, 4), x1: sp.Rational(place)}
    signs = {sign: sp.sign(transversality(sign).subs(values)) for sign in (1, -1)}
    expected = {(-1, -1): Mode.SLIP_MINUS, (1, 1): Mode.SLIP_PLUS, (-1, 1): Mode.STICK}[(signs[1], signs[-1])]
    run = solve(Scene(QUARTER, State(x1=place, v1="0.1", v2="0.1"), until=1))
    assert run.modes[0] is expected
