"""S, its parts, the sliding field and the exits, against the printed formulas and the exact slips."""

import pytest
from sympy import Rational, S, diff, series, simplify

from theory import filippov
from theory.closed_forms import Regime, coefficients, slip_guard
from theory.symbols import (
    a1,
    a2,
    b,
    distance,
    lower,
    m1,
    m2,
    t,
    upper,
    v1,
    v1_0,
    v2,
    v2_0,
    x1,
    x1_0,
)

PRINTED_HALF_WIDTH = b * (m1 + m2) / (a2 * m2)
NUMBERS = {m1: Rational(3, 2), m2: Rational(2, 3), a1: Rational(1, 7), a2: S(5), b: Rational(3, 4)}
EDGE = PRINTED_HALF_WIDTH.subs(NUMBERS)
BOTH = pytest.mark.parametrize("damped", [False, True])
SIDES = pytest.mark.parametrize("side", [1, -1])


@BOTH
def test_manifest_signs(damped):
    signs = filippov.manifest_signs(damped)
    assert signs["plus", 1].is_negative
    assert signs["plus", -1].is_negative
    assert signs["minus", 1].is_positive
    assert signs["minus", -1].is_positive
    assert signs["sliding", 1].is_nonpositive
    assert signs["sliding", -1].is_nonnegative
    assert signs["sliding", 1].has(upper)
    assert signs["sliding", -1].has(lower)
    assert signs["plus", 1].has(distance)


@pytest.mark.parametrize(
    ("state", "part"),
    [
        ((EDGE, 1, 1), "sliding"),
        ((EDGE, 1, 1), "ray_plus"),
        ((-EDGE, -1, -1), "ray_minus"),
        ((-EDGE, 0, 0), "sliding"),
        ((2 * EDGE, 1, 1), "plus"),
        ((-2 * EDGE, 1, 1), "minus"),
    ],
)
def test_parts_of_the_surface(state, part):
    condition = getattr(filippov.surface(), part).subs(NUMBERS)
    assert condition.subs(dict(zip((x1, v1, v2), state, strict=True))) == True  # noqa: E712
    off_surface = (state[0], state[1] + 1, state[2])
    assert condition.subs(dict(zip((x1, v1, v2), off_surface, strict=True))) == False  # noqa: E712


@BOTH
def test_the_convex_combination_is_tangent_and_its_weight_fits_on_s0_only(damped, same):
    alpha = filippov.sliding_weight(damped)
    mixed = alpha * filippov.transversality(1, damped) + (1 - alpha) * filippov.transversality(-1, damped)
    assert simplify(mixed) == 0
    assert same(filippov.weight_margin(damped), alpha * (1 - alpha))
    edge = filippov.load_threshold()
    assert same(filippov.weight_margin(damped), (edge**2 - filippov.load(damped) ** 2) / (4 * edge**2))


@BOTH
@SIDES
def test_exit_by_the_ray_goes_into_the_half_space_of_the_other_sign(damped, side):
    contact = filippov.edge_contact(side, damped)
    tangent = side * a1 * b / (a2 * m2) if damped else S(0)
    beyond = tangent + side * distance  # further out than the tangency, so on the ray
    assert contact.first == 0
    assert (side * simplify(contact.second.subs(v1, beyond))).is_negative
    assert (side * simplify(contact.second.subs(v1, tangent - side * distance))).is_positive
    assert simplify(contact.second.subs(v1, tangent)) == 0
    assert (side * simplify(contact.third.subs(v1, tangent))).is_positive
    assert (side * simplify(filippov.edge_speed_rate(side, damped).subs(v1, beyond))).is_positive


def test_edge_contact_is_the_taylor_expansion_of_the_exact_slip():
    side, mode = -1, "slip+"
    for regime, damped in ((Regime.UNDAMPED, False), (Regime.CRITICAL, True)):
        known = coefficients(mode, regime)
        position = (side * filippov.load_threshold() - (a1 * v1 if damped else 0)) / a2
        exact = slip_guard(mode, regime).subs({x1_0: position, v1_0: v1, v2_0: v1}, simultaneous=True)
        contact = filippov.edge_contact(side, damped)
        taylor = series(exact.subs(known), t, 0, 3).removeO()
        expected = contact.first * t + contact.second * t**2 / 2
        assert simplify((taylor - expected).subs(known)) == 0
        third = diff(exact, t, 3).subs(t, 0)
        assert simplify((third - contact.third).subs(known)) == 0
