"""An independent solver of every scene: Taylor steps of the linear equations; of numerics/ it has the scene alone.

From eqs (2)-(4), with b the friction in force at the time, beta = b/m2 and M = m1 + m2:
  slip s   m1 x1'' + a1 x1' + a2 x1 = u - s b,  v2' = s beta         stick   M x1'' + a1 x1' + a2 x1 = u,  v2 = v1
Friction has to supply m2 x1'' in stick, so stick is possible while b -+ m2 x1'' >= 0: the guards of stick; that of a
slip is s (v1 - v2). A step takes the Taylor polynomial of x1, so long that its remainder is below rounding; the first
zero of a guard on it is found without sampling (forced/first_roots.py). No closed form of a motion is used.

Which mode follows where v1 = v2 = v: let y = x1 + v t + s beta t^2/2, the motion with the whole friction of sign s, and
  p(t) = u - a2 y - a1 y' - M s beta.
With e = x1 - y: in slip s, m1 e'' + a1 e' + a2 e = p and v1 - v2 = e'; in stick, M e'' + a1 e' + a2 e = p and
m2 x1'' - s b = m2 e''. Both from e = e' = 0, so if p = p_k t^k + ..., slip s moves apart in its own sense if and only
if s p_k > 0, and stick stays within that edge if and only if s p_k <= 0. Where neither s slips, the pair sticks.

What is zero exactly is told from what is not by size: below 10^(-5/8 digits) of its terms. Approximate; two runs with
different digits and steps say how good it is. Units: SI. The law is Filippov's.
"""

from fractions import Fraction
from typing import NamedTuple

from flint import arb, arb_poly, ctx
from forced.first_roots import Zeros

from numerics import Law, Scene


class Event(NamedTuple):
    """A change of mode; cause "guard", "jump", or "both" where a guard's zero falls on a jump of u or b."""

    t: arb
    before: int
    after: int
    cause: str
    y: tuple[arb, arb, arb, arb]


def number(exact: Fraction) -> arb:
    return arb(exact.numerator) / exact.denominator


class Force:
    """u(t): the normalised Taylor coefficients u^(k) h^k/k!, and the sizes of their terms."""

    def __init__(self, scene: Scene):
        pieces = scene.force.pieces
        self.starts = [one.start for one in pieces]
        self.polynomials = [[number(c) for c in one.polynomial] for one in pieces]
        self.sines = [
            [(number(sine.amplitude), number(sine.omega), number(sine.phase)) for sine in one.sines] for one in pieces
        ]

    def piece(self, at: Fraction) -> int:
        """The piece in force from `at` on; -1 before the first."""
        return sum(start <= at for start in self.starts) - 1

    def fastest(self, piece: int) -> arb:
        return max((omega for _, omega, _ in self.sines[piece]), default=arb(0)) if piece >= 0 else arb(0)

    def series(self, piece: int, t: arb, h: arb, terms: int) -> tuple[list[arb], list[arb]]:
        values, sizes = [arb(0)] * terms, [arb(0)] * terms
        if piece < 0:
            return values, sizes
        since = t - number(self.starts[piece])
        moved = arb_poly(self.polynomials[piece])(arb_poly([since, h])).coeffs()
        large = arb_poly([abs(c) for c in self.polynomials[piece]])(arb_poly([abs(since), h])).coeffs()
        for k, (one, two) in enumerate(zip(moved, large, strict=False)):
            values[k], sizes[k] = one, two
        for amplitude, omega, phase in self.sines[piece]:
            sin, cos = (omega * t + phase).sin_cos()
            turning, factor = (sin, cos, -sin, -cos), amplitude
            for k in range(terms):
                values[k], sizes[k] = values[k] + factor * turning[k % 4], sizes[k] + abs(factor)
                factor = factor * omega * h / (k + 1)
        return values, sizes


class Motion(NamedTuple):
    """One step on the unit interval: x1, v1 and v2 as polynomials, and the guards with their leading zeros gone."""

    x1: arb_poly
    v1: arb_poly
    v2: arb_poly
    guards: list[Zeros]


