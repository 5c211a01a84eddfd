"""Energy: its rate in each mode, its level sets on S0, the critical level, and the contraction identity."""

from functools import cache

from sympy import (
    Expr,
    ImmutableMatrix,
    Rational,
    Symbol,
    diag,
    sqrt,
)

from theory.filippov import STATE, derivative_along, half_width, load_threshold, sliding_field
from theory.fraction import factored, in_lowest_terms
from theory.linear import root
from theory.model import free_system, slip
from theory.symbols import (
    E0,
    a1,
    a2,
    diff,
    m1,
    m2,
    put,
    undamped,
    v1,
    v1_other,
    v2,
    v2_other,
    x1,
    x1_other,
)

# The friction of two solutions: values of the set-valued sign, each in [-1, 1].
sigma, sigma_other = Symbol("sigma", real=True), Symbol(r"\tilde{\sigma}", real=True)


def metric() -> ImmutableMatrix:
    """Matrix of the energy inner product <z, z~> = a2 x x~ + m1 v1 v1~ + m2 v2 v2~ (twice J)."""
    return ImmutableMatrix(diag(a2, m1, m2))


def inner_product(first: ImmutableMatrix, second: ImmutableMatrix) -> Expr:
    """The energy inner product of two states (x1, v1, v2)."""
    return (first.T * metric() * second)[0]


def energy() -> Expr:
    """E of Section III, J: half the energy norm squared."""
    return Rational(1, 2) * inner_product(STATE, STATE).expand()


@cache
def slip_rate(sign: int) -> Expr:
    """dE/dt in slip with sgn(v1 - v2) = sign, W; with a1 = 0 this is (8) as |v1 - v2| = sign (v1 - v2)."""
    return derivative_along(slip(sign).field, energy()).expand()


@cache
def stick_rate() -> Expr:
    """dE/dt on S0 along Filippov's sliding field, W: zero when a1 = 0."""
    return in_lowest_terms(derivative_along(sliding_field(damped=True), energy()).subs(v2, v1))


def on_surface() -> Expr:
    """E on S, J, as a function of x1 and the common velocity v1."""
    return energy().subs(v2, v1)


@cache
def level_semi_axis() -> Expr:
    """Semi-axis along x1 of the ellipse {E = E0} on S, m: where the ellipse meets v1 = v2 = 0."""
    square = Symbol("x^2", positive=True)
    return sqrt(root(on_surface().subs({v1: 0, x1: sqrt(square)}) - E0, square))


@cache
def critical_energy() -> Expr:
    """E_cr, J: the level whose semi-axis is the half width of S0."""
    return factored(root(level_semi_axis() ** 2 - half_width() ** 2, E0))


@cache
def semi_axis_margin() -> Expr:
    """L^2 - semi-axis^2, m^2, as (E_cr - E0) times a positive factor: the condition and its converse."""
    gap = critical_energy() - E0
    return in_lowest_terms((half_width() ** 2 - level_semi_axis() ** 2) / gap) * gap


@cache
def edge_speed_squared() -> Expr:
    """v1^2 where {E = E0} on S meets the edges |x1| = L, as (E0 - E_cr) times a positive factor.

    Positive exactly when E0 > E_cr: then the ellipse is cut into two arcs, v1 > 0 and v1 < 0.
    """
    square = Symbol("v^2", real=True)
    level = on_surface().subs(v1, sqrt(square)).subs(x1, half_width())
    gap = E0 - critical_energy()
    return in_lowest_terms(root(level - E0, square) / gap) * gap


@cache
def arc_speed_terms() -> tuple[Expr, Expr]:
    """v1^2 on {E = E0} on S as ``edge_speed_squared`` plus a term (L^2 - x1^2) that is >= 0 on S0.

    For E0 > E_cr their sum is positive, so v1 keeps its sign on each arc: the one with v1 > 0 runs from
    x1 = -L to the ray l_+, the other from x1 = L to l_-.
    """
    square = Symbol("v^2", real=True)
    level = root(on_surface().subs(v1, sqrt(square)) - E0, square)
    return edge_speed_squared(), factored(level - edge_speed_squared())


@cache
def captive_energy() -> Expr:
    """The largest level whose ellipse on S lies in the strip |a2 x1 + a1 v1| <= b M/m2 of a1 > 0, J.

    The ellipse is x1 = A cos, v1 = B sin; the load on it has amplitude sqrt((a2 A)^2 + (a1 B)^2).  As E never
    increases, sliding motion below this level stays in S0 for ever; for a1 = 0 it is E_cr.
    """
    speed_axis = sqrt(2 * E0 / diff(on_surface(), v1, 2))
    amplitude = (a2 * level_semi_axis()) ** 2 + (a1 * speed_axis) ** 2
    return factored(root(amplitude - load_threshold() ** 2, E0))


def other(quantity: Expr) -> Expr:
    """The same function of a second solution (tilde)."""
    renamed = {x1: x1_other, v1: v1_other, v2: v2_other, sigma: sigma_other}
    return put(quantity, renamed)


@cache
def contraction_rate() -> Expr:
    """Rate of half the squared energy distance of two solutions, from (5)-(7) set-valued friction, W."""
    field = free_system(sigma)
    return inner_product(STATE - other(STATE), field - other(field)).expand()


@cache
def contraction_terms() -> tuple[Expr, Expr]:
    """Viscous and friction term whose sum is ``contraction_rate``; neither is ever positive.

    The first is minus a square.  The friction term is -b (sigma - sigma~)(w - w~).
    """
    rate = contraction_rate()
    friction = rate.subs(a1, 0)
    return factored(rate.expand() - friction.expand()), factored(friction)


@cache
def dwell_time_bound() -> Expr:
    """Upper bound of the time a trajectory with E <= E0 stays in one half-space, s.

    E >= m2 v2^2/2 confines v2 to an interval, which the constant rate v2' = +-b/m2 crosses in that time.
    """
    largest = sqrt(2 * E0 / diff(energy(), v2, 2))
    rate = undamped(slip(1).field)[2]
    return 2 * largest / rate
