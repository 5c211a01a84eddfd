"""The oscillator of every regime, told in each arithmetic, against complex exponentials in 200 digits."""

from fractions import Fraction

import mpmath
from flint import arb
from hypothesis import assume, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import decimals, signed

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.flows import oscillator as texts
from numerics.motion.tellings import motion_telling
from numerics.trajectory.comparison import as_fraction


def told(arithmetic, function):
    return motion_telling(arithmetic.telling, is_damped=False)(function)


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
