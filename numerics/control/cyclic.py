"""Newton's step for equations in a ring, each of which joins the unknowns of an event to those of the next one.

With three unknowns d_k an event (a 3x1 matrix), the equations miss_k + A_k d_k + B_k d_(k+1) = 0, and the last event
before the first, each d_(k+1) is an affine map of d_k. Products of these maps are taken as a tree: a periodic motion
contracts, so they stay small, and in a tree of balls a radius grows by a factor a level, not a factor an event. The
cost is that of so many 3x3 matrices; the whole as one matrix would cost the cube of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import arb, arb_mat

from numerics.arithmetic.ball_words import working_digits
from numerics.errors import EventUndecided

SIZE = 3
"""Unknowns of an event."""


class Link(NamedTuple):
    """How far an equation is missed, and its derivatives by the unknowns of its event and of the next one."""

    miss: arb_mat
    here: arb_mat
    ahead: arb_mat


def newton_step(links: Sequence[Link]) -> list[arb_mat]:
    """Return an enclosure of d_0, d_1, ...: what solves the linear equations. Raises EventUndecided if none is proved.

    >>> one = arb_mat([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> [step] = newton_step([Link(arb_mat([[1], [2], [3]]), one / 2, -one)])
    >>> [float(entry) for entry in step.entries()]
    [2.0, 4.0, 6.0]
    """
    maps = [_affine(_solved(one.ahead, -one.here), _solved(one.ahead, -one.miss)) for one in links]
    reached = prefixes(maps)
    around, shift = _parts(reached[-1])
    unit = arb_mat([[int(row == column) for column in range(SIZE)] for row in range(SIZE)])
    first = _solved(unit - around, shift)
    steps = [first]
    for one in reached[:-1]:
        along, moved = _parts(one)
        steps.append(along * first + moved)
    return steps


def prefixes(maps: Sequence[arb_mat]) -> list[arb_mat]:
    """Return maps[0], maps[1] maps[0], maps[2] maps[1] maps[0], ... by a tree of products."""
    if len(maps) == 1:
        return list(maps)
    pairs = prefixes([after * before for before, after in zip(maps[::2], maps[1::2], strict=False)])
    return [maps[0]] + [pairs[k // 2] if k % 2 else maps[k] * pairs[k // 2 - 1] for k in range(1, len(maps))]


def _affine(along: arb_mat, moved: arb_mat) -> arb_mat:
    """Return d -> along d + moved as one 4x4 matrix."""
    rows = [[*row, shift] for row, (shift,) in zip(along.tolist(), moved.tolist(), strict=True)]
    return arb_mat([*rows, [arb(0)] * SIZE + [arb(1)]])


def _parts(affine: arb_mat) -> tuple[arb_mat, arb_mat]:
    rows = affine.tolist()[:SIZE]
    return arb_mat([row[:SIZE] for row in rows]), arb_mat([row[SIZE:] for row in rows])


def _solved(matrix: arb_mat, right: arb_mat) -> arb_mat:
    try:
        return matrix.solve(right)
    except ZeroDivisionError:
        raise EventUndecided("is the periodic motion isolated?", "a singular matrix", working_digits()) from None
