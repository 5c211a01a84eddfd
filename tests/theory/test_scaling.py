"""The reduced coordinates: derived fields, one parameter, energy; and the way back to SI."""

import pytest
from sympy import Matrix, simplify

from theory import filippov, scaling
from theory.symbols import V1, V2, X, a1, a2, b, m1, m2, q, r, total_mass, v1, v2, x1, zeta

ZERO = Matrix([0, 0, 0])
SIGNS = pytest.mark.parametrize("sign", [1, -1])


@SIGNS
def test_undamped_fields(sign):
    assert simplify(scaling.reduced_slip(sign) - Matrix([V1, -(X + r * sign) / q, sign])) == ZERO
    assert simplify(scaling.reduced_stick() - Matrix([V1, -X, -X])) == ZERO
    for wrong in ([V1, -(X - r * sign) / q, sign], [V1, -(X + r * sign) / r, sign], [V1, -X / q, sign]):
        assert simplify(scaling.reduced_slip(sign) - Matrix(wrong)) != ZERO


@SIGNS
def test_viscous_fields(sign):
    slip = Matrix([V1, -(X + 2 * zeta * V1 + r * sign) / q, sign])
    assert simplify(scaling.reduced_slip(sign, damped=True) - slip) == ZERO
    stick = -(X + 2 * zeta * V1)
    assert simplify(scaling.reduced_stick(damped=True) - Matrix([V1, stick, stick])) == ZERO


@SIGNS
def test_energy_and_excess(sign, same):
    assert same(scaling.reduced_energy(), X**2 + q * V1**2 + r * V2**2)
    printed = -2 * r * sign * (V1 - V2)
    assert same(scaling.excess_rate(sign), printed)
    assert same(scaling.excess_rate(sign, damped=True), printed - 4 * zeta * V1**2)


@SIGNS
def test_the_reduced_rate_is_the_chain_rule_in_reduced_coordinates(sign, same):
    gradient = Matrix([scaling.reduced_energy()]).jacobian([X, V1, V2])
    for damped in (False, True):
        along = (gradient * scaling.reduced_slip(sign, damped))[0]
        assert same(along, scaling.excess_rate(sign, damped))


def test_the_canonical_pair_has_unit_length_frequency_and_mass():
    for size in (scaling.half_width(), scaling.stick_frequency(), total_mass()):
        assert simplify(size.subs(scaling.canonical_pair(), simultaneous=True)) == 1
    for sign in (1, -1):
        field = filippov.phi(sign, damped=True).subs(scaling.canonical_pair(), simultaneous=True)
        renamed = field.subs({x1: X, v1: V1, v2: V2}, simultaneous=True)
        assert simplify(renamed - scaling.reduced_slip(sign, damped=True)) == ZERO
    assert scaling.canonical_pair() == {m1: q, m2: r, a2: 1, b: r, a1: 2 * zeta}
