"""The return map of a ray and its series against slips in 50 digits, and faults that must show."""

from collections.abc import Iterator

import mpmath
import pytest
from slip_by_hand import DIGITS, SLIPS, TOLERANCE, at, number
from sympy import Rational, S, cot, expand, limit, oo, pi, sin

from theory import return_map
from theory.symbols import q, theta

CACHED = [member for member in vars(return_map).values() if hasattr(member, "cache_clear")]


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(DIGITS + 10):
        yield


@pytest.mark.parametrize("slip", [one for one in SLIPS if one.d == 0])
def test_the_return_map_of_a_ray(slip):
    end = slip.end()
    before, after = (at(one, q=slip.q, theta=end) for one in return_map.return_map_of_angle())
    assert abs(before - slip.excess(0) / slip.q) < TOLERANCE
    assert abs(after - slip.excess(end) / slip.q) < TOLERANCE
    assert abs(before - 2 * (before - after) - slip.excess(end) / slip.q) > 1e-6


def test_the_depth():
    depth = return_map.depth()
    assert limit(depth, theta, 0) == 0
    assert limit(depth / theta**2, theta, 0) == Rational(1, 6)
    assert depth.subs(theta, pi) == 2
    assert limit(depth, theta, 2 * pi, "-") == oo
    assert abs(number((return_map.in_trigonometry(depth) - depth).subs(theta, S(2)))) < TOLERANCE
    assert not return_map.in_trigonometry(depth).has(cot)


def depth_by_inversion(excess):
    """c at y: h(theta) = sqrt(y) solved by Newton's method from theta = 3 sqrt(y), to the working precision."""
    root = mpmath.sqrt(excess)
    angle = mpmath.findroot(
        lambda a: (a - mpmath.sin(a)) / (1 - mpmath.cos(a)) - root,
        3 * root,
        tol=mpmath.mpf(10) ** (-1.5 * mpmath.mp.dps),
    )
    return 2 - angle * mpmath.cot(angle / 2)


def remainders(coefficients, excess):
    """(c - the terms before y^n)/y^n - c_n for each n: of the size of the next term, c_(n+1) y."""
    left = depth_by_inversion(excess)
    for power, coefficient in enumerate(coefficients, 1):
        value = mpmath.mpf(coefficient.p) / coefficient.q
        yield left / excess**power - value
        left -= value * excess**power


def test_the_series_of_the_depth_is_that_of_the_inverted_map():
    coefficients = return_map.depth_series(7)
    assert all(isinstance(coefficient, Rational) for coefficient in coefficients)
    assert coefficients[0] == Rational(3, 2)
    with mpmath.workdps(160):
        small = mpmath.mpf(10) ** -12
        assert all(abs(remainder) < 1e-11 for remainder in remainders(coefficients, small))
        for power in range(len(coefficients)):
            wrong = list(coefficients)
            wrong[power] *= Rational(1001, 1000)
            assert max(abs(remainder) for remainder in remainders(wrong, small)) > 1e-9


@pytest.mark.parametrize("order", [2, 3, 8])
def test_the_series_of_the_return_map_errs_by_its_first_dropped_term(order):
    series, fraction = return_map.return_map_series(order), mpmath.mpf(1) / 4
    quadratic = expand(series).coeff(return_map.scaled_excess, 2)
    assert expand(quadratic + Rational(9, 4) * (1 - q)) == 0
    with mpmath.workdps(DIGITS + 10):
        small = mpmath.mpf(10) ** -4
        exact = small - (1 - fraction) * depth_by_inversion(small) ** 2
        error = abs(at(series, q=fraction, y=small) - exact)
    assert 0.25 < error / small ** (order + 1) < 4  # the coefficient that was dropped is of the size of 1


RESIDUALS = [
    "guard_residual",
    "contact_slope_residual",
    "landing_residuals",
    "depth_slope_residual",
    "return_map_residuals",
    "return_map_slope_residual",
]


def nonzero(names):
    """Those of these residuals that are not all zero."""
    values = {name: getattr(return_map, name)() for name in names}
    return {name for name, value in values.items() if value not in (0, (0, 0), (0, 0, 0))}


def test_all_residuals_are_zero():
    assert nonzero(RESIDUALS) == set()


@pytest.fixture
def plant(monkeypatch):
    """Replace a name of theory.return_map, with nothing remembered before or after."""

    def planted(name, fault):
        monkeypatch.setattr(return_map, name, fault(getattr(return_map, name)))
        forget()

    yield planted
    monkeypatch.undo()
    forget()


def forget():
    for member in CACHED:
        member.cache_clear()


FAULTS = [
    ("depth", lambda depth: lambda: -depth(), {"landing_residuals", "depth_slope_residual"}),
    ("depth", lambda depth: lambda: depth() + sin(theta), set(RESIDUALS[2:])),
    ("h", lambda h: lambda: 2 * h(), {"guard_residual", "landing_residuals", *RESIDUALS[3:]}),
    ("half_cotangent", lambda half: lambda: -half(), {*RESIDUALS[:3], "return_map_residuals", "depth_slope_residual"}),
    ("r", lambda share: -share, {"landing_residuals", "return_map_residuals"}),
    ("excess", lambda excess: lambda: 2 * excess(), {"landing_residuals"}),
    ("contact_slope", lambda slope: lambda: (slope()[0], -slope()[1]), {"contact_slope_residual"}),
    ("contact_condition", lambda contact: lambda: contact() + 1, {"guard_residual"}),
    ("return_map_of_angle", lambda both: lambda: (both()[0], both()[1] ** 2), set(RESIDUALS[4:])),
]


@pytest.mark.parametrize(("name", "fault", "shown"), FAULTS)
def test_a_fault_leaves_a_residual(plant, name, fault, shown):
    plant(name, fault)
    assert nonzero(shown) == shown
