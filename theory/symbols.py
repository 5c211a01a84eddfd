"""The letters of the paper as sympy symbols, with the assumptions under which every statement is read.

The damping ``a1`` is assumed positive; Section III of the paper is the case a1 = 0, which is reached
by ``undamped(expression)`` (a substitution, exact), never by a second symbol.  Likewise ``free`` puts the
control u to zero.  Symbols carry SI units; the reduced coordinates of ``theory.scaling`` are dimensionless.
"""

from collections.abc import Mapping
from functools import cache
from typing import Any

import sympy
from sympy import Add, Basic, Expr, Function, Integer, Mul, Symbol, cos, factor_terms, signsimp, sin, symbols, sympify

# Parameters of the pair: masses (kg), stiffness (N/m), Coulomb force (N), viscosity (N s/m).
m1, m2, a2, b = symbols("m1 m2 a2 b", positive=True)
a1 = Symbol("a1", positive=True)
u = Symbol("u", real=True)  # control force, N

# State: positions (m), velocities (m/s), accelerations (m/s^2), time (s).
x1, v1, x2, v2 = symbols("x1 v1 x2 v2", real=True)
acceleration1, acceleration2 = symbols(r"\ddot{x}_1 \ddot{x}_2", real=True)
t = Symbol("t", nonnegative=True)

# Initial state of a mode and a second solution beside the first (for the contraction identity).
x1_0, v1_0, x2_0, v2_0 = symbols("x10 v10 x20 v20", real=True)
x1_other, v1_other, v2_other = symbols(r"\tilde{x}_1 \tilde{v}_1 \tilde{v}_2", real=True)

# The unevaluated signum of eq (1); ``theory.model.signum`` is its definition.
sgn = Function("sgn", real=True)

# A level of energy (J), and auxiliary quantities that are nonnegative by their meaning.
E0 = Symbol("E0", positive=True)
distance = Symbol("d", positive=True)  # distance beyond an edge of the sliding region
upper, lower = symbols("lambda mu", nonnegative=True)  # convex weights, upper + lower = 1

# Reduced coordinates: dimensionless state, time, mass fraction of the driving body, damping ratio.
X, V1, V2, Z = symbols("X V1 V2 Z", real=True)
tau = Symbol("tau", nonnegative=True)
q = Symbol("q", positive=True)  # m1/(m1 + m2), between 0 and 1
r = 1 - q  # m2/(m1 + m2); an expression, so that q + r = 1 needs no simplification rule
zeta = Symbol("zeta", positive=True)

# One slip excursion: slip angle, speed on the ray, the same over sqrt(q), overshoot, excess energy.
theta = Symbol("theta", positive=True)
epsilon = Symbol("epsilon", positive=True)
h_value = Symbol("h", positive=True)
overshoot = Symbol("delta", nonnegative=True)
w = Symbol("w", positive=True)


def put(expression: Expr, values: Mapping[Basic, Any]) -> Expr:
    """The expression with values in the places of symbols, all at once: exact, ten times as quick as `subs`."""
    return expression.xreplace({one: sympify(value) for one, value in values.items()})


def diff(expression: Expr, variable: Symbol, times: int = 1) -> Expr:
    """The derivative, exact; sympy's own `diff` asks of every part whether it is 0 and takes three times as long."""
    for _ in range(times):
        expression = _slope(sympify(expression), variable)
    return factor_terms(signsimp(expression)) if times > 1 else expression


@cache
def _slope(part: Expr, variable: Symbol) -> Expr:
    if part.is_Atom:
        return Integer(part == variable)
    if part.is_Add:
        return Add(*(_slope(one, variable) for one in part.args))
    if part.is_Mul:
        parts = part.args
        return Add(*(Mul(*parts[:n], _slope(one, variable), *parts[n + 1 :]) for n, one in enumerate(parts)))
    if part.is_Pow and part.exp.is_Rational:
        return part * (_slope(part.base, variable) * part.exp / part.base)
    if isinstance(part, sin | cos):
        return part.fdiff() * _slope(part.args[0], variable)
    return sympy.diff(part, variable)


def undamped(expression: Expr) -> Expr:
    """Put a1 = 0 in an SI expression and zeta = 0 in a reduced one (exact)."""
    return put(expression, {a1: 0, zeta: 0})


def free(expression: Expr) -> Expr:
    """Put the control u = 0: the free system of Section III (exact)."""
    return put(expression, {u: 0})


def total_mass() -> Expr:
    """The mass M = m1 + m2 that the spring moves in stick, kg."""
    return m1 + m2
