"""Every Hypothesis strategy. Values are built, not filtered; magnitudes are drawn by their exponent.

Scenes are those of draws.py: Hypothesis is the source of their random numbers, and shrinks them.
"""

import math
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from operator import add, mul
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


def driven_scenes() -> st.SearchStrategy[Scene]:
    """Scenes under a force whose size and speed are the pair's own, with friction by pieces."""
    return drawn(draws.driven)


def starts_by_the_edge() -> st.SearchStrategy[Fraction]:
    """Return x1 over the half width of the sliding region, often a whole number."""
    return st.builds(Fraction, st.integers(-40, 40), st.sampled_from((1, 2, 3, 7)))


def near_root(square: Fraction) -> Fraction:
    """A rational within a part in 10^30 of the square root of a positive one."""
    places = Fraction(10) ** (30 + max(0, len(str(square.denominator)) - len(str(square.numerator))))
    return Fraction(math.isqrt(math.floor(square * places**2))) / places


@st.composite
def free_pairs(draw, exponents: tuple[int, int] = (-9, 9), ratios: tuple[int, int] = (-4, 4), damped: bool = False):
    """Pairs of any mass, mass ratio, stiffness and friction; a damper has 1e-9 to 1e3 of the critical damping."""
    m1, a2, b = (draw(magnitudes(*exponents)) for _ in range(3))
    m2 = m1 * draw(magnitudes(*ratios))
    a1 = 2 * near_root(a2 * (m1 + m2)) * draw(magnitudes(-9, 2)) if damped else Fraction(0)
    return Pair(m1, m2, a2, b, a1)


@st.composite
def free_starts(draw, pair: Pair, size: tuple[int, int] = (-3, 1)) -> State:
    """Starts on S and off it, on the edge of S0 and at rest, in units of the pair."""
    width, unit = pair.half_width, pair.half_width * near_root(pair.a2 / pair.mass)
    x1, v1, v2 = (draw(signed(magnitudes(*size))) * one for one in (width, unit, unit))
    kind = draw(st.sampled_from(["off S", "on S", "on the edge", "at rest"]))
    if kind == "on the edge":
        x1 = draw(st.sampled_from([-1, 1])) * width
    if kind != "off S":
        v2 = v1 = v1 * (kind != "at rest")
    return State(x1, v1, 0, v2)


@st.composite
def free_motions(draw, damped: bool = False, size: tuple[int, int] = (-3, 1), law: Law = Law.FILIPPOV, **of) -> Scene:
    """The pair without a force, from anywhere, for some periods."""
    pair = draw(free_pairs(damped=damped, **of))
    until = draw(st.integers(1, 30)) / near_root(pair.a2 / pair.mass)
    return Scene(pair, draw(free_starts(pair, size)), until, law)


def excesses(low: int, high: int) -> st.SearchStrategy[Fraction]:
    """w = E/E_cr - 1 above 0 and below it, |w| < 1 below, by its exponent."""
    return magnitudes(low, high) | magnitudes(low, -1).map(lambda w: -w)


@st.composite
def motions_of_energy(draw, w: st.SearchStrategy[Fraction], on_surface: bool | None = None, **of) -> Scene:
    """The free pair with an energy of E_cr (1 + w), to a part in 10^30, on S, in S0 or outside it, and off S."""
    pair = draw(free_pairs(**of))
    on_surface = draw(st.booleans()) if on_surface is None else on_surface
    at = draw(free_starts(pair, (-3, 0)))
    at = State(at.x1, at.v1, 0, at.v1 if on_surface else at.v2)
    wanted = pair.critical_energy * (1 + draw(w)) / Scene(pair, at, 1).energy
    factor = near_root(wanted)
    return Scene(pair, State(*(factor * one for one in (at.x1, at.v1, 0, at.v2))), 1)


@st.composite
def starts_on_a_ray(draw, decades: tuple[int, int] = (-30, -1), **of) -> Scene:
    """The free pair as it leaves S0 by a ray with w = q y, y by its exponent and at most (pi/2 - 1)^2."""
    pair = draw(free_pairs(**of))
    y = draw(magnitudes(*decades)) * Fraction(3, 10)
    side = draw(st.sampled_from([-1, 1]))
    speed = side * near_root(2 * pair.critical_energy * pair.share * y / pair.mass)
    return Scene(pair, State(side * pair.half_width, speed, 0, speed), 1)


