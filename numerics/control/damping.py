"""What a damper a1 on body 1 does to the free pair: when the bodies stick permanently, and when they have come to rest.

Both are last times, in s, of one motion: that of the last contact, and that at which E falls to a2 d^2/2. As E never
grows, from then on |x1| <= d, |v1| <= d sqrt(a2/m1) and |v2| <= d sqrt(a2/m2): at rest within the tolerance d. Neither
is monotone in a1. As a1 grows, body 1 stops at once where it is, and friction alone stops body 2:

    stuck -> m2 |v2(0)|/b
    rest  -> m2 (|v2(0)| - sqrt(a2 (d^2 - x1(0)^2)/m2))/b, or 0, for |x1(0)| < d
             max(m2 |v2(0)|/b, (m1 v1(0) + m2 v2(0))/(a2 x1(0))), or 0, for |x1(0)| = d
    rest  ~  (a1/a2) ln(|x1(0)|/d) for |x1(0)| > d

At |x1(0)| = d: what the momentum moves the pair beyond d, of the order 1/a1, the spring takes back in that time.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.root import falling_root
from numerics.control.answers import most_digits, number
from numerics.errors import NoForceHere, NotSettled, OutOfRange
from numerics.free.abel import creeping_place
from numerics.linear.record import How
from numerics.scene import Scene
from numerics.scene.decimals import Exact, positive, require_digits, short
from numerics.scene.model import require_plain
from numerics.scene.short_repr import ShortRepr
from numerics.solver.solve import solve
from numerics.trajectory.run import run_scene
from numerics.trajectory.trajectory import Trajectory

_log = logging.getLogger(__name__)
_SWINGS, _DOUBLINGS, _MOST_EVENTS = 16, 60, 10_000
_OCTAVES, _PER_OCTAVE, _ZOOMS, _PARTS = 8, 8, 3, 16
"""The best damper is looked for so many octaves about 2 sqrt(a2 M), then between the neighbours of the best one."""
_MOST_DECIMALS = 6
"""By how many decimals a tolerance may be below the positions of a run in float64."""
_LEAST = Fraction(1, 10**300)
"""The least energy at the tolerance, J, that the search in float64 takes."""


class Times(NamedTuple):
    """The bodies stick from `stuck` on, and rest within the tolerance from `rest` on, s; infinite: never."""

    stuck: Number
    rest: Number


@dataclass(frozen=True, repr=False)
class Damping(ShortRepr):
    """What dampers do to the free pair of a scene: enclosures with `digits` right digits.

    `own`: with the damper of the scene; `heavy`: the limits as a1 grows. `best`: of the dampers that were tried the one
    with the least time to rest, N s/m, and `at_best`; both None where none is before the limit. That no other damper is
    better is not proved. `sampled`: (a1, (stuck, rest)) of what was tried, as floats.

    >>> from numerics import load_scene
    >>> found = damping(load_scene("start-at-6mm"), "0.0001", digits=6)
    >>> float(found.best), [one.str(6, radius=False) for one in found.at_best]
    (32.47, ['0.0210130', '0.471097'])
    >>> found.own.rest.is_finite(), float(found.heavy.stuck), found.heavy.rest.is_finite()
    (False, 0.0, False)
    """

    scene: Scene
    tolerance: Fraction
    own: Times
    best: Fraction | None
    at_best: Times | None
    heavy: Times
    digits: int
    sampled: list[tuple[float, Times]] = field(repr=False)


def damping(scene: Scene, tolerance: Exact, *, digits: int = 15, max_digits: int | None = None) -> Damping:
    """Return when a free pair sticks permanently, and rests within a tolerance (m) > 0; and the damper best for that.

    max_digits is as in `response`. Progress is logged. Raises InvalidScene, NoForceHere, EventUndecided, NotSettled
    (too many slips), OutOfRange, PrecisionExhausted, TypeError, ValueError.

    >>> from numerics import load_scene
    >>> damping(load_scene("velocities").replace(a1=5), "0.001").own.stuck.str(8, radius=False)
    '0.95690084'
    """
    require_plain("damping", scene, "damping")
    scene.require_filippov("damping")
    require_digits(digits, max_digits=max_digits)
    size = positive(tolerance, "tolerance", "give the displacement that counts as rest, in m")
    if scene.is_forced:
        raise NoForceHere("damping is that of the free pair; leave the force and the changes of friction out")
    level = scene.pair.a2 * size**2 / 2
    try:
        if not _LEAST <= level <= 1 / _LEAST:
            raise OverflowError
        sampled = _sampled(scene, level)
    except OverflowError:
        low, high = (number(2 * one / scene.pair.a2).sqrt().str(3, radius=False) for one in (_LEAST, 1 / _LEAST))
        raise OutOfRange(
            f"tolerance = {short(size)} m must be between {low} and {high} m, and the search dampers and times in the "
            "range of float64; give another tolerance, or choose units that bring them into range"
        ) from None
    best = Fraction(f"{min(sampled, key=lambda one: one[1].rest)[0]:.4g}")

    def attempt(arithmetic: Ball) -> tuple[Damping, list[arb]]:
        def follow(one: Scene) -> Trajectory:
            return run_scene(one, arithmetic, _MOST_EVENTS)

        own, at_best = (_times(one, level, follow) for one in (scene, scene.replace(a1=best)))
        heavy = _heavy(scene, size)
        known, is_best = [one for one in (*own, *at_best, *heavy) if one.is_finite()], not heavy.rest <= at_best.rest
        found = Damping(
            scene, size, own, best if is_best else None, at_best if is_best else None, heavy, digits, sampled
        )
        return found, known

    return to_digits(attempt, digits, most_digits(digits, max_digits))


def _heavy(scene: Scene, size: Fraction) -> Times:
    """Return the limits as a1 grows without bound."""
    pair, at, left = scene.pair, scene.initial, size**2 - scene.initial.x1**2
    speed, per = number(abs(at.v2)), number(pair.m2 / pair.b)
    rest = arb.pos_inf()
    if left == 0:
        rest = number((pair.m1 * at.v1 + pair.m2 * at.v2) / (pair.a2 * at.x1)).max(per * speed)
    elif left > 0:
        rest = per * (speed - number(pair.a2 * left / pair.m2).sqrt()).max(arb(0))
    return Times(per * speed, rest)


def _sampled(scene: Scene, level: Fraction) -> list[tuple[float, Times]]:
    """Return the times of dampers about the critical one of the stuck pair, closer about the best, as floats.

    They come from float64, or from balls where the tolerance is below what rounding leaves of positions.
    """
    found: list[tuple[float, Times]] = []
    smaller = int(scene.energy / level).bit_length() // 6  # decimals by which the tolerance may be below |x1|
    how: dict[str, Any] = {"arithmetic": "ball", "digits": 30 + smaller} if smaller > _MOST_DECIMALS else {}
    critical = 2 * math.sqrt(scene.pair.a2 * scene.pair.mass)
    dampers = critical * np.logspace(-_OCTAVES, _OCTAVES, 2 * _OCTAVES * _PER_OCTAVE + 1, base=2)
    for _ in range(_ZOOMS):
        _log.info("trying dampers from %.6g to %.6g N s/m", dampers[0], dampers[-1])
        scenes = [scene.replace(a1=Fraction(a1)) for a1 in dampers]
        runs = [_times(one, level, lambda one: solve(one, max_events=_MOST_EVENTS, **how)) for one in scenes]
        times = [Times(*map(float, one)) for one in runs]
        found += zip(dampers.tolist(), times, strict=True)
        at = min(range(len(times)), key=lambda k: times[k].rest)
        dampers = np.geomspace(dampers[max(at - 1, 0)], dampers[min(at + 1, len(times) - 1)], _PARTS + 1)
    return sorted(found)


def _times(scene: Scene, level: Fraction, follow: Callable[[Scene], Trajectory]) -> Times:
    """Return from when on the pair sticks permanently, and from when on E <= level. Raises NotSettled."""
    never, pair = arb.pos_inf(), scene.pair
    until = Fraction(_SWINGS * math.sqrt(pair.mass / pair.a2))
    for _ in range(_DOUBLINGS):
        run = follow(scene.replace(until=until))
        none, left = run.arithmetic.number(0), run.final_energy - run.arithmetic.number(level)
        creeps = pair.a1 == 0 and creeping_place(run, pair, math.inf, Fraction(-1))  # and E tends to E_cr
        if creeps or run.record.how == How.STUCK:
            stuck = never if creeps else [none, *(one.t for one in run.events)][-1]
            if scene.energy <= level:
                return Times(stuck, none)
            if run.reached and left < 0:
                return Times(stuck, _first_at(run, level))
            if pair.a1 == 0 and (level <= pair.critical_energy if creeps else left > 0):
                return Times(stuck, never)
        if not run.reached:
            break
        until *= 2
    raise NotSettled(
        f"with a1 = {float(pair.a1):.6g} N s/m the pair still slips, or moves too much, after {len(run.events)} events "
        f"at t = {float(run.end_time):.6g} s; a larger damper or tolerance may help"
    )


def _first_at(run: Trajectory, level: Fraction) -> Number:
    """Return the time at which E falls to a level that it is below at the end."""
    pair, exact = run.scene.pair, run.arithmetic.number

    def over(t: Number) -> tuple[Number, Number]:
        _, v1, _, v2 = y = run.sol(t).tolist()
        return pair.energy(y, exact) - exact(level), -exact(pair.a1) * v1 * v1 - exact(pair.b) * abs(v1 - v2)

    with run.context():
        moments = [*zip(run.t.tolist(), run.energy - exact(level), strict=True)]
        low = [moments[0][0], *(t for t, left in moments if left > 0)][-1]
        high = next(t for t, left in moments if left < 0)
        return falling_root(low, high, over)
