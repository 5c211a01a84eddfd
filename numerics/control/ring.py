"""The tolerance ring of Fig. 1: from when on the relative motion (z, w) = (x1 - x2, v1 - v2) stays near its limit.

The ring is (z - z*)^2 + (w/rate)^2 <= R^2. Where the bodies end up together, or creep, its centre is the limit z* of z
(the energy norm N sees w, but not z), at w = 0; around a periodic motion it goes along with that: z and w less those of
it. The entry is the last time at which the motion is on the ring. Before a late time each stretch is searched backwards
in balls for it; after that time the motion is inside by what is proved of all later times (settled.py).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.control.asked import Tell, most_digits, silent, to_digits
from numerics.control.orbit import Drive, Orbit
from numerics.control.response import last_drive, response
from numerics.control.ring_crossing import last_on_ring
from numerics.control.settled import Settled, creeping_settled, free_settled, periodic_settled, stuck_settled
from numerics.errors import InvalidScene, NotSettled
from numerics.run.one import run_scene
from numerics.scene import Scene
from numerics.scene.decimals import Exact, exact_decimal, short

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
