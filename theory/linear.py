"""Roots of equations that are linear in their unknowns: exact, and much quicker than sympy's general `solve`."""

from collections.abc import Sequence

from sympy import Expr, Symbol, fraction

from theory.fraction import in_lowest_terms


def root(expression: Expr, unknown: Symbol) -> Expr:
    """The one value of the unknown for which the expression is 0.

    Raises ValueError for an expression that is not linear in the unknown, or in which it is not.
    """
    above, below = fraction(in_lowest_terms(expression))
    slope, rest = above.coeff(unknown, 1), above.coeff(unknown, 0)
    if slope == 0 or (slope * unknown + rest - above).expand() != 0 or (slope + rest + below).has(unknown):
        raise ValueError(f"{expression} is not linear in {unknown}")
    return in_lowest_terms(-rest / slope)


def roots(expressions: Sequence[Expr], unknowns: Sequence[Symbol]) -> tuple[Expr, Expr]:
    """The values of two unknowns for which two expressions are 0: the first is eliminated by the first expression.

    Raises ValueError, as `root`.
    """
    (one, other), (first, second) = expressions, unknowns
    eliminated = root(one, first)
    last = root(other.subs(first, eliminated), second)
    return in_lowest_terms(eliminated.subs(second, last)), last
