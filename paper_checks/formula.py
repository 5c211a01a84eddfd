"""Formulas of a derivation, set from the expressions that were checked."""

from __future__ import annotations

import sympy as sp


def equation(left: str, right: sp.Basic | int, *, relation: str = "=") -> str:
    """Return the displayed equation with the LaTeX `left` and an expression of theory on the right.

    >>> equation("E", sp.Symbol("m_1") ** 2)
    '$$E=m_{1}^{2}$$'
    """
    return f"$${left}{relation}{sp.latex(right)}$$"
