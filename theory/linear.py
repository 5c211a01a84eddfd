"""The root of an equation that is linear in its unknown: exact, and much quicker than sympy's general `solve`."""

from sympy import Expr, Symbol, cancel, diff


def root(expression: Expr, unknown: Symbol) -> Expr:
    """The one value of the unknown for which the expression is 0.

    Raises ValueError for an expression that is not linear in the unknown, or in which it is not.
    """
    slope = cancel(diff(expression, unknown))
    if slope == 0 or slope.has(unknown):
        raise ValueError(f"{expression} is not linear in {unknown}")
    return cancel(-expression.subs(unknown, 0) / slope)
