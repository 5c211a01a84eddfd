"""Random scenes for the audit: exponents first, every kind of extreme by name. A seed gives the same scenes again."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import TypeAlias

from numerics.scene import Force, Friction, Pair, Piece, Scene, Sine, State, Weakening
from numerics.scene.plane import PlanePair, PlaneScene

AnyScene: TypeAlias = Scene | PlaneScene
_PERIODS = Fraction(25, 4)


def decimal(random: Random, low: float, high: float) -> Fraction:
    """Return a positive decimal of four digits, its exponent uniform in [low, high)."""
    return Fraction(random.randint(1000, 9999)) * Fraction(10) ** (math.floor(random.uniform(low, high)) - 3)


def signed(random: Random, low: float, high: float) -> Fraction:
    """Return a decimal of either sign."""
    return random.choice((-1, 1)) * decimal(random, low, high)


def rate(stiffness: Fraction, mass: Fraction) -> Fraction:
    """Return a rational near sqrt(stiffness/mass), 1/s: the exact one is irrational."""
    return Fraction(math.sqrt(stiffness / mass))


def _pair(random: Random, **given: Fraction) -> Pair:
    return Pair(**({name: decimal(random, -1, 2) for name in ("m1", "m2", "a2", "b")} | given))


def _scene(random: Random, pair: Pair, size: float = 1) -> Scene:
    """Return a scene of some periods whose reduced coordinates are of order 10^+-size."""
    width, omega = pair.half_width, rate(pair.a2, pair.mass)
    x1, x2 = (signed(random, -size, size) * width for _ in range(2))
    v1, v2 = (signed(random, -size, size) * width * omega for _ in range(2))
    kind = random.choice(("any", "any", "on the surface", "at rest", "edge"))
    if kind == "at rest":
        v1 = v2 = Fraction(0)
    elif kind != "any":
        v2 = v1
    if kind == "edge":
        x1 = (1 if x1 > 0 else -1) * width - pair.a1 * v1 / pair.a2
    return Scene(pair, State(x1, v1, x2, v2), _PERIODS * random.randint(1, 4) / omega)


def damping(random: Random) -> Scene:
    """Return a scene with a1 from 1e-12 to 1e6 of critical damping, next to the critical cases, or on them exactly."""
    pair = _pair(random, m1=decimal(random, random.choice((-6, -1)), 2))
    moved, k = random.choice((pair.m1, pair.mass)), decimal(random, -1, 1)
    # a1^2 = 4 a2 m is met by a rational a1 if a2 = k^2 m
    apart = random.choice((Fraction(0), signed(random, -60, -1)))
    factor = random.choice((1 + apart, decimal(random, -12, 6)))
    return _scene(random, Pair(pair.m1, pair.m2, k * k * moved, pair.b, 2 * k * moved * factor))


def near_critical(random: Random) -> Scene:
    """Return a pair on an exit ray, or at rest beside it, with energy excess from 1e-300 to 1e-3."""
    pair, side = _pair(random, m1=decimal(random, -3, 3)), random.choice((-1, 1))
    width, omega, least = pair.half_width, rate(pair.a2, pair.mass), random.choice((-300, -20, -8))
    at = State(x1=side * width * (1 + decimal(random, least, -3)))
    if random.random() < 0.5:
        v = side * width * omega * decimal(random, least / 2, -2)
        at = State(side * width, v, 0, v)
    return Scene(pair, at, _PERIODS * random.randint(1, 3) / omega)


def long_slip(random: Random) -> Scene:
    """Return a pair whose body 2 is so fast that one slip lasts 1 to 1e9 spring cycles."""
    pair = _pair(random)
    width, omega = pair.half_width, rate(pair.a2, pair.mass)
    fast = signed(random, 0, 9) * 6 * width * omega
    at = State(signed(random, -1, 1) * width, signed(random, -1, 1) * width * omega, 0, fast)
    return Scene(pair, at, 2 * abs(fast) * pair.m2 / pair.b + 1 / omega)


def driven(random: Random, sines: int = 0, friction: bool = False) -> Scene:
    """Return a scene under one to four pieces of force, polynomials and at most so many sines, and b by pieces."""
    scene = damping(random) if random.random() < 0.5 else _scene(random, _pair(random))
    pair, until = scene.pair, scene.until / 4
    held, omegas = pair.a2 * pair.half_width, [rate(pair.a2, mass) for mass in (pair.m1, pair.mass)]
    starts = sorted({Fraction(random.randint(0, 99), 100) * until for _ in range(random.randint(1, 4))})
    pieces = []
    for start in starts:
        powers = [signed(random, -2, 1) * held * omegas[1] ** k for k in range(random.randint(0, 3))]
        waves = [_sine(random, held, random.choice(omegas)) for _ in range(random.randint(min(1, sines), sines))]
        pieces.append(Piece(start, powers, waves))
    jumps = [(start, pair.b * decimal(random, -1, 1)) for start in starts] if friction else []
    at = random.choice((State(), scene.initial))
    return Scene(pair, at, until, force=Force(pieces), friction=Friction(jumps))


def _sine(random: Random, held: Fraction, omega: Fraction) -> Sine:
    """Return a sine at resonance, next to it, or of any frequency."""
    factor = random.choice((Fraction(1), 1 + signed(random, -12, -2), decimal(random, -1, 1)))
    return Sine(signed(random, -1, 1) * held, factor * omega, random.choice((Fraction(0), signed(random, -1, 1))))


def state_friction(random: Random) -> Scene:
    """Return a scene whose friction falls and rises with speed, at knots where it goes, and changes by place."""
    free = random.random() < 0.5
    scene = _scene(random, _pair(random), 0.5) if free else driven(random, sines=1, friction=random.random() < 0.3)
    pair = scene.pair
    width, b = pair.half_width, pair.b
    fast = width * rate(pair.a2, pair.mass)
    knots = sorted({decimal(random, -2, 1) for _ in range(random.randint(0, 3))})
    speed = [(fast * knot, b * Fraction(random.randint(100, 1300), 1000)) for knot in knots]
    slope = random.choice((0, decimal(random, -2, 0) * b / fast))
    places = sorted({signed(random, -1, 1) for _ in range(random.choice((0, 2)))})
    place = [(width * z, b * Fraction(random.randint(0, 600), 1000)) for z in places]
    friction = Friction(scene.friction.pieces, Weakening(speed, slope, place))
    return Scene(pair, scene.initial, scene.until / random.choice((1, 4)), force=scene.force, friction=friction)


def surface(random: Random, shape: str = "ellipsoid") -> PlaneScene:
    """Return a scene on two axes or three: round or not, coupled or not, from anywhere, together, nearly on a line."""
    n, moderate = random.choice((2, 2, 3)), (-1, 1)
    m1, m2, a2, b = ([decimal(random, *moderate) for _ in range(n)] for _ in range(4))
    if random.random() < 0.4:
        m1, m2, a2, b = ([one[0]] * n for one in (m1, m2, a2, b))
    rows = [[a2[i] if i == j else Fraction(0) for j in range(n)] for i in range(n)]
    if random.random() < 0.5:
        rows[0][1] = rows[1][0] = Fraction(random.randint(-9, 9), 10) * Fraction(math.sqrt(a2[0] * a2[1]))
    omega = [rate(a, x + y) for a, x, y in zip(a2, m1, m2, strict=True)]
    held = [f * (x + y) / y for f, x, y in zip(b, m1, m2, strict=True)]
    a1 = random.choice((0, [decimal(random, -2, 0) * a / w for a, w in zip(a2, omega, strict=True)]))

    def start(powers: int, size: float = 0.5) -> list[Fraction]:
        sizes = (h / a * w**powers for h, a, w in zip(held, a2, omega, strict=True))
        return [signed(random, -size, size) * one for one in sizes]

    x1, v1, v2, kind = start(0), start(1), start(1), random.choice(("any", "together", "at rest", "narrow"))
    if kind in {"together", "at rest"}:
        v2 = v1 = v1 if kind == "together" else [Fraction(0)] * n
    elif kind == "narrow":  # near reversals: across the line of motion there is little
        v1, v2 = ([v[0], *(one * decimal(random, -9, -2) for one in v[1:])] for v in (v1, v2))
    force = [Force([Piece(0, [], [_sine(random, h, w)])]) for h, w in zip(held, omega, strict=True)]
    until = _PERIODS * Fraction(random.randint(1, 4), 4) / min(omega)
    pair = PlanePair(m1, m2, rows, b, a1, shape)
    return PlaneScene(pair, until, x1, v1, 0, v2, force if random.random() < 0.5 else ())


KINDS: dict[str, Callable[[Random], AnyScene]] = {
    "masses": lambda random: _scene(random, _pair(random, m1=decimal(random, -6, 6), m2=decimal(random, -6, 6))),
    "stiffness": lambda random: _scene(random, _pair(random, a2=decimal(random, -30, 30))),
    "friction": lambda random: _scene(random, _pair(random, b=decimal(random, -30, 30)), size=2),
    "light driver": lambda random: _scene(random, _pair(random, m1=decimal(random, -11, -3))),
    "damping": damping,
    "near critical": near_critical,
    "long slip": long_slip,
    "force": driven,
    "sines": lambda random: driven(random, sines=3),
    "force and friction": lambda random: driven(random, sines=1, friction=True),
    "friction of the state": state_friction,
    "ellipsoid": surface,
    "box": lambda random: surface(random, "box"),
}
