"""The energy at any time, however late, without stepping there: `energy_at`.

Three roads, the cheapest that gives what is asked: a pair that never slips again keeps its energy; a few hundred events
are stepped one by one; beyond those, on an exit ray close to the critical orbit, the Abel functions of the return map
(abel.py) jump over all remaining excursions at once. Everything is enclosed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from functools import lru_cache

from flint import arb, fmpq

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.protocol import Arithmetic, Number, decide_sign
from numerics.errors import EventUndecided, InvalidScene, OutOfRange, PrecisionExhausted
from numerics.long_time.abel import AbelFunctions
from numerics.motion.frame import Frame, ReducedState
from numerics.motion.modes import Mode
from numerics.old.motion import Motion
from numerics.old.start import initial_motion
from numerics.old.undamped import UndampedSlip, UndampedStick
from numerics.scene import Scene
from numerics.scene.decimals import Exact, exact_decimal
from numerics.trajectory.accuracy import digits_within

MAX_STEPS = 200_000
MAX_DIGITS = 20_000
_JUMP_PAYS_AFTER = 300
"""Excursions left, from which on a jump is cheaper than stepping."""
_SPARE_DIGITS = 12


class Road(Enum):
    """How the answer was found; the value is the sentence that --explain prints."""

    NO_MORE_SLIP = "the pair never slips again: its energy is that of its last slip, or its start"
    STEPPED = "every event up to the time was located, one after the other"
    ABEL = "close to the critical orbit the Abel functions of the return map jumped over all remaining excursions"


@dataclass(frozen=True)
class EnergyAt:
    """The answer at time t (s): energy (J), excess w, excursions so far, mode and reduced state; enclosures.

    `stepped` counts the events that were located one by one, `digits` the right digits of energy and excess.
    """

    scene: Scene
    t: Fraction
    frame: Frame
    energy: Number
    energy_excess: Number
    excursions: int
    mode: Mode
    state: ReducedState
    road: Road
    stepped: int
    digits: int

    @property
    def si_state(self) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) in m and m/s, the phase at time t; after a jump x2 counts from an unknown origin."""
        with self.frame.arithmetic.context():
            return self.frame.si_state(self.state)


def energy_at(
    scene: Scene, t: Exact, *, digits: int = 15, max_steps: int = MAX_STEPS, max_digits: int = MAX_DIGITS
) -> EnergyAt:
    """Return the energy of a scene at time t (s) > 0, its `until` disregarded, to `digits` right digits (proved).

    Raises InvalidScene (t), OutOfRange (too many events before the return map takes over), EventUndecided and
    PrecisionExhausted (the cap on the working digits).
    """
    at = exact_decimal(t, "t")
    if at <= 0:
        raise InvalidScene("t must be > 0; give the time in seconds")
    rate_squared = scene.pair.a2 / scene.pair.mass * at * at
    size = max(0, math.ceil((rate_squared.numerator.bit_length() - rate_squared.denominator.bit_length()) * 0.1506))
    working = digits + size + _SPARE_DIGITS
    undecided: EventUndecided | None = None
    while working <= max_digits:
        try:
            found = _attempt(scene, at, working, working - size, max_steps)
            if found.digits >= digits:
                return found
            undecided, working = None, working + digits - found.digits + _SPARE_DIGITS
        except EventUndecided as error:
            undecided, working = error, 2 * working
    if undecided is not None:
        raise undecided
    raise PrecisionExhausted(
        f"{digits} right digits at t = {arb(fmpq(at.numerator, at.denominator)).str(6, radius=False)} s need more than "
        f"{max_digits} working digits; raise max_digits (--max-digits)"
    )


def _attempt(scene: Scene, at: Fraction, working: int, reach_digits: int, max_steps: int) -> EnergyAt:
    arithmetic = Ball(working)
    with arithmetic.context():
        walk = _Walk(scene, Frame(arithmetic, scene.pair), arithmetic.number(at), reach_digits)
        walk.step(max_steps)
        if walk.road is Road.ABEL:
            walk.jump()
        state = walk.motion.state(walk.target - walk.start)
        w = state.w
        # viscosity takes E to 0, where 1 + w would cancel; without it w is the accurate one
        energy = walk.frame.energy(state) if scene.pair.a1 > 0 else walk.frame.critical_energy * (1 + w)
        right = min(digits_within(energy.rad(), energy, walk.frame.critical_energy), digits_within(w.rad(), w, arb(1)))
    return EnergyAt(
        scene, at, walk.frame, energy, w, walk.excursions, walk.motion.mode, state, walk.road, walk.stepped, right
    )


