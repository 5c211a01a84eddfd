"""One slip excursion from the ray l_+ and back to S, exact, in reduced coordinates (a1 = 0).

The pair leaves S0 at X = 1, V1 = V2 = eps > 0 by slip with v1 < v2.  With the slip angle theta =
tau/sqrt(q) and u = eps/sqrt(q) the guard is sqrt(q)(1 - cos theta)(h(theta) - u): its double root at the
start divided out, the excursion ends where h(theta) = u.  As h increases from 0 to infinity on (0, 2 pi),
theta parametrises all excursions and every quantity at their ends is a closed form in theta.  Excursions
from l_- are the mirror images (X, V, Z) -> (-X, -V, -Z).
"""

from dataclasses import dataclass
from functools import cache

from sympy import (
    Expr,
    Integer,
    Symbol,
    cos,
    expand,
    expand_trig,
    factor,
    fraction,
    integrate,
    rem,
    sin,
    sqrt,
)

from theory.closed_forms import DampingRegime, rate, rates, solution
from theory.fraction import factored, in_lowest_terms
from theory.linear import root
from theory.scaling import canonical_pair, excess
from theory.symbols import V1, V2, X, diff, epsilon, h_value, overshoot, put, q, r, t, theta, v1_0, v2_0, x1_0

angle = Symbol("phi", positive=True)  # half slip angle theta/2, in (0, pi)
half_tangent = Symbol("k", real=True)  # tan(theta/2)


@cache
def half_tangent_form(expression: Expr) -> Expr:
    """An expression in theta, sin theta, cos theta as a reduced fraction in theta and k = tan(theta/2).

    theta and k are algebraically independent, so the form is zero exactly when the expression is: a decision
    procedure for the identities of this module, where ``simplify`` only tries.
    """
    k = half_tangent
    circle = {sin(theta): 2 * k / (1 + k**2), cos(theta): (1 - k**2) / (1 + k**2)}
    return factored(expand_trig(expression).xreplace(circle))


def on_circle(expression: Expr) -> Expr:
    """An expression in theta, sin theta, cos theta as one fraction without powers of the sine above the first."""
    c, s = Symbol("c"), Symbol("s")
    parts = fraction(in_lowest_terms(put(expression, {cos(theta): c, sin(theta): s})))
    above, below = (rem(part, s**2 + c**2 - 1, s) for part in parts)
    top, bottom = fraction(in_lowest_terms(above / below))
    return put(top / factor(bottom), {c: cos(theta), s: sin(theta)})


@dataclass(frozen=True)
class Slip:
    """X, V1, V2 along an excursion as functions of theta, and the guard V1 - V2 (dimensionless, exact)."""

    X: Expr
    V1: Expr
    V2: Expr

    @property
    def guard(self) -> Expr:
        """The relative velocity V1 - V2: negative during the excursion."""
        return expand(self.V1 - self.V2)


@cache
def slip_from(position: Expr, velocity: Expr) -> Slip:
    """The slip with v1 < v2 from X = position, V1 = V2 = velocity: the closed form of the canonical pair."""
    found = solution("slip-", DampingRegime.UNDAMPED)
    start = {x1_0: position, v1_0: velocity, v2_0: velocity}
    meaning = rates("slip-", DampingRegime.UNDAMPED)

    def reduced(expression: Expr) -> Expr:
        canonical = put(put(expression, {rate: meaning[rate]}), canonical_pair())
        return expand(put(canonical, start).subs(t, sqrt(q) * theta))

    return Slip(reduced(found.x1), reduced(found.v1), reduced(found.v2))


def slip_from_ray() -> Slip:
    """The excursion from the ray l_+ with V1 = V2 = epsilon."""
    return slip_from(Integer(1), epsilon)


def slip_from_outside() -> Slip:
    """The slip with v1 < v2 from S_+ or its edge: X = 1 + delta, V1 = V2 = epsilon."""
    return slip_from(1 + overshoot, epsilon)


@cache
def h() -> Expr:
    """h(theta): the guard over sqrt(q)(1 - cos theta) is h - epsilon/sqrt(q); h = u ends the excursion.

    Solved from the guard: h is the value of u for which it vanishes.
    """
    return root(guard_of_u(), h_value)


@cache
def h_slope() -> Expr:
    """h'(theta) = (2(1 - cos theta) - theta sin theta)/(1 - cos theta)^2 in combined form."""
    return factored(on_circle(diff(h(), theta)))


@cache
def half_angle_slope() -> tuple[Expr, Expr]:
    """h'(theta) with theta = 2 phi as (positive factor, increment) on 0 < phi < pi.

    h' = factor * (sin phi - phi cos phi), and the increment is 0 at phi = 0 with derivative phi sin phi > 0.
    """
    halved = {cos(theta): 1 - 2 * sin(angle) ** 2, sin(theta): 2 * sin(angle) * cos(angle), theta: 2 * angle}
    increment = sin(angle) - angle * cos(angle)
    return in_lowest_terms(h_slope().subs(halved) / increment), increment


@dataclass(frozen=True)
class Excursion:
    """What one excursion does, in closed form in its slip angle theta (dimensionless, exact).

    ``velocity`` and ``position`` are those at re-entry, ``displacement`` is X1 - X2 gained (>= 0 in
    absolute value), ``excess`` and ``next_excess`` are w before and after.
    """

    start_velocity: Expr
    duration: Expr
    position: Expr
    velocity: Expr
    displacement: Expr
    excess: Expr
    next_excess: Expr


@cache
def displacement_of_angle() -> Expr:
    """D(theta): the relative displacement of an excursion over q, from the integral of the guard."""
    path = integrate(expand(-slip_from_ray().guard * sqrt(q)), (theta, 0, theta))
    return on_circle(expand(path / q).subs(epsilon, sqrt(q) * h()))


@cache
def excursion() -> Excursion:
    """The excursion from l_+ that ends at slip angle theta, 0 < theta < 2 pi.

    The excess after it is that of the re-entry state; ``energy_balance`` compares it with friction work.
    """
    start = sqrt(q) * h()
    slip = slip_from_ray()
    position = slip.X.subs(epsilon, start)
    velocity = slip.V2.subs(epsilon, start)
    before = put(excess(), {X: 1, V1: start, V2: start})
    after = put(excess(), {X: position, V1: velocity, V2: velocity})
    return Excursion(
        start_velocity=start,
        duration=sqrt(q) * theta,
        position=on_circle(position),
        velocity=sqrt(q) * on_circle(velocity / sqrt(q)),
        displacement=q * displacement_of_angle(),
        excess=factor(before),
        next_excess=after,
    )


@cache
def energy_balance() -> Expr:
    """w - w' - 2 r |X1 - X2|: zero, as dw/dtau = -2 r |V1 - V2| (friction force times path over E_cr)."""
    one = excursion()
    return half_tangent_form(one.excess - one.next_excess - 2 * r * one.displacement)


@cache
def next_excess() -> Expr:
    """w' = q (h^2 - 2 r D) as a function of theta: the excess after the excursion, with friction work."""
    return q * (h() ** 2 - 2 * r * displacement_of_angle())


def guard_of_u() -> Expr:
    """(V1 - V2)/sqrt(q) with epsilon = u sqrt(q): (theta - sin theta) - u (1 - cos theta)."""
    return expand(slip_from_ray().guard.subs(epsilon, h_value * sqrt(q)) / sqrt(q))


def duration_in_si() -> Expr:
    """The duration of an excursion of slip angle theta, s."""
    return theta / rates("slip-", DampingRegime.UNDAMPED)[rate]
