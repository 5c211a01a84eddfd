"""Thresholds of U sin(omega t + phase): permanent stick needs U <= U*, slip with two reversals a period U >= U**.

With beta = b/m2, M = m1 + m2 and Z(m) = |a2 - m omega^2 + i a1 omega|:

    U*  = beta Z(M)/omega^2     the stuck response has the acceleration omega^2 U/Z(M), and friction gives body 2 beta
    U** = (Z(m1)/omega) hypot(V, A/omega)    the least for permanent slip with two reversals a period

v1 = v2 = -beta T/4 where a slip of sign + starts; the square wave of friction alone puts x1 = -b h, v1 = -b h' there,
and U supplies the rest of the velocity, V = b (pi/(2 m2 omega) - h'), and of the acceleration, which must be at least
beta: A = (b/m1) (M/m2 - a2 h - a1 h'). From there on

    w = -m1 b h' g'(t) - b (1 - a2 h) g(t) - beta (t - T/4) - V cos(omega t) + R sin(omega t)

with g the impulse response of body 1, R^2 = (U omega/Z(m1))^2 - V^2. It is a motion exactly if U >= U** and w > 0 for
0 < t < T/2. There w rises with R, so the second condition, too, holds from some amplitude on: from U** on for a1 = 0,
omega > omega1.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from flint import acb, arb, arb_mat

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball
from numerics.control.answers import number
from numerics.errors import InvalidScene
from numerics.scene import Pair
from numerics.scene.decimals import Exact, positive, require_digits
from numerics.scene.model import PLAIN, require_kind
from numerics.scene.plane import PlanePair
from numerics.scene.short_repr import ShortRepr

_TIMES = 96
"""Times in half a period at which w is looked at for a figure."""


@dataclass(frozen=True, repr=False)
class Thresholds(ShortRepr):
    """U* and U** (N) of a pair at one frequency omega (rad/s): enclosures with `digits` right digits.

    `entrainment`, U*: a permanently stuck motion needs U <= U*; exactly 0 at the resonance of the undamped stuck pair.
    `non_stop`, U**: permanent slip with two reversals per period needs U >= U**; infinite where a1 = 0 and omega1/omega
    is an odd integer > 1 (resonance of friction with body 1). `exception` (N) is None unless a1 = 0 and Omega/omega = n
    is an odd integer >= 3: then other stuck motions exist up to U*/cos(pi/(2 n)), whose free oscillation flattens the
    peaks of the acceleration.

    >>> from numerics import Pair
    >>> found = thresholds(Pair(m1=1, m2=1, a2=200, b="0.5"), "10/3", digits=6)
    >>> found.omega, [one.str(6, radius=False) for one in (found.entrainment, found.non_stop, found.exception)]
    (Fraction(10, 3), ['8.00000', '22.1213', '9.23760'])
    """

    omega: Fraction
    entrainment: arb
    non_stop: arb
    exception: arb | None
    digits: int


def thresholds(pair: Pair | PlanePair, omega: Exact, *, digits: int = 15, max_digits: int | None = None) -> Thresholds:
    """Return both thresholds at the frequency omega (rad/s) > 0. Raises InvalidScene, PrecisionExhausted, TypeError,
    ValueError (digits).

    >>> from numerics import Pair
    >>> found = thresholds(Pair(m1=1, m2=1, a2=200, b="0.5"), 12)
    >>> found.entrainment.str(6, radius=False), found.non_stop.str(6, radius=False)
    ('0.305556', '0.471990')
    """
    if not isinstance(pair, PlanePair):
        require_kind("thresholds", pair, Pair, "build Pair(m1=..., m2=..., a2=..., b=...)")
        if extra := pair.extra:
            raise InvalidScene(f"thresholds are not available for {extra}; {PLAIN}")
    require_digits(digits, max_digits=max_digits)
    rate = positive(omega, "omega", "give a frequency in rad/s")
    line = round_pair(pair) if isinstance(pair, PlanePair) else pair

    def attempt(_: Ball) -> tuple[Thresholds, list[arb]]:
        low = entrainment_threshold(line, rate)
        if isinstance(pair, PlanePair):  # under a rotating force both are equal
            return Thresholds(rate, low, low, None, digits), [low]
        high, odd = non_stop_threshold(line, rate), odd_ratio(line, line.mass, rate)
        # others stick where a free oscillation flattens the peaks: min max |sin t + c sin(n t + phase)| = cos(pi/(2 n))
        flattened = None if odd is None else low / (arb.pi() / (2 * odd)).cos()
        numbers = [low, high if odd_ratio(line, line.m1, rate) is None else low, flattened or low]
        return Thresholds(rate, low, high, flattened, digits), numbers

    return to_digits(attempt, digits, max_digits)


def round_pair(pair: PlanePair) -> Pair:
    """Return the pair on a line that one with all directions alike is along each of them. Raises InvalidScene."""
    numbers = pair.m1[0], pair.m2[0], pair.a2[0][0], pair.b[0], pair.a1[0][0]
    if pair != PlanePair(*numbers):
        raise InvalidScene("only an isotropic pair has a closed form: two axes, ellipsoid, equal numbers on both")
    return Pair(*numbers)


def load_margin(pair: Pair, amplitude: Fraction, omega: Fraction) -> Fraction:
    """Return b^2 Z(M)^2 - (m2 omega^2 U)^2, exact: >= 0 exactly if U <= U*."""
    squared = (pair.a2 - pair.mass * omega**2) ** 2 + (pair.a1 * omega) ** 2
    return pair.b**2 * squared - (pair.m2 * amplitude * omega**2) ** 2


def entrainment_threshold(pair: Pair, omega: Fraction) -> arb:
    """Return an enclosure of U*, N, at a frequency; in the arithmetic's context."""
    rate = number(omega)
    return number(pair.b / pair.m2) * abs(impedance(pair, pair.mass, omega)) / (rate * rate)