def late_times(low: int = 3, high: int = 100) -> st.SearchStrategy[Fraction]:
    """Times from 10^low s to 10^high s, by their exponent."""
    return magnitudes(low, high)


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


@st.composite
def sine_scenes(draw) -> tuple[Scene, Regime]:
    """A damped pair from rest under one sine below U*, between U* and U**, or above U**; and its regime.

    Frequencies are at least 0.9 omega1: below, a motion may reverse or stop more than twice a period.
    """
    masses = [draw(decimals(-1, 0, 2)) for _ in range(2)]
    a2, b = draw(decimals(0, 1, 2)), draw(decimals(-1, 0, 2))
    rate = Fraction(math.isqrt(int(10**8 * a2 / masses[0])), 10**4)
    a1 = draw(st.sampled_from([Fraction(1, 20), Fraction(1, 2), Fraction(2), Fraction(5)])) * rate * masses[0]
    pair = Pair(*masses, a2, b, a1)
    omega = rate * draw(st.integers(9, 30)) / 10
    known = thresholds(pair, omega)
    low, high = (Fraction(float(one)) for one in (known.entrainment, known.non_stop))
    regime = draw(st.sampled_from([Regime.ENTRAINED, Regime.STICK_SLIP, Regime.NON_STOP]))
    part = Fraction(draw(st.integers(2, 8)), 10)
    amplitude = {
        Regime.ENTRAINED: part * low,
        Regime.STICK_SLIP: low + part * (high - low),
        Regime.NON_STOP: high * (1 + part),
    }[regime]
    return Scene(pair, State(), until=1, force=Force.sine(amplitude, omega, draw(st.integers(-3, 3)))), regime


reaches = st.sampled_from([0.3, 0.9, 1.0])


@st.composite
def polynomials_of_roots(draw, terms: int) -> tuple[float, np.ndarray, float]:
    """How far to look, a polynomial, positive at 0, of chosen roots times a positive factor, and its scale.

    Roots lie next to each other and to the end.
    """
    theta = draw(reaches)
    near = st.sampled_from([1 - 1e-3, 1 - 1e-7, 1 + 1e-7, 1 + 1e-3, 0.01, 0.3, 0.5, 0.7, 1.5, 4.0]).map(
        lambda x: x * theta
    )
    roots = draw(st.lists(near, max_size=2))
    if roots and draw(st.booleans()):
        roots.append(roots[0] * (1 + draw(st.sampled_from([0.0, 1e-9, 1e-4, 0.03]))))
    factor = [1, draw(st.floats(-0.4, 0.4)), draw(st.floats(0, 0.3))]
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    q = np.polynomial.polynomial.polyfromroots(roots) / np.prod([-r for r in roots]) if roots else np.ones(1)
    q = np.polynomial.polynomial.polymul(q, factor)
    scale = draw(st.sampled_from([1.0, 1e-6]))
    lift = draw(st.sampled_from([0.0, 0.0, 1e-6, 1e-2]))  # so that it dips near 0 without a root
    q = np.pad(q, (0, terms - len(q))) + lift * (np.arange(terms) == 0)
    return theta, scale * (q + 1e-18 * random.normal(size=terms)), scale


@st.composite
def trigonometric_quotients(draw):
    """Quotients of polynomials in theta, its sine, its cosine and sqrt(q); a zero of the denominator leaves no pole."""
    from sympy import cos, sin, sqrt

    from theory.symbols import q, theta

    zeros, powers = draw(st.integers(0, 2)), st.integers(0, 2)
    terms = draw(st.lists(st.tuples(st.integers(-3, 3), powers, powers, powers, powers), min_size=1, max_size=3))
    top = sum(n * theta**a * sin(theta) ** b * cos(theta) ** c * sqrt(q) ** d for n, a, b, c, d in terms)
    unit = draw(st.integers(1, 3)) + draw(st.sampled_from([0, 1, sqrt(q), q])) * sin(theta)
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
