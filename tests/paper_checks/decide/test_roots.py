"""Roots in balls: both ends of the bracket are proved, and no root is made up."""

import pytest
from flint import arb

from paper_checks.decide.balls import precision
from paper_checks.decide.roots import enclosed_root


@pytest.mark.parametrize("sign", [1, -1])
def test_a_root_is_inside_its_ball(sign):
    with precision():
        found = enclosed_root(lambda x: sign * (x * x - 2), 1, 2, 20)
        assert found.contains(arb(2).sqrt())
        assert found.rad() < arb(10) ** -22


@pytest.mark.parametrize(
    ("function", "said"),
    [
        (lambda x: x * x + 1, "no change of sign"),
        (lambda x: x - 1, "the sign at 1 is not decided"),
        (lambda x: 2 * x - 3, "the sign at 3/2 is not decided"),
    ],
)
def test_a_sign_that_does_not_change_or_is_open_is_no_root(function, said):
    with pytest.raises(ArithmeticError, match=said):
        enclosed_root(function, 1, 2)
