"""S at numbers, the exact solutions, and the reduced coordinates: as typed here."""

from dataclasses import replace

import pytest
from sympy import Matrix, Rational, S, diff, exp, series, simplify

from theory import closed_forms, filippov, scaling
from theory.closed_forms import DampingRegime, coefficients, rate, slip_guard
from theory.symbols import V1, V2, X, a1, a2, b, m1, m2, q, r, t, total_mass, v1, v1_0, v2, v2_0, x1, x1_0, zeta

NUMBERS = {m1: Rational(3, 2), m2: Rational(2, 3), a1: Rational(1, 7), a2: S(5), b: Rational(3, 4)}
EDGE = (b * (m1 + m2) / (a2 * m2)).subs(NUMBERS)
SIGNS = pytest.mark.parametrize("sign", [1, -1])
REGIMES = pytest.mark.parametrize("regime", list(DampingRegime))


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


@pytest.mark.parametrize("damped", [False, True])
def test_manifest_signs(damped):
    signs = filippov.manifest_signs(damped)
    assert all(signs["plus", sign].is_negative and signs["minus", sign].is_positive for sign in (1, -1))
    assert signs["sliding", 1].is_nonpositive
    assert signs["sliding", -1].is_nonnegative


def test_edge_contact_is_the_taylor_expansion_of_the_exact_slip():
    side, mode = -1, "slip+"
    for regime, damped in ((DampingRegime.UNDAMPED, False), (DampingRegime.CRITICAL, True)):
        known = coefficients(mode, regime)
        position = (side * filippov.load_threshold() - (a1 * v1 if damped else 0)) / a2
        exact = slip_guard(mode, regime).subs({x1_0: position, v1_0: v1, v2_0: v1}, simultaneous=True)
        contact = filippov.edge_contact(side, damped)
        taylor = series(exact.subs(known), t, 0, 3).removeO()
        assert simplify((taylor - contact.first * t - contact.second * t**2 / 2).subs(known)) == 0
        assert simplify((diff(exact, t, 3).subs(t, 0) - contact.third).subs(known)) == 0


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


@SIGNS
@pytest.mark.parametrize("damping", [0, zeta])
def test_the_reduced_fields_and_the_rate_of_the_excess(sign, damping, same):
    damped, spring = bool(damping), X + 2 * damping * V1
    slip = scaling.reduced_slip(sign, damped)
    assert simplify(slip - Matrix([V1, -(spring + r * sign) / q, sign])) == Matrix([0, 0, 0])
    assert simplify(scaling.reduced_stick(damped) - Matrix([V1, -spring, -spring])) == Matrix([0, 0, 0])
    energy = X**2 + q * V1**2 + r * V2**2
    assert same(scaling.reduced_energy(), energy)
    along = (Matrix([energy]).jacobian([X, V1, V2]) * slip)[0]
    assert same(scaling.excess_rate(sign, damped), along)


def test_the_canonical_pair_has_unit_length_frequency_and_mass():
    assert scaling.canonical_pair() == {m1: q, m2: r, a2: 1, b: r, a1: 2 * zeta}
    for size in (scaling.half_width(), scaling.stick_frequency(), total_mass()):
        assert simplify(size.subs(scaling.canonical_pair(), simultaneous=True)) == 1
