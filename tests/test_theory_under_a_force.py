"""What theory states under a force and what numerics does: thresholds, two stops, references, transfers."""

import math
from fractions import Fraction

import pytest
import sympy as sp
from flint import acb, arb, fmpq
from hypothesis import given
from strategies import MODERATE, decimals, pairs
from theory_values import exact, of_pair

from numerics import Force, Mode, Pair, Piece, Scene, State, cheapest_transfer, fastest_transfer, solve, track
from numerics.arithmetic.precision import precision
from numerics.control.response import response as forced_response_of
from numerics.control.thresholds import square_wave_response, thresholds
from theory import cheapest, forced
from theory import forced_control as control
from theory import forced_response as response
from theory.symbols import a1, a2, b, m1, m2

HEAVY = Pair(m1="3/2", m2="2/3", a1="2/5", a2=7, b="1/3")
LIGHT = Pair(m1="0.4", m2=3, a2=50, b="0.7")
SLOWED = Pair(m1="0.9", m2="0.4", a1=40, a2=12, b="0.2")
"""Beyond critical damping."""
TAU = sp.sqrt(m2 * control.path / b)
DECLINE = a1 / (2 * m1)
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
        squared, parts = (
            response.non_stop_amplitude_squared(),
            [value(one, pair, **at) for one in response.square_wave()],
        )
        at |= dict(zip(("h", "h'"), parts, strict=True))
        assert all(map(close, square_wave_response(pair, arb(exact(omega))), parts))
    assert close(thresholds(pair, omega).non_stop, value(squared, pair, **at).sqrt())


def test_at_resonance_both_have_four_b_over_pi():
    pair = Pair(m1=2, m2=3, a2=18, b="0.7")
    assert close(thresholds(pair, 3).non_stop, value(response.resonant_amplitude(), pair))
    assert response.resonant_amplitude() == response.resonant_non_stop_amplitude()


@pytest.mark.parametrize("part", [Fraction(1, 50), Fraction(1, 2), Fraction(49, 50)])
def test_the_two_stop_motion_meets_theorys_conditions(part):
    """At the exit to slip +, under forces from next to U* to next to U**."""
    omega = Fraction(5, 2)
    low, high = (
        Fraction(float(one)) for one in (thresholds(HEAVY, omega).entrainment, thresholds(HEAVY, omega).non_stop)
    )
    force = Force.sine(low + part * (high - low), omega)
    found = forced_response_of(Scene(HEAVY, State(), 1, force=force), digits=20)
    exit_, *others = found.orbit.legs
    assert [exit_.side, *(one.side for one in others)] == [1, 0, -1, 0]
    cosine = force(Fraction(float(exit_.start)))
    letters = {"x_0": exit_.state[0], "v_0": exit_.state[1], "C": arb(cosine), "omega": omega}
    assert abs(value(response.two_stop_conditions()[0], HEAVY, **letters)) < 1e-12


@pytest.mark.parametrize("pair", [HEAVY, LIGHT])
@pytest.mark.parametrize("by", [Fraction(1, 100), Fraction(1, 3)])
def test_a_transfer_takes_theorys_time_and_amplitude(pair, by):
    found = fastest_transfer(Scene(pair, State(), until=1), by)
    assert close(found.bound, value(control.least_time(), pair, D=by))
    turn, hold, late = (value(one, pair, D=by) for one in control.stuck_amplitudes())
    inside = value(control.late_peak(), pair, D=by) >= 0
    assert close(found.stuck_amplitude, turn.max(hold).max(late if inside else hold))
    pulse = control.impulse_response()
    g, slope = (value(one.subs(control.t, TAU), pair, D=by) for one in (pulse, sp.diff(pulse, control.t)))
    if found.least_amplitude is not None:
        assert slope > 0
        assert close(found.least_amplitude, value(control.slipping_amplitude(), pair, D=by, g=g))


def test_a_weak_force_takes_the_time_of_both_arcs():
    pair = Pair(m1=1, m2=2, a2=3, b=4)
    found = fastest_transfer(Scene(pair, State(), until=1), "0.2", amplitude=1)
    arcs = sum(control.switching()).subs(control.reduced, sp.Rational(3, 5))
    assert close(found.time, arb(str(arcs.evalf(30))))


