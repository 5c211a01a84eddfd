"""Between SI units and the reduced coordinates, in which the undamped family has one parameter.

With M = m1 + m2, L = b M/(a2 m2), Omega = sqrt(a2/M), q = m1/M, r = m2/M, 2 zeta = a1/(M Omega):
X = x1/L, V_i = v_i/(L Omega), Z = (x1 - x2)/L, tau = Omega t, w = E/E_cr - 1 (all dimensionless). Then

    stick            X'' + 2 zeta X' + X = 0
    slip, sign s     q V1' = -(X + 2 zeta V1 + r s),   V2' = s
    energy           E/E_cr = X^2 + q V1^2 + r V2^2,   w' = -2 r |V1 - V2| - 4 zeta V1^2
"""

from __future__ import annotations

from typing import NamedTuple

from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.scene import Pair, Scene


class ReducedState(NamedTuple):
    """A point of the reduced state space; w is a variable of its own, accurate where E/E_cr - 1 would cancel."""

    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number


class Frame:
    """The constants of one pair in one arithmetic: dimensionless q, r, sqrt_q, two_zeta; SI length, rate, speed.

    In float64 rationals are rounded once (0.5 ulp), so roots of them are within 1 ulp and the speed within 3 ulp.
    """

    def __init__(self, arithmetic: Arithmetic, pair: Pair) -> None:
        """Convert the exact parameters once; raises OutOfRange if the arithmetic cannot hold one of them."""
        number, sqrt = arithmetic.number, arithmetic.sqrt
        self.arithmetic, self.pair = arithmetic, pair
        mass, width = pair.mass, pair.half_width
        share = pair.m1 / mass
        self.q, self.r = number(share), number(pair.m2 / mass)
        self.sqrt_q = sqrt(self.q)
        self.rate = sqrt(number(pair.a2 / mass))
        # at a1 = 0 the square has no derivative, by which the sensitivities see the damper
        self.two_zeta = sqrt(number(pair.a1**2 / (pair.a2 * mass))) if pair.a1 else number(pair.a1 / mass) / self.rate
        # the sign of 1 - zeta^2 (stick) and of q - zeta^2 (slip) is decided exactly: which damping regime it is
        zeta_squared = pair.a1**2 / (4 * pair.a2 * mass)
        self.stick_discriminant = 1 - zeta_squared
        self.slip_discriminant = share - zeta_squared
        self.length = number(width)
        self.speed = self.length * self.rate
        self.critical_energy = number(pair.a2 * width * width / 2)

    def initial(self, scene: Scene) -> ReducedState:
        """Return the initial state of a scene; X, Z and w are conversions of exact rationals."""
        number, width, at = self.arithmetic.number, self.pair.half_width, scene.initial
        return ReducedState(
            X=number(at.x1 / width),
            V1=number(at.v1 / width) / self.rate,
            V2=number(at.v2 / width) / self.rate,
            Z=number((at.x1 - at.x2) / width),
            w=number(scene.energy_excess),
        )

    def si_state(self, state: ReducedState) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) in m and m/s."""
        return (
            self.length * state.X,
            self.speed * state.V1,
            self.length * (state.X - state.Z),
            self.speed * state.V2,
        )

    def si_time(self, tau: Number) -> Number:
        """Return t = tau/Omega in s."""
        return tau / self.rate

    def energy(self, state: ReducedState) -> Number:
        """Return E in J, formed from the state."""
        return self.critical_energy * self.energy_ratio(state.X, state.V1, state.V2)

    def energy_ratio(self, X: Number, V1: Number, V2: Number) -> Number:
        """Return E/E_cr = X^2 + q V1^2 + r V2^2, formed from the state: in float64 within 3.5 ulp.

        Each term is > 0 and has 2 u or less, u = 2^-53, the first sum adds 1 u and the second 0.5 ulp.
        """
        return X * X + self.q * V1 * V1 + self.r * V2 * V2
