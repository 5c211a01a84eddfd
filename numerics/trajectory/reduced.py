"""Reduced coordinates, in which the free pair has one parameter, and a pair's constants in an arithmetic.

With M = m1 + m2, L = b M/(a2 m2), Omega = sqrt(a2/M), q = m1/M, r = m2/M, 2 zeta = a1/(M Omega):
X = x1/L, V_i = v_i/(L Omega), Z = (x1 - x2)/L, tau = Omega t, w = E/E_cr - 1 (all dimensionless). Then

    stick            X'' + 2 zeta X' + X = 0
    slip, sign s     q V1' = -(X + 2 zeta V1 + r s),   V2' = s
    energy           E/E_cr = X^2 + q V1^2 + r V2^2,   w' = -2 r |V1 - V2| - 4 zeta V1^2
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.frame import Frame as FreeFrame
from numerics.scene import Pair


class ReducedState(NamedTuple):
    """A point of the reduced state space; w is a variable of its own, accurate where E/E_cr - 1 would cancel."""

    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number


class Frame(FreeFrame):
    """The constants of any pair in one arithmetic; `two_zeta` = 2 zeta, dimensionless, is 0 for a free one."""

    def __init__(self, arithmetic: Arithmetic, pair: Pair) -> None:
        """Convert the exact parameters once, in the arithmetic's context; raises OutOfRange if one does not fit."""
        super().__init__(arithmetic, pair)
        self.two_zeta = arithmetic.number(pair.a1 / pair.mass) / self.rate

    def reduced(self, y: Any, excess: Number | None = None) -> ReducedState:
        """Return (x1, v1, x2, v2) in reduced coordinates; without an excess, w is formed from the state."""
        x1, v1, x2, v2 = y
        X, V1, V2 = x1 / self.length, v1 / self.speed, v2 / self.speed
        w = self.energy_ratio(X, V1, V2) - 1 if excess is None else excess
        return ReducedState(X, V1, V2, (x1 - x2) / self.length, w)
