"""Rational expressions as quotients of polynomials without a common factor: exact, much quicker than sympy's `cancel`.

Sympy expands whole numerators and denominators before it looks for common factors; here every sum and product on the
way is reduced at once, in a field of fractions.
"""

from collections.abc import Mapping
from functools import cache
from typing import Any

from sympy import ZZ, Expr, Rational, factor
from sympy.polys.fields import FracField


@cache
def in_lowest_terms(expression: Expr) -> Expr:
    """The expression as `cancel` writes it, a quotient of expanded polynomials; exact.

    Its letters are what is no sum, product or whole power: symbols, roots, sines. Nothing is known of these but that
    each is another one. Raises ZeroDivisionError where the expression divides by 0.
    """
    letters = sorted(_letters(expression), key=str)
    if not letters:
        return expression
    field = FracField(letters, ZZ)
    found = _value(expression, dict(zip(letters, field.gens, strict=True)), field)
    return found.numer.as_expr() / found.denom.as_expr()


@cache
def factored(expression: Expr) -> Expr:
    """The expression in lowest terms, numerator and denominator as products; exact."""
    return factor(in_lowest_terms(expression))


def _letters(part: Expr) -> dict[Expr, None]:
    if part.is_Rational:
        return {}
    if part.is_Add or part.is_Mul:
        return {letter: None for one in part.args for letter in _letters(one)}
    return _letters(part.base) if part.is_Pow and part.exp.is_Integer else {_root(part): None}


def _root(part: Expr) -> Expr:
    """The root of which a fractional power is a whole one; anything else itself."""
    return part.base ** Rational(1, part.exp.q) if part.is_Pow and part.exp.is_Rational else part


def _value(part: Expr, letters: Mapping[Expr, Any], field: FracField) -> Any:
    if part.is_Rational:
        return field(int(part.p)) / int(part.q)
    if part.is_Add or part.is_Mul:
        total, *others = (_value(one, letters, field) for one in part.args)
        for other in others:
            total = total + other if part.is_Add else total * other
        return total
    if part.is_Pow and part.exp.is_Integer:
        return _value(part.base, letters, field) ** int(part.exp)
    return letters[_root(part)] ** (int(part.exp.p) if part.is_Pow and part.exp.is_Rational else 1)
