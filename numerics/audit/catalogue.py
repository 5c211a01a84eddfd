"""The formulas of flow, guard, excursion and energy that claim relative accuracy, each beside its definition in balls.

Where the definition is an equation (the slip angle) or the formula is already the shortest one, the same text is
evaluated at 300 bits: what is measured then is the rounding, and the enclosures are tried elsewhere.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from random import Random

from flint import arb

from numerics.arithmetic import elementary, float64
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import BALL
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.protocol import Number
from numerics.audit.formulas import Arguments, Formula
from numerics.contact.seed import positive_root
from numerics.contact.surface import contact
from numerics.flows.oscillator import log_quotient, oscillator
from numerics.motion.codes import STICK
from numerics.motion.frame import Frame
from numerics.motion.tellings import motion_telling
from numerics.motion.undamped import Pair as UndampedPair
from numerics.motion.undamped import Start, locate
from numerics.scene import Pair

_FLOAT = Float64()
_FRAME = Frame(_FLOAT, Pair(1, 2, 1, 1))
_PAIR = UndampedPair(_FRAME.q, _FRAME.r, _FRAME.sqrt_q, 0.0, literal=False)
_CONTACT = motion_telling(BALL, is_damped=False)(contact)
_TURN = 2 * math.pi


def formulas() -> tuple[Formula, ...]:
    """Return all of them; the range of each is where its value is a normal binary64 number."""
    return (*_library(), *_deficits(), *_motions(), *_constants())


def _library() -> tuple[Formula, ...]:
    """Functions of the C library: not ours, but every bound stands on them."""
    return (
        Formula("cos x", lambda x: float64.sine_cosine(x)[1], lambda x: x.cos(), 1e-300, 1e300),
        Formula("sin x", lambda x: float64.sine_cosine(x)[0], lambda x: x.sin(), 1e-300, 1e300),
        Formula("exp x", float64.exp, lambda x: x.exp(), 1e-300, 700.0, _either_sign),
        Formula("expm1 x, x <= 0", float64.expm1, lambda x: x.expm1(), 1e-300, 1e4, lambda _, x: (-x,)),
        Formula("log x", float64.log, lambda x: x.log(), 1e-300, 1e300),
        Formula("log1p x, |x| < 1/2", float64.log1p, lambda x: x.log1p(), 1e-300, 0.5, _either_sign),
        Formula("atan2(y, x) by y/x", float64.atan2, arb.atan2, 1e-200, 1e200, _point_of_slope),
    )


def _deficits() -> tuple[Formula, ...]:
    return (
        Formula("versine: 1 - cos x", float64.versine, lambda x: 1 - x.cos(), 1e-153, 1e300),
        Formula("sine deficit: x - sin x", float64.sine_deficit, lambda x: x - x.sin(), 1e-102, 1e300),
        Formula(
            "cosine deficit: x^2/2 - 1 + cos x",
            float64.cosine_deficit,
            lambda x: x * x / 2 - 1 + x.cos(),
            1e-76,
            1e150,
        ),
        Formula("lag: sin x - x cos x", elementary.lag, lambda x: x.sin() - x * x.cos(), 1e-102, math.pi),
        Formula(
            "rise: (x - sin x)/(1 - cos x)", elementary.rise, lambda x: (x - x.sin()) / (1 - x.cos()), 1e-300, _TURN
        ),
        Formula("depth: 2 - x cot(x/2)", elementary.depth, lambda x: 2 - x * (x / 2).cot(), 1e-153, _TURN),
    )


def _motions() -> tuple[Formula, ...]:
    return (
        Formula(
            "bracket: b + sqrt(b^2 + c)",
            positive_root,
            lambda b, c: b + (b * b + c).sqrt(),
            1e-100,
            1e100,
            lambda random, x: (random.choice((-1, 1)) * x, x * x * 10.0 ** random.uniform(-12, 12)),
        ),
        Formula(
            "slip angle of a ray by its push",
            lambda u: contact(0.0, u).theta,
            lambda u: _CONTACT(arb(0), u).theta,
            1e-96,
            1e9,
            cost=20,
        ),
        Formula(
            "stick angle to the exit by w",
            _stick_angle,
            _exact_stick_angle,
            1e-300,
            1e6,
            _inside_the_edge,
        ),
        Formula(
            "slow rate k/(d + n) by n/d",
            lambda n, d, k: oscillator(d, k, -1, n).slow,
            lambda n, d, k: k / (d + n),
            1e-100,
            1.0,
            _overdamped,
        ),
        Formula(
            "logarithm of a quotient by its excess over 1",
            lambda base, excess: log_quotient(base, base + excess, excess),
            lambda base, excess: (excess / base).log1p(),
            1e-100,
            1e100,
            lambda random, x: (1.0, x if x >= 0.5 else random.choice((-1, 1)) * x),
        ),
    )


def _constants() -> tuple[Formula, ...]:
    """The constants of a pair by m1/m2, and its energy; parameters are exact, so the truth is that of rationals."""
    return (
        Formula("half width L by m1/m2", _constant("length"), _exact("half_width"), 1e-150, 1e130, _parameters, 10),
        Formula("speed L Omega by m1/m2", _constant("speed"), _exact_speed, 1e-150, 1e130, _parameters, 10),
        Formula("2 zeta by m1/m2", _constant("two_zeta"), _exact_two_zeta, 1e-150, 1e130, _parameters, 10),
        Formula(
            "E_cr by m1/m2", _constant("critical_energy"), _exact("critical_energy"), 1e-150, 1e130, _parameters, 10
        ),
        Formula(
            "E/E_cr: X^2 + q V1^2 + r V2^2 by X",
            _FRAME.energy_ratio,
            lambda X, V1, V2: X * X + arb(_FRAME.q) * V1 * V1 + arb(_FRAME.r) * V2 * V2,
            1e-100,
            1e100,
            lambda random, x: (x, x * 10.0 ** random.uniform(-9, 9), x * 10.0 ** random.uniform(-9, 9)),
        ),
    )


def _either_sign(random: Random, x: float) -> Arguments:
    return (random.choice((-1, 1)) * x,)


def _point_of_slope(random: Random, slope: float) -> Arguments:
    x = 10.0 ** random.uniform(-3, 3)
    return random.choice((-1, 1)) * slope * x, random.choice((-1, 1)) * x


def _overdamped(random: Random, ratio: float) -> Arguments:
    decay = 10.0 ** random.uniform(-9, 9)
    return ratio * decay, decay, decay * decay * random.random()


def _inside_the_edge(random: Random, w: float) -> Arguments:
    """Return (w, offset, v) of a stuck pair at X = 1 + offset: v^2 = w + 1 - X^2, up to its rounding."""
    offset = -min(2.0, 10.0 ** random.uniform(-12, 0.3))
    return w, offset, math.sqrt(w - offset * (2 + offset))


def _stick_angle(w: float, offset: float, v: float) -> Number:
    start = Start(STICK, 1.0, 1 + offset, 0.0, offset, v, 0.0, True, 0.0, w, 0.0, 0.0, 0.0)
    return locate(_PAIR, start)[1]


def _exact_stick_angle(w: arb, offset: arb, v: arb) -> arb:
    """Half the angle between (X, V) and (1, sqrt w) has this tangent; the three arguments are rounded one by one."""
    return 2 * (-offset / (v + w.sqrt())).atan()


def _parameters(random: Random, ratio: float) -> Arguments:
    """Return m1, m2, a2, b, a1."""
    small = [10.0 ** random.uniform(-9, 9) for _ in range(4)]
    return ratio * small[0], *small


def _pair(parameters: Arguments) -> Pair:
    return Pair(*(Fraction(one) for one in parameters))


def _constant(name: str) -> Callable[..., float]:
    """Return a constant of the frame as a function of the parameters."""
    return lambda *parameters: getattr(Frame(_FLOAT, _pair(parameters)), name)


def _exact(name: str) -> Callable[..., arb]:
    """Return a rational property of the pair as a function of the parameters."""
    return lambda *parameters: Ball.number(getattr(_pair(tuple(float(one) for one in parameters)), name))


def _exact_speed(*parameters: arb) -> arb:
    pair = _pair(tuple(float(one) for one in parameters))
    return Ball.number(pair.half_width**2 * pair.a2 / pair.mass).sqrt()


def _exact_two_zeta(*parameters: arb) -> arb:
    pair = _pair(tuple(float(one) for one in parameters))
    return Ball.number(pair.a1**2 / (pair.a2 * pair.mass)).sqrt()
