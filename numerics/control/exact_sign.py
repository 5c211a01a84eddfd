"""Whether a polynomial with rational coefficients is >= 0 on an interval, decided exactly, double zeros included."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from flint import fmpq, fmpq_poly


def is_never_negative(coefficients: Sequence[Fraction], length: Fraction) -> bool:
    """Return whether sum c_k t^k >= 0 for all 0 <= t <= length; exact, by Sturm's theorem.

    >>> is_never_negative([Fraction(1), Fraction(-2), Fraction(1)], Fraction(2))  # (1 - t)^2
    True
    >>> is_never_negative([Fraction(1), Fraction(-2), Fraction(999, 1000)], Fraction(2))
    False
    """
    polynomial, end = fmpq_poly([_rational(one) for one in coefficients]), _rational(length)
    if polynomial.is_zero():
        return True
    _, factors = polynomial.factor_squarefree()
    if any(power % 2 == 1 and _zeros_inside(factor, end) for factor, power in factors):
        return False
    # it keeps its sign inside, and one of so many points is no zero
    points = [end * k / (polynomial.degree() + 2) for k in range(1, polynomial.degree() + 2)]
    return all(polynomial(one) >= 0 for one in points)


def _rational(value: Fraction) -> fmpq:
    return fmpq(value.numerator, value.denominator)


def _zeros_inside(polynomial: fmpq_poly, end: fmpq) -> int:
    """Return how many zeros a polynomial without double zeros has in 0 < t < end."""
    chain = [polynomial, polynomial.derivative()]
    while chain[-1].degree() > 0:
        chain.append(-(chain[-2] % chain[-1]))

    def changes(at: fmpq) -> int:
        signs = [value > 0 for one in chain if (value := one(at)) != 0]
        return sum(one != two for one, two in pairwise(signs))

    return changes(fmpq(0)) - changes(end) - int(polynomial(end) == 0)
