"""Centred forms: each holds every value over its cell, and is not much wider."""

from fractions import Fraction

from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from numerics.arithmetic.ball import Ball
from numerics.free.centred_form import parameters

sides = st.tuples(st.integers(1, 1000), st.integers(1, 100)).map(lambda s: (Fraction(s[0], 100), Fraction(sum(s), 100)))
inside = st.fractions(0, 1, max_denominator=1000)


@given(sides, sides, inside, inside)
def test_a_centred_form_holds_every_value_and_no_more_than_twice_the_width(first, second, s, t):
    """For f = (x y - y) sqrt(x) + 3 x over a cell, and over one whose sides are a thousandth of their distance."""
    with Ball(20).context():
        x, y = (low + (high - low) * part for (low, high), part in ((first, s), (second, t)))
        ranges = _form(first, second)
        exact = _value(x, y)
        assert ranges.value.contains(exact) or ranges.value.overlaps(exact)
        small = _form((x, x * Fraction(1001, 1000)), (y, y * Fraction(1001, 1000))).value
        corners = [_value(a, b) for a in (x, x * Fraction(1001, 1000)) for b in (y, y * Fraction(1001, 1000))]
        hull = corners[0].union(corners[1]).union(corners[2]).union(corners[3])
        assert small.rad() < 2 * hull.rad() + arb(10) ** -12


def _form(*sides):
    x, y = parameters(*sides)
    return (x * y - y) * x.sqrt() + x * x.constant(arb(3))


def _value(x, y):
    a, b = (arb(fmpq(one.numerator, one.denominator)) for one in (x, y))
    return (a * b - b) * a.sqrt() + a * 3
