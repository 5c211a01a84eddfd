"""Every Hypothesis strategy. Values are built, not filtered; magnitudes are drawn by their exponent.

Scenes are those of draws.py: Hypothesis is the source of their random numbers, and shrinks them.
"""

import math
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from operator import add, mul
from random import Random
from typing import Any

import draws
import numpy as np
from flint import arb
from hypothesis import settings
from hypothesis import strategies as st

from numerics import Force, Law, Pair, Scene, State, thresholds
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.pair import TwoFloats, two_sum
from numerics.control.response import Regime

MODERATE = (-2, 2)
EXTREME = (-12, 12)


def drawn(draw: Callable[..., Any], *given: Any, **named: Any) -> st.SearchStrategy[Any]:
    """What a function makes of a source of random numbers."""
    return st.randoms(use_true_random=False).map(lambda random: draw(random, *given, **named))


decimals = partial(drawn, draws.decimal)
"""Positive decimals of up to so many digits, four unless told, the first at 10^low to 10^high."""
magnitudes = decimals
pairs = partial(drawn, draws.pair)
states = partial(drawn, draws.state)
scenes = partial(drawn, draws.scene)
near_critical = partial(drawn, draws.near_critical)
long_slips = partial(drawn, draws.long_slip)
ties = partial(drawn, draws.tie)
grazes = partial(drawn, draws.graze)
weakened_scenes = partial(drawn, draws.weakened, damping=(-12, 2))
"""With friction of the state, and dampers that do not ask for more steps than a test waits for."""
driven_scenes = partial(drawn, draws.driven)
"""Under a force whose size and speed are the pair's own, with friction by pieces."""
brought_scenes = partial(drawn, draws.brought)
plane_scenes = partial(drawn, draws.surface, exponents=(0, 0), narrow=False)
extreme_scenes = {kind: drawn(draw) for kind, draw in draws.KINDS.items()}
"""Scenes of masses, rates, frictions and energies of many magnitudes, and on a surface."""
forces = partial(drawn, draws.force, Fraction(1), Fraction(3), Fraction(10))


