"""What the theorems past the paper are written with: their letters, and how an equation in them is decided."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from paper_checks.engines.deciders import equals
from paper_checks.evidence.clause import Clause, Formula
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim, Kind
from theory.excursion import h
from theory.return_map import depth
from theory.symbols import r as share_of_q

SECTION = "Theorems"
WHERE = "past the paper"
C, H, R = sp.symbols("c h r", positive=True)


def meanings() -> dict[sp.Symbol, sp.Expr]:
    """Return what the letters stand for in the theory; derived when a formula is decided, not when the ledger is read."""
    return {C: depth(), H: h(), R: share_of_q}


def theorem(name: str, *clauses: Clause, open: tuple[str, ...] = ()) -> Claim:
    """Return a row that is ours: it is proved, or it is not there; `open` says what it leaves undecided."""
    return Claim(name, SECTION, WHERE, clauses, Verdict.HOLDS, Kind.THEOREM, open=open)


def in_angle(left: str, right: sp.Expr, derived: Callable[[], sp.Basic]) -> Formula:
    """Return an equation in the letters h, c and r."""
    return Formula(left, "=", right, equals(derived, meanings))


def of_share(left: str, right: sp.Expr, derived: Callable[[], sp.Basic]) -> Formula:
    """Return an equation in the letter r = 1 - q."""
    return Formula(left, "=", right, equals(derived, lambda: {R: share_of_q}))