def impedance(pair: Pair, mass: Fraction, omega: Fraction) -> acb:
    """Return an enclosure of a2 - mass omega^2 + i a1 omega, N/m, whose size is Z; exactly 0 at an exact resonance."""
    return acb(number(pair.a2 - mass * omega**2), number(pair.a1 * omega))


def non_stop_threshold(pair: Pair, omega: Fraction) -> arb:
    """Return an enclosure of U**, N; infinite where no such motion exists; in the arithmetic's context."""
    if odd_ratio(pair, pair.m1, omega) is not None:
        return arb.pos_inf()
    if pair.a1 == 0 and pair.a2 == pair.m1 * omega**2:
        # at omega1 itself the sine must make up for what friction takes in a cycle, 4 b times the amplitude
        return 4 * number(pair.b) / arb.pi()
    motion = NonStop(pair, omega)
    return motion.amplitude(motion.least)


def odd_ratio(pair: Pair, mass: Fraction, omega: Fraction) -> int | None:
    """Return n if a1 = 0 and a mass on the spring has the frequency n omega, n >= 3 an odd whole number; exact."""
    ratio = pair.a2 / mass / omega**2
    root = math.isqrt(ratio.numerator)
    is_odd = pair.a1 == 0 and ratio.denominator == 1 and root**2 == ratio and root % 2 == 1 and root >= 3
    return root if is_odd else None


def edges(pair: Pair, omega: Fraction) -> tuple[arb, arb, arb]:
    """Return U*, U** and the least U >= U** at which w keeps its sign, N; in the arithmetic's context.

    The last is approximate, for figures: w is looked at on a grid of times, not between them, so it may lie a little
    too low. It is infinite where U** is.
    """
    low, high = entrainment_threshold(pair, omega), non_stop_threshold(pair, omega)
    if not high.is_finite():
        return low, high, high
    least, motion = arb(0), NonStop(pair, omega)
    t = motion.half / (2 * _TIMES)
    fading, step = flow(pair, t) * motion.fading, flow(pair, 2 * t)
    for _ in range(_TIMES):
        angle = motion.omega * t
        w = fading[1, 0] - motion.beta * (t - motion.half / 2) - motion.V * angle.cos()
        least, fading, t = least.max(-w / angle.sin()), step * fading, t + motion.half / _TIMES
    return low, high, high.max(motion.amplitude(least))


class NonStop:
    """The motion that slips permanently and reverses twice a period, at a frequency (rad/s).

    The names are those of the formulas above: `V` and `reach` = Z(m1)/omega, `least` = A/omega; `fading`: the (x1, v1)
    whose own motion is in w; SI units.
    """

    def __init__(self, pair: Pair, omega: Fraction) -> None:
        """Enclose what w consists of, in the arithmetic's context."""
        m1, a1, a2, b = map(number, (pair.m1, pair.a1, pair.a2, pair.b))
        self.omega, self.beta = number(omega), number(pair.b / pair.m2)
        self.half = arb.pi() / self.omega
        (C, S), (pull, slope) = (flow(pair, self.half) + arb_mat([[1, 0], [0, 1]])).tolist()
        (x, v, _), below = pushed(pair, self.half), C * slope - S * pull
        # after half a period, in which 1 N pushes, h and h' have the opposite sign
        h, speed = (S * v - slope * x) / below, (pull * x - C * v) / below
        held = b * (1 - a2 * h)
        self.fading = arb_mat([[held / a2], [-b * speed]])
        self.V, self.reach = self.beta * self.half / 2 - b * speed, abs(impedance(pair, pair.m1, omega)) / self.omega
        self.least = (self.beta + (held - a1 * b * speed) / m1) / self.omega

    def amplitude(self, R: arb) -> arb:
        """Return the U to which an R belongs, N."""
        return self.reach * abs(acb(self.V, R))


def flow(pair: Pair, t: arb) -> arb_mat:
    """Return exp(A t) of body 1 alone: what a time (s) makes of (x1, v1)."""
    return (arb_mat([[0, 1], [number(-pair.a2 / pair.m1), number(-pair.a1 / pair.m1)]]) * t).exp()


def pushed(pair: Pair, t: arb) -> tuple[arb, arb, arb]:
    """Return where body 1 alone is under 1 N from rest after a time (s), its velocity g, and g'."""
    (C, S), (_, slope) = flow(pair, t).tolist()
    return (1 - C) / number(pair.a2), S / number(pair.m1), slope / number(pair.m1)
