"""Where a mode ends under a force: the first root of its guard, isolated by proved bounds, then refined.

From a point at which the guard g is known with two derivatives and |g'''| <= B, g cannot vanish for h seconds if
g + g' h + g'' h^2/2 - B h^3/6 > 0 up to there. So steps of that length walk to where the guard certainly falls through
zero once. Nothing is sampled: what is not proved to be free of roots is not passed. Where the value is within its own
error, or steps get too short for the numbers, the answer is DOUBT.
"""

from __future__ import annotations

from typing import NamedTuple

from numerics.arithmetic.float64 import UNIT, ZERO, below, middle, positive, rough, settled, size, spread, tolerance
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text, text_apart
from numerics.contact.apart import apart, fastest_of, stays
from numerics.contact.calm import calm
from numerics.flows.forced_jet import guard_at, slip_jet, stick_jets
from numerics.flows.forced_records import Drive, Jet, Pair, Start

NONE, ROOT, DOUBT, NEVER, AHEAD, ENDLESS = 0, 1, 2, 3, 4, 5
"""No root up to the end of the piece; one, isolated; not settled by these numbers; none in stick, however long the
piece is; not seen yet; at this pace the piece would take more steps than anybody waits for."""
_MOST_STEPS, _FEWER, _PATIENCE = 2_000_000, 200_000, 2_000
"""Steps through a piece, in floats and in numbers that take a hundred times as long; after how many of them it is asked
again whether they will do: at their mean pace, or because the time reached has grown (next to a tie steps do)."""
_MOST_TRIALS, _MARGIN, _LONG = 300, 1e-12, 20.0


class Bracket(NamedTuple):
    """What was found, the side of stick that it belongs to, and the times (after the start) between which it is."""

    how: int
    side: int
    low: Number
    high: Number


class Root(NamedTuple):
    """The time of a root after the start, how far off it may be, the guard's slope there, and whether it is sure."""

    tau: Number
    window: Number
    slope: Number
    sure: bool


@text
def leaves(jet: Jet, order: int, h: float) -> bool:
    """Return whether a guard whose value (order 2: and slope) is 0 is proved to be positive in the next h seconds."""
    rest = (jet.bound + h * jet.growth) * h / 6.0
    if order == 1:
        return jet.slope + h * (min(jet.bend, 0.0) / 2.0 - rest) > _MARGIN * (abs(jet.slope) + h * abs(jet.bend))
    return jet.bend / 2.0 - rest > 0.1 * jet.bend


@text
def falls(jet: Jet, h: float) -> bool:
    """Return whether the slope is proved to be negative for the next h seconds."""
    steepest = jet.slope + max(jet.bend, 0.0) * h + (jet.bound + h * jet.growth) * h * h / 2.0
    return steepest < _MARGIN * jet.slope


@text
def crossing(jet: Jet) -> float:
    """Return the length of a bracket within which the guard certainly falls through 0 once; 0 if that is not proved."""
    value, slope = jet.value + 2.0 * jet.error, jet.slope
    if not slope < 0.0:
        return 0.0
    # the root of the parabola, whose slope is at least half of the present one there, or nothing
    if jet.bend * value > 0.375 * slope * slope:
        return 0.0
    root = -value / slope
    for _ in range(4):
        root = -(value + jet.bend * root * root / 2.0) / slope
    for factor in (1.125, 1.5, 2.0):
        h = factor * root
        end = value + h * (slope + h * jet.bend / 2.0) + (jet.bound + h * jet.growth) * h * h * h / 6.0
        if h > 0.0 and end < _MARGIN * h * slope and falls(jet, h):
            return h
    return 0.0


