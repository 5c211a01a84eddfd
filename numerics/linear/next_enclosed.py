"""The search for the next event from a point of the path: where a guard vanishes first, and how far off that is.

Short steps look at a Taylor polynomial of the guards, long ones at what is slow in them and the amplitude of the rest.
An event is off by the guard's error over its slope.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import arb, arb_poly, ctx

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.precision import precision
from numerics.errors import OutOfRange
from numerics.linear.cells import VANISHES
from numerics.linear.flow import FEW, REACH, Expansion
from numerics.linear.model import AHEAD, CONSTANT
from numerics.linear.path_enclosed import AWAY, At, EnclosedPath
from numerics.linear.scan import CLEAR, UNKNOWN, Guard, scan
from numerics.linear.swings import Swings
from numerics.linear.ties import MARGINAL

_LONG, _PATIENCE, _PACE, _MOST_STEPS = 4 * REACH, 5, 1_000, 200_000
"""From how many radians on long steps are tried, and after how many short ones; after how many steps it is asked
whether those up to the end of the piece are too many; how many are."""
_RESOLVED = 16
"""A step must be longer than the last bits of time, so many."""
_FINEST = 1_100
"""Intervals that are shorter by so many bits than a step are not looked at."""
_COARSE = 192
"""With as many bits and more a root is refined to half of them first."""
_FINE = arb((1, 40))
"""A step that is shorter than its reach by this factor, and was not cut for the sake of its polynomial, is none."""
_TOO_FAST, _SCAN_BITS, _SHARP_BITS = arb((1, 1024)), 128, 2_400
_RATIO, _NEAR, SHY = arb("0.4873"), arb((1, -24)), 1 - arb((1, -20))
"""Intervals are cut a little below their middle: a root at a round number is then seldom an end of one. A step ends at
SHY of the time that is proved."""


class Bracket(NamedTuple):
    """Which guard falls through zero between two times after a point, once, and the coefficients of the rows there."""

    guard: int
    low: arb
    high: arb
    rows: list[list[arb]]


class Root(NamedTuple):
    """Where a guard vanishes: which one, when in the piece (exact), how long after the point of the path.

    `window` and `late` bound how far off that is for the path and for the true motion, `value` the guard there.
    """

    motion: Expansion
    guard: Guard
    local: arb
    tau: arb
    window: arb
    late: arb
    value: arb


def next_event(path: EnclosedPath, at: At) -> tuple[At, Root | None]:
    """Return the last point before a mode ends and the root of its guard; None where the piece ends before."""
    if (path.literal and at.mode == 0) or path.lasts(at):
        return at, None
    flow, ready = path.flow(at), _PATIENCE if at.mode == 0 else 0
    short, far, begun = flow.reach, path.left(at), at.local
    if flow.fastest * far > _TOO_FAST:
        raise OutOfRange(
            "the rates of this scene differ too much: a mode oscillates more than 1e300 times; bring a1/m1, "
            "sqrt(a2/m1), omega and 1/until closer together"
        )
    for n in range(_MOST_STEPS):
        left, motion, step = path.left(at), path.motion(at), None
        if n % _PACE == _PACE - 1 and (at.local - begun) * (_MOST_STEPS // n) < left:
            break
        if ready >= _PATIENCE and not (path.varies and at.mode) and flow.fastest * left > _LONG:
            step = long_step(path, at, motion, left.min(far))
            ready, far = (ready, 64 * step) if step is not None else (0, left)
        if step is None:
            found = short_step(path, at, left.min(flow.reach), short)
            if isinstance(found, Bracket):
                return at, refined(path, at, found)
            step, short = found
        if step >= left:
            return at, None
        # a little before the step ends: what is before it is proved
        local = (at.local + step * SHY).mid()
        if local - at.local < local * arb((1, _RESOLVED - path.bits)):
            raise path.undecided(at)  # so short a step is in the rounding of time
        at, ready = path.evolved(at, local), ready + 1
    rows, _ = path.motion(at).short(flow.reach)
    if not all(one.value(rows) > one.margin / _NEAR for one in guards_of(path, at, rows)):
        raise path.undecided(at)  # more digits lead closer to the root
    raise OutOfRange(
        f"the mode at t = {path.time(at):.6g} s would take more than {_MOST_STEPS} steps; shorten the horizon, "
        "leave a fast sine out, or start exactly on the tie that is next to this start"
    )


def guards_of(path: EnclosedPath, at: At, rows: Sequence[Sequence[arb]]) -> list[Guard]:
    """Return the guards of a mode, from the coefficients of its rows; some of them may vanish here to some order.

    Of a slip the ends of its intervals of |w| and of x1 - x2, and B + C > 0; of stick the load below b on either side.
    """
    flow, cells, side, number = path.flow(at), path.cells, at.mode, Ball.number
    norm = at.norm * flow.norm.growth(flow.reach) if side else at.norm
    if side == 0:
        margin, nearer = path.margin(at), int(not rows[0][0].mid() < rows[1][0].mid())
        orders = [at.orders[0] * (which == nearer) for which in range(2)]
        return [
            Guard(1, arb(0), order, flow.apart(which, order) * norm if order else margin, which)
            for which, order in enumerate(orders)
        ]
    place = at.place + path.kappa * norm * flow.reach if path.varies else at.place
    ends, may_vanish = cells.guards(side, at.cell)
    found = []
    for kind, sign, offset in ends:
        of_place, order = kind == AHEAD, 0 if kind == AHEAD else at.orders[kind]
        margin = place if of_place else flow.apart(0, order) * norm
        found.append(Guard(sign, number(offset), order, margin, int(of_place), kind))
    if may_vanish and path.varies:
        branch = cells.branch(path.pieces[at.piece], side, at.cell)
        margin = number(abs(branch.slope)) * path.kappa * norm + number(abs(branch.pull)) * place
        found.append(Guard(side, arb(0), 0, margin, 2, VANISHES))
    return found


def short_step(path: EnclosedPath, at: At, reach: arb, short: arb) -> tuple[arb, arb] | Bracket:
    """Return a time within reach of a Taylor polynomial in which no guard vanishes; or where one does, once.

    With the time comes the last interval that was looked at as one; `short` is that of the step before.
    """
    for bits in (_SCAN_BITS, min(path.bits, _SHARP_BITS)) if max(at.orders) < MARGINAL else ():
        with precision(bits):
            found = scanned(path, at, *path.motion(at).short(reach), reach, short)
        if found is not None:
            return found
    raise path.undecided(at)


def scanned(
    path: EnclosedPath, at: At, rows: list[list[arb]], rests: list[arb], reach: arb, short: arb
) -> tuple[arb, arb] | Bracket | None:
    """Return the same from the rows of the guards; None where their digits do not tell anything."""
    guards, near, since, h = guards_of(path, at, rows), rows, arb(0), reach if 64 * short > reach else 4 * short
    h = h / 4 if any(one.order for one in guards) else h
    more, tiny = ctx.prec < min(path.bits, _SHARP_BITS), arb((1, -min(path.bits, _FINEST)))
    for _ in range(ctx.prec // 2 if more else 2 * ctx.prec):
        if not h > reach * tiny:
            break
        guard = scan(near, guards, rests, h, since)
        if guard == UNKNOWN:
            # from nearer by a polynomial leaves out less
            if since > h and not all(
                abs(one.value(near)) > rests[one.row] * (since + h) ** FEW / _NEAR for one in guards
            ):
                return since, h
            h = (h * _RATIO).mid()
            continue
        if guard != CLEAR:
            return Bracket(guard, since, since + h, rows)
        if not since + h < reach:
            return reach, reach
        if any(one.order for one in guards):
            guards = guards_of(path, at._replace(orders=AWAY), rows)
        since, h = (since + h).mid(), 4 * h
        shift, left = arb_poly([since, 1]), (reach - since).upper()
        near = [[moved[n] for n in range(FEW)] for moved in (arb_poly(row)(shift) for row in rows)]
        h = left if left < 2 * h else h
    else:
        if more:
            return None  # after so many intervals it is digits that are short
    return (since, h) if since * _FINE > reach else None


def long_step(path: EnclosedPath, at: At, motion: Expansion, most: arb) -> arb | None:
    """Return the longest of `most`, about half of it, ... in which the guards exceed an amplitude; long ones only."""
    flow = motion.flow
    if at.orders[0] or (flow.slips and flow.mode.cell != CONSTANT):
        return None
    swings, guards = Swings(flow, motion.z), guards_of(path, at, motion.short(flow.reach)[0])
    for limit in (arb(0), flow.fastest / 4):
        taken, h = [swings.taken(flow.bent[one.row], limit) for one in guards], most
        if limit > 0 and not any(one.rest > 0 for one in taken):
            return None
        above = [
            one._replace(margin=one.margin + of.amplitude, row=k)
            for k, (one, of) in enumerate(zip(guards, taken, strict=True))
        ]
        rows, rests = [one.row for one in taken], [one.rest for one in taken]
        if not all(one.value(rows) > one.margin for one in above):
            continue
        for sign, offset, _, margin, which, _ in above:
            # up to next to where the slow part comes down to the amplitude, if it does
            curve = arb_poly(rows[which]) * sign + (offset - 4 * margin)
            if curve(0) > 0 and curve(h) < 0:
                h = _newton(curve, curve.derivative(), arb(0), h, h / 2, h * _NEAR)
        while flow.fastest * h > _LONG:
            if scan(rows, above, rests, h) == CLEAR:
                return h
            h = (h * _RATIO).mid()
    return None


def refined(path: EnclosedPath, at: At, found: Bracket) -> Root:
    """Return the root of a guard in its bracket, by Newton's method."""
    index, since, h, rows = found
    guard = guards_of(path, at._replace(orders=AWAY), rows)[index]
    sign, offset, which = guard.sign, guard.offset, guard.row
    near = arb_poly(rows[which]) * sign + offset
    guess = _newton(near, near.derivative(), since, h, (since + h) / 2, h * _NEAR)
    motion, until = path.motion(at), 2 * h
    curve, tau = motion.guard(which) * sign, guess
    slope = curve.derivative()
    for bits in reversed([path.bits >> k for k in range(8) if k == 0 or path.bits >> k > _COARSE]):
        with precision(bits):
            tau = _newton(curve + offset, slope, since, h, tau, (h * arb((1, -bits // 2 - 4))).mid())
    local = (at.local + tau).mid()
    tau = local - at.local  # so far the path goes; what that is rounded by counts as an error of the root
    # the true root is where the guard is between -reached and reached; between both ends its slope is known
    off = (curve(tau) + offset).abs_upper() + motion.guard_off(which, tau.abs_upper(), 0)
    reached = off + guard.margin
    within = (2 * reached / abs(slope(tau)) + h * arb((1, -path.bits))).upper()
    around = tau + arb(0, within)
    steepness = (-slope(around) - motion.guard_off(which, until, 1)).lower()
    late = (reached / steepness).upper()
    if not (steepness > 0 and late < within and around < until):
        raise path.undecided(at)
    return Root(motion, guard, local, tau, (off / steepness).upper(), late, off.upper())


def _newton(curve: arb_poly, slope: arb_poly, low: arb, high: arb, at: arb, settled: arb) -> arb:
    """Return the root of a falling function between low and high from a guess; a change below `settled` is the last."""
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
