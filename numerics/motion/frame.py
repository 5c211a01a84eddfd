"""Between SI units and the reduced coordinates, in which the undamped family has one parameter.

With M = m1 + m2, L = b M/(a2 m2), Omega = sqrt(a2/M), q = m1/M, r = m2/M, 2 zeta = a1/(M Omega):
X = x1/L, V_i = v_i/(L Omega), Z = (x1 - x2)/L, tau = Omega t, w = E/E_cr - 1 (all dimensionless). Then

    stick            X'' + 2 zeta X' + X = 0
    slip, sign s     q V1' = -(X + 2 zeta V1 + r s),   V2' = s
    energy           E/E_cr = X^2 + q V1^2 + r V2^2,   w' = -2 r |V1 - V2| - 4 zeta V1^2
"""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.motion.start import SI, damping_ratio, reduced
from numerics.motion.tellings import start_telling
from numerics.scene import Pair


class Frame:
    """The constants of one pair in one arithmetic: dimensionless q, r, sqrt_q, two_zeta; SI length, rate, speed.

    In float64 rationals are rounded once (0.5 ulp), so roots of them are within 1 ulp and the speed within 3 ulp.
    """

    def __init__(self, arithmetic: Arithmetic, pair: Pair) -> None:
        """Convert the exact parameters once, in the arithmetic's context; raises OutOfRange if one does not fit."""
        self.arithmetic, self.pair = arithmetic, pair
        told, si = start_telling(arithmetic), SI(pair.m1, pair.m2, pair.a2, pair.b, 0, 0, 0, 0, 1, pair.a1)
        at = told(reduced)(si)
        self.q, self.r, self.units = at.q, at.r, at.units
        self.length, self.rate, self.critical_energy = at.units
        self.sqrt_q, self.two_zeta = arithmetic.sqrt(at.q), told(damping_ratio)(si)
        self.speed = self.length * self.rate

    def si_state(self, state: Any) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) in m and m/s of a reduced state."""
        return (
            self.length * state.X,
            self.speed * state.V1,
            self.length * (state.X - state.Z),
            self.speed * state.V2,
        )

    def si_time(self, tau: Number) -> Number:
        """Return t = tau/Omega in s."""
        return tau / self.rate

    def energy(self, state: Any) -> Number:
        """Return E in J, formed from the state."""
        return self.critical_energy * self.energy_ratio(state.X, state.V1, state.V2)

    def energy_ratio(self, X: Number, V1: Number, V2: Number) -> Number:
        """Return E/E_cr = X^2 + q V1^2 + r V2^2, formed from the state: in float64 within 3.5 ulp.

        Each term is > 0 and has 2 u or less, u = 2^-53, the first sum adds 1 u and the second 0.5 ulp.
        """
        return X * X + self.q * V1 * V1 + self.r * V2 * V2
