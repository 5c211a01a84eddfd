"""Clauses of a claim: prose whose mathematics is made from the expressions that are checked.

A `Formula` is shown as LaTeX and decided from the same expressions; `paper_checks.running.planting` changes a sign, a factor, an
exponent or a relation in it and sees the decision turn.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import sympy as sp

from paper_checks.errors import LedgerError
from paper_checks.evidence.evidence import Evidence, one_line
from paper_checks.evidence.formula import latex, pointed

RELATIONS = {
    "=": "=",
    "!=": r"\neq ",
    "<": "<",
    "<=": r"\leqslant ",
    ">": ">",
    ">=": r"\geqslant ",
    "->": r"\to ",
    "=...": "=",
}
"""The relations of formulas in LaTeX: `->` is a limit, `=...` a decimal fraction that goes on."""
NEGATIONS = {"=": "!=", "!=": "=", "<": ">=", ">=": "<", "<=": ">", ">": "<="}
_SLOT = re.compile("«([a-z0-9_]+)»")


def decimal_places(value: sp.Rational) -> int:
    """Return how many decimal places a decimal fraction has; its reduced denominator may lack factors of 10^places."""
    return max(sp.multiplicity(prime, value.q) for prime in (2, 5))


@dataclass(frozen=True)
class Formula:
    """`left relation right`, and how it is decided.

    `decide` returns the evidence for a formula of this shape: passed is True, False, or None where it is not settled.
    A formula that the paper states and that is false is decided by its counterexample, and marked as `false`. A `sharp`
    inequality is one whose sides are decided too, as a definition's are.
    """

    left: sp.Basic | str
    relation: str
    right: sp.Basic | int
    decide: Callable[[Formula], Evidence] = field(compare=False)
    false: bool = False
    sharp: bool = False

    def __post_init__(self) -> None:
        """Refuse an unknown relation."""
        if self.relation not in RELATIONS:
            raise LedgerError(f"the relation {self.relation!r} is none of {', '.join(RELATIONS)}")

    @cached_property
    def latex(self) -> str:
        """LaTeX of the formula, without dollars."""
        return f"{latex(self.left)}{RELATIONS[self.relation]}{self._right()}"

    def _right(self) -> str:
        if self.relation != "=...":
            return latex(self.right)
        places = decimal_places(sp.Rational(self.right))
        return rf"{pointed(int(self.right * 10**places), places)}\ldots"

    def evidence(self) -> Evidence:
        """Return what is found about it."""
        return self.decide(self)


@dataclass(frozen=True)
class Clause:
    """A part of a claim that is proved as one: prose, with `«name»` where the formula of that name is shown.

    `kernel` names the theorems of `paper_checks.proofs` that together prove the whole of it.
    Raises LedgerError where a name has no formula, or a formula no place.
    """

    id: str
    text: str
    formulas: Mapping[str, Formula] = field(default_factory=dict, hash=False)
    kernel: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Compare the places with the formulas."""
        object.__setattr__(self, "text", one_line(self.text))
        if set(_SLOT.findall(self.text)) != set(self.formulas):
            raise LedgerError(f"the clause {self.id} has formulas that differ from the places in its text")

    @property
    def shown(self) -> str:
        """The text, its formulas in LaTeX between dollars."""
        return _SLOT.sub(lambda match: f"${self.formulas[match[1]].latex}$", self.text)


def clause(id: str, text: str, *, kernel: str = "", **formulas: Formula) -> Clause:
    """Return a clause with its formulas by name; `kernel` names the theorems that prove it, with spaces between them."""
    return Clause(id, text, formulas, tuple(kernel.split()))
