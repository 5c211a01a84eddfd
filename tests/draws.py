"""Random scenes, magnitudes drawn by their exponent, every kind of extreme by name."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import Any, TypeAlias

import numpy as np
from numpy.polynomial.polynomial import polyadd, polyder, polyint, polyval

from numerics.scene import Force, Friction, Law, Pair, Piece, Scene, Signal, Sine, State, Weakening
from numerics.scene.plane import PlanePair, PlaneScene

Range: TypeAlias = tuple[int, int]
"""The least and the largest exponent of ten, or whole number."""
_PERIOD = Fraction(25, 4)
"""Nearly 2 pi: no event falls on it."""


def decimal(random: Random, low: int, high: int, digits: int = 4) -> Fraction:
    """Return a positive decimal of at most so many digits, the first of them at 10^low to 10^high."""
    number = random.randint(1, 10**digits - 1)
    return number * Fraction(10) ** (random.randint(low, high) - len(str(number)) + 1)


def signed(random: Random, low: int, high: int) -> Fraction:
    """Return a decimal of either sign."""
    return random.choice((-1, 1)) * decimal(random, low, high)


def rate(stiffness: Fraction, mass: Fraction) -> Fraction:
    """Return a rational near sqrt(stiffness/mass), 1/s: the exact one is irrational."""
    return Fraction(math.sqrt(stiffness / mass))


def units(of: Pair) -> tuple[Fraction, Fraction]:
    """Return L and L Omega of a pair, m and m/s."""
    return of.half_width, of.half_width * rate(of.a2, of.mass)


def pair(
    random: Random,
    exponents: Range = (-2, 2),
    damped: bool | None = False,
    damping: Range = (-12, 6),
    ratios: Range | None = None,
    **given: Fraction,
) -> Pair:
    """Return a pair, perhaps with m2/m1 within its range.

    A damper has 1e-12 to 1e6 of the critical one, is next to it or exactly it; None: with or without.
    """
    numbers = {name: decimal(random, *exponents) for name in ("m1", "m2", "a2", "b")} | given
    if ratios:
        numbers["m2"] = numbers["m1"] * decimal(random, *ratios)
    if not (random.choice((False, True)) if damped is None else damped):
        return Pair(**numbers)
    moved = numbers["m1"] + random.choice((0, 1)) * numbers["m2"]
    k = rate(numbers["a2"], moved)
    if random.choice((False, True)) and "a2" not in given:  # a1^2 = 4 a2 m is met by a rational a1 if a2 = k^2 m
        k = decimal(random, -1, 1)
        numbers["a2"] = k * k * moved
    factor = random.choice((Fraction(1), 1 + signed(random, -60, -1), decimal(random, *damping)))
    return Pair(**numbers, a1=2 * k * moved * factor)


def state(random: Random, of: Pair, size: Range = (-1, 0), u: Any = 0) -> State:
    """Return a state in units of a pair: any, on S, at rest, on the edge of S under a force u, in a slip from there."""
    width, speed = units(of)
    x1, v1, x2, v2 = (random.choice((0, 1, 1)) * signed(random, *size) * one for one in (width, speed) * 2)
    kind = random.choice(("any", "on S", "at rest", "on the edge", "from the edge"))
    if kind == "at rest":
        v1 = v2 = Fraction(0)
    elif kind.startswith("on"):
        v2 = v1
    if kind.endswith("edge"):
        x1 = random.choice((-1, 1)) * width + (u - of.a1 * v1) / of.a2
    return State(x1, v1, x2, v2)


def scene(
    random: Random,
    exponents: Range = (-2, 2),
    damped: bool | None = False,
    size: Range = (-1, 0),
    periods: Range = (1, 4),
    law: Law = Law.FILIPPOV,
    **given: Any,
) -> Scene:
    """Return a scene of some periods of the stuck pair whose reduced coordinates have exponents within a size."""
    of = pair(random, exponents, damped, **given)
    return Scene(of, state(random, of, size), _PERIOD * random.randint(*periods) / rate(of.a2, of.mass), law)


def near_critical(random: Random, decades: Range = (3, 300), damped: bool | None = False, **given: Any) -> Scene:
    """Return a pair that leaves S, or at rest beside it, with an energy excess of 10^-n, n within the decades."""
    of, (few, many) = pair(random, damped=damped, **given), decades
    (width, speed), side = units(of), random.choice((-1, 1))
    v = side * speed * decimal(random, -many // 2, -few // 2)
    beside = State(x1=side * width * (1 + decimal(random, -many, -few)))
    at = random.choice((State(side * width, v, 0, v), beside))
    return Scene(of, at, _PERIOD * random.randint(1, 3) * width / speed)


def long_slip(random: Random, damped: bool | None = False, turns: Range = (0, 3)) -> Scene:
    """Return a pair whose body 2 is so fast that one slip lasts many spring cycles, exponents within the turns."""
    of = pair(random, damped=damped)
    width, speed = units(of)
    x1, v1, fast = signed(random, -1, 0), signed(random, -1, 0), signed(random, *turns) * 6 * speed
    return Scene(of, State(x1 * width, v1 * speed, 0, fast), 2 * abs(fast) * of.m2 / of.b + width / speed)


def root(square: Fraction) -> Fraction:
    """Return a rational within a part in 10^30 of the square root of a positive one."""
    places = Fraction(10) ** (30 + max(0, len(str(square.denominator)) - len(str(square.numerator))))
    return Fraction(math.isqrt(math.floor(square * places**2))) / places


def of_energy(
    random: Random, decades: Range, below: bool = False, on_surface: bool = False, ratios: Range = (-4, 4)
) -> Scene:
    """Return a pair with an energy of E_cr (1 + w), to a part in 10^30, on S, in S0 or outside it, and perhaps off S.

    w is above 0, or perhaps below it and above -1, by its exponent.
    """
    of, w = pair(random, (-9, 9), ratios=ratios), decimal(random, *decades)
    if below and random.choice((True, False)):
        w = -decimal(random, decades[0], -1)
    width, unit = units(of)
    x1, v1, v2 = (signed(random, -3, 0) * one for one in (random.choice((width, 100 * width)), unit, unit))
    v2 = v1 if on_surface else random.choice((v1, v2))
    factor = root(of.critical_energy * (1 + w) / Scene(of, State(x1, v1, 0, v2), 1).energy)
    return Scene(of, State(*(factor * one for one in (x1, v1, 0, v2))), 1)


def sine(random: Random, held: Fraction, omega: Fraction) -> Sine:
    """Return a sine at resonance, next to it, or of any frequency."""
    factor = random.choice((Fraction(1), 1 + signed(random, -12, -2), decimal(random, -1, 0)))
    return Sine(signed(random, -1, 0) * held, factor * omega, random.choice((0, 1)) * signed(random, -1, 0))


def starts(random: Random, until: Fraction) -> list[Fraction]:
    """Return when up to four pieces begin, s."""
    return sorted({Fraction(random.randint(0, 99), 100) * until for _ in range(random.randint(0, 4))})


def force(random: Random, held: Fraction, omega: Fraction, until: Fraction, sines: int = 2) -> Force:
    """Return a force by pieces, of polynomials and so many sines, in units of what friction holds and of a rate."""
    return Force(
        Piece(
            start,
            [signed(random, -2, 0) * held * omega**k for k in range(random.randint(0, 3))],
            [sine(random, held, omega) for _ in range(random.randint(0, sines))],
        )
        for start in starts(random, until)
    )


def friction(random: Random, b: Fraction, until: Fraction) -> Friction:
    """Return a friction by pieces, in units of b."""
    return Friction([(start, b * decimal(random, -1, 0)) for start in starts(random, until)])


def driven(random: Random, sines: int = 2, by_pieces: bool = True, **more: Any) -> Scene:
    """Return a scene under a force of the pair's own size and speed, perhaps with b by pieces."""
    of = pair(random, **({"damped": None} | more))
    omega, held = rate(of.a2, random.choice((of.m1, of.mass))), of.a2 * of.half_width
    until = _PERIOD * random.randint(1, 4) / 4 / rate(of.a2, of.mass)
    push = force(random, held, omega, until, sines)
    at = random.choice((State(), state(random, of, u=u if isinstance(u := push(0), Fraction) else 0)))
    return Scene(of, at, until, force=push, friction=friction(random, of.b, until) if by_pieces else Friction())


