"""The velocity on a supercritical arc, and viscosity in stick. What the paper prints is decided where it is claimed."""

from sympy import sqrt

from theory import energy, filippov
from theory.symbols import E0, a1, a2, total_mass, v1, v1_0, x1


def test_the_velocity_keeps_its_sign_on_a_supercritical_arc(same):
    at_edge, rest = energy.arc_speed_terms()
    assert same(rest, a2 * (filippov.half_width() ** 2 - x1**2) / total_mass())
    level = energy.on_surface().subs(v1, sqrt(v1_0)).subs(v1_0, at_edge + rest)
    assert same(level, E0)
    assert not same(level, 2 * E0)


def test_stick_conserves_energy_but_for_viscosity(same):
    assert same(energy.stick_rate(), -a1 * v1**2)
