"""The pair under a force u(t) on body 1: the load, the modes, what decides a tie, contraction and energy (a1 >= 0).

Everything follows from the branches of (3), (4) with u kept; b(t) in the place of b leaves the accelerations.
"""

from functools import cache

from sympy import (
    Expr,
    ImmutableMatrix,
    Integer,
    Rational,
    Symbol,
    factorial,
    sin,
    sqrt,
    symbols,
)

from theory.energy import energy, inner_product, other, sigma
from theory.filippov import STATE, derivative_along
from theory.fraction import factored, in_lowest_terms
from theory.linear import root
from theory.model import CASE_STUDY, branch_named, free_system, slip, stick
from theory.symbols import a1, a2, b, diff, m1, m2, put, t, total_mass, u, v1, v2, x1, x1_other

U_RATES = symbols(r"\dot{u} \ddot{u} u^{(3)} u^{(4)}", real=True)
"""Derivatives of u from the right, N/s, N/s^2, ..."""
u_other = Symbol(r"\tilde{u}", real=True)  # the force on a second solution, N
velocity_gap = Symbol("d", real=True)  # what both velocities of one pair are ahead of those of another, m/s
gap, gap_rate = symbols("y \\dot{y}", real=True)
"""Place (m) and velocity (m/s) of body 1 beside the motion that both modes follow at a tie."""


@cache
def load() -> Expr:
    """Lambda, N: the friction force on body 2 that sticking needs."""
    return factored(m2 * stick().acceleration1)


@cache
def coupling() -> Expr:
    """kappa, 1/kg: in slip of sign s the relative velocity has the rate kappa (Lambda - s b)."""
    found = slip(1)
    return factored((found.acceleration1 - found.acceleration2) / (load() - b))


def relative_rate(sign: int) -> Expr:
    """dw/dt in slip of a sign, m/s^2."""
    found = slip(sign)
    return found.acceleration1 - found.acceleration2


def reference(sign: int) -> Expr:
    """The motion of body 1, m, that slip of a sign and stick share to second order where Lambda = sign b."""
    return x1 + v1 * t + slip(sign).acceleration2 * t**2 / 2


@cache
def held_at_the_limit() -> Expr:
    """The force, N, under which the pair of Section IV, b = 1/2 N, sticks from rest at 0 with the load b for ever."""
    path = reference(1).subs({x1: 0, v1: 0})
    along = {x1: path, v1: diff(path, t)}
    balance = put(stick().acceleration1, along) - diff(path, t, 2)
    return root(balance, u).subs(CASE_STUDY).subs(b, Rational(1, 2))


@cache
def imbalance(sign: int) -> Expr:
    """p(t), N: (M/m2)(Lambda - sign b) along the reference, for the force u at that time."""
    along = {x1: reference(sign), v1: diff(reference(sign), t)}
    return in_lowest_terms(put(total_mass() / m2 * (load() - sign * b), along)).expand()


def jet(order: int) -> Expr:
    """The force as its Taylor polynomial of an order up to 4, N."""
    terms = (rate * t**k / factorial(k) for k, rate in enumerate(U_RATES[:order], start=1))
    return u + sum(terms, Integer(0))


def tie_derivative(sign: int, order: int) -> Expr:
    """The derivative of p of an order from 1 to 4 at the tie, N/s^order: the first nonzero one decides."""
    return put(diff(put(imbalance(sign), {u: jet(order)}), t, order), {t: 0})


@cache
def deviation_force(mode: str, sign: int) -> Expr:
    """I y'' + a1 y' + a2 y, N, for the place y of body 1 beside the reference in a mode of inertia I: it is p(t)."""
    place = reference(sign)
    along = {x1: place + gap, v1: diff(place, t) + gap_rate}
    found = branch_named(mode).acceleration1
    acceleration = put(found, along) - diff(place, t, 2)
    inertia = total_mass() if mode == "stick" else m1
    spring = -diff(found, x1) * inertia
    return in_lowest_terms(inertia * acceleration + a1 * gap_rate + spring * gap).expand()


def excess_load(sign: int) -> Expr:
    """Lambda - sign b, N, at the place y beside the reference."""
    place = reference(sign)
    along = {x1: place + gap, v1: diff(place, t) + gap_rate}
    return put(load() - sign * b, along)


