"""What theory states and what numerics does, where both speak: thresholds and transfers."""

from fractions import Fraction

import pytest
import sympy as sp
from flint import acb, arb
from hypothesis import given
from strategies import MODERATE, decimals, pairs
from theory_values import of_pair

from numerics import Pair, Scene, State, cheapest_transfer, fastest_transfer
from numerics.arithmetic.precision import precision
from numerics.control.thresholds import thresholds
from theory import cheapest
from theory import forced_control as control
from theory import forced_response as response
from theory.symbols import a1, a2, b, m1, m2

HEAVY = Pair(m1="3/2", m2="2/3", a1="2/5", a2=7, b="1/3")
LIGHT = Pair(m1="0.4", m2=3, a2=50, b="0.7")
SLOWED = Pair(m1="0.9", m2="0.4", a1=40, a2=12, b="0.2")
"""Beyond critical damping."""
TAU, DECLINE = sp.sqrt(m2 * control.path / b), a1 / (2 * m1)
SWING = {
    response.decline: DECLINE,
    response.swing: sp.sqrt(a2 / m1 - DECLINE**2),
    response.decayed: sp.exp(-sp.pi * DECLINE / response.omega),
    response.natural: sp.sqrt(a2 / m1),
    control.half_time: TAU,
}
"""Of a body 1 that swings, and half the least time of a transfer."""


def value(expression, pair, **letters):
    """Theory's number for a pair, real."""
    found = of_pair(expression.subs(SWING), pair, **letters)
    return found.real if isinstance(found, acb) else arb(found)


def close(found, expected):
    """Say whether a ball is theory's number, to twelve digits; an exact 0 is 0."""
    return abs(found - expected) <= abs(expected) * 1e-12


@pytest.fixture(autouse=True)
def many_digits():
    with precision(200):
        yield


@given(pairs(damped=None), decimals(*MODERATE))
def test_the_stuck_response_breaks_at_the_same_amplitude(pair, omega):
    assert close(thresholds(pair, omega).entrainment, value(response.entrained_amplitude(), pair, omega=omega))


@pytest.mark.parametrize("pair", [HEAVY, LIGHT, SLOWED])
@pytest.mark.parametrize("omega", [Fraction(1, 3), Fraction(5, 2), Fraction(40)])
def test_permanent_slip_begins_at_the_same_amplitude(pair, omega):
    squared, at = response.undamped_non_stop_amplitude_squared(), {"omega": omega}
    if pair.a1:
        squared, (h, rate) = response.non_stop_amplitude_squared(), response.square_wave()
        at |= {"h": value(h, pair, **at), "h'": value(rate, pair, **at)}
    assert close(thresholds(pair, omega).non_stop, value(squared, pair, **at).sqrt())


@pytest.mark.parametrize("pair", [HEAVY, LIGHT])
@pytest.mark.parametrize("by", [Fraction(1, 100), Fraction(1, 3)])
def test_a_transfer_takes_theorys_time_and_amplitude(pair, by):
    found = fastest_transfer(Scene(pair, State(), until=1), by)
    assert close(found.bound, value(control.least_time(), pair, D=by))
    turn, hold, late = (value(one, pair, D=by) for one in control.stuck_amplitudes())
    inside = value(control.late_peak(), pair, D=by) >= 0
    assert close(found.stuck_amplitude, turn.max(hold).max(late if inside else hold))
    if found.least_amplitude is not None:
        g = value(control.impulse_response().subs(control.t, TAU), pair, D=by)
        assert close(found.least_amplitude, value(control.slipping_amplitude(), pair, D=by, g=g))


def test_a_weak_force_takes_the_time_of_both_arcs_and_the_least_energy_is_theorys():
    scene = Scene(Pair(m1=1, m2=2, a2=3, b=4), State(), until=1)
    arcs = sum(control.switching()).subs(control.reduced, sp.Rational(3, 5))
    assert close(fastest_transfer(scene, "0.2", amplitude=1).time, arb(str(arcs.evalf(30))))
    below = cheapest_transfer(scene, "0.2", 2)
    assert not below.is_at_limit
    assert close(below.cost, value(cheapest.undamped_energy(), scene.pair, D=Fraction(1, 5), theta=2))
    heavy = Pair(1, 1, 200, "0.5")
    far = value(cheapest.far_energy(), heavy, **{str(cheapest.beyond): Fraction("0.045")})
    assert 18.3 < far < cheapest_transfer(Scene(heavy, State(), until=1), "0.05", "1.2").cost < 1.1 * far
