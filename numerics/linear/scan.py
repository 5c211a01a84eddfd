"""Where a guard is proved to be positive or to fall, from its Taylor coefficients at a point: nothing is sampled.

On [0, h] a polynomial lies between the least and the greatest of its Bernstein coefficients. They are formed in balls,
so no rounding is lost, and what the polynomial leaves out is added to its bounds.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise, zip_longest
from typing import Any, NamedTuple

import flint
from flint import arb, arb_mat, arb_poly

from numerics.arithmetic.ball import Ball
from numerics.linear.flow import FEW, Flow
from numerics.linear.model import V1, V2, X1
from numerics.linear.pieces import ExactPiece, particular

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


def sharpest(flow: Flow, z: Sequence[Any], h: arb, least: int) -> tuple[int, arb]:
    """Return the order, from `least` on, at which a polynomial leaves out least, and R; fast rates raise high ones."""
    rests = [(order, flow.rests(z, h, order)[-1]) for order in (3, 5, 8, FEW) if order >= least]
    return min(rests, key=lambda one: (one[1] * h ** one[0]).mid())


class Split(NamedTuple):
    """The row of a guard as a polynomial, which leaves out R = `rest`, the row of a slow z, and what is bounded.

    `slow` is None where there is no slow z. The rest are oscillations, or what fades, below `amplitude`.
    """

    polynomial: list[arb]
    rest: arb
    slow: list[arb] | None
    amplitude: arb


def splits(flow: Flow, piece: ExactPiece, side: int, local: Any, z: Sequence[Any]) -> Iterator[Split]:
    """Yield ways to split: everything that swings or fades by its amplitude; or fast things only.

    x1 is the particular polynomial, the steady answer to each sine, and a free motion y, of which a2 y^2/m + y'^2 never
    grows; under heavy damping it fades fast and slowly. At resonance there is no steady answer, and no split.
    """
    pair, mass, number, z = flow.mode.pair, flow.mode.mass, Ball.number, [arb(one) for one in z]
    m2, force = number(pair.m2), list(piece.polynomial) or [Fraction(0)]
    force[0] -= side * piece.b
    x = arb_poly([number(c) for c in particular(force, mass, pair.a1, pair.a2)])(arb_poly([arb(local), 1]))
    v = x.derivative()
    y, w = z[X1] - x(0), z[V1] - v(0)
    waves = []
    for sine, place in zip(piece.sines, flow.places, strict=True):
        spring, drag = pair.a2 - mass * sine.omega**2, pair.a1 * sine.omega
        square = spring**2 + drag**2
        if square == 0:
            return
        one, two, omega = number(spring / square), number(drag / square), number(sine.omega)
        answer = z[place] * one - z[place + 1] * two, omega * (z[place + 1] * one + z[place] * two)
        height = omega if flow.slips else m2 * omega * omega
        waves.append((omega, place, answer, height * number(abs(sine.amplitude)) / number(square).sqrt()))
        y, w = y - answer[0], w - answer[1]
    # derivatives of y: what bounds one by the one before it bounds it by the next one, too
    rate, stiff = number(pair.a1 / mass), number(pair.a2 / mass)
    root_stiff = stiff.sqrt()
    bend = -stiff * y - rate * w
    before, here, after = (y, w, bend) if flow.slips else (w, bend, -stiff * w - rate * bend)
    free = _length(root_stiff * before, here).min(_length(here, after / root_stiff))
    if flow.slips:
        polynomial = (v - arb_poly([z[V2], side * number(piece.b / pair.m2)])).coeffs() or [arb(0)]
    else:
        polynomial, free = (v.derivative() * m2).coeffs() or [arb(0)], m2 * free
    heights = sum((height for *_, height in waves), arb(0))
    yield Split(polynomial, arb(0), None, (heights + free).upper())
    slow, limit = [arb(0)] * len(z), flow.fastest / 4
    if pair.a1**2 > 16 * pair.a2 * mass:
        fast = (rate + (rate * rate - 4 * stiff).sqrt()) / 2
        fading = stiff / fast
        one, two = (w + fading * y) / (fading - fast), (w + fast * y) / (fast - fading)
        lead, free = (-fading * two, abs(fast * one)) if flow.slips else (m2 * fading**2 * two, m2 * fast**2 * abs(one))
        row = [lead * (-fading) ** k / math.factorial(k) for k in range(FEW)]
        rest = (abs(lead) * fading**FEW / math.factorial(FEW)).upper()
        if len(polynomial) <= FEW:
            row = [a + b for a, b in zip_longest(row, polynomial, fillvalue=arb(0))]
            yield Split(row, rest, None, (heights + free).upper())
        slow[X1], slow[V1] = two, -fading * two
    elif flow.rate < limit:
        slow[X1], slow[V1], free = y, w, arb(0)
    for omega, place, answer, height in waves:
        if omega < limit:
            slow[X1], slow[V1], heights = slow[X1] + answer[0], slow[V1] + answer[1], heights - height
            slow[place], slow[place + 1] = z[place], z[place + 1]
    if len(polynomial) <= FEW and not all(one.is_zero() for one in slow):
        yield Split(polynomial, arb(0), slow, (heights + free).upper())


def _length(x: arb, y: arb) -> arb:
    """Return a bound on sqrt(x^2 + y^2)."""
    return (x * x + y * y).abs_upper().sqrt()
