"""The functions of the arithmetics against 8000-bit truth, by decade; roots, and the oscillator's regimes."""

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, NamedTuple

import flint
import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import decimals, signed

from numerics.arithmetic import ball_words, float64, multiprecision
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.protocol import Sign, decide_sign
from numerics.arithmetic.questions import GRAZES
from numerics.arithmetic.telling import text
from numerics.contact.root import root_of
from numerics.errors import EventUndecided, OutOfRange
from numerics.flows import oscillator as texts
from numerics.motion.tellings import motion_telling
from numerics.trajectory.comparison import as_fraction

DEFICITS = {
    "versine": lambda x: 1 - x.cos(),
    "sine_deficit": lambda x: x - x.sin(),
    "cosine_deficit": lambda x: x * x / 2 - 1 + x.cos(),
}
SMALLEST = {"versine": 1e-150, "sine_deficit": 1e-100, "cosine_deficit": 1e-75}
TRUTH_BITS = 8000


def ball(value: Fraction) -> arb:
    return arb(fmpq(value.numerator, value.denominator))


def said(arithmetic, name: str):
    """A word as an arithmetic says it."""
    modules = {"float64": float64, "mpmath": multiprecision, "ball": ball_words}
    return getattr(modules[arithmetic.name], name)


class Bits:
    """The precision of the truth, restored."""

    def __init__(self, bits: int = TRUTH_BITS):
        self.bits = bits

    def __enter__(self):
        self.before, flint.ctx.prec = flint.ctx.prec, self.bits

    def __exit__(self, *_):
        flint.ctx.prec = self.before


def ulps(computed: float, truth: arb) -> float:
    """The error of a float in units of its last place."""
    with Bits():
        return float(abs(arb(computed) - truth).upper()) / math.ulp(float(truth.mid()))


def angles(decade: int) -> Iterator[float]:
    for leading in (1.0, 1.23456789, 2.0, 3.14159265358979, 4.4934, 6.283185307179586, 7.77, 9.99):
        yield float(f"{leading!r}e{decade}")


@pytest.mark.parametrize("name", DEFICITS)
@pytest.mark.parametrize("decades", [range(-75, -8), range(-8, 1), range(1, 22)], ids=["small", "middle", "large"])
def test_float64_is_within_4_ulp(name, decades):
    function, worst = said(Float64(), name), 0.0
    for decade in decades:
        for x in angles(decade):
            if x >= SMALLEST[name]:
                with Bits():
                    truth = DEFICITS[name](arb(x))
                worst = max(worst, ulps(function(x), truth))
    assert worst <= 4


@pytest.mark.parametrize("name", DEFICITS)
@given(x=st.floats(1e-70, 1e15))
def test_float64_is_within_4_ulp_anywhere(name, x):
    with Bits():
        truth = DEFICITS[name](arb(x))
        assume(abs(truth) > 1e-290)
    assert ulps(said(Float64(), name)(x), truth) <= 4


@pytest.mark.parametrize("name", DEFICITS)
@given(x=decimals(-300, 20, 20), digits=st.sampled_from([10, 50, 200]))
def test_balls_enclose_and_are_tight(name, x, digits):
    arithmetic = Ball(digits)
    with Bits():
        truth = DEFICITS[name](ball(x))
    with arithmetic.context():
        value = said(arithmetic, name)(arithmetic.number(x))
    with Bits():
        assert value.contains(truth) or value.overlaps(truth)
        if x < 6:  # beyond, sines have zeros next to which a ball of x says less
            assert value.rad() <= abs(truth) * arb(2) ** (12 - arithmetic.bits)


@pytest.mark.parametrize("name", DEFICITS)
@given(x=decimals(-40, -1, 10), relative=st.integers(3, 25), part=st.floats(-1, 1))
def test_a_wide_ball_encloses_every_point_of_it(name, x, relative, part):
    radius = x / 10**relative
    inside = x + radius * Fraction(part) * Fraction(999, 1000)
    arithmetic = Ball(30)
    with Bits():
        truth, wide = DEFICITS[name](ball(inside)), arb(ball(x).mid(), ball(radius).upper())
    with arithmetic.context():
        value = said(arithmetic, name)(wide)
    with Bits():
        assert value.overlaps(truth)
        if relative > 5:  # x^4 moves four times as much as x, relatively
            assert value.rad() <= 8 * abs(truth) * arb(10) ** -relative


@pytest.mark.parametrize("name", DEFICITS)
@given(x=decimals(-300, 12, 20))
def test_mpmath_is_right_to_its_digits(name, x):
    arithmetic = Multiprecision(50)
    with arithmetic.context():
        number = arithmetic.number(x)
        value, exact = said(arithmetic, name)(number), as_fraction(number)
    with Bits():
        truth = DEFICITS[name](ball(exact))
        assert abs(ball(as_fraction(value)) - truth) <= abs(truth) * arb(10) ** -45


