"""The undamped slip: after one change of variables it is the same motion for every pair.

For a slip of sign s put sigma = -s, angle theta = tau/sqrt(q), and from its start
    gap    d = (sigma X - 1)/q          signed distance beyond the edge of the sliding region that it may leave by
    push   u = sigma V1/sqrt(q)
    guard  k = s (V1 - V2)/sqrt(q)      positive while the slip lasts, k(0) = g
Then (1 + d, u) turns on a circle and, with versine = 1 - cos and sine_deficit = theta - sin, free of cancellation,
    k(theta)  = g + d sin + u versine - sine_deficit,       k' = d(theta)
    d(theta)  = d - (1 + d) versine + u sin
    u(theta)  = u - u versine - (1 + d) sin
    K(theta)  = g theta + d versine + u sine_deficit - (theta^2/2 - versine)
where K is the integral of k: the bodies have slid q K (in units of L) and E/E_cr has dropped by 2 r q K.
"""

from __future__ import annotations

from dataclasses import dataclass

from numerics.arithmetic.protocol import Arithmetic, Number, Sign, decide_sign
from numerics.errors import EventUndecided, OutOfRange
from numerics.kernel.first_contact import guard_root

_SMALLEST_ANGLE = 1e-97
"""Its cube, the size of the guard there, still is a normal binary64 number with bits to spare."""


@dataclass(frozen=True, slots=True)
class SlipFlow:
    """An undamped slip in the variables above; all dimensionless."""

    arithmetic: Arithmetic
    guard_at_start: Number
    gap_at_start: Number
    push_at_start: Number
    turns: bool = True
    """Whether the guard has extrema, A^2 = (1 + d)^2 + u^2 > 1: decided on exact rationals where A may be 1."""

    def guard(self, theta: Number) -> Number:
        """Return k(theta)."""
        arithmetic = self.arithmetic
        _, sine = arithmetic.cos_sin(theta)
        turning = self.gap_at_start * sine + self.push_at_start * arithmetic.versine(theta)
        return (turning - arithmetic.sine_deficit(theta)) + self.guard_at_start

    def gap(self, theta: Number) -> Number:
        """Return d(theta) = k'(theta)."""
        _, sine = self.arithmetic.cos_sin(theta)
        drop = (1 + self.gap_at_start) * self.arithmetic.versine(theta)
        return self.gap_at_start + (self.push_at_start * sine - drop)

    def push(self, theta: Number) -> Number:
        """Return u(theta)."""
        cosine, sine = self.arithmetic.cos_sin(theta)
        return self.push_at_start * cosine - (1 + self.gap_at_start) * sine

    def slid(self, theta: Number) -> Number:
        """Return K(theta), the integral of the guard; its slope is the guard, so at a contact it is stationary."""
        return self.arithmetic.mean_value(self._slid, self.guard, theta)

    def _slid(self, theta: Number) -> Number:
        arithmetic = self.arithmetic
        grown = self.gap_at_start * arithmetic.versine(theta) + self.push_at_start * arithmetic.sine_deficit(theta)
        return (grown - arithmetic.cosine_deficit(theta)) + self.guard_at_start * theta

    def first_contact(self) -> Number:
        """Return the first theta > 0 with k = 0 of a slip that starts off the surface (slip_contact.py has g = 0).

        k' = A cos(theta - phase) - 1 vanishes at phase +- lean + 2 pi j, so the pieces on which k is monotone are
        explicit; its local minima fall by 2 pi from one to the next, so the first one below zero is known without
        visiting the others. The root lies on the decreasing piece before it, and is the first.
        A minimum that is not proved to be above or below zero is a graze: EventUndecided.
        """
        lower, upper = self._bracket()
        return self.arithmetic.root(self.guard, self.gap, lower, upper, self._guess(lower, upper))

    def _guess(self, lower: Number, upper: Number) -> float | None:
        """Return the root that binary64 finds in the bracket, None where it has no digits for it."""
        number = self.arithmetic.to_float
        variables = [number(one) for one in (self.guard_at_start, self.gap_at_start, self.push_at_start, lower, upper)]
        if self.arithmetic.name != "ball" or not all(1e-9 < abs(one) < 1e4 for one in variables if one):
            return None
        return guard_root(*variables)

    def _bracket(self) -> tuple[Number, Number]:
        arithmetic, d, u = self.arithmetic, self.gap_at_start, self.push_at_start
        excess = d * (2 + d) + u * u  # A^2 - 1
        if not self.turns or decide_sign(arithmetic, excess, "does the guard of this slip turn at all?") <= 0:
            return arithmetic.number(0), self.guard_at_start + u + 3  # monotone: k <= g + u + A - theta, A <= 1
        lean = arithmetic.atan2(arithmetic.sqrt(excess), arithmetic.number(1))
        phase = arithmetic.atan2(u, 1 + d)
        turn = 2 * arithmetic.pi()
        minimum_at_zero = self.guard_at_start + u - arithmetic.sqrt(excess) + (lean - phase)  # k(phase - lean)
        index = self._first_minimum_below_zero(phase - lean, minimum_at_zero / turn)
        minimum = phase - lean + turn * index
        maximum = minimum - turn + 2 * lean
        start_is_later = arithmetic.to_float(maximum) <= 0  # then the start itself, where k = g > 0, is the left end
        return (arithmetic.number(0) if start_is_later else maximum), minimum

    def _first_minimum_below_zero(self, first: Number, turns: Number) -> int:
        """Return the index j of the first minimum first + 2 pi j > 0 at which k = 2 pi (turns - j) is negative."""
        arithmetic = self.arithmetic
        least = 1 if arithmetic.sign(first) is not Sign.POSITIVE else 0
        if least and arithmetic.sign(first) is Sign.UNDECIDED and arithmetic.sign(turns) is not Sign.POSITIVE:
            raise EventUndecided(
                "is the guard's minimum next to the start before it?", arithmetic.text(first), arithmetic.digits
            )
        index = arithmetic.ceiling(turns)
        if index is None:
            question = "does the slip touch the switching surface without crossing it (a graze)?"
            raise EventUndecided(question, arithmetic.text(turns), arithmetic.digits)
        return max(least, index)


def refuse_unresolved(arithmetic: Arithmetic, theta: Number) -> None:
    """Raise OutOfRange where the digits of theta leave no phase, or its cube no digits; balls need no such care."""
    if arithmetic.name == "ball":
        return
    if theta > 10 ** (arithmetic.digits - 3):
        angle = f"one slip turns through {arithmetic.text(theta)} rad"
        raise OutOfRange(f"{angle}, which {arithmetic.digits} digits do not resolve; use --arithmetic ball")
    if arithmetic.name == "float64" and theta < _SMALLEST_ANGLE:
        raise OutOfRange(f"one slip turns through {theta:g} rad, whose cube is below float64; use --arithmetic ball")
