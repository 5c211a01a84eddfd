"""The pair under u = U sin(omega t): the stuck response, permanent slip, two stops a period, resonance (a1 >= 0).

Slip moves body 1 alone, with the decay `decline` and the angular frequency `swing`, a1 = 2 m1 decline and
a2 = m1 (decline^2 + swing^2); expressions in them hold for an overdamped body 1 too, with an imaginary `swing`.
"""

from functools import cache

from sympy import (
    Expr,
    I,
    Symbol,
    asin,
    cos,
    exp,
    expand,
    fraction,
    integrate,
    pi,
    sin,
    sqrt,
    tan,
)

from theory.forced import load
from theory.fraction import in_lowest_terms
from theory.linear import root, roots
from theory.model import slip, stick
from theory.power_series import taylor
from theory.symbols import a1, a2, b, diff, m1, m2, put, t, total_mass, u, v1, x1

amplitude, omega = Symbol("U", positive=True), Symbol("omega", positive=True)
"""Amplitude (N) and angular frequency (1/s) of the force."""
decline, swing = Symbol("lambda", positive=True), Symbol("nu", positive=True)
"""Decay rate and angular frequency (1/s) of body 1 on its spring and damper."""
decayed = Symbol("delta", positive=True)
"""exp(-pi decline/omega): what is left of an oscillation of body 1 after half a period of the force."""
natural = Symbol("omega_1", positive=True)
"""sqrt(a2/m1), 1/s: the angular frequency of body 1 alone without a damper."""
sine_part, cosine_part = Symbol("S", real=True), Symbol("C", real=True)
"""u = S sin(omega t) + C cos(omega t), N, from the exit of a slip on."""
multiple = Symbol("n", positive=True, integer=True)  # Omega/omega, an odd number from 3 on
slip_length = Symbol("t_s", positive=True)
exit_place, exit_speed = Symbol("x_0", real=True), Symbol("v_0", real=True)
end_place, end_speed = Symbol("x_s", real=True), Symbol("v_s", real=True)
square_place, square_speed = Symbol("h", real=True), Symbol("h'", real=True)
"""What a square wave of friction of 1 N does: place (m/N) and velocity (m/s/N) of body 1 where its sign turns to 1."""


@cache
def rates() -> tuple[Expr, Expr]:
    """(lambda, omega_d), 1/s, of body 1 on its spring and damper: its motion has the roots -lambda +- i omega_d."""
    rate = Symbol("rho")
    acceleration = put(slip(1).acceleration1, {x1: 1, v1: rate, u: 0, b: 0})
    quadratic = expand(rate**2 - acceleration)
    half = quadratic.coeff(rate, 1) / 2
    return half, sqrt(quadratic.coeff(rate, 0) - half**2)


def left_after_half() -> Expr:
    """What half a period of the force leaves of an oscillation of body 1 that declines at the rate `decline`."""
    return exp(-decline * t).subs(t, pi / omega)


def impedance(acceleration: Expr, inertia: Expr) -> Expr:
    """Force by place, N/m, of a body with that acceleration on exp(i omega t): a2 - I omega^2 + i a1 omega."""
    along = {x1: 1, v1: I * omega, u: 0, b: 0}
    return -(inertia * omega**2) - inertia * put(acceleration, along)


def stuck_impedance() -> Expr:
    """Force by place of the stuck pair, N/m."""
    return impedance(stick().acceleration1, total_mass()).expand()


def slip_impedance() -> Expr:
    """Force by place of body 1 alone, N/m."""
    return impedance(slip(1).acceleration1, m1).expand()


def size_squared(impedance: Expr) -> Expr:
    """The square of the size of an impedance, by its parts in and out of phase."""
    out_of_phase = impedance.coeff(I)
    return (impedance - I * out_of_phase).expand() ** 2 + out_of_phase**2


@cache
def entrained_amplitude() -> Expr:
    """U*, N: the amplitude at which the stuck response needs all of the friction, omega^2 |x1| = b/m2."""
    place = amplitude / sqrt(size_squared(stuck_impedance()))
    return root(m2 * omega**2 * place - b, amplitude)


