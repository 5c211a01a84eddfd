"""Evidence for symbolic identities: left minus right simplifies to 0, and is 0 at random rational points.

The points are the check of the simplifier: they use neither the normal form nor sympy's rewriting.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import Any, TypeAlias

import sympy as sp
from flint import acb, arb, fmpq
from sympy.core.function import AppliedUndef

from paper_checks.decide.at_point import NotEvaluatedError, Value, at_point
from paper_checks.decide.balls import precision
from paper_checks.decide.normal_form import is_zero
from paper_checks.evidence.evidence import Evidence, EvidenceKind

Side: TypeAlias = "sp.Basic | int | Sequence[Any]"
"""An expression, or a list or matrix of sides."""
_MANY = sp.MatrixBase | list | tuple
NORMAL_FORM, SYMPY = "normal form", "sympy"
"""What decides: `normal_form`, over FLINT's polynomials, or where that does not reach 0 one of sympy's rewritings."""
POINTS = 5
DIGITS = 45
"""Digits after the point to which a difference that is not rational at a point is enclosed."""


def identity(statement: str, left: Side, right: Side = 0) -> Evidence:
    """Check that two sympy expressions, or lists or matrices entry by entry, are equal for all their symbols' values.

    One expression on the right stands beside each entry on the left.

    Passed is True where every entry of the difference simplifies to 0 and vanishes at `POINTS` seeded random
    rational points that meet the symbols' assumptions; False where it is not zero at one of them (the value
    names it); None where the simplifier does not reach zero, or no point could be evaluated.
    """
    lefts = _entries(left)
    rights = _entries(right if isinstance(right, _MANY) else [right] * len(lefts))
    differences = [one - other for one, other in zip(lefts, rights, strict=True)]
    randomness = random.Random(0)
    tried, inexact, unseen = 0, 0, 0
    for difference in differences:
        before = tried
        for point, value in _samples(difference, randomness):
            tried += 1
            inexact += not isinstance(value, fmpq)
            if not _vanishes(value):
                where = ", ".join(f"{symbol} = {point[symbol]}" for symbol in sorted(point, key=str))
                text = f"difference {_shown(value)} at {where or 'no symbols'}"
                return _evidence(statement, False, tried, text)
        unseen += tried == before
    if unseen:
        return _evidence(statement, None, tried, f"{unseen} of the differences could be evaluated nowhere")
    zero = all(simplifies_to_zero(difference) for difference in differences)
    text = (
        f"left minus right simplifies to 0, and is 0 at {tried} test points"
        if zero
        else "the simplifier does not reach 0"
    )
    if zero and inexact:
        text += f" (to {DIGITS} digits at {inexact} of them)"
    engine = NORMAL_FORM if zero and all(map(is_zero, differences)) else SYMPY
    return _evidence(statement, True if zero else None, tried, text, engine)


def simplifies_to_zero(expression: sp.Expr) -> bool:
    """Say whether the expression is 0 by its normal form, or one of sympy's rewritings, cheapest first, makes it 0."""
    if is_zero(expression):
        return True
    for rewriting in (_with_simple_roots, sp.cancel, sp.trigsimp, sp.simplify):
        try:
            if rewriting(expression) == 0:
                return True
        except sp.PolynomialError:  # cancel refuses piecewise expressions
            continue
    return False


def _with_simple_roots(expression: sp.Expr) -> sp.Expr:
    """Return the expression with 1 - cos^2 for sin^2 in what its roots are taken of."""

    def rooted(part: sp.Expr) -> sp.Expr:
        squares = {one**2: 1 - sp.cos(one.args[0]) ** 2 for one in part.base.atoms(sp.sin)}
        return sp.expand(part.base.xreplace(squares)) ** part.exp

    return expression.replace(lambda part: part.is_Pow and part.exp.is_Rational and not part.exp.is_Integer, rooted)


def _evidence(statement: str, passed: bool | None, cases: int, value: str, engine: str = SYMPY) -> Evidence:
    return Evidence(EvidenceKind.EXACT, engine, statement, passed, cases, value)


def _entries(side: Side) -> list[sp.Expr]:
    if isinstance(side, _MANY):
        return [entry for part in side for entry in _entries(part)]
    return [sp.sympify(side)]


def _samples(expression: sp.Expr, randomness: random.Random) -> Iterable[tuple[dict[sp.Symbol, sp.Rational], Value]]:
    """Yield up to `POINTS` rational points, with the expression's finite values there: exact, or in balls.

    A function that is only named is stood in for by a known one: what differs for one function is no identity.
    """
    if expression.has(AppliedUndef):
        expression = expression.replace(lambda part: isinstance(part, AppliedUndef), _stand_in)
    symbols = sorted(expression.free_symbols, key=str)
    found = 0
    for _ in range(10 * POINTS):
        point = {symbol: _rational(symbol, randomness) for symbol in symbols}
        value = _value(expression, tuple(point.items()))
        if value is None:
            continue  # a pole of the expression
        yield point, value
        found += 1
        if found == POINTS:
            return


def _stand_in(named: sp.Expr) -> sp.Expr:
    """Return a positive function of the same arguments that is none of the usual ones; another name, another function."""
    number = 2 + sum(map(ord, str(named.func)))
    return sp.Integer(1) / number + sum((1 / (number + one**2) for one in named.args), sp.Integer(0))


def _rational(symbol: sp.Symbol, randomness: random.Random) -> sp.Rational:
    """Return a random rational that meets what sympy assumes of the symbol."""
    denominator = 1 if symbol.is_integer else randomness.randint(2, 50)
    size = sp.Rational(randomness.randint(1, 100), denominator)
    if symbol.is_nonnegative:
        return size
    if symbol.is_nonpositive:
        return -size
    return size * randomness.choice((-1, 1))


@lru_cache(maxsize=5000)  # steps of several claims say the same
def _value(expression: sp.Expr, point: tuple[tuple[sp.Symbol, sp.Rational], ...]) -> Value | None:
    """Return the value at a point, exact or enclosed to `DIGITS`; None at a pole, or where it is not known so well."""
    for digits in (DIGITS, 10 * DIGITS):
        try:
            with precision(digits):
                value = at_point(expression, dict(point))
        except (ZeroDivisionError, NotEvaluatedError):
            return None
        if isinstance(value, fmpq) or _radius(value) < arb(10) ** -DIGITS:
            return value
    return None


def _radius(value: arb | acb) -> arb:
    return value.real.rad() + value.imag.rad()


def _vanishes(value: Value) -> bool:
    """Say whether a value is 0 or may be: a ball without 0 in it is proved not to be."""
    return bool(value == 0) if isinstance(value, fmpq) else bool(value.contains(0))


def _shown(value: Value) -> str:
    if isinstance(value, fmpq):
        return str(sp.N(sp.Rational(int(value.p), int(value.q)), 8))
    return str(value.str(8, radius=False))
