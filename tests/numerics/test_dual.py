"""Dual numbers: every function of the arithmetic against a difference of its values, in balls."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
import pytest
from finite_differences import ball
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.dual_number import DualNumber
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.protocol import Sign
from numerics.arithmetic.telling import text
from numerics.contact.root import root_of
from numerics.contact.surface import contact
from numerics.sensitivity.duals import dual

BASE = Ball(80)
DUAL = dual(BASE)
WORDS = DUAL.telling.words
CONTACT = DUAL.telling(contact)


class Pairing(NamedTuple):
    """Two numbers."""

    x: Any
    y: Any


@text
def falling(at, x):
    """x0 - y p - p^3 and its slope."""
    return at[0] - at[1] * x - x * x * x, -at[1] - 3 * x * x


ROOT = DUAL.telling(root_of(falling, "root_of_falling"))
STEP = Fraction(1, 10**30)
FUNCTIONS = {
    "sum": lambda x, y: 2 + x + y - 3 * x,
    "difference": lambda x, y: 1 - x - (y - 2),
    "product": lambda x, y: 3 * x * y * 2,
    "quotient": lambda x, y: x / y + 1 / x + y / 7,
    "power": lambda x, y: x**3 - y**2,
    "absolute value": lambda x, y: abs(-x) * abs(y),
    "sqrt": lambda x, y: WORDS["sqrt"](x * y),
    "exp": lambda x, y: WORDS["exp"](x - y),
    "expm1": lambda x, y: WORDS["expm1"](x * y),
    "log": lambda x, y: WORDS["log"](x + y),
    "log1p": lambda x, y: WORDS["log1p"](x * y),
    "cosine": lambda x, y: WORDS["sine_cosine"](x + 2 * y)[1],
    "sine": lambda x, y: WORDS["sine_cosine"](x - 2 * y)[0],
    "atan2": lambda x, y: WORDS["atan2"](x * y, x - y),
    "versine": lambda x, y: WORDS["versine"](x * y),
    "sine deficit": lambda x, y: WORDS["sine_deficit"](x * y),
    "cosine deficit": lambda x, y: WORDS["cosine_deficit"](x / y),
    "contact angle": lambda x, y: CONTACT(x, y).theta,
    "contact depth": lambda x, y: CONTACT(x * y, -y).depth,
    "late contact": lambda x, y: CONTACT(x, 2 + y).versine,
    "root": lambda x, y: ROOT(Pairing(x, y), DUAL.number(-5), DUAL.number(5), DUAL.number(0)),
    "sum in parts": lambda x, y: WORDS["clock"](x, DUAL.number(0), y * y)[0],
    "ceiling": lambda x, y: DUAL.number(WORDS["ceiling"](x + y, 0)) * x,
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
        assert not any(one.is_finite() for one in WORDS["sqrt"](x).gradient)
        assert WORDS["sqrt"](DUAL.number(0)).gradient is None
        assert DUAL.sign(WORDS["sqrt"](x)) is Sign.ZERO


@pytest.mark.parametrize("base", [Float64(), Multiprecision(40), BASE], ids=lambda one: one.name)
def test_names_digits_and_order_are_those_of_the_base(base):
    duals = dual(base)
    assert (duals.name, duals.digits) == (base.name, base.digits)
    with duals.context():
        one, two = duals.number(1), duals.number(2)
        assert one < two
        assert two >= 2
        assert one == 1
        assert not duals.number(0)
        assert duals.to_float(duals.telling.words["half_turn"]()) == pytest.approx(3.14159265358979)
        assert duals.text(two) == base.text(base.number(2))
