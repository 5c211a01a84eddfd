"""Formulas of a derivation, set from the expressions that were checked."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from paper_checks.evidence.evidence import Evidence


def equation(left: str, right: sp.Basic | int, *, relation: str = "=") -> str:
    """Return the displayed equation with the LaTeX `left` and an expression of theory on the right.

    >>> equation("E", sp.Symbol("m_1") ** 2)
    '$$E=m_{1}^{2}$$'
    """
    return f"$${left}{relation}{sp.latex(right)}$$"


def stating(evidence: Evidence, *forms: str) -> Evidence:
    """Return the evidence with closed forms, for programs to read, before its value.

    >>> from paper_checks.evidence.evidence import EvidenceKind
    >>> stating(Evidence(EvidenceKind.EXACT, "sympy", "s", True, value="0"), "y = h**2", "x = 1").value
    'y = h**2; x = 1; 0'
    """
    return replace(evidence, value="; ".join((*forms, evidence.value)))


def form(left: str, right: sp.Basic | int) -> str:
    """Return `left = right` with the expression as sympy writes it."""
    return f"{left} = {sp.sstr(right)}"
