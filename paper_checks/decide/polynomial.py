"""Rational expressions made polynomial for the SMT solvers: denominators with a manifest sign are cleared."""

from __future__ import annotations

import sympy as sp

from paper_checks.decide.normal_form import fraction


def cleared(expression: sp.Expr) -> sp.Expr:
    """Return the numerator of an expression whose denominator is positive by the assumptions on its symbols.

    The sign of the result is the sign of the expression. Raises ValueError where that is not manifest.
    """
    numerator, denominator = fraction(expression)
    if (-denominator).is_positive:
        return -numerator
    if not denominator.is_positive:
        raise ValueError(f"the denominator {denominator} is not manifestly positive; clear it by hand")
    return numerator


RELATIONAL = {"=": sp.Eq, "!=": sp.Ne, "<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}


def signed(expression: sp.Expr, relation: str) -> sp.Rel:
    """Return `expression relation 0`, its denominator cleared, and left as it stands by sympy.

    >>> x = sp.Symbol("x", positive=True)
    >>> signed(x - 1 / x, "<=")
    x**2 - 1 <= 0
    """
    return RELATIONAL[relation](cleared(expression), 0, evaluate=False)
