"""One statement that a definition of the proofs is what the theory derives, and the letters that it is written with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from paper_checks.proofs.gallina import term
from theory import energy, excursion, return_map
from theory.symbols import E0, a1, a2, b, m1, m2, t, theta, v1, v2, x1

PAIR = "0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> "
NAMES = {one: one.name for one in (m1, m2, a1, a2, b, t)} | {
    x1: "x",
    v1: "v1",
    v2: "v2",
    E0: "e",
    theta: "u",
    excursion.angle: "p",
    energy.sigma: "sg",
    return_map.gap: "d",
    return_map.push: "u",
}


@dataclass(frozen=True)
class Tie:
    """One statement that a definition is what the theory says, and its proof."""

    name: str
    words: str
    statement: str
    proof: str

    @property
    def text(self) -> str:
        """As it stands in the file."""
        return f"(** {self.words} *)\nTheorem {self.name} : {self.statement}.\nProof. {self.proof} Qed.\n"


def equal(variables: str, given: str, mine: str, theirs: sp.Expr, names: Mapping[sp.Symbol, str] | None = None) -> str:
    """Return the statement that a definition, for variables with some properties, is an expression of `theory/`."""
    return f"forall {variables} : R, {given}{mine} = {term(theirs, names or NAMES)}"
