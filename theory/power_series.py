"""Taylor polynomials at 0 by truncated power series: exact, and much quicker than sympy's general `series`."""

from collections.abc import Sequence
from functools import cache
from math import factorial
from typing import Any

from sympy import (
    QQ,
    Dummy,
    Expr,
    Integer,
    Piecewise,
    Poly,
    PolynomialError,
    Pow,
    Symbol,
    cos,
    expand,
    fraction,
    pi,
    series,
    sin,
    sqrt,
)
from sympy.polys.polyerrors import CoercionFailed

from theory.fraction import in_lowest_terms
from theory.symbols import put

_SPARE = 12
"""Orders that a zero of the denominator may take away."""


@cache
def taylor(expression: Expr, variable: Symbol, order: int) -> Expr:
    """Taylor polynomial at 0 below variable**order.

    For a quotient of polynomials in the variable, its sine and its cosine by power series over the field of all other
    symbols and their square roots; for anything else, or at a pole, by sympy's `series`. Raises ValueError for an
    expression by cases, on which `series` may not end.
    """
    if (found := _by_division(expression, variable, order)) is not None:
        return found
    if expression.has(Piecewise):
        raise ValueError(f"{expression} is given by cases; give one case, for a Taylor polynomial of one formula")
    return expand(series(expression, variable, 0, order).removeO())


def reverted(inner: Expr, variable: Symbol, order: int, outer: Expr) -> list[Expr]:
    """Coefficients below u**order of `outer`, where u = `inner`, which is 0 at 0, with a slope, and rational: exact.

    The coefficient of u^n is that of x^(n - 1) in outer'(x) (x/inner(x))^n/n (Lagrange). Raises ValueError where
    one of both is no quotient of power series: sympy's `series` may not end there.
    """
    given, slopes = _by_division(inner, variable, order + 1), _by_division(outer, variable, order)
    if given is None or slopes is None:
        raise ValueError(f"{inner} and {outer} are not both quotients of power series in {variable}, finite at 0")
    bottom = [QQ.from_sympy(given.coeff(variable, n + 1)) for n in range(order)]
    quotient = _divided([QQ(1), *[QQ(0)] * (order - 1)], bottom, order)
    power, found = quotient, [slopes.coeff(variable, 0)]
    for n in range(1, order):
        terms = (QQ.to_sympy(power[n - k] * k / n) * slopes.coeff(variable, k) for k in range(1, n + 1))
        found.append(expand(sum(terms, Integer(0))))
        power = _product(power, quotient)
    return found


def composed(outer: Expr, variable: Symbol, order: int, inner: Expr) -> Expr:
    """Taylor polynomial below variable**order of `outer` at `inner`, a polynomial in the variable that is 0 at 0."""
    argument, end = Poly(inner, variable, field=True), Poly(variable**order, variable)
    coefficients = taylor(outer, variable, order)
    value = Poly(0, variable, domain=argument.domain)
    for power in reversed(range(order)):
        value = (value * argument + coefficients.coeff(variable, power)).rem(end)
    return sum((expand(one) * variable**n for (n,), one in reversed(value.terms())), Integer(0))


def _by_division(expression: Expr, variable: Symbol, order: int) -> Expr | None:
    sine, cosine, half_turn = Dummy("sine"), Dummy("cosine"), Dummy("pi", positive=True)
    roots = {}
    if any(not one.exp.is_Integer for one in expression.atoms(Pow)):
        roots = {one: Dummy(one.name, positive=True) for one in expression.free_symbols - {variable} if one.is_positive}
    unknown = expression.xreplace({sin(variable): sine, cos(variable): cosine, pi: half_turn})
    unknown = unknown.subs({one: root**2 for one, root in roots.items()})
    letters = sorted(unknown.free_symbols - {variable, sine, cosine}, key=str)
    field = QQ.frac_field(*letters) if letters else QQ
    length = order + _SPARE
    unit = [QQ(1), *[QQ(0)] * (length - 1)]
    powers = [[unit, one] for one in _circle(length)]
    try:
        top, bottom = (
            _value(Poly(part, variable, sine, cosine, domain=field), powers, length)
            for part in fraction(in_lowest_terms(unknown))
        )
    except (PolynomialError, CoercionFailed):
        return None
    zeros = next((place for place, one in enumerate(bottom) if one), length)
    if zeros > _SPARE or any(top[:zeros]):
        return None
    quotient = _divided(top[zeros:], bottom[zeros:], order)
    back = {half_turn: pi} | {root: sqrt(one) for one, root in roots.items()}
    return expand(sum((put(field.to_sympy(one), back) * variable**n for n, one in enumerate(quotient)), Integer(0)))


def _circle(length: int) -> list[list[Any]]:
    """The coefficients of sine and cosine."""
    return [[QQ(signs[n % 4], factorial(n)) for n in range(length)] for signs in ((0, 1, 0, -1), (1, 0, -1, 0))]


def _power(powers: list[list[Any]], exponent: int) -> list[Any]:
    """A power of a series; `powers` has its powers 0 and 1, and keeps the others."""
    while len(powers) <= exponent:
        powers.append(_product(powers[-1], powers[1]))
    return powers[exponent]


def _value(polynomial: Poly, powers: Sequence[list[list[Any]]], length: int) -> list[Any]:
    """A polynomial in variable, sine and cosine as a series."""
    field = polynomial.domain
    found = [field.zero] * length
    for (shift, of_sine, of_cosine), factor in polynomial.rep.to_dict().items():
        term = _product(_power(powers[0], of_sine), _power(powers[1], of_cosine))
        for n, one in enumerate(term[: max(0, length - shift)]):
            if one:
                found[n + shift] += factor * field.convert(one, QQ)
    return found


def _product(one: Sequence[Any], other: Sequence[Any]) -> list[Any]:
    return [sum(one[m] * other[n - m] for m in range(n + 1)) for n in range(len(one))]


def _divided(top: Sequence[Any], bottom: Sequence[Any], order: int) -> list[Any]:
    """The first coefficients of a quotient of series; the bottom one does not begin with 0."""
    found: list[Any] = []
    for n in range(order):
        rest = sum((found[m] * bottom[n - m] for m in range(n) if bottom[n - m]), top[n] * 0)
        found.append((top[n] - rest) / bottom[0])
    return found
