"""Evidence for symbolic identities: the difference simplifies to 0, and vanishes at random rational points.

The points are the check of the simplifier: they do not use it.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator

import sympy as sp
from sympy.core.function import AppliedUndef

from paper_checks.evidence.evidence import Evidence, EvidenceKind

DIGITS = 60
"""Decimal digits at which a difference that is not rational at a point is evaluated."""
NEGLIGIBLE = sp.Float(10) ** (-DIGITS + 15)
"""Bound, dimensionless, below which such a difference counts as zero."""


def identity(
    statement: str,
    left: sp.Basic | int,
    right: sp.Basic | int = 0,
    *,
    seed: int = 0,
    points: int = 5,
    assumptions: tuple[str, ...] = (),
) -> Evidence:
    """Check that two sympy expressions, or matrices entry by entry, are equal for all their symbols' values.

    Passed is True where every entry of the difference simplifies to 0 and vanishes at `points` seeded random
    rational points that meet the symbols' assumptions; False where it is not zero at one of them (the value
    names it); None where the simplifier does not reach zero, or no point could be evaluated.
    """
    differences = list(_entries(left, right))
    randomness = random.Random(seed)
    tried, inexact = 0, 0
    for difference in differences:
        for point, value in _samples(difference, randomness, points):
            tried += 1
            inexact += not value.is_Rational
            if not _vanishes(value):
                where = ", ".join(f"{symbol} = {point[symbol]}" for symbol in sorted(point, key=str))
                text = f"difference {sp.N(value, 8)} at {where or 'no symbols'}"
                return _evidence(statement, False, tried, text, assumptions)
    zero = all(simplifies_to_zero(difference) for difference in differences)
    text = f"difference simplifies to 0; zero at {tried} rational points" if zero else "the simplifier does not reach 0"
    if zero and inexact:
        text += f" (to {DIGITS - 15} digits at {inexact} of them)"
    return _evidence(statement, True if zero else None, tried, text, assumptions)


def simplifies_to_zero(expression: sp.Expr) -> bool:
    """Say whether one of sympy's rewritings, cheapest first, turns the expression into 0."""
    for rewriting in (sp.expand, sp.cancel, sp.trigsimp, sp.simplify):
        try:
            if rewriting(expression) == 0:
                return True
        except sp.PolynomialError:  # cancel refuses piecewise expressions
            continue
    return False


def _evidence(statement: str, passed: bool | None, cases: int, value: str, assumptions: tuple[str, ...]) -> Evidence:
    return Evidence(EvidenceKind.EXACT, "sympy", statement, passed, cases, value, assumptions)


def _entries(left: sp.Basic | int, right: sp.Basic | int) -> Iterator[sp.Expr]:
    if isinstance(left, sp.MatrixBase):
        yield from left - (sp.zeros(*left.shape) if right == 0 else right)
    else:
        yield sp.sympify(left) - sp.sympify(right)


def _samples(
    expression: sp.Expr, randomness: random.Random, points: int
) -> Iterable[tuple[dict[sp.Symbol, sp.Rational], sp.Expr]]:
    """Yield up to `points` rational points, with the expression's finite values there.

    A function that is only named is stood in for by a known one: what differs for one function is no identity.
    """
    expression = expression.replace(lambda part: isinstance(part, AppliedUndef), _stand_in)
    symbols = sorted(expression.free_symbols, key=str)
    found = 0
    for _ in range(10 * points):
        point = {symbol: _rational(symbol, randomness) for symbol in symbols}
        value = expression.subs(point)
        if value.is_finite is False or value.has(sp.nan, sp.zoo, sp.oo):
            continue  # a pole of the expression
        yield point, value
        found += 1
        if found == points:
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


def _vanishes(value: sp.Expr) -> bool:
    if value.is_Rational:
        return bool(value == 0)
    return bool(abs(value.evalf(DIGITS)) < NEGLIGIBLE)
