"""Dual numbers: every function of the arithmetic against a difference of its values, in balls."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from finite_differences import ball
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.dual import Dual, differentiated
from numerics.arithmetic.dual_number import DualNumber
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.protocol import Sign

BASE = Ball(80)
DUAL = Dual(BASE)
STEP = Fraction(1, 10**30)
FUNCTIONS = {
    "sum": lambda x, y: 2 + x + y - 3 * x,
    "difference": lambda x, y: 1 - x - (y - 2),
    "product": lambda x, y: 3 * x * y * 2,
    "quotient": lambda x, y: x / y + 1 / x + y / 7,
    "power": lambda x, y: x**3 - y**2,
    "absolute value": lambda x, y: abs(-x) * abs(y),
    "sqrt": lambda x, y: DUAL.sqrt(x * y),
    "exp": lambda x, y: DUAL.exp(x - y),
    "expm1": lambda x, y: DUAL.expm1(x * y),
    "log": lambda x, y: DUAL.log(x + y),
    "log1p": lambda x, y: DUAL.log1p(x * y),
    "cosine": lambda x, y: DUAL.cos_sin(x + 2 * y)[0],
    "sine": lambda x, y: DUAL.cos_sin(x - 2 * y)[1],
    "atan2": lambda x, y: DUAL.atan2(x * y, x - y),
    "versine": lambda x, y: DUAL.versine(x * y),
    "sine deficit": lambda x, y: DUAL.sine_deficit(x * y),
    "cosine deficit": lambda x, y: DUAL.cosine_deficit(x / y),
    "lag": lambda x, y: DUAL.lag(x - y),
    "rise": lambda x, y: DUAL.rise(x + y),
    "depth": lambda x, y: DUAL.depth(x + y),
    "contact angle": lambda x, y: DUAL.contact(x, y).theta,
    "contact depth": lambda x, y: DUAL.contact(x * y, -y).depth,
    "late contact": lambda x, y: DUAL.contact(x, 2 + y).versine,
    "root": lambda x, y: DUAL.root(
        lambda p: x - y * p - DUAL.exp(p), lambda p: -y - DUAL.exp(p), DUAL.number(-5), DUAL.number(5)
    ),
    "mean value": lambda x, y: DUAL.mean_value(lambda p: p * p * y, lambda p: 2 * p * y, x + y),
    "sum in parts": lambda x, y: DUAL.accumulate(x, DUAL.number(0), y * y)[0],
    "ceiling": lambda x, y: DUAL.number(DUAL.ceiling(x + y)) * x,
}


def variables(x, y):
    """Two independent quantities, as exact rationals."""
    return [
        DUAL.number(DualNumber(v, np.array(unit, dtype=object)))
        for v, unit in zip((x, y), np.eye(2, dtype=int).tolist(), strict=True)
    ]


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("point", [(Fraction(7, 10), Fraction(1, 3)), (Fraction(13, 8), Fraction(9, 7))])
def test_gradients_are_limits_of_differences(name, point):
    function = FUNCTIONS[name]
    with DUAL.context():
        found = function(*variables(*point))
        for index in range(2):
            up, down = ([v + s * STEP * (k == index) for k, v in enumerate(point)] for s in (1, -1))
            difference = (function(*variables(*up)).value - function(*variables(*down)).value) / ball(2 * STEP)
            assert abs(difference - found.gradient[index]) < arb("1e-40")


def test_what_has_no_derivative_has_none():
    with DUAL.context():
        x, _ = variables(Fraction(0), Fraction(1))
        assert not any(one.is_finite() for one in DUAL.sqrt(x).gradient)
        assert DUAL.sqrt(DUAL.number(0)).gradient is None
        assert DUAL.sign(DUAL.sqrt(x)) is Sign.ZERO


@pytest.mark.parametrize("base", [Float64(), Multiprecision(40), BASE], ids=lambda one: one.name)
def test_names_digits_and_order_are_those_of_the_base(base):
    dual = Dual(base)
    assert (dual.name, dual.digits) == (base.name, base.digits)
    with dual.context():
        one, two = dual.number(1), dual.number(2)
        assert one < two
        assert two >= 2
        assert one == 1
        assert not dual.number(0)
        assert dual.to_float(dual.pi()) == pytest.approx(3.14159265358979)
        assert dual.text(two) == base.text(base.number(2))
        assert dual.centre(two).value == base.number(2)


def test_values_and_gradients_may_come_from_two_formulas():
    """x is the value, and 3 x has the derivatives; without duals the second formula is never asked."""
    with DUAL.context():
        x, _ = variables(Fraction(2), Fraction(1))
        found = differentiated(DUAL, lambda: x, lambda constant: 3 * x + constant)
        assert found.value == 2
        assert [float(one) for one in found.gradient] == [3, 0]
    assert differentiated(Float64(), lambda: 5.0, lambda _: 1 / 0) == 5.0
