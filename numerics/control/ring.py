"""The tolerance ring of Fig. 1: from when on the relative motion (z, w) = (x1 - x2, v1 - v2) stays near its limit.

The ring is (z - z*)^2 + (w/rate)^2 <= R^2, its centre the limit z* of z (the energy norm N sees w, but not z), w* = 0.
The entry is the last time at which the motion is on the ring. Before a late event each stretch is searched backwards in
balls for it; after that event the motion is inside by what is proved of all later slips.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import working_digits
from numerics.control.asked import MAX_DIGITS, to_digits
from numerics.control.legs import Stretch, stretches
from numerics.control.linear import V1, V2, X1, X2, Row, W, value
from numerics.control.response import last_drive
from numerics.control.settled import stuck_for_ever
from numerics.errors import EventUndecided, InvalidScene, PrecisionExhausted
from numerics.long_time.resting_place import RestingPlace, resting_place
from numerics.run.one import run_scene
from numerics.scene import Scene
from numerics.scene.decimals import Exact, exact_decimal, short

Z: Row = ((X1, Fraction(1)), (X2, Fraction(-1)))
_DOUBLINGS = 24
"""So often the horizon is doubled until the motion is known for ever."""
_MAX_EVENTS = 100_000


@dataclass(frozen=True)
class Ring:
    """When the relative motion of a scene enters its ring for good.

    `entry` (s), exactly 0 if it never leaves it; `centre` z* (m); enclosures with `digits` right digits. `for_ever`:
    proved for all later times, not for those up to the horizon only; `why` says by what.
    """

    scene: Scene
    radius: Fraction
    rate: Fraction
    centre: arb
    entry: arb
    for_ever: bool
    why: str
    digits: int


def ring_entry(scene: Scene, radius: Exact, *, rate: Exact = 1, digits: int = 15, max_digits: int = MAX_DIGITS) -> Ring:
    """Return when the relative motion enters for good the ring of a radius (m) > 0; w counts as w/rate, rate (1/s) > 0.

    Raises InvalidScene, EventUndecided (the motion touches the ring), PrecisionExhausted (it settles too late).
    """
    size, per = exact_decimal(radius, "radius"), exact_decimal(rate, "rate")
    for name, one in (("radius", size), ("rate", per)):
        if one <= 0:
            raise InvalidScene(f"{name} = {short(one)} must be > 0; give a positive {name}")

    def attempt(arithmetic: Ball) -> tuple[Ring, list[arb]]:
        trajectory, place = _settled(scene, arithmetic, size, per)
        entry = last_on_ring(trajectory, place, size, per)
        found = Ring(scene, size, per, place.limit, entry, True, _why(place), digits)
        return found, [found.centre, found.entry]

    return to_digits(attempt, digits, max_digits)


def _settled(scene: Scene, arithmetic: Ball, radius: Fraction, rate: Fraction) -> tuple[Any, RestingPlace]:
    """Return a trajectory that is long enough to know the resting place, and the place."""
    until, near, drive = scene.until, float(radius) * min(1.0, float(rate)) / 2, None
    if scene.is_forced:
        drive = last_drive(scene)
        if drive is None:
            raise InvalidScene("the force grows for ever: its last piece must be a constant and sines for a ring")
        until = max(until, *(at + 1 for at in (*scene.force.starts, *scene.friction.starts)))
    for _ in range(_DOUBLINGS):
        longer = Scene(scene.pair, scene.initial, until, scene.law, scene.force, scene.friction)
        trajectory = run_scene(longer, arithmetic, _MAX_EVENTS)
        found = resting_place(trajectory, near) if drive is None else stuck_for_ever(trajectory, drive)
        if found is not None:
            return trajectory, found
        if not trajectory.reached:
            break
        until *= 2
    raise PrecisionExhausted(
        f"the motion settles to within {float(radius):g} m after more than {_MAX_EVENTS} events; give a larger radius"
    )


def _why(place: RestingPlace) -> str:
    if place.speed.is_zero():
        return "the pair has stuck for ever"
    return f"all slips after event {place.index + 1} are bounded, to one side and the other in turn"


def last_on_ring(trajectory: Any, place: RestingPlace, radius: Fraction, rate: Fraction) -> arb:
    """Return the last time (s) at which the motion is on the ring before the event from which on it is inside; or 0."""
    parts = list(stretches(trajectory))
    squared, weight = Ball.number(radius**2), Ball.number(1 / rate**2)
    for stretch in reversed(parts):
        if place.index < 0 or not stretch.start < trajectory.events[place.index].t:
            continue
        found = _last_in(stretch, place.limit, squared, weight)
        if found is not None:
            return stretch.start + found
    return arb(0)


def _last_in(stretch: Stretch, centre: arb, squared: arb, weight: arb) -> arb | None:
    """Return the last time in a stretch at which D = (z - z*)^2 + (w/rate)^2 - R^2 is 0; None if D < 0."""
    motion = stretch.motion

    def over(t: arb) -> arb:
        z, w = motion.range(Z, t) - centre, motion.range(W, t)
        return z * z + weight * w * w - squared

    def slope(t: arb) -> arb:
        z, w, change = motion.range(Z, t) - centre, motion.range(W, t), motion.range(W, t, 1)
        return 2 * w * (z + weight * change)

    waiting = [(arb(0), stretch.length.upper())]
    smallest = stretch.length.upper() * arb(2) ** (-working_digits())
    while waiting:
        low, high = waiting.pop()
        part = low.union(high)
        if over(part) < 0:
            continue
        if over(high) > 0:
            raise EventUndecided("is the motion inside the ring here?", over(high).str(6), working_digits())
        rate = slope(part)
        if rate < 0 and over(low) > 0:
            return _crossing(over, slope, low, high)
        if not (rate < 0 or rate > 0) or over(low).contains(0):
            if high - low < smallest:
                raise EventUndecided("does the motion touch the ring?", over(part).str(6), working_digits())
            middle = ((low + high) / 2).mid()
            waiting += [(low, middle), (middle, high)]
    return None


def _crossing(over: Any, slope: Any, low: arb, high: arb) -> arb:
    """Return an enclosure of the one zero of a falling function between two times, by Newton's interval step."""
    part = low.union(high)
    for _ in range(200):
        middle = part.mid()
        step = middle - over(middle) / slope(part)
        if not step.overlaps(part):
            raise EventUndecided("where is the motion on the ring?", part.str(6), working_digits())
        smaller = step.intersection(part)
        if smaller.rad() > part.rad() * arb("0.9"):
            return smaller
        part = smaller
    return part


def relative(stretch: Stretch, t: arb) -> tuple[arb, arb]:
    """Return (z, w) at a time from the start of a stretch."""
    z = stretch.motion.at(t)
    return value(Z, z), z[V1, 0] - z[V2, 0]
