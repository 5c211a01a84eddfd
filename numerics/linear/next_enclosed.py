"""The search for the next event from a point of the path: where a guard vanishes first, and how far off that is.

Short steps look at a Taylor polynomial of the guards, long ones at what is slow in them and the amplitude of the rest.
Nothing is sampled: on an interval a polynomial lies between the least and the greatest of its Bernstein coefficients.
They are formed in balls, so no rounding is lost, and what the polynomial leaves out is added to its bounds. An event is
off by the guard's error over its slope.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

from flint import arb, arb_mat, arb_poly, ctx

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.precision import precision
from numerics.errors import OutOfRange
from numerics.linear.cells import VANISHES
from numerics.linear.flow import REACH, Curve, Motion
from numerics.linear.model import AHEAD
from numerics.linear.path_enclosed import AWAY, At, EnclosedPath
from numerics.linear.swings import Swings
from numerics.linear.ties import MARGINAL

_LONG, _PATIENCE, _PACE, _MOST_STEPS = 4 * REACH, 5, 1_000, 200_000
"""From how many radians on long steps are tried, and after how many short ones; after how many steps it is asked
whether those up to the end of the piece are too many; how many are."""
_RESOLVED = 16
"""A step must be longer than the last bits of time, so many."""
_FINEST = 1_100
"""Intervals that are shorter by so many bits than a step are not looked at, and a step that is by half of them is none:
a guard that comes as near to 0 as digits tell it from 0 does so for a time of half as many."""
_COARSE = 192
"""With as many bits and more a root is refined to half of them first."""
_TOO_FAST, _SCAN_BITS, _SHARP_BITS = arb((1, 1024)), 128, 2_400
_NEAR, SHY = arb((1, -24)), 1 - arb((1, -20))
"""A guard that exceeds its margin by no more than the first factor is near 0. A step ends at SHY of the time that is
proved."""
CLEAR, UNCLEAR = -1, -2
"""No guard vanishes; that is not proved. Otherwise the answer is the index of the guard that does."""
_RATIO, _BEHIND = arb("0.4873"), arb((1, -12))
"""Intervals are cut a little below their middle: a root at a round number is then seldom an end of one. When they are
shorter than the time behind them by the second factor, it is better to look again from there."""


class Root(NamedTuple):
    """Where a guard vanishes: which one, when in the piece (exact), how long after the point of the path.

    `window` and `late` bound how far off that is for the path and for the true motion, `value` the guard there.
    """

    motion: Motion
    guard: Curve
    local: arb
    tau: arb
    window: arb
    late: arb
    value: arb


class Clear(NamedTuple):
    """Up to `since` no guard vanishes; in the interval h behind it one falls through zero once, if there is a `hit`."""

    since: arb
    h: arb
    hit: int = CLEAR


def next_event(path: EnclosedPath, at: At) -> tuple[At, Root | None]:
    """Return the last point before a mode ends and the root of its guard; None where the piece ends before."""
    if (path.literal and at.mode == 0) or path.lasts(at):
        return at, None
    flow, ready, begun = path.flow(at), _PATIENCE if at.mode == 0 else 0, at.local
    if flow.fastest * path.left(at) > _TOO_FAST:
        raise OutOfRange(
            "the rates of this scene differ too much: a mode oscillates more than 1e300 times; bring a1/m1, "
            "sqrt(a2/m1), omega and 1/until closer together"
        )
    for n in range(_MOST_STEPS):
        left, found = path.left(at), None
        if n % _PACE == _PACE - 1 and (at.local - begun) * (_MOST_STEPS // n) < left:
            break
        if ready >= _PATIENCE and not (path.varies and at.mode) and flow.fastest * left > _LONG:
            found = long_step(path, at, left)
            ready = ready if found is not None else 0
        found = found or short_step(path, at, left.min(flow.reach))
        if found.hit != CLEAR:
            return at, refined(path, at, found)
        if found.since >= left:
            return at, None
        # a little before the step ends: what is before it is proved
        local = (at.local + found.since * SHY).mid()
        if local - at.local < local * arb((1, _RESOLVED - path.bits)):
            raise path.undecided(at)  # so short a step is in the rounding of time
        at, ready = path.evolved(at, local), ready + 1
    curves = curves_of(path, at, path.motion(at).guards(flow.reach))
    if not all(one.polynomial[0] > one.margin / _NEAR for one in curves):
        raise path.undecided(at)  # more digits lead closer to the root
    raise OutOfRange(
        f"the mode at t = {path.time(at):.6g} s would take more than {_MOST_STEPS} steps; shorten the horizon, "
        "leave a fast sine out, or start exactly on the tie that is next to this start"
    )


def curves_of(path: EnclosedPath, at: At, guards: Sequence[Curve]) -> list[Curve]:
    """Return what is positive in a mode, from the rows of its flow; some of it may vanish here to some order.

    Of a slip the ends of its intervals of |w| and of x1 - x2, and B + C > 0; of stick the load below b on either side.
    """
    flow, cells, side, number = path.flow(at), path.cells, at.mode, Ball.number
    reach = flow.reach.min(2 * path.left(at))  # a bracket may end behind the piece
    norm = at.norm * flow.norm.growth(reach) if side else at.norm
    if side == 0:
        margin, nearer = path.margin(at), int(not guards[0].polynomial[0].mid() < guards[1].polynomial[0].mid())
        orders = [at.orders[0] * (which == nearer) for which in range(2)]
        return [
            one._replace(margin=flow.apart[one.row][order] * norm if order else margin, order=order)
            for one, order in zip(guards, orders, strict=True)
        ]
    place = at.place + path.kappa * norm * reach
    ends, may_vanish = cells.guards(side, at.cell)
    found = []
    for kind, sign, offset in ends:
        row, order = int(kind == AHEAD), 0 if kind == AHEAD else at.orders[kind]
        curve, margin = guards[row].polynomial * sign + number(offset), place if row else flow.apart[0][order] * norm
        found.append(guards[row]._replace(polynomial=curve, margin=margin, order=order, kind=kind))
    if may_vanish and path.varies:
        branch = cells.branch(path.pieces[at.piece], side, at.cell)
        margin = number(abs(branch.slope)) * path.kappa * norm + number(abs(branch.pull)) * place
        found.append(guards[2]._replace(polynomial=guards[2].polynomial * side, margin=margin, kind=VANISHES))
    return found


def short_step(path: EnclosedPath, at: At, reach: arb) -> Clear:
    """Return a time within reach of a Taylor polynomial in which no guard vanishes; or where one does, once."""
    motion, begins = path.motion(at), any(at.orders)
    for bits in (_SCAN_BITS, min(path.bits, _SHARP_BITS)) if max(at.orders) < MARGINAL else ():
        with precision(bits):
            guards = motion.guards(reach)
            later = curves_of(path, at._replace(orders=AWAY), guards)
            first = curves_of(path, at, guards) if begins else later
            fine = min(bits, _FINEST)
            found = march(first, later, reach, reach / 4 if begins else reach, reach * arb((1, -fine)))
        if found is not None and (found.hit != CLEAR or found.since > reach * arb((1, -fine // 2))):
            return found
    raise path.undecided(at)


def long_step(path: EnclosedPath, at: At, left: arb) -> Clear | None:
    """Return a long time in which the guards exceed an amplitude, if there is one."""
    least = _LONG / path.flow(at).fastest
    for curves in slow_curves(path, at, arb(0), path.flow(at).fastest / 4) if not at.orders[0] else ():
        if not all(one.polynomial[0] > one.margin for one in curves):
            continue
        h = left
        for one in curves:  # up to next to where the slow part comes down to the amplitude, if it does
            curve = one.polynomial - 4 * one.margin
            if curve(0) > 0 and curve(h) < 0:
                h = newton(curve, arb(0), h, h / 2, h * _NEAR)
        found = march(curves, curves, left, h.max(4 * least), least, finds=False)
        if found is not None and found.since > least:
            return found
    return None


def slow_curves(path: EnclosedPath, at: At, *limits: arb) -> Iterator[list[Curve]]:
    """Yield the guards as polynomials with terms of rates below a limit; margins have the amplitude of the others."""
    motion, sign = path.motion(at), at.mode or 1
    swings, guards = Swings(motion.flow, motion.z), curves_of(path, at, motion.guards(motion.flow.reach))
    for limit in limits:
        found = []
        for one in guards:
            taken = swings.taken(motion.flow.bent[one.row], limit)
            found.append(taken._replace(polynomial=taken.polynomial * sign, margin=one.margin + taken.margin))
        if limit.is_zero() or any(one.rest > 0 for one in found):
            yield found


def refined(path: EnclosedPath, at: At, found: Clear) -> Root:
    """Return the root of a guard in its bracket, by Newton's method."""
    motion, (since, h, hit), end = path.motion(at), found, found.since + found.h
    guard = curves_of(path, at._replace(orders=AWAY), motion.guards())[hit]
    curve, until, tau = guard.polynomial, 2 * end, since + h / 2
    for bits in reversed([path.bits >> k for k in range(8) if k == 0 or path.bits >> k > _COARSE]):
        with precision(bits):
            tau = newton(curve, since, end, tau, (end * arb((1, -bits // 2 - 4))).mid())
    local = (at.local + tau).mid()
    tau = local - at.local  # so far the path goes; what that is rounded by counts as an error of the root
    # the true root is where the guard is between -reached and reached; between both ends its slope is known
    off = guard.at(tau).abs_upper()
    reached = off + guard.margin
    within = (2 * reached / abs(curve.derivative()(tau)) + end * arb((1, -path.bits))).upper()
    around = tau + arb(0, within)
    steepness = (-guard.at(around, 1)).lower()
    late = (reached / steepness).upper()
    if not (steepness > 0 and late < within and around < until):
        raise path.undecided(at)
    return Root(motion, guard, local, tau, (off / steepness).upper(), late, off.upper())


def bernstein(p: arb_poly, since: arb, h: arb) -> list[arb]:
    """Return the Bernstein coefficients of a polynomial from `since` on for a time h."""
    shifted = p(arb_poly([since, h])).coeffs() or [arb(0)]
    return (_bernstein_matrix(len(shifted) - 1, ctx.prec) * arb_mat(len(shifted), 1, shifted)).entries()


@lru_cache(maxsize=64)
def _bernstein_matrix(degree: int, _: int) -> arb_mat:
    number, row = Ball.number, range(degree + 1)
    return arb_mat([[number(Fraction(math.comb(i, k), math.comb(degree, k))) for k in row] for i in row])


def look(curves: Sequence[Curve], since: arb, h: arb) -> int:
    """Return whether no curve vanishes behind `since` for a time h, or which one falls through zero there, once.

    At an end that counts the sign is proved, too.
    """
    hit, end = CLEAR, since + h
    for index, one in enumerate(curves):
        values, off = bernstein(one.derived(one.order), since, h), one.left_out(end, one.order) + one.margin
        if all(value > off for value in values):
            continue
        # the slope has the Bernstein coefficients n (b_k+1 - b_k)/h
        slack = one.left_out(end, 1) * h / max(1, len(values) - 1)
        if one.order or len(values) == 1 or not all(two - before < -slack for before, two in pairwise(values)):
            return UNCLEAR
        if values[-1] > off:
            continue
        if not -values[-1] > off or hit != CLEAR:
            return UNCLEAR
        hit = index
    return hit


def march(
    first: Sequence[Curve], later: Sequence[Curve], reach: arb, h: arb, least: arb, *, finds: bool = True
) -> Clear | None:
    """Return up to where no curve vanishes within reach, and what it finds there; None if digits do not tell anything.

    The first interval looked at has length h, and the `first` curves; behind it are the `later` ones. None is shorter
    than `least`.
    """
    since, curves = arb(0), first
    while h > least.max(since * _BEHIND):
        hit = look(curves, since, h)
        if hit == UNCLEAR or (hit != CLEAR and not finds):
            h = (h * _RATIO).mid()
        elif hit != CLEAR:
            return Clear(since, h, hit)
        elif not since + h < reach:
            return Clear(reach, reach)
        else:
            since, h, curves = (since + h).mid(), 2 * h, later
            left = (reach - since).upper()
            h = left if left < 2 * h else h
    return Clear(since, h) if since > 0 else None


def newton(curve: arb_poly, low: arb, high: arb, at: arb, settled: arb) -> arb:
    """Return the root of a falling function between low and high from a guess; a change below `settled` is the last."""
    slope = curve.derivative()
    for _ in range(2_000):
        value = curve(at).mid()
        if value > 0:
            low = at
        else:
            high = at
        change = (value / slope(at)).mid()
        after = (at - change).mid()
        if abs(change) < settled:
            return after
        at = after if low < after < high else ((low + high) / 2).mid()
    return at
