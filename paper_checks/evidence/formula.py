"""Formulas in LaTeX, set from the expressions that were checked."""

from __future__ import annotations

import sympy as sp
from sympy.printing.latex import LatexPrinter

_BARE = (sp.sin, sp.cos, sp.tan, sp.cot, sp.log)
"""Functions that a single letter follows without brackets."""


class _Printer(LatexPrinter):
    """As people write: a sum does not begin with a minus if it need not, and sin x has no brackets."""

    def _as_ordered_terms(self, expr: sp.Add, order: str | None = None) -> list[sp.Expr]:
        terms = list(super()._as_ordered_terms(expr, order=order))
        if not terms[0].could_extract_minus_sign():
            return terms
        return sorted(terms, key=lambda term: term.could_extract_minus_sign())

    def _print_Function(self, expr: sp.Function, exp: str | None = None) -> str:
        bare = isinstance(expr, _BARE) and isinstance(expr.args[0], sp.Symbol)
        self._settings["fold_func_brackets"] = bare
        return str(super()._print_Function(expr, exp))


def latex(expression: sp.Basic | str | int) -> str:
    r"""Return LaTeX of an expression; a text is LaTeX already, a column is written as a row.

    >>> x, theta = sp.symbols("x theta")
    >>> latex(-x * sp.cos(theta) + sp.sin(theta))
    '\\sin {\\theta} - x \\cos {\\theta}'
    """
    if isinstance(expression, str):
        return expression
    if isinstance(expression, sp.MatrixBase):
        return r"\bigl(" + r",\,".join(map(latex, expression)) + r"\bigr)"
    return str(_Printer({"fold_short_frac": False}).doprint(sp.sympify(expression)))


def equation(left: str, right: sp.Basic | int, *, relation: str = "=") -> str:
    """Return the displayed equation with the LaTeX `left` and an expression of theory on the right, for the notebooks.

    >>> equation("E", sp.Symbol("m_1") ** 2)
    '$$E=m_{1}^{2}$$'
    """
    return f"$${left}{relation}{latex(right)}$$"


def pointed(whole: int, places: int) -> str:
    """Return a number of units of the last decimal place as a decimal.

    >>> pointed(-5, 2), pointed(5, 0)
    ('-0.05', '5')
    """
    digits = str(abs(whole)).rjust(places + 1, "0")
    cut = len(digits) - places
    return "-" * (whole < 0) + digits[:cut] + f".{digits[cut:]}" * (places > 0)
