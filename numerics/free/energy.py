"""The energy at any time, however late, without stepping there: `energy_at`.

Three roads, the cheapest that gives what is asked: a pair that never slips again keeps its energy; a few hundred events
are stepped one by one; beyond those, on an exit ray close to the critical orbit, the Abel functions of the return map
(abel.py) jump over all remaining excursions at once. Everything is enclosed. With a damper, a force or friction that
changes, every event is stepped.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from itertools import pairwise
from typing import Any

from flint import arb

from numerics.arithmetic.attempts import SPARE_DIGITS, to_digits
from numerics.arithmetic.ball import Ball, proved_sign, undecided
from numerics.arithmetic.protocol import Number
from numerics.errors import InvalidScene, OutOfRange
from numerics.free.abel import AbelFunctions, abel_functions, reach_of
from numerics.free.frame import RAY, STICK, Frame, ReducedState, begin
from numerics.free.motion import mode_of, motions, on_ray, state_at
from numerics.linear.modes import MODES, Mode
from numerics.linear.record import How
from numerics.scene import Law, Scene
from numerics.scene.decimals import Exact, exact_decimal, short
from numerics.scene.model import require_plain

MAX_STEPS = 200_000
MAX_DIGITS = 20_000
_JUMP_PAYS_AFTER = 300
"""Excursions left, from which on a jump is cheaper than stepping."""


class EnergyMethod(Enum):
    """How the answer was found; the value is the sentence that --explain prints."""

    NO_MORE_SLIP = "the pair never slips again: its motion since the last slip, or the start, is known"
    STEPPED = "every event up to the time was located, one after the other"
    ABEL = "close to the critical orbit the Abel functions of the return map jumped over all remaining excursions"


@dataclass(frozen=True)
class EnergyAt:
    """The answer: energy (J), excess w, excursions so far, mode and reduced state at the time; enclosures.

    After a jump Z, and so x2, counts from an unknown origin. `stepped` counts the events that were located one by one,
    up to the jump, `digits` the right digits of energy and excess.
    """

    digits: int
    frame: Frame
    energy: Number
    energy_excess: Number
    excursions: int
    mode: Mode
    state: ReducedState
    road: EnergyMethod
    stepped: int

    @property
    def si_state(self) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) in m and m/s."""
        with self.frame.arithmetic.context():
            return self.frame.in_si(self.state)


def energy_at(
    scene: Scene, t: Exact, *, digits: int = 15, max_steps: int = MAX_STEPS, max_digits: int = MAX_DIGITS
) -> EnergyAt:
    """Return the energy of a scene at time t (s) > 0, its `until` disregarded, to `digits` right digits (proved).

    E_cr is that of the pair's own b. Raises InvalidScene (t), OutOfRange (too many events before the return map takes
    over), EventUndecided and PrecisionExhausted (the cap on the working digits).
    """
    at = exact_decimal(t, "t")
    if at <= 0:
        raise InvalidScene(f"t = {short(at)} must be > 0; give the time in seconds")
    require_plain("energy_at", scene, "the energy at one time")
    rate_squared = scene.pair.a2 / scene.pair.mass * at * at
    size = max(0, math.ceil((rate_squared.numerator.bit_length() - rate_squared.denominator.bit_length()) * 0.1506))
    road = _stepped if scene.pair.a1 > 0 or scene.is_forced else _free

    def attempt(arithmetic: Ball) -> tuple[EnergyAt, list[arb]]:
        found = EnergyAt(digits, *road(scene, at, arithmetic, arithmetic.digits - size, max_steps))
        return found, [found.energy / found.frame.critical_energy, found.energy_excess]

    return to_digits(attempt, digits, max_digits, size + SPARE_DIGITS)


