"""Two-sided bounds of one excursion from a ray, behind the 1/t law and the absence of merging (a1 = 0).

All statements are for slip angles 0 < theta <= theta_0 <= pi/2; each rests on a form whose sign is manifest.
As w decreases from one excursion to the next, so does theta: a bound for the first holds for all that follow.
"""

from functools import cache

from sympy import Expr, Rational, Symbol, cos, factor, limit, pi, simplify, sqrt

from theory.excursion import displacement_of_angle, h, h_slope, half_tangent, half_tangent_form
from theory.symbols import diff, q, r, theta


@cache
def dissipation_density() -> Expr:
    """rho(theta) = D'/(h^3 h'): displacement per fourth power of the exit speed, D = integral of rho h^3 dh."""
    density = half_tangent_form(diff(displacement_of_angle(), theta) / (h() ** 3 * h_slope()))
    # Only even powers of k = tan(theta/2) are left.
    return factor(simplify(density.subs(half_tangent, sqrt((1 - cos(theta)) / (1 + cos(theta))))))


@cache
def density_at_zero() -> Expr:
    """The limit of rho at theta = 0, its supremum on (0, 2 pi)."""
    return limit(dissipation_density(), theta, 0)


@cache
def inverse_step() -> Expr:
    """1/w' - 1/w of one excursion, exact in theta: (2r/q)(D/h^4)/(1 - 2r D/h^2)."""
    path, height = displacement_of_angle(), h()
    return 2 * r / q * (path / height**4) / (1 - 2 * r * path / height**2)


def inverse_step_bounds() -> tuple[Expr, Expr]:
    """Lower and upper bound of 1/w' - 1/w for all slip angles up to theta (here theta_0 <= pi/2).

    rho(theta_0) <= rho <= rho(0) bounds D/h^4 by a fourth of each; D' = h (1 - cos theta) h' bounds D/h^2 by
    (1 - cos theta_0)/2.  Both bounds tend to the constant of the 1/t law as theta_0 -> 0.
    """
    lower = 2 * r / q * dissipation_density() / 4
    upper = 2 * r / q * density_at_zero() / 4 / (1 - r * (1 - cos(theta)))
    return lower, upper


def no_merging_excess() -> Expr:
    """A level of w, dimensionless: from a ray at or below it every excursion ends in S0 with 0 < w' < w.

    It is w at theta = pi/2, where dw'/dtheta > 0 for every q and re-entry is inside S0: "slightly higher than
    E_cr" made explicit.  Larger values may also do.
    """
    return factor((q * h() ** 2).subs(theta, pi / 2))


# The first exit's y0 = w0/q, depth c0, slip angle theta_0, and the reduced time s since then (dimensionless).
first_excess, first_depth, first_angle = (Symbol(name, positive=True) for name in ("y_0", "c_0", "theta_0"))
elapsed = Symbol("s", nonnegative=True)


def gains() -> tuple[Expr, Expr]:
    """Least and largest gain (a', A) of 1/y per excursion from the first exit on.

    y - y' = r c^2 with c/y >= c0/y0 and c <= 3 y/2 lies between a' y^2 and (9 r/4) y^2, and y'/y >= 1 - r c0^2/y0.
    """
    slowest = r * (first_depth / first_excess) ** 2
    fastest = Rational(9, 4) * r / (1 - r * first_depth**2 / first_excess)
    return slowest, fastest


def cycle_times() -> tuple[Expr, Expr]:
    """Shortest and longest reduced time (T_-, T_+) of an excursion and its stick from the first exit on."""
    inward = q * first_depth / (1 - q * first_depth)
    return pi - sqrt(q) * (first_angle - sqrt(first_excess)) * inward, pi + sqrt(q) * first_angle


def excess_bounds() -> tuple[Expr, Expr]:
    """Bounds of w at the reduced time s after the first exit: q over 1/y0 and what it has gained."""
    (slowest, fastest), (shortest, longest) = gains(), cycle_times()
    least = q / (1 / first_excess + fastest * (elapsed / shortest + 1))
    return least, q / (1 / first_excess + slowest * (elapsed / longest - 1))
