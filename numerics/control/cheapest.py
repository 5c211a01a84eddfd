"""From rest to rest over a distance in a given time with the least int u^2 dt, among motions that stick."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball
from numerics.control.answers import KEPT_DIGITS, number, solved_again
from numerics.control.least_energy import Search
from numerics.control.transfer import Transfer, TransferKind, read_transfer
from numerics.errors import InvalidScene
from numerics.habits import helpful
from numerics.scene import Force, Piece, Scene
from numerics.scene.decimals import Exact, decimal_text, positive
from numerics.scene.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class CheapestTransfer(ShortRepr):
    """A transfer over `distance` (m) in the time `time` (s), and its force as a scene; `digits` right digits.

    `bound` (s): lower bound on the time of every transfer. `energy` (N^2 s): int u^2 dt up to that time;
    `least_energy`: proved lower bound on it for all transfers that stick and keep the margin, which is less by a part
    of some 10^-18 if `is_at_limit`: whether friction is at its limit, or at the margin, at times.

    >>> from numerics import load_scene
    >>> found = cheapest_transfer(load_scene("at-rest"), "0.01", "0.3")
    >>> [one.str(15, radius=False) for one in (found.energy, found.least_energy)], found.is_at_limit
    (['0.295046099130115', '0.295046099130115'], True)
    """

    distance: Fraction
    time: arb
    bound: arb
    energy: arb
    least_energy: arb
    is_at_limit: bool
    scene: Scene
    digits: int

    road, sticks, goal = TransferKind.CHEAPEST, True, Transfer.goal


@helpful
def cheapest_transfer(
    scene: Scene, distance: Exact, time: Exact, *, margin: Exact = 0, digits: int = 15, max_digits: int | None = None
) -> CheapestTransfer:
    """Return the transfer of a scene's pair over a distance (m) in a time (s) that sticks and has the least int u^2 dt.

    Its load is at most (1 - margin) b; it is solved again by events. Raises InvalidScene (a time below the least one
    among others), NotSettled (no force was found), PrecisionExhausted, TypeError (no scene), ValueError (digits).

    >>> from numerics import load_scene
    >>> found = cheapest_transfer(load_scene("at-rest"), "0.001", "0.2")
    >>> found.energy.str(6, radius=False), found.is_at_limit, len(found.scene.force.pieces)
    ('0.00408826', False, 3)
    """
    by, part = read_transfer("cheapest_transfer", scene, distance, margin, digits, max_digits)
    pair, far, until = scene.pair, abs(by), positive(time, "time")
    most = (1 - part) * pair.b / pair.m2

    def attempt(_: Ball) -> tuple[CheapestTransfer, list[arb]]:
        bound, search = 2 * number(far / most).sqrt(), Search(pair, far, until)
        if number(until) < bound:
            raise InvalidScene(
                f"time = {decimal_text(until)} s must be at least 2 sqrt(m2 D/((1 - margin) b)) = "
                f"{bound.str(15, radius=False)} s, as no transfer is faster; give more time, or less distance or margin"
            )
        found = search.force(most)
        force = Force((*(one for one, _ in found.parts), Piece(until, (pair.a2 * far,))))
        planned = Scene(pair, scene.initial, until=until * 3 / 2, force=force if by > 0 else -force)
        energies = search.bound(found, most)
        at_limit = any(side for _, side in found.parts)
        return CheapestTransfer(by, number(until), bound, *energies, at_limit, planned, digits), list(energies)

    found = to_digits(attempt, max(digits, KEPT_DIGITS), max_digits)
    solved_again(found)
    return found
