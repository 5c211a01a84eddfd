"""Functions of wide balls hold the values at their points; what is no number decides nothing; roots."""

from fractions import Fraction
from typing import Any, NamedTuple

import flint
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from strategies import decimals

from numerics.arithmetic import functions
from numerics.arithmetic.ball import Ball, proved_sign
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.questions import GRAZES
from numerics.errors import EventUndecided, OutOfRange
from numerics.free.root import falling_root

DEFICITS = {
    "versine": lambda x: 1 - x.cos(),
    "sine_deficit": lambda x: x - x.sin(),
    "cosine_deficit": lambda x: x * x / 2 - 1 + x.cos(),
}
TRUTH_BITS = 8000


def ball(value: Fraction) -> arb:
    return arb(fmpq(value.numerator, value.denominator))


class Bits:
    """The precision of the truth, restored."""

    def __init__(self, bits: int = TRUTH_BITS):
        self.bits = bits

    def __enter__(self):
        self.before, flint.ctx.prec = flint.ctx.prec, self.bits

    def __exit__(self, *_):
        flint.ctx.prec = self.before


@pytest.mark.parametrize("name", DEFICITS)
@given(x=decimals(-40, -1, 10), relative=st.integers(3, 25), part=st.floats(-1, 1))
def test_a_wide_ball_encloses_every_point_of_it(name, x, relative, part):
    radius = x / 10**relative
    inside = x + radius * Fraction(part) * Fraction(999, 1000)
    arithmetic = Ball(30)
    with Bits():
        truth, wide = DEFICITS[name](ball(inside)), arb(ball(x).mid(), ball(radius).upper())
    with arithmetic.context():
        value = getattr(functions, name)(wide)
    with Bits():
        assert value.overlaps(truth)
        if relative > 5:  # x^4 moves four times as much as x, relatively
            assert value.rad() <= 8 * abs(truth) * arb(10) ** -relative


def test_balls_that_are_not_finite_decide_nothing():
    arithmetic = Ball(20)
    with arithmetic.context():
        for x in (arb("nan"), arb("inf"), arb(0, 1), arb(1, 2)):
            with pytest.raises(EventUndecided, match=r"which\?"):
                proved_sign(x, "which?")
            with pytest.raises(EventUndecided, match="graze"):
                functions.sign(x, GRAZES)
        with pytest.raises(EventUndecided, match="graze"):
            functions.ceiling(arb(0, 1), GRAZES)
        assert functions.sign(arb(0), GRAZES) == 0
        assert functions.sqrt(arb(0, 1e-30)).is_finite()
        assert functions.sqrt(arb(0, 1e-30)).contains(arb(1e-15))


def test_float64_refuses_what_it_cannot_hold():
    for value in (Fraction(10) ** 400, Fraction(1, 10**400), -(Fraction(10) ** 400)):
        with pytest.raises(OutOfRange):
            Float64().number(value)


def power(p: int):
    """c^p - x^p, which falls through its root c, and its slope."""
    return lambda at, x: (at.c**p - x**p, -p * x ** (p - 1))


class Target(NamedTuple):
    """Where the root is."""

    c: Any


@given(target=decimals(-30, 6, 8), p=st.sampled_from([1, 3, 5]))
def test_roots_of_monotone_functions(target, p):
    """Wide brackets and steep flanks included."""
    for arithmetic in (Float64(), Multiprecision(40), Ball(40)):
        with arithmetic.context():
            c = arithmetic.number(target)
            lower, upper = c / 1000, 1000 * c
            root = falling_root(lower, upper, power(p), Target(c))
            if arithmetic.name == "ball":
                assert root.overlaps(c)
                assert root.rad() <= c * arb(10) ** -36
            else:
                digits = 14 if arithmetic.name == "float64" else 37
                assert abs(root / c - 1) <= 10.0**-digits


def test_a_ball_root_needs_proven_signs():
    arithmetic = Ball(30)
    with arithmetic.context():
        for lower, upper in ((2, 3), (-3, -2), (0, 1), (1, 2)):
            with pytest.raises(EventUndecided, match="bracket"):
                falling_root(arb(lower), arb(upper), power(1), Target(arb(1)))