def _stepped(scene: Scene, at: Fraction, arithmetic: Ball, _: int, max_steps: int) -> tuple[Any, ...]:
    """Return the answer for a pair with a damper, which takes E to 0, where 1 + w would cancel, or with signals."""
    from numerics.linear.engine import run_linear

    scene = scene.replace(until=at)
    record = run_linear(scene, arithmetic, max_steps)
    if record.how is How.EVENT_LIMIT:
        raise OutOfRange(f"more than {max_steps} events before t = {short(at)} s; raise max_steps")
    frame, end = Frame(arithmetic, scene.pair), record.end
    state = frame.reduced((end.x1, end.v1, end.x2, end.v2))
    exits = sum(before.mode == 0 != after.mode for before, after in pairwise(record.rows))
    lasts = record.how is How.STUCK and not scene.changes_later
    road = EnergyMethod.NO_MORE_SLIP if lasts else EnergyMethod.STEPPED
    energy = scene.pair.energy((end.x1, end.v1, end.x2, end.v2), arithmetic.number)
    return frame, energy, state.w, exits, MODES[end.mode], state, road, record.events


def _free(scene: Scene, at: Fraction, arithmetic: Ball, digits: int, max_steps: int) -> tuple[Any, ...]:
    """Return the answer for the free pair: by events, then by the return map, for so many right digits."""
    frame, literal = Frame(arithmetic, scene.pair), scene.law is Law.THREE_VALUED_SGN
    walk = motions(frame, begin(scene, frame), literal)
    target, excursions, stepped, road = frame.rate * arithmetic.number(at), 0, 0, EnergyMethod.STEPPED
    while True:
        start, duration = next(walk)
        left = target - start.tau
        if duration is None:
            road = EnergyMethod.NO_MORE_SLIP
            break
        if proved_sign(duration - left, "does the next event come before the time asked for?") > 0:
            break
        if start.kind == RAY:
            y, half_turns = start.w / frame.q, arithmetic.to_float(left / arb.pi())
            abel = abel_functions(scene.pair.share, digits, y) if half_turns >= _JUMP_PAYS_AFTER else None
            if abel is not None:
                count, y, elapsed = _exit_before(abel, y, left)
                side = start.side if count % 2 == 0 else -start.side
                ray = on_ray(frame, side, arb(0), y * frame.q, start.tau + elapsed)
                road, excursions, walk = EnergyMethod.ABEL, excursions + count, motions(frame, ray)
                continue
            _refuse_countless(arithmetic.to_float(y), half_turns, 1 - scene.pair.share, digits, max_steps - stepped)
        if stepped == max_steps:
            raise OutOfRange(f"more than {max_steps} events before the return map takes over; raise max_steps")
        excursions += start.kind == STICK
        stepped += road is EnergyMethod.STEPPED
    state, mode = state_at(frame, start, left), MODES[mode_of(start)]
    energy = frame.critical_energy * (1 + state.w)  # w is the accurate one
    return frame, energy, state.w, excursions, mode, state, road, stepped


def _refuse_countless(y: float, half_turns: float, r: Fraction, digits: int, left: int) -> None:
    """Raise OutOfRange at once where so many steps as are `left` are certainly too few for a jump or the target.

    1/y grows by G/(y (1 - G)) <= a/(1 - a y) an excursion, as c <= 3 y/2 and so G <= a y, a = 9 r/4: for a y < 1/2 by
    less than 2 a, and it never merges. An excursion is two events and takes less than the reduced time 4 pi.
    """
    a, reach = float(9 * r / 4), reach_of(digits)
    if not reach < y < 1 / (2 * a):
        return
    events = min((1 / reach - 1 / y) / a, half_turns / 2)
    if events > left:
        raise OutOfRange(
            f"{digits} working digits need about {events:.0e} events before the return map applies, "
            f"the limit leaves {left}; request fewer digits, or raise max_steps"
        )


def _exit_before(abel: AbelFunctions, y: arb, elapsed: arb) -> tuple[int, arb, arb]:
    """Return (n, y_n, reduced time of n cycles), the time proved to be before `elapsed`, by a few cycles at most."""
    alpha, beta, left, count = abel.alpha(y), abel.beta(y), elapsed, 0
    for _ in range(200):
        whole = (left / arb.pi()).mid().floor().unique_fmpz()
        count = max(0, count + int(whole or 0) - 1)
        here = abel.alpha_inverse(alpha + count, y) if count else y
        time = abel.beta(here) - beta
        left = elapsed - time
        if 0 <= left < 4 * arb.pi():
            return count, here, time
    raise undecided("which exit is the last one before the time asked for?", left)
