"""Expressions of sympy as terms of Gallina, the language of the proof kernel."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from theory.symbols import sgn

FUNCTIONS = {
    sp.sin: "(sin {0})",
    sp.cos: "(cos {0})",
    sp.cot: "(cos {0} / sin {0})",
    sp.tan: "(tan {0})",
    sp.Abs: "(Rabs {0})",
    sgn: "(Switching.sgn {0})",
}
CONSTANTS = {sp.pi: "PI"}


def term(expression: sp.Expr, names: Mapping[sp.Symbol, str]) -> str:
    """The expression with symbols written as `names` says. Raises TypeError for what has no exact form."""
    if known := names.get(expression) or CONSTANTS.get(expression):
        return known
    if expression.is_Rational:
        return _rational(expression)
    if expression.is_Pow:
        return _power(expression.base, expression.exp, names)
    parts = [term(part, names) for part in expression.args]
    if expression.is_Add or expression.is_Mul:
        return f"({(' + ' if expression.is_Add else ' * ').join(parts)})"
    if expression.func in FUNCTIONS:
        return FUNCTIONS[expression.func].format(*parts)
    raise TypeError(f"no Gallina for {sp.srepr(expression)}")


def _rational(number: sp.Rational) -> str:
    if number.q == 1:
        return f"({number.p})" if number.p < 0 else str(number.p)
    return f"({number.p} / {number.q})"


def _power(base: sp.Expr, exponent: sp.Expr, names: Mapping[sp.Symbol, str]) -> str:
    if not (exponent.is_Rational and exponent.q in {1, 2}):
        raise TypeError(f"no Gallina for the power {sp.srepr(exponent)}")
    root = term(base, names) if exponent.q == 1 else f"(sqrt {term(base, names)})"
    raised = root if abs(exponent.p) == 1 else f"({root} ^ {abs(exponent.p)})"
    return raised if exponent > 0 else f"(/ {raised})"
