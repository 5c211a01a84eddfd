"""The isotropic pair under a rotating force u = U (cos wt, sin wt), in closed form; clockwise, mirrored at the x axis.

With D = a2 - m1 w^2 + i a1 w and D_M = a2 - M w^2 + i a1 w there is one threshold, U* = b |D_M|/(m2 w^2): up to it the
pair sticks and rotates, above it body 2 slips with the constant speed rho = b p/(m2 w), p > 0 the root of

    |D|^2 p^2 + 2 a1 m2 w^3 p + |D_M|^2 = (U m2 w^2/b)^2,   s parallel to f, v2 = -i f/(m2 w).

Friction is a viscous damper b/rho across the slip and none along it: in the rotating frame all is linear, and constant
in time.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from flint import acb, arb, arb_mat

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball
from numerics.control.orbit import eigenvalues
from numerics.control.thresholds import entrainment_threshold, impedance, load_margin, round_pair
from numerics.errors import InvalidScene
from numerics.exits import tool
from numerics.scene import Pair
from numerics.scene.decimals import Exact, positive
from numerics.scene.plane import PlanePair, PlaneScene

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SPARE = 20


@dataclass(frozen=True)
class RotatingResponse:
    """The motion that rotates with the force; enclosures.

    Complex numbers are vectors (x + iy) e^{-iwt}, of a force that turns `clockwise` (x + iy) e^{iwt}.
    `threshold` U* (N); `speed` of the slip (m/s), 0 if stuck; `friction` f (N), `q1` (m), `v1` and `v2` (m/s) with the
    force U along x at t = 0; `exponents` (1/s) of perturbations of a slip in the rotating frame, none if stuck.
    `attracts`: whether every motion is proved to tend to it; for U < U* without a damper not every one does.

    >>> found = rotating_response(PlanePair(m1=1, m2=1, a2=200, b="0.5", a1=1), "0.5", 12)
    >>> [one.str(6, radius=False) for one in (found.threshold, found.speed, found.exponents[0].real)]
    ['0.308383', '0.0633854', '-1.86943']
    >>> found.sentence, found.attracts, abs(found.v2).str(6, radius=False)
    ('non-stop: body 2 slips on a circle at constant speed; there is no stick-slip, U** = U*', True, '0.0416667')
    """

    omega: Fraction
    amplitude: Fraction
    threshold: arb
    speed: arb
    friction: acb
    q1: acb
    v1: acb
    v2: acb
    exponents: tuple[acb, ...]
    attracts: bool
    clockwise: bool
    digits: int

    def plot(self) -> Figure:
        """Return a matplotlib figure: the circles of positions and velocities. Raises MissingTool."""
        return pictures().draw_rotating(self)

    @property
    def sentence(self) -> str:
        """Return the long-time behaviour as a sentence."""
        if self.speed.is_zero():
            return "entrained: a motion in which the bodies stick and rotate with the force, for U up to U*"
        return "non-stop: body 2 slips on a circle at constant speed; there is no stick-slip, U** = U*"


def pictures() -> Any:
    """Return what draws answers. Raises MissingTool."""
    return tool("numerics.control.pictures")


def rotating_response(
    pair: PlanePair, amplitude: Exact, omega: Exact, digits: int = 15, *, clockwise: bool = False
) -> RotatingResponse:
    """Return the motion of an isotropic pair that rotates with U (cos wt, sin wt), or with U (cos wt, -sin wt).

    Raises InvalidScene, EventUndecided (exponents that are not separated).
    """
    line, w = round_pair(pair), positive(omega, "omega", "give the frequency in rad/s")
    size = positive(amplitude, "amplitude", "give the size of the rotating force in N")
    m1, m2, a1, a2, b = line.m1, line.m2, line.a1, line.a2, line.b
    driven, slope = (a2 - m1 * w * w) ** 2 + (a1 * w) ** 2, a1 * m2 * w**3
    level = -load_margin(line, size, w) / b**2
    if level > 0 and not driven:
        raise InvalidScene("undamped body 1 is at resonance, and U > U*: there is no such motion; change omega or a1")

    def attempt(_: Ball) -> tuple[RotatingResponse, list[arb]]:
        n, i = Ball.number, acb(0, 1)
        p = n(level) / (n(slope * slope + driven * level).sqrt() + n(slope)) if level > 0 else arb(0)
        f = -n(m2 * w * w * size) / (impedance(line, line.mass, w) + i * p * impedance(line, m1, w))
        rho, v2 = n(b / (m2 * w)) * p, -i * f / n(m2 * w)
        v1 = v2 + f * (rho / n(b))
        attracts = bool(a1 > 0) or (level > 0 and a2 / m1 not in {w * w, w * w * 4})  # stuck, a free oscillation stays
        exponents = _exponents(line, w, rho) if level > 0 else ()
        vectors = f, v1 / (i * n(w)), v1, v2
        f, q1, v1, v2 = (one.conjugate() for one in vectors) if clockwise else vectors
        threshold, known = entrainment_threshold(line, w), [one.real for one in exponents]
        return RotatingResponse(w, size, threshold, rho, f, q1, v1, v2, exponents, attracts, clockwise, digits), known

    return to_digits(attempt, digits, spare=_SPARE)


def _exponents(line: Pair, w: Fraction, rho: arb) -> tuple[acb, ...]:
    """Return the six exponents, least damped first: eigenvalues for (x1, v1, v2), along the slip and across it."""
    n, m1, m2 = Ball.number, line.m1, line.m2
    turn, spring, viscous, across = n(w), n(-line.a2 / m1), n(-line.a1 / m1), n(line.b) / rho
    by_1, by_2 = across / n(m1), across / n(m2)
    matrix = [
        [0, turn, 1, 0, 0, 0],
        [-turn, 0, 0, 1, 0, 0],
        [spring, 0, viscous, turn, 0, 0],
        [0, spring, -turn, viscous - by_1, 0, by_1],
        [0, 0, 0, 0, 0, turn],
        [0, 0, 0, by_2, -turn, -by_2],
    ]
    return tuple(sorted(eigenvalues(arb_mat(matrix)), key=lambda one: -float(one.real.mid())))


def rotating_force(scene: PlaneScene, digits: int = 15) -> tuple[Fraction, Fraction, bool]:
    """Return U, omega, and whether it turns clockwise, of a scene whose force rotates.

    Its phases differ by pi/2 to `digits` digits. Raises InvalidScene.
    """
    refusal = InvalidScene(
        "the force does not rotate: give each of x and y one piece from 0 on with one sine of the same amplitude and "
        "omega, phases pi/2 apart to the digits requested"
    )
    pieces = [piece for one in scene.force for piece in one.pieces]
    turns = all(one.start == 0 and not one.polynomial and len(one.sines) == 1 for one in pieces)
    if scene.friction or len(pieces) != 2 or not turns:
        raise refusal
    x, y = (one.sines[0] for one in pieces)
    with Ball(digits + _SPARE).context():
        turn = abs(Ball.number(x.phase - y.phase)) - arb.pi() / 2
        if x.omega != y.omega or abs(x.amplitude) != abs(y.amplitude) or not abs(turn) < arb(10) ** (-digits):
            raise refusal
    return abs(x.amplitude), x.omega, x.amplitude * y.amplitude * (x.phase - y.phase) < 0
