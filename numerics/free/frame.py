"""Reduced coordinates, in which the free pair has one parameter; how a run starts in them, every sign decided exactly.

With M = m1 + m2, L = b M/(a2 m2), Omega = sqrt(a2/M), q = m1/M, r = m2/M, 2 zeta = a1/(M Omega):
X = x1/L, V_i = v_i/(L Omega), Z = (x1 - x2)/L, tau = Omega t, w = E/E_cr - 1 (all dimensionless). Then

    stick            X'' + 2 zeta X' + X = 0
    slip, sign s     q V1' = -(X + 2 zeta V1 + r s),   V2' = s
    energy           E/E_cr = X^2 + q V1^2 + r V2^2,   w' = -2 r |V1 - V2| - 4 zeta V1^2

What a run needs of the exact rationals of a scene is formed among them and converted once.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.functions import sqrt
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.slip import Start
from numerics.scene import Law, Pair, Scene

STICK, RAY, SURFACE, FREE = 0, 1, 2, 3
"""Kinds of motion: stick; slips from an exit ray, from elsewhere on the switching surface, from off it."""


class ReducedState(NamedTuple):
    """A point of the reduced state space; w is a variable of its own, accurate where E/E_cr - 1 would cancel."""

    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number


class Frame:
    """The constants of one pair in one arithmetic: dimensionless q, r, sqrt_q; SI units of what is reduced.

    These are length, rate, speed and critical_energy.
    In float64 rationals are rounded once (0.5 ulp), so roots of them are within 1 ulp and the speed within 3 ulp.
    """

    def __init__(self, arithmetic: Arithmetic, pair: Pair) -> None:
        """Convert the exact parameters once, in the arithmetic's context; raises OutOfRange if one does not fit."""
        number = arithmetic.number
        self.arithmetic, self.q, self.r = arithmetic, number(pair.share), number(1 - pair.share)
        self.length, self.critical_energy = number(pair.half_width), number(pair.critical_energy)
        self.rate, self.sqrt_q = sqrt(number(pair.a2 / pair.mass)), sqrt(self.q)
        self.speed = self.length * self.rate

    def reduced(self, y: Any, excess: Number | None = None) -> ReducedState:
        """Return (x1, v1, x2, v2) in reduced coordinates; without an excess, w is formed from the state."""
        x1, v1, x2, v2 = y
        X, V1, V2 = x1 / self.length, v1 / self.speed, v2 / self.speed
        w = X * X + self.q * V1 * V1 + self.r * V2 * V2 - 1 if excess is None else excess
        return ReducedState(X, V1, V2, (x1 - x2) / self.length, w)

    def in_si(self, state: ReducedState) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) in m and m/s of a reduced state."""
        X, V1, V2, Z, _ = state
        return self.length * X, self.speed * V1, self.length * (X - Z), self.speed * V2


def begin(scene: Scene, frame: Frame) -> Start:
    """Return the first motion of a scene with a1 = 0, no force and constant b, in the arithmetic's context.

    Every sign is decided on exact rationals; which mode begins is the rule of linear/modes.py. Raises OutOfRange.
    """
    pair, at = scene.pair, scene.initial
    number, rate, length, q = frame.arithmetic.number, frame.rate, pair.half_width, pair.share
    x, v1, v2, apart = (one / length for one in (at.x1, at.v1, at.v2, at.v1 - at.v2))  # V_i Omega
    mode, near = _sign(apart), 1 if x >= 0 else -1
    on_surface, outside = mode == 0, _sign(near * x - 1)
    # on the edge the pair leaves by the side to which it moves
    if on_surface and scene.law is Law.FILIPPOV and (outside > 0 or (outside == 0 and near * _sign(v1) > 0)):
        mode = -near
    side = -mode or near
    beyond = side * x - 1
    X, V1, Z = number(x), number(v1) / rate, number((at.x1 - at.x2) / length)
    w, zero = number(scene.energy_excess), X * 0
    if mode == 0:
        return Start(STICK, side, X, zero, number(beyond), V1, zero, True, Z, w, zero)
    gap, push = beyond / q, side * V1 / frame.sqrt_q
    turning = gap * (2 + gap) + v1 * v1 * pair.mass / (pair.a2 * q)
    guard = number(-side * apart) / rate / frame.sqrt_q
    driven = push if on_surface else side * (number(v2) / rate) / frame.sqrt_q
    kind = SURFACE if on_surface else FREE
    return Start(kind, side, X, guard, number(gap), push, driven, turning > 0, Z, w, zero)


def _sign(x: Any) -> int:
    return (x > 0) - (x < 0)
