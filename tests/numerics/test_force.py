"""A force and a friction in time are read exactly, and what describes none is refused in one line."""

from fractions import Fraction

import pandas
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from strategies import MODERATE, decimals, forces, signed

from numerics import Force
from numerics.scene.decimals import decimal_text, exact_decimal

TIMES = st.integers(0, 40).map(lambda k: Fraction(k, 3))


@given(forces(), forces(), TIMES, st.sampled_from([-1, 1]), signed(decimals(*MODERATE)))
def test_a_sum_and_a_multiple_of_forces_are_those_of_their_values_on_both_sides_of_a_jump(f, g, t, side, factor):
    value = float(factor) * float(f(t, side)) - float(g(t, side))
    assert (factor * f - g)(t, side) == pytest.approx(value, rel=1e-9, abs=1e-6)


def test_samples_may_be_columns_of_a_table():
    table = pandas.DataFrame({"t": [0, 1, 2], "u": [0.0, 1.0, 0.5]})
    assert Force.samples(table["t"], table["u"]) == Force.samples([0, 1, 2], [0, 1, 0.5])


@given(forces())
def test_a_piece_that_is_moved_is_the_same_function_exactly(f):
    for piece in f.pieces:
        assert piece.moved(piece.start + Fraction(7, 3)).moved(piece.start) == piece


TRAPEZOIDS = {
    Force.trapezoid(1, 2, 1, "0.5", 3): {1: "0 0", 2: "1.5 1.5", 3: "3 3", 4: "3 3", "4.25": "1.5 1.5", 5: "0 0"},
    Force.trapezoid(0, 0, 1, 0, 3): {0: "0 3", "0.5": "3 3", 1: "3 0"},
}


@pytest.mark.parametrize("force", TRAPEZOIDS)
def test_a_trapezoid_is_what_it_says_on_both_sides_of_a_time(force):
    for t, values in TRAPEZOIDS[force].items():
        assert [force(t, side) for side in (-1, 1)] == [*map(Fraction, values.split())]


@given(signed(decimals(-300, 300, 30)))
@example(Fraction(0))
@example(Fraction(10) ** 1000)
@example(Fraction(1, 10**1000))
@example(Fraction(2**80, 3))
def test_every_number_survives_its_text(value):
    assert exact_decimal(decimal_text(value), "x1") == value
