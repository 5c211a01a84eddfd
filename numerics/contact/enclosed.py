"""The contact of a slip from the switching surface in balls, at the price of one sine-cosine at full precision.

The equation is that of surface.py, in theta for push <= 1 and in eta = 2 pi - theta beyond. A binary64 root is refined
by Halley's method, the precision tripled with each step, up to half of the bits asked for. There the function is
evaluated once at full precision and one interval Newton step encloses the root: its slope need only be known to half of
the bits. The inclusion proves the root; that it is the only one in (0, 2 pi), hence the first, is a theorem.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

from flint import arb, ctx

from numerics.arithmetic.ball_words import BALL, precision
from numerics.contact.enclosed_root import EnclosedRoot
from numerics.contact.root import root
from numerics.contact.seed import binary64_contact, late_angle
from numerics.contact.surface import (
    Contact,
    EarlyPoint,
    LatePoint,
    bracketed_contact,
    early_point,
    early_shift,
    late_point,
    late_shift,
)

_SEED_BITS = 44
_SMALLEST_SEED = 1e-90
_SPARE_BITS = 12
_point_early, _shift_early = BALL(early_point), BALL(early_shift)
_point_late, _shift_late = BALL(late_point), BALL(late_shift)
_BRACKETED = BALL.but("bracketed", {root: EnclosedRoot})
_EARLY_REACH, _LATE_REACH = 3.4, 5
"""Up to 3.4 h' <= 5/4 and c' = h <= 2; for push <= 1 the root is below 3.3. For push > 1 eta is below 3 pi/2."""


def enclosed_contact(gap: arb, push: arb) -> Contact:
    """Return the enclosed contact at flint's present precision. Raises EventUndecided."""
    d, u = float(gap.mid()), float(push.mid())
    found = None
    if 0.0 <= d < math.inf and abs(u) < math.inf and (d > 0.0 or u > 0.0):
        found = _late(gap, push, u, d) if u > 1.0 else _early(gap, push, u, d)
    return found or _BRACKETED(bracketed_contact)(gap, push)


def _early(gap: arb, push: arb, u: float, d: float) -> Contact | None:
    """Return the contact for push <= 1; c and h grow at rates at most 2 and 5/4 below 3.4, the second derivative of

    1 - cos is at most 1 and its first sin = (1 - cos) cot."""

    def slope_over(at: EarlyPoint, spread: arb) -> arb:
        depth = at.depth + (at.rise + 5 * spread / 4) * spread
        versine = 1 / at.reciprocal
        return -(depth + at.gap) / (versine + versine * at.cotangent * spread + spread * spread / 2)

    try:
        seed = binary64_contact(d, u)[0]
    except ArithmeticError:
        return None
    found = _proved(seed, partial(_point_early, gap, push), _shift_early, slope_over, _EARLY_REACH)
    if found is None:
        return None
    at, shift = found
    depth = at.depth + (at.rise + arb(0, (abs(shift) * 5 / 4).upper())) * shift
    versine = (1 + at.cotangent * shift) / at.reciprocal + arb(0, (shift * shift / 2).upper())
    return Contact(at.theta + shift, depth, versine)


def _late(gap: arb, push: arb, u: float, d: float) -> Contact | None:
    """Return the contact for push > 1; sine, cosine and versine change by at most |spread|."""

    def slope_over(at: LatePoint, spread: arb) -> arb:
        versine = at.versine + (at.sine + spread) * spread
        return gap * (1 - versine) - push * (at.sine + spread) - versine

    try:
        seed = late_angle(d, u)
    except ArithmeticError:
        return None
    found = _proved(seed, partial(_point_late, gap, push), _shift_late, slope_over, _LATE_REACH)
    if found is None:
        return None
    at, shift = found
    turn, spread = 2 * arb.pi(), arb(0, abs(shift).upper())
    versine_over = at.versine + at.sine * spread + arb(0, (shift * shift / 2).upper())
    rise = (turn - (at.eta + spread) + at.sine + spread) / versine_over
    depth = 2 + (turn - at.eta) * at.half_cosine / at.half_sine - rise * shift
    versine = at.versine + at.sine * shift + arb(0, (shift * shift / 2).upper())
    return Contact(turn - (at.eta + shift), depth, versine)


def _proved(
    seed: float,
    point: Callable[[arb], Any],
    shift_from: Callable[[Any], arb],
    slope_over: Callable[[Any, arb], arb],
    reach: float,
) -> tuple[Any, arb] | None:
    """Refine the seed, then prove the root next to it: return the point at full precision and the way to the root."""
    if not seed > _SMALLEST_SEED:
        return None
    bits = ctx.prec
    half = bits // 2 + _SPARE_BITS
    x, right = arb(seed), _SEED_BITS
    while right < half:
        right = min(3 * right - 4, half)
        with precision(right + _SPARE_BITS):
            x = (x + shift_from(point(x))).mid()
    with precision(bits + _SPARE_BITS):
        at = point(x)
        # a first guess of the distance: half the bits are right, more where the inputs are wide
        width = (2 * abs(at.value / at.steepness)).upper() + x * arb(2) ** -(bits + _SPARE_BITS)
        for _ in range(3):
            spread = arb(0, width.upper())
            slope = slope_over(at, spread)
            inside = x + spread > 0 and x + spread < reach
            if inside and slope < 0 and spread.contains_interior(shift := -at.value / slope):
                return at, shift
            width = 4 * width
    return None
