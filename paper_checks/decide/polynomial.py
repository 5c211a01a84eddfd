"""Rational expressions made polynomial for the SMT solvers: denominators with a manifest sign are cleared."""

from __future__ import annotations

import sympy as sp


def cleared(expression: sp.Expr) -> sp.Expr:
    """Return the numerator of an expression whose denominator is positive by the assumptions on its symbols.

    The sign of the result is the sign of the expression. Raises ValueError where that is not manifest.
    """
    numerator, denominator = sp.fraction(sp.together(expression))
    if not denominator.is_positive:
        raise ValueError(f"the denominator {denominator} is not manifestly positive; clear it by hand")
    return sp.expand(numerator)
