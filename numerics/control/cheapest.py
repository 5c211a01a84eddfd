"""From rest to rest over a distance in a given time with the least int u^2 dt, or max |u|, among motions that stick."""

from __future__ import annotations

from dataclasses import replace

from flint import arb

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball
from numerics.control.answers import KEPT_DIGITS, SlipsAgain, number, solved_again
from numerics.control.optimal import LeastEnergy, LeastPeak
from numerics.control.transfer import Transfer, TransferKind, read_transfer
from numerics.errors import InvalidScene, NotSettled
from numerics.scene import Force, Piece, Scene
from numerics.scene.decimals import Exact, decimal_text, positive, require_one_of, short

_CLOSE = 1e-12
"""By this part at most what is proved to be the least may be below the cost of the force."""
_FIND = {"energy": (TransferKind.CHEAPEST, LeastEnergy), "peak": (TransferKind.GENTLEST, LeastPeak)}


def cheapest_transfer(
    scene: Scene,
    distance: Exact,
    time: Exact,
    *,
    least: str = "energy",
    margin: Exact = 0,
    digits: int = 15,
    max_digits: int | None = None,
) -> Transfer:
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
    require_one_of("least", least, _FIND)
    road, find = _FIND[least]

    def attempt(_: Ball) -> tuple[Transfer, list[arb]]:
        bound, fastest = (2 * number(one.m2 * far / one.b).sqrt() for one in (pair, tight))
        if number(until) < fastest:
            raise InvalidScene(
                f"time = {decimal_text(until)} s must be at least 2 sqrt(m2 D/((1 - margin) b)) = "
                f"{fastest.str(15, radius=False)} s, as no transfer that keeps the margin is faster; give more time, "
                "or less distance or margin"
            )
        search = find(tight, far, until)
        found = search.force()
        cost, least_cost = search.bound(found)
        if not cost - least_cost < cost * _CLOSE:
            raise search.not_found
        force = Force((*search.pieces(found), Piece(until, (pair.a2 * far,))))
        at_limit = any(one.arc.side for one in found.parts)
        planned = Scene(pair, scene.initial, until=until * 3 / 2, force=force if by > 0 else -force)
        known = {"cost": cost, "least_cost": least_cost, "is_at_limit": at_limit, "holding_force": pair.a2 * by}
        return Transfer(by, part, road, bound, number(until), planned, digits, **known), [cost, least_cost]

    try:
        found = to_digits(attempt, max(digits, KEPT_DIGITS), max_digits)
        assert found.scene is not None
        solved_again(replace(found, scene=replace(found.scene, pair=tight)))
    except (NotSettled, SlipsAgain) as error:  # under the force of a search that fails friction may give way
        end = pair.a2 * far - tight.b * pair.mass / pair.m2
        needed = f"; with any time the end needs a peak of {short(end)} N" if least == "peak" and end > 0 else ""
        raise NotSettled(f"{error}{needed}; give another time") from error
    return found
