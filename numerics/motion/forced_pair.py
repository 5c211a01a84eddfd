"""The constants of a pair under a force, in numbers of one arithmetic, from exact rationals."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from numerics.arithmetic.protocol import Arithmetic
from numerics.flows.forced_records import Pair, Swing
from numerics.flows.oscillator import oscillator
from numerics.scene import Law, Scene


def pair_of(scene: Scene, arithmetic: Arithmetic) -> Pair:
    """Return the pair; in the arithmetic's context. Raises OutOfRange."""
    pair, number, sqrt = scene.pair, arithmetic.number, arithmetic.sqrt
    m1, m2, mass, a1, a2 = pair.m1, pair.m2, pair.mass, pair.a1, pair.a2
    load_square = (m2 / mass) ** 2 * (a2 + a1 * a1 / m1)
    swings = (_swing(arithmetic, mass_of_mode, a1, a2) for mass_of_mode in (m1, mass))
    roots = (sqrt(number(one)) for one in (a2, m1, m2, mass / (m1 * m2), load_square))
    given = map(number, (m1, m2, mass, a1, a2))
    return Pair._make((*given, *swings, *roots, scene.law is Law.THREE_VALUED_SGN))


def _swing(arithmetic: Arithmetic, mass: Fraction, a1: Fraction, a2: Fraction) -> Swing:
    """Return the oscillator of one mass; its regime is decided on exact numbers."""
    number, square = arithmetic.number, a1 * a1
    discriminant = 4 * a2 * mass - square
    regime = (discriminant > 0) - (discriminant < 0)
    frequency = arithmetic.sqrt(number(abs(discriminant) / (4 * mass * mass)))
    of: Any = arithmetic.telling(oscillator)(number(a1 / (2 * mass)), number(a2 / mass), regime, frequency)
    rate = 1.0001 * (float(a1 / mass) + math.sqrt(float(a2 / mass)))
    light = 4 * square < discriminant
    short, terms = _series(arithmetic)
    return Swing(number(mass), number(a1), number(a2), of, rate, light, short, terms)


def bits_of(arithmetic: Arithmetic) -> int:
    """Return how many bits a number of an arithmetic has, or a few more."""
    return {"float64": 53, "double-double": 107}.get(arithmetic.name, math.ceil(arithmetic.digits * 3.33) + 16)


def _series(arithmetic: Arithmetic) -> tuple[float, int]:
    """Return up to what argument power series are used, and of how many terms: up to 1 where digits are few.

    With more of them closed forms are quicker, and what little cancels there is added to the working digits.
    """
    bits = bits_of(arithmetic)
    short = 1.0 if bits < 120 else 1 / 16
    terms, size = 2, 0.0
    while size < bits + 8:
        terms += 1
        size += math.log2(terms / short)
    return short, terms
