"""Whether a run is the motion of its scene: at sampled times the inclusion itself, by differences of what was solved.

  x1' = v1,  x2' = v2,  m2 v2' = F + f (on a belt v2 = c),  m1 v1' + a1 (v1 - y') + a2 (x1 - y) + F = u,
  F in b Sgn(v1 - v2), at rest up to the static friction

with the forces u and f, the wall's place y, the belt's speed c and b as the scene gives them at the time, b also of
|v1 - v2| and x1 - x2. No mode, no closed form and no guard is used, and two motions from one start do not part: what
passes everywhere is the motion; up to where friction at rest is more than in slip: from v1 = v2 a slip may begin only
where a stick would need more than that. Samples crowd at both ends of each piece and where friction is nearest to its
limit, or v1 to v2, so that a short event that was passed over is found too.
"""

from collections.abc import Iterator
from fractions import Fraction
from functools import partial
from itertools import pairwise
from typing import Any

import overlapping
from flint import arb

from numerics import Law, Scene, solve
from numerics.arithmetic.ball import Ball

DIGITS = 60
SMALL, LEAST = arb(10) ** -20, arb(10) ** -50
"""What differences of so many digits leave of a sum of forces, and what rounding does."""
NEAR = [Fraction(1, 10**n) for n in (18, 10, 5, 2)]
GRID = [*NEAR, *(Fraction(n, 12) for n in range(1, 12)), *(1 - one for one in reversed(NEAR))]


def solved(scene: Scene, **how: Any) -> Any:
    """Return a run in many digits."""
    return solve(scene, **{"arithmetic": "ball", "digits": DIGITS, "max_digits": 2000} | how)


def motion(scene: Scene, **how: Any) -> Any:
    """Return a run in many digits that was found to be the motion of its scene."""
    run = solved(scene, **how)
    assert not (found := next(faults(run), "")), found
    return run


def overlap(one: Any, two: Any) -> bool:
    """Return whether two runs in balls may be of the same motion."""
    return overlapping.overlap(*((run.signs, run.event_times, run.event_states, run.final_state) for run in (one, two)))


def faults(run: Any, scene: Scene | None = None, digits: int = DIGITS) -> Iterator[str]:
    """Yield, in words, where a run is no motion of its scene, or of another one."""
    with Ball(digits).context():
        law, at = Inclusion(scene or run.scene), run.sol
        ends, given = [*run.row_times, run.end_time], 3 if law.m2 is None else 4  # a belt's speed may jump
        if any(not (a - Ball.number(b)).contains(0) for a, b in list(zip(at(0), law.start, strict=True))[:given]):
            yield "another start"
        for k, (begin, end) in enumerate(pairwise(ends)):
            if not end > begin:
                continue
            sides = list(zip(at(begin, "left"), at(begin, "right"), strict=True))[:given]
            if k and not all(a.overlaps(b) for a, b in sides):
                yield f"a jump of the state at {begin}"
            judged = partial(law.judge, at, begin.mid(), (end - begin).mid(), sign=int(run.row_signs[k]))
            _, v1, _, v2 = at(begin, "right")
            found = {GRID[0]: judged(GRID[0], leaves=bool(v1.overlaps(v2)))}
            found |= {part: judged(part) for part in GRID[1:]}
            around = [(GRID[k - 1], GRID[k + 1]) for k in nearest([margin for _, margin in found.values()])]
            finer = (low + (high - low) * n / 8 for low, high in around for n in range(1, 8))
            for part, (wrong, _) in (found | {part: judged(part) for part in finer}).items():
                if wrong:
                    yield f"{wrong} at {begin} + {part} of a piece that ends at {end}"


def nearest(margins: list[arb]) -> list[int]:
    """Return where a margin is less than both of its neighbours."""
    return [k for k in range(1, len(margins) - 1) if margins[k - 1] > margins[k] < margins[k + 1]]


