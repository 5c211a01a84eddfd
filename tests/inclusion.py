"""Whether a run is the motion of its scene: at sampled times the inclusion itself, by differences of what was solved.

  x1' = v1,  x2' = v2,  m2 v2' = F,  m1 v1' + a1 v1 + a2 x1 + F = u,  F in b Sgn(v1 - v2)

with u and b as the scene gives them at the time, b also of |v1 - v2| and x1 - x2. No mode, no closed form and no guard
is used, and two motions from one start do not part: what passes everywhere is the motion. Samples crowd at both ends
of each piece and where friction is nearest to its limit, or v1 to v2, so that a short event that was passed over is
found too.
"""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

from flint import arb

from numerics import Law, Scene, solve
from numerics.arithmetic.ball import Ball

DIGITS = 60
SMALL, LEAST = arb(10) ** -20, arb(10) ** -50
"""What differences of so many digits leave of a sum of forces, and what rounding does."""
NEAR = [Fraction(1, 10**n) for n in (10, 5, 2)]
GRID = [*NEAR, *(Fraction(n, 12) for n in range(1, 12)), *(1 - one for one in reversed(NEAR))]


def solved(scene: Scene, **how: Any) -> Any:
    """Return a run in many digits."""
    return solve(scene, **{"arithmetic": "ball", "digits": DIGITS, "max_digits": 2000} | how)


def motion(scene: Scene, **how: Any) -> Any:
    """Return a run in many digits that was found to be the motion of its scene."""
    run = solved(scene, **how)
    assert not (found := next(faults(run), "")), found
    return run


def faults(run: Any, scene: Scene | None = None, digits: int = DIGITS) -> Iterator[str]:
    """Yield, in words, where a run is no motion of its scene, or of another one."""
    with Ball(digits).context():
        law, at = Inclusion(scene or run.scene), run.sol
        ends = [*run.row_times, run.end_time]
        if any(not (a - Ball.number(b)).contains(0) for a, b in zip(at(0), law.start, strict=True)):
            yield "another start"
        for k, (begin, end) in enumerate(pairwise(ends)):
            if not end > begin:
                continue
            if k and not all(a.overlaps(b) for a, b in zip(at(begin, "left"), at(begin, "right"), strict=True)):
                yield f"a jump of the state at {begin}"
            margins = []
            for part in GRID:
                wrong, margin = law.judge(at, begin.mid(), (end - begin).mid(), part, int(run.row_signs[k]))
                margins.append(margin)
                if wrong:
                    yield f"{wrong} at {begin} + {part} of a piece that ends at {end}"
            for low in nearest(margins):
                for n in range(1, 8):
                    part = GRID[low - 1] + (GRID[low + 1] - GRID[low - 1]) * n / 8
                    if wrong := law.judge(at, begin.mid(), (end - begin).mid(), part, int(run.row_signs[k]))[0]:
                        yield f"{wrong} at {begin} + {part} of a piece that ends at {end}"


def nearest(margins: list[arb]) -> list[int]:
    """Return where a margin is less than both of its neighbours."""
    return [k for k in range(1, len(margins) - 1) if margins[k - 1] > margins[k] < margins[k + 1]]


class Inclusion:
    """What a scene asks of a motion; in balls."""

    def __init__(self, scene: Scene) -> None:
        """Read the numbers."""
        number, pair, state = Ball.number, scene.pair, scene.initial
        self.m1, self.m2, self.a1, self.a2 = (number(getattr(pair, one)) for one in ("m1", "m2", "a1", "a2"))
        self.start, self.scene = (state.x1, state.v1, state.x2, state.v2), scene
        given = scene.friction.weakening
        self.speed = [(Fraction(0), pair.b), *given.speed] if given else [(Fraction(0), pair.b)]
        self.place, self.last = (given.place, given.last_slope) if given else ((), Fraction(0))
        self.rate = 1 + self.a1 / self.m1 + (self.a2 / self.m1).sqrt()
        self.rate += sum((number(one.omega) for piece in scene.force.pieces for one in piece.sines), arb(0))

    def force(self, t: arb) -> arb:
        """Return u(t)."""
        piece = next((one for one in reversed(self.scene.force.pieces) if t > Ball.number(one.start)), None)
        if piece is None:
            return arb(0)
        since, number = t - Ball.number(piece.start), Ball.number
        waves = (number(one.amplitude) * (number(one.omega) * t + number(one.phase)).sin() for one in piece.sines)
        return sum(waves, arb(0)) + sum((number(c) * since**k for k, c in enumerate(piece.polynomial)), arb(0))

    def friction(self, t: arb, w: arb, z: arb) -> arb:
        """Return the most that friction is."""
        now = [self.scene.pair.b, *(b for start, b in self.scene.friction.steps if t > Ball.number(start))][-1]
        last, number = self.speed[-1], Ball.number
        beyond = number(last[1]) + number(self.last) * (w - number(last[0]))
        of_place = table(self.place, z, number(self.place[-1][1])) if self.place else arb(0)
        return number(now / self.scene.pair.b) * (table(self.speed, w, beyond) + of_place)

    def judge(self, at: Any, begin: arb, length: arb, part: Fraction, sign: int) -> tuple[str, arb]:
        """Return what is wrong at a part of a piece, and how far friction or v1 - v2 is from another mode."""
        t = begin + length * Ball.number(part)
        step = min(length * Ball.number(min(part, 1 - part)), 1 / self.rate) * arb(10) ** -12

        def mean(a: arb, b: arb) -> arb:
            return (a + b) / 2

        def slope(a: arb, b: arb) -> arb:
            return (b - a) / (2 * step)

        around = [[one.mid() for one in at((t + k * step).mid())] for k in (-1, 1)]
        (x1, v1, x2, v2), slopes = ([f(a, b) for a, b in zip(*around, strict=True)] for f in (mean, slope))
        u, w, F = self.force(t), v1 - v2, self.m2 * slopes[3]
        most, small = self.friction(t, abs(w), x1 - x2), SMALL + LEAST / (step * self.rate)
        speed = abs(v1) + abs(v2) + (abs(x1) + abs(x2)) * self.rate
        slack = (abs(u) + most + (self.a1 + self.m1 * self.rate + self.m2 * self.rate) * speed) * small
        if not max(abs(slopes[0] - v1), abs(slopes[2] - v2)) <= small * speed:
            return "a velocity that is none", arb(0)
        if not abs(self.m1 * slopes[1] + self.a1 * v1 + self.a2 * x1 + F - u) <= slack:
            return "forces that do not balance", arb(0)
        if sign == 0:
            holds = abs(w) <= small * speed and (self.scene.law is not Law.FILIPPOV or abs(F) <= most + slack)
            return "" if holds else "no stick", most - abs(F)
        return "" if sign * w >= -small * speed and abs(F - sign * most) <= slack else "no slip", sign * w


def table(points: Any, at: arb, beyond: arb) -> arb:
    """Interpolate linearly; below the first point it is the first one's value."""
    number = Ball.number
    if at <= number(points[0][0]):
        return number(points[0][1])
    for (a, f), (b, g) in pairwise(points):
        if at <= number(b):
            return number(f) + (at - number(a)) * number((g - f) / (b - a))
    return beyond