@cache
def harmonic_amplitude() -> Expr:
    """What U may be in units of U* where Omega = n omega without a damper, n = 3, 5, ...; dimensionless.

    A free oscillation turns the acceleration cos(phi) into cos(phi) - share cos(n phi). Its values at phi = pi/(2 n)
    and -pi/(2 n) are those of cos whatever is added, and its largest ones for the share with which it is flat there.
    """
    phi, share = Symbol("phi", real=True), Symbol("epsilon", positive=True)
    curve = cos(phi) - share * cos(multiple * phi)
    place = pi / (2 * multiple)
    flat = root(diff(curve, phi).subs(phi, place), share)
    return 1 / curve.subs(phi, place).subs(share, flat)


@cache
def harmonic_slope() -> Expr:
    """The slope of that acceleration for this share, by phi; 0 at pi/(2 n)."""
    phi = Symbol("phi", real=True)
    return sin(pi / (2 * multiple)) * sin(multiple * phi) - sin(phi)


@cache
def square_wave() -> tuple[Expr, Expr]:
    """Place and velocity of body 1 under a square wave of 1 N, where that turns from -1 to 1.

    In `decline`, `swing`, `decayed` = exp(-pi decline/omega), m1 and `omega`. The motion over half a period is a
    constant and a decaying oscillation, and the next half period is its negative.
    """
    first, second = Symbol("A"), Symbol("B")
    stiffness = m1 * (decline**2 + swing**2)
    place = 1 / stiffness + exp(-decline * t) * (first * cos(swing * t) + second * sin(swing * t))
    speed, half = diff(place, t), pi / omega
    left = {exp(-decline * half): decayed, cos(swing * half): Symbol("c"), sin(swing * half): Symbol("s")}
    ends = [put(put(one, {t: half}) + put(one, {t: 0}), left) for one in (place, speed)]
    found = dict(zip((first, second), roots(ends, [first, second]), strict=True))
    return _reduced(place.subs(t, 0).subs(found)), _reduced(speed.subs(t, 0).subs(found))


def _reduced(value: Expr) -> Expr:
    """The value as one fraction, without the square of the sine of half a period's turn."""
    turn = pi * swing / omega
    c, s = Symbol("c"), Symbol("s")
    parts = fraction(in_lowest_terms(put(value, {cos(turn): c, sin(turn): s})))
    above, below = (part.expand().subs(s**2, 1 - c**2) for part in parts)
    return in_lowest_terms(above / below).subs({c: cos(turn), s: sin(turn)})


def half_turn(value: Expr) -> Expr:
    """The value with k = tan(pi swing/(2 omega)) for the sine and the cosine of that turn: a rational function."""
    turn, k = pi * swing / omega, Symbol("k", real=True)
    return put(value, {cos(turn): (1 - k**2) / (1 + k**2), sin(turn): 2 * k / (1 + k**2)})


@cache
def non_stop_parts() -> tuple[Expr, Expr]:
    """Of the harmonic part a sin + c cos of x1 in a motion that slips always: a, and c where it leaves by an edge, m.

    A slip of sign 1 from t = 0 on: v2 rises from its lowest value at b/m2, both velocities agree, and the load is b.
    """
    a, c = Symbol("a", real=True), Symbol("c", real=True)
    lowest = -slip(1).acceleration2 * pi / omega / 2
    place, speed = c - b * square_place, a * omega - b * square_speed
    force = ((slip_impedance() - I * slip_impedance().coeff(I)) * c + slip_impedance().coeff(I) * a).expand()
    at_exit = put(load(), {u: force, x1: place, v1: speed}) - b
    return roots([speed - lowest, at_exit], [a, c])


@cache
def non_stop_amplitude_squared() -> Expr:
    """(U**)^2, N^2, by h and h'."""
    in_phase, out_of_phase = non_stop_parts()
    return (in_phase**2 + out_of_phase**2) * size_squared(slip_impedance())


