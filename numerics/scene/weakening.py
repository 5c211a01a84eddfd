"""Friction that depends on the state: B of the speed |v1 - v2|, C of the place x1 - x2, by affine pieces. Exact."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from numerics.errors import InvalidScene
from numerics.scene.decimals import Exact, exact_decimal, keep, put, short
from numerics.scene.short_repr import ShortRepr

MAX_POINTS = 1000
_TWO_COEFFICIENTS = (
    "friction at rest above that in slip, without a slope between them, is ill-posed: for a load between the two stick "
    "and slip are both solutions at every instant; take B continuous, however steep"
)


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Weakening(ShortRepr):
    """F = sgn(w) (B(|w|) + C(z)), w = v1 - v2 (m/s), z = x1 - x2 (m): what friction is in slip; at rest B(0) + C(z).

    B goes from the pair's b at w = 0 through the points `speed`, (|w|, B in N), linear between, and on from the last
    one with `last_slope` (N s/m). C is linear between the points `place`, (z, C in N), and constant outside of them.
    Where b changes in time by pieces, B and C are both scaled by b(t)/b. It is a part of the scene's friction:
    `Scene(pair, state, until, friction=Friction(weakening=falling))`. Raises InvalidScene.

    >>> falling = Weakening(speed=[("0.05", "0.3")], last_slope="0.4")
    >>> falling, falling.speed, falling.last_slope, falling.place
    (Weakening(speed=((0.05, 0.3),), last_slope=0.4), ((Fraction(1, 20), Fraction(3, 10)),), Fraction(2, 5), ())
    """

    speed: tuple[tuple[Fraction, Fraction], ...]
    last_slope: Fraction
    place: tuple[tuple[Fraction, Fraction], ...]

    def __init__(
        self,
        speed: Iterable[tuple[Exact, Exact]] = (),
        last_slope: Exact = 0,
        place: Iterable[tuple[Exact, Exact]] = (),
    ) -> None:
        """Read the points; both lists in order, B and C continuous."""
        speeds, places = _points(speed, "speed", "|w|", "B"), _points(place, "place", "z", "C")
        for (before, _), (w, b) in pairwise(((Fraction(0), Fraction(0)), *speeds)):
            if w < before:
                raise InvalidScene(f"speed has |w| = {short(w)} after {short(before)}; give points in order of |w| > 0")
            if w == before:
                raise InvalidScene(f"speed has a second B = {short(b)} at |w| = {short(w)}: {_TWO_COEFFICIENTS}")
        for one, two in pairwise(places):
            if two[0] <= one[0]:
                raise InvalidScene(
                    f"place has z = {short(two[0])} after {short(one[0])}; give points in order, with one C at each z"
                )
        put(self, speed=speeds, place=places)
        keep(self, last_slope=last_slope)


def two_coefficients(key: str) -> InvalidScene:
    """Return the error for a friction with one coefficient at rest and another one in slip."""
    return InvalidScene(f"{key}: {_TWO_COEFFICIENTS}, as [weakening] speed = [[|w|, B], ...]")


def _points(given: Any, name: str, first: str, second: str) -> tuple[tuple[Fraction, Fraction], ...]:
    """Return points of a table, exact."""
    try:
        pairs = [(one, two) for one, two in given]
    except (TypeError, ValueError):
        raise InvalidScene(f"{name} must be points; write {name} = [[{first}, {second}], ...]") from None
    if len(pairs) > MAX_POINTS:
        raise InvalidScene(f"{name} has {len(pairs)} points; at most {MAX_POINTS} are read")
    return tuple(
        (exact_decimal(one, f"{first} in {name}"), exact_decimal(two, f"{second} in {name}")) for one, two in pairs
    )