@pytest.mark.parametrize("name", DEFICITS)
def test_deficits_at_zero_and_at_turns(name):
    for arithmetic in (Float64(), Multiprecision(30), Ball(30)):
        with arithmetic.context():
            function = said(arithmetic, name)
            assert arithmetic.to_float(function(arithmetic.number(0))) == 0
            turn = function(said(arithmetic, "turn")())
            expected = {"versine": 0, "sine_deficit": 2 * math.pi, "cosine_deficit": 2 * math.pi**2}[name]
            assert arithmetic.to_float(turn) == pytest.approx(expected, abs=1e-15)


def test_balls_that_are_not_finite_decide_nothing():
    arithmetic = Ball(20)
    with arithmetic.context():
        for x in (arb("nan"), arb("inf"), arb(0, 1), arb(1, 2)):
            assert arithmetic.sign(x) is Sign.UNDECIDED
            with pytest.raises(EventUndecided, match=r"which\?"):
                decide_sign(arithmetic, x, "which?")
            with pytest.raises(EventUndecided, match="graze"):
                ball_words.sign(x, GRAZES)
        assert arithmetic.sign(arb(0)) is Sign.ZERO
        with pytest.raises(EventUndecided, match="graze"):
            ball_words.ceiling(arb(0, 1), GRAZES)
        assert ball_words.sign(arb(0), GRAZES) == 0
        assert arithmetic.sqrt(arb(0, 1e-30)).is_finite()
        assert arithmetic.sqrt(arb(0, 1e-30)).contains(arb(1e-15))


def test_float64_refuses_what_it_cannot_hold():
    for value in (Fraction(10) ** 400, Fraction(1, 10**400), -(Fraction(10) ** 400)):
        with pytest.raises(OutOfRange):
            Float64().number(value)
    for x in (math.nan, math.inf, -math.inf):
        with pytest.raises(OutOfRange):
            Float64().sign(x)


class Power(NamedTuple):
    """c^p - x^p, which falls through its root c."""

    c: Any
    p: int


@text
def power_and_slope(at, x):
    """Its value and its slope at x."""
    return at.c**at.p - x**at.p, -at.p * x ** (at.p - 1)


root_of_power = root_of(power_and_slope, "root_of_power")


def told(arithmetic, function):
    return motion_telling(arithmetic.telling, is_damped=False)(function)


@given(target=decimals(-30, 6, 8), power=st.sampled_from([1, 3, 5]))
def test_roots_of_monotone_functions(target, power):
    """Wide brackets and steep flanks included."""
    for arithmetic in (Float64(), Multiprecision(40), Ball(40)):
        with arithmetic.context():
            c = arithmetic.number(target)
            lower, upper = c / 1000, 1000 * c
            root = told(arithmetic, root_of_power)(Power(c, power), lower, upper, (lower + upper) / 2)
            if arithmetic.name == "ball":
                assert root.overlaps(c)
                assert root.rad() <= c * arb(10) ** -36
            else:
                digits = 14 if arithmetic.name == "float64" else 37
                assert abs(root / c - 1) <= 10.0**-digits


def test_a_ball_root_needs_proven_signs():
    arithmetic = Ball(30)
    with arithmetic.context():
        for lower, upper in ((2, 3), (-3, -2), (0, 1), (1, 2)):
            with pytest.raises(EventUndecided, match="bracket"):
                told(arithmetic, root_of_power)(Power(arb(1), 1), arb(lower), arb(upper), arb(1))


def truth_of(decay, stiffness, y, v, t):
    """The oscillator by complex exponentials in 200 digits."""
    with mpmath.workdps(200):
        decay, stiffness, y, v, t = (mpmath.mpf(one.numerator) / one.denominator for one in (decay, stiffness, y, v, t))
        n = mpmath.sqrt(mpmath.mpc(decay * decay - stiffness))
        one, two = -decay + n, -decay - n
        if n == 0:
            e = mpmath.exp(one * t)
            return ((y + (v - one * y) * t) * e).real, ((v + one * (v - one * y) * t) * e).real
        c1 = (v - two * y) / (one - two)
        c2 = y - c1
        e1, e2 = mpmath.exp(one * t), mpmath.exp(two * t)
        return (c1 * e1 + c2 * e2).real, (c1 * one * e1 + c2 * two * e2).real


def oscillator(arithmetic, decay: Fraction, stiffness: Fraction) -> texts.Oscillator:
    discriminant = stiffness - decay * decay
    regime = (discriminant > 0) - (discriminant < 0)
    frequency = arithmetic.sqrt(arithmetic.number(abs(discriminant)))
    return told(arithmetic, texts.oscillator)(arithmetic.number(decay), arithmetic.number(stiffness), regime, frequency)


