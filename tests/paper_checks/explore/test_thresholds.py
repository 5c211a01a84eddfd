"""The thresholds of a sine that the page tells, against the formulas of `theory`."""

from itertools import product
from math import pi
from pathlib import Path

import pytest
import sympy as sp
from chromium import asked

from theory import forced_response, symbols

POINTS = [*product((0.1, 1.0, 6.0), (0.02, 0.3, 0.8, 3.0), (0.2, 0.9, 1.7, 8.0)), (1.0, 0.0, 0.7), (3.0, 0.0, 4.1)]
RESONANT = (1 / 3, 0.0, 2.0)
HARMONIC = (1.0, 0.0, 0.2)


@pytest.fixture(scope="module")
def told(whole, tmp_path_factory) -> list[list[float]]:
    question = Path(__file__).with_name("thresholds.js")
    return asked(whole, question, tmp_path_factory.mktemp("thresholds"), POINTS=[*POINTS, RESONANT, HARMONIC])


def canonical(ratio: float, zeta: float, omega: float) -> dict:
    """The pair with L = Omega = M = 1, so that b = r and u/b is U/r."""
    q = sp.Rational(ratio) / (1 + sp.Rational(ratio))
    numbers = {symbols.m1: q, symbols.m2: 1 - q, symbols.a2: 1, symbols.b: 1 - q, symbols.a1: 2 * sp.Rational(zeta)}
    return numbers | {forced_response.omega: sp.Rational(omega)}


def damped_square_wave(numbers: dict) -> dict:
    """h and h' of `theory.forced_response.square_wave` as numbers."""
    m1, a1, a2, omega = (numbers[one] for one in (symbols.m1, symbols.a1, symbols.a2, forced_response.omega))
    decline = a1 / (2 * m1)
    swing = sp.sqrt(a2 / m1 - decline**2)
    values = {
        symbols.m1: m1,
        forced_response.omega: omega,
        forced_response.decline: decline,
        forced_response.swing: swing,
        forced_response.decayed: sp.exp(-sp.pi * decline / omega),
    }
    place, speed = forced_response.square_wave()
    return {forced_response.square_place: place.subs(values), forced_response.square_speed: speed.subs(values)}


def test_they_are_those_of_the_theory(told):
    for point, (stuck, slipping) in zip(POINTS, told, strict=False):
        numbers = canonical(*point)
        friction = float(numbers[symbols.b])
        assert stuck * friction == pytest.approx(float(forced_response.entrained_amplitude().subs(numbers)), rel=1e-12)
        if point[1] == 0:
            natural = {forced_response.natural: sp.sqrt(1 / numbers[symbols.m1])}
            square = forced_response.undamped_non_stop_amplitude_squared().subs(numbers | natural)
        else:
            square = forced_response.non_stop_amplitude_squared().subs(numbers | damped_square_wave(numbers))
        right = abs(complex(sp.N(square, 30))) ** 0.5
        assert slipping * friction == pytest.approx(right, rel=1e-10), point


def test_at_resonance_without_damping_it_is_four_over_pi(told):
    assert told[-2][1] == pytest.approx(4 / pi)


def test_a_free_oscillation_flattens_the_peaks_at_an_odd_multiple(told):
    numbers = canonical(*HARMONIC)
    factor = forced_response.harmonic_amplitude().subs(forced_response.multiple, 5)
    stuck = forced_response.entrained_amplitude().subs(numbers) * factor / numbers[symbols.b]
    assert told[-1][0] == pytest.approx(float(stuck), rel=1e-12)
