"""Random scenes by kind, drawn from a seed as exact rationals; nothing of the package is used.

A scene is a list: [m1, m2, a2, b, a1], [x1, v1, x2, v2], until, law, pieces of force (start, coefficients, sines as
[amplitude, omega, phase]), pieces of friction (start, b); every number a decimal, or a ratio, as text.
"""

import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from random import Random
from typing import Any

SGN = "three-valued-sgn"
Numbers = tuple[Fraction, Fraction, Fraction, Fraction, Fraction]
"""m1, m2, a2, b, a1"""


def text(value: Fraction) -> str:
    """A rational as decimal text where it has one that is short, else as a ratio."""
    below = value.denominator
    while below % 10 == 0:
        below //= 10
    for prime in (2, 5):
        while below % prime == 0:
            below //= prime
    if below != 1:
        return f"{value.numerator}/{value.denominator}"
    places = 0
    while (value * 10**places).denominator != 1:
        places += 1
    whole = (value * 10**places).numerator
    while whole and whole % 10 == 0:
        whole, places = whole // 10, places - 1
    sign, digits, exponent = Decimal(whole).as_tuple()
    return str(Decimal((sign, digits, int(exponent) - places)))


class Draw:
    """Numbers by magnitude, and the pair's own units."""

    def __init__(self, seed: str) -> None:
        self.random = Random(seed)

    def decimal(self, low: float, high: float, digits: int = 3) -> Fraction:
        """A positive decimal of a few digits, its logarithm uniform in low .. high."""
        return rounded(10 ** self.random.uniform(low, high), digits)

    def signed(self, low: float, high: float, digits: int = 3) -> Fraction:
        return self.side() * self.decimal(low, high, digits)

    def side(self) -> int:
        return self.random.choice([-1, 1])

    def pair(self, spread: float = 1, damping: Fraction | str | None = None) -> Numbers:
        """A pair of magnitudes 10^-spread .. 10^spread; damping is a ratio a1 / (2 sqrt(a2 M))."""
        m1, m2, a2, b = (self.decimal(-spread, spread) for _ in range(4))
        zeta = Fraction(0) if damping is None else Fraction(damping)
        rate = root(a2 / (m1 + m2))
        return m1, m2, a2, b, rounded(float(2 * zeta * (m1 + m2) * rate), 4)

    def rational_pair(self, spread: float = 1, slip: bool = False) -> Numbers:
        """A pair whose stick rate sqrt(a2/M) (slip: sqrt(a2/m1)) is a decimal, and whose half width is one."""
        m1, m2 = (self.decimal(-spread, spread, 2) for _ in range(2))
        rate, width = self.decimal(-spread, spread, 2), self.decimal(-spread, spread, 2)
        a2 = rate**2 * (m1 if slip else m1 + m2)
        return m1, m2, a2, a2 * m2 * width / (m1 + m2), Fraction(0)


def rounded(value: float, digits: int) -> Fraction:
    return Fraction(f"{value:.{digits - 1}e}")