@text_apart
def isolate(pair: Pair, drive: Drive, start: Start, limit: Number) -> Bracket:
    """Return the first root of the guard within `limit` seconds after the start."""
    step, order, tau = rough(limit), start.order, ZERO
    shortest, fastest = 4.0 * UNIT * step, fastest_of(pair, drive, start.piece)
    if positive(start.quiet - start.local):
        order, tau = 0, middle(start.quiet - start.local)
    most, before = (_MOST_STEPS if UNIT > 0.0 else _FEWER), 0.0
    for n in range(most):
        left = rough(limit - tau)
        if left <= 0.0:
            return Bracket(NONE, 0, limit, limit)
        if n % _PATIENCE == 0:
            if rough(tau) < 1.25 * before and rough(tau) * most < rough(limit) * n:
                break
            before = rough(tau)
        one, two = jets_at(pair, drive, start, tau)
        found = ahead(pair, drive, start, order, tau, limit, one, two)
        if found.how != AHEAD:
            return found
        if order == 0 and start.mode != 0 and fastest * left > _LONG:
            free = apart(pair, drive, start, tau, left, fastest)
            if free > 0.0:
                tau = limit if free >= left else middle(tau + free)
                continue
        step = min(2.0 * step, left)
        while step > 0.0 and not advances(one, two, order, step):
            step = step / 2.0 if step > max(shortest, 1e-300) else 0.0
        if step == 0.0:
            return Bracket(DOUBT, 0, tau, limit)
        order, tau = 0, limit if step >= left else middle(tau + step)
    return Bracket(ENDLESS, 0, tau, limit)


@text
def jets_at(pair: Pair, drive: Drive, start: Start, tau: Number) -> tuple[Jet, Jet]:
    """Return both guards of stick, or that of a slip, twice."""
    if start.mode == 0:
        return stick_jets(pair, drive, start, tau)
    one = slip_jet(pair, drive, start, tau)
    return one, one


@text
def ahead(
    pair: Pair, drive: Drive, start: Start, order: int, tau: Number, limit: Number, one: Jet, two: Jet
) -> Bracket:
    """Return what is known of the rest of the piece from one point: a root, none, a doubt; AHEAD if it is a step on."""
    is_stick, left = start.mode == 0, rough(limit - tau)
    is_free = one.value > 0.0 and two.value > 0.0
    if is_stick and (pair.literal or (is_free and order == 0 and calm(pair, drive, start, tau))):
        return Bracket(NEVER, 0, tau, limit)
    if order != 0 or not is_free:
        return Bracket(DOUBT if order == 0 else AHEAD, 0, tau, limit)
    side = -1 if is_stick and two.slope < 0.0 else 1
    nearer, other = (two, one) if side < 0 else (one, two)
    length = crossing(nearer)
    if 0.0 < length < left and (not is_stick or stays(other, length)):
        return Bracket(ROOT, side, tau, tau + length)
    if (length > 0.0 or falls(nearer, left)) and (not is_stick or stays(other, left)):
        return at_the_end(pair, drive, start, side, tau, limit)
    return Bracket(AHEAD, 0, tau, limit)


@text
def advances(one: Jet, two: Jet, order: int, step: float) -> bool:
    """Return whether no guard vanishes for the next `step` seconds."""
    if order != 0:
        if one.value < two.value:
            return leaves(one, order, step) and stays(two, step)
        return leaves(two, order, step) and (one.value == two.value or stays(one, step))
    return stays(one, step) and stays(two, step)


@text
def at_the_end(pair: Pair, drive: Drive, start: Start, side: int, tau: Number, limit: Number) -> Bracket:
    """Return what the guard, which falls from tau on, does up to the end of the piece: the sign there decides."""
    value, _, error = guard_at(pair, drive, start, side, limit)
    norm = pair.load_norm if start.mode == 0 else pair.guard_norm
    error += rough(spread(value)) + rough(norm * start.norm)
    if abs(rough(value)) <= error:
        return Bracket(DOUBT, side, tau, limit)
    return Bracket(NONE if rough(value) > 0.0 else ROOT, side, tau, limit)


@text_apart
def refine(pair: Pair, drive: Drive, start: Start, found: Bracket) -> Root:
    """Return the root in a bracket by Newton's method, kept in it by bisection."""
    low, high = found.low, found.high
    tau = middle((low + high) / 2)
    value, slope, error = guard_at(pair, drive, start, found.side, tau)
    is_last = False
    for _ in range(_MOST_TRIALS):
        if positive(value):
            low = tau
        else:
            high = tau
        change = middle(value / slope)
        after = middle(tau - change)
        is_near = size(change) <= size(tau) * settled() or size(change) <= size(tau) * tolerance() * 4
        if not is_near and not (below(low, after) and below(after, high)):
            after = middle((low + high) / 2)
        tau = after
        value, slope, error = guard_at(pair, drive, start, found.side, tau)
        # a rough value of balls vanishes below 1e-308, and their error is 0: only a bound on rounding ends it early
        if is_last or (error > 0.0 and abs(rough(value)) <= error):
            break
        is_last = is_near
    window = (size(value) + spread(value) + error) / size(slope)
    return Root(tau, window, slope, positive(-slope))