class _Walk:
    """From the start towards the target time: by events, then by the return map."""

    def __init__(self, scene: Scene, frame: Frame, at: Number, digits: int) -> None:
        self.frame, self.arithmetic, self.digits = frame, frame.arithmetic, digits
        self.motion: Motion = initial_motion(frame, scene)
        self.start, self.target = self.arithmetic.number(0), frame.rate * at
        self.excursions, self.stepped, self.road = 0, 0, Road.STEPPED
        self.share = scene.pair.m1 / scene.pair.mass

    def step(self, max_steps: int) -> None:
        """Locate events until the target lies in the current motion, nothing slips any more, or a jump pays."""
        while True:
            if self._may_jump():
                self.road = Road.ABEL
                return
            self._refuse_countless(max_steps)
            duration = self.motion.duration()
            if duration is None:
                self.road = Road.NO_MORE_SLIP
                return
            end = self.start + duration
            question = "does the next event come before the time asked for?"
            if decide_sign(self.arithmetic, end - self.target, question) > 0:
                return
            if self.stepped == max_steps:
                raise OutOfRange(
                    f"more than {max_steps} events before the return map takes over; raise max_steps (--max-steps)"
                )
            was_stuck = self.motion.mode is Mode.STICK
            self.motion, self.start, self.stepped = self.motion.successor(), end, self.stepped + 1
            self.excursions += was_stuck

    def _refuse_countless(self, max_steps: int) -> None:
        """Raise OutOfRange at once where the cap on steps is certain to be met before a jump or the target.

        1/y grows by G/(y (1 - G)) <= a/(1 - a y) an excursion, as c <= 3 y/2 and so G <= a y, a = 9 r/4: for a y < 1/2
        by less than 2 a, and it never merges. An excursion is two events and takes less than the reduced time 4 pi.
        """
        motion, number = self.motion, self.arithmetic.to_float
        if not isinstance(motion, UndampedSlip) or not motion.from_ray:
            return
        a, y = 9 * number(self.frame.r) / 4, number(motion.w / self.frame.q)
        reach = _reach(self.digits)
        if not reach < y < 1 / (2 * a):
            return
        half_turns = number((self.target - self.start) / self.arithmetic.pi())
        events = min((1 / reach - 1 / y) / a, half_turns / 2)
        if events > max_steps - self.stepped:
            raise OutOfRange(
                f"{self.digits} working digits need about {events:.0e} events before the return map takes over, "
                f"the cap is {max_steps}; ask for fewer digits, or raise max_steps (--max-steps)"
            )

    def _may_jump(self) -> bool:
        """Return whether the pair is on an exit ray, close enough to E_cr for the digits, with a long way to go."""
        motion = self.motion
        if not isinstance(motion, UndampedSlip) or not motion.from_ray:
            return False
        remaining = self.arithmetic.to_float((self.target - self.start) / self.arithmetic.pi())
        if remaining < _JUMP_PAYS_AFTER:
            return False
        y = self.arithmetic.to_float(motion.w / self.frame.q)
        if y >= _reach(self.digits):
            return False
        return y < _abel_functions(self.share, _order(self.digits)).largest_argument

    def jump(self) -> None:
        """Put the motion on the last exit ray before the target: alpha counts excursions, beta adds up their times."""
        motion = self.motion
        assert isinstance(motion, UndampedSlip)
        abel = _abel_functions(self.share, _order(self.digits))
        y = motion.w / self.frame.q
        count, later, elapsed = _last_exit_before(self.arithmetic, abel, y, self.target - self.start)
        side = motion.side if count % 2 == 0 else -motion.side
        self.start, self.excursions = self.start + elapsed, self.excursions + count
        w = later * self.frame.q
        self.motion = UndampedSlip.from_exit_ray(self.frame, motion.law, side, self.arithmetic.number(0), w)
        duration = self.motion.duration()
        assert duration is not None
        if decide_sign(self.arithmetic, self.start + duration - self.target, "does the slip end before the time?") <= 0:
            self.start, self.motion = self.start + duration, self.motion.successor()
            assert isinstance(self.motion, UndampedStick)


def _last_exit_before(
    arithmetic: Arithmetic, abel: AbelFunctions, y: Number, elapsed: Number
) -> tuple[int, Number, Number]:
    """Return (n, y_n, reduced time of n cycles) for the largest n whose time is at most `elapsed`; all proved."""
    alpha, beta = abel.alpha(y), abel.beta(y)
    count = max(0, _whole(elapsed / arb.pi()))
    for _ in range(200):
        try:
            here, next_one = (abel.alpha_inverse(alpha + n, y) if n else y for n in (count, count + 1))
        except ArithmeticError as error:
            raise EventUndecided(str(error), arithmetic.text(y), arithmetic.digits) from None
        time, next_time = abel.beta(here) - beta, abel.beta(next_one) - beta
        if time <= elapsed and next_time > elapsed:
            return count, here, time
        if time > elapsed:
            count = max(0, count - max(1, _whole((time - elapsed) / 4)))
        elif next_time <= elapsed:
            count += max(1, _whole((elapsed - next_time) / 4))
        else:
            break
    question = "which is the last exit before the time asked for?"
    raise EventUndecided(question, arithmetic.text(time - elapsed), arithmetic.digits)


def _whole(x: Number) -> int:
    """Return the whole part of the midpoint of a ball."""
    return int(x.mid().floor().unique_fmpz() or 0)


def _order(digits: int) -> int:
    """Return the number of terms that lets the jump start early enough for this many digits."""
    return max(24, min(80, digits))


def _reach(digits: int) -> float:
    """Return the largest y = w/q to jump from: there the terms left out are below the digits asked for."""
    order = _order(digits)
    return float(0.12 * 10.0 ** (-digits / (order + 1)))


@lru_cache(maxsize=8)
def _abel_functions(share: Fraction, order: int) -> AbelFunctions:
    return AbelFunctions(share, order)
