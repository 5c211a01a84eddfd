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
from numerics.free.start import constants, narrowing, wide
from numerics.scene import Pair


class ReducedState(NamedTuple):
    """A point of the reduced state space; w is a variable of its own, accurate where E/E_cr - 1 would cancel."""

    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number


class Frame:
    """The constants of one pair in one arithmetic: dimensionless q, r, sqrt_q, two_zeta; SI units of what is reduced.

    These are length, rate, speed and critical_energy. two_zeta = 2 zeta is 0 for a free pair.
    In float64 rationals are rounded once (0.5 ulp), so roots of them are within 1 ulp and the speed within 3 ulp.
    """

    def __init__(self, arithmetic: Arithmetic, pair: Pair) -> None:
        """Convert the exact parameters once, in the arithmetic's context; raises OutOfRange if one does not fit."""
        self.arithmetic, self.pair, narrow = arithmetic, pair, narrowing(arithmetic)
        m1, m2, a2, b = map(wide, (pair.m1, pair.m2, pair.a2, pair.b))
        self.parameters, self.units = constants(m1, m2, a2, b, False, narrow)
        self.q, self.r, self.sqrt_q, *_ = self.parameters
        self.length, self.rate, self.critical_energy = self.units
        self.speed = self.length * self.rate
        self.two_zeta = arithmetic.number(pair.a1 / pair.mass) / self.rate

    def reduced(self, y: Any, excess: Number | None = None) -> ReducedState:
        """Return (x1, v1, x2, v2) in reduced coordinates; without an excess, w is formed from the state."""
        x1, v1, x2, v2 = y
        X, V1, V2 = x1 / self.length, v1 / self.speed, v2 / self.speed
        w = self.energy_ratio(X, V1, V2) - 1 if excess is None else excess
        return ReducedState(X, V1, V2, (x1 - x2) / self.length, w)

    def energy(self, state: Any) -> Number:
        """Return E in J, formed from the state."""
        return self.critical_energy * self.energy_ratio(state.X, state.V1, state.V2)

    def energy_ratio(self, X: Number, V1: Number, V2: Number) -> Number:
        """Return E/E_cr = X^2 + q V1^2 + r V2^2, formed from the state: in float64 within 3.5 ulp.

        Each term is > 0 and has 2 u or less, u = 2^-53, the first sum adds 1 u and the second 0.5 ulp.
        """
        return X * X + self.q * V1 * V1 + self.r * V2 * V2
