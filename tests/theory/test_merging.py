"""Merging in closed form, the long-time expansion: against slips solved by hand, and faults that must show."""

import mpmath
import pytest
from sympy import lambdify

from theory import long_time, merging
from theory.excursion import angle

RESIDUALS = [
    merging.slip_residuals,
    merging.next_excess_residual,
    merging.vertex_residual,
    merging.least_excess_residual,
    merging.least_excess_slope_residual,
    merging.ray_residuals,
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
    ("slip_start", "slip_residuals"),
    ("least_excess", "least_excess_residual"),
    ("ratio", "ratio_slope_residual"),
    ("vertex", "vertex_residual"),
    ("ray_excess", "ray_residuals"),
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


def test_the_threshold_is_the_least_ratio_of_push_to_depth():
    with mpmath.workdps(40):
        root = mpmath.findroot(lambdify(angle, merging.turning_function(), "mpmath"), 1.9)
        ratio = lambdify(angle, merging.ratio(), "mpmath")
        least = ratio(root) ** 2
        assert mpmath.almosteq(least, 1 / (2 * mpmath.sin(root) ** 2), 1e-38)
        assert mpmath.nstr(least, 16) == "0.5578390907215263"
        assert all(ratio(root + shift) ** 2 > least for shift in (-1, -0.01, 0.01, 1))
