"""How a formula of a clause is decided: from what theory derives, by solvers, in balls, or at a point."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

import sympy as sp
from flint import arb

from paper_checks.decide.balls import point
from paper_checks.decide.exact import identity
from paper_checks.decide.exhibit import Point, exhibit
from paper_checks.decide.polynomial import signed
from paper_checks.decide.smt import prove
from paper_checks.evidence.clause import Formula, decimal_places
from paper_checks.evidence.evidence import Evidence, EvidenceKind, enclosed
from theory.symbols import put

Derived = Callable[[], sp.Basic]
Decide = Callable[[Formula], Evidence]


def shown(formula: Formula) -> str:
    """Return the formula as the statement of its evidence."""
    return f"${formula.latex}$"


def equals(derived: Derived, where: Callable[[], Mapping[sp.Basic, sp.Basic]] = dict) -> Decide:
    """Decide `left = right`, or `left -> right`: what theory derives for the left side is the right side, for all values.

    `where` says what the letters of the right side stand for.
    """

    def decide(formula: Formula) -> Evidence:
        statement = f"{shown(formula)}, as derived"
        if formula.relation not in ("=", "->"):
            return Evidence(EvidenceKind.EXACT, "sympy", statement, None, value="only an equality is derived")
        right = sp.sympify(formula.right)
        return identity(statement, derived(), put(right, where()))

    return decide


def equal(
    left: sp.Basic | str,
    right: sp.Basic | int,
    derived: Derived,
    where: Callable[[], Mapping[sp.Basic, sp.Basic]] = dict,
    *,
    relation: str = "=",
) -> Formula:
    """Return the formula `left = right`, which is decided by what theory derives for the left side."""
    return Formula(left, relation, right, equals(derived, where))


tends = partial(equal, relation="->")
"""The formula `left -> right`, which is decided by the limit that theory derives."""


def implied(
    given: Callable[[], Sequence[sp.Basic]] = list, where: Callable[[], Mapping[sp.Basic, sp.Basic]] = dict
) -> Decide:
    """Decide an inequality: the assumptions imply it, with what theory derives in the places of `where`."""

    def decide(formula: Formula) -> Evidence:
        difference = sp.sympify(formula.left) - sp.sympify(formula.right)
        conclusion = signed(put(difference, where()), formula.relation)
        return prove(shown(formula), given(), conclusion)

    return decide


def sharp(
    left: sp.Basic, relation: str, right: sp.Basic | int, derived: Callable[[], tuple[sp.Basic, str, sp.Basic | int]]
) -> Formula:
    """Return an inequality that is decided as a definition is: theory derives both of its sides and their relation."""

    def decide(formula: Formula) -> Evidence:
        one, sign, other = derived()
        same = identity(f"{shown(formula)}, as derived", [formula.left, formula.right], [one, other])
        return same if sign == formula.relation else replace(same, passed=False)

    return Formula(left, relation, right, decide, sharp=True)


def decimal(left: sp.Basic | str, right: str, value: Callable[[], arb]) -> Formula:
    """Return the formula `left = right...`, a decimal fraction that goes on: the enclosed value has these digits."""

    def decide(formula: Formula) -> Evidence:
        digits, found = sp.Rational(formula.right), value()
        low, high = point(digits), point(digits + sp.Rational(1, 10 ** decimal_places(digits)))
        inside, outside = found > low and found < high, found < low or found > high
        passed = True if inside else False if outside else None
        return enclosed(shown(formula), passed, str(found.str(20)))

    return Formula(left, "=...", sp.Rational(right), decide)


def fails_at(point: Point, where: Callable[[], Mapping[sp.Basic, sp.Basic]] = dict) -> Decide:
    """Decide that a formula, stated for all, is false: it fails at one rational point, with what theory derives in the places of `where`."""

    def decide(formula: Formula) -> Evidence:
        left, right = (put(sp.sympify(side), where()) for side in (formula.left, formula.right))
        found = exhibit(f"{shown(formula)} fails at a point", point, (left, formula.relation, right))
        return replace(found, passed=None if found.passed is None else not found.passed)

    return decide
