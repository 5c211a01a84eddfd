"""Evidence at one point, in exact rational arithmetic: how a counterexample is shown to be real."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from paper_checks.evidence import Evidence, EvidenceKind

Point = Mapping[sp.Symbol, "sp.Rational | int"]
"""Exact values of symbols, SI units; anything but a rational is refused."""


def exhibit(statement: str, point: Point, *relations: sp.Basic) -> Evidence:
    """Check that all relations hold at a rational point.

    Passed is True where each relation becomes true between rationals there, False where one becomes false, None
    where one stays open (a symbol without a value) or there is none. Raises TypeError for an inexact value.
    """
    values = {symbol: sp.sympify(value) for symbol, value in point.items()}
    for symbol, value in values.items():
        if not value.is_Rational:
            raise TypeError(f"{symbol} = {value} is not a rational number: write sp.Rational('0.006')")
    found = [_decided(relation, values) for relation in relations]
    passed = False if False in found else None if None in found else True
    text = ", ".join(f"${_shown(relation, values)}$" for relation in relations)
    return Evidence(EvidenceKind.EXACT, "rational arithmetic", statement, passed, len(relations), text)


def _decided(relation: sp.Basic, values: dict[sp.Symbol, sp.Expr]) -> bool | None:
    answer = relation.subs(values)
    return {sp.true: True, sp.false: False}.get(answer)


def _shown(relation: sp.Basic, values: dict[sp.Symbol, sp.Expr]) -> str:
    """Return both sides at the point with the relation between them, as LaTeX."""
    if not isinstance(relation, sp.core.relational.Relational):
        return str(sp.latex(relation.subs(values)))
    sides = [sp.latex(sp.simplify(side.subs(values))) for side in relation.args]
    signs = {"<=": r"\leq", ">=": r"\geq", "==": "=", "!=": r"\neq"}
    return f"{sides[0]} {signs.get(relation.rel_op, relation.rel_op)} {sides[1]}"
