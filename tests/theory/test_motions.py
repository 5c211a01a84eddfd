"""Branches and closed forms of motion put into the printed equations: they solve them, and nothing beside them does.

What theory derives from them the claims hold against what is typed there, and a fault in it turns their rows.
"""

from dataclasses import replace

import pytest
from sympy import Rational, S, exp, simplify

from theory import closed_forms, model, scaling
from theory.closed_forms import DampingRegime, rate
from theory.symbols import (
    a1,
    a2,
    acceleration1,
    acceleration2,
    b,
    m1,
    m2,
    sgn,
    t,
    total_mass,
    u,
    v1,
    v2,
    x1,
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


def test_the_canonical_pair_has_unit_length_frequency_and_mass():
    for size in (scaling.half_width(), scaling.stick_frequency(), total_mass()):
        assert simplify(size.subs(scaling.canonical_pair(), simultaneous=True)) == 1
