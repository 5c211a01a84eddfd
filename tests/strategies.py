"""Every Hypothesis strategy. Values are built, not filtered; magnitudes are drawn by their exponent."""

import math
from fractions import Fraction

import numpy as np
from hypothesis import strategies as st

from numerics import Force, Friction, Law, Pair, Piece, PlanePair, PlaneScene, Scene, Sine, State, Weakening, thresholds
from numerics.arithmetic.pair import Pair as WideNumber
from numerics.arithmetic.pair import two_sum
from numerics.control.response import Regime

MODERATE = (-2, 2)
EXTREME = (-12, 12)


def decimals(low: int, high: int, digits: int = 4) -> st.SearchStrategy[Fraction]:
    """Positive decimals of up to `digits` digits, m * 10^e with the leading digit at 10^low .. 10^high."""
    mantissas = st.integers(1, 10**digits - 1)
    exponents = st.integers(low, high)
    return st.builds(lambda m, e: Fraction(m) * Fraction(10) ** (e - len(str(m)) + 1), mantissas, exponents)


def signed(values: st.SearchStrategy[Fraction]) -> st.SearchStrategy[Fraction]:
    """Either sign of a positive value."""
    return st.builds(lambda s, v: s * v, st.sampled_from([-1, 1]), values)


def scaled_speed(pair: Pair, reduced: Fraction) -> Fraction:
    """A rational speed near reduced * L Omega: Omega is irrational, its first 12 digits will do."""
    rate = Fraction(pair.a2 / pair.mass)
    # integer square root of rate * 4^k, so that 40 bits of it are there at every magnitude
    shift = 40 + max(0, rate.denominator.bit_length() - rate.numerator.bit_length())
    root = math.isqrt(rate.numerator * 4**shift // rate.denominator)
    return reduced * pair.half_width * Fraction(root, 2**shift)


@st.composite
def pairs(draw, exponents: tuple[int, int] = MODERATE, damped: bool | None = False) -> Pair:
    """Pairs: damped=False a1 = 0; True every damping regime of stick and slip, borders exactly included; None both."""
    m1, m2, a2, b = (draw(decimals(*exponents)) for _ in range(4))
    if damped is False or (damped is None and draw(st.booleans())):
        return Pair(m1=m1, m2=m2, a2=a2, b=b)
    kind = draw(st.sampled_from(["tiny", "under", "near", "critical stick", "critical slip", "over", "far over"]))
    if kind.startswith("critical"):
        # a1^2 = 4 a2 m with m = m1 + m2 (stick) or m1 (slip): a2 is replaced so that a1 is rational
        mass = m1 + m2 if kind == "critical stick" else m1
        k = draw(decimals(-1, 1))
        return Pair(m1=m1, m2=m2, a2=k * k * mass, b=b, a1=2 * k * mass)
    border = scaled_speed(Pair(m1=m1, m2=m2, a2=a2, b=a2 * m2 / (m1 + m2)), Fraction(2)) * (m1 + m2)
    factor = {
        "tiny": st.builds(lambda e: Fraction(1, 10**e), st.integers(4, 30)),
        "under": decimals(-2, -1),
        "near": st.builds(lambda s, e: 1 + s * Fraction(1, 10**e), st.sampled_from([-1, 1]), st.integers(2, 11)),
        "over": st.builds(lambda f: 1 + f, decimals(-1, 0)),
        "far over": decimals(1, 5),
    }[kind]
    return Pair(m1=m1, m2=m2, a2=a2, b=b, a1=border * draw(factor))


@st.composite
def states(draw, pair: Pair, size: tuple[int, int] = (-2, 1)) -> State:
    """States in units of the pair: generic, at rest, on S, on the edge exactly, on a ray, at E_cr exactly."""
    width = pair.half_width
    reduced = st.one_of(st.just(Fraction(0)), signed(decimals(*size)))
    kind = draw(st.sampled_from(["generic", "generic", "rest", "surface", "edge", "ray", "critical", "edge slip"]))
    side = draw(st.sampled_from([-1, 1]))
    x2 = draw(reduced) * width
    if kind == "critical":
        # X^2 + V^2 = 1 with X a rational point of the circle, scaled by the irrational Omega: only X = +-1 is exact
        return State(x1=side * width, x2=x2)
    v = scaled_speed(pair, draw(reduced))
    if kind == "generic":
        return State(draw(reduced) * width, v, x2, scaled_speed(pair, draw(reduced)))
    if kind == "rest":
        return State(draw(reduced) * width, 0, x2, 0)
    if kind == "surface":
        return State(draw(reduced) * width, v, x2, v)
    if kind == "edge slip":
        return State(side * width, v, x2, scaled_speed(pair, draw(reduced)))
    load = side * width  # |P| = 1 exactly: x1 + a1 v1/a2 = +-L
    v = v if kind == "edge" else side * abs(v)
    return State(load - pair.a1 * v / pair.a2, v, x2, v)


@st.composite
def scenes(
    draw,
    exponents: tuple[int, int] = MODERATE,
    damped: bool | None = False,
    size: tuple[int, int] = (-2, 1),
    periods: tuple[int, int] = (1, 6),
    law: Law = Law.FILIPPOV,
) -> Scene:
    """Scenes whose horizon is some periods of the stuck pair."""
    pair = draw(pairs(exponents, damped))
    state = draw(states(pair, size))
    return Scene(pair, state, until=horizon(pair, draw(st.integers(*periods))), law=law)


def horizon(pair: Pair, periods: int) -> Fraction:
    """A rational time of about that many periods 2 pi/Omega, with a few digits, so that no event falls on it."""
    per_radian = 1 / (scaled_speed(pair, Fraction(1)) / pair.half_width)
    return Fraction(*(float(per_radian * periods) * 6.2731).as_integer_ratio())


@st.composite
def near_critical(draw, exponents: tuple[int, int] = (3, 300), pair: Pair | None = None) -> Scene:
    """Pairs stuck on the edge X = +-1 with outward V such that w = V^2 is about 10^-n, n up to 300."""
    pair = pair or draw(pairs())
    side, n = draw(st.sampled_from([-1, 1])), draw(st.integers(*exponents))
    v = side * scaled_speed(pair, Fraction(1, 10 ** (n // 2)) * draw(decimals(0, 0)))
    return Scene(pair, State(x1=side * pair.half_width, v1=v, v2=v), until=horizon(pair, 3))


@st.composite
def long_slips(draw, damped: bool | None = False, turns: tuple[int, int] = (0, 3)) -> Scene:
    """Slips that last many spring cycles: body 2 is much faster than body 1."""
    pair = draw(pairs(damped=damped))
    fast = scaled_speed(pair, draw(signed(decimals(*turns))) * 6)
    slow = scaled_speed(pair, draw(signed(decimals(-1, 1))))
    lasts = abs(fast) * pair.m2 / pair.b
    return Scene(pair, State(draw(signed(decimals(-1, 1))) * pair.half_width, slow, 0, fast), until=2 * lasts + 1)


def thousandths(low: float, high: float) -> st.SearchStrategy[Fraction]:
    """Decimals of three places in a range."""
    return st.builds(Fraction, st.integers(round(1000 * low), round(1000 * high)), st.just(1000))


@st.composite
def weakenings(draw, b: Fraction) -> Weakening:
    """Friction that falls and rises with speed, from 1/10 of b on, and changes by place by up to 3/5 of b, upwards."""
    gaps = draw(st.lists(thousandths(0.002, 0.15), max_size=4))
    heights = draw(st.lists(thousandths(0.1, 1.3), min_size=len(gaps), max_size=len(gaps)))
    speed = [(sum(gaps[: k + 1]), b * height) for k, height in enumerate(heights)]
    places = [sum(draw(st.lists(thousandths(0.01, 0.04), min_size=k, max_size=k)), Fraction(-1, 30)) for k in range(3)]
    place = [(z, b * draw(thousandths(0, 0.6))) for z in sorted(set(places))] if draw(st.booleans()) else []
    return Weakening(speed, draw(thousandths(0, 0.5)), place)


@st.composite
def weakened_scenes(draw) -> Scene:
    """Pairs whose friction depends on the state, free or under a sine or a trapezoid, some with pieces of b."""
    b = draw(st.sampled_from([Fraction(3, 10), Fraction(1, 2), Fraction(1)]))
    a1 = draw(st.sampled_from([Fraction(0), Fraction(3, 10), Fraction(2)]))
    pair = Pair(draw(thousandths(0.3, 2)), draw(thousandths(0.3, 2)), draw(st.sampled_from([20, 50, 200])), b, a1)
    forces = st.one_of(
        st.just(Force()),
        st.builds(Force.sine, thousandths(0.3, 3), thousandths(3, 15), thousandths(0, 6)),
        st.builds(lambda height: Force.trapezoid("0.3", "0.5", "0.7", "0.4", height), thousandths(0.5, 3)),
    )
    pieces = draw(st.sampled_from([(), (("0.7", b * Fraction(13, 10)), ("1.9", b * Fraction(7, 10)))]))
    moving = [thousandths(-0.02, 0.02), thousandths(-0.6, 0.6), st.just(Fraction(0)), thousandths(-0.6, 0.6)]
    at = State(*map(draw, moving)) if draw(st.booleans()) else State(draw(moving[0]))
    return Scene(
        pair, at, draw(st.sampled_from([1, 2, 3])), force=draw(forces), friction=Friction(pieces, draw(weakenings(b)))
    )


def free_scenes() -> st.SearchStrategy[Scene]:
    """The paper's pair: ordinary, of any magnitude, next to E_cr, in long slips, under the literal law."""
    literal = scenes(law=Law.THREE_VALUED_SGN)
    return st.one_of(scenes(size=(-2, 2)), scenes((-9, 9)), near_critical((3, 80)), long_slips(), literal)


@st.composite
def viscous_scenes(draw) -> Scene:
    """Scenes with a1 > 0 for the kernels: every damping regime, starts on S, long slips, next to E_cr, both laws."""
    kind = draw(st.sampled_from(["any", "any", "law", "long", "near"]))
    if kind == "long":
        return draw(long_slips(damped=True))
    if kind == "near":
        return draw(near_critical(exponents=(1, 14), pair=draw(pairs(damped=True))))
    return draw(scenes(damped=True, law=Law.THREE_VALUED_SGN if kind == "law" else Law.FILIPPOV))


def wide_numbers(low: int, high: int) -> st.SearchStrategy[WideNumber]:
    """Positive double-double numbers from 2^low to 2^high, with all of their 106 bits."""
    parts = st.tuples(st.floats(1, 2), st.floats(-1, 1), st.integers(low, high - 1))
    return parts.map(lambda at: two_sum(at[0] * 2.0 ** at[2], at[1] * 2.0 ** (at[2] - 53)))


def near_quarter_turns() -> st.SearchStrategy[WideNumber]:
    """Double-double numbers next to a multiple of pi/2, where a sine or a cosine vanishes."""
    parts = st.tuples(st.integers(1, 10**8), st.integers(2, 52), st.sampled_from([-1, 1]))
    return parts.map(lambda at: two_sum(at[0] * math.pi / 2 * (1 + at[2] * 2.0 ** -at[1]), 0.0))


def sines() -> st.SearchStrategy[Sine]:
    """Sines of moderate numbers."""
    return st.builds(Sine, signed(decimals(*MODERATE)), decimals(*MODERATE), signed(decimals(-1, 1)))


@st.composite
def forces(draw, most: int = 4) -> Force:
    """Forces by pieces in order of time, some of them empty."""
    gaps = draw(st.lists(decimals(-2, 1), max_size=most))
    at, pieces = draw(st.sampled_from([Fraction(0), Fraction(1, 3)])), []
    for gap in gaps:
        coefficients = draw(st.lists(signed(decimals(*MODERATE)), max_size=3))
        pieces.append(Piece(at, coefficients, draw(st.lists(sines(), max_size=2))))
        at += gap
    return Force(pieces)


@st.composite
def frictions(draw, most: int = 3) -> Friction:
    """Frictions by pieces."""
    at, pieces = Fraction(0), []
    for gap in draw(st.lists(decimals(-2, 1), max_size=most)):
        at += gap
        pieces.append((at, draw(decimals(*MODERATE))))
    return Friction(pieces)


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


@st.composite
def driven_scenes(draw) -> Scene:
    """Scenes under a force whose size and speed are the pair's own: resonances, jumps, ties, friction by pieces.

    Starts at rest, on S, on its edge as the force moves it, or in slip; any damping. A few periods long.
    """
    pair = draw(pairs((-1, 1)))
    stick = scaled_speed(pair, Fraction(1)) / pair.half_width
    slip = stick * Fraction(math.isqrt(10**8 * pair.mass // pair.m1), 10**4)
    damping = draw(st.sampled_from([Fraction(0), Fraction(1, 20), Fraction(2), Fraction(6)]))
    pair = Pair(pair.m1, pair.m2, pair.a2, pair.b, a1=damping * pair.mass * stick)
    held, until = pair.a2 * pair.half_width, Fraction(draw(st.integers(1, 60)), 10) / stick
    sizes = signed(decimals(-1, 0, 2))
    rates = st.sampled_from([stick / 3, stick, slip, slip * (1 + Fraction(1, 10**9)), 2 * slip, 3 * stick])
    times = st.integers(0, 99).map(lambda n: until * n / 100)
    pieces = []
    for start in sorted(draw(st.sets(times, min_size=1, max_size=4))):
        powers = draw(st.lists(sizes, max_size=3))
        waves = draw(
            st.lists(st.builds(Sine, sizes.map(lambda a: a * held), rates, signed(decimals(-1, 0, 1))), max_size=2)
        )
        pieces.append(Piece(start, [c * held * stick**k for k, c in enumerate(powers)], waves))
    frictions = [(t, pair.b * draw(decimals(-1, 0, 2))) for t in sorted(draw(st.sets(times, max_size=2)))]
    force = Force(pieces)
    return Scene(pair, draw(driven_states(pair, force)), until, force=force, friction=Friction(frictions))


@st.composite
def driven_states(draw, pair: Pair, force: Force) -> State:
    """States in the pair's own size: rest, on S, in slip, or a load of exactly b under the force at t = 0."""
    x, v = (draw(signed(decimals(-1, 0))) * pair.half_width for _ in range(2))
    v *= scaled_speed(pair, Fraction(1)) / pair.half_width
    kind, u = draw(st.sampled_from(["rest", "surface", "edge", "slip"])), force(0)
    if kind == "rest":
        return State()
    if kind == "slip":
        return State(x, v, 0, v * draw(signed(decimals(-1, 0))))
    if kind == "edge" and isinstance(u, Fraction):
        x = (u - pair.a1 * v - draw(st.sampled_from([-1, 1])) * pair.a2 * pair.half_width) / pair.a2
    return State(x, v, x, v)


KINDS = {
    "free": scenes(),
    "damped": scenes(damped=True),
    "many cycles in one slip": long_slips(damped=None, turns=(0, 0)),
    "next to E_cr": near_critical((3, 16)),
    "the literal law": scenes(damped=None, law=Law.THREE_VALUED_SGN),
    "driven": driven_scenes(),
}


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


@st.composite
def elementary_expressions(draw, depth: int = 3):
    """Sums, products and whole powers of two positive symbols, rationals, square roots, sines and cosines; no pole."""
    from sympy import Rational, cos, sin, sqrt, symbols

    x, y = symbols("x y", positive=True)
    if depth == 0:
        return draw(st.sampled_from([x, y, x + 2 * y, sin(x), cos(2 * x), sin(x + y), sqrt(x), sqrt(x + y)]))
    smaller = elementary_expressions(depth=depth - 1)
    kind = draw(st.sampled_from(["sum", "product", "square", "inverse", "scaled"]))
    one = draw(smaller)
    if kind == "sum":
        return one + draw(smaller)
    if kind == "product":
        return one * draw(smaller)
    if kind == "square":
        return one**2
    if kind == "inverse":
        return 1 / (1 + one**2)
    return Rational(draw(st.integers(-9, 9)), draw(st.integers(1, 9))) * one


@st.composite
def plane_scenes(draw, shape: str = "ellipsoid"):
    """Scenes on a surface, of two axes or three: round or not, with or without couplings, damper and force."""
    n = draw(st.sampled_from([2, 2, 3]))

    def thousandths(low, high):
        return Fraction(draw(st.integers(low, high)), 1000)

    def several(low, high):
        return [thousandths(low, high) for _ in range(n)]

    springs = several(80_000, 200_000)
    coupling = thousandths(-50_000, 50_000) if draw(st.booleans()) else Fraction(0)
    a2 = [[springs[i] if i == j else coupling if i + j == 1 else Fraction(0) for j in range(n)] for i in range(n)]
    b = several(200, 1000) if draw(st.booleans()) else thousandths(200, 1000)
    pair = PlanePair(several(500, 2000), several(500, 2000), a2, b, draw(st.sampled_from([0, 1])), shape)
    force = [Force.sine(thousandths(200, 2000), thousandths(2000, 9000), thousandths(0, 3000)) for _ in range(n)]
    start = {"x1": several(-20, 20), "v1": several(-200, 200), "v2": several(-200, 200)}
    return PlaneScene(pair, Fraction(1, 2), **start, force=force if draw(st.booleans()) else ())
