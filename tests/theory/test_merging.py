"""Merging in closed form, the long-time expansion: against slips solved by hand, and faults that must show."""

import mpmath
import pytest
from sympy import lambdify

from theory import long_time, merging
from theory.excursion import angle

RESIDUALS = [
    merging.ratio_slope_residual,
    merging.turning_residual,
    merging.turning_slope_residual,
    merging.critical_mass_ratio_residual,
    long_time.abel_defect,
    long_time.expansion_defect,
]
CACHED = [one for module in (merging, long_time) for one in vars(module).values() if hasattr(one, "cache_clear")]


@pytest.fixture(autouse=True)
def nothing_is_remembered():
    yield
    for one in CACHED:
        one.cache_clear()


@pytest.mark.parametrize("residual", RESIDUALS)
def test_every_residual_is_zero(residual):
    found = residual()
    assert all(one == 0 for one in (found if isinstance(found, tuple) else (found,)))


@pytest.mark.parametrize(("name", "residual"), [
    ("ratio", "ratio_slope_residual"),
    ("ratio", "turning_residual"),
    ("turning_slope", "turning_slope_residual"),
    ("critical_mass_ratio", "critical_mass_ratio_residual"),
])  # fmt: skip
def test_a_changed_form_leaves_a_residual(monkeypatch, name, residual):
    for one in CACHED:
        one.cache_clear()
    original = getattr(merging, name)()
    changed = tuple(2 * one for one in original) if isinstance(original, tuple) else 2 * original
    for one in CACHED:
        one.cache_clear()
    monkeypatch.setattr(merging, name, lambda: changed)
    found = getattr(merging, residual)()
    assert any(one != 0 for one in (found if isinstance(found, tuple) else (found,)))


@pytest.mark.parametrize("fraction", ["0.1", "0.5", "0.93"])
@pytest.mark.parametrize("phi", ["0.3", "1.5", "1.9", "2.9"])
def test_the_excess_after_a_slip_from_a_ray_is_that_of_the_slip_solved_by_hand(fraction, phi):
    """q V1' = -(X - r), V2' = -1 from X = 1 with the push of the half angle."""
    with mpmath.workdps(50):
        fraction, phi = mpmath.mpf(fraction), mpmath.mpf(phi)
        push = (phi - mpmath.sin(phi) * mpmath.cos(phi)) / mpmath.sin(phi) ** 2
        turn = 2 * phi
        position = 1 - fraction + fraction * (mpmath.cos(turn) + push * mpmath.sin(turn))
        first = mpmath.sqrt(fraction) * (push * mpmath.cos(turn) - mpmath.sin(turn))
        assert mpmath.almosteq(first, mpmath.sqrt(fraction) * (push - turn), 1e-40)
        form = lambdify((merging.share, angle), merging.ray_excess(), "mpmath")
        assert mpmath.almosteq(form(1 - fraction, phi), (position**2 + first**2 - 1) / fraction, 1e-40)


def test_the_threshold_is_the_least_ratio_of_push_to_depth():
    with mpmath.workdps(40):
        root = mpmath.findroot(lambdify(angle, merging.turning_function(), "mpmath"), 1.9)
        ratio = lambdify(angle, merging.ratio(), "mpmath")
        least = ratio(root) ** 2
        assert mpmath.almosteq(least, 1 / (2 * mpmath.sin(root) ** 2), 1e-38)
        assert mpmath.nstr(least, 16) == "0.5578390907215263"
        assert all(ratio(root + shift) ** 2 > least for shift in (-1, -0.01, 0.01, 1))
