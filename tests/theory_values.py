"""What `theory` states of one pair, as numbers: exact where all is rational, balls elsewhere."""

from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb, fmpq

from numerics import Pair, Scene
from paper_checks.decide.at_point import at_point
from theory import excursion, return_map, scaling, symbols
from theory.energy import critical_energy, energy

MOST_ANGLE = arb("6.2831853")
"""A slip angle below 2 pi."""


def exact(value: Fraction | int) -> fmpq:
    """A rational as one of flint's."""
    return fmpq(value.numerator, value.denominator)


def of_pair(expression: sp.Expr, pair: Pair, **letters: Any) -> Any:
    """An expression in the parameters of a pair, SI or reduced, and in other letters by their names in `theory`."""
    numbers = {name: getattr(pair, name) for name in ("m1", "m2", "a1", "a2", "b")} | {"q": pair.share} | letters
    known = {str(one): one for one in expression.free_symbols}
    point = {known[name]: one for name, one in numbers.items() if name in known}
    return at_point(expression, {one: exact(n) if isinstance(n, Fraction | int) else n for one, n in point.items()})


def energy_of(pair: Pair, state: Any) -> Any:
    """E of a state (x1, v1, x2, v2), J."""
    x1, v1, _, v2 = state
    return of_pair(energy(), pair, x1=x1, v1=v1, v2=v2)


def start_of(scene: Scene) -> tuple[Fraction, ...]:
    """The state at t = 0, exact."""
    at = scene.initial
    return at.x1, at.v1, at.x2, at.v2


def excess_of(scene: Scene) -> fmpq:
    """E/E_cr - 1 at t = 0, exact."""
    return energy_of(scene.pair, start_of(scene)) / of_pair(critical_energy(), scene.pair) - 1


def reduced_time(pair: Pair, t: Fraction | arb) -> arb:
    """Omega t."""
    return of_pair(scaling.stick_frequency(), pair) * (exact(t) if isinstance(t, Fraction | int) else t)


def excursion_of(y: arb) -> dict[str, arb]:
    """The letters of an excursion with h(theta_0)^2 = y > 0: y_0, its slip angle theta_0 and its depth c_0.

    h and c rise with the angle: both are enclosed between the ends of a bracket. theta/3 <= h, and h <= theta/2 for
    theta <= 3/2. Raises AssertionError where h(theta)^2 - y does not change its sign between the ends.
    """
    height = arb(y).sqrt()
    low, high = (2 * height).min(arb(1.5)).mid(), (3 * height * (1 + arb(2) ** -30)).min(MOST_ANGLE).mid()
    for _ in range(70):
        middle = ((low + high) / 2).mid()
        low, high = (middle, high) if push(middle) < height else (low, middle)
    assert push(low) < height < push(high)
    deep = [at_point(return_map.depth(), {symbols.theta: one}) for one in (low, high)]
    return {"y_0": y, "theta_0": low.union(high), "c_0": deep[0].union(deep[1])}


def push(angle: arb) -> arb:
    """h of a slip angle."""
    return at_point(excursion.h(), {symbols.theta: angle})
