"""Energy rates, the critical level and its converse, contraction, against printed formulas and samples."""

import pytest
from sympy import Abs, Matrix, limit, simplify, sqrt

from theory import energy, filippov
from theory.symbols import (
    E0,
    a1,
    a2,
    b,
    m1,
    m2,
    total_mass,
    undamped,
    v1,
    v1_0,
    v1_other,
    v2,
    v2_other,
    x1,
)

PRINTED_CRITICAL = b**2 * (m1 + m2) ** 2 / (2 * a2 * m2**2)
SIGNS = pytest.mark.parametrize("sign", [1, -1])


def test_the_printed_energy(same):
    assert same(energy.energy(), a2 * x1**2 / 2 + m1 * v1**2 / 2 + m2 * v2**2 / 2)


@SIGNS
def test_the_printed_rates(sign, same):
    printed = -b * sign * (v1 - v2)
    assert same(undamped(energy.slip_rate(sign)), printed)
    assert same(energy.slip_rate(sign), printed - a1 * v1**2)
    # sign (v1 - v2) is |v1 - v2| in the half-space of that sign.
    inside = {v1: v2 + sign * E0}
    assert same(printed.subs(inside), -b * Abs(v1 - v2).subs(inside))


def test_stick_conserves_energy_but_for_viscosity(same):
    assert same(energy.stick_rate(), -a1 * v1**2)


def test_the_printed_critical_energy(same):
    assert same(energy.critical_energy(), PRINTED_CRITICAL)


def test_condition_and_converse(same):
    gap = PRINTED_CRITICAL - E0
    assert same(energy.semi_axis_margin(), filippov.half_width() ** 2 - energy.level_semi_axis() ** 2)
    assert simplify(energy.semi_axis_margin() / gap).is_positive
    assert simplify(energy.edge_speed_squared() / -gap).is_positive


def test_the_velocity_keeps_its_sign_on_a_supercritical_arc(same):
    at_edge, rest = energy.arc_speed_terms()
    assert same(rest, a2 * (filippov.half_width() ** 2 - x1**2) / total_mass())
    level = energy.on_surface().subs(v1, sqrt(v1_0)).subs(v1_0, at_edge + rest)
    assert same(level, E0)
    assert not same(level, 2 * E0)


def test_captive_energy_is_where_the_ellipse_touches_the_strip(same):
    level = energy.captive_energy()
    assert same(limit(level, a1, 0), PRINTED_CRITICAL)
    # Where the ellipse touches the strip, v1/x1 is that of the gradients of E on S and of the load.
    common = filippov.load_threshold() / (a2 + a1**2 / total_mass())
    touching = {x1: common, v1: common * a1 / total_mass()}
    load = filippov.load(damped=True)
    gradients = Matrix([energy.on_surface(), load]).jacobian([x1, v1]).subs(touching)
    assert simplify(gradients.det()) == 0
    assert same(load.subs(touching), filippov.load_threshold())
    assert same(energy.on_surface().subs(touching), level)


def test_contraction_identity(same):
    viscous, friction = energy.contraction_terms()
    printed_viscous = -a1 * (v1 - v1_other) ** 2
    relative = (v1 - v2) - (v1_other - v2_other)
    printed_friction = -b * (energy.sigma - energy.sigma_other) * relative
    assert same(viscous, printed_viscous)
    assert same(friction, printed_friction)
    assert same(energy.contraction_rate(), viscous + friction)
