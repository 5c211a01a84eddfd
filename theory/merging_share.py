"""How much of an energy sphere merges, for r <= r*: an integral over the disc of captive contacts (a1 = 0, reduced).

The states with E/E_cr = e that first meet S at (X, V) are those on the slip that ends there. The flow keeps volume, so
their share of the sphere is the flux through S over the rate at which the energy passes e, over the sphere's measure.
"""

from functools import cache

from sympy import Expr, Symbol, expand, limit, oo, pi, sqrt

from theory.fraction import in_lowest_terms
from theory.scaling import excess_rate, reduced_energy, reduced_slip
from theory.symbols import V1, V2, X, diff, q, r

level = Symbol("e", positive=True)  # E/E_cr
relative = Symbol("g", positive=True)  # |V1 - V2| where the slip has the energy e


@cache
def divergence() -> Expr:
    """The divergence of the slip field: 0, so volume is kept."""
    field = reduced_slip(-1)
    return sum(diff(entry, one) for entry, one in zip(field, (X, V1, V2), strict=True))


@cache
def flux() -> Expr:
    """Rate of V1 - V2 on S in the slip with v1 < v2: (1 - X)/q."""
    field = reduced_slip(-1)
    return in_lowest_terms((field[1] - field[2]).subs(V2, V1))


@cache
def dissipation() -> Expr:
    """-d(E/E_cr)/dtau in that slip where V1 - V2 = -g: 2 r g."""
    return in_lowest_terms(-excess_rate(-1).subs(V2, V1 + relative))


@cache
def sphere() -> Expr:
    """The measure of {E/E_cr = e}: the volume within, differentiated."""
    axes = [1 / sqrt(diff(reduced_energy(), one, 2) / 2) for one in (X, V1, V2)]
    volume = 4 * pi / 3 * axes[0] * axes[1] * axes[2] * sqrt(level) ** 3
    return diff(volume, level)


@cache
def density() -> Expr:
    """What a point (X, V) of the disc adds to the share, both half-spaces together."""
    share = Symbol("r", positive=True)  # 1 - q, of which sphere and dissipation have powers that cancel
    lost, size = (one().subs(q, 1 - share) for one in (dissipation, sphere))
    return (2 * flux() / in_lowest_terms(lost) / size).subs(share, r)


@cache
def large_energy_limit() -> Expr:
    """lim e times the share as e grows: there r g^2/e tends to 1, and the integral of 1 - X over the disc is pi.

    Raises ValueError for a density that is not linear in X: sympy's integral of another one may take for ever.
    """
    at = expand(density().subs(relative, sqrt(level) / sqrt(r)) * level)
    even, odd = at.coeff(X, 0), at.coeff(X, 1)
    if expand(at - even - odd * X) != 0 or {V1, V2} & at.free_symbols:
        raise ValueError(f"the density is {at}, which is not linear in X alone: its integral is not known here")
    return limit(pi * even, level, oo)
