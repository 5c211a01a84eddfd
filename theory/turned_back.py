"""The pair turned back by the angle of stick: two numbers that only slip changes (a1 = 0).

With P = m1 v1 + m2 v2, M = m1 + m2 and Omega^2 = a2/M the point (x1, P/(M Omega)) turned back by Omega t has
coordinates A and B that change at the rates (m2/M)(v1 - v2) cos(Omega t) and (m2/M)(v1 - v2) sin(Omega t), whatever
friction is.
"""

from functools import cache

from sympy import Expr, ImmutableMatrix, cos, sin, sqrt

from theory.energy import sigma
from theory.filippov import derivative_along, guard
from theory.model import free_system
from theory.symbols import a2, diff, m1, m2, t, total_mass, undamped, v1, v2, x1


def frequency() -> Expr:
    """Omega = sqrt(a2/M), rad/s."""
    return sqrt(a2 / total_mass())


def momentum() -> Expr:
    """P = m1 v1 + m2 v2, kg m/s."""
    return m1 * v1 + m2 * v2


@cache
def coordinates() -> ImmutableMatrix:
    """(A, B), m: (x1, P/(M Omega)) turned back by Omega t."""
    other = momentum() / (total_mass() * frequency())
    angle = frequency() * t
    return ImmutableMatrix([x1 * cos(angle) - other * sin(angle), x1 * sin(angle) + other * cos(angle)])


@cache
def rates() -> ImmutableMatrix:
    """(dA/dt, dB/dt), m/s, along (5)-(7) for every value sigma of friction."""
    field = undamped(free_system(sigma))
    return ImmutableMatrix([diff(one, t) + derivative_along(field, one) for one in coordinates()])


def claimed_rates() -> ImmutableMatrix:
    """(m2/M)(v1 - v2) (cos Omega t, sin Omega t): zero in stick."""
    angle = frequency() * t
    return m2 / total_mass() * guard() * ImmutableMatrix([cos(angle), sin(angle)])


def relative_rate() -> Expr:
    """d(v1 - v2)/dt along (5)-(7) for every value sigma of friction, m/s^2."""
    return derivative_along(undamped(free_system(sigma)), guard())
