"""The closed form (3), (4) and its branches: signum at numbers, and where each branch solves the printed equations."""

import pytest
from sympy import Rational, S

from theory import model
from theory.symbols import a1, a2, acceleration1, acceleration2, b, m1, m2, sgn, u, v1, v2, x1

PARAMETERS = {m1: Rational(3, 2), m2: Rational(2, 3), a1: Rational(1, 7), a2: S(5), b: Rational(3, 4), u: S(0)}
THRESHOLD = Rational(3, 4) * (Rational(3, 2) + Rational(2, 3)) / Rational(2, 3)  # b M/m2

# States that realise each branch: (x1, v1, v2); at v1 = 0 the load is a2 x1.
STATES = {
    "stick": [(THRESHOLD / 6, 0, 0), (Rational(1, 9), Rational(-1, 5), Rational(-1, 5)), (0, 0, 0)],
    "half adhesion": [(THRESHOLD / 5, 0, 0), (-THRESHOLD / 5, 0, 0)],
    "broken adhesion": [(THRESHOLD / 4, 0, 0), (-3 * THRESHOLD, 0, 0)],
    "slip+": [(2, 1, 0), (Rational(1, 100), 0, -1), (-9, 0, -1)],
    "slip-": [(2, 0, 1), (Rational(1, 100), -1, 0), (-9, -1, 0)],
}


def satisfies(name, state):
    """Both equations at numbers, with sgn replaced by its definition (1), never by an assumed value."""
    found = model.branch_named(name)
    numbers = PARAMETERS | dict(zip((x1, v1, v2), map(S, state), strict=True))
    motion = {acceleration1: found.acceleration1, acceleration2: found.acceleration2}
    equations = (model.driving_equation(), model.driven_equation())
    return all(one.subs(motion).subs(numbers).replace(sgn, model.signum) == 0 for one in equations)


@pytest.mark.parametrize(("value", "expected"), [(-2, -1), (Rational(-1, 10**30), -1), (0, 0), (7, 1)])
def test_signum_takes_three_values(value, expected):
    assert model.signum(S(value)) == expected


def test_there_are_five_branches_and_slip_ignores_the_second_bracket():
    assert [found.name for found in model.branches()] == list(STATES)
    assert {found.name for found in model.branches() if found.stiction_sign is None} == {"slip+", "slip-"}


@pytest.mark.parametrize("name", STATES)
def test_a_branch_solves_the_closed_form_where_its_signs_hold_and_nowhere_else(name):
    assert all(satisfies(name, state) for state in STATES[name])
    elsewhere = [state for other, states in STATES.items() if other != name for state in states if state[0]]
    assert not any(satisfies(name, state) for state in elsewhere)
