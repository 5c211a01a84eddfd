"""From rest to rest over a distance in a given time with the least int u^2 dt, or max |u|, among motions that stick."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

from flint import arb

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball
from numerics.control.answers import KEPT_DIGITS, SlipsAgain, number, solved_again
from numerics.control.least_peak import least_peak
from numerics.control.optimal import LeastEnergy
from numerics.control.transfer import Transfer, TransferKind, read_transfer
from numerics.errors import InvalidScene, NotSettled
from numerics.scene import Force, Pair, Piece, Scene
from numerics.scene.decimals import Exact, decimal_text, positive
from numerics.scene.short_repr import ShortRepr

_CLOSE = Fraction(1, 10**12)
"""By this part at most what is proved to be the least may be below the cost of the force."""


@dataclass(frozen=True, repr=False)
class CheapestTransfer(ShortRepr):
    """A transfer over `distance` (m) in the time `time` (s), and its force as a scene; `digits` right digits.

    `bound` (s): lower bound on the time of every transfer. `road`: what it has least of. `cost`: int u^2 dt (N^2 s), or
    max |u| (N), up to that time; `least_cost`: proved lower bound on it for all transfers that stick and keep the
    margin, which is less by a part of some 10^-18. `is_at_limit`: whether friction is at its limit, or at the margin,
    at times.

    >>> from numerics import load_scene
    >>> found = cheapest_transfer(load_scene("at-rest"), "0.01", "0.3")
    >>> [one.str(15, radius=False) for one in (found.cost, found.least_cost)], found.is_at_limit
    (['0.295046099130115', '0.295046099130115'], True)
    """

    distance: Fraction
    time: arb
    bound: arb
    road: TransferKind
    cost: arb
    least_cost: arb
    is_at_limit: bool
    scene: Scene
    digits: int

    sticks, goal = True, Transfer.goal

    @property
    def holding_force(self) -> Fraction:
        """Return a2 D, the force (N) that holds the pair at its new place after that time; no part of the cost."""
        return self.scene.pair.a2 * self.distance


def cheapest_transfer(
    scene: Scene,
    distance: Exact,
    time: Exact,
    *,
    least: str = "energy",
    margin: Exact = 0,
    digits: int = 15,
    max_digits: int | None = None,
) -> CheapestTransfer:
    """Return the transfer of a scene's pair over a distance (m) in a time (s) that sticks and has the least int u^2 dt.

    `least="peak"`: the least max |u| up to that time instead. The load is at most (1 - margin) b. Raises InvalidScene
    (a time below the least one among others), NotSettled (no force was found), PrecisionExhausted, TypeError (no
    scene), ValueError (digits).

    >>> from numerics import load_scene
    >>> found = cheapest_transfer(load_scene("at-rest"), "0.001", "0.2")
    >>> found.cost.str(6, radius=False), found.is_at_limit, len(found.scene.force.pieces)
    ('0.00408826', False, 3)
    >>> cheapest_transfer(load_scene("at-rest"), "0.001", "0.2", least="peak").cost.str(6, radius=False)
    '0.167016'
    """
    by, part = read_transfer("cheapest_transfer", scene, distance, margin, digits, max_digits)
    pair, far, until = scene.pair, abs(by), positive(time, "time")
    tight = replace(pair, b=(1 - part) * pair.b)
    if least not in _FIND:
        raise InvalidScene(f"least = {least!r} must be one of {', '.join(_FIND)}; leave it out for the least energy")
    road, find = _FIND[least]

    def attempt(_: Ball) -> tuple[CheapestTransfer, list[arb]]:
        bound, fastest = (2 * number(one.m2 * far / one.b).sqrt() for one in (pair, tight))
        if number(until) < fastest:
            raise InvalidScene(
                f"time = {decimal_text(until)} s must be at least 2 sqrt(m2 D/((1 - margin) b)) = "
                f"{fastest.str(15, radius=False)} s, as no transfer that keeps the margin is faster; give more time, "
                "or less distance or margin"
            )
        pieces, cost, least_cost, at_limit = find(tight, far, until)
        if not cost - least_cost < cost * number(_CLOSE):
            raise NotSettled(
                f"no force of least {least} was found: {least_cost.str(6)} is proved, {cost.str(6)} is needed; give "
                "another time"
            )
        force = Force((*pieces, Piece(until, (pair.a2 * far,))))
        planned = Scene(pair, scene.initial, until=until * 3 / 2, force=force if by > 0 else -force)
        found = CheapestTransfer(by, number(until), bound, road, cost, least_cost, at_limit, planned, digits)
        return found, [cost, least_cost]

    found = to_digits(attempt, max(digits, KEPT_DIGITS), max_digits)
    try:
        solved_again(replace(found, scene=replace(found.scene, pair=tight)))
    except SlipsAgain as error:
        raise NotSettled(
            f"no force of least {least} was found: under that of the search friction gives way; give another time"
        ) from error
    return found


def _energy(pair: Pair, far: Fraction, until: Fraction) -> tuple[list[Piece], arb, arb, bool]:
    search = LeastEnergy(pair, far, until)
    found = search.force()
    cost, least = (search.mass**2 * one for one in search.bound(found))
    return search.pieces(found), cost, least, any(part.arc.side for part in found.parts)


_FIND = {"energy": (TransferKind.CHEAPEST, _energy), "peak": (TransferKind.GENTLEST, least_peak)}
