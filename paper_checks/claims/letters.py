"""Letters that clauses of several subjects are written with, and what they stand for."""

from paper_checks.claims.words import *
from theory.excursion import h
from theory.near_critical import rate_constant
from theory.return_map import depth
from theory.symbols import r as share_of_q

SIGN = Symbol(r"\mathrm{sign}(v_1-v_2)", real=True)
S = Symbol("s", real=True)
"""The sign of a slip."""


def past_edge(side: int, relation: str = ">") -> Basic:
    """Return the condition side x1 > L, or >=, of S_+ and S_-."""
    return signed(side * x1 - half_width(), relation)


def in_strip() -> list[Basic]:
    """Return the conditions |x1| <= L of S_0."""
    return [signed(side * x1 - half_width(), "<=") for side in (1, -1)]


def field(sign: int) -> Matrix:
    """Return Phi_+ (sign 1) or Phi_- (sign -1) as printed."""
    return Matrix([v1, -a2 / m1 * x1 - sign * b / m1, sign * b / m2])


def guard_rate(sign: int) -> Symbol:
    """Return the letter of a field's product with the normal of S."""
    return Symbol(rf"\Phi_{{{'+' if sign > 0 else '-'}}}\cdot n_S", real=True)


def either_sign(derived: Callable[[int], Expr], where: dict[Symbol, Callable[[int], Expr]] | None = None) -> Decide:
    """Decide an equation with the sign s of a slip: it holds for s = 1 and for s = -1."""

    def decide(formula: Formula) -> Evidence:
        right = sp.sympify(formula.right)
        sides = [right.subs({one: value(s) for one, value in (where or {}).items()}).subs(S, s) for s in (1, -1)]
        return identity(f"${formula.latex}$, as derived", [derived(1), derived(-1)], sides)

    return decide


ECR = Symbol("E_{cr}", positive=True)
RATE = ECR * 4 * pi / 9 * m1 / m2 * sqrt((m1 + m2) / a2)


def limit_of_energy() -> Formula:
    """Return the limit of t (E - E_cr)."""
    return tends(r"t\,(E(t)-E_{cr})", RATE, lambda: rate_constant() / critical_energy() * ECR)


C, H, R = symbols("c h r", positive=True)


def meanings() -> dict[Symbol, Expr]:
    """Return what the letters stand for in the theory; derived when a formula is decided, not when the ledger is read."""
    return {C: depth(), H: h(), R: share_of_q}


def in_angle(left: str, right: Expr, derived: Callable[[], Basic]) -> Formula:
    """Return an equation in the letters h, c and r."""
    return equal(left, right, derived, meanings)


def of_share(left: str, right: Expr, derived: Callable[[], Basic]) -> Formula:
    """Return an equation in the letter r = 1 - q."""
    return equal(left, right, derived, lambda: {R: share_of_q})


MASS = m1 + m2
DISTANCE = Symbol("N", nonnegative=True)
