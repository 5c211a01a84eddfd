"""Between SI units and the reduced coordinates (start.py), in which the undamped family has one parameter."""

from __future__ import annotations

from typing import Any

from flint import fmpq

from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.motion import State
from numerics.free.start import SI, in_si, narrowing, parameters_of, units_of, wide
from numerics.scene import Pair


class Frame:
    """The constants of one pair in one arithmetic: dimensionless q, r, sqrt_q; SI length, rate, speed, critical_energy.

    In float64 rationals are rounded once (0.5 ulp), so roots of them are within 1 ulp and the speed within 3 ulp.
    """

    def __init__(self, arithmetic: Arithmetic, pair: Pair) -> None:
        """Convert the exact parameters once, in the arithmetic's context; raises OutOfRange if one does not fit."""
        self.arithmetic, self.pair, narrow = arithmetic, pair, narrowing(arithmetic)
        si = SI(*map(wide, (pair.m1, pair.m2, pair.a2, pair.b)), *[fmpq(0)] * 6)
        self.q, self.r, self.sqrt_q, _ = parameters_of(si, False, narrow)
        self.units = units_of(si, narrow)
        self.length, self.rate, self.critical_energy = self.units
        self.speed = self.length * self.rate

    def si_state(self, state: State) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) in m and m/s of a reduced state."""
        return in_si(self.units, state)

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