def weakened(random: Random, **more: Any) -> Scene:
    """Return a scene whose friction falls and rises with speed, at knots where it goes, and changes by place."""
    given = driven(random, 1, **more)
    of, b = given.pair, given.pair.b
    width, fast = units(of)
    knots = sorted({decimal(random, -2, 0) for _ in range(random.randint(0, 3))})
    places = sorted({signed(random, -1, 0) for _ in range(random.choice((0, 2)))})
    table = Weakening(
        [(fast * knot, b * Fraction(random.randint(100, 1300), 1000)) for knot in knots],
        random.choice((0, 1)) * decimal(random, -2, -1) * b / fast,
        [(width * z, b * Fraction(random.randint(0, 600), 1000)) for z in places],
    )
    pushed, pieces = random.choice(((Force(), ()), (given.force, given.friction.steps)))
    return given.replace(force=pushed, friction=Friction(pieces, table))


def varying(random: Random, b: Fraction, omega: Fraction, until: Fraction) -> Friction:
    """Return a friction that varies within its pieces, in units of b and of a rate: never below 0, perhaps at it."""
    begin, pieces = starts(random, until), []
    for start, end in zip(begin, [*begin[1:], until], strict=False):
        low, high = (random.choice((0, 1)) * b * decimal(random, -1, 0) for _ in range(2))
        part = Fraction(random.randint(0, 4), 4)
        straight = low, (high - low) / (end - start)
        waving = [low], [Sine(part * low, omega, signed(random, -1, 0)), Sine((1 - part) * low, 3 * omega)]
        pieces.append(random.choice((Piece(start, straight), Piece(start, *waving), Piece(start, [high]))))
    return Friction(pieces)


