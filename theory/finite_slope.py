"""One excursion from the ray l_+ under a friction b (1 - kappa |v1 - v2|): a slope and no jump (a1 = 0, reduced).

With the exit speed epsilon = sqrt(w), the time epsilon s, X = 1 + epsilon^2 xi, V2 = epsilon eta and
V2 - V1 = epsilon^3 y the equations are polynomial in epsilon: as epsilon -> 0 the slope drops out of them.
"""

from functools import cache

from sympy import Expr, ImmutableMatrix, Symbol, factor, integrate, sqrt

from theory.filippov import phi
from theory.near_critical import inverse_step, reduced_rate_constant, truncate
from theory.scaling import excess_rate, reduced_field
from theory.symbols import V1, V2, X, b, diff, epsilon, put

slope = Symbol("k", real=True)  # kappa L Omega: what the friction falls by, over b, per unit of the reduced speed
scaled_time = Symbol("s", nonnegative=True)
place, speed, relative = SCALED = (Symbol("xi", real=True), Symbol("eta", real=True), Symbol("y", real=True))
END = 3  # of the slip, in scaled time, as epsilon -> 0


def strength() -> Expr:
    """The friction of that slip over b."""
    return 1 - slope * epsilon**3 * relative


@cache
def scaled_field() -> ImmutableMatrix:
    """d(xi, eta, y)/ds: what (3), (4) become, polynomial in epsilon."""
    share = Symbol("f", positive=True)
    state = {X: 1 + epsilon**2 * place, V1: epsilon * speed - epsilon**3 * relative, V2: epsilon * speed}
    onward, first, second = put(reduced_field(put(phi(-1), {b: share * b})), {**state, share: strength()})
    return ImmutableMatrix([onward / epsilon, second, (second - first) / epsilon**2]).expand()


@cache
def path() -> ImmutableMatrix:
    """(xi, eta, y) at s below epsilon^2: Picard's iteration from (0, 1, 0) is exact there after four steps."""
    start = found = ImmutableMatrix([0, 1, 0])
    for _ in range(4):
        rates = put(scaled_field(), dict(zip(SCALED, found, strict=True)))
        found = start + rates.applyfunc(lambda one: integrate(truncate(one, epsilon, 2), (scaled_time, 0, scaled_time)))
    return found.expand()


@cache
def gain() -> Expr:
    """(w - w')/w^2 below epsilon^2, over its value for epsilon = 0 and constant friction.

    That is the work of friction up to s = 3: y_0 is 0 there, so the end of the slip moves it at epsilon^2 only.
    """
    rate = put(excess_rate(-1), {V1: -relative, V2: 0}) * strength()
    lost = truncate(-put(rate, {relative: path()[2]}), epsilon, 2)
    return factor(integrate(lost, (scaled_time, 0, END)) / inverse_step())


@cache
def approach() -> Expr:
    """lim sqrt(tau)(tau w/C - 1), C = lim tau w, dimensionless.

    1/w gains a (1 + c sqrt(w)) per excursion, so 1/w = a n + 2 c sqrt(a n) + ... after n of them, a n = tau/C + ...
    """
    return factor(-2 * diff(gain(), epsilon) * sqrt(reduced_rate_constant()))
