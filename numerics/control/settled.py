"""From when on the relative motion of a scene is known for ever: stuck, creeping, or closing in on a periodic motion.

In stick under a force that ends as a constant or as sines the motion is the stuck response and a free part (e, e')
whose energy a2 e^2 + M e'^2 never grows. The load of the free part is at most (m2/M) (sqrt(a2) + a1/sqrt(M)) times the
root of it, that of the response at most the sum of m2 omega^2 |A|/Z(M): once both are below b together, the pair never
slips.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import sqrt
from numerics.control.attraction import distance, place_at, slide_left
from numerics.control.legs import Stretch, stretches
from numerics.control.orbit import Drive, Orbit
from numerics.control.stuck import stuck_state
from numerics.control.thresholds import stiffness
from numerics.errors import EventUndecided
from numerics.long_time.resting_place import RestingPlace, creeping_place, resting_place
from numerics.motion.modes import Mode


@dataclass(frozen=True)
class Settled:
    """The limit of z = x1 - x2 (m), less the z of a periodic motion; near it from `since` (s) on; why."""

    limit: arb
    since: arb
    why: str
    orbit: Orbit | None = None
    is_sharp: bool = True
    """False: most of the limit's radius is what can still slide after the horizon; a later one makes it sharper."""


def free_settled(trajectory: Any, near: float) -> Settled | None:
    """Return what is known of a free pair; None if its horizon comes before that."""
    found = resting_place(trajectory, near)
    if found is None:
        return None
    return _at_rest(trajectory, found)


def creeping_settled(trajectory: Any, drive: Drive, near: float) -> Settled | None:
    """Return what is known of a pair under a force that ends as a constant, a1 = 0; None if that is too early."""
    scene = trajectory.scene
    last = max((*scene.force.starts, *scene.friction.starts), default=Fraction(0))
    found = None if drive.piece.sines else creeping_place(trajectory, drive.pair, near, last)
    return None if found is None else _at_rest(trajectory, found)


def _at_rest(trajectory: Any, found: RestingPlace) -> Settled:
    since = trajectory.events[found.index].t if found.index >= 0 else arb(0)
    if found.speed.is_zero():
        return Settled(found.limit, since, "the pair has stuck for ever")
    why = f"all slips after event {found.index + 1} are bounded, to one side and the other in turn"
    return Settled(found.limit, since, why)


def stuck_settled(trajectory: Any, drive: Drive) -> Settled | None:
    """Return where a trajectory in balls sticks for ever from its last event on; None if that is not proved yet.

    `drive` acts at the horizon and after it. In the arithmetic's context.
    """
    response = stuck_state(drive, Ball.number(trajectory.scene.until))
    if trajectory.final_mode is not Mode.STICK or response is None:
        return None
    x1, v1, x2, _ = trajectory.final_state
    pair, number = drive.pair, Ball.number
    place, speed = x1 - response[0], v1 - response[1]
    energy = number(pair.a2) * place * place + number(pair.mass) * speed * speed
    root = number(pair.a2).sqrt() + number(pair.a1) / number(pair.mass).sqrt()
    load = number(pair.m2 / pair.mass) * root * sqrt(energy)
    for one in drive.piece.sines:
        load += number(pair.m2 * abs(one.amplitude) * one.omega**2) / stiffness(pair, pair.mass, one.omega)
    if not load < number(drive.b):
        return None
    since = trajectory.events[-1].t if len(trajectory.events) else arb(0)
    return Settled(x1 - x2, since, "the pair has stuck for ever")


def periodic_settled(trajectory: Any, orbit: Orbit, near: float) -> Settled | None:
    """Return how a trajectory closes in on a periodic motion; None if its horizon comes before that is proved.

    At its end it gives the limit, up to what can still slide; the earliest time, whole periods before, from which on
    the motion stays within `near` of the limit (m, and m/s) is `since`.
    """
    parts = list(stretches(trajectory))
    end = Ball.number(trajectory.scene.until)
    limit, since, is_sharp = None, None, False
    kappa = orbit.drive.pair.mass / (orbit.drive.pair.m1 * orbit.drive.pair.m2)
    for back in range(int(float(end / orbit.drive.period))):
        t = end - back * orbit.drive.period
        try:
            state, place = _state_at(parts, t, orbit), place_at(orbit, t)
            if state is None:
                break
            reach = distance(orbit.drive.pair, state, place.state)
            left = slide_left(orbit, place, reach)
        except EventUndecided:
            break
        if limit is None:
            limit = state[0] - state[2] - (place.state[0] - place.state[2])
            is_sharp = bool(left <= limit.rad())
            limit += arb(0, left)
            if not is_sharp:
                since = t
                break
        if not left.max(Ball.number(kappa).sqrt() * reach) < near:
            break
        since = t
    if limit is None or since is None:
        return None
    return Settled(
        limit, since, "it closes in on the periodic motion: the period map shrinks distances", orbit, is_sharp
    )


def _state_at(parts: list[Stretch], t: arb, orbit: Orbit) -> tuple[arb, arb, arb, arb] | None:
    """Return the state at a time if it lies within a stretch in the same mode as the orbit."""
    for stretch in parts:
        since = t - stretch.start
        if since >= 0 and not since > stretch.length:
            same = stretch.side == orbit.legs[place_at(orbit, t).leg].side
            return stretch.motion.state(since) if same else None
    return None