class Reference:
    """Runs a scene."""

    def __init__(self, scene: Scene, digits: int = 120, radians: float = 2):
        self.scene, self.digits, self.radians = scene, digits, radians

    def run(self) -> "Reference":
        before, ctx.dps = ctx.dps, self.digits
        try:
            self._begin()
            self._walk()
        finally:
            ctx.dps = before
        return self

    def _begin(self) -> None:
        pair, start, self.until = self.scene.pair, self.scene.initial, self.scene.until
        self.m1, self.m2, self.a1, self.a2, self.b = map(number, (pair.m1, pair.m2, pair.a1, pair.a2, pair.b))
        self.x1, self.v1, self.x2, self.v2 = map(number, (start.x1, start.v1, start.x2, start.v2))
        self.M, self.force = self.m1 + self.m2, Force(self.scene)
        self.friction = {at: number(b) for at, b in self.scene.friction.steps}
        jumps = {*self.force.starts, *self.friction, Fraction(0)}
        self.times = [*sorted(at for at in jumps if 0 <= at < self.until), self.until]
        self.far, self.fast = max(abs(self.x1), abs(self.x2)), max(abs(self.v1), abs(self.v2))
        self.tie = arb(10) ** (-5 * self.digits // 8)
        self.t, self.mode, self.events = arb(0), None, []
        reach, self.terms = arb(1), 0
        while reach > arb(10) ** (-10 - self.digits) or self.terms < 12:
            self.terms += 1
            reach = reach * arb(self.radians) / self.terms
        self.terms = max(self.terms, *(len(one) + 3 for one in [[], *self.force.polynomials]))

    @property
    def modes(self) -> list[int]:
        """The modes in their order, the sign of v1 - v2."""
        first = self.events[0].before if self.events else self.mode
        return [first, *(event.after for event in self.events)]

    def rate(self, mode: int) -> arb:
        """No mode of the motion, and no sine of the force, is faster, 1/s."""
        mass = self.m1 if mode else self.M
        return max(self.a1 / mass + (self.a2 / mass).sqrt(), self.force.fastest(self.piece))

    def _walk(self) -> None:
        met, apart = False, self.v1 - self.v2
        if apart != 0:
            self.mode = 1 if apart > 0 else -1
        for at, end in zip(self.times, self.times[1:], strict=False):
            self.piece, self.b, self.t = self.force.piece(at), self.friction.get(at, self.b), number(at)
            if self.mode is None or self.mode == 0 or met:
                self.change("both" if met else "jump")
            met = self._segment(number(end))
        self.t = number(self.until)

    def _segment(self, end: arb) -> bool:
        """Up to the next jump; whether a guard has a zero exactly there."""
        while True:
            h = min(arb(self.radians) / self.rate(self.mode), (end - self.t).mid())
            last = bool(self.t + h >= end * (1 - self.tie))
            motion = self.motion(h)
            zeros = [zero for zero in (guard.first() for guard in motion.guards) if zero is not None]
            zero = min(zeros, default=None)
            met = zero is not None and last and bool((1 - zero) * h <= self.tie * (end + h))
            self.move(motion, arb(1) if zero is None or met else zero, h)
            if zero is not None:
                self.v2 = self.v1  # in stick it is so already
            if met or (last and zero is None):
                return met
            if zero is not None:
                self.change("guard")

    def change(self, cause: str) -> None:
        """Decide the mode on v1 = v2; keep an event if it is one."""
        before, self.mode = self.mode, self.decided()
        if before is not None and before != self.mode:
            self.events.append(Event(self.t, before, self.mode, cause, self.state()))

    def state(self) -> tuple[arb, arb, arb, arb]:
        return self.x1, self.v1, self.x2, self.v2

    def decided(self) -> int:
        """The mode right after t where v1 = v2: slip s if the first coefficient of s p that is not zero is positive."""
        if self.scene.law is not Law.FILIPPOV:
            return 0
        h = arb(self.radians) / self.rate(1)
        u, sizes = self.force.series(self.piece, self.t, h, self.terms)
        beta = self.b / self.m2
        for s in (1, -1):
            values, large = list(u), list(sizes)
            values[0] -= self.a2 * self.x1 + self.a1 * self.v1 + s * self.M * beta
            values[1] -= (self.a2 * self.v1 + self.a1 * s * beta) * h
            values[2] -= self.a2 * s * beta * h * h / 2
            large[0] += self.a2 * self.far + self.a1 * self.fast + self.M * beta
            large[1] += (self.a2 * self.fast + self.a1 * beta) * h
            large[2] += self.a2 * beta * h * h / 2
            for value, size in zip(values, large, strict=True):
                if abs(value.mid()) > self.tie * size:
                    if s * value.mid() > 0:
                        return s
                    break
        return 0

    def motion(self, h: arb) -> Motion:
        """The Taylor polynomials of one step of length h, scaled to the unit interval."""
        s, mass, beta = self.mode, self.m1 if self.mode else self.M, self.b / self.m2
        u, sizes = self.force.series(self.piece, self.t, h, self.terms)
        pushed = list(u)
        pushed[0] -= s * self.b
        x, damping, spring = [self.x1, self.v1 * h], self.a1 * h, self.a2 * h * h
        for k in range(self.terms - 2):
            right = pushed[k] * h * h - damping * (k + 1) * x[k + 1] - spring * x[k]
            x.append((right / (mass * ((k + 1) * (k + 2)))).mid())
        x1 = arb_poly(x)
        v1 = x1.derivative() * (1 / h)
        if s:
            v2 = arb_poly([self.v2, s * beta * h])
            scale = self.fast + beta * h + Zeros.bound(v1)
            guards = [(s * (v1 - v2), scale)]
        else:
            v2, load = v1, v1.derivative() * (self.m2 / h)
            scale = self.b + self.m2 / self.M * (sum(sizes, arb(0)) + self.a2 * self.far + self.a1 * self.fast)
            guards = (
                []
                if self.scene.law is not Law.FILIPPOV
                else [(arb_poly([self.b]) - load, scale), (arb_poly([self.b]) + load, scale)]
            )
        return Motion(x1, v1, v2, [self.guard(one, scale) for one, scale in guards])

    def guard(self, polynomial: arb_poly, scale: arb) -> Zeros:
        """Its zeros after the start: a zero at the start, of any order, is divided out."""
        values, k = polynomial.coeffs(), 0
        while k < len(values) and abs(values[k].mid()) <= self.tie * scale:
            k += 1
        if k < len(values) and not values[k].mid() > 0:
            raise ArithmeticError(f"mode {self.mode} cannot begin at t = {self.t.str(20, radius=False)}")
        return Zeros(arb_poly(values[k:]), self.tie * scale)

    def move(self, motion: Motion, to: arb, h: arb) -> None:
        """Go to the point `to` of the unit interval."""
        x1, v1, v2 = (polynomial(to).mid() for polynomial in motion[:3])
        self.x2 = (self.x2 + motion.v2.integral()(to) * h).mid() if self.mode else (self.x2 + x1 - self.x1).mid()
        self.x1, self.v1, self.v2, self.t = x1, v1, v2, (self.t + to * h).mid()
        self.far = max(self.far, abs(self.x1), abs(self.x2))
        self.fast = max(self.fast, abs(self.v1), abs(self.v2))
