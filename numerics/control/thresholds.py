"""Thresholds of a force U sin(omega t + phase): up to U* it may stick for ever, only from U** on slip for ever.

With beta = b/m2, M = m1 + m2 and Z(m) = |a2 - m omega^2 + i a1 omega|:

    U*  = beta Z(M)/omega^2     the stuck response has the acceleration omega^2 U/Z(M), and friction gives body 2 beta
    U** : the least for a motion that slips for ever and reverses twice a period; it is one if w keeps its sign between
          the reversals, too (`non_stop`): from U** on for a1 = 0 and omega > omega1, else from some U on.
          v1 = v2 = -beta T/4 where a slip of sign + starts,
          the square wave of friction alone puts x1 = -b h, v1 = -b h' there, and U supplies the rest of the velocity,
          b (pi/(2 m2 omega) - h'), and of the acceleration, which must be at least beta: (b/m1) (M/m2 - a2 h - a1 h').

U** = (Z(m1)/omega) hypot of the velocity and of the acceleration over omega. Both are enclosed in balls.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import sqrt
from numerics.control.asked import to_digits
from numerics.errors import InvalidScene
from numerics.scene import Pair
from numerics.scene.decimals import Exact, exact_decimal, short


@dataclass(frozen=True)
class Thresholds:
    """U* and U** (N) of a pair at one frequency omega (rad/s): enclosures with `digits` right digits.

    `non_stop` is infinite where a1 = 0 and omega1/omega is an odd whole number > 1: there friction and body 1 are in
    resonance, and no force keeps the pair slipping with two reversals a period. `entrainment` is exactly 0 at the
    resonance of the stuck pair without damper. `exception` (N), None but where a1 = 0 and Omega/omega = n is an odd
    whole number >= 3: up to U*/cos(pi/(2 n)) other stuck motions exist, whose free oscillation flattens the peaks of
    the acceleration.
    """

    omega: Fraction
    entrainment: arb
    non_stop: arb
    exception: arb | None
    digits: int


def thresholds(pair: Pair, omega: Exact, *, digits: int = 15, max_digits: int | None = None) -> Thresholds:
    """Return both thresholds at the frequency omega (rad/s) > 0. Raises InvalidScene, PrecisionExhausted.

    >>> from numerics import Pair
    >>> found = thresholds(Pair(m1=1, m2=1, a2=200, b="0.5"), 12)
    >>> found.entrainment.str(6, radius=False), found.non_stop.str(6, radius=False)
    ('0.305556', '0.471990')
    """
    rate = exact_decimal(omega, "omega")
    if rate <= 0:
        raise InvalidScene(f"omega = {short(rate)} must be > 0; give a frequency in rad/s")

    def attempt(_: Ball) -> tuple[Thresholds, list[arb]]:
        low, high = entrainment_threshold(pair, rate), non_stop_threshold(pair, rate)
        odd = odd_ratio(pair.a2 / pair.mass, rate, pair)
        flattened = None if odd is None else low / flattest_peak(odd)
        found = Thresholds(rate, low, high, flattened, digits)
        finite = [] if non_stop_is_infinite(pair, rate) else [high]
        return found, [low, *finite, *([] if flattened is None else [flattened])]

    return to_digits(attempt, digits, max_digits)


def load_margin(pair: Pair, amplitude: Fraction, omega: Fraction) -> Fraction:
    """Return b^2 Z(M)^2 - (m2 omega^2 U)^2, exact: >= 0 exactly if U <= U*."""
    squared = (pair.a2 - pair.mass * omega**2) ** 2 + (pair.a1 * omega) ** 2
    return pair.b**2 * squared - (pair.m2 * amplitude * omega**2) ** 2


def entrainment_threshold(pair: Pair, omega: Fraction | arb) -> arb:
    """Return an enclosure of U*, N, at a frequency or over a ball of them; in the arithmetic's context."""
    rate = omega if isinstance(omega, arb) else Ball.number(omega)
    return Ball.number(pair.b / pair.m2) * stiffness(pair, pair.mass, omega) / (rate * rate)


def stiffness(pair: Pair, mass: Fraction, omega: Fraction | arb) -> arb:
    """Return an enclosure of Z(mass) = |a2 - mass omega^2 + i a1 omega|, N/m; exactly 0 at an exact resonance."""
    number = Ball.number
    if isinstance(omega, arb):
        return hypot(number(pair.a2) - number(mass) * omega * omega, number(pair.a1) * omega)
    return hypot(number(pair.a2 - mass * omega**2), number(pair.a1 * omega))


