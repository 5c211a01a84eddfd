"""How fast E tends to E_cr over all trajectories with one E(0): an upper bound, a family without a lower one (a1 = 0).

Reduced coordinates; y0 = w0/q, and theta_0, c0 are the angle and the depth of the excursion with h(theta_0)^2 = y0.
"""

from functools import cache

from sympy import Expr, Max, Min, Symbol, acot, ceiling, pi, sqrt

from theory.energy import critical_energy, dwell_time_bound
from theory.rate_bounds import first_depth, first_excess
from theory.return_map import depth
from theory.scaling import stick_frequency, to_reduced
from theory.symbols import E0, q, r, tau, theta, w

crossings = Symbol("N", nonnegative=True)  # bound of the number of slips that cross S


@cache
def first_contact_bound() -> Expr:
    """The reduced time up to which S is met, from the bound of a stay with E = E_cr (1 + w)."""
    seconds = dwell_time_bound().subs(E0, critical_energy() * (1 + w))
    return to_reduced(seconds * stick_frequency())


def gain() -> Expr:
    """rho, the least gain of 1/y from ray to ray: r (c0/y0)^2."""
    return r * (first_depth / first_excess) ** 2


def crossing_loss() -> Expr:
    """The least loss of y by a slip that crosses S; its depth is at least c(2 arccot(q (sqrt y0 + pi/2))), or 1/q."""
    angle = 2 * acot(q * (sqrt(first_excess) + pi / 2))
    return 2 * r / q * Min(depth().subs(theta, angle), 1 / q)


def crossings_bound() -> Expr:
    """How many slips can cross S: y0 over the least loss, rounded up."""
    return ceiling(first_excess / crossing_loss())


def cycle_bound() -> Expr:
    """The longest reduced time from ray to ray, but for slips that cross: a slip of less than a turn, half a turn."""
    return pi * (1 + 2 * sqrt(q))


def late() -> Expr:
    """tau*: first contact and all slips that cross."""
    return first_contact_bound().subs(w, q * first_excess) + 2 * pi * sqrt(q) * crossings


def upper_bound() -> Expr:
    """The bound of w at the reduced time tau."""
    return q / (1 / first_excess + gain() * Max(0, (tau - late()) / cycle_bound() - 2))
