"""The tolerance ring of Fig. 1: from when on the relative motion (z, w) = (x1 - x2, v1 - v2) stays near its limit.

The ring is (z - z*)^2 + (w/rate)^2 <= R^2. Where the bodies end up together, or creep, its centre is the limit z* of z
(the energy norm N sees w, but not z), at w = 0; around a periodic motion it goes along with that: z and w less those of
it. The entry is the last time at which the motion is on the ring. Before a late time each stretch is searched backwards
in balls for it; after that time the motion is inside by what is proved of all later times (settled.py).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import flint
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import precision, working_digits
from numerics.control.asked import Tell, most_digits, silent, to_digits
from numerics.control.legs import stretches
from numerics.control.linear import X1, X2, Motion, Row, W
from numerics.control.orbit import Drive, Orbit
from numerics.control.response import last_drive, response
from numerics.control.settled import Settled, creeping_settled, free_settled, periodic_settled, stuck_settled
from numerics.errors import EventUndecided, InvalidScene, NotSettled
from numerics.run.one import run_scene
from numerics.scene import Scene
from numerics.scene.decimals import Exact, exact_decimal, short

Z: Row = ((X1, Fraction(1)), (X2, Fraction(-1)))
_SEARCH_BITS = 96
_DOUBLINGS = 24
"""So often the horizon is doubled until the motion is known for ever."""
_MAX_EVENTS = 100_000
_FORCED_DOUBLINGS, _MAX_FORCED_EVENTS = 7, 2_000


@dataclass(frozen=True)
class Ring:
    """When the relative motion of a scene enters its ring for good.

    `entry` (s), exactly 0 if it never leaves it; `centre` (m): z*, less the z of the periodic motion if there is an
    `orbit`; enclosures with `digits` right digits. `why` says what keeps it inside for ever.
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
    tell: Tell = silent,
) -> Ring:
    """Return when the relative motion enters for good the ring of a radius (m) > 0; w counts as w/rate, rate (1/s) > 0.

    `tell` hears what is being done. Raises InvalidScene, EventUndecided (the motion touches the ring), NotSettled (it
    settles too late, or not for certain), PrecisionExhausted. max_digits is as in `response`.
    """
    size, per = exact_decimal(radius, "radius"), exact_decimal(rate, "rate")
    for name, one in (("radius", size), ("rate", per)):
        if one <= 0:
            raise InvalidScene(f"{name} = {short(one)} must be > 0; give a positive {name}")

    def attempt(arithmetic: Ball) -> tuple[Ring, list[arb]]:
        trajectory, known = _settled(scene, arithmetic, (size, per), tell)
        entry = last_on_ring(trajectory, known, size, per)
        found = Ring(scene, size, per, known.limit, entry, known.orbit, known.why, digits)
        return found, [found.centre, found.entry]

    return to_digits(attempt, digits, most_digits(digits, max_digits))


def _settled(scene: Scene, arithmetic: Ball, ring: tuple[Fraction, Fraction], tell: Tell) -> tuple[Any, Settled]:
    """Return a trajectory that is long enough to know the limit, and what is known; `ring`: its radius and rate."""
    radius, rate = ring
    until, near = scene.until, float(radius) * min(1.0, float(rate)) / 2
    drive = _drive(scene) if scene.is_forced else None
    orbit = _orbit(scene, drive, arithmetic, tell)
    doublings, most = (_DOUBLINGS, _MAX_EVENTS) if drive is None else (_FORCED_DOUBLINGS, _MAX_FORCED_EVENTS)
    if drive is not None:
        until = max(until, *(at + 1 for at in (*scene.force.starts, *scene.friction.starts)))
    for _ in range(doublings):
        longer = Scene(scene.pair, scene.initial, until, scene.law, scene.force, scene.friction)
        tell(f"following the motion to t = {float(until):.6g} s in {arithmetic.digits} digits")
        trajectory = run_scene(longer, arithmetic, most)
        found = _known(trajectory, drive, orbit, near)
        if found is not None and found.is_sharp:
            return trajectory, found
        if not trajectory.reached:
            break
        until *= 2
    raise NotSettled(
        f"the motion is not known to settle to within a radius of {short(radius)} m by t = "
        f"{short(trajectory.scene.until)} s or {most} events; {_remedy(drive, orbit)}"
    )


def _remedy(drive: Drive | None, orbit: Orbit | None) -> str:
    """Return whether a larger radius can help where nothing was proved of all later times."""
    if orbit is not None:
        return "no proof was found that it closes in on the periodic motion; a larger radius may not help either"
    if drive is not None and drive.piece.sines:
        return "a larger radius does not help: the pair is not proved to stick for ever"
    return "give a larger radius"


def _known(trajectory: Any, drive: Drive | None, orbit: Orbit | None, near: float) -> Settled | None:
    """Return what is known for ever of a trajectory, by the road that its force leaves."""
    if drive is None:
        return free_settled(trajectory, near)
    if orbit is not None:
        return periodic_settled(trajectory, orbit, near)
    return stuck_settled(trajectory, drive) or creeping_settled(trajectory, drive, near)


def _drive(scene: Scene) -> Drive:
    drive = last_drive(scene)
    if drive is None:
        raise InvalidScene("the force grows for ever: its last piece must be a constant and sines for a ring")
    return drive