def fewer(times: int) -> settings:
    """Settings of a test whose cases are long: it tries so many times fewer than the others."""
    return settings(max_examples=max(2, settings().max_examples // times))


def signed(values: st.SearchStrategy[Fraction]) -> st.SearchStrategy[Fraction]:
    """Either sign of a positive value."""
    return st.builds(lambda s, v: s * v, st.sampled_from([-1, 1]), values)


def starts_by_the_edge() -> st.SearchStrategy[Fraction]:
    """Return x1 over the half width of the sliding region, often a whole number."""
    return st.builds(Fraction, st.integers(-40, 40), st.sampled_from((1, 2, 3, 7)))


free_motions = partial(scenes, (-9, 9), size=(-3, 1), periods=(1, 5), damping=(-9, 2), ratios=(-4, 4))
motions_of_energy = partial(drawn, draws.of_energy)
late_times = partial(decimals, 3, 100)


def free_scenes() -> st.SearchStrategy[Scene]:
    """The paper's pair: ordinary, of any magnitude, next to E_cr, in long slips, under the literal law."""
    literal = scenes(law=Law.THREE_VALUED_SGN)
    return st.one_of(scenes(size=(-2, 2)), scenes(exponents=(-9, 9)), near_critical((3, 80)), long_slips(), literal)


def viscous_scenes() -> st.SearchStrategy[Scene]:
    """Scenes with a1 > 0: every damping regime, starts on S, long slips, next to E_cr, both laws."""
    law = scenes(damped=True, law=Law.THREE_VALUED_SGN)
    return st.one_of(scenes(damped=True), law, long_slips(damped=True), near_critical((1, 14), damped=True))


def balls() -> st.SearchStrategy[arb]:
    """Balls whose midpoints have up to 600 bits, and whose radii are of any size beside them, or 0."""

    def built(mantissa: int, exponent: int, radius: int, smaller: int) -> arb:
        with Ball(200).context():
            return arb(arb((mantissa, exponent)), arb((radius, exponent - smaller)))

    exponents = st.integers(-3000, 3000)
    return st.builds(built, st.integers(-(2**600), 2**600), exponents, st.integers(0, 2**30 - 1), exponents)


def positive_floats(low: int, high: int) -> st.SearchStrategy[float]:
    """Positive floats from 2^low to 2^high."""
    return st.builds(math.ldexp, st.floats(1, 2), st.integers(low, high - 1))


def two_floats(low: int, high: int) -> st.SearchStrategy[TwoFloats]:
    """Positive numbers from 2^low to 2^high as sums of two floats, with 106 bits."""
    parts = st.tuples(st.floats(1, 2), st.floats(-1, 1), st.integers(low, high - 1))
    return parts.map(lambda at: two_sum(at[0] * 2.0 ** at[2], at[1] * 2.0 ** (at[2] - 53)))


def near_quarter_turns() -> st.SearchStrategy[float]:
    """Floats next to a multiple of pi/2, where a sine or a cosine vanishes."""
    parts = st.tuples(st.integers(1, 10**8), st.integers(2, 52), st.sampled_from([-1, 1]))
    return parts.map(lambda at: at[0] * math.pi / 2 * (1 + at[2] * 2.0 ** -at[1]))


def from_random(draw: Callable[..., Any]) -> Callable[..., st.SearchStrategy[Any]]:
    return partial(drawn, draw)


@from_random
def sine_scenes(random: Random) -> tuple[Scene, Regime]:
    """A damped pair from rest under one sine below U*, between U* and U**, or above U**; and its regime.

    Frequencies are at least 0.9 omega1: below, a motion may reverse or stop more than twice a period.
    """
    m1, m2, b = (draws.decimal(random, -1, 0, 2) for _ in range(3))
    a2 = draws.decimal(random, 0, 1, 2)
    rate = Fraction(math.isqrt(int(10**8 * a2 / m1)), 10**4)
    pair = Pair(m1, m2, a2, b, random.choice([Fraction(1, 20), Fraction(1, 2), 2, 5]) * rate * m1)
    omega, part = rate * random.randint(9, 30) / 10, Fraction(random.randint(2, 8), 10)
    known = thresholds(pair, omega)
    low, high = (Fraction(float(one)) for one in (known.entrainment, known.non_stop))
    sizes = [part * low, low + part * (high - low), high * (1 + part)]
    regime, size = random.choice([*zip((Regime.ENTRAINED, Regime.STICK_SLIP, Regime.NON_STOP), sizes, strict=True)])
    return Scene(pair, State(), until=1, force=Force.sine(size, omega, random.randint(-3, 3))), regime


NEAR_1 = [1 - 1e-3, 1 - 1e-7, 1 + 1e-7, 1 + 1e-3, 0.01, 0.3, 0.5, 0.7, 1.5, 4.0]


@from_random
def polynomials_of_roots(random: Random, terms: int) -> tuple[float, np.ndarray, float]:
    """How far to look, a polynomial, positive at 0, of chosen roots times a positive factor, and its scale.

    Roots lie next to each other and to the end; it may dip near 0 without a root, and is off by rounding.
    """
    theta, scale = random.choice([0.3, 0.9, 1.0]), random.choice([1.0, 1e-6])
    roots = [theta * random.choice(NEAR_1) for _ in range(random.randint(0, 2))]
    if roots and random.choice([True, False]):
        roots.append(roots[0] * (1 + random.choice([0.0, 1e-9, 1e-4, 0.03])))
    q = np.polynomial.Polynomial([1, random.uniform(-0.4, 0.4), random.uniform(0, 0.3)])
    for root in roots:
        q *= np.polynomial.Polynomial([1, -1 / root])
    q += random.choice([0.0, 0.0, 1e-6, 1e-2])
    off = [1e-18 * random.uniform(-2, 2) for _ in range(terms)]
    return theta, scale * (np.pad(q.coef, (0, terms - len(q.coef))) + off), scale


@from_random
def trigonometric_quotients(random: Random) -> Any:
    """Quotients of polynomials in theta, its sine, its cosine and sqrt(q); a zero of the denominator leaves no pole."""
    from sympy import cos, sin, sqrt

    from theory.symbols import q, theta

    zeros, letters = random.randint(0, 2), (theta, sin(theta), cos(theta), sqrt(q))
    terms = range(random.randint(1, 3))
    top = sum(random.randint(-3, 3) * math.prod(one ** random.randint(0, 2) for one in letters) for _ in terms)
    unit = random.randint(1, 3) + random.choice([0, 1, sqrt(q), q]) * sin(theta)
    return top * theta ** (2 * zeros) / ((1 - cos(theta)) ** zeros * unit)


def elementary_expressions() -> st.SearchStrategy[Any]:
    """Sums, products and whole powers of two positive symbols, rationals, square roots, sines and cosines; no pole."""
    from sympy import Rational, cos, sin, sqrt, symbols

    x, y = symbols("x y", positive=True)
    ratios = st.builds(Rational, st.integers(-9, 9), st.integers(1, 9))

    def larger(some: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
        powers = some.map(lambda one: one**2) | some.map(lambda one: 1 / (1 + one**2))
        return st.builds(add, some, some) | st.builds(mul, some | ratios, some) | powers

    return st.recursive(
        st.sampled_from([x, y, x + 2 * y, sin(x), cos(2 * x), sin(x + y), sqrt(x), sqrt(x + y)]), larger, max_leaves=6
    )