@st.composite
def oscillators(draw) -> tuple[Fraction, Fraction]:
    decay = draw(decimals(-2, 2))
    kind = draw(st.sampled_from(["under", "over", "critical", "near"]))
    if kind == "critical":
        return decay, decay * decay
    if kind == "near":
        return decay, decay * decay * (1 + draw(st.sampled_from([-1, 1])) * Fraction(1, 10 ** draw(st.integers(2, 60))))
    return decay, decay * decay * (1 + draw(decimals(-1, 4)) if kind == "under" else draw(decimals(-4, -1)))


COORDINATES = st.one_of(st.just(Fraction(0)), signed(decimals(-3, 3)))


@given(oscillators(), COORDINATES, COORDINATES, decimals(-4, 1))
def test_the_oscillator_in_every_regime(parameters, y, v, t):
    decay, stiffness = parameters
    t = t / decay
    truths = truth_of(decay, stiffness, y, v, t)
    size = float(abs(y) + abs(v) / decay)
    for arithmetic, digits in ((Float64(), 11), (Multiprecision(60), 50), (Ball(60), 45)):
        with arithmetic.context():
            numbers = (arithmetic.number(one) for one in (y, v, t))
            found = told(arithmetic, texts.propagate)(oscillator(arithmetic, decay, stiffness), *numbers)
            rate = float(decay + abs(stiffness) / decay)
            for one, truth, scale in zip(found, truths, (size * (1 + rate / float(decay)), size * rate), strict=True):
                with mpmath.workdps(200):
                    middle = as_fraction(one) if arithmetic.name != "ball" else exact(one.mid())
                    error = abs(mpmath.mpf(middle.numerator) / middle.denominator - truth)
                    assert error <= mpmath.mpf(10) ** -digits * scale
                    if arithmetic.name == "ball":
                        assert error <= 2 * mpmath.mpf(float(one.rad())) + mpmath.mpf(10) ** -150 * scale


def exact(point: arb) -> Fraction:
    mantissa, exponent = point.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def derivatives(decay, stiffness, y, v):
    """The third and the fourth derivative, exact."""
    pull = -(2 * decay * v + stiffness * y)
    jerk = -(2 * decay * pull + stiffness * v)
    return jerk, -(2 * decay * jerk + stiffness * pull)


@reaching
@given(oscillators(), COORDINATES, COORDINATES)
def test_the_jerk_s_first_zero_is_a_zero_and_the_first(parameters, y, v):
    """It obeys the same equation as y; the damped motions turn there."""
    decay, stiffness = parameters
    jerk, snap = derivatives(decay, stiffness, y, v)
    assume(jerk or snap)
    arithmetic = Multiprecision(60)
    with arithmetic.context():
        number, motion = arithmetic.number, oscillator(arithmetic, decay, stiffness)
        horizon = 1000 / number(decay)
        zero = told(arithmetic, texts.first_jerk_zero)(motion, number(y), number(v), horizon, jerk == 0)
        assert zero > 0
        if zero > horizon:
            assert motion.regime <= 0
            later = [truth_of(decay, stiffness, jerk, snap, Fraction(k * k, 50) / decay)[0] for k in range(1, 40)]
            assert all(one >= 0 for one in later) or all(one <= 0 for one in later)
            raise LeftOut

        def at(t):
            return told(arithmetic, texts.propagate)(motion, number(jerk), number(snap), t)[0]

        # as n -> 0 the logarithm of the overdamped zero loses the digits of n; a bracket needs no more
        assert abs(at(zero)) <= mpmath.mpf(10) ** -25 * (abs(number(jerk)) + abs(number(snap)) / number(decay))
        before = [at(zero * k / 40) for k in range(1, 40)]
        assert all(one > 0 for one in before) or all(one < 0 for one in before)


@reaching
@given(oscillators(), COORDINATES, COORDINATES, decimals(-3, 1))
def test_the_integral_of_the_square(parameters, y, v, t):
    decay, stiffness = parameters
    arithmetic = Multiprecision(60)
    with arithmetic.context():
        motion = oscillator(arithmetic, decay, stiffness)
        y0, v0, length = (arithmetic.number(one) for one in (y, v, t / decay / 4))
        pieces = max(2, int(length * mpmath.sqrt(arithmetic.number(stiffness))) + 2)
        if pieces > 40:
            raise LeftOut
        grid, propagate = mpmath.linspace(0, length, pieces + 1), told(arithmetic, texts.propagate)
        expected = mpmath.quad(lambda s: propagate(motion, y0, v0, s)[0] ** 2, grid)
        size = (y0**2 + v0**2 / arithmetic.number(stiffness)) / arithmetic.number(decay)
        found = told(arithmetic, texts.integral_of_square)(motion, y0, v0, length)
        assert abs(found - expected) <= 1e-30 * (size + expected)
