"""The energy at any time, however late, without stepping there: `energy_at`.

Three roads, the cheapest that gives what is asked: a pair that never slips again keeps its energy; a few hundred events
are stepped one by one; beyond those, on an exit ray close to the critical orbit, the Abel functions of the return map
(abel.py) jump over all remaining excursions at once. Everything is enclosed. A pair with a damper is stepped.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise

from flint import arb

from numerics.arithmetic.attempts import SPARE_DIGITS, to_digits
from numerics.arithmetic.ball import Ball, proved_sign, undecided
from numerics.arithmetic.protocol import Number
from numerics.errors import InvalidScene, OutOfRange
from numerics.free.abel import AbelFunctions
from numerics.free.engine import begin_exactly
from numerics.free.frame import Frame
from numerics.free.motion import State, on_ray, state_at
from numerics.free.walk import Walk
from numerics.linear.modes import MODES, Mode
from numerics.linear.record import How
from numerics.scene import Scene
from numerics.scene.decimals import Exact, exact_decimal, short

MAX_STEPS = 200_000
MAX_DIGITS = 20_000
_JUMP_PAYS_AFTER = 300
"""Excursions left, from which on a jump is cheaper than stepping."""


class Road(Enum):
    """How the answer was found; the value is the sentence that --explain prints."""

    NO_MORE_SLIP = "the pair never slips again: its energy is that of its last slip, or its start"
    STEPPED = "every event up to the time was located, one after the other"
    ABEL = "close to the critical orbit the Abel functions of the return map jumped over all remaining excursions"


@dataclass(frozen=True)
class EnergyAt:
    """The answer at time t (s): energy (J), excess w, excursions so far, mode and state; enclosures.

    `si_state` is (x1, v1, x2, v2) in m and m/s; after a jump x2 counts from an unknown origin. `state` is the same,
    reduced; None with a damper. `stepped` counts the events that were located one by one, `digits` the right digits of
    energy and excess.
    """

    scene: Scene
    t: Fraction
    frame: Frame
    energy: Number
    energy_excess: Number
    excursions: int
    mode: Mode
    state: State | None
    si_state: tuple[Number, Number, Number, Number]
    road: Road
    stepped: int
    digits: int


def energy_at(
    scene: Scene, t: Exact, *, digits: int = 15, max_steps: int = MAX_STEPS, max_digits: int = MAX_DIGITS
) -> EnergyAt:
    """Return the energy of a scene at time t (s) > 0, its `until` disregarded, to `digits` right digits (proved).

    Raises InvalidScene (t), NoForceHere, OutOfRange (too many events before the return map takes over), EventUndecided
    and PrecisionExhausted (the cap on the working digits).
    """
    at = exact_decimal(t, "t")
    if at <= 0:
        raise InvalidScene(f"t = {short(at)} must be > 0; give the time in seconds")
    rate_squared = scene.pair.a2 / scene.pair.mass * at * at
    size = max(0, math.ceil((rate_squared.numerator.bit_length() - rate_squared.denominator.bit_length()) * 0.1506))

    def attempt(arithmetic: Ball) -> tuple[EnergyAt, list[arb]]:
        if scene.pair.a1 > 0 and not scene.is_forced:
            found = _damped(scene, at, arithmetic, max_steps, digits)
        else:
            found = _Way(scene, at, arithmetic, arithmetic.digits - size).found(max_steps, digits)
        return found, [found.energy / found.frame.critical_energy, found.energy_excess]

    return to_digits(attempt, digits, max_digits, size + SPARE_DIGITS)


def _damped(scene: Scene, at: Fraction, arithmetic: Ball, max_steps: int, digits: int) -> EnergyAt:
    """Return the answer for a pair with a damper, which takes E to 0, where 1 + w would cancel."""
    from numerics.linear.engine import run_linear

    record = run_linear(Scene(scene.pair, scene.initial, at, scene.law), arithmetic, max_steps)
    if record.how is How.EVENT_LIMIT:
        raise OutOfRange(f"more than {max_steps} events before t = {short(at)} s; raise max_steps")
    frame, end, pair = Frame(arithmetic, scene.pair), record.end, scene.pair
    m1, m2, a2 = (arithmetic.number(one) for one in (pair.m1, pair.m2, pair.a2))
    energy = (a2 * end.x1**2 + m1 * end.v1**2 + m2 * end.v2**2) / 2
    signs = [row.mode for row in record.rows]
    exits = sum(before == 0 != after for before, after in pairwise(signs))
    road = Road.NO_MORE_SLIP if record.how is How.STUCK else Road.STEPPED
    found = energy, energy / frame.critical_energy - 1, exits, MODES[end.mode], None, (end.x1, end.v1, end.x2, end.v2)
    return EnergyAt(scene, at, frame, *found, road, record.events, digits)


class _Way:
    """From the start towards the target, a reduced time: by events, then by the return map."""

    def __init__(self, scene: Scene, at: Fraction, arithmetic: Ball, digits: int) -> None:
        self.scene, self.at, self.arithmetic, self.digits = scene, at, arithmetic, digits
        begun, _ = begin_exactly(scene, arithmetic)
        self.frame = Frame(arithmetic, scene.pair)
        self.target = self.frame.rate * arithmetic.number(at)
        self.walk = Walk(arithmetic, begun.at, begun.start)
        self.excursions, self.stepped, self.road = 0, 0, Road.STEPPED
        self.share = scene.pair.share

    def found(self, max_steps: int, digits: int) -> EnergyAt:
        """Go the whole way, for so many right digits."""
        self._step(max_steps)
        if self.road is Road.ABEL:
            self._jump()
        walk, frame = self.walk, self.frame
        state = state_at(walk.at, walk.start, self.target - walk.start.tau)
        energy = frame.critical_energy * (1 + state.w)  # w is the accurate one
        found = energy, state.w, self.excursions, walk.mode, state, frame.si_state(state)
        return EnergyAt(self.scene, self.at, frame, *found, self.road, self.stepped, digits)

    @property
    def _y(self) -> float:
        """Return w/q at the start of the present motion."""
        return self.arithmetic.to_float(self.walk.start.w / self.frame.q)

    @property
    def _half_turns(self) -> float:
        """Return the reduced time to go, over pi."""
        return self.arithmetic.to_float((self.target - self.walk.start.tau) / arb.pi())

    def _step(self, max_steps: int) -> None:
        """Locate events until the target lies in the current motion, nothing slips any more, or a jump pays."""
        while True:
            if self._may_jump():
                self.road = Road.ABEL
                return
            self._refuse_countless(max_steps)
            duration = self.walk.duration
            if duration is None:
                self.road = Road.NO_MORE_SLIP
                return
            if self._ends_later(duration):
                return
            if self.stepped == max_steps:
                raise OutOfRange(f"more than {max_steps} events before the return map takes over; raise max_steps")
            self.excursions += self.walk.mode is Mode.STICK
            self.walk.go_on()
            self.stepped += 1

    def _ends_later(self, duration: arb) -> bool:
        """Return whether the present motion ends after the target; proved."""
        question = "does the next event come before the time asked for?"
        return proved_sign(self.walk.start.tau + duration - self.target, question) > 0

    def _refuse_countless(self, max_steps: int) -> None:
        """Raise OutOfRange at once where the cap on steps is certain to be met before a jump or the target.

        1/y grows by G/(y (1 - G)) <= a/(1 - a y) an excursion, as c <= 3 y/2 and so G <= a y, a = 9 r/4: for a y < 1/2
        by less than 2 a, and it never merges. An excursion is two events and takes less than the reduced time 4 pi.
        """
        if not self.walk.on_ray:
            return
        a, y, reach = 9 * self.arithmetic.to_float(self.frame.r) / 4, self._y, reach_of(self.digits)
        if not reach < y < 1 / (2 * a):
            return
        events = min((1 / reach - 1 / y) / a, self._half_turns / 2)
        if events > max_steps - self.stepped:
            raise OutOfRange(
                f"{self.digits} working digits need about {events:.0e} events before the return map takes over, "
                f"the cap is {max_steps}; ask for fewer digits, or raise max_steps"
            )

    def _may_jump(self) -> bool:
        """Return whether the pair is on an exit ray, close enough to E_cr for the digits, with a long way to go."""
        if not self.walk.on_ray or self._half_turns < _JUMP_PAYS_AFTER or self._y >= reach_of(self.digits):
            return False
        return self._y < abel_functions(self.share, order_for(self.digits)).largest_argument

    def _jump(self) -> None:
        """Put the pair on the last exit ray before the target: alpha counts excursions, beta adds up their times."""
        start, q = self.walk.start, self.frame.q
        abel = abel_functions(self.share, order_for(self.digits))
        count, y, elapsed = _last_exit_before(abel, start.w / q, self.target - start.tau)
        self.excursions += count
        side = start.side if count % 2 == 0 else -start.side
        self.walk.put(on_ray(self.walk.at, side, arb(0), y * q, start.tau + elapsed, arb(0), arb(0)))
        if not self._ends_later(self.walk.duration):
            self.walk.go_on()
            assert self.walk.mode is Mode.STICK


def _last_exit_before(abel: AbelFunctions, y: arb, elapsed: arb) -> tuple[int, arb, arb]:
    """Return (n, y_n, reduced time of n cycles) for the largest n whose time is at most `elapsed`; all proved."""
    alpha, beta = abel.alpha(y), abel.beta(y)
    count = max(0, _whole(elapsed / arb.pi()))
    for _ in range(200):
        try:
            here, next_one = (abel.alpha_inverse(alpha + n, y) if n else y for n in (count, count + 1))
        except ArithmeticError as error:
            raise undecided(str(error), y) from None
        time, next_time = abel.beta(here) - beta, abel.beta(next_one) - beta
        if time <= elapsed and next_time > elapsed:
            return count, here, time
        if time > elapsed:
            count = max(0, count - max(1, _whole((time - elapsed) / 4)))
        elif next_time <= elapsed:
            count += max(1, _whole((elapsed - next_time) / 4))
        else:
            break
    raise undecided("which is the last exit before the time asked for?", time - elapsed)


def _whole(x: Number) -> int:
    """Return the whole part of the midpoint of a ball."""
    return int(x.mid().floor().unique_fmpz() or 0)


def order_for(digits: int) -> int:
    """Return the number of terms that lets the jump start early enough for this many digits."""
    return max(24, min(80, digits))


def reach_of(digits: int) -> float:
    """Return the largest y = w/q to jump from: there the terms left out are below the digits asked for."""
    order = order_for(digits)
    return float(0.12 * 10.0 ** (-digits / (order + 1)))


@lru_cache(maxsize=8)
def abel_functions(share: Fraction, order: int) -> AbelFunctions:
    """Return the Abel functions of a mass share, computed once."""
    return AbelFunctions(share, order)
