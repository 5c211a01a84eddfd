"""What theory states under a force and what numerics does: thresholds, two stops, references, transfers."""

from fractions import Fraction

import pytest
import sympy as sp
from flint import arb
from hypothesis import given
from strategies import MODERATE, decimals, pairs

from numerics import Force, Mode, Pair, Piece, Scene, State, cheapest_transfer, fastest_transfer, solve, track
from numerics.arithmetic.ball import Ball
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


def letters(pair, omega=None):
    """Return what theory's letters are for a pair, exactly."""
    values = {m1: pair.m1, m2: pair.m2, a1: pair.a1, a2: pair.a2, b: pair.b}
    values |= {response.omega: omega} if omega is not None else {}
    return {one: sp.Rational(value.numerator, value.denominator) for one, value in values.items()}


def close(found, expected, digits=12):
    """Say whether a ball is next to theory's number, to many digits; an exact 0 is 0."""
    value = sp.N(expected, 30)
    return abs(sp.Float(found.str(25, radius=False), 30) - value) <= abs(value) * 10**-digits


def swing_letters(pair, omega):
    """Return decay, frequency and what half a period leaves, for a pair whose body 1 swings."""
    values = letters(pair)
    lam = values[a1] / (2 * values[m1])
    nu = sp.sqrt(values[a2] / values[m1] - lam**2)
    left = sp.exp(-sp.pi * lam / sp.Rational(str(omega)))
    return {response.decline: lam, response.swing: nu, response.decayed: left}


@given(pairs(damped=None), decimals(*MODERATE))
def test_the_stuck_response_breaks_at_the_same_amplitude(pair, omega):
    expected = response.entrained_amplitude().subs(letters(pair, omega))
    assert close(thresholds(pair, omega).entrainment, expected)


@pytest.mark.parametrize("pair", [HEAVY, LIGHT, SLOWED])
@pytest.mark.parametrize("omega", [Fraction(1, 3), Fraction(5, 2), Fraction(40)])
def test_permanent_slip_begins_at_the_same_amplitude(pair, omega):
    values = letters(pair, omega)
    if pair.a1:
        # the letters of the swing are put in together: a1 is one of them
        place, speed = (one.subs(swing_letters(pair, omega)).subs(values) for one in response.square_wave())
        known = {response.square_place: place, response.square_speed: speed}
        squared = response.non_stop_amplitude_squared().subs(known).subs(values)
        with Ball(30).context():
            found = square_wave_response(pair, arb(omega.numerator) / omega.denominator)
        assert close(found[0], place)
        assert close(found[1], speed)
    else:
        natural = sp.sqrt(values[a2] / values[m1])
        squared = response.undamped_non_stop_amplitude_squared().subs({response.natural: natural}).subs(values)
    assert close(thresholds(pair, omega).non_stop, sp.sqrt(squared))


def test_at_resonance_both_have_four_b_over_pi():
    pair = Pair(m1=2, m2=3, a2=18, b="0.7")
    found = thresholds(pair, 3).non_stop
    assert close(found, response.resonant_amplitude().subs(b, sp.Rational(7, 10)))
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
    x1, v1, *_ = exit_.state
    at = {response.exit_place: x1, response.exit_speed: v1, response.cosine_part: cosine}
    terms = sp.lambdify(list(at), response.two_stop_conditions()[0].subs(letters(HEAVY, omega)))
    assert abs(float(terms(*(float(one) for one in at.values())))) < 1e-12


@pytest.mark.parametrize("pair", [HEAVY, LIGHT])
@pytest.mark.parametrize("by", [Fraction(1, 100), Fraction(1, 3)])
def test_a_transfer_takes_theorys_time_and_amplitude(pair, by):
    found = fastest_transfer(Scene(pair, State(), until=1), by)
    values = letters(pair) | {control.path: sp.Rational(str(by))}
    assert close(found.bound, control.least_time().subs(values))
    turn, hold, late = (one.subs(values) for one in control.stuck_amplitudes())
    inside = control.late_peak().subs(values) >= 0
    assert close(found.stuck_amplitude, max([turn, hold, *([late] if inside else [])], key=sp.N))
    tau = sp.sqrt(values[m2] * values[control.path] / values[b])
    swing = swing_letters(pair, 1)
    g = control.impulse_response().subs(control.t, tau).subs(swing).subs(values)
    slope = sp.diff(control.impulse_response(), control.t).subs(control.t, tau).subs(swing).subs(values)
    if found.least_amplitude is not None:
        assert sp.N(slope) > 0
        known = {sp.Symbol("g", positive=True): g, control.half_time: tau}
        assert close(found.least_amplitude, control.slipping_amplitude().subs(known).subs(values))


def test_a_weak_force_takes_the_time_of_both_arcs():
    pair = Pair(m1=1, m2=2, a2=3, b=4)
    found = fastest_transfer(Scene(pair, State(), until=1), "0.2", amplitude=1)
    first, second = (one.subs(control.reduced, sp.Rational(3, 5)) for one in control.switching())
    assert close(found.time, (first + second) / sp.sqrt(1))


def test_the_least_energy_is_theorys_below_the_limit_and_above_its_bounds_beyond():
    below = cheapest_transfer(Scene(Pair(1, 2, 3, 4), State(), until=1), "0.2", 2)
    values = letters(Pair(1, 2, 3, 4)) | {control.path: sp.Rational(1, 5), control.angle: 2}
    assert not below.is_at_limit
    assert close(below.cost, cheapest.undamped_energy().subs(values))
    far = cheapest_transfer(Scene(Pair(1, 1, 200, "0.5"), State(), until=1), "0.05", "1.2").cost
    stuck = cheapest.far_energy().subs(letters(Pair(1, 1, 200, "0.5")) | {cheapest.beyond: sp.Rational("0.045")})
    assert 18.3 < sp.N(stuck) < float(far) < 1.1 * sp.N(stuck)


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
    beyond = sp.Rational(str(25 * hop - pair.half_width))
    assert 0.05 < 25 * hop < 0.051
    assert 25 * energy < 0.8 * sp.N(cheapest.far_energy().subs(letters(pair) | {cheapest.beyond: beyond}))


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
