"""Friction with presliding: a spring of stiffness k in series with Coulomb's slider, which slips at the force b.

The force on body 2 is k delta with |delta| <= b/k; delta' is the relative velocity less that of the slider.
"""

from functools import cache

from sympy import Expr, Symbol, symbols

from theory.energy import inner_product, other, sigma
from theory.filippov import STATE
from theory.linear import root
from theory.model import free_system
from theory.symbols import b

stiffness = Symbol("k", positive=True)  # N/m
deflection = Symbol("delta", real=True)  # of that spring, m
deflection_rate, slider_rate = symbols(r"\dot{\delta} s", real=True)  # m/s; their sum is v1 - v2
variation = Symbol("V", nonnegative=True)  # of friction over b in slips and sticks, dimensionless


@cache
def largest_deflection() -> Expr:
    """The presliding displacement at which the slider slips, m (exact)."""
    return root(stiffness * deflection - b, deflection)


@cache
def distance_rate() -> Expr:
    """Rate of half the squared energy distance of a motion with that spring to one of Coulomb's law (tilde), W."""
    spring = free_system(stiffness * deflection / b)
    return inner_product(STATE - other(STATE), spring - other(free_system(sigma))).expand()


def distance_squared() -> Expr:
    """Upper bound of N^2, J: twice the spring's energy at the start, and twice b times the integral of sigma delta'."""
    at_start = stiffness * largest_deflection() ** 2
    return at_start + 2 * b * (2 + variation) * largest_deflection()