def root(value: Fraction) -> Fraction:
    """A square root to ten digits."""
    shift = 34 + max(0, value.denominator.bit_length() - value.numerator.bit_length())
    found = Fraction(math.isqrt(value.numerator * 4**shift // value.denominator), 2**shift)
    return Fraction(f"{Decimal(found.numerator) / Decimal(found.denominator):.9e}")


def width_of(pair: Numbers) -> Fraction:
    m1, m2, a2, b, _ = pair
    return b * (m1 + m2) / (a2 * m2)


def rate_of(pair: Numbers) -> Fraction:
    return root(pair[2] / (pair[0] + pair[1]))


def speed_of(pair: Numbers) -> Fraction:
    return rounded(float(width_of(pair) * rate_of(pair)), 9)


def until_of(pair: Numbers, periods: float) -> Fraction:
    return rounded(2 * math.pi * periods / float(rate_of(pair)), 7)


def scene(
    pair: Numbers,
    state: tuple[Fraction | int, Fraction | int, Fraction | int, Fraction | int],
    until: Fraction,
    law: str = "filippov",
    force: Any = (),
    friction: Any = (),
) -> list[Any]:
    def written(value: Any) -> Any:
        return [written(one) for one in value] if isinstance(value, list | tuple) else text(Fraction(value))

    return [written(pair), written(state), text(until), law, written(force), written(friction)]


def generic(draw: Draw, pair: Numbers, size: tuple[float, float] = (-0.7, 1.1), law: str = "") -> tuple[Fraction, ...]:
    """A state in units of the pair: any, at rest, or with v1 = v2; in slip where the law would hold it for ever."""
    width, speed = width_of(pair), speed_of(pair)
    x, y = (rounded(float(width * draw.signed(*size)), 6) for _ in range(2))
    v, w = (rounded(float(speed * draw.signed(*size)), 6) for _ in range(2))
    kind = draw.random.choice(["any", "any", "any", "one at rest", *(["rest", "together"] if law != SGN else [])])
    if kind == "rest":
        return x, Fraction(0), y, Fraction(0)
    if kind == "together":
        return x, v, y, v
    return (x, v, y, Fraction(0)) if kind == "one at rest" else (x, v, y, w)


def free(draw: Draw, law: str = "filippov") -> list[Any]:
    pair = draw.pair(draw.random.choice([1, 2]))
    return scene(pair, generic(draw, pair, law=law), until_of(pair, draw.random.uniform(0.3, 3)), law)


def free_magnitudes(draw: Draw) -> list[Any]:
    pair = draw.pair(12)
    until = min(until_of(pair, draw.random.uniform(0.3, 2)), 10**6 * width_of(pair) / speed_of(pair))
    return scene(pair, generic(draw, pair), until)


def free_far(draw: Draw) -> list[Any]:
    pair = draw.pair(1)
    return scene(pair, generic(draw, pair, (1, 3)), until_of(pair, draw.random.uniform(1, 6)))


def free_edge(draw: Draw) -> list[Any]:
    """v1 = v2 on the edge, or a little within or beyond it, moving outwards, inwards or not at all."""
    pair = draw.rational_pair()
    off = draw.random.choice([0, 0, draw.signed(-30, -1, 1)])
    x = draw.side() * width_of(pair) * (1 + off)
    v = draw.random.choice([Fraction(0), rounded(float(speed_of(pair) * draw.signed(-6, 0)), 3)])
    return scene(pair, (x, v, draw.signed(-1, 1), v), until_of(pair, draw.random.uniform(0.3, 2)))


def free_critical(draw: Draw) -> list[Any]:
    """v1 = v2 with E = E_cr exactly (3, 4, 5), or E/E_cr - 1 = +-10^-1 .. 10^-30."""
    pair = draw.rational_pair()
    width, rate = width_of(pair), rate_of(pair)
    excess = draw.random.choice([Fraction(0), draw.signed(-30, -1, 1)])
    leg, other = draw.random.choice([("3/5", "4/5"), ("5/13", "12/13"), ("20/29", "21/29"), ("0", "1"), ("4/5", "3/5")])
    x = draw.side() * width * Fraction(leg) * (1 + excess / 2)
    v = draw.side() * width * rate * Fraction(other) * (1 + excess / 2)
    return scene(pair, (x, v, 0, v), until_of(pair, draw.random.uniform(1, 3)))


def free_creeping(draw: Draw) -> list[Any]:
    """On the edge, outwards, with a little more energy than critical: short slips for ever."""
    pair, side = draw.rational_pair(), draw.side()
    v = rounded(float(side * speed_of(pair) * draw.decimal(-5, -0.5)), 3)
    return scene(pair, (side * width_of(pair), v, 0, v), until_of(pair, draw.random.uniform(2, 7)))


def damped(draw: Draw, low: float, high: float, law: str = "filippov") -> list[Any]:
    pair = draw.pair(draw.random.choice([1, 2]), draw.decimal(low, high))
    return scene(pair, generic(draw, pair, law=law), until_of(pair, draw.random.uniform(0.3, 3)), law)


def damped_critical(draw: Draw) -> list[Any]:
    """a1^2 = 4 a2 m, m = m1 + m2 or m1, exactly or nearly."""
    slip = draw.random.choice([False, True])
    m1, m2, a2, b, _ = draw.rational_pair(slip=slip)
    mass = m1 if slip else m1 + m2
    off = draw.random.choice([Fraction(0), draw.signed(-25, -1, 1)])
    pair = m1, m2, a2, b, 2 * mass * root(a2 / mass) * (1 + off)
    return scene(pair, generic(draw, pair), until_of(pair, draw.random.uniform(0.3, 3)))


def damped_stiff(draw: Draw) -> list[Any]:
    """a1/m1 far above the other rates: a light body 1."""
    m2, a2, b = (draw.decimal(-1, 1) for _ in range(3))
    m1 = rounded(float(m2 * draw.decimal(-7, -2)), 3)
    pair = m1, m2, a2, b, rounded(float(root(a2 * m2) * draw.decimal(-2, 1)), 3)
    return scene(pair, generic(draw, pair), until_of(pair, draw.random.uniform(0.3, 3)))


def damped_edge(draw: Draw) -> list[Any]:
    """v1 = v2, |a2 x1 + a1 v1| = b M/m2 exactly or nearly."""
    m1, m2, a2, b, _ = draw.rational_pair()
    a1 = draw.decimal(-2, 1) * (m1 + m2) * rate_of((m1, m2, a2, b, Fraction(0)))
    pair, side = (m1, m2, a2, b, a1), draw.side()
    v = draw.random.choice([Fraction(0), rounded(float(speed_of(pair) * draw.signed(-3, 0.5)), 3)])
    off = draw.random.choice([0, 0, draw.signed(-25, -1, 1)])
    return scene(
        pair, (side * width_of(pair) * (1 + off) - a1 * v / a2, v, 0, v), until_of(pair, draw.random.uniform(0.3, 2))
    )


def driven_pair(draw: Draw) -> Numbers:
    zeta = draw.random.choice([None, Fraction(1, 20), draw.decimal(-3, 1), 1, draw.decimal(1, 3)])
    return draw.pair(1, zeta)


def driven_start(draw: Draw, pair: Numbers, law: str = "") -> tuple[Any, ...]:
    return (0, 0, 0, 0) if law != SGN and draw.random.random() < 0.5 else generic(draw, pair, (-1, 0.5), law)


def held_of(pair: Numbers) -> Fraction:
    """The load that friction holds, b M/m2."""
    return pair[2] * width_of(pair)


def sine(draw: Draw, pair: Numbers, size: tuple[float, float] = (-0.7, 0.7)) -> list[Fraction]:
    amplitude = rounded(float(held_of(pair) * draw.signed(*size)), 3)
    omega = rounded(float(rate_of(pair) * draw.decimal(-0.7, 1)), 3)
    return [amplitude, omega, draw.random.choice([Fraction(0), draw.signed(-1, 0.5, 2)])]


def polynomial(draw: Draw, pair: Numbers, degree: int) -> list[Fraction]:
    held, rate = float(held_of(pair)), float(rate_of(pair))
    return [rounded(held * rate**k * float(draw.signed(-1, 0.5)) / math.factorial(k), 3) for k in range(degree + 1)]


def driven(draw: Draw, force: Callable[[Draw, Numbers, Fraction], list[Any]], law: str = "filippov") -> list[Any]:
    pair = driven_pair(draw)
    until = until_of(pair, draw.random.uniform(0.5, 3))
    return scene(pair, driven_start(draw, pair, law), until, law, force(draw, pair, until))


def moments(draw: Draw, until: Fraction, count: int) -> list[Fraction]:
    return sorted({rounded(float(until) * draw.random.uniform(0.02, 0.98), 4) for _ in range(count)})


def constants(draw: Draw, pair: Numbers, _: Fraction) -> list[Any]:
    return [[0, polynomial(draw, pair, 0), []]]


def steps(draw: Draw, pair: Numbers, until: Fraction) -> list[Any]:
    return [[at, polynomial(draw, pair, 0), []] for at in moments(draw, until, draw.random.randint(1, 5))]


def ramps(draw: Draw, pair: Numbers, until: Fraction) -> list[Any]:
    one, two = moments(draw, until, 2) if draw.random.random() < 0.7 else (Fraction(0), until / 3)
    top = rounded(float(held_of(pair) * draw.signed(-0.2, 0.6)), 3)
    return [[one, [0, top / (two - one)], []], [two, [top], []]]


def polynomials(draw: Draw, pair: Numbers, _: Fraction) -> list[Any]:
    return [[0, polynomial(draw, pair, draw.random.randint(1, 6)), []]]


def one_sine(draw: Draw, pair: Numbers, _: Fraction) -> list[Any]:
    return [[0, [], [sine(draw, pair)]]]


def some_sines(draw: Draw, pair: Numbers, _: Fraction) -> list[Any]:
    sines = [sine(draw, pair) for _ in range(draw.random.randint(2, 3))]
    return [[0, polynomial(draw, pair, 0) if draw.random.random() < 0.3 else [], sines]]


def trapezoids(draw: Draw, pair: Numbers, until: Fraction) -> list[Any]:
    found: list[Any] = []
    at = Fraction(0)
    while at < until and len(found) < 9:
        rise, hold = (rounded(float(until) * draw.random.uniform(0.02, 0.15), 3) for _ in range(2))
        top = rounded(float(held_of(pair) * draw.signed(-0.2, 0.5)), 3)
        slope = top / rise
        found += [[at, [0, slope], []], [at + rise, [top], []], [at + rise + hold, [top, -slope], []]]
        at += 2 * rise + hold
    return [*found, [at, [], []]]


def pieces(draw: Draw, pair: Numbers, until: Fraction) -> list[Any]:
    found = []
    for at in [Fraction(0), *moments(draw, until, draw.random.randint(1, 5))]:
        powers = polynomial(draw, pair, draw.random.randint(0, 2)) if draw.random.random() < 0.6 else []
        found.append([at, powers, [sine(draw, pair) for _ in range(draw.random.randint(0, 2))]])
    return found


def resonance(draw: Draw) -> list[Any]:
    """A sine whose frequency is that of stick or of slip, exactly or nearly, with or without a little damping."""
    slip = draw.random.choice([False, True])
    m1, m2, a2, b, a1 = draw.rational_pair(slip=slip)
    omega = root(a2 / (m1 if slip else m1 + m2))
    if draw.random.random() < 0.4:
        omega *= 1 + draw.signed(-15, -2, 1)
    if draw.random.random() < 0.3:
        a1 = rounded(float((m1 + m2) * omega * draw.decimal(-6, -2)), 2)
    pair = m1, m2, a2, b, a1
    amplitude = rounded(float(held_of(pair) * draw.signed(-0.7, 0.3)), 3)
    force = [[0, [], [[amplitude, omega, draw.random.choice([Fraction(0), Fraction(1, 2)])]]]]
    return scene(pair, driven_start(draw, pair), until_of(pair, draw.random.uniform(1, 3)), "filippov", force)


def frictions(draw: Draw, law: str = "filippov") -> list[Any]:
    """b that jumps a few times, with or without a force."""
    pair = driven_pair(draw)
    until = until_of(pair, draw.random.uniform(0.5, 3))
    jumps = [
        [at, rounded(float(pair[3] * draw.decimal(-0.7, 0.7)), 3)]
        for at in moments(draw, until, draw.random.randint(1, 4))
    ]
    force = draw.random.choice([None, one_sine, steps, pieces])
    acts = force(draw, pair, until) if force else []
    return scene(pair, driven_start(draw, pair, law), until, law, acts, jumps)


def tied(draw: Draw) -> list[Any]:
    """A load of exactly b under the force at t = 0, moving or at rest; decided by derivatives of the force."""
    m1, m2, a2, b, _ = draw.rational_pair()
    a1 = draw.random.choice([Fraction(0), draw.decimal(-2, 0) * (m1 + m2) * rate_of((m1, m2, a2, b, Fraction(0)))])
    pair, side = (m1, m2, a2, b, a1), draw.side()
    until = until_of(pair, draw.random.uniform(0.5, 2))
    powers = polynomial(draw, pair, draw.random.randint(0, 3))
    if len(powers) > 2 and draw.random.random() < 0.5:
        powers[1] = Fraction(0)
    v = draw.random.choice([Fraction(0), rounded(float(speed_of(pair) * draw.signed(-2, 0)), 2)])
    x = (powers[0] - side * held_of(pair) - a1 * v) / a2
    force = [[0, powers, []], [rounded(float(until) * 0.6, 3), polynomial(draw, pair, 1), []]]
    return scene(pair, (x, v, 0, v), until, "filippov", force)


KINDS: dict[str, tuple[int, Callable[[Draw], list[Any]]]] = {
    "free": (340, free),
    "free-magnitudes": (200, free_magnitudes),
    "free-far": (100, free_far),
    "free-edge": (150, free_edge),
    "free-critical": (120, free_critical),
    "free-creeping": (80, free_creeping),
    "free-sgn": (110, lambda draw: free(draw, SGN)),
    "damped-light": (160, lambda draw: damped(draw, -4, -0.3)),
    "damped-critical": (160, damped_critical),
    "damped-heavy": (130, lambda draw: damped(draw, 0.05, 4)),
    "damped-stiff": (150, damped_stiff),
    "damped-edge": (110, damped_edge),
    "damped-sgn": (80, lambda draw: damped(draw, -2, 1, SGN)),
    "forced-constant": (60, lambda draw: driven(draw, constants)),
    "forced-steps": (90, lambda draw: driven(draw, steps)),
    "forced-ramps": (70, lambda draw: driven(draw, ramps)),
    "forced-polynomial": (100, lambda draw: driven(draw, polynomials)),
    "forced-sine": (180, lambda draw: driven(draw, one_sine)),
    "forced-sines": (140, lambda draw: driven(draw, some_sines)),
    "forced-trapezoids": (60, lambda draw: driven(draw, trapezoids)),
    "forced-pieces": (120, lambda draw: driven(draw, pieces)),
    "forced-resonance": (110, resonance),
    "forced-friction": (140, frictions),
    "forced-friction-sgn": (30, lambda draw: frictions(draw, SGN)),
    "forced-tied": (100, tied),
    "forced-sgn": (70, lambda draw: driven(draw, pieces, SGN)),
}
"""How many scenes of each kind are frozen, and how one is drawn."""


def drawn(kind: str, number: int) -> list[Any]:
    """Scene `number` of a kind; the same for ever."""
    return KINDS[kind][1](Draw(f"{kind} {number}"))