def test_the_least_energy_is_theorys_below_the_limit_and_above_its_bounds_beyond():
    pair, heavy = Pair(1, 2, 3, 4), Pair(1, 1, 200, "0.5")
    below = cheapest_transfer(Scene(pair, State(), until=1), "0.2", 2)
    assert not below.is_at_limit
    assert close(below.cost, value(cheapest.undamped_energy(), pair, D=Fraction(1, 5), theta=2))
    far = cheapest_transfer(Scene(heavy, State(), until=1), "0.05", "1.2").cost
    assert 18.3 < far_energy(heavy, Fraction("0.045")) < far < 1.1 * far_energy(heavy, Fraction("0.045"))


def far_energy(pair, beyond):
    """A bound of the energy of stuck transfers by so much more than the half width."""
    return value(cheapest.far_energy(), pair, **{str(cheapest.beyond): beyond})


def test_hops_are_cheaper_than_every_stuck_transfer_over_five_centimetres():
    """The pair moves forward stuck, then body 1 goes back, slipping; all is as before but for x2."""
    pair, far, go, back = Pair(1, 1, 200, "0.5"), Fraction("0.004"), Fraction("0.25"), Fraction("0.07")
    gain = pair.b / pair.m2
    met = back * (1 - gain * back**2 / (6 * far))  # from then on body 1 is the slower one
    ways = [(0, (0, 0, 3 * far / go**2, -2 * far / go**3)), (go, (far, 0, -3 * far / back**2, 2 * far / back**3))]
    force = pair.a2 * Force((*(Piece(*one) for one in ways), Piece(go + back, (0,))))
    bends = [Piece(start, (2 * way[2], 6 * way[3])) for start, way in ways]
    force += pair.mass * Force((bends[0], Piece(go, (0,)))) + pair.m1 * Force((bends[1], Piece(go + back, (0,))))
    force += Force((Piece(go, (-pair.b,)), Piece(go + met, (pair.b,)), Piece(go + 2 * met, (0,))))
    solved = solve(Scene(pair, State(), until=1, force=force), digits=15, arithmetic="ball")
    hop = far - gain * met**2
    assert [mode.value for mode in solved.modes] == ["stick", "slip-", "slip+", "stick"]
    assert all(abs(float(one) - float(to)) < 1e-18 for one, to in zip(solved.final_state, (0, 0, hop, 0), strict=True))
    energy = sum(float(force(Fraction(2 * k + 1, 8000))) ** 2 for k in range(4000)) / 4000
    assert 0.05 < 25 * hop < 0.051
    assert 25 * energy < 0.8 * far_energy(pair, 25 * hop - pair.half_width)


def test_the_force_of_a_reference_is_that_of_the_stuck_pair():
    found = track(Scene(HEAVY, State(v1=1, v2=1), until=2), (Piece(0, (0, 1, "1/10")),))
    assert found.scene is not None
    at = {"r": Fraction(11, 10), r"\dot{r}": Fraction(12, 10), r"\ddot{r}": Fraction(2, 10)}
    assert exact(found.scene.force(Fraction(1))) == of_pair(control.stuck_force(), HEAVY, **at)


TIES = [(1, 1), (1, -1), (2, 1), (2, -1), (3, 1), (3, -1), (4, 1), (4, -1)]


@pytest.mark.parametrize("pair", [HEAVY, LIGHT])
@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("order", "side"), TIES)
def test_a_tie_is_decided_by_the_derivative_that_theory_names(pair, sign, order, side):
    """The force is made so that p and its derivatives below an order vanish at the start, and that one has a side."""
    at, coefficients = Fraction(3, 7), []
    known = {"x1": Fraction(0), "v1": at}
    for k in range(5):
        # linear in each derivative of u
        excess = forced.tie_derivative(sign, k) if k else forced.load() - sign * b
        letter = str(forced.U_RATES[k - 1] if k else forced.u)
        off = of_pair(excess, pair, **known, **{letter: Fraction(0)})
        slope = of_pair(excess, pair, **known, **{letter: Fraction(1)}) - off
        known[letter] = (fmpq(side * (k == order), 5) - off) / slope
        coefficients.append(known[letter] / math.factorial(k))
    force = Force((Piece(0, tuple(Fraction(int(one.p), int(one.q)) for one in coefficients)),))
    run = solve(Scene(pair, State(v1=at, v2=at), until="0.01", force=force), digits=20, arithmetic="ball")
    slipping = {1: Mode.SLIP_PLUS, -1: Mode.SLIP_MINUS}[sign]
    assert run.modes[0] is (slipping if sign * side > 0 else Mode.STICK)
