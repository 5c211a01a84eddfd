"""Evidence at one point, in exact rational arithmetic: how a counterexample is shown to be real."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from paper_checks.decide.polynomial import RELATIONAL
from paper_checks.evidence.clause import RELATIONS, decimal_places
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.formula import latex, pointed
from theory.symbols import put

Point = Mapping[sp.Symbol, "sp.Rational | int"]
"""Exact values of symbols, SI units; anything but a rational is refused."""

Relation = tuple["sp.Expr | int", str, "sp.Expr | int"]
"""Left side, one of < <= = != >= >, right side."""

ENGINE = "rational arithmetic"


def exhibit(statement: str, point: Point, *relations: Relation) -> Evidence:
    """Check that all relations hold at a rational point; the value shows both sides of each there.

    Passed is True where they hold, False where one fails, None where a side is no rational number there (a symbol
    without a value) or there is no relation. Raises TypeError for an inexact value, KeyError for another operator.
    """
    values = {symbol: sp.sympify(value) for symbol, value in point.items()}
    for symbol, value in values.items():
        if not value.is_Rational:
            raise TypeError(f"{symbol} = {value} is not a rational number: write sp.Rational('0.006')")
    answers, texts = [], []
    for left, relation, right in relations:
        sides = [_value(sp.sympify(side), values) for side in (left, right)]
        rational = all(side.is_Rational for side in sides)
        answers.append(bool(RELATIONAL[relation](*sides)) if rational else None)
        shown = [_decimal(side) if side.is_Rational else latex(side) for side in sides]
        texts.append(f"${shown[0]}{RELATIONS[relation].strip()} {shown[1]}$")
    passed = False if False in answers else None if None in answers or not answers else True
    return Evidence(EvidenceKind.EXACT, ENGINE, statement, passed, len(relations), ", ".join(texts))


def value_at(expression: sp.Expr, point: Point) -> str:
    """Return the exact value of an expression at a point as a decimal, or as a fraction where no decimal ends.

    Raises ValueError where it is no rational number there.
    """
    value = _value(expression, point)
    if not value.is_Rational:
        raise ValueError(f"{expression} has no rational value at the point: {value}")
    return _decimal(value)


def _value(expression: sp.Expr, point: Point) -> sp.Expr:
    """Return an expression at a point: a rational number, where it can be brought to one."""
    value = put(expression, point)
    return value if value.is_Rational else sp.simplify(value)


def _decimal(value: sp.Rational) -> str:
    """Return a rational number as a decimal, or as a fraction where no decimal ends."""
    places = decimal_places(value)
    units = value * 10**places
    return pointed(int(units), places) if units.is_Integer else str(value)
