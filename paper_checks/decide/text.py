"""Polynomial statements over the reals, from sympy to SMT-LIB 2 text (logic QF_NRA), exactly."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from paper_checks.errors import NotPolynomialError

_RELATIONS = {
    sp.StrictGreaterThan: ">",
    sp.GreaterThan: ">=",
    sp.StrictLessThan: "<",
    sp.LessThan: "<=",
    sp.Equality: "=",
}
_CONNECTIVES = {sp.And: "and", sp.Or: "or", sp.Not: "not", sp.Implies: "=>", sp.Equivalent: "="}


def script(statements: Iterable[sp.Basic], also: Iterable[sp.Symbol] = ()) -> str:
    """Return the SMT-LIB 2 text that declares the symbols, `also` those, and asserts each statement.

    What sympy assumes of a symbol (positive, non-negative, ...) is asserted too, so that solver and sympy
    speak of the same reals. Raises NotPolynomialError for whatever is not an exact polynomial statement over
    the reals.
    """
    formulas = list(statements)
    symbols = sorted(set(also).union(*(formula.free_symbols for formula in formulas)), key=lambda symbol: symbol.name)
    names = [symbol.name for symbol in symbols]
    if len(set(names)) != len(names):
        raise NotPolynomialError(f"two symbols of one name and different assumptions among {', '.join(names)}")
    lines = ["(set-logic QF_NRA)"]
    lines += [f"(declare-const {_name(symbol)} Real)" for symbol in symbols]
    lines += [f"(assert {fact})" for symbol in symbols for fact in _facts(symbol)]
    lines += [f"(assert {boolean(formula)})" for formula in formulas]
    return "\n".join(lines) + "\n"


def boolean(formula: sp.Basic) -> str:
    """Return the text of a relational or of a Boolean combination of relationals."""
    if formula in (sp.true, sp.false):
        return str(bool(formula)).lower()
    if isinstance(formula, sp.Unequality):
        return f"(not (= {term(formula.lhs)} {term(formula.rhs)}))"
    if formula.func in _RELATIONS:
        return f"({_RELATIONS[formula.func]} {term(formula.lhs)} {term(formula.rhs)})"
    if formula.func in _CONNECTIVES:
        return f"({_CONNECTIVES[formula.func]} {' '.join(boolean(part) for part in formula.args)})"
    raise NotPolynomialError(f"{formula} is neither a relation nor a Boolean combination of relations")


def term(expression: sp.Basic) -> str:
    """Return the text of a polynomial with rational coefficients; absolute values are allowed."""
    if isinstance(expression, sp.Rational):
        return _rational(expression)
    if isinstance(expression, sp.Symbol):
        return _name(expression)
    if isinstance(expression, sp.Add | sp.Mul):
        operator = "+" if isinstance(expression, sp.Add) else "*"
        return f"({operator} {' '.join(term(part) for part in expression.args)})"
    if isinstance(expression, sp.Abs):
        inside = term(expression.args[0])
        return f"(ite (>= {inside} 0.0) {inside} (- {inside}))"
    if isinstance(expression, sp.Pow):
        return _power(expression)
    raise NotPolynomialError(f"{expression} ({type(expression).__name__}) is not an exact polynomial")


def _power(expression: sp.Pow) -> str:
    base, exponent = expression.args
    if not (isinstance(exponent, sp.Integer) and exponent > 0):
        raise NotPolynomialError(f"the power {expression} is not polynomial: clear denominators, name roots as symbols")
    factor = term(base)
    return f"(* {' '.join([factor] * int(exponent))})"


def _rational(number: sp.Rational) -> str:
    size = f"{abs(number.p)}.0" if number.q == 1 else f"(/ {abs(number.p)}.0 {number.q}.0)"
    return f"(- {size})" if number < 0 else size


def _name(symbol: sp.Symbol) -> str:
    if not symbol.is_extended_real:
        raise NotPolynomialError(f"the symbol {symbol} is not declared real")
    if "|" in symbol.name or "\\" in symbol.name:
        raise NotPolynomialError(f"the symbol {symbol} has a name that SMT-LIB cannot quote")
    return f"|{symbol.name}|"


def _facts(symbol: sp.Symbol) -> list[str]:
    """Return what sympy assumes of the symbol, as SMT-LIB formulas."""
    if symbol.is_integer:
        raise NotPolynomialError(f"the symbol {symbol} is an integer; only reals are translated")
    name = _name(symbol)
    if symbol.is_zero:
        return [f"(= {name} 0.0)"]
    for holds, relation in (
        (symbol.is_positive, ">"),
        (symbol.is_negative, "<"),
        (symbol.is_nonnegative, ">="),
        (symbol.is_nonpositive, "<="),
    ):
        if holds:
            return [f"({relation} {name} 0.0)"]
    return [f"(not (= {name} 0.0))"] if symbol.is_nonzero else []
