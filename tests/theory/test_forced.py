"""The pair under a force: the mode rule's derivatives, thresholds and transfers against independent numbers."""

import cmath
import math

import pytest
import sympy as sp

from theory import forced, forced_control, forced_response
from theory.forced_response import decayed, decline, natural, omega, square_place, square_speed, swing
from theory.symbols import a1, a2, b, m1, m2, t, total_mass, u, v1, x1

PAIR = {m1: sp.Rational(3, 2), m2: sp.Rational(2, 3), a1: sp.Rational(2, 5), a2: 7, b: sp.Rational(1, 3)}
RATE = sp.Rational(5, 2)


@pytest.mark.parametrize("sign", [1, -1])
def test_at_a_tie_slip_and_stick_part_by_the_first_derivative_only(sign, same):
    # x1 chosen so that the load is sign b, and its rate zero: the second derivative of both loads is (m2/M) p''
    for mode in ("stick", "slip+" if sign > 0 else "slip-"):
        assert same(forced.deviation_force(mode, sign), forced.imbalance(sign))
    assert same(forced.imbalance(sign).subs(t, 0), total_mass() / m2 * (forced.load() - sign * b))


def test_the_load_is_what_holds_body_2():
    field = forced.forced_system(forced.load() / b)
    assert sp.simplify((field[1] - field[2]).subs(sp.Symbol("v2", real=True), v1)) == 0


def test_the_stuck_response_needs_all_friction_at_the_first_threshold():
    values = PAIR | {omega: RATE}
    place = complex(forced_response.stuck_impedance().subs(values))
    found = float(forced_response.entrained_amplitude().subs(values))
    assert math.isclose(float(PAIR[m2]) * 2.5**2 * found / abs(place), float(PAIR[b]), rel_tol=1e-14)


def square_wave_by_its_series(terms=200_000):
    """Return h and h' as Fourier series: 4/(pi k) sin(k omega t), k odd."""
    values = {one.name: float(value) for one, value in PAIR.items()}
    place = speed = 0.0
    for k in range(1, terms, 2):
        one = 1 / (values["a2"] - values["m1"] * (2.5 * k) ** 2 + 1j * values["a1"] * 2.5 * k)
        place += 4 / (math.pi * k) * (one / 1j).real
        speed += 4 / (math.pi * k) * (2.5 * k * one).real
    return place, speed


def letters():
    """Return the decay and the frequency of body 1, and what half a period leaves."""
    lam = float(PAIR[a1] / (2 * PAIR[m1]))
    return {
        decline: lam,
        swing: math.sqrt(float(PAIR[a2] / PAIR[m1]) - lam**2),
        decayed: math.exp(-math.pi * lam / 2.5),
    }


def test_the_square_waves_response_is_that_of_its_series():
    values = letters() | {m1: 1.5, omega: 2.5}
    found = [float(one.subs(values)) for one in forced_response.square_wave()]
    assert found == pytest.approx(square_wave_by_its_series(), abs=2e-6)


def test_without_a_damper_both_formulas_of_permanent_slip_agree():
    undamped = {**PAIR, a1: 0, omega: RATE}
    frequency = math.sqrt(float(PAIR[a2] / PAIR[m1]))
    response = {square_place: 0, square_speed: -math.tan(math.pi * frequency / 5) / (1.5 * frequency)}
    one = float(forced_response.non_stop_amplitude_squared().subs(undamped | response))
    other = float(forced_response.undamped_non_stop_amplitude_squared().subs({natural: frequency} | undamped))
    assert math.isclose(one, other, rel_tol=1e-13)


@pytest.mark.parametrize("n", [3, 5, 7])
def test_a_free_oscillation_flattens_the_peaks_as_far_as_it_is_said(n):
    share = math.sin(math.pi / (2 * n)) / n
    highest = max(abs(math.cos(p) - share * math.cos(n * p)) for p in (k * math.pi / 5000 for k in range(10001)))
    found = forced_response.harmonic_amplitude().subs(forced_response.multiple, n)
    assert math.isclose(1 / highest, float(found), rel_tol=1e-6)
    others = [share * (1 + d) for d in (-0.2, -0.05, 0.05, 0.2)]
    for other in others:
        assert max(abs(math.cos(k / 1000) - other * math.cos(n * k / 1000)) for k in range(1600)) > highest


def test_the_stuck_force_moves_the_stuck_pair(same):
    along = {
        forced_control.r_place: sp.sin(t),
        forced_control.r_speed: sp.cos(t),
        forced_control.r_acceleration: -sp.sin(t),
    }
    force = forced_control.stuck_force().subs(along)
    load = forced.load().subs({u: force, x1: sp.sin(t), v1: sp.cos(t)})
    assert same(load, -m2 * sp.sin(t))


@pytest.mark.parametrize("damping", [0.0, 0.4])
def test_the_least_force_of_a_slipping_transfer_by_stepping(damping):
    """Body 1 under U - b for tau, by Verlet-like steps: it is as fast as body 2 at tau."""
    mass, second, spring, friction, tau, steps = 1.5, 0.7, 3.0, 0.4, 0.6, 20_000
    lam = damping / (2 * mass)
    nu = math.sqrt(spring / mass - lam**2)
    values = {decline: lam, swing: nu, m1: mass, t: tau}
    g = float(forced_control.impulse_response().subs(values))
    known = {sp.Symbol("g", positive=True): g, forced_control.half_time: tau, b: friction, m2: second}
    push = float(forced_control.slipping_amplitude().subs(known))
    place = speed = 0.0
    for _ in range(steps):
        middle = place + speed * tau / steps / 2
        speed += (push - friction - spring * middle - damping * speed) / mass * tau / steps
        place = middle + speed * tau / steps / 2
    assert speed == pytest.approx(friction / second * tau, rel=1e-4)


def test_the_two_arcs_lead_from_rest_to_rest():
    for d in (0.01, 0.5, 1.0):
        first, second = (float(one.subs(forced_control.reduced, d)) for one in forced_control.switching())
        state = 1 + (0 - 1) * cmath.exp(-1j * first)
        state = -1 + (state + 1) * cmath.exp(-1j * second)
        assert state == pytest.approx(d, abs=1e-9)
