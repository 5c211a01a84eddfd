"""The forward Euler method itself, without rounding: each of its steps in balls, each sign proved (a1 = 0).

`numerics.trade.forward_euler` is the program, in binary64; this is the method that it rounds.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from flint import acb, arb

from numerics.arithmetic.ball import Ball, proved_sign
from numerics.scene import Scene
from numerics.scene.file import load_scene

STEPS = tuple(Fraction(text) for text in ("1e-2", "1e-3", "2e-4", "1e-4", "5e-5", "1e-5"))
"""The steps tried, s."""
COARSE = Fraction(1, 1000)
"""A step, s, from which on the first adhesion of Fig. 5 (a) comes more than a second late, if ever."""
HORIZONS = {"start-with-speed": 1, "relative-motion-b02": 2, "velocities": 5}
"""How far each scene is run, s: past its first adhesion."""
DIGITS = 80
"""Working digits; the balls of a rotation widen by about 14 digits in a second of the case study."""
BALL, ZERO = Ball(DIGITS), arb(0)
SINGLE, MOST = 16, 14
"""Steps one by one before many are tried, and the most that are: 2^14."""


@dataclass(frozen=True)
class EnclosedEulerRun:
    """What was proved about a forward Euler run of `steps` steps of `step` s."""

    step: Fraction
    steps: int
    contact: int | None
    """The first step at which z' = 0 exactly, where the two readings of sgn(0) part and the run ends."""
    chatter: int
    """Pairs of consecutive steps, both in |x1| <= L, between which z' changes its sign."""
    adhesion: int | None
    """The first step after such a change: where the run first sticks. None if it never does."""
    energy_ratio: arb
    """E at the end over E at the start, dimensionless."""

    @property
    def adhesion_time(self) -> Fraction | None:
        """Time of the first adhesion, s, exact."""
        return None if self.adhesion is None else self.adhesion * self.step


def euler_in_balls(scene: Scene, step: Fraction, until: Fraction) -> EnclosedEulerRun:
    """Run forward Euler from a state with z' != 0 up to `until` s, or to its first step with z' = 0.

    Raises EventUndecided where a sign is not proved at `DIGITS`, ValueError for a1 > 0 or a start with z' = 0.
    """
    pair, at = scene.pair, scene.initial
    if pair.a1 or at.v1 == at.v2:
        raise ValueError("a1 must be 0 and the start must slip")
    with BALL.context():
        number = BALL.number
        h, width = number(step), number(pair.half_width)
        spring = -number(step * pair.a2 / pair.m1)
        push, driven = ({s: -s * number(step * pair.b / mass) for s in (1, -1)} for mass in (pair.m1, pair.m2))
        x1, v1, relative = number(at.x1), number(at.v1), number(at.v1 - at.v2)
        steps, contact, chatter, adhesion = int(until / step), None, 0, None
        sign = 1 if at.v1 > at.v2 else -1
        many = _ManySteps(scene, step)
        n = since = 0  # steps, and those of them up to the last change of sign, or up to where many at once did not go
        while n < steps:
            if n - since >= SINGLE:
                if (power := many.power(x1, v1, relative, sign, steps - n)) is not None:
                    n += 1 << power
                    before_jump = v1
                    x1, v1 = many.after(x1, v1, sign, power)
                    relative = relative + v1 - before_jump + driven[sign] * (1 << power)
                    continue
                since = n
            n += 1
            before, dv1 = x1, spring * x1 + push[sign]
            x1, v1, relative = x1 + h * v1, v1 + dv1, relative + dv1 + driven[sign]
            if relative > ZERO if sign > 0 else relative < ZERO:
                continue
            sign, since = -sign, n
            if _sign(relative, "sign of the relative velocity", n) == 0:
                steps = contact = n
                break
            if _in_strip(before, width, n) and _in_strip(x1, width, n):
                chatter += 1
                adhesion = adhesion or n
        v2 = v1 - relative
        energy = number(pair.a2) * x1 * x1 + number(pair.m1) * v1 * v1 + number(pair.m2) * v2 * v2
        return EnclosedEulerRun(step, steps, contact, chatter, adhesion, energy / number(2 * scene.energy))


class _ManySteps:
    """Many steps of one slip at once, as far as the relative velocity is proved to keep its sign.

    With z = (x1 - centre) + i v1/omega, omega^2 = a2/m1, a step is z -> (1 - i h omega) z: 2^k of them are a product.
    """

    def __init__(self, scene: Scene, step: Fraction) -> None:
        """Find the products, and by how much all steps of each can change the relative velocity: by |z|, and beside it."""
        number, pair = BALL.number, scene.pair
        self.centre, self.omega = number(pair.b / pair.a2), number(pair.a2 / pair.m1).sqrt()
        self.products = [acb(1, -number(step) * self.omega)]
        for _ in range(MOST):
            self.products.append(self.products[-1] ** 2)
        spring, driven = number(step * pair.a2 / pair.m1), number(step * pair.b / pair.m2)
        self.changes = [(spring * abs(one) * (1 << k), driven * (1 << k)) for k, one in enumerate(self.products)]

    def _turned(self, x1: arb, v1: arb, sign: int) -> acb:
        return acb(x1 + sign * self.centre, v1 / self.omega)

    def power(self, x1: arb, v1: arb, relative: arb, sign: int, left: int) -> int | None:
        """Return a k for which 2^k steps are no more than are left and keep the sign; None where k would be small."""
        size, least = abs(self._turned(x1, v1, sign)), abs(relative)
        for power in range(min(MOST, left.bit_length() - 1), SINGLE.bit_length() - 2, -1):
            # |x1 - centre| is at most |z| all the way, which grows
            of_spring, of_friction = self.changes[power]
            if of_spring * size + of_friction < least:
                return power
        return None

    def after(self, x1: arb, v1: arb, sign: int, power: int) -> tuple[arb, arb]:
        """Return x1 and v1 after 2^power steps."""
        found = self._turned(x1, v1, sign) * self.products[power]
        return found.real - sign * self.centre, found.imag * self.omega


def _sign(value: arb, question: str, step: int) -> int:
    """Return a sign that is proved; the question's whole text is made only where it is not."""
    return 1 if value > ZERO else -1 if value < ZERO else proved_sign(value, f"{question} at Euler step {step}")


def _in_strip(x1: arb, width: arb, step: int) -> bool:
    """Return whether |x1| <= L, proved."""
    size = abs(x1)
    return size <= width or _sign(size - width, "in the strip?", step) <= 0


@cache
def run(name: str, step: Fraction) -> EnclosedEulerRun:
    """Return forward Euler of a shipped scene of `HORIZONS` with a step (s); two seconds longer where it is coarse."""
    return euler_in_balls(load_scene(name), step, Fraction(HORIZONS[name] + (2 if step >= COARSE else 0)))