def non_stop_threshold(pair: Pair, omega: Fraction) -> arb:
    """Return an enclosure of U**, N; infinite where no such motion exists; in the arithmetic's context."""
    if non_stop_is_infinite(pair, omega):
        return arb.pos_inf()
    if pair.a1 == 0 and pair.a2 == pair.m1 * omega**2:
        # at omega1 itself the sine must make up for what friction takes in a cycle, 4 b times the amplitude
        return 4 * Ball.number(pair.b) / arb.pi()
    return non_stop_over(pair, omega)


def non_stop_is_infinite(pair: Pair, omega: Fraction) -> bool:
    """Return whether a1 = 0 and omega1/omega is an odd whole number >= 3: no U** then; exact."""
    return odd_ratio(pair.a2 / pair.m1, omega, pair) is not None


def non_stop_over(pair: Pair, omega: Fraction | arb) -> arb:
    """Return an enclosure of U** where it is finite, at a frequency or over a ball of them."""
    rate = omega if isinstance(omega, arb) else Ball.number(omega)
    velocity, acceleration = reversal_demand(pair, rate)
    return stiffness(pair, pair.m1, omega) / rate * hypot(velocity, acceleration / rate)


def reversal_demand(pair: Pair, omega: arb) -> tuple[arb, arb]:
    """Return what the response to U must give where slip + begins: minus a velocity, at least an acceleration."""
    number = Ball.number
    b, m1, m2 = number(pair.b), number(pair.m1), number(pair.m2)
    place, speed = square_wave_response(pair, omega)
    velocity = b * (arb.pi() / (2 * m2 * omega) - speed)
    return velocity, b / m1 * (number(pair.mass) / m2 - number(pair.a2) * place - number(pair.a1) * speed)


def square_wave_response(pair: Pair, omega: arb) -> tuple[arb, arb]:
    """Return h (m/N) and h' (m/(N s)): where a square wave of +-1 N has m1 x'' + a1 x' + a2 x when it turns to +1."""
    number = Ball.number
    half = arb.pi() / omega
    decay = number(pair.a1 / (2 * pair.m1)) * half
    cosine, sine = cosine_and_sine(pair.a2 / pair.m1 - (pair.a1 / (2 * pair.m1)) ** 2, half / 2)
    # D = cosh + cos, and sin(omegad T/2)/omegad, by half angles: next to D = 0 nothing cancels
    rise = (decay / 2).sinh()
    below = 2 * (rise * rise + cosine * cosine)
    sine_over_rate = 2 * sine * cosine
    place = -(decay.sinh() - decay / half * sine_over_rate) / (number(pair.a2) * below)
    return place, -sine_over_rate / (number(pair.m1) * below)


def cosine_and_sine(squared_rate: Fraction, time: arb) -> tuple[arb, arb]:
    """Return cos(rate t) and sin(rate t)/rate for rate^2 of any sign: light, critical and heavy damping."""
    if squared_rate == 0:
        return arb(1), time
    rate = Ball.number(abs(squared_rate)).sqrt()
    angle = rate * time
    if squared_rate > 0:
        return angle.cos(), angle.sin() / rate
    return angle.cosh(), angle.sinh() / rate


def hypot(x: arb, y: arb) -> arb:
    """Return an enclosure of sqrt(x^2 + y^2), an exact |x| where y is exactly 0."""
    if y.is_zero():
        return abs(x)
    return abs(y) if x.is_zero() else sqrt(x * x + y * y)


def flattest_peak(odd: int) -> arb:
    """Return the least max |sin t + c sin(n t + phase)| over c and phase for an odd n >= 3: cos(pi/(2 n))."""
    return (arb.pi() / (2 * odd)).cos()


def odd_ratio(squared_rate: Fraction, omega: Fraction, pair: Pair) -> int | None:
    """Return rate/omega if a1 = 0 and that is an odd whole number >= 3, else None; exact."""
    ratio = squared_rate / omega**2
    root = math.isqrt(ratio.numerator)
    is_odd = pair.a1 == 0 and ratio.denominator == 1 and root**2 == ratio and root % 2 == 1 and root >= 3
    return root if is_odd else None
