"""The root of an equation that is linear in its unknown: exact, and much quicker than sympy's general `solve`."""

from sympy import Expr, Symbol, diff

from theory.fraction import in_lowest_terms


def root(expression: Expr, unknown: Symbol) -> Expr:
    """The one value of the unknown for which the expression is 0.

    Raises ValueError for an expression that is not linear in the unknown, or in which it is not.
    """
    slope = in_lowest_terms(diff(expression, unknown))
    if slope == 0 or slope.has(unknown):
        raise ValueError(f"{expression} is not linear in {unknown}")
    return in_lowest_terms(-expression.subs(unknown, 0) / slope)
