"""Exact solutions of stick and slip, for a1 = 0 and for a1 > 0 in the three damping regimes.

In each mode x1 obeys I x1'' + a1 x1' + a2 x1 = -s b with I = m1 and s = sgn(v1 - v2) in slip, I = M and
no force in stick.  Solutions are written with the decay rate and a second rate, whose SI meaning
``rates`` gives; ``residual`` substitutes a solution into eqs (3), (4) and the initial conditions.
"""

from dataclasses import dataclass
from enum import Enum
from functools import cache

from sympy import (
    Expr,
    Integer,
    Symbol,
    cos,
    cosh,
    exp,
    integrate,
    sin,
    sinh,
    sqrt,
)

from theory.fraction import in_lowest_terms
from theory.linear import root, roots
from theory.model import branch_named
from theory.symbols import a1, a2, diff, free, m1, put, t, total_mass, v1, v1_0, v2_0, x1, x1_0, x2_0

decay = Symbol("beta", positive=True)  # decay rate a1/(2 I), 1/s
rate = Symbol("omega", positive=True)  # angular frequency, or half distance of the real rates, 1/s


class DampingRegime(Enum):
    """The damping regime of one mode, by the sign of a1^2 - 4 a2 I."""

    UNDAMPED = "undamped"
    UNDERDAMPED = "underdamped"
    CRITICAL = "critically damped"
    OVERDAMPED = "overdamped"


@dataclass(frozen=True)
class ModeSolution:
    """Motion of both bodies in one mode as functions of t, x1(0), v1(0), x2(0), v2(0) (SI, exact)."""

    mode: str
    regime: DampingRegime
    x1: Expr
    x2: Expr

    @property
    def v1(self) -> Expr:
        """Velocity of body 1, m/s."""
        return diff(self.x1, t)

    @property
    def v2(self) -> Expr:
        """Velocity of body 2, m/s."""
        return diff(self.x2, t)


def inertia(mode: str) -> Expr:
    """The mass that the spring moves in a mode ("stick", "slip+", "slip-"), kg."""
    return total_mass() if mode == "stick" else m1


def discriminant(mode: str) -> Expr:
    """a1^2 - 4 a2 I, (N s/m)^2: negative underdamped, zero critical, positive overdamped."""
    return a1**2 - 4 * a2 * inertia(mode)


def rates(mode: str, regime: DampingRegime) -> dict[Symbol, Expr]:
    """SI meaning of ``decay`` and ``rate`` in a mode and regime; a rate that does not occur is absent."""
    mass = inertia(mode)
    if regime is DampingRegime.UNDAMPED:
        return {rate: sqrt(a2 / mass)}
    meaning = {decay: a1 / (2 * mass)}
    if regime is DampingRegime.UNDERDAMPED:
        meaning[rate] = sqrt(-discriminant(mode)) / (2 * mass)
    if regime is DampingRegime.OVERDAMPED:
        meaning[rate] = sqrt(discriminant(mode)) / (2 * mass)
    return meaning


@cache
def coefficients(mode: str, regime: DampingRegime) -> dict[Symbol, Expr]:
    """a1 and a2 by the rates: the inverse of ``rates``, polynomial, so that residuals become identities."""
    mass = inertia(mode)
    damping = Integer(0) if regime is DampingRegime.UNDAMPED else root(a1 / (2 * mass) - decay, a1)
    squared = {DampingRegime.CRITICAL: Integer(0), DampingRegime.OVERDAMPED: rate**2}.get(regime, -(rate**2))
    stiffness = root((discriminant(mode) - (2 * mass * rate) ** 2).subs({a1: damping, rate**2: squared}), a2)
    return {a1: damping, a2: stiffness}


def decaying_pair(regime: DampingRegime) -> tuple[Expr, Expr]:
    """Two independent solutions of the homogeneous equation in a regime."""
    if regime is DampingRegime.UNDAMPED:
        return cos(rate * t), sin(rate * t)
    oscillation = {
        DampingRegime.UNDERDAMPED: (cos(rate * t), sin(rate * t)),
        DampingRegime.CRITICAL: (Integer(1), t),
        DampingRegime.OVERDAMPED: (cosh(rate * t), sinh(rate * t)),
    }[regime]
    return exp(-decay * t) * oscillation[0], exp(-decay * t) * oscillation[1]


@cache
def solution(mode: str, regime: DampingRegime) -> ModeSolution:
    """The solution of a mode: rest position plus the homogeneous solutions fitted to the initial state.

    Raises KeyError for a mode other than "stick", "slip+" and "slip-".
    """
    field = branch_named(mode)
    rest = root(free(field.acceleration1).subs(v1, 0), x1)
    first, second = Symbol("C1"), Symbol("C2")
    shape = decaying_pair(regime)
    ansatz = rest + first * shape[0] + second * shape[1]
    start = [(ansatz - x1_0).subs(t, 0), (diff(ansatz, t) - v1_0).subs(t, 0)]
    position = ansatz.subs(dict(zip((first, second), roots(start, [first, second]), strict=True)))
    if mode == "stick":
        return ModeSolution(mode, regime, position, x2_0 + position - x1_0)
    velocity2 = v2_0 + integrate(field.acceleration2, t)
    return ModeSolution(mode, regime, position, x2_0 + integrate(velocity2, t))


def residual(found: ModeSolution) -> tuple[Expr, ...]:
    """What a solution leaves in eq (3), eq (4) and the four initial conditions: all zero iff it is exact.

    Equations (3), (4) are those of the branch; in stick the initial velocities are equal (v2(0) = v1(0)).
    """
    field = branch_named(found.mode)
    along = {x1: found.x1, v1: found.v1}
    equations = (
        diff(found.x1, t, 2) - put(free(field.acceleration1), along),
        diff(found.x2, t, 2) - put(free(field.acceleration2), along),
    )
    common = v1_0 if found.mode == "stick" else v2_0
    initial = (found.x1 - x1_0, found.v1 - v1_0, found.x2 - x2_0, found.v2 - common)
    system = equations + tuple(entry.subs(t, 0) for entry in initial)
    known = coefficients(found.mode, found.regime)
    # Linear in the independent functions t, exp, cos, ... with rational coefficients: cancelling decides.
    return tuple(in_lowest_terms(put(entry, known)) for entry in system)