def _orbit(scene: Scene, drive: Drive | None, arithmetic: Ball, tell: Tell) -> Orbit | None:
    """Return the periodic motion that a scene tends to, None if it ends stuck."""
    if drive is None or not drive.piece.sines:
        return None
    found = response(scene, digits=arithmetic.digits, tell=tell)
    if found.growth > 0:
        raise InvalidScene(f"{found.regime.value}; no ring is entered for good")
    return found.orbit


def last_on_ring(trajectory: Any, known: Settled, radius: Fraction, rate: Fraction) -> arb:
    """Return the last time (s) at which the motion is on the ring before the time from which on it is inside; or 0."""
    squared, weight = Ball.number(radius**2), Ball.number(1 / rate**2)
    for stretch in reversed(list(stretches(trajectory))):
        if not stretch.start < known.since:
            continue
        for start, length, distance in reversed(list(_distances(stretch.motion, stretch.start, stretch.length, known))):
            found = _last_in(distance, length, squared, weight)
            if found is not None:
                return start + found
    return arb(0)


Apart = tuple[arb, arb, arb, arb]
"""z - z*, w - w* and their derivatives over a ball of times."""
Distance = Callable[[arb], Apart]


def _distances(motion: Motion, start: arb, length: arb, known: Settled) -> Iterator[tuple[arb, arb, Distance]]:
    """Yield the parts of a stretch in which the periodic motion has one mode: start, length, and the distance in it."""
    if known.orbit is None:
        limit = known.limit

        def distance(t: arb) -> Apart:
            here = motion.over(t)
            return here.range(Z) - limit, here.range(W), here.range(Z, 1), here.range(W, 1)

        yield start, length, distance
        return
    for begin, end, other, moved in timeline(known.orbit, start, start + length):
        first, last = later(begin, start), -later(-end, -(start + length))
        yield first, last - first, _apart(motion, first - start, other, first - begin, known.limit + moved)


def _apart(motion: Motion, passed: arb, other: Motion, ahead: arb, limit: arb) -> Distance:
    """Return the distance of two motions, each from some time after its start on; z less a limit."""

    def distance(t: arb) -> Apart:
        here, there = motion.over(passed + t), other.over(ahead + t)
        z, w, slide, change = (here.range(row, n) - there.range(row, n) for n in (0, 1) for row in (Z, W))
        return z - limit, w, slide, change

    return distance


def timeline(orbit: Orbit, start: arb, end: arb) -> Iterator[tuple[arb, arb, Motion, arb]]:
    """Yield the legs of a periodic motion that meet [start, end]: begin, end, motion, and how far x2 was before it, m.

    The last is -x2 at its begin, counted from the first event: z of the motion lacks it.
    """
    period = orbit.drive.period
    count = math.floor(float((start - orbit.legs[0].t) / period)) - 1
    while True:
        moved = count * orbit.travel
        for leg, after in orbit.turns:
            motion, begin = orbit.motion(leg), leg.t + count * period
            if begin > end:
                return
            if after.t + count * period > start:
                yield begin, after.t + count * period, motion, -moved
            moved = moved + motion.at(after.t - leg.t)[X2, 0]
        count += 1


def later(one: arb, two: arb) -> arb:
    """Return the later of two times. Raises EventUndecided."""
    if one >= two:
        return one
    if one < two:
        return two
    raise EventUndecided("which of these two events is the later one?", (one - two).str(6), working_digits())


def _last_in(apart: Distance, length: arb, squared: arb, weight: arb) -> arb | None:
    """Return the last time in a stretch at which D = (z - z*)^2 + (w - w*)^2/rate^2 - R^2 is 0; None if D < 0."""

    def over(t: arb) -> tuple[arb, arb]:
        z, w, slide, change = apart(t)
        return z * z + weight * w * w - squared, 2 * (z * slide + weight * w * change)

    waiting = [(arb(0), length.upper())]
    smallest = length.upper() * arb(2) ** (-working_digits())
    while waiting:
        low, high = waiting.pop()
        # telling inside from outside needs few digits
        with precision(min(flint.ctx.prec, _SEARCH_BITS)):
            part, rate = over(low.union(high))
            if part < 0:
                continue
            left, right = over(low)[0], over(high)[0]
        if right > 0:
            raise EventUndecided("is the motion inside the ring here?", right.str(6), working_digits())
        if rate < 0 and left > 0:
            return _crossing(over, low, high)
        if not (rate < 0 or rate > 0) or left.contains(0):
            if high - low < smallest:
                raise EventUndecided("does the motion touch the ring?", part.str(6), working_digits())
            middle = ((low + high) / 2).mid()
            waiting += [(low, middle), (middle, high)]
    return None


def _crossing(over: Callable[[arb], tuple[arb, arb]], low: arb, high: arb) -> arb:
    """Return an enclosure of the one zero of a falling function between two times, by Newton's interval step."""
    part = low.union(high)
    for _ in range(200):
        middle = part.mid()
        step = middle - over(middle)[0] / over(part)[1]
        if not step.overlaps(part):
            raise EventUndecided("where is the motion on the ring?", part.str(6), working_digits())
        smaller = step.intersection(part)
        if smaller.rad() > part.rad() * arb("0.9"):
            return smaller
        part = smaller
    return part
