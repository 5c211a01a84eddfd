"""Section III: the switching surface S = {v1 = v2}, its parts, Filippov's sliding field, exits by the rays.

Fields are the slip branches of the model.  Every function takes ``damped``: False is the paper's a1 = 0,
True keeps a1 > 0; there the place of x1 is taken by the load a2 x1 + a1 v1 on the bodies.
"""

from dataclasses import dataclass
from functools import cache

from sympy import (
    Abs,
    And,
    Eq,
    Expr,
    Gt,
    ImmutableMatrix,
    Integer,
    Le,
    Lt,
    Symbol,
)

from theory.fraction import factored
from theory.linear import root
from theory.model import slip
from theory.symbols import a1, a2, diff, distance, lower, undamped, upper, v1, v2, x1

STATE = ImmutableMatrix([x1, v1, v2])


def guard() -> Expr:
    """The relative velocity v1 - v2, m/s, whose zero set is S."""
    return v1 - v2


@cache
def phi(sign: int, damped: bool = False) -> ImmutableMatrix:
    """Phi_+ (sign 1) or Phi_- (sign -1) on (x1, v1, v2): the field of the slip branch of eqs (3), (4)."""
    field = slip(sign).field
    return field if damped else undamped(field)


def normal() -> ImmutableMatrix:
    """The normal n_S: the gradient of the guard, pointing from Omega_- to Omega_+."""
    return ImmutableMatrix([diff(guard(), coordinate) for coordinate in STATE])


def derivative_along(field: ImmutableMatrix, quantity: Expr) -> Expr:
    """The rate of a function of the state along a field (chain rule)."""
    return sum((diff(quantity, c) * component for c, component in zip(STATE, field, strict=True)), Integer(0))


@cache
def transversality(sign: int, damped: bool = False) -> Expr:
    """Phi_sign . n_S on S as one fraction of factored terms, m/s^2."""
    return factored(derivative_along(phi(sign, damped), guard()).subs(v2, v1))


@cache
def half_width() -> Expr:
    """Half width L of S0, m: where Phi_- . n_S vanishes (a1 = 0)."""
    return factored(root(transversality(-1), x1))


@cache
def load_threshold() -> Expr:
    """The load a2 L at which adhesion gives way, N; the same with and without damping."""
    load_symbol = Symbol("p", real=True)
    product = transversality(-1, damped=True).subs(x1, (load_symbol - a1 * v1) / a2)
    return factored(root(product, load_symbol))


def load(damped: bool = False) -> Expr:
    """What spring and damper exert on the pair, N, with opposite sign: a2 x1 + a1 v1."""
    return a2 * x1 + a1 * v1 if damped else a2 * x1


@dataclass(frozen=True)
class Surface:
    """The parts of S and the rays on the edges of S0, each a sympy condition on (x1, v1, v2)."""

    minus: Expr
    sliding: Expr
    plus: Expr
    ray_minus: Expr
    ray_plus: Expr


@cache
def surface(damped: bool = False) -> Surface:
    """S_-, S_0, S_+ and the rays l_-, l_+; the rays hold the points where sliding motion leaves S0."""
    on_surface = Eq(v1, v2)
    position = load(damped) if damped else x1
    edge = load_threshold() if damped else half_width()

    def ray(side: int) -> Expr:
        outward = Gt(side * edge_speed_rate(side, damped), 0)
        return And(on_surface, Eq(position, side * edge), outward)

    return Surface(
        minus=And(on_surface, Lt(position, -edge)),
        sliding=And(on_surface, Le(Abs(position), edge)),
        plus=And(on_surface, Gt(position, edge)),
        ray_minus=ray(-1),
        ray_plus=ray(1),
    )


@cache
def manifest_signs(damped: bool = False) -> dict[tuple[str, int], Expr]:
    """Transversality products of (9), (10) with a sign that can be read off.

    Keys are (part of S, sign of the field).  On S_+ and S_- the edge is at distance d > 0; on S0
    x1 = L (lambda - mu) with lambda, mu >= 0 and lambda + mu = 1, so each product is a monomial or a sum
    of terms of one sign.  With damping the same is said of load/a2 in the place of x1.
    """
    edge = half_width()
    places = {
        ("plus", 1): edge + distance,
        ("plus", -1): edge + distance,
        ("minus", 1): -edge - distance,
        ("minus", -1): -edge - distance,
        ("sliding", 1): edge * (2 * upper - 1),
        ("sliding", -1): edge * (1 - 2 * lower),
    }
    position = Symbol("x", real=True)
    at = root(load(damped) - a2 * position, x1)
    return {
        (part, sign): factored(transversality(sign, damped).subs(x1, at.subs(position, place)))
        for (part, sign), place in places.items()
    }


@cache
def sliding_weight(damped: bool = False) -> Expr:
    """Weight alpha of Phi_+ for which alpha Phi_+ + (1 - alpha) Phi_- is tangent to S; dimensionless."""
    alpha = Symbol("alpha", real=True)
    tangency = alpha * transversality(1, damped) + (1 - alpha) * transversality(-1, damped)
    return factored(root(tangency, alpha))


@cache
def weight_margin(damped: bool = False) -> Expr:
    """alpha (1 - alpha) in factored form: nonnegative, that is alpha in [0, 1], exactly on S0."""
    alpha = sliding_weight(damped)
    return factored(alpha * (1 - alpha))


@cache
def sliding_field(damped: bool = False) -> ImmutableMatrix:
    """Filippov's field on S0: the convex combination with the weight put in, on v2 = v1."""
    alpha = sliding_weight(damped)
    mixed = alpha * phi(1, damped) + (1 - alpha) * phi(-1, damped)
    return ImmutableMatrix(mixed.subs(v2, v1).applyfunc(factored))


def at_edge(quantity: Expr, side: int, damped: bool = False) -> Expr:
    """Value of a function of the state on the edge of S0 where the load is side * threshold."""
    place = (side * load_threshold() - (a1 * v1 if damped else 0)) / a2
    return factored(quantity.subs({v2: v1}).subs(x1, place))


@cache
def edge_speed_rate(side: int, damped: bool = False) -> Expr:
    """Rate of load/a2 along the sliding field at an edge, m/s: it leaves where side * rate > 0."""
    return at_edge(derivative_along(sliding_field(damped), load(damped) / a2), side, damped)


@dataclass(frozen=True)
class EdgeContact:
    """Time derivatives of the guard at an edge of S0 along the slip that leaves by it, functions of v1.

    The first is zero: the guard of a slip that starts on an edge has a double root at its start.
    """

    first: Expr
    second: Expr
    third: Expr


@cache
def edge_contact(side: int, damped: bool = False) -> EdgeContact:
    """The contact of the slip with sign -side at the edge with load side * threshold.

    On the ray the second derivative has the sign -side: the exit is into the half-space of that sign.
    Where it vanishes the third has the sign +side, so the motion stays in S0.
    """
    field = phi(-side, damped)
    derivatives = [derivative_along(field, guard())]
    for _ in range(2):
        derivatives.append(derivative_along(field, derivatives[-1]))
    return EdgeContact(*(at_edge(entry, side, damped) for entry in derivatives))
