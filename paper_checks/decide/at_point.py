"""The value of an expression at a rational point, without sympy's rewriting: an exact rational, or a ball around it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from operator import mul
from typing import Any, TypeAlias

import sympy as sp
from flint import acb, arb, fmpq

Value: TypeAlias = "fmpq | arb | acb"
"""A rational while all that it is made of is rational; else a ball, a complex one beyond roots of negative numbers."""


class NotEvaluatedError(ArithmeticError):
    """A function that has no value here."""


def at_point(expression: sp.Expr, point: Mapping[sp.Symbol, sp.Rational | Value]) -> Value:
    """Return the value at a point, at flint's precision; where a coordinate is a ball, a ball around all values on it.

    Raises ZeroDivisionError at an exact pole, NotEvaluatedError for a function that is not known. A ball that is not
    finite says that there may be a pole.
    """
    known: dict[sp.Basic, Value] = {
        symbol: fmpq(int(one.p), int(one.q)) if isinstance(one, sp.Rational) else one for symbol, one in point.items()
    }

    def value(part: sp.Expr) -> Value:
        if part not in known:
            known[part] = _combined(part, value)
        return known[part]

    return value(expression)


def _combined(part: sp.Expr, value: Callable[[sp.Expr], Value]) -> Value:
    if part.is_Rational:
        return fmpq(int(part.p), int(part.q))
    if part in _CONSTANTS:
        return _CONSTANTS[part]()
    values = [value(one) for one in part.args]
    if part.is_Add:
        return sum(values[1:], values[0])
    if part.is_Mul:
        return reduce(mul, values)
    if part.is_Pow:
        return _power(*values)
    if part.func not in _FUNCTIONS:
        raise NotEvaluatedError(f"{part.func} is not evaluated at a point")
    return _FUNCTIONS[part.func](*values)


def _power(base: Value, exponent: Value) -> Value:
    if isinstance(exponent, fmpq) and exponent.q == 1:
        return base ** int(exponent.p)
    ball = _ball(base)
    if isinstance(ball, arb) and not ball >= 0:
        ball = acb(ball)
    return ball ** _ball(exponent)


def _ball(value: Value) -> arb | acb:
    return arb(value) if isinstance(value, fmpq) else value


def _least(left: Value, right: Value) -> Value:
    if isinstance(left, acb) or isinstance(right, acb):
        raise NotEvaluatedError("complex numbers have no order")
    return arb(left).min(arb(right))


_CONSTANTS: dict[sp.Basic, Callable[[], Value]] = {sp.pi: arb.pi, sp.E: arb.const_e, sp.I: lambda: acb(0, 1)}
_FUNCTIONS: dict[Any, Callable[..., Value]] = {
    sp.sin: lambda one: _ball(one).sin(),
    sp.cos: lambda one: _ball(one).cos(),
    sp.tan: lambda one: _ball(one).tan(),
    sp.cot: lambda one: _ball(one).cot(),
    sp.atan: lambda one: _ball(one).atan(),
    sp.acot: lambda one: (1 / _ball(one)).atan(),
    sp.exp: lambda one: _ball(one).exp(),
    sp.log: lambda one: _ball(one).log(),
    sp.Abs: abs,
    sp.floor: lambda one: fmpq(one.floor()) if isinstance(one, fmpq) else one.floor(),
    sp.ceiling: lambda one: fmpq(one.ceil()) if isinstance(one, fmpq) else one.ceil(),
    sp.Min: lambda *all: reduce(_least, all),
    sp.Max: lambda *all: -reduce(_least, (-one for one in all)),
}