@cache
def forced_system(sign: Expr, force: Expr = u) -> ImmutableMatrix:
    """The field on (x1, v1, v2) under a force, for a value of sign(v1 - v2); set-valued friction has any in [-1, 1]."""
    return ImmutableMatrix(free_system(sign) + ImmutableMatrix([0, force / m1, 0]))


@cache
def energy_rate() -> Expr:
    """dE/dt under a force, W, for a value sigma of sign(v1 - v2)."""
    return derivative_along(forced_system(sigma), energy()).expand()


@cache
def contraction_rate() -> Expr:
    """Rate of half the squared energy distance of two solutions under one force, W."""
    return distance_rate().subs(u_other, u)


@cache
def distance_rate() -> Expr:
    """The same where the second solution has a force of its own, W."""
    first, second = forced_system(sigma), other(forced_system(sigma, u_other))
    return inner_product(STATE - other(STATE), first - second).expand()


b_other = Symbol(r"\tilde{b}", positive=True)  # the friction at the place of the second solution, N
a1_other = Symbol(r"\tilde{a}_1", positive=True)  # the damper there, N s/m


def place_dependent_rate(sign: int) -> Expr:
    """The rate of half the squared distance of two slips of one sign with frictions b and b~, a1 = 0, W."""
    second = put(other(forced_system(sigma, u)), {other(sigma): sign, b: b_other})
    difference = forced_system(sigma).subs(sigma, sign) - second
    return inner_product(STATE - other(STATE), difference).expand().subs(a1, 0)


def place_dependent_damper_rate() -> Expr:
    """The rate of half the squared distance of two motions with one friction and the dampers a1 and a1~, W."""
    second = put(other(forced_system(sigma)), {other(sigma): sigma, other(u): u, a1: a1_other})
    return inner_product(STATE - other(STATE), forced_system(sigma) - second).expand()


def growth_by_place(slope: Expr) -> Expr:
    """The rate, 1/s, at which N may grow where b changes by at most `slope` (N/m) times the distance of the places.

    d(N^2/2)/dt is at most |b - b~| |w - w~|, and N^2 = 1 holds |x1 - x1~| and |w - w~| below these two.
    """
    return slope * sqrt(1 / diff(distance_squared(), x1, 2) * 2) * sqrt(_relative_by_distance())


def growth_by_speed(slope: Expr) -> Expr:
    """The rate, 1/s, at which N may grow where b falls by at most `slope` (N s/m) times the speed of the slip."""
    return slope * _relative_by_distance()


def _relative_by_distance() -> Expr:
    """The largest (w - w~)^2 with N = 1, 1/kg: by Cauchy and Schwarz the sum of the inverse coefficients of N^2."""
    return sum((2 / diff(distance_squared(), one, 2) for one in (v1, v2)), Integer(0))


def distance_squared() -> Expr:
    """N^2, J: the squared energy distance of two solutions."""
    return inner_product(STATE - other(STATE), STATE - other(STATE))


@cache
def undamped_difference() -> tuple[Expr, Expr]:
    """(x1 - x1~, w - w~), m and m/s, of two slips with one friction force, a1 = 0; omega_1 = sqrt(a2/m1).

    At the start x1 = x1~, and both velocities of the first pair are larger by d.
    """
    frequency = Symbol("omega_1", positive=True)
    first = forced_system(sigma)[1].subs(a1, 0)
    force = (first - other(first).subs(other(sigma), sigma)).subs(a2, m1 * frequency**2)
    place = velocity_gap / frequency * sin(frequency * t)
    left = diff(place, t, 2) - put(force, {x1: place, x1_other: 0})
    if left.expand() != 0:
        raise ArithmeticError(f"the difference of two slips leaves {left}")
    return place, diff(place, t) - velocity_gap


@cache
def breaking_damping() -> Expr:
    """The damping, N s/m, at which the stuck pair needs all of the friction at x1 = 0 and v1 > 0."""
    needed = load().subs({u: 0, x1: 0})
    return factored(root(needed + b, a1))


@cache
def creeping_load() -> Expr:
    """a2 x1 + a1 v1, N, on which a heavily damped body 1 settles in slip of sign sigma: where its acceleration is 0."""
    p = Symbol("p", real=True)
    acceleration = (m1 * free_system(sigma)[1]).subs(x1, root(load().subs(u, 0) + m2 * p / total_mass(), x1))
    return root(acceleration, p)