def brought(random: Random, **more: Any) -> Scene:
    """Return a scene of what people bring.

    No spring, no contact, the ground or a belt, b_static, b(t), a push of body 2, a wall that moves.
    """
    given = driven(random, 1, **more)
    of, until, omega, at = given.pair, given.until, rate(given.pair.a2, given.pair.m1), given.initial
    is_fixed, lies = random.choice((True, False)), random.choice((True, True, False))
    b, spring = lies * of.b, random.choice((0, 1, 1)) * of.a2
    b_static = random.choice((None, b * Fraction(random.randint(10, 20), 10))) if lies else None
    pair = Pair(of.m1, "inf" if is_fixed else of.m2, spring, b, of.a1, b_static)
    sizes = {"belt": of.half_width * omega} if is_fixed else {"force_2": of.b}
    sizes |= {} if pair.a1 else {"wall": of.half_width}
    signals = {name: force(random, size, omega, until) for name, size in sizes.items()}
    chosen = {name: random.choice((Signal(), signal, signal)) for name, signal in signals.items()}
    b_of_t = random.choice((given.friction, varying(random, of.b, omega, until)))
    start = State(at.x1, at.v1, at.x2, 0 if is_fixed else at.v2)
    return Scene(pair, start, until, force=given.force, friction=b_of_t, **chosen)


def _polynomial(coefficients: Any) -> Any:
    return np.array([Fraction(one) for one in coefficients], object)


def _slipped(random: Random, gap: Fraction, unit: Fraction, length: Fraction) -> Any:
    """|v1 - v2| as a polynomial of t, from a gap to 0 at the length: of any order there, and at the start from 0.

    Perhaps it touches 0 in between.
    """
    w = _polynomial([gap] if gap else [0] * random.randint(1, 3) + [unit * decimal(random, -1, 0)])
    for at in random.choice([[1], [1], [1, 1, 1], [Fraction(1, 2)] * 2 + [1]]):
        w = np.convolve(w, _polynomial([1, -1 / (at * length)]))
    return w


def _needed(random: Random, length: Fraction) -> Any:
    """What part of b a stick needs, a polynomial of t up to the length: within, on the edge, up to it, touching it."""
    part, side = decimal(random, -1, -1), random.choice([-1, 1])
    kinds = [part], [1], [part, (1 - part) / length], [1 - part, 4 * part / length, -4 * part / length**2]
    return side * _polynomial(random.choice(kinds))


def _push(of: Pair, moved: Fraction, v_1: Any, x1: Fraction, friction: Fraction) -> Any:
    """The force on body 1 under which a mass moves at a speed from a place on, against friction."""
    u = polyadd(polyadd(of.a2 * polyint(v_1, k=[x1]), of.a1 * v_1), moved * polyder(v_1))
    return polyadd(u, _polynomial([friction]))


def tie(random: Random) -> Scene:
    """A scene whose contacts, touches, exits and jumps of u and b fall on rational times, and on each other.

    Chosen are the motions, v1 - v2 of a slip and x1'' of a stick, polynomials of time; the force follows from them.
    After the last tie u goes on as it is, or as anything.
    """
    of = pair(random, (-1, 1), damped=None)
    unit = Fraction(10) ** round(math.log10(math.sqrt(of.mass / of.a2)))
    speed, b, t = of.b / of.m2 * unit, of.b, Fraction(0)
    x1, v2 = (random.choice([0, 1]) * signed(random, -1, 0) * one for one in (speed * unit, speed))
    side = random.choice([-1, 0, 1])
    gap = abs(side) * random.choice([0, 1]) * decimal(random, -1, 0) * speed
    begun, pieces, frictions = State(x1, v2 + side * gap, 0, v2), [], []
    for _ in range(random.randint(1, 3)):
        length = Fraction(random.randint(1, 20), 10) * unit
        if side:
            v_2 = _polynomial([v2, side * b / of.m2])
            v_1 = polyadd(v_2, side * _slipped(random, gap, speed / unit, length))
        else:
            v_1 = v_2 = polyint(b / of.m2 * _needed(random, length), k=[v2])
        pieces.append(Piece(t, _push(of, of.m1 if side else of.mass, v_1, x1, side * b)))
        x1, v2 = polyval(length, polyint(v_1, k=[x1])), polyval(length, v_2)
        t, side, gap = t + length, random.choice([-1, 0, 1]), Fraction(0)
        if random.choice([True, False]):
            b = decimal(random, -1, 0) * of.b
            frictions.append((t, b))
    if random.choice([True, False]):
        pieces += [Piece(t, [signed(random, 0, 1) * of.b], [sine(random, 3 * of.b, 1 / unit)])]
    until = t + random.choice([Fraction(1, 3), 3]) * unit
    return Scene(of, begun, until, force=Force(pieces), friction=Friction(frictions))


