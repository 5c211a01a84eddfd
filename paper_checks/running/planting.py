"""Faults planted in every formula of every clause: a sign, a factor, an exponent, a relation. Each must turn its row.

`python -m paper_checks plant [ID ...]` plants them all and prints how many turned.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import sympy as sp

from paper_checks.decide.exact import identity
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.clause import NEGATIONS, Clause, Formula

REVERSED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}


@dataclass(frozen=True)
class Planted:
    """A formula with a fault in it, where it stands, and whether its row turns."""

    claim: str
    clause: str
    fault: str
    latex: str
    turned: bool


def faults(formula: Formula) -> Iterator[tuple[str, Formula]]:
    """Yield the kinds of fault and the formulas with one fault.

    An equation, and a sharp inequality, has each of its terms' signs, factors and exponents changed; an inequality is
    turned round; a formula that is false as the paper states it is exchanged for its negation, which is true.
    """
    if formula.false:
        yield "negation", replace(formula, relation=NEGATIONS[formula.relation])
        return
    if formula.relation in REVERSED:
        yield "inequality", replace(formula, relation=REVERSED[formula.relation])
    if formula.relation not in REVERSED or formula.sharp:
        seen: set[sp.Basic] = {sp.sympify(formula.right)}
        for kind, right in _changes(sp.sympify(formula.right)):
            if right not in seen and not _same(right, formula.right):
                seen.add(right)
                yield kind, replace(formula, right=right)


def _changes(value: sp.Basic) -> Iterator[tuple[str, sp.Basic]]:
    if isinstance(value, sp.MatrixBase):
        for index, entry in enumerate(value):
            for kind, changed in _changes(entry):
                entries = list(value)
                entries[index] = changed
                yield kind, type(value)(*value.shape, entries)
    elif value == 0:
        yield "factor", sp.Integer(1)
    else:
        yield "sign", -value
        yield "factor", 2 * value
        yield from _within(value)


def _within(value: sp.Basic) -> Iterator[tuple[str, sp.Basic]]:
    """Yield the expression with the sign of one term of a sum, or one exponent, changed, however deep."""
    if isinstance(value, sp.Add):
        for term in value.args:
            yield "sign", value - 2 * term
    if isinstance(value, sp.Pow) and value.exp.is_Rational:
        yield "exponent", value.base ** (value.exp + 1)
    if isinstance(value, sp.Symbol):
        yield "exponent", value**2
    for index, part in enumerate(value.args):
        if isinstance(value, sp.Pow) and index == 1:
            continue
        for kind, changed in _within(part):
            yield kind, value.func(*value.args[:index], changed, *value.args[index + 1 :])


def _same(one: sp.Basic, other: sp.Basic | int) -> bool:
    """Say whether two expressions are equal for all values: then the change was no fault. A point that tells them apart says no."""
    return identity("the change changes nothing", one, other).passed is not False


def places(claims: Iterable[Claim]) -> Iterator[tuple[Claim, Clause, str, Formula]]:
    """Yield every formula of every clause of the claims, and where it stands."""
    for claim in claims:
        for clause in (*claim.clauses, *claim.correction):
            for name, formula in clause.formulas.items():
                yield claim, clause, name, formula


def planted(claims: Iterable[Claim]) -> Iterator[Planted]:
    """Plant every fault and say whether the formula's evidence, without which the row does not stand, turns."""
    for claim, clause, _, formula in places(claims):
        for kind, wrong in faults(formula):
            yield Planted(claim.id, clause.id, kind, wrong.latex, _turns(wrong))


def _turns(formula: Formula) -> bool:
    """Say whether the evidence is not a pass; a check that raises may say only that the fault broke the program."""
    try:
        return formula.evidence().passed is not True
    except Exception:  # noqa: BLE001  whatever it raises, nothing was decided
        return False
