"""The least int u^2 dt of a transfer of the stuck pair from rest to rest: what bounds it, and what it is (a1 >= 0)."""

from functools import cache

from sympy import Expr, Symbol, cos, integrate, sin, sqrt, symbols

from theory.forced_control import (
    angle,
    duration,
    path,
    r_acceleration,
    r_place,
    r_speed,
    strongest,
    stuck_force,
)
from theory.linear import root, roots
from theory.scaling import stick_frequency
from theory.symbols import a1, a2, diff, m1, t, total_mass

weight, rate, bend = symbols(r"w \dot{w} \ddot{w}", real=True)
"""Any function of time beside the force, N, and its derivatives."""
once, twice = symbols("S R", real=True)  # int_t^T w ds, N s; int_t^T S ds, N s^2
nu, mu = symbols("nu mu", real=True)  # multipliers of v1(T) = 0 and x1(T) = D
slide, slip, slip_rate = symbols(r"z \dot{z} \ddot{z}", real=True)
height, beyond = symbols("c h", positive=True)
"""Largest velocity of a trapezoid, m/s; distance beyond the sliding region, m."""
RATES = {r_place: r_speed, r_speed: r_acceleration, once: -weight, twice: -once, weight: rate, rate: bend, slide: slip}
RATES |= {slip: slip_rate, t: 1}


def along(value: Expr) -> Expr:
    """The rate of a quantity along a stuck motion."""
    return sum(diff(value, one) * speed for one, speed in RATES.items())


def gathered() -> Expr:
    """What the pairing of w with the force leaves at both ends: 0 at the start, mu D at the end."""
    left = mu * (duration - t) - nu
    return left * r_speed + mu * r_place - a1 * once * r_speed - a2 * (twice * r_speed + once * r_place)


@cache
def misfit() -> Expr:
    """rho, N kg: what w times the force of a stuck motion has per acceleration, beside the rate of `gathered`."""
    return diff((weight * stuck_force() - along(gathered())).expand(), r_acceleration)


@cache
def adjoint() -> Expr:
    """w'' where rho is 0 over a time, N/s^2."""
    return root(along(along(misfit())).expand(), bend)


def end_multiplier() -> Expr:
    """mu, N kg/s, of a w for which rho is 0 up to T, where S is 0; w and its rate are those at T."""
    return root(along(misfit()).subs(once, 0).expand(), mu)


@cache
def undamped_energy() -> Expr:
    """The least int u^2 dt without a damper and below the limit of friction, N^2 s, by the angle Omega T.

    u = A sin + B cos of Omega (T - t): x1(T) and v1(T) are its integrals with this sine and cosine, over M Omega and M.
    """
    first, second = symbols("A B")
    force, omega = first * sin(t) + second * cos(t), stick_frequency()
    place, speed = (integrate((force * one).expand(), (t, 0, angle)) for one in (sin(t), cos(t)))
    reached = total_mass() * omega * path
    return roots((place - reached * omega, speed), (first, second))[0] * reached


def trapezoid(power: int) -> Expr:
    """The integral of a power of the velocity that rises at the limit of friction to `height`, stays, and falls."""
    ramp = height / strongest()
    return 2 * integrate((strongest() * t) ** power, (t, 0, ramp)) + height**power * (duration - 2 * ramp)


def work() -> Expr:
    """The work of the force along the trapezoid, J: the spring keeps its part, the damper takes the rest."""
    return a2 * path**2 / 2 + a1 * trapezoid(2)


def slip_force() -> Expr:
    """What body 1 needs beyond the stuck pair to be at z = x1 - x2, where x2 stays as it is, N."""
    return m1 * slip_rate + a1 * slip + a2 * slide


def slip_gathered() -> Expr:
    """What the pairing of w with that force leaves at both ends, where it is 0."""
    return m1 * weight * slip - a2 * once * slide


@cache
def slip_weight() -> Expr:
    """kappa, N^2 s/m: what w times that force has per slip velocity, beside the rate of `slip_gathered`."""
    return diff((weight * slip_force() - along(slip_gathered())).expand(), slip)


def far_energy() -> Expr:
    """The least int u^2 dt of a stuck transfer that ends by h > 0 beyond the strip, N^2 s, in whatever time.

    At y before its farthest place the velocity is at most sqrt(2 b y/m2), and the force at least a2 (h - y).
    """
    way = Symbol("y", positive=True)
    return integrate(a2**2 * (beyond - way) ** 2 / sqrt(2 * strongest() * way), (way, 0, beyond))
