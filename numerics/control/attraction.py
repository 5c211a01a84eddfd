"""How a pair closes in on its periodic motion for good: a contraction of the period map, proved over a neighbourhood.

From a time at which a trajectory is in a leg of the orbit and within eps of it in the norm N, both are followed as one
box of states, leg by leg: every state of the box has the same events. The derivative of the period map over the box
bounds how much a period shrinks distances; N never grows in between. If k periods shrink it by theta < 1, then

    int |w - w*| dt <= sqrt(kappa) k T eps/(1 - theta)    from then on, N(y) = sqrt(kappa) |w| at most.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import working_digits
from numerics.control.linear import V1, X1, Motion, Row, W
from numerics.control.modes_proved import QUICK, is_positive_inside, require_slip, require_stick
from numerics.control.orbit import Orbit
from numerics.control.variation import across, part
from numerics.errors import EventUndecided
from numerics.scene import Pair

_DOUBLINGS = 10
"""The period map is taken up to 2^n times in a row until it shrinks all distances."""


@dataclass(frozen=True)
class Place:
    """Where a periodic motion is at a time: its leg by number, the time since that leg began, and (x1, v1, x2, v2).

    x2 counts from where it was at the first event of the orbit.
    """

    leg: int
    since: arb
    state: tuple[arb, arb, arb, arb]


def place_at(orbit: Orbit, t: arb) -> Place:
    """Return where the orbit is at a time t (s) that is no event of it. Raises EventUndecided."""
    period, first = orbit.drive.period, orbit.legs[0].t
    turns = ((t - first) / period).floor().unique_fmpz()
    if turns is None:
        raise EventUndecided("in which period is this time?", t.str(6), working_digits())
    phase, x2 = t - int(turns) * period, int(turns) * orbit.travel
    for number, (leg, after) in enumerate(orbit.turns):
        motion = orbit.motion(leg)
        if phase < after.t:
            x1, v1, moved, v2 = motion.state(phase - leg.t)
            return Place(number, phase - leg.t, (x1, v1, x2 + moved, v2))
        if not phase > after.t:
            break
        x2 += motion.state(after.t - leg.t)[2]
    raise EventUndecided("in which leg is this time?", t.str(6), working_digits())


def distance(pair: Pair, one: Sequence[arb], two: Sequence[arb]) -> arb:
    """Return N of the difference of two states (x1, v1, x2, v2): sqrt(a2 dx1^2 + m1 dv1^2 + m2 dv2^2)."""
    number, total = Ball.number, arb(0)
    for weight, place in ((pair.a2, 0), (pair.m1, 1), (pair.m2, 3)):
        off = abs(one[place] - two[place]).upper()
        total += number(weight) * off * off
    return total.sqrt().upper()


def slide_left(orbit: Orbit, place: Place, reach: arb) -> arb:
    """Return a bound of int |w - w*| dt for all motions in the mode of `place` within `reach` of it. EventUndecided."""
    drive = orbit.drive
    slopes, powers = _period_slopes(orbit, place, reach), 1
    for _ in range(_DOUBLINGS):
        shrunk = _norm(drive.pair, slopes)
        if shrunk < arb("0.9"):
            kappa = Ball.number(drive.pair.mass / (drive.pair.m1 * drive.pair.m2)).sqrt()
            return (kappa * powers * drive.period * reach / (1 - shrunk)).upper()
        slopes, powers = slopes * slopes, 2 * powers
    raise EventUndecided("does the period map shrink distances?", _norm(drive.pair, slopes).str(6), working_digits())


def _norm(pair: Pair, slopes: arb_mat) -> arb:
    """Return an upper bound of the norm of a linear map of (x1, v1, v2) that belongs to N (Frobenius)."""
    weights, total = [Ball.number(one).sqrt() for one in (pair.a2, pair.m1, pair.m2)], arb(0)
    for row in range(3):
        for column in range(3):
            entry = abs(weights[row] * slopes[row, column] / weights[column]).upper()
            total += entry * entry
    return total.sqrt()


def _period_slopes(orbit: Orbit, place: Place, reach: arb) -> arb_mat:
    """Return the derivative of (x1, v1, v2) after a period by that before, over the box around a place."""
    drive, order = orbit.drive, [*orbit.turns[place.leg :], *orbit.turns[: place.leg]]
    number, pair = Ball.number, drive.pair
    leg, _ = order[0]
    sizes = [(reach / number(one).sqrt()).upper() for one in (pair.a2, pair.m1, pair.m2)]
    x1, v1, _, v2 = place.state
    x, speed, other = (one + arb(0, size) for one, size in zip((x1, v1, v2), sizes, strict=True))
    if leg.side == 0:
        other = speed
    motion = drive.mode(leg.side).motion((x, speed, arb(0), other), leg.t + place.since)
    total, here = _unit(leg.side), leg.t + place.since
    for number_of, (leg, after) in enumerate(order):
        nominal = after.t if after.t > here else after.t + drive.period
        end = _event_time(motion, nominal - here, after.side)
        if leg.side == 0:
            require_stick(motion, end, after.side, QUICK)
        elif number_of:
            require_slip(motion, end, from_stick=order[number_of - 1][0].side == 0, effort=QUICK)
        else:
            _require_apart(motion, end)
        z = motion.at(end)
        begun = drive.mode(after.side).motion((z[X1, 0], z[V1, 0], arb(0), z[V1, 0]), here + end)
        total = across(motion, end, begun) * total
        motion, here = begun, here + end
    return part(motion.flow(place.since)) * total


def _require_apart(motion: Motion, end: arb) -> None:
    """Raise EventUndecided unless s w > 0 is proved from inside a slip to its end."""
    row = tuple((place, motion.mode.side * one) for place, one in W)
    if not is_positive_inside(motion, row, end, 0, 1, QUICK):
        raise EventUndecided("do the bodies of the whole box slip?", "w near 0", working_digits())


def _unit(side: int) -> arb_mat:
    return arb_mat([[1, 0, 0], [0, 1, 0], [0, int(side == 0), int(side != 0)]])


def _event_time(motion: Motion, near: arb, side: int) -> arb:
    """Return an enclosure of when each state of a box meets its next event, by an interval Newton step."""
    mode = motion.mode
    row: Row = W if mode.side else mode.load
    level = arb(0) if mode.side else side * Ball.number(mode.b)
    middle = near.mid()
    miss = motion.range(row, middle) - level
    width = abs(miss / motion.range(row, middle, 1)).upper()
    for factor in (2, 8, 32):
        region = middle + arb(0, (factor * width).upper())
        step = middle - miss / motion.range(row, region, 1)
        if region.contains_interior(step):
            return step
    raise EventUndecided("do all motions of the box meet this event?", miss.str(6), working_digits())
