"""Branches and closed forms of motion put into the printed equations: they solve them, and nothing beside them does.

What theory derives from them the claims hold against what is typed there, and a fault in it turns their rows.
"""

from dataclasses import replace

import pytest
from sympy import Rational, S, exp, simplify

from theory import closed_forms, filippov, model, scaling
from theory.closed_forms import DampingRegime, rate
from theory.symbols import (
    V1,
    X,
    a1,
    a2,
    acceleration1,
    acceleration2,
    b,
    m1,
    m2,
    q,
    r,
    sgn,
    t,
    total_mass,
    u,
    v1,
    v2,
    x1,
    zeta,
)

NUMBERS = {m1: Rational(3, 2), m2: Rational(2, 3), a1: Rational(1, 7), a2: S(5), b: Rational(3, 4), u: S(0)}
EDGE = (b * (m1 + m2) / (a2 * m2)).subs(NUMBERS)
REGIMES = pytest.mark.parametrize("regime", list(DampingRegime))

# States that realise each branch: (x1, v1, v2).
STATES = {
    "stick": [(EDGE * 5 / 6, 0, 0), (Rational(1, 9), Rational(-1, 5), Rational(-1, 5)), (0, 0, 0)],
    "half adhesion": [(EDGE, 0, 0), (-EDGE, 0, 0)],
    "broken adhesion": [(EDGE * 5 / 4, 0, 0), (-15 * EDGE, 0, 0)],
    "slip+": [(2, 1, 0), (Rational(1, 100), 0, -1), (-9, 0, -1)],
    "slip-": [(2, 0, 1), (Rational(1, 100), -1, 0), (-9, -1, 0)],
}


def satisfies(name, state):
    """Both equations at numbers, with sgn replaced by its definition (1), never by an assumed value."""
    found = model.branch_named(name)
    numbers = NUMBERS | dict(zip((x1, v1, v2), map(S, state), strict=True))
    motion = {acceleration1: found.acceleration1, acceleration2: found.acceleration2}
    equations = (model.driving_equation(), model.driven_equation())
    return all(one.subs(motion).subs(numbers).replace(sgn, model.signum) == 0 for one in equations)


@pytest.mark.parametrize("name", STATES)
def test_a_branch_solves_the_closed_form_where_its_signs_hold_and_nowhere_else(name):
    assert [found.name for found in model.branches()] == list(STATES)
    assert (model.branch_named(name).stiction_sign is None) == name.startswith("slip")
    assert all(satisfies(name, state) for state in STATES[name])
    elsewhere = [state for other, states in STATES.items() if other != name for state in states if state[0]]
    assert not any(satisfies(name, state) for state in elsewhere)


@pytest.mark.parametrize("mode", ["stick", "slip+", "slip-"])
@REGIMES
def test_the_exact_solution_leaves_nothing(mode, regime):
    assert closed_forms.residual(closed_forms.solution(mode, regime)) == (0,) * 6


@REGIMES
def test_every_fault_in_it_leaves_something(regime):
    found = closed_forms.solution("slip+", regime)
    faults = [
        replace(found, x1=2 * found.x1),
        replace(found, x1=found.x1.subs(rate, 2 * rate) if regime is not DampingRegime.CRITICAL else found.x1 * exp(t)),
        replace(found, x2=found.x2 + t**2 / 2),
        replace(found, x2=-found.x2),
        replace(found, mode="slip-"),
    ]
    assert all(set(closed_forms.residual(fault)) != {0} for fault in faults)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("damped", [False, True])
def test_the_rate_of_the_excess_is_that_along_the_reduced_field(sign, damped):
    along = filippov.derivative_along(filippov.phi(sign, damped), scaling.to_si(scaling.reduced_energy()))
    assert simplify(scaling.to_si(scaling.excess_rate(sign, damped)) * scaling.stick_frequency() - along) == 0
    field = [V1, -(X + 2 * int(damped) * zeta * V1 + r * sign) / q, sign]
    assert all(simplify(one - two) == 0 for one, two in zip(scaling.reduced_slip(sign, damped), field, strict=True))


def test_the_canonical_pair_has_unit_length_frequency_and_mass():
    for size in (scaling.half_width(), scaling.stick_frequency(), total_mass()):
        assert simplify(size.subs(scaling.canonical_pair(), simultaneous=True)) == 1


@pytest.mark.parametrize("damped", [False, True])
def test_manifest_signs(damped):
    signs = filippov.manifest_signs(damped)
    assert all(signs["plus", sign].is_negative and signs["minus", sign].is_positive for sign in (1, -1))
    assert signs["sliding", 1].is_nonpositive
    assert signs["sliding", -1].is_nonnegative