class Inclusion:
    """What a scene asks of a motion; in balls."""

    def __init__(self, scene: Scene) -> None:
        """Read the numbers."""
        number, pair, state, self.scene = Ball.number, scene.pair, scene.initial, scene
        self.m1, self.a1, self.a2, self.b = (number(getattr(pair, one)) for one in ("m1", "a1", "a2", "b"))
        self.m2 = None if pair.is_fixed else number(pair.m2)
        self.start = state.x1, state.v1, state.x2, state.v2
        self.most_at_rest = number(pair.b_static / pair.b) if pair.b_static else arb(1)
        given = scene.friction.weakening
        self.speed = [(Fraction(0), pair.b), *given.speed] if given else []
        self.place, self.last = (given.place, given.last_slope) if given else ((), Fraction(0))
        self.rate = 1 + self.a1 / self.m1 + (self.a2 / self.m1).sqrt()
        sines = (sine for pieces in scene.pieces.values() for piece in pieces for sine in piece.sines)
        self.rate += sum((number(one.omega) for one in sines), arb(0))

    def signal(self, name: str, t: arb, before: arb | int = 0) -> arb:
        """Return a signal at a time; `before`: what it is before its first piece."""
        pieces, number = self.scene.pieces[name], Ball.number
        piece = next((one for one in reversed(pieces) if t > number(one.start)), None)
        if piece is None:
            return arb(before)
        since = t - number(piece.start)
        waves = (number(one.amplitude) * (number(one.omega) * t + number(one.phase)).sin() for one in piece.sines)
        return sum(waves, arb(0)) + sum((number(c) * since**k for k, c in enumerate(piece.polynomial)), arb(0))

    def friction(self, t: arb, w: arb, z: arb) -> arb:
        """Return the most that friction is in slip."""
        b, number = self.signal("friction", t, self.b), Ball.number
        if not self.speed:
            return b
        last = self.speed[-1]
        beyond = number(last[1]) + number(self.last) * (w - number(last[0]))
        of_place = table(self.place, z, number(self.place[-1][1])) if self.place else arb(0)
        return b / self.b * (table(self.speed, w, beyond) + of_place)

    def judge(
        self, at: Any, begin: arb, length: arb, part: Fraction, sign: int, leaves: bool = False
    ) -> tuple[str, arb]:
        """Return what is wrong at a part of a piece, and how far friction or v1 - v2 is from another mode.

        `leaves`: it has just left v1 = v2, if it is a slip.
        """
        t = begin + length * Ball.number(part)
        step = min(length * Ball.number(min(part, 1 - part)), 1 / self.rate) * arb(10) ** -12
        times = (t - step).mid(), (t + step).mid()
        around = [[one.mid() for one in (*at(now), self.signal("wall", now))] for now in times]
        x1, v1, x2, v2, y = ((a + b) / 2 for a, b in zip(*around, strict=True))
        dx1, dv1, dx2, dv2, dy = ((b - a) / (2 * step) for a, b in zip(*around, strict=True))
        u, f, c = (self.signal(name, t) for name in ("force", "force_2", "belt"))
        w, small = v1 - v2, SMALL + LEAST / (step * self.rate)
        rest, most = u - self.a2 * (x1 - y) - self.a1 * (v1 - dy) - self.m1 * dv1, self.friction(t, abs(w), x1 - x2)
        F = rest if self.m2 is None else self.m2 * dv2 - f
        speed = abs(v1) + abs(v2) + abs(dy) + (abs(x1) + abs(x2) + abs(y)) * self.rate
        slack = (abs(u) + abs(f) + most + (self.a1 + (self.m1 + (self.m2 or 0)) * self.rate) * speed) * small
        if not max(abs(dx1 - v1), abs(dx2 - v2)) <= small * speed:
            return "a velocity that is none", arb(0)
        if self.m2 is None and not abs(v2 - c) <= small * (speed + abs(c)):
            return "another speed than the belt's", arb(0)
        if not abs(rest - F) <= slack:
            return "forces that do not balance", arb(0)
        if sign == 0:
            most = most * self.most_at_rest
            holds = abs(w) <= small * speed and (self.scene.law is not Law.FILIPPOV or abs(F) <= most + slack)
            return "" if holds else "no stick", most - abs(F)
        if leaves and not self.breaks(sign * (dv1 - dv2), most, slack):
            return "a slip that begins too early", arb(0)
        return "" if sign * w >= -small * speed and abs(F - sign * most) <= slack else "no slip", sign * w

    def breaks(self, leaving: arb, most: arb, slack: arb) -> bool:
        """Return whether a stick would need more than friction at rest: as much more as v1 - v2 grows by in slip.

        To within `slack`, N: without static friction it grows by nothing at first.
        """
        moved = self.m1 if self.m2 is None else self.m1 * self.m2 / (self.m1 + self.m2)
        too_little = leaving * moved < most * (self.most_at_rest - 1) * (1 - arb("1e-9")) - slack
        return self.scene.law is Law.FILIPPOV and not too_little


def table(points: Any, at: arb, beyond: arb) -> arb:
    """Interpolate linearly; below the first point it is the first one's value."""
    number = Ball.number
    if at <= number(points[0][0]):
        return number(points[0][1])
    for (a, f), (b, g) in pairwise(points):
        if at <= number(b):
            return number(f) + (at - number(a)) * number((g - f) / (b - a))
    return beyond
