"""The closed form (3), (4) and its branches: signum at numbers, forces, the printed equations."""

import pytest
from sympy import Rational, S

from theory import model
from theory.symbols import (
    a1,
    a2,
    acceleration1,
    acceleration2,
    b,
    free,
    m1,
    m2,
    sgn,
    total_mass,
    u,
    v1,
    v2,
    x1,
)

PARAMETERS = {
    m1: Rational(3, 2),
    m2: Rational(2, 3),
    a1: Rational(1, 7),
    a2: S(5),
    b: Rational(3, 4),
    u: S(0),
}
THRESHOLD = Rational(3, 4) * (Rational(3, 2) + Rational(2, 3)) / Rational(2, 3)  # b M/m2

# States that realise each branch: (x1, v1, v2); at v1 = 0 the load is a2 x1.
STATES = {
    "stick": [(THRESHOLD / 6, 0, 0), (Rational(1, 9), Rational(-1, 5), Rational(-1, 5)), (0, 0, 0)],
    "half adhesion": [(THRESHOLD / 5, 0, 0), (-THRESHOLD / 5, 0, 0)],
    "broken adhesion": [(THRESHOLD / 4, 0, 0), (-3 * THRESHOLD, 0, 0)],
    "slip+": [(2, 1, 0), (Rational(1, 100), 0, -1), (-9, 0, -1)],
    "slip-": [(2, 0, 1), (Rational(1, 100), -1, 0), (-9, -1, 0)],
}


def evaluated(equation, found, state):
    """An equation at numbers, with sgn replaced by its definition (1), never by an assumed value."""
    numbers = PARAMETERS | dict(zip((x1, v1, v2), map(S, state), strict=True))
    motion = {acceleration1: found.acceleration1, acceleration2: found.acceleration2}
    return equation.subs(motion).subs(numbers).replace(sgn, model.signum)


def satisfies(found, state):
    equations = (model.driving_equation(), model.driven_equation())
    return all(evaluated(equation, found, state) == 0 for equation in equations)


@pytest.mark.parametrize(("value", "expected"), [(-2, -1), (Rational(-1, 10**30), -1), (0, 0), (7, 1)])
def test_signum_takes_three_values(value, expected):
    assert model.signum(S(value)) == expected


def test_there_are_five_branches_and_slip_ignores_the_second_bracket():
    assert [found.name for found in model.branches()] == list(STATES)
    assert {found.name for found in model.branches() if found.stiction_sign is None} == {"slip+", "slip-"}


@pytest.mark.parametrize("name", STATES)
def test_a_branch_solves_the_closed_form_where_its_signs_hold(name):
    assert all(satisfies(model.branch_named(name), state) for state in STATES[name])


@pytest.mark.parametrize("name", STATES)
def test_a_branch_solves_the_closed_form_nowhere_else(name):
    elsewhere = [state for other, states in STATES.items() if other != name for state in states if state[0]]
    assert not any(satisfies(model.branch_named(name), state) for state in elsewhere)


def test_forces_are_equal_and_opposite_in_the_two_modes_only():
    balanced = {found.name for found in model.branches() if found.force_imbalance == 0}
    assert balanced == {"stick", "slip+", "slip-"}


def test_broken_adhesion_leaves_a_force_on_one_body_alone(same):
    found = model.branch_named("broken adhesion")
    assert found.acceleration2 == 0
    assert found.force_on_second == 0
    assert same(found.force_on_first, -m2 * found.acceleration1)
    half = model.branch_named("half adhesion")
    assert same(half.acceleration2, half.acceleration1 / 2)
    assert same(half.force_imbalance, -m2 * half.acceleration1 / 2)


def test_free_system_agrees_with_the_branches_off_the_surface_and_not_on_it(same):
    for sign in (1, -1):
        assert all(
            same(left, right) for left, right in zip(model.free_system(sign), model.slip(sign).field, strict=True)
        )
    assert not same(model.free_system(0)[1], model.stick().field[1])
    # The set-valued sign that makes both accelerations equal gives stick.
    adhesion = -m2 * free(a1 * v1 + a2 * x1) / (total_mass() * b)
    assert all(same(left, right) for left, right in zip(model.free_system(adhesion), model.stick().field, strict=True))
