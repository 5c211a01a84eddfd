"""Reduced (dimensionless) coordinates, derived by substitution from the SI fields.

X = x1/L, V_i = v_i/(L Omega), tau = Omega t with L the half width of S0 and Omega the frequency of stick.
For a1 = 0 one parameter is left, the mass fraction q = m1/M; with a1 > 0 the damping ratio zeta besides.
"""

from functools import cache

from sympy import Expr, ImmutableMatrix, Symbol, sqrt, together

from theory.energy import critical_energy, energy, slip_rate
from theory.filippov import load_threshold, phi, sliding_field
from theory.fraction import factored, in_lowest_terms
from theory.linear import root
from theory.symbols import (
    V1,
    V2,
    X,
    a1,
    a2,
    acceleration1,
    acceleration2,
    b,
    diff,
    m1,
    m2,
    put,
    q,
    r,
    total_mass,
    u,
    undamped,
    v1,
    v2,
    x1,
    zeta,
)

# Units of the reduced coordinates as free symbols: length (m), frequency (rad/s), mass (kg).
radius = Symbol("R", positive=True)  # of an axis, m
L, Omega, M = Symbol("L", positive=True), Symbol("Omega", positive=True), Symbol("M", positive=True)


def half_width() -> Expr:
    """The unit of length L, m: the load at which adhesion gives way over the stiffness."""
    return load_threshold() / a2


@cache
def stick_frequency() -> Expr:
    """The unit of frequency Omega, rad/s, read off the undamped sliding field."""
    return sqrt(-diff(sliding_field()[1], x1))


@cache
def damping_ratio() -> Expr:
    """zeta, dimensionless: the damping of stick relative to the critical one."""
    rate = -diff(sliding_field(damped=True)[1], v1)
    return rate / (2 * stick_frequency())


@cache
def parameters() -> dict[Symbol, Expr]:
    """SI parameters by reduced ones and units: m1, m2, a2, b, a1 by q, zeta, M, Omega, L (exact)."""
    masses = {m1: q * M, m2: r * M}
    stiffness = root(stick_frequency() ** 2 - Omega**2, a2).subs(masses)
    force = root((half_width() - L).subs(masses), b).subs(a2, stiffness)
    viscosity = root(damping_ratio() - zeta, a1).subs(masses).subs(a2, stiffness)
    return {**masses, a2: together(stiffness), b: together(force), a1: together(viscosity)}


def about_an_axis(expression: Expr) -> Expr:
    """A quantity of translation at the radius R of an axis, in the letters of rotation: each letter now stands for its
    counterpart there, a mass for a moment of inertia, a force for a torque, a place for an angle (exact).
    """
    lengths = {one: radius * one for one in (x1, v1, v2, acceleration1, acceleration2)}
    coefficients = {one: one / radius**2 for one in (m1, m2, a1, a2)}
    return put(expression, {**lengths, **coefficients, b: b / radius, u: u / radius})


def to_reduced(expression: Expr) -> Expr:
    """An SI expression of state and parameters in reduced coordinates; its unit remains in M, Omega, L."""
    state = {x1: L * X, v1: L * Omega * V1, v2: L * Omega * V2, total_mass(): M}
    return factored(put(put(expression, state), parameters()))


def to_si(expression: Expr) -> Expr:
    """A reduced expression in SI symbols: q, zeta, X, V1, V2 by their definitions."""
    unit_of_speed = half_width() * stick_frequency()
    definitions = {
        X: x1 / half_width(),
        V1: v1 / unit_of_speed,
        V2: v2 / unit_of_speed,
        q: m1 / total_mass(),
        zeta: damping_ratio(),
    }
    return put(expression, definitions)


def reduced_field(field: ImmutableMatrix) -> ImmutableMatrix:
    """A field on (x1, v1, v2) as d(X, V1, V2)/dtau, dimensionless: no unit may remain."""
    units = (L * Omega, L * Omega**2, L * Omega**2)
    return ImmutableMatrix(
        [in_lowest_terms(to_reduced(entry) / unit) for entry, unit in zip(field, units, strict=True)]
    )


@cache
def reduced_slip(sign: int, damped: bool = False) -> ImmutableMatrix:
    """d(X, V1, V2)/dtau in slip with sgn(V1 - V2) = sign, dimensionless."""
    return reduced_field(phi(sign, damped))


@cache
def reduced_energy() -> Expr:
    """E/E_cr in reduced coordinates, dimensionless."""
    return in_lowest_terms(to_reduced(energy() / critical_energy()))


def excess() -> Expr:
    """w = E/E_cr - 1 in reduced coordinates, dimensionless."""
    return reduced_energy() - 1


@cache
def excess_rate(sign: int, damped: bool = False) -> Expr:
    """dw/dtau in slip with sgn(V1 - V2) = sign, dimensionless."""
    rate = slip_rate(sign) if damped else undamped(slip_rate(sign))
    return factored(to_reduced(rate / critical_energy()) / Omega)


def canonical_pair() -> dict[Symbol, Expr]:
    """SI parameters for which L = Omega = M = 1: its SI formulas are the reduced ones."""
    return {symbol: put(value, {L: 1, M: 1, Omega: 1}) for symbol, value in parameters().items()}
