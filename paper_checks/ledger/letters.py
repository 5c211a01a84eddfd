"""What several clauses are written with: the sign of friction, the parts of S, the printed fields."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from paper_checks.engines.deciders import Decide, shown
from paper_checks.engines.exact import identity
from paper_checks.evidence.clause import Formula
from paper_checks.evidence.evidence import Evidence
from paper_checks.solvers.polynomial import cleared
from theory.filippov import half_width
from theory.symbols import a2, b, m1, m2, v1, x1

SIGN = sp.Symbol(r"\mathrm{sign}(v_1-v_2)", real=True)
S = sp.Symbol("s", real=True)
"""The sign of a slip."""
Conditions = Callable[[], list[sp.Basic]]


def _beyond(side: int) -> Conditions:
    return lambda: [sp.Gt(cleared(side * x1 - half_width()), 0, evaluate=False)]


BEYOND: dict[int, Conditions] = {1: _beyond(1), -1: _beyond(-1)}
"""The conditions side x1 > L of S_+ and S_-."""


def WITHIN() -> list[sp.Basic]:
    """Return the conditions |x1| <= L of S_0."""
    return [sp.Le(cleared(side * x1 - half_width()), 0, evaluate=False) for side in (1, -1)]


def field(sign: int) -> sp.Matrix:
    """Return Phi_+ (sign 1) or Phi_- (sign -1) as printed."""
    return sp.Matrix([v1, -a2 / m1 * x1 - sign * b / m1, sign * b / m2])


def guard_rate(sign: int) -> sp.Symbol:
    """Return the letter of a field's product with the normal of S."""
    return sp.Symbol(rf"\Phi_{{{'+' if sign > 0 else '-'}}}\cdot n_S", real=True)


def either_sign(
    derived: Callable[[int], sp.Expr], where: dict[sp.Symbol, Callable[[int], sp.Expr]] | None = None
) -> Decide:
    """Decide an equation with the sign s of a slip: it holds for s = 1 and for s = -1."""

    def decide(formula: Formula) -> Evidence:
        right = sp.sympify(formula.right)
        sides = [right.subs({one: value(s) for one, value in (where or {}).items()}).subs(S, s) for s in (1, -1)]
        return identity(f"{shown(formula)}, as derived", sp.Matrix([derived(1), derived(-1)]), sp.Matrix(sides))

    return decide
