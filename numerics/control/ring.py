"""The tolerance ring of Fig. 1: the time from which on (z, w) = (x1 - x2, v1 - v2) stays near its limit.

The ring is (z - z*)^2 + (w/rate)^2 <= R^2. Where the bodies end up together, or creep, its centre is the limit z* of z
(the energy norm N sees w, but not z), at w = 0; around a periodic motion it goes along with that: z and w less those of
it. The entry is the last time at which the motion is on the ring. Before a late time each stretch is searched backwards
in balls for it; after that time the motion is inside by what is proved of all later times:

    stuck for ever  what acts at the horizon goes on, and the engine proves that the load stays below b
    creeping        a1 = 0 and no sine: all slips to come are bounded (`creeping_place`)
    closing in      on a periodic motion: the period map shrinks distances (`slide_left`)
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from itertools import chain, count
from typing import NamedTuple

import flint
from flint import arb

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball, exact_middle, undecided, working_digits
from numerics.arithmetic.precision import precision
from numerics.arithmetic.root import Function, falling_root, first_fall
from numerics.control.answers import most_digits, number, rounded
from numerics.control.drive import PeriodicDrive, last_drive
from numerics.control.orbit import Orbit, motion_of, one_round, state_at, without_x2
from numerics.control.response import response
from numerics.errors import EventUndecided, InvalidScene, NotSettled
from numerics.free.abel import creeping_place
from numerics.linear.flow import Motion
from numerics.linear.system import W, Z
from numerics.scene import Scene
from numerics.scene.decimals import Exact, positive, require_digits, short
from numerics.scene.model import require_plain
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.run import run_scene
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory
from numerics.trajectory.variation import Leg, legs

_log = logging.getLogger(__name__)
_FREE, _FORCED = (24, 100_000), (7, 2_000)
"""Number of times the horizon is doubled until all later motion is known, and the limit on events."""
_SEARCH_BITS, _SQUARINGS = 96, 10


@dataclass(frozen=True, repr=False)
class Ring(ShortRepr):
    """From `entry` (s) on, (z - z*)^2 + (w/rate)^2 <= radius^2; `radius` in m, `rate` in 1/s.

    If there is an `orbit`, a periodic motion, z and w are minus those of it. `entry` is exactly 0 if the motion never
    leaves the ring. `centre` (m): z*. Both are enclosures with `digits` right digits. `why`: why it stays inside.

    >>> from numerics import load_scene
    >>> found = ring_entry(load_scene("velocities"), "0.001", rate=20, digits=8)
    >>> float(found.radius), float(found.rate), found.centre.str(6, radius=False), found.entry.str(6, radius=False)
    (0.001, 20.0, '0.000326235', '4.17249')
    >>> found.orbit, found.why
    (None, 'all slips after event 114 are bounded, and alternate in sign')
    """

    scene: Scene
    radius: Fraction
    rate: Fraction
    centre: arb
    entry: arb
    orbit: Orbit | None
    why: str
    digits: int


def ring_entry(
    scene: Scene,
    radius: Exact,
    *,
    rate: Exact = 1,
    digits: int = 15,
    max_digits: int | None = None,
) -> Ring:
    """Return the time from which on the relative motion stays in a ring: (z - z*)^2 + (w/rate)^2 <= radius^2.

    `radius` (m) > 0, `rate` (1/s) > 0; max_digits is as in `response`. Progress is logged. Raises InvalidScene,
    EventUndecided (the motion touches the ring), NotSettled (it settles too late, or this is not proved),
    PrecisionExhausted, TypeError, ValueError.

    >>> from numerics import load_scene
    >>> ring_entry(load_scene("velocities"), "0.001").entry.str(8, radius=False)
    '4.7556413'
    """
    require_plain("ring_entry", scene, "a tolerance ring")
    require_digits(digits, max_digits=max_digits)
    size, per = positive(radius, "radius"), positive(rate, "rate")
    drive = last_drive(scene)
    if drive is None:
        raise InvalidScene("the force grows without bound: for a ring its last piece must be a constant and sines")

    def attempt(arithmetic: Ball) -> tuple[Ring, list[arb]]:
        orbit = None
        if drive.piece.sines:
            found = response(scene, digits=arithmetic.digits)
            if found.growth > 0:
                raise InvalidScene(f"{found.regime.value}; the motion leaves every ring")
            orbit = found.orbit
        # so near its limit, in m and in m/s for w, the motion is inside its ring
        trajectory, known = _settled(scene, drive, orbit, float(size) * min(1.0, float(per)) / 2, arithmetic)
        entry = _last_on_ring(trajectory, known, size, per)
        return Ring(scene, size, per, known.limit, entry, orbit, known.why, digits), [known.limit, entry]

    return to_digits(attempt, digits, most_digits(digits, max_digits))


# what is known of all later times


class Settled(NamedTuple):
    """The limit of z (m), less the z of a periodic motion; near it from `since` (s) on; why."""

    limit: arb
    since: arb
    why: str
    orbit: Orbit | None = None


def _settled(
    scene: Scene, drive: PeriodicDrive, orbit: Orbit | None, near: float, arithmetic: Ball
) -> tuple[Trajectory, Settled]:
    """Return a trajectory that is long enough to know when the motion stays near its limit (m, m/s), and what is known.

    Raises NotSettled.
    """
    doublings, most = _FORCED if scene.is_forced else _FREE
    last = _last_start(scene)
    until = max(scene.until, last + 1)
    for _ in range(doublings):
        _log.info("following the motion to t = %.6g s in %d digits", until, arithmetic.digits)
        run, found = run_scene(replace(scene, until=until), arithmetic, most), None
        if orbit is not None:
            found = periodic_settled(run, orbit, near)
        elif run.status is Status.STUCK_FOR_EVER:  # what acts at the horizon acts after it
            x1, _, x2, _ = run.final_state
            found = Settled(x1 - x2, [arb(0), *(one.t for one in run.events)][-1], "the pair sticks permanently")
        elif not drive.piece.sines and (slip := creeping_place(run, drive.pair, near, max(last, Fraction(0)))):
            why = f"all slips after event {slip.index + 1} are bounded, and alternate in sign"
            found = Settled(slip.limit, run.events[slip.index].t, why)
        if found is not None:
            return run, found
        if not run.reached:
            break
        until *= 2
    remedy = "it is not proved to do so later, which a larger radius may not change"
    if not drive.piece.sines:
        remedy = "a later horizon or a larger radius may help"
    raise NotSettled(
        f"the motion is not known to settle to within {near:.3g} m of its limit by t = {short(run.scene.until)} s or "
        f"{most} events; {remedy}"
    )


def _last_start(scene: Scene) -> Fraction:
    """Return when the last piece of force and friction begins, s; -1 if there is none."""
    return max((*scene.force.starts, *scene.friction.starts), default=Fraction(-1))


def periodic_settled(trajectory: Trajectory, orbit: Orbit, near: float) -> Settled | None:
    """Return how a trajectory closes in on a periodic motion; None if its horizon comes before that is proved.

    At its end it gives the limit, up to what can still slide; the earliest time, whole periods before, from which on
    the motion stays within `near` of the limit (m, and m/s) is `since`: after the last piece of force and friction has
    begun, as what acts before it may do anything in between. While more can still slide than that is sharp and the
    balls of both motions are apart, a later horizon is sharper: None.
    """
    norm, period, left = orbit.drive.norm, orbit.drive.period, arb(0)
    end, limit, since = number(trajectory.scene.until), None, None
    begin = number(max(_last_start(trajectory.scene), Fraction(0)))
    for back in count() if trajectory.reached else ():
        t = (end - back * period).mid()
        if not t > begin:
            break
        try:
            there = orbit.passage_at(t)
            apart = [a - b for a, b in zip(trajectory.sol(t), state_at(there, t), strict=True)]
            reach = norm.of(apart)
            if limit is None:
                if trajectory.mode_at(t).sign != there.side:
                    return None
                left, limit = slide_left(orbit, t, reach), apart[0] - apart[2]
                if not left <= limit.rad() and not all(apart[k].contains(0) for k in (0, 1, 3)):
                    return None
                limit += arb(0, left)
            else:
                left += norm.kappa * (since - t) * reach  # N never grows
        except EventUndecided:
            break
        if not left.max(norm.kappa * reach) < near:
            break
        since = t
    if limit is None or since is None:
        return None
    return Settled(limit, since, "it closes in on the periodic motion: the period map shrinks distances", orbit)


def slide_left(orbit: Orbit, t: arb, reach: arb) -> arb:
    """Return a bound of int |w - w*| dt from a time on, for all motions in the mode of the orbit within `reach` of it.

    Both are followed as one box of states that have the same events (`one_round`). The derivative of the period map
    over this box bounds how much a period shrinks distances; N never grows in between. If k periods shrink it by theta
    < 1, then int |w - w*| dt <= kappa k T reach/(1 - theta), as |w - w*| <= kappa N. Raises EventUndecided.
    """
    t, norm = t.mid(), orbit.drive.norm
    at = without_x2(state_at(orbit.passage_at(t), t))
    start = [rounded(one, working_digits()) for one in at]
    off = max(abs(one - number(near)).upper() for one, near in zip(at, start, strict=True))
    radius = (off + reach / min(norm.root_a2, norm.root_m1, norm.root_m2)).upper()
    slopes = one_round(orbit.drive, exact_middle(t), start, len(orbit.legs), radius).slopes
    for doubling in range(_SQUARINGS):
        x1, v1, v2 = (norm.most((x, v, arb(0), w)) for x, v, w in slopes.tolist())
        shrunk = norm.of((x1, v1, arb(0), v2))
        if shrunk < arb("0.9"):
            return (norm.kappa * 2**doubling * orbit.drive.period * reach / (1 - shrunk)).upper()
        slopes = slopes * slopes
    raise undecided("does the period map shrink distances?", shrunk)


# the last time on the ring


def _last_on_ring(trajectory: Trajectory, known: Settled, radius: Fraction, rate: Fraction) -> arb:
    """Return the last time (s) at which the motion is on the ring before the time from which on it is inside; or 0."""
    orbit, squared, weight = known.orbit, number(radius**2), number(1 / rate**2)
    last = _last_start(trajectory.scene)
    for one in reversed(legs(trajectory)):
        if one.start < known.since:
            together = [(one,)] if orbit is None else [(one, two) for two in orbit.between(one.start, one.end)]
            for parts in reversed(together):
                start, end = reduce(arb.max, (part.start for part in parts)), reduce(arb.min, (p.end for p in parts))
                motions = _apart(parts, start) if one.mode.piece.start >= last else _motions(parts, start)
                found = _last_zero(_outside(motions, known.limit, squared, weight), end - start)
                if found is not None:
                    return start + found
    return arb(0)


def _motions(parts: Sequence[Leg], start: arb) -> list[tuple[Motion, arb]]:
    """Return the motions of legs, each with the time (s) since its start at which another time counts from 0."""
    return [(motion_of(one), start - one.start) for one in parts]


def _apart(parts: Sequence[Leg], start: arb) -> list[tuple[Motion, arb]]:
    """Return the same of legs under one force; in one mode their difference is a motion, which no signal drives."""
    if len({one.side for one in parts}) == len(parts):
        return _motions(parts, start)
    mode, (one, two) = parts[0].mode, (state_at(part, start) for part in parts)
    apart = [a - b for a, b in zip(one, two, strict=True)]
    return [(Motion(motion_of(parts[0]).flow, [*apart, *[arb(0)] * (mode.size - len(apart))]), arb(0))]


def _outside(motions: Sequence[tuple[Motion, arb]], limit: arb, squared: arb, weight: arb) -> Function:
    """Return D = (z - z*)^2 + (w - w*)^2/rate^2 - R^2: of one motion, or of that less another."""

    def over(t: arb) -> tuple[arb, arb]:
        here, *others = [[*chain(*motion.ranges((Z, W), since + t, 0, 1))] for motion, since in motions]
        for other in others:
            here = [a - b for a, b in zip(here, other, strict=True)]
        z, w, slide, change = here
        z -= limit
        return z * z + weight * w * w - squared, 2 * (z * slide + weight * w * change)

    return over


def _last_zero(over: Function, length: arb) -> arb | None:
    """Return the last zero in [0, length] of a function that ends below 0; None if there is none."""
    zero, end = arb(0), length.upper()

    def backwards(t: arb) -> tuple[arb, arb]:
        value, rate = over(end - t)
        return -value, rate

    # telling inside from outside needs few digits
    least = end * arb(2) ** (-working_digits())
    with precision(min(flint.ctx.prec, _SEARCH_BITS)):
        found = first_fall(zero, end, backwards, zero, least)
    if found is False:
        raise undecided("does the motion touch the ring?", over(end)[0])
    return None if found is None else falling_root(end - found[1], end - found[0], over)
