"""Without a damper, a force whose part at the frequency of body 1 is just what friction can take, U1 = 4b/pi.

theta = omega_1 t, from an instant on at which that part is greatest. Friction that turns at the zeros of cos(theta)
keeps the amplitude A = exp(-i theta)(v1 + i omega_1 x1) of body 1 periodic. Of any motion X and Y are the real and the
imaginary part of A, less those periodic parts, and P is v2 less its own: they change only while friction has turned too
early, or not yet.
"""

from functools import cache

from sympy import Expr, I, ImmutableMatrix, Symbol, cos, diff, expand, integrate, pi, sin

from theory.forced_response import amplitude_rate, natural
from theory.linear import root
from theory.model import slip
from theory.symbols import m1

ahead = Symbol("X", positive=True)
beside, faster = Symbol("Y", real=True), Symbol("P", real=True)
"""What the real and the imaginary part of A, and v2, are more than their periodic parts, m/s."""
own = Symbol("e", real=True)
"""What the periodic parts alone would make v2 - v1, times -1 or 1, at a zero of cos(theta), m/s."""
delay = Symbol("delta", real=True)
"""By what angle friction turns late at a zero of cos(theta)."""
moments = Symbol("D", nonnegative=True)
"""The sum of the squares of the integral of u sin(theta) at the zeros in a period, less its mean on a side, N^2 s^2."""
zeros, period = Symbol("N", positive=True, integer=True), Symbol("T", positive=True)
"""Turns of theta in a period of the force, and that period, s."""
push, order, phase, angle = Symbol("p", positive=True), Symbol("r", positive=True), Symbol("psi"), Symbol("theta")
"""A part p cos(r theta + psi) of the force."""


@cache
def passage(side: int) -> ImmutableMatrix:
    """What X, Y, P gain, m/s, where sin(theta) = side and friction turns late by `delay`: it is off by 2 side b."""
    since, sigma = Symbol("tau"), Symbol("sigma", real=True)
    turned = (cos(since) - I * sin(since)) / (I * side)  # exp(-i theta)
    of_amplitude = expand(diff(amplitude_rate(), sigma) * turned)
    rates = (of_amplitude - I * of_amplitude.coeff(I), of_amplitude.coeff(I), slip(1).acceleration2)
    return ImmutableMatrix([integrate(2 * side * expand(one) / natural, (since, 0, delay)) for one in rates])


@cache
def late(side: int) -> Expr:
    """By what angle friction turns late, to first order in 1/X: v1 - v2 = X cos(theta) - side (Y + side P + e) is 0."""
    return root(-side * ahead * delay - side * (beside + side * faster + own), delay)


def gain(side: int) -> ImmutableMatrix:
    """What X, Y, P gain there, m/s, each to its first order in 1/X."""
    return passage(side).applyfunc(lambda gained: gained.as_leading_term(delay).subs(delay, late(side)))


def growth() -> Expr:
    """What |A|^3/t tends to, m^3/s^4: 3 X^2 by the gain of X at all zeros of a period, where Y and P are 0."""
    of_one = gain(1)[0].subs({beside: 0, faster: 0}).expand()
    return 3 * ahead**2 * of_one.subs(own**2, moments / m1**2) / period


def moment() -> Expr:
    """An integral of p cos(r theta + psi) sin(theta) over the time, N s."""
    turn = order * angle + phase
    return -push * (order * sin(turn) * sin(angle) + cos(turn) * cos(angle)) / (natural * (1 - order**2))


def growth_by_one_part() -> Expr:
    """What |A|^3/t tends to where one part beside that at omega_1 is at a fraction of it: N is half of all zeros."""
    of_one = moment().subs({cos(angle): 0, sin(angle): 1, sin(order * angle + phase): 1})
    return growth().subs(moments, zeros * of_one**2).subs(period, 2 * pi * zeros / natural)
