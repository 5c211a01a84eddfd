"""Random scenes for the audit: exponents first, every kind of extreme by name. A seed gives the same scenes again."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from random import Random

from numerics.scene import Pair, Scene, State

_PERIODS = Fraction(25, 4)


def decimal(random: Random, low: float, high: float) -> Fraction:
    """Return a positive decimal of four digits, its exponent uniform in [low, high)."""
    exponent = math.floor(random.uniform(low, high))
    return Fraction(random.randint(1000, 9999)) * Fraction(10) ** (exponent - 3)


def signed(random: Random, low: float, high: float) -> Fraction:
    """Return a decimal of either sign."""
    return random.choice((-1, 1)) * decimal(random, low, high)


def rate(pair: Pair) -> Fraction:
    """Return a rational near Omega = sqrt(a2/(m1+m2)), 1/s, to 12 digits: the exact one is irrational."""
    squared = pair.a2 / pair.mass
    shift = 40 + max(0, squared.denominator.bit_length() - squared.numerator.bit_length())
    return Fraction(math.isqrt(squared.numerator * 4**shift // squared.denominator), 2**shift)


def _scene(random: Random, pair: Pair, size: float = 1) -> Scene:
    """Return a scene of some periods whose reduced coordinates are of order 10^+-size."""
    width, speed = pair.half_width, pair.half_width * rate(pair)
    v1, v2 = (signed(random, -size, size) * speed for _ in range(2))
    x1, x2 = (signed(random, -size, size) * width for _ in range(2))
    kind = random.choice(("generic", "generic", "on the surface", "at rest", "edge"))
    if kind == "at rest":
        v1 = v2 = Fraction(0)
    elif kind == "on the surface":
        v2 = v1
    elif kind == "edge":
        x1, v2 = (1 if x1 > 0 else -1) * width, v1
    return Scene(pair, State(x1, v1, x2, v2), _PERIODS * random.randint(1, 4) / rate(pair))


def _pair(random: Random, **given: Fraction) -> Pair:
    parameters = {name: decimal(random, -1, 2) for name in ("m1", "m2", "a2", "b")} | given
    return Pair(**parameters)


def masses(random: Random) -> Scene:
    """Return a scene whose mass ratio is 1e-12 to 1e12."""
    return _scene(random, _pair(random, m1=decimal(random, -6, 6), m2=decimal(random, -6, 6)))


def stiffness(random: Random) -> Scene:
    """Return a scene with a2 from 1e-30 to 1e30 N/m."""
    return _scene(random, _pair(random, a2=decimal(random, -30, 30)))


def friction(random: Random) -> Scene:
    """Return a scene with b from 1e-30 to 1e30 N, and motions up to 100 times the sliding region."""
    return _scene(random, _pair(random, b=decimal(random, -30, 30)), size=2)


def light_driver(random: Random) -> Scene:
    """Return a scene with m1/m2 from 1e-12 to 1e-3: slips through the same ray again and again."""
    return _scene(random, _pair(random, m1=decimal(random, -11, -3)))


def damping(random: Random) -> Scene:
    """Return a scene with a1 from 1e-12 to 1e6 of critical damping, next to the critical cases, or on them exactly."""
    pair = _pair(random)
    kind = random.choice(("any", "any", "near", "nearer", "exact"))
    if kind in {"nearer", "exact"}:
        # a1^2 = 4 a2 m is met by a rational a1 if a2 = k^2 m
        moved, k = random.choice((pair.m1, pair.mass)), decimal(random, -1, 1)
        apart = signed(random, -60, -9) if kind == "nearer" else 0
        return _scene(random, Pair(pair.m1, pair.m2, k * k * moved, pair.b, 2 * k * moved * (1 + apart)))
    critical = 2 * rate(pair) * pair.mass
    if random.random() < 0.5:
        critical = 2 * rate(Pair(pair.m1 / 2, pair.m1 / 2, pair.a2, pair.b)) * pair.m1
    factor = decimal(random, -12, 6) if kind == "any" else 1 + signed(random, -9, -1)
    return _scene(random, Pair(pair.m1, pair.m2, pair.a2, pair.b, critical * factor))


def near_critical(random: Random) -> Scene:
    """Return a pair on an exit ray, or at rest beside it, with energy excess from 1e-300 to 1e-3."""
    pair = _pair(random, m1=decimal(random, -3, 3))
    side, width = random.choice((-1, 1)), pair.half_width
    if random.random() < 0.5:
        at = State(x1=side * width * (1 + decimal(random, -300, -3)))
    else:
        v = side * width * rate(pair) * decimal(random, -150, -2)
        at = State(side * width, v, 0, v)
    return Scene(pair, at, _PERIODS * random.randint(1, 3) / rate(pair))


def long_slip(random: Random) -> Scene:
    """Return a pair whose body 2 is so fast that one slip lasts 1 to 1e9 spring cycles."""
    pair = _pair(random)
    width, speed = pair.half_width, pair.half_width * rate(pair)
    fast = signed(random, 0, 9) * 6 * speed
    lasts = abs(fast) * pair.m2 / pair.b
    at = State(signed(random, -1, 1) * width, signed(random, -1, 1) * speed, 0, fast)
    return Scene(pair, at, 2 * lasts + 1 / rate(pair))


KINDS: dict[str, Callable[[Random], Scene]] = {
    "masses": masses,
    "stiffness": stiffness,
    "friction": friction,
    "light driver": light_driver,
    "damping": damping,
    "near critical": near_critical,
    "long slip": long_slip,
}
