"""Where a guard is proved to be positive or to fall, from its Taylor coefficients at a point: nothing is sampled.

On [0, h] a polynomial lies between the least and the greatest of its Bernstein coefficients. They are formed in balls,
so no rounding is lost, and what the polynomial leaves out is added to its bounds.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import flint
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball

CLEAR, UNKNOWN = -1, -2
"""No guard vanishes; that is not proved. Otherwise a scan answers with the index of the guard that does."""


class Guard(NamedTuple):
    """offset + sign row, which is positive in a mode; how many of its derivatives vanish at the start of a scan.

    `margin` bounds how far the derivative of this order may be from that of the true motion; `row` says of which row it
    is, `kind` what it means (cells.py).
    """

    sign: int
    offset: arb
    order: int
    margin: arb
    row: int = 0
    kind: int = 0

    def value(self, rows: Sequence[Sequence[arb]]) -> arb:
        """Return it at the point at which rows have these coefficients."""
        return self.offset + self.sign * rows[self.row][0]


def bernstein(row: Sequence[arb], h: arb, order: int) -> list[arb]:
    """Return the Bernstein coefficients of a derivative of a polynomial on [0, h]."""
    count = len(row)
    power, scaled = arb(1), []
    for k in range(order, count):
        scaled.append(row[k] * power * math.perm(k, order) if order else row[k] * power)
        power = power * h
    matrix = _bernstein_matrix(count - order - 1, flint.ctx.prec)
    return (matrix * arb_mat(len(scaled), 1, scaled)).entries()


@lru_cache(maxsize=64)
def _bernstein_matrix(degree: int, _: int) -> arb_mat:
    number, row = Ball.number, range(degree + 1)
    return arb_mat([[number(Fraction(math.comb(i, k), math.comb(degree, k))) for k in row] for i in row])


def scan(
    rows: Sequence[Sequence[arb]], guards: Sequence[Guard], rests: Sequence[arb], h: arb, since: arb | None = None
) -> int:
    """Return whether no guard vanishes in (0, h], or which one falls through zero there, once.

    `rows` are Taylor coefficients, `rests` what they leave out (Flow), formed at a point a time `since` before. At an
    end that counts the sign is proved, too.
    """
    known: dict[tuple[int, int], list[arb]] = {}
    far, hit = h if since is None else h + since, CLEAR

    def left_out(which: int, order: int) -> arb:
        count = len(rows[which])
        return rests[which] * (far ** (count - order) * math.perm(count, order))

    for index, (sign, offset, order, margin, which, _) in enumerate(guards):
        if (which, order) not in known:
            known[which, order] = bernstein(rows[which], h, order)
        values, off = known[which, order], left_out(which, order)
        least = off + margin - (0 if order else offset)
        if all(one > least for one in values) if sign > 0 else all(one < -least for one in values):
            continue
        if order or len(values) == 1:
            return UNKNOWN
        # the slope has the Bernstein coefficients n (b_k+1 - b_k)/h
        slack, ends = left_out(which, 1) * h / (len(values) - 1), values if sign > 0 else reversed(values)
        if not all(two - one < -slack for one, two in pairwise(ends)):
            return UNKNOWN
        end = offset + sign * values[-1]
        if end > off + margin:
            continue
        if not -end > off + margin or hit != CLEAR:
            return UNKNOWN
        hit = index
    return hit