@cache
def undamped_non_stop_amplitude_squared() -> Expr:
    """(U**)^2 for a1 = 0, N^2, by `natural`: h = 0, and h' = -tan(pi omega_1/(2 omega))/(m1 omega_1)."""
    turn = tan(pi * natural / (2 * omega))
    speed = {square_place: 0, square_speed: -turn / (m1 * natural)}
    return non_stop_amplitude_squared().subs(a1, 0).subs(speed).subs(a2, m1 * natural**2)


@cache
def resonant_non_stop_amplitude() -> Expr:
    """The limit of U** as omega tends to omega_1 without a damper, N."""
    off = Symbol("epsilon")  # pi omega_1/(2 omega) is pi/2 + off, and its tangent -cos(off)/sin(off)
    gap = 1 - natural**2 / omega**2
    residue = taylor(gap.subs(natural, omega * (1 + 2 * off / pi)) * -cos(off) / sin(off), off, 1)
    squared = undamped_non_stop_amplitude_squared().subs(tan(pi * natural / (2 * omega)), residue / gap)
    return sqrt(in_lowest_terms(squared).subs(natural, omega))


def two_stop_conditions() -> tuple[Expr, Expr, Expr]:
    """What the exit (x0, v0) and the end (xs, vs) of a slip of sign 1 meet, each expression zero.

    The load is b at the exit (N); both velocities agree at the end (m/s); and from the end the stuck pair comes to
    (-x0, -v0) in the rest of half a period: the last one is for a slip that lasts all of it, (m/s).
    """
    at_exit = put(load(), {u: cosine_part, x1: exit_place, v1: exit_speed}) - b
    at_end = end_speed - (exit_speed + slip(1).acceleration2 * slip_length)
    return at_exit, at_end, at_end.subs({end_speed: -exit_speed, slip_length: pi / omega})


def short_slip() -> tuple[Expr, Expr]:
    """The first two rates of w at an exit where the load is b, m/s^2 and m/s^3, by the rate of the load.

    The end w(ts) = 0 of a slip of length ts, divided by ts^2, tends to the second one: as ts -> 0 the load turns there.
    """
    load_rate = Symbol(r"\dot{\Lambda}", real=True)
    rate = put(slip(1).acceleration1 - slip(1).acceleration2, {x1: root(load() - b - load_rate * t, x1)})
    return expand(rate.subs(t, 0)), expand(diff(rate, t))


# Resonance of the slip without a damper: u has the Fourier amplitude U at omega_1.


def amplitude_rate() -> Expr:
    """Rate of z = exp(-i omega_1 t)(v1 + i omega_1 x1), m/s^2, times exp(i omega_1 t): no state is left in it."""
    sigma = Symbol("sigma", real=True)
    acceleration = ((u - a2 * x1 - b * sigma) / m1).subs(a2, m1 * natural**2)
    return (acceleration + I * natural * v1 - I * natural * (v1 + I * natural * x1)).expand()


@cache
def mean_absolute_cosine() -> Expr:
    """Mean of |cos| over a period, dimensionless."""
    return integrate(cos(t), (t, -pi / 2, pi / 2)) / pi


@cache
def resonant_amplitude() -> Expr:
    """The Fourier amplitude, N, at which the force gives as much as friction can take at most: U/2 = b mean |cos|."""
    return root(amplitude / 2 - b * mean_absolute_cosine(), amplitude)


@cache
def growth_rate() -> Expr:
    """What |z| grows by at least in the mean, m/s^2."""
    return (amplitude / 2 - b * mean_absolute_cosine()) / m1


@cache
def path_beside(offset: Expr) -> Expr:
    """The integral of |cos(s) - offset| over a period, for an offset between 0 and 1, dimensionless."""
    turn = pi / 2 - asin(offset)
    inside = 2 * integrate(cos(t) - offset, (t, 0, turn))
    return expand(inside + 2 * integrate(offset - cos(t), (t, turn, pi)))
