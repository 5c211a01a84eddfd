"""The contact of a slip from the switching surface in balls, at the price of one sine-cosine at full precision.

The equation is that of slip_contact.py, in theta for push <= 1 and in eta = 2 pi - theta beyond. A binary64 root is
refined by Halley's method, the precision tripled with each step, up to half of the bits asked for. There the function
is evaluated once at full precision and one interval Newton step encloses the root: its slope need only be known to half
of the bits. The inclusion proves the root; that it is the only one in (0, 2 pi), hence the first, is a theorem.
"""

from __future__ import annotations

import math
from typing import Any

from flint import arb, ctx

from numerics.arithmetic.protocol import Contact
from numerics.kernel.contact import contact as binary64_contact
from numerics.kernel.contact import late_angle

_SEED_BITS = 44
_SMALLEST_SEED = 1e-90
_SPARE_BITS = 12


def ball_contact(gap: arb, push: arb) -> Contact | None:
    """Return the enclosed contact at flint's present precision, None without a binary64 seed or without a proof."""
    d, u = float(gap.mid()), float(push.mid())
    if not (0.0 <= d < math.inf and abs(u) < math.inf) or d == u == 0.0 or (d == 0.0 and u < 0.0):
        return None
    try:
        equation = _Late(gap, push, late_angle(d, u)) if u > 1.0 else _Early(gap, push, binary64_contact(d, u)[0])
    except ArithmeticError:
        return None
    return _enclosed(equation) if equation.seed > _SMALLEST_SEED else None


def _enclosed(equation: Any) -> Contact | None:
    """Refine the seed, then prove the root next to it and return what follows from one evaluation there."""
    bits = ctx.prec
    missing = 2 * max(0, -math.frexp(equation.seed)[1])  # bits that cancel for small angles
    half = bits // 2 + _SPARE_BITS
    x, right = arb(equation.seed), _SEED_BITS
    try:
        while right < half:
            right = min(3 * right - 4, half)
            ctx.prec = right + missing + _SPARE_BITS
            x = (x + equation.at(x).halley()).mid()
        ctx.prec = bits + missing + _SPARE_BITS
        at = equation.at(x)
        # a first guess of the distance: half the bits are right, more where the inputs are wide
        width = (2 * abs(at.value / at.slope)).upper() + x * arb(2) ** -(bits + _SPARE_BITS)
        for _ in range(3):
            spread = arb(0, width.upper())
            slope = at.slope_over(spread)
            inside = x + spread > 0 and x + spread < equation.reach
            if inside and slope < 0 and spread.contains_interior(shift := -at.value / slope):
                ctx.prec = bits
                return equation.contact(at, shift)
            width = 4 * width
    finally:
        ctx.prec = bits
    return None


class _Early:
    """u + d cot(theta/2) - h(theta), of slope -(c + d)/(1 - cos theta)."""

    reach = 3.4
    """Up to here the bounds on h' below hold; for push <= 1 the root is below 3.3."""

    def __init__(self, gap: arb, push: arb, seed: float) -> None:
        self.gap, self.push, self.seed = gap, push, seed

    def at(self, x: arb) -> _EarlyPoint:
        return _EarlyPoint(self.gap, self.push, x)

    @staticmethod
    def contact(at: _EarlyPoint, shift: arb) -> Contact:
        """Return the contact at x + shift: c' = h, h' <= 5/4 below 3.4; the second derivative of 1 - cos is <= 1."""
        depth = at.depth + (at.rise + arb(0, (abs(shift) * 5 / 4).upper())) * shift
        versine = at.versine + 2 * at.sine * at.cosine * shift + arb(0, (shift * shift / 2).upper())
        return Contact(at.x + shift, depth, versine)


class _EarlyPoint:
    """The equation and its slope at an exact angle x, from one sine and cosine of x/2."""

    def __init__(self, gap: arb, push: arb, x: arb) -> None:
        self.gap, self.x = gap, x
        self.sine, self.cosine = sine, cosine = (x / 2).sin_cos()
        cotangent = cosine / sine
        self.versine = versine = 2 * sine * sine
        self.depth = 2 - x * cotangent
        self.rise = x / versine - cotangent
        self.value = push + gap * cotangent - self.rise
        self.slope = -(self.depth + gap) / versine

    def halley(self) -> arb:
        """Return the step of Halley's method: lead'' = ((d + c) cot - h)/(1 - cos)."""
        shift = -self.value / self.slope
        second = ((self.gap + self.depth) * self.cosine / self.sine - self.rise) / self.versine
        return shift / (1 + shift * second / (2 * self.slope))

    def slope_over(self, spread: arb) -> arb:
        """Return the slope over x + spread: c and h grow at rates at most 2 and 5/4 below 3.4, sin(x/2) at most 1/2."""
        depth = self.depth + (self.rise + 5 * spread / 4) * spread
        sine = self.sine + spread / 2
        return -(depth + self.gap) / (2 * sine * sine)


class _Late:
    """2 pi + d sin eta - u (1 - cos eta) - (eta - sin eta) in eta = 2 pi - theta."""

    reach = 5
    """Beyond the root, which for push > 1 is below 3 pi/2."""

    def __init__(self, gap: arb, push: arb, seed: float) -> None:
        self.gap, self.push, self.seed = gap, push, seed

    def at(self, x: arb) -> _LatePoint:
        return _LatePoint(self.gap, self.push, x)

    @staticmethod
    def contact(at: _LatePoint, shift: arb) -> Contact:
        """Return the contact at eta + shift; dc/d eta = -h(theta) = -(theta + sin eta)/(1 - cos eta)."""
        turn = 2 * arb.pi()
        theta = turn - (at.x + shift)
        spread = arb(0, abs(shift).upper())
        versine_over = at.versine + at.sine * spread + arb(0, (shift * shift / 2).upper())
        rise = (turn - (at.x + spread) + at.sine + spread) / versine_over
        depth = 2 + (turn - at.x) * at.half_cosine / at.half_sine - rise * shift
        return Contact(theta, depth, at.versine + at.sine * shift + arb(0, (shift * shift / 2).upper()))


class _LatePoint:
    def __init__(self, gap: arb, push: arb, x: arb) -> None:
        self.gap, self.push, self.x = gap, push, x
        self.half_sine, self.half_cosine = half_sine, half_cosine = (x / 2).sin_cos()
        self.sine = sine = 2 * half_sine * half_cosine
        self.versine = versine = 2 * half_sine * half_sine
        self.value = 2 * arb.pi() + gap * sine - push * versine - (x - sine)
        self.slope = gap * (1 - versine) - push * sine - versine

    def halley(self) -> arb:
        """Return the step of Halley's method: the second derivative is -d sin - u cos - sin."""
        shift = -self.value / self.slope
        second = -(self.gap + 1) * self.sine - self.push * (1 - self.versine)
        return shift / (1 + shift * second / (2 * self.slope))

    def slope_over(self, spread: arb) -> arb:
        """Return the slope over eta + spread: sine, cosine and versine change by at most |spread|."""
        versine = self.versine + (self.sine + spread) * spread
        return self.gap * (1 - versine) - self.push * (self.sine + spread) - versine
