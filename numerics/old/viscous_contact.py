"""The first contact of a viscous slip, certified.

With y = s X + r, the guard is f(tau) = y'(tau) - c - tau, c = s V2 at the start: a damped sinusoid and a line.
The zeros of f'' = y''' are closed-form; between two of them f' is monotone and has at most one zero, which a bracket
encloses; between two zeros of f' the guard is monotone and has at most one root. Nothing is sampled.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from numerics.arithmetic.protocol import Arithmetic, Number, Sign, decide_sign
from numerics.errors import OutOfRange
from numerics.old.oscillator import Oscillator
from numerics.old.slip_flow import refuse_unresolved

MAX_PIECES = 100_000


@dataclass(frozen=True, slots=True)
class Guard:
    """f(tau) = y'(tau) - c - tau along q y'' + 2 zeta y' + y = 0 from (y, v); dimensionless."""

    oscillator: Oscillator
    y: Number
    v: Number
    c: Number
    level: bool = False
    """Whether f''(0) = 0 is known to hold exactly."""

    @property
    def arithmetic(self) -> Arithmetic:
        """Return the arithmetic of its numbers."""
        return self.oscillator.arithmetic

    def acceleration(self, y: Number, v: Number) -> Number:
        """Return y''; the same linear map takes (y', y'') to y'''."""
        return -(2 * self.oscillator.decay * v + self.oscillator.stiffness * y)

    def value(self, tau: Number) -> Number:
        """Return f(tau)."""
        return self.oscillator.propagate(self.y, self.v, tau)[1] - self.c - tau

    def slope(self, tau: Number) -> Number:
        """Return f'(tau)."""
        return self.acceleration(*self.oscillator.propagate(self.y, self.v, tau)) - 1

    def curvature(self, tau: Number) -> Number:
        """Return f''(tau)."""
        y, v = self.oscillator.propagate(self.y, self.v, tau)
        return self.acceleration(v, self.acceleration(y, v))

    def after(self, tau: Number) -> Guard:
        """Return the same guard with its clock started at tau."""
        y, v = self.oscillator.propagate(self.y, self.v, tau)
        return Guard(self.oscillator, y, v, self.c + tau)

    def speed_bound(self, tau: Number) -> Number:
        """Return a bound of |y'| from tau on: y'^2 + stiffness y^2 never grows."""
        y, v = self.oscillator.propagate(self.y, self.v, tau)
        return self.arithmetic.sqrt(v * v + self.oscillator.stiffness * y * y)

    def falls_for_ever(self) -> bool:
        """Return whether f' < 0 is proved from the start on: an oscillation died away has no signs left to decide."""
        arithmetic, oscillator = self.arithmetic, self.oscillator
        steepest = 2 * oscillator.decay + arithmetic.sqrt(oscillator.stiffness)
        return arithmetic.sign(1 - steepest * self.speed_bound(arithmetic.number(0))) is Sign.POSITIVE


def first_contact(guard: Guard, *, rising: bool) -> Number:
    """Return the first root of the guard after the start, where f > 0, or f = 0 and it is `rising`.

    Raises EventUndecided (a graze, or a sign not proven) and OutOfRange (too many oscillations to inspect).
    """
    wait = _certain_wait(guard)
    if wait is None:
        return _first_fall(guard, rising=rising)
    _refuse_lost_phase(guard, wait)
    later = guard.after(wait)
    slope = later.slope(guard.arithmetic.number(0))
    return wait + _first_fall(later, rising=decide_sign(guard.arithmetic, slope, "is the guard rising?") > 0)


def _refuse_lost_phase(guard: Guard, wait: Number) -> None:
    """Raise OutOfRange where a point arithmetic keeps no phase of an oscillation that is still alive after `wait`."""
    arithmetic, oscillator = guard.arithmetic, guard.oscillator
    # e^(-2.5 digits) is below the last digit: what has decayed so far needs no phase
    if oscillator.regime > 0 and arithmetic.to_float(oscillator.decay * wait) < 2.5 * arithmetic.digits:
        refuse_unresolved(arithmetic, oscillator.frequency * wait)


def _certain_wait(guard: Guard) -> Number | None:
    """Return a time up to which f > 0 is certain, if that is more than a few oscillations: they need no inspection.

    f(tau) >= -speed_bound(t) - c - tau for tau >= t; as the oscillation decays the bound is taken again and again.
    """
    arithmetic, wait = guard.arithmetic, guard.arithmetic.number(0)
    for _ in range(60):
        certain = -guard.c - guard.speed_bound(wait)
        if arithmetic.to_float((certain - wait) * guard.oscillator.stiffness * (certain - wait)) < 1000:
            break
        if arithmetic.to_float(certain - wait) <= 0:  # the two as floats would agree long before they do
            break
        wait = wait + 15 * (certain - wait) / 16
    return wait if arithmetic.to_float(wait) > 0 else None


def _first_fall(guard: Guard, *, rising: bool) -> Number:
    """Return the first root by visiting the pieces on which f' is monotone."""
    left, trend = guard.arithmetic.number(0), 1 if rising else -1
    if not rising and guard.falls_for_ever():
        return guard.arithmetic.root(guard.value, guard.slope, left, _certainly_negative(guard))
    for right in _turning_points(guard):
        trend_right = decide_sign(guard.arithmetic, guard.slope(right), "is the guard rising at its inflection?") or 1
        fall = _falling_part(guard, left, trend, right, trend_right)
        if fall is not None:
            question = "does the slip touch the switching surface without crossing it (a graze)?"
            if decide_sign(guard.arithmetic, guard.value(fall[1]), question) < 0:
                return guard.arithmetic.root(guard.value, guard.slope, *fall)
        left, trend = right, trend_right
    raise AssertionError("the guard is negative at the last turning point by construction")


def _falling_part(guard: Guard, left: Number, trend: int, right: Number, trend_right: int) -> tuple | None:  # type: ignore[type-arg]
    """Return the part of [left, right], on which f' is monotone, where f falls; None if it only rises."""
    if trend > 0 and trend_right > 0:
        return None
    if trend < 0 and trend_right < 0:
        return left, right
    flip = trend  # f' falls through zero if it starts positive
    turn = guard.arithmetic.root(_times(flip, guard.slope), _times(flip, guard.curvature), left, right)
    return (turn, right) if trend > 0 else (left, turn)


def _times(factor: int, function: Callable[[Number], Number]) -> Callable[[Number], Number]:
    return lambda tau: factor * function(tau)


def _certainly_negative(guard: Guard) -> Number:
    """Return a time from which f < 0 is certain: f <= |y'| - c - tau."""
    return guard.speed_bound(guard.arithmetic.number(0)) - guard.c + 1


def _turning_points(guard: Guard) -> Iterator[Number]:
    """Yield the zeros of f'' in order, up to and then including a time at which f < 0 is certain."""
    arithmetic, oscillator = guard.arithmetic, guard.oscillator
    last = _certainly_negative(guard)
    point = oscillator.first_jerk_zero(guard.y, guard.v, last, level=guard.level)
    step = arithmetic.pi() / oscillator.frequency if oscillator.regime > 0 else None
    count = 0
    while point is not None and arithmetic.to_float(last - point) > 0:
        yield point
        count += 1
        if count > MAX_PIECES:
            raise OutOfRange(
                f"one slip lasts more than {MAX_PIECES} half oscillations; make |v1 - v2| smaller or set a1 = 0"
            )
        point = None if step is None else point + step
    yield last