def graze(random: Random) -> Scene:
    """A slip whose v1 - v2 = c (t - t0)^2 + e has a least value e of any size and sign; with a spring or damper or not.

    The force follows from that motion; body 2 is held at rest by its own, but where it is the ground.
    """
    m1, c, t0 = (decimal(random, -1, 0, 2) for _ in range(3))
    m2: Any = random.choice([decimal(random, -1, 0), "inf"])
    of = Pair(m1, m2, *(random.choice([0, decimal(random, -2, 1)]) for _ in range(3)))
    v_1 = _polynomial([c * t0 * t0 + signed(random, -20, -8) * random.choice([0, 1, 1]), -2 * c * t0, c])
    held = {} if m2 == "inf" or not of.b else {"force_2": Force.constant(-of.b)}
    push = Force([Piece(0, _push(of, m1, v_1, Fraction(0), of.b))])
    return Scene(of, State(0, v_1[0]), 2 * t0, force=push, **held)


def surface(random: Random, shape: str = "ellipsoid", exponents: Range = (-1, 0), narrow: bool = True) -> PlaneScene:
    """Return a scene on two axes or three: round or not, coupled or not, from anywhere, together, nearly on a line."""
    n = random.choice((2, 2, 3))
    m1, m2, a2, b = (np.array([decimal(random, *exponents) for _ in range(n)]) for _ in range(4))
    if random.choice((False, False, True)):
        m1, m2, a2, b = (np.full(n, one[0]) for one in (m1, m2, a2, b))
    springs, held = np.diag(a2), b * (m1 + m2) / m2
    springs[0, 1] = springs[1, 0] = random.randint(-9, 9) * Fraction(math.sqrt(a2[0] * a2[1])) / 10
    omega = np.array([*map(rate, a2, m1 + m2)])
    a1 = random.choice((0, 1)) * np.array([decimal(random, -2, -1) for _ in range(n)]) * a2 / omega

    def drawn(unit: Any) -> Any:
        return np.array([signed(random, -1, 0) for _ in range(n)]) * unit

    x1, v1, v2 = drawn(held / a2), drawn(held / a2 * omega), drawn(held / a2 * omega)
    kind = random.choice(("any", "together", "at rest", "narrow")[: 3 + narrow])
    if kind == "narrow":  # near reversals: across the line of motion there is little
        v1[1:], v2[1:] = (one[1:] * decimal(random, -9, -3) for one in (v1, v2))
    elif kind != "any":
        v2 = v1 = v1 * (kind == "together")
    push = [Force([Piece(0, [], [sine(random, h, w)])]) for h, w in zip(held, omega, strict=True)]
    until = _PERIOD * random.randint(1, 4) / 4 / min(omega)
    of = PlanePair(m1, m2, springs, b, a1, shape)
    return PlaneScene(of, until, x1, v1, 0, v2, random.choice(((), push)))


MAGNITUDES = {"m1": (-11, 5), "m2": (-6, 5), "a2": (-30, 29), "b": (-30, 29)}
KINDS: dict[str, Callable[[Random], Scene | PlaneScene]] = {
    name: lambda random, name=name: scene(random, size=(-2, 1), **{name: decimal(random, *MAGNITUDES[name])})
    for name in MAGNITUDES
} | {
    "damping": lambda random: scene(random, damped=True, m1=decimal(random, random.choice((-6, -1)), 1)),
    "near critical": lambda random: near_critical(random, (3, random.choice((8, 20, 300))), m1=decimal(random, -3, 2)),
    "long slip": lambda random: long_slip(random, turns=(0, 8)),
    "sines": lambda random: driven(random, 3, False),
    "force and friction": lambda random: driven(random, 1),
    "ties": tie,
    "friction of the state": weakened,
    "ellipsoid": surface,
    "box": lambda random: surface(random, "box"),
}
